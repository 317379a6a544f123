//! Ctrl-C and requests to terminate, taken between two bands so that no half-written file stays behind.

use core::sync::atomic::{AtomicBool, Ordering};
use std::sync::Once;

use crate::picture::output;

/// Exit status of a process that an interrupt has ended, by the convention of shells: 128 and the number of the signal.
pub const STATUS: u8 = 130;

static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Handles Ctrl-C, requests to terminate and the end of the terminal from here on: the first one sets the flag that is returned,
/// the second ends the process at once. Those that were ignored when the program started, as `nohup` and scripts have it, stay
/// ignored.
///
/// It is called when there is work to be ended in order. Until then, and where the system does not allow a handler, each of them
/// ends the process at once.
pub fn watch() -> &'static AtomicBool {
    static ONCE: Once = Once::new();
    // Without a handler the program is ended as any other is.
    ONCE.call_once(|| drop(system::catch()));
    &INTERRUPTED
}

/// Makes a file that grows beyond the limit of the user (`ulimit -f`) an error of writing and not the end of the process, where the
/// system is known to have such a limit.
pub fn forgo_file_limit() {
    #[cfg(target_os = "linux")]
    system::forgo_file_limit();
}

/// What each of the signals does.
fn requested() {
    if INTERRUPTED.swap(true, Ordering::Relaxed) {
        output::discard();
        std::process::exit(STATUS.into());
    }
}

#[cfg(target_os = "linux")]
mod system {
    use core::ffi::c_int;
    use core::sync::atomic::AtomicBool;
    use std::fs;
    use std::io;
    use std::sync::Arc;

    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM, SIGXFSZ};
    use signal_hook::flag;
    use signal_hook::iterator::Signals;

    pub(super) fn catch() -> io::Result<()> {
        let ignored = ignored();
        let caught = [SIGINT, SIGTERM, SIGHUP].into_iter().filter(|&signal| !ignored(signal));
        let mut signals = Signals::new(caught)?;
        std::thread::Builder::new().spawn(move || signals.forever().for_each(|_| super::requested()))?;
        Ok(())
    }

    pub(super) fn forgo_file_limit() {
        if !ignored()(SIGXFSZ) {
            // The flag is for nobody: what counts is that there is a handler.
            let _ = flag::register(SIGXFSZ, Arc::new(AtomicBool::new(false)));
        }
    }

    /// Returns whether a signal is ignored; none where the system does not tell (no `/proc`).
    fn ignored() -> impl Fn(c_int) -> bool {
        let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
        let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
        let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0);
        move |signal| mask >> (signal - 1) & 1 != 0
    }
}

#[cfg(not(target_os = "linux"))]
mod system {
    /// Catches all of them, or none where one is ignored.
    pub(super) fn catch() -> Result<(), ctrlc::Error> {
        ctrlc::try_set_handler(super::requested)
    }
}
