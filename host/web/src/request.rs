//! A request of the page: a line of settings, and the text of a scene.

use rta_scenes::{Format, Model, shipped};

use crate::coloring::{DitherKind, TableKind};
use crate::failure::Failure;
use crate::json;
use crate::screen::Device;

/// The largest scene that is read, in bytes: what is made of a text takes some times its size, of the memory of 4 GiB at most.
const LARGEST: usize = 64 << 20;

/// Recursion depth where neither the page nor the scene says it.
pub(crate) const DEPTH: u32 = 5;

/// The deepest recursion: the capacity of the tracer's stack of pending rays.
pub(crate) const MAX_DEPTH: u32 = 32;

/// The most frames of a film: as many as a browser has the memory for, at two megabytes each for all three displays.
pub(crate) const MAX_FRAMES: u32 = 240;

/// The most frames that are shown in a second, as in `rta render`.
const MAX_RATE: u32 = 50;

/// The word for what the scene or the display decides.
const OWN: &str = "auto";

/// What of a scene in which things move along paths is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Time {
    /// A picture of an instant, 0 to 1.
    Instant(f64),
    /// A film of so many frames.
    Film(u32),
}

/// How a scene is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Request {
    /// The display.
    pub(crate) device: Device,
    /// By how much the sides of the picture are divided: 1 for the whole screen.
    pub(crate) divisor: u32,
    /// The number format.
    pub(crate) format: Format,
    /// The illumination model, or the one that the scene was made for.
    pub(crate) model: Option<Model>,
    /// Recursion depth, or the scene's.
    pub(crate) depth: Option<u32>,
    /// The colour table.
    pub(crate) table: TableKind,
    /// The dithering, or the one that suits table and display.
    pub(crate) dither: Option<DitherKind>,
    /// A picture or a film.
    pub(crate) time: Time,
}

impl Request {
    /// Reads a request: `vga 1 q16 auto 5 sampled none instant 0.5`, the display, by how much its raster is divided, number format, model,
    /// depth, colour table, dithering, and the instant or, as `frames 24`, the frames of a film; model, depth and dithering may be `auto`.
    /// Returns it, and the scene's text, which stands from the next line on.
    ///
    /// # Errors
    /// [`Failure`] with the first word that is wrong, or for a scene that is too large.
    pub(crate) fn parse(request: &[u8]) -> Result<(Self, &[u8]), Failure> {
        let line = || {
            let end = request.iter().position(|&byte| byte == b'\n')?;
            let (line, rest) = request.split_at_checked(end)?;
            Some((core::str::from_utf8(line).ok()?, rest.get(1..)?))
        };
        let (settings, text) =
            line().ok_or_else(|| Failure::plain("a request begins with a line of settings"))?;
        if text.len() > LARGEST {
            return Err(Failure::plain(format!("the scene is larger than {} MiB", LARGEST >> 20)));
        }
        let mut words = settings.split(' ');
        let mut word = || words.next().unwrap_or_default();
        let request = Self {
            device: one_of("display", word(), &Device::ALL)?,
            divisor: whole("divisor of the raster", word(), 1, 8)?,
            format: one_of("number format", word(), &named(Format::ALL, Format::name))?,
            model: unless_own(word(), |word| {
                one_of("illumination model", word, &named(Model::ALL, Model::name))
            })?,
            depth: unless_own(word(), |word| whole("depth", word, 0, MAX_DEPTH))?,
            table: one_of("colour table", word(), &TableKind::ALL)?,
            dither: unless_own(word(), |word| one_of("dithering", word, &DitherKind::ALL))?,
            time: match word() {
                "instant" => Time::Instant(instant(word())?),
                "frames" => Time::Film(whole("number of frames", word(), 1, MAX_FRAMES)?),
                other => return Err(Failure::plain(format!("{other:?} is neither instant nor frames"))),
            },
        };
        match words.next() {
            None => Ok((request, text)),
            Some(word) => Err(Failure::plain(format!("one setting too many: {word:?}"))),
        }
    }

    /// Returns width and height of the picture in pixels.
    pub(crate) fn size(&self) -> (u32, u32) {
        let whole = self.device.capabilities();
        let part = |side: u32| side.checked_div(self.divisor).unwrap_or(side).max(1);
        (part(whole.width), part(whole.height))
    }

    /// Returns the shape of the part of the screen that the picture fills, width over height.
    pub(crate) fn aspect(&self) -> f64 {
        let ratio = |(width, height): (u32, u32)| f64::from(width) / f64::from(height);
        let whole = self.device.capabilities();
        ratio(self.size()) / ratio((whole.width, whole.height)) * ratio(whole.aspect)
    }
}

/// Returns the values of a list with their names.
fn named<T: Copy>(values: &[T], name: impl Fn(T) -> &'static str) -> Vec<(&'static str, T)> {
    values.iter().map(|&value| (name(value), value)).collect()
}

/// Returns the value that has a name.
fn one_of<T: Copy>(what: &str, word: &str, values: &[(&str, T)]) -> Result<T, Failure> {
    let found = values.iter().find(|(name, _)| *name == word);
    found.map(|(_, value)| *value).ok_or_else(|| Failure::plain(format!("there is no {what} {word:?}")))
}

/// Reads a whole number within limits.
fn whole(what: &str, word: &str, least: u32, most: u32) -> Result<u32, Failure> {
    let number = word.parse().ok().filter(|number| (least..=most).contains(number));
    number
        .ok_or_else(|| Failure::plain(format!("the {what} is {word:?}, not a number from {least} to {most}")))
}

/// Reads an instant of a film.
fn instant(word: &str) -> Result<f64, Failure> {
    let instant = word.parse().ok().filter(|instant| (0.0..=1.0).contains(instant));
    instant.ok_or_else(|| Failure::plain(format!("the instant is {word:?}, not a number from 0 to 1")))
}

/// Reads a word unless it says that something else decides.
fn unless_own<T>(word: &str, read: impl FnOnce(&str) -> Result<T, Failure>) -> Result<Option<T>, Failure> {
    if word == OWN { Ok(None) } else { read(word).map(Some) }
}

/// Returns what a page offers, as JSON.
pub(crate) fn choices() -> String {
    let choice =
        |name: &str, about: &str| json::object([("name", json::text(name)), ("about", json::text(about))]);
    let names = |names: &mut dyn Iterator<Item = &'static str>| json::list(names.map(json::text));
    let display = |(name, device): (&str, Device)| {
        let of = device.capabilities();
        let (width, height) = of.aspect;
        json::object([
            ("name", json::text(name)),
            ("width", of.width.to_string()),
            ("height", of.height.to_string()),
            ("colors", of.colors.to_string()),
            ("guns", (u32::from(of.gun_max) + 1).to_string()),
            ("aspect", json::number(f64::from(width) / f64::from(height))),
        ])
    };
    let scene =
        |(name, text): (&str, &str)| json::object([("name", json::text(name)), ("text", json::text(text))]);
    let others = [
        ("juggler.rta", shipped::JUGGLING),
        ("balls2.nff", shipped::BALLS_2),
        ("prism.rta", shipped::PRISM),
        ("mesh.rta", shipped::MESH),
    ];
    json::object([
        ("displays", json::list(Device::ALL.map(display))),
        ("formats", json::list(Format::ALL.iter().map(|format| choice(format.name(), format.about())))),
        ("models", json::list(Model::ALL.iter().map(|model| choice(model.name(), model.about())))),
        ("tables", names(&mut TableKind::ALL.iter().map(|(name, _)| *name))),
        ("dithers", names(&mut DitherKind::ALL.iter().map(|(name, _)| *name))),
        ("depth", MAX_DEPTH.to_string()),
        ("frames", MAX_FRAMES.to_string()),
        ("rate", MAX_RATE.to_string()),
        ("scenes", json::list(shipped::ALL.into_iter().chain(others).map(scene))),
    ])
}

#[cfg(test)]
mod tests {
    use rta_scenes::{Format, Model};

    use super::{Request, Time};
    use crate::coloring::{DitherKind, TableKind};
    use crate::screen::Device;

    #[test]
    fn requests_are_read() {
        let (request, text) =
            Request::parse(b"pixrect 2 q20 whitted 7 baked auto frames 24\nrta 1\n").expect("one");
        assert_eq!((request.device, request.format), (Device::Pixrect, Format::Q20));
        assert_eq!((request.model, request.depth), (Some(Model::Whitted), Some(7)));
        assert_eq!((request.table, request.dither), (TableKind::Baked, None));
        assert_eq!(request.time, Time::Film(24));
        assert_eq!(text, b"rta 1\n");
        assert_eq!(request.size(), (576, 450));
        assert!((request.aspect() - 1.28).abs() < 1e-12);
        let (request, text) =
            Request::parse(b"vga 1 f32 auto auto uniform bayer instant 0.25\n").expect("one");
        assert_eq!((request.model, request.depth, text), (None, None, &b""[..]));
        assert_eq!((request.dither, request.size()), (Some(DitherKind::Bayer), (320, 200)));
        assert_eq!(request.time, Time::Instant(0.25));
    }

    #[test]
    fn what_is_wrong_is_named() {
        for (request, message) in [
            (&b""[..], "a request begins with a line of settings"),
            (b"\xff\n", "a request begins with a line of settings"),
            (b"cga 1 q16 auto 5 sampled none\n", "there is no display \"cga\""),
            (
                b"vga 0 q16 auto 5 sampled none\n",
                "the divisor of the raster is \"0\", not a number from 1 to 8",
            ),
            (b"vga 1 q16 auto 33 sampled none\n", "the depth is \"33\", not a number from 0 to 32"),
            (b"vga 1 q16 auto 5 octree none\n", "there is no colour table \"octree\""),
            (b"vga 1 q16 auto 5 sampled\n", "there is no dithering \"\""),
            (b"vga 1 q16 auto 5 sampled none\n", "\"\" is neither instant nor frames"),
            (
                b"vga 1 q16 auto 5 sampled none instant NaN\n",
                "the instant is \"NaN\", not a number from 0 to 1",
            ),
            (
                b"vga 1 q16 auto 5 sampled none frames 0\n",
                "the number of frames is \"0\", not a number from 1 to 240",
            ),
            (b"vga 1 q16 auto 5 sampled none instant 0 x\n", "one setting too many: \"x\""),
        ] {
            assert_eq!(Request::parse(request).expect_err(message).message, message);
        }
    }
}
