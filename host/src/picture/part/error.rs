//! What may be wrong with parts.

use core::ops::Range;
use std::path::PathBuf;

use super::MAGIC;

/// Why a file is no part of a picture.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PartError {
    /// It begins otherwise.
    #[error("no part of a picture: it does not begin with \"{MAGIC}\"")]
    NoPart,
    /// A line of the header is not as it should be.
    #[error("no part of a picture: {0} is missing in its header, or wrong")]
    Header(&'static str),
    /// It ends too early.
    #[error("cut off: {0} bytes are missing at its end")]
    CutOff(usize),
    /// It ends too late.
    #[error("{0} bytes follow its end")]
    Spare(usize),
    /// Its content is not what was written.
    #[error("damaged: its hash is not that of its content")]
    Damaged,
}

/// Why parts make no picture. It prints as one line.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum MergeError {
    /// A file is no part, or not all of one.
    #[error("{}: {source}", path.display())]
    Part {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        source: PartError,
    },
    /// Two parts are not of one picture.
    #[error("{} and {} are of two pictures: {setting} is {} in one and {} in the other", paths.0.display(), paths.1.display(), values.0, values.1)]
    Other {
        /// Their files.
        paths: Box<(PathBuf, PathBuf)>,
        /// What is not the same.
        setting: &'static str,
        /// Its values.
        values: Box<(String, String)>,
    },
    /// Rows or frames are in two parts.
    #[error("{what} {}..{} are in {} and in {}", rows.start, rows.end, paths.0.display(), paths.1.display())]
    Overlap {
        /// Rows, or frames.
        what: &'static str,
        /// Which.
        rows: Range<u32>,
        /// The files.
        paths: Box<(PathBuf, PathBuf)>,
    },
    /// Rows or frames are in no part.
    #[error("{what} {}..{} of {all} are in none of the parts", rows.start, rows.end)]
    Gap {
        /// Rows, or frames.
        what: &'static str,
        /// Which.
        rows: Range<u32>,
        /// How many there are in all.
        all: u32,
    },
}
