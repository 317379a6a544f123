//! Inputs that an output must not replace.

use std::fs::File;
use std::path::Path;
use std::sync::Arc;

use same_file::Handle;

/// The files that a command has read, which are known again by whatever name they are written to: they are compared by device and
/// inode (on Windows by volume and index) and stay open as long as this lives. Only ordinary files count: a terminal or `/dev/null`
/// may well be both ends.
#[derive(Clone, Debug, Default)]
pub struct Inputs(Vec<Arc<Handle>>);

impl Inputs {
    /// No input, for what is made of nothing that could be replaced.
    pub const NONE: &Self = &Self(Vec::new());

    /// Returns the one input `file`, if it is an ordinary file.
    #[must_use]
    pub fn file(file: &File) -> Self {
        Self(file.try_clone().and_then(Handle::from_file).ok().and_then(ordinary).into_iter().collect())
    }

    /// Returns what standard input comes from, if it is an ordinary file.
    #[must_use]
    pub fn stdin() -> Self {
        Self(Handle::stdin().ok().and_then(ordinary).into_iter().collect())
    }

    /// Adds all of `others`.
    pub fn add(&mut self, others: &Self) {
        self.0.extend(others.0.iter().cloned());
    }

    /// Returns whether the file that `path` leads to, through whatever links, is among them.
    #[must_use]
    pub fn has(&self, path: &Path) -> bool {
        !self.0.is_empty() && Handle::from_path(path).is_ok_and(|output| self.holds(&output))
    }

    /// Returns whether standard output goes into one of them.
    #[must_use]
    pub fn has_stdout(&self) -> bool {
        !self.0.is_empty() && Handle::stdout().is_ok_and(|output| self.holds(&output))
    }

    fn holds(&self, output: &Handle) -> bool {
        self.0.iter().any(|input| **input == *output)
    }
}

fn ordinary(handle: Handle) -> Option<Arc<Handle>> {
    let ordinary = handle.as_file().metadata().is_ok_and(|metadata| metadata.is_file());
    ordinary.then(|| Arc::new(handle))
}
