//! A progress bar on a terminal, for work that takes longer than a second.

use core::time::Duration;
use std::io::{self, IsTerminal};
use std::time::Instant;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Time before the bar appears.
const PATIENCE: Duration = Duration::from_secs(1);

/// A bar on standard error if that is a terminal, and nothing anywhere else. It goes away when dropped.
#[derive(Debug)]
pub struct Progress {
    bar: ProgressBar,
    /// When the work began; none once the bar is shown, or where there is no terminal.
    waits_since: Option<Instant>,
}

impl Progress {
    /// Begins with none of `rows` rows done.
    #[must_use]
    pub fn new(rows: u32) -> Self {
        let bar = ProgressBar::with_draw_target(Some(rows.into()), ProgressDrawTarget::hidden());
        if let Ok(style) =
            ProgressStyle::with_template("{bar:40} {percent:>3} %  {elapsed} (about {eta} left){msg}")
        {
            bar.set_style(style);
        }
        Self { bar, waits_since: io::stderr().is_terminal().then(Instant::now) }
    }

    /// Tells something beside the bar.
    #[must_use]
    pub fn beside(self, text: String) -> Self {
        self.bar.set_message(text);
        self
    }

    /// Shows that the first `rows` rows are done.
    pub fn reached(&mut self, rows: u32) {
        if self.waits_since.is_some_and(|since| since.elapsed() > PATIENCE) {
            self.waits_since = None;
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        self.bar.set_position(rows.into());
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
