//! Paths, and what goes along them.

use super::Reader;
use super::said::{Given, Said};
use super::statements::A_PATH;
use crate::description::{Keyframe, Path};
use crate::error::{Found, SceneError};
use crate::numbers::Short;

impl<'a> Reader<'a> {
    pub(super) fn path(&mut self, said: &Said<'a>) -> Result<(), SceneError> {
        let (name, place) = said.part("").map_or(("", said.place), |part| part.word(0));
        if self.scene.details.paths.iter().any(|path| path.name == name) {
            let found = Found::Told(format!("\"{name}\", which is defined above"));
            return Err(said.error(place, "a new name of the path", found));
        }
        let mut keyframes: Vec<Keyframe> = Vec::new();
        for part in said.parts.iter().filter(|part| part.keyword == "at") {
            let keyframe = Keyframe { time: part.number(0), place: part.numbers(1) };
            if let Some(before) = keyframes.last().filter(|before| keyframe.time <= before.time) {
                let (word, place) = part.word(0);
                let expected = format!("a time of the path after {}", Short::nearest(before.time));
                return Err(said.error(place, expected, Found::token(word)));
            }
            keyframes.push(keyframe);
        }
        if keyframes.len() < 2 {
            let found = Found::Told("the end of the path".into());
            return Err(said.error(said.end, "a second \"at\" of the path", found));
        }
        let linear = said.has("linear");
        self.scene.details.paths.push(Path { name: name.into(), linear, keyframes });
        Ok(())
    }

    /// Returns the name of the path that something goes along, if it does.
    pub(super) fn along(&self, said: &Said<'a>) -> Result<Option<String>, SceneError> {
        said.part("along").map(|part| self.known_path(said, part)).transpose()
    }

    fn known_path(&self, said: &Said<'a>, part: &Given<'a>) -> Result<String, SceneError> {
        let (name, place) = part.word(0);
        let mut known = self.scene.details.paths.iter().map(|path| path.name.as_str());
        if known.clone().any(|other| other == name) {
            return Ok(name.into());
        }
        Err(said.error(place, A_PATH, super::nearest::found(name, &mut known)))
    }
}
