//! Textures.

use super::Reader;
use super::said::{Given, Said};
use crate::description::{Axis, Pattern, Texture};
use crate::error::{Found, SceneError};

fn axis(word: &str) -> Axis {
    match word {
        "x" => Axis::X,
        "y" => Axis::Y,
        _ => Axis::Z,
    }
}

impl<'a> Reader<'a> {
    pub(super) fn texture(&mut self, said: &Said<'a>) -> Result<(), SceneError> {
        let (name, place) = said.part("").map_or(("", said.place), |part| part.word(0));
        if let Some(first) = self.scene.textures.iter().find(|texture| texture.name == name) {
            let found = Found::Told(format!("\"{name}\", which is defined in line {}", first.line));
            return Err(said.error(place, "a new name of the texture", found));
        }
        let colors = |part: &Given<'_>| [part.numbers(0), part.numbers(3)];
        let or = |part: &Given<'_>, at, default| if part.data.len() > at { part.number(at) } else { default };
        let pattern = if let Some(part) = said.part("checker") {
            Pattern::Checker(colors(part))
        } else if let Some(part) = said.part("marble") {
            let octaves = if part.data.len() > 6 { part.whole(6) } else { 4 };
            Pattern::Marble { colors: colors(part), octaves, amount: or(part, 7, 2.0) }
        } else if let Some(part) = said.part("wood") {
            Pattern::Wood { colors: colors(part), amount: or(part, 6, 0.1) }
        } else {
            let file = said.part("image").map_or("", |part| part.word(0).0).to_owned();
            let plane = said.part("plane").map(|part| [0, 1].map(|at| axis(part.word(at).0)));
            Pattern::Image { file, nearest: said.has("nearest"), plane }
        };
        let (at, scale) = (said.triple("at").unwrap_or_default(), said.number("scale").unwrap_or(1.0));
        self.scene.textures.push(Texture { name: name.into(), pattern, at, scale, line: said.place.0 });
        Ok(())
    }

    /// Returns the name of a texture that was defined.
    pub(super) fn known_texture(&self, said: &Said<'a>, part: &Given<'a>) -> Result<String, SceneError> {
        let (name, place) = part.word(0);
        let mut known = self.scene.textures.iter().map(|texture| texture.name.as_str());
        if known.clone().any(|other| other == name) {
            return Ok(name.into());
        }
        Err(said.error(place, super::statements::A_TEXTURE, super::nearest::found(name, &mut known)))
    }
}
