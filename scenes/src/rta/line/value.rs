//! The values of a statement: numbers, colours, names and files.

use core::fmt::Display;

use super::Line;
use crate::error::{Found, SceneError};
use crate::numbers::{AXES, Range};
use crate::rta::said::{Datum, error};
use crate::rta::table::{Kind, Statement, Value};
use crate::tokens::Token;

impl<'a> Line<'a> {
    pub(super) fn value(
        &mut self,
        statement: &Statement,
        Value(what, kind): &Value,
        data: &mut Vec<Datum<'a>>,
    ) -> Result<(), SceneError> {
        let noun = statement.noun;
        match *kind {
            Kind::Number(range) => {
                data.push(self.number(format_args!("the {what} of the {noun} ({range})"), range)?)
            }
            Kind::Share => data.push(self.number("a share from 0 to 1", Range::Share)?),
            Kind::Whole(least, most) => {
                let expected =
                    format_args!("the {what} of the {noun} (a whole number from {least} to {most})");
                let is_whole =
                    |token: &Token<'_>| token.text.parse().is_ok_and(|n: u32| (least..=most).contains(&n));
                let token = self.token(expected, is_whole)?;
                data.push(datum(token));
            }
            Kind::Vector(range) => {
                for axis in AXES {
                    data.push(
                        self.number(format_args!("the {axis} of the {noun}'s {what} ({range})"), range)?,
                    );
                }
            }
            Kind::Color(range) => data.extend(self.color(noun, what, range)?),
            Kind::Spectrum(range) => {
                let is_one = self.tokens.get(self.next + 1).is_none_or(|token| !token.is_like_a_number());
                if is_one && self.peek().is_some_and(|token| token.is_like_a_number()) {
                    data.extend([self.number(format_args!("the {what} of the {noun} ({range})"), range)?; 3]);
                } else {
                    data.extend(self.color(noun, what, range)?);
                }
            }
            Kind::New => {
                let expected = format_args!("a name of the {noun} (small letters, then digits and - too)");
                data.push(datum(self.token(expected, |token| is_name(token.text))?));
            }
            Kind::Name(expected) => data.push(datum(self.token(expected, |_| true)?)),
            Kind::File => {
                let expected = format_args!("the {what} of the {noun} (a name in quotes)");
                let token = self.token(expected, |token| unquoted(token.text).is_some())?;
                data.push(Datum { word: unquoted(token.text).unwrap_or_default(), ..datum(token) });
            }
            Kind::Axis => {
                let expected = format_args!("the {what} of the {noun} (x, y or z)");
                data.push(datum(self.token(expected, |token| AXES.contains(&token.text))?));
            }
            Kind::Offset => {
                if self.peek().is_some_and(|token| token.text == "offset") {
                    self.next += 1;
                    data.push(self.number(format_args!("the offset of the {noun} (a number)"), Range::Any)?);
                } else {
                    data.push(Datum { place: self.end(), number: 1.0, word: "1", is_number: true });
                }
            }
            Kind::Options => {
                while let Some(token) = self.peek() {
                    self.next += 1;
                    data.push(datum(token));
                }
            }
        }
        Ok(())
    }

    fn token(
        &mut self,
        expected: impl Display,
        is_meant: impl Fn(&Token<'a>) -> bool,
    ) -> Result<Token<'a>, SceneError> {
        let Some(token) = self.peek() else { return Err(self.error_at_end(expected.to_string())) };
        if !is_meant(&token) {
            return Err(error(self.file, (token.line, token.column), expected, Found::word(token.text)));
        }
        self.next += 1;
        Ok(token)
    }

    fn number(&mut self, expected: impl Display, range: Range) -> Result<Datum<'a>, SceneError> {
        let Some(token) = self.peek() else { return Err(self.error_at_end(expected.to_string())) };
        let read = datum(token);
        if !read.is_number || !range.holds(read.number) {
            return Err(error(self.file, read.place, expected, Found::token(token.text)));
        }
        self.next += 1;
        Ok(read)
    }

    fn color(&mut self, noun: &str, what: &str, range: Range) -> Result<[Datum<'a>; 3], SceneError> {
        let first = self.peek();
        let all = |number: f64, token: Token<'a>| [Datum { number, is_number: true, ..datum(token) }; 3];
        if let Some(token) = first
            && matches!(token.text, "white" | "black" | "grey" | "srgb")
        {
            self.next += 1;
            match token.text {
                "white" => return Ok(all(1.0, token)),
                "black" if range.holds(0.0) => return Ok(all(0.0, token)),
                "grey" => {
                    let expected = format_args!("the grey of the {noun}'s {what} ({range})");
                    return Ok([self.number(expected, range)?; 3]);
                }
                "srgb" => {
                    let mut byte = |register| {
                        let expected = format_args!(
                            "the {register} of the {noun}'s {what} (a whole number from 0 to 255)"
                        );
                        let token = self.token(expected, |token| token.text.parse::<u8>().is_ok())?;
                        let read = datum(token);
                        Ok(Datum { number: linear(read.number), ..read })
                    };
                    return Ok([byte("red")?, byte("green")?, byte("blue")?]);
                }
                _ => self.next -= 1,
            }
        }
        let words = if range.holds(0.0) { "or grey, srgb, white, black" } else { "or grey, srgb, white" };
        let expected = format!("the red of the {noun}'s {what} ({range}, {words})");
        let red = self.number(expected, range)?;
        let mut register =
            |register| self.number(format_args!("the {register} of the {noun}'s {what} ({range})"), range);
        Ok([red, register("green")?, register("blue")?])
    }
}

fn datum(token: Token<'_>) -> Datum<'_> {
    let number = token.text.parse().ok().filter(|number: &f64| number.is_finite());
    let place = (token.line, token.column);
    Datum { place, number: number.unwrap_or(0.0), word: token.text, is_number: number.is_some() }
}

/// Returns whether a word may be a name.
pub(in crate::rta) fn is_name(word: &str) -> bool {
    let is_inner = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
    word.starts_with(|c: char| c.is_ascii_lowercase()) && word.chars().all(is_inner)
}

fn unquoted(word: &str) -> Option<&str> {
    word.strip_prefix('"')?.strip_suffix('"')
}

/// Returns the linear light of a code of sRGB (IEC 61966-2-1).
fn linear(code: f64) -> f64 {
    let code = code / 255.0;
    if code <= 0.04045 { code / 12.92 } else { ((code + 0.055) / 1.055).powf(2.4) }
}
