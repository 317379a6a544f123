//! What a key has led to, in words: told in the window's title, for a while over the picture, and once on the terminal.

use core::time::Duration;
use std::time::Instant;

/// Time for which a message that is no error is to be seen over the picture.
const VISIBLE: Duration = Duration::from_secs(4);

/// A message or an error.
#[derive(Clone, Debug)]
pub struct Note {
    text: String,
    is_error: bool,
    since: Instant,
    is_told: bool,
}

impl Note {
    /// Returns a message.
    #[must_use]
    pub fn message(text: String) -> Self {
        Self { text, is_error: false, since: Instant::now(), is_told: false }
    }

    /// Returns the message that something has failed.
    #[must_use]
    pub fn error(text: String) -> Self {
        Self { is_error: true, ..Self::message(text) }
    }

    /// Returns what it says.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Returns whether something has failed.
    #[must_use]
    pub const fn is_error(&self) -> bool {
        self.is_error
    }

    /// Returns what it says as long as it is to be seen over the picture: a message for some seconds, an error until another note
    /// takes its place.
    #[must_use]
    pub fn visible(&self) -> Option<&str> {
        (self.is_error || self.since.elapsed() < VISIBLE).then_some(&self.text)
    }

    /// Returns the note if it has not been told on the terminal yet; from now on it has.
    pub fn tell(&mut self) -> Option<Self> {
        (!core::mem::replace(&mut self.is_told, true)).then(|| self.clone())
    }
}
