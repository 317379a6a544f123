//! What a reader has to say of a scene that it has read all the same.

use core::fmt::{self, Display};

/// Something in a scene file that is perhaps not meant as it was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// Line of the file, from 1; 0 for what concerns the scene as a whole.
    pub line: u32,
    /// What it is, and what was made of it; without a full stop.
    pub text: String,
}

impl Warning {
    /// Returns the warning as a line for people: `scene.nff:12: ...`.
    pub fn of_file<'a>(&'a self, file: &'a str) -> impl Display + 'a {
        fmt::from_fn(move |f| match self.line {
            0 => write!(f, "{file}: {}", self.text),
            line => write!(f, "{file}:{line}: {}", self.text),
        })
    }
}

/// Warnings of one kind that a file may give cause for a million times: the first is told, the others are counted.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tally {
    first: Option<Warning>,
    others: usize,
}

impl Tally {
    /// Counts a warning.
    pub(crate) fn count(&mut self, line: u32, text: impl FnOnce() -> String) {
        match self.first {
            None => self.first = Some(Warning { line, text: text() }),
            Some(_) => self.others += 1,
        }
    }

    /// Returns the one warning, if there was any.
    pub(crate) fn told(self) -> Option<Warning> {
        let Self { first, others } = self;
        first.map(|Warning { line, text }| match others {
            0 => Warning { line, text },
            _ => Warning { line, text: format!("{text}; and {others} more like it") },
        })
    }
}
