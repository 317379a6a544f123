//! NFF, the Neutral File Format of Eric Haines's Standard Procedural Databases (1987), and what others have added to it.
//!
//! Entities in any order, pieces separated by white space of any kind, with `#` comments:
//!
//! ```text
//! v  from x y z  at x y z  up x y z  angle a  hither h  resolution w h      once
//! b  r g b                                        background; black without it, the last one holds
//! l  x y z [r g b]                                light; 1/sqrt(number of lights) without a colour
//! f  r g b  Kd Ks Shine T ior                     fill of all that follows
//! s  x y z  r                                     sphere
//! c  x y z r  x y z r                             cone or cylinder from base to apex, without caps
//! p  n  n times: x y z                            polygon
//! pp n  n times: x y z  nx ny nz                  polygon with normals at its corners
//! ```
//!
//! What the format leaves open, and how it is read here:
//!
//! - The angle is between the centres of the first and the last row of pixels, so the picture is a little taller.
//!   `hither` is read and not used: nothing is clipped.
//! - Lights are points, are not attenuated, and may be brighter than 1. There is no ambient light.
//! - With T = 0 an index of refraction that makes no sense is 1, as 0 is with any T.
//! - Objects before the first fill are white and diffuse, with a warning.
//! - A sphere or cone is seen from the inside only if its radius is negative; one of a cone's may be 0.
//! - Polygons are seen from both sides, unless the reader is told otherwise ([`Reading::one_sided`]): many files do not care
//!   for the order of corners, and what is closed looks the same. They may be concave, or not quite flat, and cross
//!   themselves: what the outline winds around is shown. Those without area are left out, with a warning. A normal of
//!   length 0 is the polygon's own.
//!
//! What is read besides, as it stands in files that people have:
//!
//! ```text
//! fp r g b  Kd Ks Shine T ior                     f, for smooth shading
//! f  r g b  hr hg hb  Kd Ks Shine T ior           the fill of P3F; the highlight's colour hr hg hb is not used
//! pl x y z  x y z  x y z                          infinite plane through three points (P3F)
//! box x y z  x y z                                box between two corners
//! k  r g b                                        ambient light (BART)
//! L  r g b power [atten a b c]                    area light: the polygons up to L 0 0 0 0 shine
//! bclr r g b                                      b (P3F)
//! ```
//!
//! - Entities may be in upper case, but for `L` with four numbers.
//! - An area light is, until there are area lights, a point in the middle of each of its polygons, which is not seen. What
//!   its polygons share by their areas is `power`, divided by `a + b d + c d^2` with the distance d to the place `at`: since
//!   no light is attenuated, it is everywhere as bright as it should be there.
//! - Passed over, each with a warning: the name of a texture after a fill; `tess`, `spp`, `aperture` and whatever line
//!   begins with an unknown letter and has nothing but numbers, or is nothing but words. `accel` and `focal` of P3F change
//!   nothing and are passed over silently. Other unknown lines are errors, unless the reader is
//!   [lenient](Reading::lenient).

use crate::description::{Camera, Description, FallOff, Lamp, Model, Sky, Surface};
use crate::error::{Entry, Found, SceneError};
use crate::reading::Reading;
use crate::space::Triple;
use crate::tokens::{Token, Tokens};
use crate::warning::{Tally, Warning};

mod foreign;
mod light;
mod object;
mod view;

pub use crate::polygon::MOST_CORNERS;

use light::{Area, Light};
use view::Viewpoint;

/// Reads a scene as strictly as the format has it. `file` is the file's name, for the errors.
///
/// Time and memory grow with what the file holds, never with what it promises.
///
/// # Errors
/// The first thing that is not as the format has it: an empty or binary file, an entity that is not known, a number
/// that is missing, malformed, not finite or out of its range, a file without a viewpoint or with two.
pub fn read(text: &[u8], file: &str) -> Result<Description, SceneError> {
    read_with(text, file, Reading::default())
}

/// Reads a scene as `reading` says.
///
/// # Errors
/// Those of [`read`].
pub fn read_with(text: &[u8], file: &str, reading: Reading) -> Result<Description, SceneError> {
    let mut reader = Reader {
        tokens: Tokens::new(text, file)?,
        reading,
        viewpoint: None,
        fill: None,
        lights: Vec::new(),
        areas: Vec::new(),
        shines: false,
        entry: Entry { kind: "file", line: 1, begin: 0, numbers: 0 },
        polygons: 0,
        unknown: None,
        tallies: Tallies::default(),
        scene: Description::empty(Camera::upright([0.0; 3], [0.0, 1.0, 0.0], 1.0)),
    };
    let Some(first) = reader.tokens.peek() else {
        return Err(reader.tokens.error((1, 1), "a scene with a viewpoint (v)".into(), Found::EmptyFile));
    };
    reader.refuse_other_format(first)?;
    while let Some(entity) = reader.tokens.next() {
        if let Err(error) = reader.entity(entity) {
            return Err(reader.explained(error));
        }
    }
    reader.end()
}

/// The words with which lines begin that are known.
const ENTITIES: [&str; 18] = [
    "v", "b", "l", "f", "fp", "s", "c", "p", "pp", "box", "k", "bclr", "tess", "accel", "spp", "aperture",
    "focal", "pl",
];

/// The entity `f`.
#[derive(Clone, Copy)]
struct Fill {
    color: Triple,
    surface: Surface,
}

impl Fill {
    /// What objects have before the first fill.
    const DEFAULT: Self = Self {
        color: [1.0; 3],
        surface: Surface::Finish { kd: 1.0, ks: 0.0, exponent: 0.0, kt: 0.0, ior: 1.0 },
    };
}

/// The warnings that are counted, not repeated.
#[derive(Default)]
struct Tallies {
    highlights: Tally,
    flat: Tally,
    tangled: Tally,
    crossed: Tally,
}

/// The file, and what it has said so far.
struct Reader<'a> {
    tokens: Tokens<'a>,
    reading: Reading,
    viewpoint: Option<Viewpoint>,
    fill: Option<Fill>,
    lights: Vec<Light>,
    areas: Vec<Area>,
    /// Whether polygons are part of the last of the area lights.
    shines: bool,
    /// What is being read, or was last.
    entry: Entry,
    /// Polygons that were read, for the errors: the scene holds triangles.
    polygons: usize,
    /// The error that the first unknown line would have been.
    unknown: Option<SceneError>,
    tallies: Tallies,
    scene: Description,
}

impl Reader<'_> {
    fn entity(&mut self, entity: Token<'_>) -> Result<(), SceneError> {
        let (line, text) = (entity.line, entity.text);
        // How many numbers follow tells what is meant by a letter that others use otherwise.
        let has = |numbers| self.tokens.numbers_ahead(5) == numbers;
        let lower = text.to_ascii_lowercase();
        match lower.as_str() {
            "v" => self.viewpoint(entity),
            "b" | "bclr" if text != "B" || !has(0) => self.background(line),
            "l" if text == "L" && has(4) => self.area(line),
            "l" => self.light(line),
            "k" if has(3) => self.ambient(line),
            "f" | "fp" => self.fill(line),
            "s" => self.sphere(line),
            "c" => self.cone(line),
            "p" => self.polygon(line, false),
            "pp" => self.polygon(line, true),
            "pl" => self.plane(line),
            "box" => self.cuboid(line),
            _ => self.foreign(entity, &lower),
        }
    }

    /// Says what is being read: `numbers` of them follow.
    fn begin(&mut self, kind: &'static str, line: u32, numbers: usize) {
        self.entry = Entry { kind, line, begin: self.tokens.read().0, numbers };
    }

    /// Returns an error with a note, where too few or too many numbers may be the cause.
    fn explained(&self, error: SceneError) -> SceneError {
        let Entry { kind, line, begin, numbers } = self.entry;
        let read = self.tokens.read().0.saturating_sub(begin);
        // The piece that is wrong was read too, but at the end of the file there is none.
        let (had, may_be_short) = match error.found {
            Found::EndOfFile => (read, true),
            Found::NotANumber(_) => (read.saturating_sub(1), true),
            _ => (read.saturating_sub(1), false),
        };
        let is_long = matches!(error.found, Found::Number(_)) && had == numbers && numbers > 0;
        let note = || {
            if may_be_short && had < numbers {
                return Some(self.entry.is_short(had));
            }
            is_long
                .then(|| format!("the {kind} that begins in line {line} has {numbers} numbers and no more"))
        };
        error.with_note(note)
    }

    fn background(&mut self, line: u32) -> Result<(), SceneError> {
        self.begin("background", line, 3);
        let color = self.tokens.color("the background")?;
        self.scene.sky = Sky { horizon: color, zenith: color };
        Ok(())
    }

    fn ambient(&mut self, line: u32) -> Result<(), SceneError> {
        self.begin("ambient light", line, 3);
        self.scene.ambient = self.tokens.color("the ambient light")?;
        Ok(())
    }

    fn end(self) -> Result<Description, SceneError> {
        let Self { mut tokens, viewpoint, lights, areas, mut scene, unknown, tallies, .. } = self;
        let Some(Viewpoint { camera, at, raster, .. }) = viewpoint else {
            let place = tokens.place();
            let missing = tokens.error(place, "a viewpoint (v)".into(), Found::EndOfFile);
            return Err(unknown.unwrap_or(missing));
        };
        #[expect(clippy::cast_precision_loss, reason = "no file has 2^53 lights")]
        let share = 1.0 / (lights.len().max(1) as f64).sqrt();
        let lamp = |light: Light| {
            let color = light.color(share, &areas, at);
            Lamp {
                position: light.position,
                color,
                radius: 0.0,
                fall_off: FallOff::Constant,
                line: light.line,
            }
        };
        scene.lamps = lights.into_iter().map(lamp).collect();
        // Lists of unknown length have grown to up to twice of it.
        scene.spheres.shrink_to_fit();
        scene.ellipsoids.shrink_to_fit();
        scene.cones.shrink_to_fit();
        scene.triangles.shrink_to_fit();
        let Tallies { highlights, flat, tangled, crossed } = tallies;
        let told = [highlights, flat, tangled, crossed].into_iter().filter_map(Tally::told);
        scene.warnings.extend(told);
        let mut scene = Description { camera, raster: Some(raster), model: Model::Phong, ..scene };
        scene.look_over();
        Ok(scene)
    }

    /// Adds a warning.
    fn warn(&mut self, line: u32, text: impl Into<String>) {
        self.scene.warnings.push(Warning { line, text: text.into() });
    }

    /// An error about a piece that is no number.
    fn wrong(&self, token: Token<'_>, expected: String) -> SceneError {
        self.tokens.error((token.line, token.column), expected, Found::word(token.text))
    }
}

#[cfg(test)]
mod tests;
