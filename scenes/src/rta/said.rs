//! What a statement says, once it was read.

use core::fmt::Display;

use super::table::Statement;
use crate::error::{Found, SceneError};

/// Line and column, from 1.
pub(super) type Place = (u32, u32);

/// A value that was read.
#[derive(Clone, Copy)]
pub(super) struct Datum<'a> {
    pub(super) place: Place,
    /// 0 for a word.
    pub(super) number: f64,
    /// What stands there; without quotes where it is a file.
    pub(super) word: &'a str,
    /// Whether it is a number.
    pub(super) is_number: bool,
}

/// A part that was read. Colours and vectors are three values each.
pub(super) struct Given<'a> {
    pub(super) keyword: &'static str,
    pub(super) place: Place,
    pub(super) data: Vec<Datum<'a>>,
}

impl<'a> Given<'a> {
    /// Returns numbers from a place among the values on; 0 where there are too few.
    pub(super) fn numbers<const N: usize>(&self, from: usize) -> [f64; N] {
        core::array::from_fn(|i| self.number(from + i))
    }

    /// Returns a number; 0 where there is none.
    pub(super) fn number(&self, at: usize) -> f64 {
        self.data.get(at).map_or(0.0, |datum| datum.number)
    }

    /// Returns a whole number; 0 where there is none.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "it was read as a whole number"
    )]
    pub(super) fn whole(&self, at: usize) -> u32 {
        self.number(at) as u32
    }

    /// Returns a word and where it stands.
    pub(super) fn word(&self, at: usize) -> (&'a str, Place) {
        self.data.get(at).map_or(("", self.place), |datum| (datum.word, datum.place))
    }
}

/// A statement that was read.
pub(super) struct Said<'a> {
    pub(super) file: &'a str,
    pub(super) statement: &'static Statement,
    pub(super) place: Place,
    /// Where it ends.
    pub(super) end: Place,
    /// What it says, in the order of the file.
    pub(super) parts: Vec<Given<'a>>,
}

impl<'a> Said<'a> {
    /// Returns a part, if it was given.
    pub(super) fn part(&self, keyword: &str) -> Option<&Given<'a>> {
        self.parts.iter().find(|part| part.keyword == keyword)
    }

    /// Returns whether a part was given.
    pub(super) fn has(&self, keyword: &str) -> bool {
        self.part(keyword).is_some()
    }

    /// Returns the number of a part, if it was given.
    pub(super) fn number(&self, keyword: &str) -> Option<f64> {
        self.part(keyword).map(|part| part.number(0))
    }

    /// Returns the whole number of a part, if it was given.
    pub(super) fn whole(&self, keyword: &str) -> Option<u32> {
        self.part(keyword).map(|part| part.whole(0))
    }

    /// Returns the vector or colour of a part, if it was given.
    pub(super) fn triple(&self, keyword: &str) -> Option<[f64; 3]> {
        self.part(keyword).map(|part| part.numbers(0))
    }

    /// Returns the number of the part that stays behind another, if it was given.
    pub(super) fn after(&self, keyword: &str, tail: &str) -> Option<&Given<'a>> {
        let behind = self.parts.iter().skip_while(|part| part.keyword != keyword).nth(1);
        behind.filter(|part| part.keyword == tail)
    }

    /// Returns an error about this statement.
    pub(super) fn error(&self, place: Place, expected: impl Display, found: Found) -> SceneError {
        error(self.file, place, expected, found)
    }
}

pub(super) fn error(file: &str, (line, column): Place, expected: impl Display, found: Found) -> SceneError {
    SceneError { file: file.into(), line, column, expected: expected.to_string(), found, note: None }
}
