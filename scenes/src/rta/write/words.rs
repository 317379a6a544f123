//! The words of a statement that is being written.

use core::fmt::{Display, Write};

use crate::numbers::Numbers;
use crate::rta::statements;
use crate::rta::table::Part;

/// A statement that grows. It has no keyword that the table of statements does not have.
pub(super) struct Words {
    keyword: &'static str,
    text: String,
}

impl Words {
    /// Begins a statement.
    pub(super) fn new(keyword: &'static str) -> Self {
        Self { keyword, text: keyword.into() }
    }

    /// Takes the words out of a chain of calls.
    pub(super) fn take(&mut self) -> Self {
        Self { keyword: self.keyword, text: core::mem::take(&mut self.text) }
    }

    /// Adds a keyword, or nothing for values that need none, with its values.
    fn add(&mut self, keyword: &str, values: impl Display) -> &mut Self {
        debug_assert!(self.is_known(keyword), "{} {keyword}", self.keyword);
        // Keywords stand apart, so that people find them.
        let is_first = !self.text.contains(' ');
        let space = if keyword.is_empty() || is_first { " " } else { "  " };
        self.text += space;
        self.text += keyword;
        let before = self.text.len();
        // A String takes all that is written to it.
        let _ = write!(self.text, " {values}");
        if self.text.len() == before + 1 || keyword.is_empty() {
            self.text.remove(before);
        }
        self
    }

    fn is_known(&self, keyword: &str) -> bool {
        fn among(parts: &[Part], keyword: &str) -> bool {
            parts.iter().any(|part| part.keyword == keyword || among(part.tail, keyword))
        }
        keyword.is_empty()
            || statements::all()
                .any(|statement| statement.keyword == self.keyword && among(statement.parts, keyword))
    }

    pub(super) fn word(&mut self, keyword: &str) -> &mut Self {
        self.add(keyword, "")
    }

    pub(super) fn flag(&mut self, keyword: &str, is_set: bool) -> &mut Self {
        if is_set { self.word(keyword) } else { self }
    }

    pub(super) fn name(&mut self, keyword: &str, name: &str) -> &mut Self {
        self.add(keyword, name)
    }

    pub(super) fn file(&mut self, keyword: &str, file: &str) -> &mut Self {
        self.add(keyword, format_args!("\"{file}\""))
    }

    pub(super) fn number(&mut self, keyword: &str, number: f64) -> &mut Self {
        self.add(keyword, Numbers(&[number]))
    }

    pub(super) fn numbers(&mut self, keyword: &str, numbers: &[f64]) -> &mut Self {
        if numbers.is_empty() { self } else { self.add(keyword, Numbers(numbers)) }
    }

    pub(super) fn vector(&mut self, keyword: &str, vector: [f64; 3]) -> &mut Self {
        self.add(keyword, Numbers(&vector))
    }

    pub(super) fn color(&mut self, keyword: &str, color: [f64; 3]) -> &mut Self {
        match color {
            [0.0, 0.0, 0.0] => self.add(keyword, "black"),
            [1.0, 1.0, 1.0] => self.add(keyword, "white"),
            [red, green, blue] if red == green && green == blue => {
                self.add(keyword, format_args!("grey {}", Numbers(&[red])))
            }
            _ => self.vector(keyword, color),
        }
    }

    /// Adds what there is.
    pub(super) fn maybe<T>(&mut self, value: Option<T>, add: impl FnOnce(&mut Self, T) -> &mut Self) {
        if let Some(value) = value {
            add(self, value);
        }
    }

    /// Ends the line.
    pub(super) fn end(&self, text: &mut String) {
        text.push_str(&self.text);
        text.push('\n');
    }
}
