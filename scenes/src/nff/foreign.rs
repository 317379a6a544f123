//! Lines that are no entity of the format: which of them are passed over.

use super::Reader;
use crate::error::{Found, SceneError};
use crate::tokens::Token;

/// What of the entities an error names.
const EXPECTED: &str = "an entity (one of v, b, l, f, s, c, p and pp) or the end of the file";

impl Reader<'_> {
    /// Refuses a file of another format that has this one's name.
    pub(super) fn refuse_other_format(&self, first: Token<'_>) -> Result<(), SceneError> {
        if !first.text.eq_ignore_ascii_case("nff") {
            return Ok(());
        }
        let error = self.wrong(first, EXPECTED.into());
        Err(error.with_note(|| Some("this is WorldToolKit's NFF (Sense8), which rta does not read".into())))
    }

    /// Passes over a line that begins with an unknown word, or does not.
    pub(super) fn foreign(&mut self, entity: Token<'_>, lower: &str) -> Result<(), SceneError> {
        let Token { text, line, column } = entity;
        let mut ahead = self.tokens.clone();
        let rest = core::iter::from_fn(|| ahead.next().filter(|token| token.line == line));
        let (mut numbers, mut words) = (0, 0);
        // The least and the greatest number of the line.
        let (mut least, mut greatest) = (0.0_f64, 0.0_f64);
        for token in rest {
            *(if token.is_like_a_number() { &mut numbers } else { &mut words }) += 1;
            let number = token.text.parse().unwrap_or(f64::INFINITY);
            (least, greatest) = (least.min(number), greatest.max(number));
        }
        let is_word = !entity.is_like_a_number();
        // What has no effect on the picture, or asks for what is so anyway.
        let is_harmless = match lower {
            "accel" | "focal" => true,
            "aperture" => least >= 0.0 && greatest <= 0.0,
            "spp" => least >= 0.0 && greatest <= 1.0,
            _ => false,
        };
        let is_known = is_harmless || matches!(lower, "tess" | "spp" | "aperture");
        let is_setting = is_word && text.len() == 1 && numbers > 0 && words == 0;
        let is_heading = is_word && numbers == 0;
        if !(is_known || is_setting || is_heading || self.reading.lenient) {
            let found = if is_word { Found::Unknown(Found::show(text)) } else { Found::word(text) };
            return Err(self.tokens.error((line, column), EXPECTED.into(), found));
        }
        self.tokens.skip_line();
        if is_harmless {
            return Ok(());
        }
        let shown = Found::show(text);
        if self.unknown.is_none() && !is_known && !self.reading.lenient {
            let note = || Some("without a viewpoint it may be another format of that name".into());
            self.unknown = Some(self.wrong(entity, EXPECTED.into()).with_note(note));
        }
        let more = if numbers + words > 0 { " and the rest of its line are" } else { " is" };
        self.warn(line, format!("\"{shown}\"{more} passed over: it is no entity that rta draws"));
        Ok(())
    }
}
