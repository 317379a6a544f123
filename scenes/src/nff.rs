//! NFF, the Neutral File Format of Eric Haines's Standard Procedural Databases (1987).
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
//! - A sphere's negative radius is taken by its size. A cone is seen from the inside only if its radii are negative;
//!   one of them may be 0.
//! - Polygons are seen from both sides. They may be concave, or not quite flat; those without area are left out, as
//!   the triangles without area of others are. A normal of length 0 is the polygon's own.

use core::fmt::Display;

use crate::description::{Camera, Cone, Description, Lamp, Model, Side, Sky, Sphere, Surface, Triangle};
use crate::error::{Found, SceneError};
use crate::numbers::{AXES, Numbers, Range, Short};
use crate::space::{Triple, cross, difference, length, unit};
use crate::tokens::{Token, Tokens};

mod polygon;

/// Most corners that a polygon may have: the time to cut up a concave one grows with their square.
pub const MOST_CORNERS: u32 = 10_000;

/// How near the upward direction may come to that of view: the sine of the angle between them.
const UPRIGHT: f64 = 1e-9;

/// Reads a scene. `file` is the file's name, for the errors.
///
/// Time and memory grow with what the file holds, never with what it promises.
///
/// # Errors
/// The first thing that is not as the format has it: an empty or binary file, an entity that is not known, a number
/// that is missing, malformed, not finite or out of its range, an object before the first fill, a file without a
/// viewpoint or with two.
pub fn read(text: &[u8], file: &str) -> Result<Description, SceneError> {
    let mut reader = Reader {
        tokens: Tokens::new(text, file)?,
        viewpoint: None,
        fill: None,
        lights: Vec::new(),
        polygons: 0,
        scene: Description::empty(Camera::upright([0.0; 3], [0.0, 1.0, 0.0], 1.0)),
    };
    if reader.tokens.clone().next().is_none() {
        return Err(reader.tokens.error(1, 1, "a scene with a viewpoint (v)".into(), Found::EmptyFile));
    }
    while let Some(entity) = reader.tokens.next() {
        reader.entity(entity)?;
    }
    reader.end()
}

/// The entity `v`.
struct Viewpoint {
    camera: Camera,
    raster: [u32; 2],
    line: u32,
}

/// The entity `f`.
#[derive(Clone, Copy)]
struct Fill {
    color: [f64; 3],
    surface: Surface,
}

/// The entity `l`.
struct Light {
    position: [f64; 3],
    color: Option<[f64; 3]>,
    line: u32,
}

/// The file, and what it has said so far.
struct Reader<'a> {
    tokens: Tokens<'a>,
    viewpoint: Option<Viewpoint>,
    fill: Option<Fill>,
    lights: Vec<Light>,
    /// Polygons that were read, for the errors: the scene holds triangles.
    polygons: usize,
    scene: Description,
}

impl Reader<'_> {
    fn entity(&mut self, entity: Token<'_>) -> Result<(), SceneError> {
        let line = entity.line;
        match entity.text {
            "v" => self.viewpoint(entity),
            "b" => {
                let color = self.tokens.color("the background")?;
                self.scene.sky = Sky { horizon: color, zenith: color };
                Ok(())
            }
            "l" => self.light(line),
            "f" => self.fill(),
            "s" => {
                let fill = self.filled(entity)?;
                self.sphere(fill, line)
            }
            "c" => {
                let fill = self.filled(entity)?;
                self.cone(fill, line)
            }
            "p" => {
                let fill = self.filled(entity)?;
                self.polygon(fill, line, false)
            }
            "pp" => {
                let fill = self.filled(entity)?;
                self.polygon(fill, line, true)
            }
            _ => {
                let expected = "an entity (one of v, b, l, f, s, c, p and pp) or the end of the file";
                Err(self.wrong(entity, expected.into()))
            }
        }
    }

    fn end(self) -> Result<Description, SceneError> {
        let Self { mut tokens, viewpoint, lights, mut scene, .. } = self;
        let Some(Viewpoint { camera, raster, .. }) = viewpoint else {
            let (line, column) = tokens.place();
            return Err(tokens.error(line, column, "a viewpoint (v)".into(), Found::EndOfFile));
        };
        #[expect(clippy::cast_precision_loss, reason = "no file has 2^53 lights")]
        let share = 1.0 / (lights.len().max(1) as f64).sqrt();
        let lamp = |Light { position, color, line }| {
            let color = color.unwrap_or([share; 3]);
            Lamp { position, color, radius: 0.0, line }
        };
        scene.lamps = lights.into_iter().map(lamp).collect();
        // Lists of unknown length have grown to up to twice of it.
        scene.spheres.shrink_to_fit();
        scene.cones.shrink_to_fit();
        scene.triangles.shrink_to_fit();
        Ok(Description { camera, raster: Some(raster), model: Model::Phong, ..scene })
    }

    fn viewpoint(&mut self, entity: Token<'_>) -> Result<(), SceneError> {
        if let Some(Viewpoint { line, .. }) = self.viewpoint {
            return Err(self.wrong(entity, format!("no second viewpoint (the first is in line {line})")));
        }
        self.word("from")?;
        let from = self.tokens.vector(AXES, "from", Range::Any)?;
        self.word("at")?;
        let place = self.tokens.place();
        let at = self.tokens.vector(AXES, "at", Range::Any)?;
        let view = difference(at, from);
        let Some(forward) = unit(view) else {
            return Err(self.vector_error(place, "at (another place than from)", at));
        };
        self.word("up")?;
        let place = self.tokens.place();
        let up = self.tokens.vector(AXES, "up", Range::Any)?;
        if unit(up).is_none_or(|up| length(cross(forward, up)) < UPRIGHT) {
            return Err(self.vector_error(place, "up (a direction that is not along the view)", up));
        }
        self.word("angle")?;
        let (line, column) = self.tokens.place();
        let angle = self.tokens.number("the angle", Range::Angle)?;
        self.word("hither")?;
        self.tokens.number("hither", Range::Any)?;
        self.word("resolution")?;
        let width = self.tokens.whole("the pixels of a row (a whole number > 0)", 1, u32::MAX)?;
        let height = self.tokens.whole("the number of rows (a whole number > 0)", 1, u32::MAX)?;
        // The angle leaves out half a row above and half a row below.
        let rows = f64::from(height.max(2));
        let whole = if height > 1 { rows / (rows - 1.0) } else { 1.0 };
        let focal = 0.5 / ((angle.to_radians() / 2.0).tan() * whole);
        if !focal.is_finite() {
            let found = Found::Number(Numbers(&[angle]).to_string());
            return Err(self.tokens.error(
                line,
                column,
                "an angle that is not next to nothing".into(),
                found,
            ));
        }
        let camera = Camera { eye: from, view, focal, side: Side::Height, up: Some(up) };
        self.viewpoint = Some(Viewpoint { camera, raster: [width, height], line: entity.line });
        Ok(())
    }

    fn light(&mut self, line: u32) -> Result<(), SceneError> {
        let which = self.lights.len() + 1;
        let position = self.tokens.vector(AXES, format_args!("light {which}"), Range::Any)?;
        let color = match self.tokens.clone().next() {
            Some(next) if next.is_like_a_number() => {
                Some(self.tokens.color(format_args!("the colour of light {which}"))?)
            }
            _ => None,
        };
        self.lights.push(Light { position, color, line });
        Ok(())
    }

    fn fill(&mut self) -> Result<(), SceneError> {
        let color = self.tokens.color("the fill")?;
        let kd = self.tokens.number("the Kd of the fill", Range::NotNegative)?;
        let ks = self.tokens.number("the Ks of the fill", Range::NotNegative)?;
        let exponent = self.tokens.number("the Shine of the fill", Range::NotNegative)?;
        let kt = self.tokens.number("the T of the fill", Range::NotNegative)?;
        let range = if kt > 0.0 { Range::NotNegative } else { Range::Any };
        let ior = self.tokens.number("the index of refraction of the fill", range)?;
        let ior = if ior > 0.0 { ior } else { 1.0 };
        self.fill = Some(Fill { color, surface: Surface::Finish { kd, ks, exponent, kt, ior } });
        Ok(())
    }

    fn sphere(&mut self, Fill { color, surface }: Fill, line: u32) -> Result<(), SceneError> {
        let which = self.scene.spheres.len() + 1;
        let position = self.tokens.vector(AXES, format_args!("the centre of sphere {which}"), Range::Any)?;
        let radius = self.tokens.number(format_args!("the radius of sphere {which}"), Range::NotZero)?.abs();
        self.scene.spheres.push(Sphere { position, color, radius, surface, line });
        Ok(())
    }

    fn cone(&mut self, Fill { color, surface }: Fill, line: u32) -> Result<(), SceneError> {
        let which = self.scene.cones.len() + 1;
        let base = self.tokens.vector(AXES, format_args!("the base of cone {which}"), Range::Any)?;
        let base_radius = self.tokens.number(format_args!("the base radius of cone {which}"), Range::Any)?;
        let place = self.tokens.place();
        let apex = self.tokens.vector(AXES, format_args!("the apex of cone {which}"), Range::Any)?;
        if apex == base {
            return Err(self.vector_error(
                place,
                format_args!("the apex of cone {which} (not its base)"),
                apex,
            ));
        }
        let (line_of_radius, column) = self.tokens.place();
        let apex_radius = self.tokens.number(format_args!("the apex radius of cone {which}"), Range::Any)?;
        let range = match base_radius {
            base if base > 0.0 => Range::NotNegative,
            base if base < 0.0 => Range::NotPositive,
            _ => Range::NotZero,
        };
        if !range.holds(apex_radius) {
            let expected = format!("the apex radius of cone {which} ({range} like the base radius)");
            let [apex, base] = [apex_radius, base_radius].map(Short::nearest);
            let found = Found::Number(format!("{apex} (the base radius is {base})"));
            return Err(self.tokens.error(line_of_radius, column, expected, found));
        }
        self.scene.cones.push(Cone {
            base,
            base_radius: base_radius.abs(),
            apex,
            apex_radius: apex_radius.abs(),
            capped: false,
            inside_only: base_radius < 0.0 || apex_radius < 0.0,
            color,
            surface,
            line,
        });
        Ok(())
    }

    fn polygon(&mut self, fill: Fill, line: u32, with_normals: bool) -> Result<(), SceneError> {
        let Fill { color, surface } = fill;
        self.polygons += 1;
        let which = format!("polygon {}", self.polygons);
        let expected =
            format_args!("the number of corners of {which} (a whole number from 3 to {MOST_CORNERS})");
        let count = self.tokens.whole(expected, 3, MOST_CORNERS)?;
        let (mut corners, mut normals): (Vec<Triple>, Vec<Triple>) = (Vec::new(), Vec::new());
        for number in 1..=count {
            corners.push(self.tokens.vector(AXES, format_args!("corner {number} of {which}"), Range::Any)?);
            if with_normals {
                let normal = format_args!("the normal of corner {number} of {which}");
                normals.push(self.tokens.vector(AXES, normal, Range::Any)?);
            }
        }
        let Some(polygon::Cut { normal, triangles }) = polygon::cut(&corners) else { return Ok(()) };
        for triangle in triangles {
            let vertices = triangle.map(|corner| corners.get(corner).copied().unwrap_or_default());
            let given = |corner| normals.get(corner).filter(|normal| **normal != [0.0; 3]);
            let normals = with_normals.then(|| triangle.map(|corner| *given(corner).unwrap_or(&normal)));
            self.scene.triangles.push(Triangle { vertices, normals, color, surface, line });
        }
        Ok(())
    }

    /// The fill that holds for an object.
    fn filled(&self, entity: Token<'_>) -> Result<Fill, SceneError> {
        self.fill.ok_or_else(|| self.wrong(entity, "a fill (f) before the first object".into()))
    }

    /// Goes past a word that must stand here.
    fn word(&mut self, word: &str) -> Result<(), SceneError> {
        let (line, column) = self.tokens.place();
        let found = match self.tokens.next() {
            Some(token) if token.text == word => return Ok(()),
            Some(token) => Found::word(token.text),
            None => Found::EndOfFile,
        };
        Err(self.tokens.error(line, column, format!("the word \"{word}\" of the viewpoint"), found))
    }

    /// An error about a piece that is no number.
    fn wrong(&self, token: Token<'_>, expected: String) -> SceneError {
        self.tokens.error(token.line, token.column, expected, Found::word(token.text))
    }

    /// An error about three numbers together.
    fn vector_error(&self, (line, column): (u32, u32), expected: impl Display, found: Triple) -> SceneError {
        self.tokens.error(line, column, expected.to_string(), Found::Number(Numbers(&found).to_string()))
    }
}

#[cfg(test)]
mod tests;
