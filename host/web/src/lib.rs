//! rta as a WebAssembly module for a page: it reads a scene, traces it row by row and shows it on an emulated display.
//!
//! Everything goes through two buffers in the module's memory. The page asks for room with [`alloc`], writes a request there and
//! calls [`check`] or [`start`]; each answer lies at [`output`], [`output_len`] bytes long. A request is a line of settings and the
//! scene's text: `vga 1 q16 auto 5 sampled none`, the display, by how much its raster is divided, number format, illumination model, depth,
//! colour table and dithering, of which model, depth and dithering may be `auto`; [`choices`] lists them.
//!
//! Functions that can fail return 0, or 1 for an error; then the answer is the error as JSON: `line` and `column` in the scene, or null, and
//! `message`. Nothing panics, whatever the page asks in whatever order.

mod coloring;
mod explain;
mod failure;
mod json;
mod picture;
mod request;
mod screen;
mod session;

use core::cell::RefCell;

use failure::Failure;
use session::Session;

std::thread_local! {
    /// All that the module keeps from call to call. It has one thread.
    static MODULE: RefCell<Module> = const { RefCell::new(Module::new()) };
}

/// The two buffers and the picture.
struct Module {
    input: Vec<u8>,
    output: Vec<u8>,
    session: Option<Session>,
}

impl Module {
    const fn new() -> Self {
        Self { input: Vec::new(), output: Vec::new(), session: None }
    }

    /// Keeps an answer for the page. Returns 0, or 1 for an error.
    fn answer(&mut self, answer: Result<Vec<u8>, Failure>) -> u32 {
        let status = u32::from(answer.is_err());
        self.output = answer.unwrap_or_else(|failure| failure.json().into_bytes());
        status
    }

    /// Calls `ask` with the picture that was started last.
    fn ask(&mut self, ask: impl FnOnce(&mut Session) -> Result<Vec<u8>, Failure>) -> u32 {
        let answer = match &mut self.session {
            Some(session) => ask(session),
            None => Err(Failure::plain("no picture was started")),
        };
        self.answer(answer)
    }
}

/// Calls `act` with the module.
fn with<R>(act: impl FnOnce(&mut Module) -> R) -> R {
    MODULE.with_borrow_mut(act)
}

/// Makes room for a request of `len` bytes and returns its address. It holds for the next call of [`check`] or [`start`].
#[unsafe(no_mangle)]
#[allow(unsafe_code, reason = "the name is exported; no other function of the module has it")]
pub extern "C" fn alloc(len: usize) -> *mut u8 {
    with(|module| {
        module.input.clear();
        module.input.resize(len, 0);
        module.input.as_mut_ptr()
    })
}

/// Reads the scene of the request and proves that it fits the number format, without drawing it. The answer is what there is to
/// say about it, as JSON: `width` and `height` of the picture, `model`, `depth`, and `warnings`, each with `line` and `message`.
#[unsafe(no_mangle)]
#[allow(unsafe_code, reason = "as above")]
pub extern "C" fn check() -> u32 {
    with(|module| {
        let answer = session::check(&module.input);
        module.answer(answer.map(String::into_bytes))
    })
}

/// Starts the picture of the request: reads the scene, makes the colour table and switches the display on. The picture that was
/// there before is kept if that fails. The answer is that of [`check`].
#[unsafe(no_mangle)]
#[allow(unsafe_code, reason = "as above")]
pub extern "C" fn start() -> u32 {
    with(|module| {
        let answer = Session::start(&module.input).map(|(session, summary)| {
            module.session = Some(session);
            summary.into_bytes()
        });
        module.answer(answer)
    })
}

/// Traces row `y` and draws it. The rows are to be drawn in order, from 0. The answer is the row as the display shows it: red,
/// green, blue and 255, 8 bits each, for each pixel.
#[unsafe(no_mangle)]
#[allow(unsafe_code, reason = "as above")]
pub extern "C" fn row(y: u32) -> u32 {
    with(|module| module.ask(|session| session.row(y)))
}

/// Returns the entries of the display's colour table, as far as it is loaded: red, green and blue, 8 bits each.
#[unsafe(no_mangle)]
#[allow(unsafe_code, reason = "as above")]
pub extern "C" fn colors() -> u32 {
    with(|module| module.ask(Session::colors))
}

/// Explains the pixel in column `x` of row `y`, as JSON: its linear `light`, the mean of `samples`; `color`, as the display shows it, and its
/// `index` in the colour table, both null before it is drawn; how many `rays` of each kind there are; and the `tree`, a list of rays with
/// `kind`, `depth`, what they meet as `text`, the object's `line` in the scene, and the `light` that each brings into the pixel by itself.
/// `untold` is how many more rays the tree has.
#[unsafe(no_mangle)]
#[allow(unsafe_code, reason = "as above")]
pub extern "C" fn explain(x: u32, y: u32) -> u32 {
    with(|module| module.ask(|session| session.explain(x, y).map(String::into_bytes)))
}

/// Returns what a page offers: number formats, models, tables, ways of dithering, displays and shipped scenes, as JSON.
#[unsafe(no_mangle)]
#[allow(unsafe_code, reason = "as above")]
pub extern "C" fn choices() -> u32 {
    with(|module| module.answer(Ok(request::choices().into_bytes())))
}

/// Returns the address of the answer of the last call.
#[unsafe(no_mangle)]
#[allow(unsafe_code, reason = "as above")]
pub extern "C" fn output() -> *const u8 {
    with(|module| module.output.as_ptr())
}

/// Returns the length of the answer of the last call in bytes.
#[unsafe(no_mangle)]
#[allow(unsafe_code, reason = "as above")]
pub extern "C" fn output_len() -> usize {
    with(|module| module.output.len())
}

#[cfg(test)]
mod tests {
    use rta_scenes::shipped;

    use super::{alloc, check, choices, colors, explain, output_len, row, start, with};

    fn ask(text: &str, call: extern "C" fn() -> u32) -> u32 {
        alloc(text.len());
        with(|module| module.input.copy_from_slice(text.as_bytes()));
        call()
    }

    fn answer() -> String {
        with(|module| String::from_utf8_lossy(&module.output).into_owned())
    }

    #[test]
    fn whatever_is_called_in_whatever_order_is_answered() {
        for status in [row(0), colors(), explain(0, 0), start(), check()] {
            assert_eq!(status, 1);
        }
        assert_eq!(
            answer(),
            r#"{"line":null,"column":null,"message":"a request begins with a line of settings"}"#
        );
        assert_eq!(choices(), 0);
        assert!(answer().contains(r#"{"name":"q16","about":"Fixed point"#));
        let request = |scene| format!("vga 8 q16 auto auto uniform none\n{scene}");
        assert_eq!(ask(&request(shipped::JUGGLER), start), 0);
        assert_eq!((row(0), output_len()), (0, 160));
        // What fails does not touch the picture.
        assert_eq!(ask(&request("1 2 x"), start), 1);
        assert_eq!((row(24), row(25), row(u32::MAX)), (0, 1, 1));
        assert_eq!((explain(39, 24), explain(40, 24), explain(u32::MAX, u32::MAX)), (0, 1, 1));
        assert_eq!((ask("\u{fffd}", check), colors()), (1, 0));
        assert_eq!(output_len(), 3 * 252); // 6 x 7 x 6 levels
    }
}
