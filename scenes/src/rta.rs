//! The scene language of rta, `.rta`: one thing a line, words and numbers.
//!
//! ```text
//! rta 1                                        # a first scene
//! camera at 0 -8 2  look 0 1 -.1  lens 1.2
//! sky horizon .8 .87 .97  zenith .15 .3 .65
//! floor .9 .9 .9  .1 .1 .1
//! lamp at -5 -6 8  power 75
//! ambient grey .25
//! sphere at 0 0 1  radius 1  color .9 .2 .1  of shiny
//! sphere at 2 1 1  radius 1  of crown
//! ```
//!
//! A line that begins with white space goes on with the line before, and `#` begins a comment. Values without a keyword come first,
//! then the keywords in any order, each once; what belongs to a keyword stays behind its values. A name is defined above its use.
//!
//! One table of statements reads the language, writes it ([`Description::to_rta`]) and documents it ([`help`]).

use std::collections::{BTreeMap, HashMap};

use crate::description::{Camera, Description, Material};
use crate::error::{Found, SceneError};
use crate::tokens::{Token, Tokens};
use crate::warning::Tally;

mod builtin;
mod document;
mod lamp;
mod line;
mod material;
mod models;
mod names;
mod nearest;
mod object;
mod path;
mod quad;
mod said;
mod statements;
mod table;
#[cfg(test)]
mod tests;
mod texture;
mod view;
mod write;

pub use document::help;

pub use builtin::material as built_in;
use line::Line;
use said::{Said, error};

/// The words that a file begins with.
const HEADER: [&str; 2] = ["rta", "1"];

/// Reads a scene. `file` is the file's name, for the errors.
///
/// Time and memory grow with what the file holds.
///
/// # Errors
/// The first thing that is not as the language has it, with what was expected there and the nearest known name.
pub fn read(text: &[u8], file: &str) -> Result<Description, SceneError> {
    let mut tokens = Tokens::new(text, file)?.with_quotes();
    let mut reader = Reader {
        file,
        scene: Description::empty(Camera::upright([0.0; 3], [0.0, 1.0, 0.0], 1.0)),
        once: Vec::new(),
        angle: None,
        defined: HashMap::new(),
        used: HashMap::new(),
        tallies: BTreeMap::new(),
    };
    let header = reader.header(&mut tokens)?;
    let (mut statement, mut last_line): (Vec<Token<'_>>, u32) = (Vec::new(), header);
    while let Some(token) = tokens.next() {
        let is_first = token.line != last_line;
        last_line = token.line;
        if is_first && token.column == 1 {
            reader.statement(core::mem::take(&mut statement))?;
        } else if statement.is_empty() {
            return Err(reader.continued(token.line));
        }
        statement.push(token);
    }
    reader.statement(statement)?;
    reader.end(tokens.place())
}

/// What the file has said so far.
struct Reader<'a> {
    file: &'a str,
    scene: Description,
    /// The statements that a scene has once, as far as they were there, and their lines.
    once: Vec<(&'static str, u32)>,
    /// Angle of view, where the camera has no lens, in degrees.
    angle: Option<f64>,
    /// Materials that were defined.
    defined: HashMap<&'a str, Material>,
    /// Materials that were referred to, by their numbers in the scene.
    used: HashMap<&'a str, u16>,
    /// Warnings, by what they are about.
    tallies: BTreeMap<&'static str, Tally>,
}

impl<'a> Reader<'a> {
    /// Reads the words that a file begins with, and returns their line.
    fn header(&self, tokens: &mut Tokens<'a>) -> Result<u32, SceneError> {
        let [rta, one] = HEADER;
        let expected = || format!("\"{rta} {one}\"");
        let Some(first) = tokens.next() else {
            return Err(error(self.file, (1, 1), expected(), Found::EmptyFile));
        };
        if first.column != 1 {
            return Err(self.continued(first.line));
        }
        let place = (first.line, first.column);
        if first.text != rta {
            return Err(error(self.file, place, expected(), Found::word(first.text)));
        }
        let version = tokens.next().filter(|token| token.line == first.line);
        if version.is_none_or(|version| version.text != one) {
            let version = version.map_or(String::new(), |version| format!(" {}", Found::show(version.text)));
            return Err(error(self.file, place, expected(), Found::Told(format!("\"{rta}{version}\""))));
        }
        match tokens.peek().filter(|token| token.line == first.line) {
            None => Ok(first.line),
            Some(more) => {
                let expected = format!("the end of the line after \"{rta} {one}\"");
                Err(error(self.file, (more.line, more.column), expected, Found::word(more.text)))
            }
        }
    }

    /// The error about a line that goes on from nothing.
    fn continued(&self, line: u32) -> SceneError {
        let found = "a continuation (a line that begins with white space) with nothing before it";
        error(self.file, (line, 1), "a statement", Found::Told(found.into()))
    }

    /// Reads one statement.
    fn statement(&mut self, tokens: Vec<Token<'a>>) -> Result<(), SceneError> {
        let Some(first) = tokens.first() else { return Ok(()) };
        let (line, place) = (first.line, (first.line, first.column));
        let Some(statement) = statements::all().find(|statement| statement.keyword == first.text) else {
            let keywords = statements::all().map(|statement| statement.keyword);
            return Err(error(self.file, place, "a statement", nearest::found(first.text, keywords)));
        };
        if statement.once {
            if let Some((_, before)) = self.once.iter().find(|(keyword, _)| *keyword == statement.keyword) {
                let found = format!("a second (the first is in line {before})");
                let expected = format!("one \"{}\"", statement.keyword);
                return Err(error(self.file, place, expected, Found::Told(found)));
            }
            self.once.push((statement.keyword, line));
        }
        let said = Line { file: self.file, tokens, next: 0 }.read(statement)?;
        self.understand(&said)
    }

    fn understand(&mut self, said: &Said<'a>) -> Result<(), SceneError> {
        match said.statement.keyword {
            "camera" => self.camera(said),
            "picture" => self.picture(said),
            "model" => self.model(said),
            "attenuation" => self.attenuation(said),
            "medium" => self.medium(said),
            "spectral" => self.spectral(said),
            "sky" => self.sky(said),
            "ambient" => {
                self.scene.ambient = said.triple("").unwrap_or_default();
                Ok(())
            }
            "floor" => self.floor(said),
            "lamp" => self.lamp(said),
            "texture" => self.texture(said),
            "material" => self.material(said),
            "path" => self.path(said),
            _ => self.object(said),
        }
    }

    /// Counts a warning, of which the first of its kind is told.
    fn warn(&mut self, kind: &'static str, line: u32, text: impl FnOnce() -> String) {
        self.tallies.entry(kind).or_default().count(line, text);
    }

    /// Counts a thing that is read and kept, and that nothing draws yet.
    fn undrawn(&mut self, what: &'static str, line: u32) {
        self.warn(what, line, || format!("{what}: read and kept, but not drawn yet"));
    }

    fn end(mut self, place: (u32, u32)) -> Result<Description, SceneError> {
        if !self.once.iter().any(|(keyword, _)| *keyword == "camera") {
            return Err(error(self.file, place, "a camera", Found::Told("the end of the file".into())));
        }
        self.widen();
        lamp::place_distant(&mut self.scene);
        let told = core::mem::take(&mut self.tallies).into_values().filter_map(Tally::told);
        self.scene.warnings.extend(told);
        self.scene.warnings.sort_by_key(|warning| warning.line);
        self.scene.look_over();
        Ok(self.scene)
    }
}
