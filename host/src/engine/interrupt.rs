//! Ctrl-C and requests to terminate, taken between two bands so that no half-written file stays behind.

use core::sync::atomic::{AtomicBool, Ordering};

/// Status of a process that an interrupt has ended, as shells have it: 128 and the number of the signal.
pub const STATUS: u8 = 130;

static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Takes over Ctrl-C from here on. What is returned becomes true at the first one; the second ends the process on
/// the spot.
///
/// Called when there is something to finish: until then, and where the system does not let it, Ctrl-C ends the
/// process as ever.
pub fn watch() -> &'static AtomicBool {
    let _ = ctrlc::try_set_handler(|| {
        if INTERRUPTED.swap(true, Ordering::Relaxed) {
            std::process::exit(STATUS.into());
        }
    });
    &INTERRUPTED
}
