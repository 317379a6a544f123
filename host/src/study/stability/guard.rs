//! Panics, caught one ray at a time, and told apart from overflow.

use core::cell::RefCell;
use core::panic::AssertUnwindSafe;
use std::panic::{self, PanicHookInfo};
use std::sync::Once;

/// Whether this build checks every operation and can go on after a panic; where it does not, a count of 0 says nothing.
pub const CHECKED: bool = cfg!(debug_assertions) && cfg!(panic = "unwind");

/// Why a computation ended in a panic.
#[derive(Clone, Debug)]
pub struct Failure {
    /// Whether a number left its format, as opposed to anything else that panics.
    pub is_overflow: bool,
    /// The message of the panic, and its place.
    pub message: String,
}

thread_local! {
    /// While a thread is under guard: what its panic said.
    static CAUGHT: RefCell<Option<String>> = const { RefCell::new(None) };
    static GUARDED: RefCell<bool> = const { RefCell::new(false) };
}

/// Keeps guarded panics to itself, and passes all others on to the hook that was there before.
fn hook() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let before = panic::take_hook();
        panic::set_hook(Box::new(move |info: &PanicHookInfo| {
            if GUARDED.with_borrow(|guarded| *guarded) {
                let place =
                    info.location().map_or(String::new(), |l| format!(" ({}:{})", l.file(), l.line()));
                let text = info.payload_as_str().unwrap_or("a panic");
                CAUGHT.with_borrow_mut(|caught| *caught = Some(format!("{text}{place}")));
            } else {
                before(info);
            }
        }));
    });
}

/// Does what `work` does.
///
/// # Errors
/// [`Failure`] if it panics, in a build that unwinds; in one that aborts the whole program ends.
pub fn guarded<T>(work: impl FnOnce() -> T) -> Result<T, Failure> {
    hook();
    GUARDED.with_borrow_mut(|guarded| *guarded = true);
    // What a panic leaves half done is thrown away with the ray.
    let outcome = panic::catch_unwind(AssertUnwindSafe(work));
    GUARDED.with_borrow_mut(|guarded| *guarded = false);
    outcome.map_err(|_| {
        let message = CAUGHT.with_borrow_mut(Option::take).unwrap_or_default();
        // The words of the compiler's own checks, of the crate `fixed`, and of the core's.
        let is_overflow = message.contains("overflow") || message.contains("exceeds its fixed-point format");
        Failure { is_overflow, message }
    })
}

#[cfg(test)]
mod tests {
    use core::hint::black_box;

    use super::guarded;

    #[test]
    fn panics_and_overflows_are_told_apart() {
        let sum = guarded(|| black_box(i32::MAX) + black_box(1)).expect_err("it overflows");
        assert!(sum.is_overflow && sum.message.contains("guard.rs:"), "{sum:?}");
        let length = guarded(|| black_box(rta_core::Q16::MAX) + black_box(rta_core::Q16::MAX));
        assert!(length.expect_err("it overflows").is_overflow);
        let other = guarded(|| panic!("no {}", black_box("more"))).expect_err("it panics");
        assert!(!other.is_overflow && other.message.starts_with("no more"), "{other:?}");
        assert_eq!(guarded(|| 2 + 2).expect("it ends"), 4);
    }
}
