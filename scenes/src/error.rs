//! What is wrong with a scene file, and where.

use core::error::Error;
use core::fmt;

/// A scene file that cannot be read. It prints as `scene.dat:12:5: expected ..., found ...`.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct SceneError {
    /// The name that the file was read under.
    pub file: String,
    /// Line, from 1.
    pub line: u32,
    /// Column, from 1, in characters.
    pub column: u32,
    /// What should stand there, with its range: `the radius of sphere 3 of 70 (a number > 0)`.
    pub expected: String,
    /// What stands there.
    pub found: Found,
    /// What helps to find the cause, which may stand earlier: `the sphere that begins in line 12 has 6 of 8 numbers`.
    pub note: Option<Box<str>>,
}

/// What stands in a scene file where something else should. The texts are ready to print: of long ones only the
/// beginning is kept, and control characters are escaped.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Found {
    /// A number, or several, of the wrong size or kind.
    Number(String),
    /// Something that is no number at all.
    NotANumber(String),
    /// Something other than the word that should stand there.
    Word(String),
    /// A word where an entity of NFF should stand, and is none; a lenient reader passes over it.
    Unknown(String),
    /// A number that is infinite, undefined, or too large for `f64`.
    NotFinite(String),
    /// The file ends here.
    EndOfFile,
    /// The file has nothing in it but white space and comments.
    EmptyFile,
    /// Something that is told in words, such as the end of a line, or a word with the one that is perhaps meant.
    Told(String),
    /// A byte outside of comments that is not text: a NUL, or one that is not UTF-8.
    Binary(u8),
}

impl Found {
    /// Longest piece of a file that an error repeats, in characters.
    const LONGEST: usize = 32;

    /// Tells what `token` is, for an error.
    pub(crate) fn token(token: &str) -> Self {
        let shown = Self::show(token);
        match token.parse::<f64>() {
            Ok(number) if number.is_finite() => Self::Number(shown),
            Ok(_) => Self::NotFinite(shown),
            Err(_) => Self::NotANumber(shown),
        }
    }

    /// Tells what `token` is where a word is expected, not a number.
    pub(crate) fn word(token: &str) -> Self {
        match Self::token(token) {
            Self::NotANumber(shown) => Self::Word(shown),
            number => number,
        }
    }

    /// Returns a piece of a file ready to be printed.
    pub(crate) fn show(token: &str) -> String {
        let mut shown: String = token.chars().take(Self::LONGEST).flat_map(char::escape_debug).collect();
        if token.chars().nth(Self::LONGEST).is_some() {
            shown.push_str("...");
        }
        shown
    }
}

impl fmt::Display for Found {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(text) | Self::Told(text) => write!(f, "{text}"),
            Self::NotANumber(text) => write!(f, "\"{text}\", not a number"),
            Self::Word(text) | Self::Unknown(text) => write!(f, "\"{text}\""),
            Self::NotFinite(text) => write!(f, "{text}, not a finite number"),
            Self::EndOfFile => write!(f, "end of file"),
            Self::EmptyFile => write!(f, "an empty file"),
            Self::Binary(byte) => write!(f, "a binary file (byte {byte:#04x})"),
        }
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { file, line, column, expected, found, note } = self;
        write!(f, "{file}:{line}:{column}: expected {expected}, found {found}")?;
        note.as_ref().map_or(Ok(()), |note| write!(f, "; {note}"))
    }
}

impl Error for SceneError {}

/// An entry of a scene file that is being read: what an error says of it where it is too short.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    /// What it is: `sphere`.
    pub(crate) kind: &'static str,
    /// The line where it begins.
    pub(crate) line: u32,
    /// How many pieces of the file come before its numbers.
    pub(crate) begin: usize,
    /// How many numbers it has.
    pub(crate) numbers: usize,
}

impl Entry {
    /// Returns the note that the entry has only `had` of its numbers.
    pub(crate) fn is_short(&self, had: usize) -> String {
        format!("the {} that begins in line {} has {had} of {} numbers", self.kind, self.line, self.numbers)
    }
}

impl SceneError {
    /// Returns the error with a note, if it has none yet.
    pub(crate) fn with_note(mut self, note: impl FnOnce() -> Option<String>) -> Self {
        self.note = self.note.or_else(|| note().map(String::into_boxed_str));
        self
    }
}

#[cfg(test)]
mod tests {
    use super::Found;

    #[test]
    fn tokens_are_told_apart() {
        assert_eq!(Found::token("-1.5e3"), Found::Number("-1.5e3".into()));
        for token in ["inf", "-Infinity", "NaN", "1e400"] {
            assert_eq!(Found::token(token), Found::NotFinite(token.into()));
        }
        for token in ["0x10", "1,5", "--1", "1e", "radius", "1f"] {
            assert_eq!(Found::token(token), Found::NotANumber(token.into()));
        }
    }

    #[test]
    fn long_and_unprintable_tokens_are_shown_short_and_escaped() {
        assert_eq!(Found::token("\u{1b}[31m\u{7}").to_string(), r#""\u{1b}[31m\u{7}", not a number"#);
        assert_eq!(Found::token(&"9".repeat(32)).to_string(), "9".repeat(32));
        assert_eq!(Found::token(&"9".repeat(33)).to_string(), "9".repeat(32) + "...");
        assert_eq!(Found::token(&"é".repeat(40)), Found::NotANumber("é".repeat(32) + "..."));
    }
}
