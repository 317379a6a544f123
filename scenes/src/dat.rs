//! The thesis's scene file: numbers separated by white space, in a fixed order, with `#` comments.
//!
//! ```text
//! observer position            x y z
//! direction of view            x y z          not zero
//! focal distance               f              > 0
//! number of cylinders          n
//!   each: position x y z  colour r g b  radius r          type
//! number of ellipsoids         n
//!   each: position x y z  colour r g b  radii rx ry rz    type
//! number of spheres            n
//!   each: position x y z  colour r g b  radius r          type
//! number of lamps              n
//!   each: position x y z  colour r g b  radius r          may be 0
//! first floor colour           r g b
//! second floor colour          r g b
//! ambient light                r g b
//! colour of the horizon        r g b
//! colour of the zenith         r g b
//! ```
//!
//! A type is 0 (opaque), 1 (shiny), 2 (mirror) or 3 (transparent), and 3 is followed by ks, kt and the index of
//! refraction. Where the thesis gives a type to some primitives only, every primitive here may have any. Numbers
//! are decimal and finite; counts and types are written without point or exponent; colours are not negative.

use core::fmt::{self, Display};

use crate::description::{
    Camera, Cylinder, Description, Ellipsoid, FallOff, Floor, Lamp, Sky, Sphere, Surface,
};
use crate::error::{Entry, Found, SceneError};
use crate::numbers::{AXES, Numbers, Range, Short};
use crate::tokens::Tokens;
use crate::warning::Tally;

mod write;

/// Most objects of one kind that a file may hold: the tracer numbers them with 16 bits.
pub const MOST_OBJECTS: u16 = u16::MAX;

/// How far ks + kt may be from 1.
pub const SHARES_TOLERANCE: f64 = 1e-6;

/// The floor's colours may be a little above 1 on purpose, as in the Juggler, whose lamps are far away.
const BRIGHT_FLOOR: f64 = 2.0;

/// Reads a scene. `name` is the file's, for the errors.
///
/// Memory grows with what the file holds, never with what its counts promise.
///
/// # Errors
/// The first thing that is not as the format has it: an empty or binary file, a number that is missing, malformed,
/// not finite or out of its range, more than [`MOST_OBJECTS`] of a kind, or anything after the end of the scene.
pub fn read(text: &[u8], name: &str) -> Result<Description, SceneError> {
    let mut reader = Reader {
        tokens: Tokens::new(text, name)?,
        entry: None,
        breaks: false,
        astray: None,
        bright: Tally::default(),
    };
    if reader.tokens.peek().is_none() {
        let expected = "a scene, which begins with the observer position".into();
        return Err(reader.tokens.error((1, 1), expected, Found::EmptyFile));
    }
    reader.scene().map_err(|error| reader.explained(error))
}

/// The pieces of the file, read as what the format wants next.
struct Reader<'a> {
    tokens: Tokens<'a>,
    /// The object that is being read, if it begins a line, and the text from there on.
    entry: Option<(Entry, Tokens<'a>)>,
    /// Whether an object before has taken several lines.
    breaks: bool,
    /// What is to be said of the first object that ends amid a line: that another one before it was too short, or too long.
    astray: Option<String>,
    /// Colours above 1.
    bright: Tally,
}

impl Reader<'_> {
    /// The whole file.
    fn scene(&mut self) -> Result<Description, SceneError> {
        let camera = self.camera()?;
        let cylinders = self.list("cylinder", 8, |reader, which| {
            let (line, position, color) = reader.place_and_color(which)?;
            let radius = reader.tokens.number(format_args!("the radius of {which}"), Range::Positive)?;
            let surface = reader.surface(which)?;
            Ok(Cylinder { position, color, radius, surface, line })
        })?;
        let ellipsoids = self.list("ellipsoid", 10, |reader, which| {
            let (line, position, color) = reader.place_and_color(which)?;
            let radii = reader.tokens.vector(["x radius", "y radius", "z radius"], which, Range::Positive)?;
            let surface = reader.surface(which)?;
            Ok(Ellipsoid { position, color, radii, inside_only: false, surface, line })
        })?;
        let spheres = self.list("sphere", 8, |reader, which| {
            let (line, position, color) = reader.place_and_color(which)?;
            let radius = reader.tokens.number(format_args!("the radius of {which}"), Range::Positive)?;
            let surface = reader.surface(which)?;
            Ok(Sphere { position, color, radius, surface, line })
        })?;
        let lamps = self.list("lamp", 7, |reader, which| {
            let (line, position) = reader.place_of(which)?;
            let color = reader.tokens.color(format_args!("the colour of {which}"))?;
            let radius = reader.tokens.number(format_args!("the radius of {which}"), Range::NotNegative)?;
            Ok(Lamp { position, color, radius, fall_off: FallOff::OfModel, line })
        })?;
        let floor = Some(Floor {
            colors: [
                self.reflectance("the first floor colour", BRIGHT_FLOOR)?,
                self.reflectance("the second floor colour", BRIGHT_FLOOR)?,
            ],
            surface: Surface::Opaque,
        });
        let ambient = self.tokens.color("the ambient light")?;
        let sky = Sky {
            horizon: self.tokens.color("the colour of the horizon")?,
            zenith: self.tokens.color("the colour of the zenith")?,
        };
        self.end()?;
        let mut scene = Description {
            cylinders,
            ellipsoids,
            spheres,
            lamps,
            floor,
            ambient,
            sky,
            ..Description::empty(camera)
        };
        scene.warnings.extend(core::mem::take(&mut self.bright).told());
        scene.look_over();
        Ok(scene)
    }

    fn camera(&mut self) -> Result<Camera, SceneError> {
        let eye = self.tokens.vector(AXES, "the observer position", Range::Any)?;
        let place = self.tokens.place();
        let view = self.tokens.vector(AXES, "the direction of view", Range::Any)?;
        if view.iter().all(|part| *part == 0.0) {
            let found = Found::Number(Numbers(&view).to_string());
            return Err(self.tokens.error(place, "the direction of view (not zero)".into(), found));
        }
        let focal = self.tokens.number("the focal distance", Range::Positive)?;
        Ok(Camera::upright(eye, view, focal))
    }

    /// A count, then that many of `kind`. What is read knows itself as "sphere 3 of 70".
    fn list<T>(
        &mut self,
        kind: &'static str,
        numbers: usize,
        each: impl Fn(&mut Self, fmt::Arguments<'_>) -> Result<T, SceneError>,
    ) -> Result<Vec<T>, SceneError> {
        let most = u32::from(MOST_OBJECTS);
        let count = self.tokens.whole(
            format_args!("the number of {kind}s (a whole number from 0 to {most})"),
            0,
            most,
        )?;
        let mut objects = Vec::new();
        for index in 1..=count {
            let is_amid_line = self.tokens.is_amid_line();
            let entry = Entry { kind, line: self.tokens.place().0, begin: self.tokens.read().0, numbers };
            self.entry = (!is_amid_line).then(|| (entry, self.tokens.clone()));
            objects.push(each(self, format_args!("{kind} {index} of {count}"))?);
            self.note_end();
        }
        Ok(objects)
    }

    /// Looks whether an object that begins a line ends one: else it, or the line, is too short.
    fn note_end(&mut self) {
        let Some((entry, _)) = &self.entry else { return };
        let (read, before) = self.tokens.read();
        if !self.tokens.is_amid_line() {
            self.breaks |= before > entry.begin;
        } else if self.astray.is_none() {
            let taken = read.saturating_sub(entry.begin);
            let long =
                || format!("in line {} more numbers follow the {taken} of the {}", entry.line, entry.kind);
            self.astray = Some(self.short(taken).unwrap_or_else(long));
        }
        self.entry = None;
    }

    /// Returns the note that the object which is being read is too short, if it has few numbers in its line, or in its lines
    /// but for the last where other objects have several. It has taken `taken` numbers.
    fn short(&self, taken: usize) -> Option<String> {
        let (entry, text) = self.entry.as_ref()?;
        let had = if self.breaks {
            self.tokens.read().1.saturating_sub(entry.begin)
        } else {
            let mut text = text.clone();
            core::iter::from_fn(|| text.next()).take_while(|token| token.line == entry.line).count()
        };
        // Those of glass are more.
        let numbers = if had < entry.numbers { entry.numbers } else { taken };
        let entry = Entry { numbers, ..entry.clone() };
        (1..numbers).contains(&had).then(|| entry.is_short(had))
    }

    /// Returns an error with a note, where numbers that are missing or too many may be the cause: they were taken from the
    /// next object, so that the error is found later.
    fn explained(&self, error: SceneError) -> SceneError {
        let current = || {
            let (entry, _) = self.entry.as_ref()?;
            let had = self.tokens.read().0.saturating_sub(entry.begin);
            let is_cut = error.found == Found::EndOfFile && (1..entry.numbers).contains(&had);
            if is_cut { Some(entry.is_short(had)) } else { self.short(had) }
        };
        let note = self.astray.clone().or_else(current);
        error.with_note(|| note)
    }

    /// A colour that says what part of the light comes back, so that more than 1 is seldom meant: above `most` there is a warning.
    fn reflectance(&mut self, what: impl Display, most: f64) -> Result<[f64; 3], SceneError> {
        let (line, _) = self.tokens.place();
        let color = self.tokens.color(&what)?;
        if let Some(above) = color.into_iter().find(|register| *register > most) {
            let above = Numbers(&[above]).to_string();
            let text = || format!("{what} has a register of {above}: colours go from 0 to 1");
            self.bright.count(line, text);
        }
        Ok(color)
    }

    /// The line where an object begins, its position and its colour.
    fn place_and_color(
        &mut self,
        which: impl Display + Copy,
    ) -> Result<(u32, [f64; 3], [f64; 3]), SceneError> {
        let (line, position) = self.place_of(which)?;
        Ok((line, position, self.reflectance(format_args!("the colour of {which}"), 1.0)?))
    }

    /// The line where an object begins, and its position.
    fn place_of(&mut self, which: impl Display) -> Result<(u32, [f64; 3]), SceneError> {
        let (line, _) = self.tokens.place();
        Ok((line, self.tokens.vector(AXES, format_args!("the position of {which}"), Range::Any)?))
    }

    fn surface(&mut self, which: impl Display) -> Result<Surface, SceneError> {
        match self.tokens.whole(format_args!("the type of {which} (0, 1, 2 or 3)"), 0, 3)? {
            0 => Ok(Surface::Opaque),
            1 => Ok(Surface::Shiny),
            2 => Ok(Surface::Mirror),
            _ => {
                let ks = self.tokens.number(format_args!("the ks of {which}"), Range::Share)?;
                let place = self.tokens.place();
                let kt = self.tokens.number(format_args!("the kt of {which}"), Range::Share)?;
                // The sum itself is rounded, by far less than 1e-15.
                if (ks + kt - 1.0).abs() > SHARES_TOLERANCE + 1e-15 {
                    let expected = format!("the kt of {which} (ks + kt = 1 within {SHARES_TOLERANCE:e})");
                    let found =
                        Found::Number(format!("ks + kt = {} + {}", Short::nearest(ks), Short::nearest(kt)));
                    return Err(self.tokens.error(place, expected, found));
                }
                let ior = self
                    .tokens
                    .number(format_args!("the index of refraction of {which}"), Range::Positive)?;
                Ok(Surface::Transparent { ks, kt, ior })
            }
        }
    }

    /// Nothing may follow the scene.
    fn end(&mut self) -> Result<(), SceneError> {
        match self.tokens.next() {
            None => Ok(()),
            Some(token) => {
                let expected = "the end of the file after the colour of the zenith".into();
                Err(self.tokens.error((token.line, token.column), expected, Found::token(token.text)))
            }
        }
    }
}

#[cfg(test)]
mod tests;
