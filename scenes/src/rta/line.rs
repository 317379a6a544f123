//! One statement of a file: the pieces of its lines, read as the table has them.

use super::nearest::{any_of, found};
use super::said::{Given, Place, Said, error};
use super::table::{Need, Part, Statement};
use crate::error::{Found, SceneError};
use crate::tokens::Token;

mod value;

pub(super) use value::is_name;

/// The pieces of a statement, of which the first is its keyword.
pub(super) struct Line<'a> {
    pub(super) file: &'a str,
    pub(super) tokens: Vec<Token<'a>>,
    /// How many were read.
    pub(super) next: usize,
}

impl<'a> Line<'a> {
    /// Reads the statement, whose keyword is known.
    pub(super) fn read(mut self, statement: &'static Statement) -> Result<Said<'a>, SceneError> {
        let place = self.tokens.first().map_or((1, 1), |token| (token.line, token.column));
        self.next = 1;
        let mut said = Vec::new();
        let is_keyword = |token: &Token<'_>| {
            statement.parts.iter().any(|part| !part.keyword.is_empty() && part.keyword == token.text)
        };
        if let Some(leading) = statement.leading()
            && (leading.need == Need::Must || self.peek().is_some_and(|token| !is_keyword(&token)))
        {
            self.part(statement, leading, place, &mut said)?;
        }
        while let Some(token) = self.peek() {
            let part = statement.parts.iter().find(|part| part.keyword == token.text);
            let Some(part) = part else { return Err(self.unknown(statement, &said, token)) };
            self.refuse(statement, part, &said, token)?;
            self.next += 1;
            self.part(statement, part, (token.line, token.column), &mut said)?;
        }
        if let Some(missing) = missing(statement, &said) {
            let expected = format!("{} of the {}", any_of(&missing), statement.noun);
            return Err(self.error_at_end(expected));
        }
        Ok(Said { file: self.file, statement, place, end: self.end(), parts: said })
    }

    fn peek(&self) -> Option<Token<'a>> {
        self.tokens.get(self.next).copied()
    }

    /// Refuses a part that was given before, or that excludes one which was.
    fn refuse(
        &self,
        statement: &Statement,
        part: &Part,
        said: &[Given<'_>],
        token: Token<'_>,
    ) -> Result<(), SceneError> {
        let found = if said.iter().any(|given| given.keyword == part.keyword) {
            let last =
                said.iter().rev().find(|given| !part.tail.iter().any(|tail| tail.keyword == given.keyword));
            if part.repeats && last.is_some_and(|given| given.keyword == part.keyword) {
                return Ok(());
            }
            format!("a second \"{}\"", part.keyword)
        } else {
            let (Need::One(_) | Need::AtMost(_)) = part.need else { return Ok(()) };
            let rivals = statement.parts.iter().filter(|other| other.need == part.need);
            let rival = rivals
                .map(|other| other.keyword)
                .find(|other| said.iter().any(|given| given.keyword == *other));
            match rival {
                None => return Ok(()),
                Some("") => format!("\"{}\" beside what stands first", part.keyword),
                Some(rival) => format!("\"{}\" beside \"{rival}\"", part.keyword),
            }
        };
        let expected = format!("nothing more of the {}", statement.noun);
        Err(error(self.file, (token.line, token.column), expected, Found::Told(found)))
    }

    /// The error about a word that is none of the statement's.
    fn unknown(&self, statement: &'static Statement, said: &[Given<'_>], token: Token<'_>) -> SceneError {
        let open = open(statement, said);
        let expected = match missing(statement, said) {
            Some(missing) => any_of(&missing),
            None if open.is_empty() => "nothing more".into(),
            None if token.is_like_a_number() => format!("nothing more, or {}", any_of(&open)),
            None => any_of(&open),
        };
        let expected = format!("{expected} of the {}", statement.noun);
        error(self.file, (token.line, token.column), expected, found(token.text, open))
    }

    /// Reads what follows a keyword.
    fn part(
        &mut self,
        statement: &Statement,
        part: &Part,
        place: Place,
        said: &mut Vec<Given<'a>>,
    ) -> Result<(), SceneError> {
        let mut data = Vec::new();
        for value in part.values {
            self.value(statement, value, &mut data)?;
        }
        let (more, most) = part.more;
        for _ in 0..most {
            if !self.peek().is_some_and(|token| token.is_like_a_number()) {
                break;
            }
            for value in more {
                self.value(statement, value, &mut data)?;
            }
        }
        said.push(Given { keyword: part.keyword, place, data });
        for tail in part.tail {
            match self.peek().filter(|token| token.text == tail.keyword) {
                Some(token) => {
                    self.next += 1;
                    self.part(statement, tail, (token.line, token.column), said)?;
                }
                None if tail.need == Need::Must => {
                    let expected = format!("\"{}\" of the {}", tail.keyword, statement.noun);
                    let Some(token) = self.peek() else { return Err(self.error_at_end(expected)) };
                    let found = found(token.text, [tail.keyword]);
                    return Err(error(self.file, (token.line, token.column), expected, found));
                }
                None => {}
            }
        }
        Ok(())
    }

    /// The place behind the last piece.
    fn end(&self) -> Place {
        self.tokens.last().map_or((1, 1), |token| {
            let length = u32::try_from(token.text.chars().count()).unwrap_or(u32::MAX);
            (token.line, token.column.saturating_add(length))
        })
    }

    fn error_at_end(&self, expected: String) -> SceneError {
        error(self.file, self.end(), expected, Found::Told("the end of the line".into()))
    }
}

/// Returns the keywords of what must still be given.
fn missing(statement: &'static Statement, said: &[Given<'_>]) -> Option<Vec<&'static str>> {
    let open = open(statement, said);
    let needed =
        |part: &&Part| matches!(part.need, Need::Must | Need::One(_)) && open.contains(&part.keyword);
    let words: Vec<_> = statement.parts.iter().filter(needed).map(|part| part.keyword).collect();
    (!words.is_empty()).then_some(words)
}

/// Returns the keywords that may still be given.
fn open(statement: &'static Statement, said: &[Given<'_>]) -> Vec<&'static str> {
    let is_given = |part: &Part| said.iter().any(|given| given.keyword == part.keyword);
    let is_excluded = |part: &Part| {
        let (Need::One(_) | Need::AtMost(_)) = part.need else { return false };
        statement.parts.iter().any(|other| other.need == part.need && is_given(other))
    };
    let parts = statement.parts.iter().filter(|part| !part.keyword.is_empty());
    parts.filter(|part| !is_given(part) && !is_excluded(part)).map(|part| part.keyword).collect()
}
