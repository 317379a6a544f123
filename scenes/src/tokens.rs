//! A text cut at white space, each piece with its line and column. `#` begins a comment.

use crate::error::{Found, SceneError};

/// One piece of the text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Token<'a> {
    pub(crate) text: &'a str,
    pub(crate) line: u32,
    pub(crate) column: u32,
}

impl Token<'_> {
    /// Whether this is meant as a number, well formed or not.
    pub(crate) fn is_like_a_number(&self) -> bool {
        self.text.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c))
            || self.text.parse::<f64>().is_ok()
    }
}

/// The text still to be read, and where that begins.
#[derive(Clone, Debug)]
pub(crate) struct Tokens<'a> {
    rest: &'a str,
    file: &'a str,
    line: u32,
    column: u32,
}

impl<'a> Tokens<'a> {
    /// Checks that `text` is text. A byte order mark is skipped and has no column.
    pub(crate) fn new(text: &'a [u8], file: &'a str) -> Result<Self, SceneError> {
        let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
        let valid = match core::str::from_utf8(text) {
            Ok(valid) => valid,
            // What comes before the bad byte was valid, so this conversion does not fail.
            Err(error) => {
                core::str::from_utf8(text.get(..error.valid_up_to()).unwrap_or(&[])).unwrap_or_default()
            }
        };
        let end = valid.find('\0').unwrap_or(valid.len());
        let mut tokens = Self { rest: valid, file, line: 1, column: 1 };
        if let Some(&byte) = text.get(end) {
            tokens.skip(end);
            let (line, column) = (tokens.line, tokens.column);
            return Err(tokens.error(
                line,
                column,
                "a scene, which is text in UTF-8".into(),
                Found::Binary(byte),
            ));
        }
        Ok(tokens)
    }

    /// The next piece, or nothing at the end of the text.
    pub(crate) fn next(&mut self) -> Option<Token<'a>> {
        self.skip_blank();
        let (line, column) = (self.line, self.column);
        let text =
            self.skip(self.rest.find(|c: char| c.is_whitespace() || c == '#').unwrap_or(self.rest.len()));
        (!text.is_empty()).then_some(Token { text, line, column })
    }

    /// Line and column of the next piece, or of the end of the text.
    pub(crate) fn place(&mut self) -> (u32, u32) {
        self.skip_blank();
        (self.line, self.column)
    }

    /// An error at the given place of this text.
    pub(crate) fn error(&self, line: u32, column: u32, expected: String, found: Found) -> SceneError {
        SceneError { file: self.file.into(), line, column, expected, found }
    }

    fn skip_blank(&mut self) {
        loop {
            if self.rest.starts_with('#') {
                self.skip(self.rest.find(['\n', '\r']).unwrap_or(self.rest.len()));
            }
            match self.rest.find(|c: char| !c.is_whitespace()).unwrap_or(self.rest.len()) {
                0 => return,
                blank => self.skip(blank),
            };
        }
    }

    /// Goes on by `length` bytes, which end between two characters, and returns what it passed.
    fn skip(&mut self, length: usize) -> &'a str {
        let (passed, rest) = self.rest.split_at(length);
        let mut characters = passed.chars().chain(rest.chars().take(1)).peekable();
        for _ in passed.chars() {
            // A line ends with LF, CR LF or CR.
            match (characters.next(), characters.peek()) {
                (Some('\n'), _) => (self.line, self.column) = (self.line.saturating_add(1), 1),
                (Some('\r'), next) if next != Some(&'\n') => {
                    (self.line, self.column) = (self.line.saturating_add(1), 1);
                }
                _ => self.column = self.column.saturating_add(1),
            }
        }
        self.rest = rest;
        passed
    }
}

#[cfg(test)]
mod tests {
    use super::Tokens;
    use crate::error::Found;

    fn places(text: &str) -> Vec<(&str, u32, u32)> {
        let mut tokens = Tokens::new(text.as_bytes(), "t").expect("it is text");
        core::iter::from_fn(|| tokens.next()).map(|token| (token.text, token.line, token.column)).collect()
    }

    #[test]
    fn places_count_from_one_in_characters() {
        assert_eq!(places("a bc\n\n  d"), [("a", 1, 1), ("bc", 1, 3), ("d", 3, 3)]);
        assert_eq!(places("éé\u{a0}x"), [("éé", 1, 1), ("x", 1, 4)]);
        assert_eq!(places("\ta"), [("a", 1, 2)]);
        assert_eq!(places("\u{feff}a"), [("a", 1, 1)]);
    }

    #[test]
    fn lines_end_in_three_ways() {
        for end in ["\n", "\r\n", "\r"] {
            let text = format!("a{end}{end}b # c{end}d#e f{end}#{end}");
            assert_eq!(places(&text), [("a", 1, 1), ("b", 3, 1), ("d", 4, 1)], "{end:?}");
        }
    }

    #[test]
    fn comments_and_blanks_alone_are_nothing() {
        for text in ["", " \n\t", "# all", "#a\n#b\n", "#\r\n #"] {
            assert_eq!(places(text), [], "{text:?}");
        }
    }

    #[test]
    fn binary_is_refused_where_it_begins() {
        let cases: [(&[u8], u32, u32, u8); 5] = [
            (b"1 2\n3 \0 4", 2, 3, 0),
            (b"# \xc3\xa9\xff", 1, 4, 0xff),
            (b"\xff\xfe1\0", 1, 1, 0xff),
            (b"a\0\xff", 1, 2, 0),
            (b"ab\xc3", 1, 3, 0xc3),
        ];
        for (text, line, column, byte) in cases {
            let error = Tokens::new(text, "t").expect_err("it is binary");
            assert_eq!((error.line, error.column, error.found), (line, column, Found::Binary(byte)));
        }
    }
}
