//! Ctrl-C and requests to terminate, taken between two bands so that no half-written file stays behind.

use core::sync::atomic::{AtomicBool, Ordering};

/// Exit status of a process that an interrupt has ended, by the convention of shells: 128 and the number of the signal.
pub const STATUS: u8 = 130;

static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Handles Ctrl-C from here on: the first one sets the flag that is returned, the second ends the process at once.
///
/// It is called when there is work to be ended in order. Until then, and where the system does not allow a handler, Ctrl-C
/// ends the process at once.
pub fn watch() -> &'static AtomicBool {
    let _ = ctrlc::try_set_handler(|| {
        if INTERRUPTED.swap(true, Ordering::Relaxed) {
            std::process::exit(STATUS.into());
        }
    });
    &INTERRUPTED
}
