//! A text cut at white space, each piece with its line and column. `#` begins a comment. Where it is asked for, a piece in
//! quotes holds white space and `#` too.

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
    /// Outside of comments it is UTF-8 without a NUL.
    rest: &'a [u8],
    file: &'a str,
    line: u32,
    column: u32,
    /// Pieces that were read, all of them and those before the line of the last one.
    read: (usize, usize),
    /// The line of the last piece that was read.
    last_line: u32,
    /// Whether a piece that begins with a quote goes on to the next one, or to the end of its line.
    has_quotes: bool,
}

impl<'a> Tokens<'a> {
    /// Checks that `text` is text. A byte order mark is skipped and has no column; comments hold any bytes; Ctrl-Z ends a
    /// text, as it did under CP/M and DOS, where nothing but blanks and more of it follows.
    pub(crate) fn new(text: &'a [u8], file: &'a str) -> Result<Self, SceneError> {
        let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
        let text = without_end_mark(text);
        let mut tokens =
            Self { rest: text, file, line: 1, column: 1, read: (0, 0), last_line: 0, has_quotes: false };
        if let Some((at, byte)) = not_text(text) {
            tokens.skip(at);
            let place = (tokens.line, tokens.column);
            return Err(tokens.error(place, "a scene, which is text in UTF-8".into(), Found::Binary(byte)));
        }
        Ok(tokens)
    }

    /// The text with pieces in quotes.
    pub(crate) fn with_quotes(self) -> Self {
        Self { has_quotes: true, ..self }
    }

    /// The next piece, or nothing at the end of the text. A piece in quotes keeps them; it ends with its line at the latest.
    pub(crate) fn next(&mut self) -> Option<Token<'a>> {
        self.skip_blank();
        let (line, column) = (self.line, self.column);
        let is_quoted = self.has_quotes && self.rest.first() == Some(&b'"');
        let length = if is_quoted { quoted(self.rest) } else { word(self.rest) };
        let piece = self.skip(length);
        if piece.is_empty() {
            return None;
        }
        // What is no UTF-8 stands behind a # in quotes: a quote alone is no name of a file.
        let text = core::str::from_utf8(piece).unwrap_or("\"");
        if line != self.last_line {
            (self.read.1, self.last_line) = (self.read.0, line);
        }
        self.read.0 += 1;
        Some(Token { text, line, column })
    }

    /// The next piece, which stays the next one.
    pub(crate) fn peek(&self) -> Option<Token<'a>> {
        self.clone().next()
    }

    /// Line and column of the next piece, or of the end of the text.
    pub(crate) fn place(&mut self) -> (u32, u32) {
        self.skip_blank();
        (self.line, self.column)
    }

    /// How many pieces were read: all of them, and those that stand before the line of the last one.
    pub(crate) fn read(&self) -> (usize, usize) {
        self.read
    }

    /// Whether the next piece stands in the line of the last one that was read.
    pub(crate) fn is_amid_line(&self) -> bool {
        self.peek().is_some_and(|token| token.line == self.last_line)
    }

    /// Goes past what is left of the line of the last piece.
    pub(crate) fn skip_line(&mut self) {
        while self.is_amid_line() {
            self.next();
        }
    }

    /// How many pieces come next that are meant as numbers, at most `most`.
    pub(crate) fn numbers_ahead(&self, most: usize) -> usize {
        let mut ahead = self.clone();
        let pieces = core::iter::from_fn(|| ahead.next());
        pieces.take(most).take_while(Token::is_like_a_number).count()
    }

    /// An error at the given line and column of this text.
    pub(crate) fn error(&self, (line, column): (u32, u32), expected: String, found: Found) -> SceneError {
        SceneError { file: self.file.into(), line, column, expected, found, note: None }
    }

    fn skip_blank(&mut self) {
        loop {
            if self.rest.first() == Some(&b'#') {
                self.skip(
                    self.rest.iter().position(|byte| b"\n\r".contains(byte)).unwrap_or(self.rest.len()),
                );
            }
            match blank(self.rest) {
                0 => return,
                blank => self.skip(blank),
            };
        }
    }

    /// Goes on by `length` bytes, which end between two characters, and returns what it passed.
    fn skip(&mut self, length: usize) -> &'a [u8] {
        let (passed, rest) = self.rest.split_at(length.min(self.rest.len()));
        let mut bytes = passed.iter().chain(rest.first()).peekable();
        for _ in passed {
            // A line ends with LF, CR LF or CR.
            match (bytes.next(), bytes.peek()) {
                (Some(b'\n'), _) => (self.line, self.column) = (self.line.saturating_add(1), 1),
                (Some(b'\r'), next) if next != Some(&&b'\n') => {
                    (self.line, self.column) = (self.line.saturating_add(1), 1);
                }
                // The first byte of a character has its column.
                (Some(byte), _) if byte & 0xc0 == 0x80 => {}
                _ => self.column = self.column.saturating_add(1),
            }
        }
        self.rest = rest;
        passed
    }
}

/// Returns the text without a Ctrl-Z at its end, and what of blanks, NULs and more of them follows it.
fn without_end_mark(text: &[u8]) -> &[u8] {
    let is_filling = |byte: &u8| matches!(byte, 0x1a | 0) || byte.is_ascii_whitespace();
    let end = text.iter().rposition(|byte| !is_filling(byte)).map_or(0, |last| last + 1);
    let (whole, filling) = text.split_at(end);
    match filling.iter().position(|byte| *byte == 0x1a) {
        Some(mark) => text.get(..end + mark).unwrap_or(whole),
        None => text,
    }
}

/// Returns the first byte outside of comments that is no text, and where it is.
fn not_text(text: &[u8]) -> Option<(usize, u8)> {
    if core::str::from_utf8(text).is_ok() && !text.contains(&0) {
        return None;
    }
    let (mut at, mut in_comment) = (0, false);
    for chunk in text.utf8_chunks() {
        for byte in chunk.valid().bytes() {
            match byte {
                b'\n' | b'\r' => in_comment = false,
                b'#' => in_comment = true,
                0 if !in_comment => return Some((at, 0)),
                _ => {}
            }
            at += 1;
        }
        if let (Some(&byte), false) = (chunk.invalid().first(), in_comment) {
            return Some((at, byte));
        }
        at += chunk.invalid().len();
    }
    None
}

/// Returns the character at the beginning of some text, and its length in bytes.
fn character(text: &[u8]) -> Option<(char, usize)> {
    let chunk = text.get(..text.len().min(4))?.utf8_chunks().next()?;
    chunk.valid().chars().next().map(|c| (c, c.len_utf8()))
}

/// Returns the length in bytes of the white space with which a text begins.
fn blank(text: &[u8]) -> usize {
    let mut length = 0;
    while let Some(&byte) = text.get(length) {
        length += match byte {
            b' ' | b'\t'..=b'\r' => 1,
            0..0x80 => break,
            _ => match text.get(length..).and_then(character) {
                Some((c, bytes)) if c.is_whitespace() => bytes,
                _ => break,
            },
        };
    }
    length
}

/// Returns the length in bytes of the piece in quotes with which a text begins.
fn quoted(text: &[u8]) -> usize {
    let end = text.iter().skip(1).position(|byte| b"\"\n\r".contains(byte));
    match end.map(|inside| inside + 1) {
        Some(end) if text.get(end) == Some(&b'"') => end + 1,
        end => end.unwrap_or(text.len()),
    }
}

/// Returns the length in bytes of the piece with which a text begins.
fn word(text: &[u8]) -> usize {
    let mut length = 0;
    while let Some(&byte) = text.get(length) {
        length += match byte {
            b' ' | b'\t'..=b'\r' | b'#' => break,
            0..0x80 => 1,
            _ => match text.get(length..).and_then(character) {
                Some((c, _)) if c.is_whitespace() => break,
                Some((_, bytes)) => bytes,
                None => 1,
            },
        };
    }
    length
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
            (b"\xc3\xa9\xff # \xff", 1, 2, 0xff),
            (b"\xff\xfe1\0", 1, 1, 0xff),
            (b"a\0\xff", 1, 2, 0),
            (b"ab\xc3", 1, 3, 0xc3),
        ];
        for (text, line, column, byte) in cases {
            let error = Tokens::new(text, "t").expect_err("it is binary");
            assert_eq!((error.line, error.column, error.found), (line, column, Found::Binary(byte)));
        }
    }

    #[test]
    fn comments_hold_any_bytes() {
        let mut tokens = Tokens::new(b"# \xf3\0\r1 #\x85\xff\n 2#\xc3", "t").expect("it is text");
        let read =
            core::array::from_fn(|_| tokens.next().map(|token| (token.text, token.line, token.column)));
        assert_eq!(read, [Some(("1", 2, 1)), Some(("2", 3, 2)), None]);
    }

    #[test]
    fn ctrl_z_ends_a_text() {
        for end in ["\x1a", "\x1a\r\n", "\r\n\x1a\x1a\0\0", " \x1a \x1a"] {
            assert_eq!(places(&format!("a b{end}")), [("a", 1, 1), ("b", 1, 3)], "{end:?}");
        }
        assert_eq!(places("a\x1a b"), [("a\x1a", 1, 1), ("b", 1, 4)]);
        assert!(Tokens::new(b"a \0\0", "t").is_err());
    }

    #[test]
    fn pieces_are_counted_by_their_lines() {
        let mut tokens = Tokens::new(b"1 2\n3 4 a 5", "t").expect("it is text");
        assert_eq!((tokens.numbers_ahead(9), tokens.numbers_ahead(3)), (4, 3));
        tokens.next();
        assert!(tokens.is_amid_line());
        tokens.next();
        assert!(!tokens.is_amid_line());
        tokens.next();
        assert_eq!(tokens.read(), (3, 2));
        tokens.skip_line();
        assert_eq!((tokens.read(), tokens.next()), ((6, 2), None));
    }
}
