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

use core::fmt::{self, Display, Write};

use crate::description::{Camera, Cylinder, Description, Ellipsoid, Floor, Lamp, Sky, Sphere, Surface};
use crate::error::{Found, SceneError};
use crate::numbers::{AXES, Numbers, Range, Short};
use crate::tokens::Tokens;

/// Most objects of one kind that a file may hold: the tracer numbers them with 16 bits.
pub const MOST_OBJECTS: u16 = u16::MAX;

/// How far ks + kt may be from 1.
pub const SHARES_TOLERANCE: f64 = 1e-6;

/// Reads a scene. `name` is the file's, for the errors.
///
/// Memory grows with what the file holds, never with what its counts promise.
///
/// # Errors
/// The first thing that is not as the format has it: an empty or binary file, a number that is missing, malformed,
/// not finite or out of its range, more than [`MOST_OBJECTS`] of a kind, or anything after the end of the scene.
pub fn read(text: &[u8], name: &str) -> Result<Description, SceneError> {
    let mut reader = Reader(Tokens::new(text, name)?);
    if reader.0.clone().next().is_none() {
        let expected = "a scene, which begins with the observer position".into();
        return Err(reader.0.error(1, 1, expected, Found::EmptyFile));
    }
    let camera = reader.camera()?;
    let cylinders = reader.list("cylinder", |reader, which| {
        let (line, position, color) = reader.place_and_color(which)?;
        let radius = reader.0.number(format_args!("the radius of {which}"), Range::Positive)?;
        let surface = reader.surface(which)?;
        Ok(Cylinder { position, color, radius, surface, line })
    })?;
    let ellipsoids = reader.list("ellipsoid", |reader, which| {
        let (line, position, color) = reader.place_and_color(which)?;
        let radii = reader.0.vector(["x radius", "y radius", "z radius"], which, Range::Positive)?;
        let surface = reader.surface(which)?;
        Ok(Ellipsoid { position, color, radii, surface, line })
    })?;
    let spheres = reader.list("sphere", |reader, which| {
        let (line, position, color) = reader.place_and_color(which)?;
        let radius = reader.0.number(format_args!("the radius of {which}"), Range::Positive)?;
        let surface = reader.surface(which)?;
        Ok(Sphere { position, color, radius, surface, line })
    })?;
    let lamps = reader.list("lamp", |reader, which| {
        let (line, position, color) = reader.place_and_color(which)?;
        let radius = reader.0.number(format_args!("the radius of {which}"), Range::NotNegative)?;
        Ok(Lamp { position, color, radius, line })
    })?;
    let floor = Some(Floor {
        colors: [reader.0.color("the first floor colour")?, reader.0.color("the second floor colour")?],
    });
    let ambient = reader.0.color("the ambient light")?;
    let sky = Sky {
        horizon: reader.0.color("the colour of the horizon")?,
        zenith: reader.0.color("the colour of the zenith")?,
    };
    reader.end()?;
    Ok(Description {
        cylinders,
        ellipsoids,
        spheres,
        lamps,
        floor,
        ambient,
        sky,
        ..Description::empty(camera)
    })
}

impl Description {
    /// The scene as the thesis's scene file, or `None` if that format cannot say what is in it: without a floor, with
    /// cones, triangles or coefficients, or seen by a camera that is not held upright.
    ///
    /// [`read`] gives the same scene back, digit for digit, with the lines of the new file.
    #[must_use]
    pub fn to_dat(&self) -> Option<String> {
        let floor = self.floor.as_ref()?;
        let cylinders = self.cylinders.iter().map(|c| &c.surface);
        let ellipsoids = self.ellipsoids.iter().map(|e| &e.surface);
        let mut surfaces = cylinders.chain(ellipsoids).chain(self.spheres.iter().map(|s| &s.surface));
        let camera = Camera::upright(self.camera.eye, self.camera.view, self.camera.focal);
        if !(self.cones.is_empty() && self.triangles.is_empty() && self.camera == camera)
            || surfaces.any(|surface| matches!(surface, Surface::Finish { .. }))
        {
            return None;
        }
        let mut text = String::new();
        write_scene(&mut text, self, floor).ok()?;
        Some(text)
    }
}

fn write_scene(text: &mut String, scene: &Description, floor: &Floor) -> fmt::Result {
    writeln!(text, "{}\n{}", Numbers(&scene.camera.eye), Numbers(&scene.camera.view))?;
    writeln!(text, "{}", Numbers(&[scene.camera.focal]))?;
    writeln!(text, "{} # cylinders", scene.cylinders.len())?;
    for Cylinder { position, color, radius, surface, .. } in &scene.cylinders {
        writeln!(
            text,
            "{}  {}  {}  {}",
            Numbers(position),
            Numbers(color),
            Numbers(&[*radius]),
            Type(surface)
        )?;
    }
    writeln!(text, "{} # ellipsoids", scene.ellipsoids.len())?;
    for Ellipsoid { position, color, radii, surface, .. } in &scene.ellipsoids {
        writeln!(text, "{}  {}  {}  {}", Numbers(position), Numbers(color), Numbers(radii), Type(surface))?;
    }
    writeln!(text, "{} # spheres", scene.spheres.len())?;
    for Sphere { position, color, radius, surface, .. } in &scene.spheres {
        writeln!(
            text,
            "{}  {}  {}  {}",
            Numbers(position),
            Numbers(color),
            Numbers(&[*radius]),
            Type(surface)
        )?;
    }
    writeln!(text, "{} # lamps", scene.lamps.len())?;
    for Lamp { position, color, radius, .. } in &scene.lamps {
        writeln!(text, "{}  {}  {}", Numbers(position), Numbers(color), Numbers(&[*radius]))?;
    }
    let [first, second] = &floor.colors;
    for color in [first, second, &scene.ambient, &scene.sky.horizon, &scene.sky.zenith] {
        writeln!(text, "{}", Numbers(color))?;
    }
    Ok(())
}

/// The type of a surface, with what follows it.
struct Type<'a>(&'a Surface);

impl Display for Type<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self.0 {
            Surface::Opaque => write!(f, "0"),
            Surface::Shiny => write!(f, "1"),
            Surface::Mirror => write!(f, "2"),
            Surface::Transparent { ks, kt, ior } => write!(f, "3  {}", Numbers(&[ks, kt, ior])),
            Surface::Finish { .. } => Err(fmt::Error),
        }
    }
}

/// The pieces of the file, read as what the format wants next.
struct Reader<'a>(Tokens<'a>);

impl Reader<'_> {
    fn camera(&mut self) -> Result<Camera, SceneError> {
        let eye = self.0.vector(AXES, "the observer position", Range::Any)?;
        let (line, column) = self.0.place();
        let view = self.0.vector(AXES, "the direction of view", Range::Any)?;
        if view.iter().all(|part| *part == 0.0) {
            let found = Found::Number(Numbers(&view).to_string());
            return Err(self.0.error(line, column, "the direction of view (not zero)".into(), found));
        }
        let focal = self.0.number("the focal distance", Range::Positive)?;
        Ok(Camera::upright(eye, view, focal))
    }

    /// A count, then that many of `kind`. What is read knows itself as "sphere 3 of 70".
    fn list<T>(
        &mut self,
        kind: &str,
        each: impl Fn(&mut Self, fmt::Arguments<'_>) -> Result<T, SceneError>,
    ) -> Result<Vec<T>, SceneError> {
        let most = u32::from(MOST_OBJECTS);
        let count =
            self.0.whole(format_args!("the number of {kind}s (a whole number from 0 to {most})"), 0, most)?;
        let mut objects = Vec::new();
        for index in 1..=count {
            objects.push(each(self, format_args!("{kind} {index} of {count}"))?);
        }
        Ok(objects)
    }

    /// The line where an object begins, its position and its colour.
    fn place_and_color(
        &mut self,
        which: impl Display + Copy,
    ) -> Result<(u32, [f64; 3], [f64; 3]), SceneError> {
        let (line, _) = self.0.place();
        let position = self.0.vector(AXES, format_args!("the position of {which}"), Range::Any)?;
        let color = self.0.color(format_args!("the colour of {which}"))?;
        Ok((line, position, color))
    }

    fn surface(&mut self, which: impl Display) -> Result<Surface, SceneError> {
        match self.0.whole(format_args!("the type of {which} (0, 1, 2 or 3)"), 0, 3)? {
            0 => Ok(Surface::Opaque),
            1 => Ok(Surface::Shiny),
            2 => Ok(Surface::Mirror),
            _ => {
                let ks = self.0.number(format_args!("the ks of {which}"), Range::Share)?;
                let (line, column) = self.0.place();
                let kt = self.0.number(format_args!("the kt of {which}"), Range::Share)?;
                // The sum itself is rounded, by far less than 1e-15.
                if (ks + kt - 1.0).abs() > SHARES_TOLERANCE + 1e-15 {
                    let expected = format!("the kt of {which} (ks + kt = 1 within {SHARES_TOLERANCE:e})");
                    let found =
                        Found::Number(format!("ks + kt = {} + {}", Short::nearest(ks), Short::nearest(kt)));
                    return Err(self.0.error(line, column, expected, found));
                }
                let ior =
                    self.0.number(format_args!("the index of refraction of {which}"), Range::Positive)?;
                Ok(Surface::Transparent { ks, kt, ior })
            }
        }
    }

    /// Nothing may follow the scene.
    fn end(&mut self) -> Result<(), SceneError> {
        match self.0.next() {
            None => Ok(()),
            Some(token) => {
                let expected = "the end of the file after the colour of the zenith".into();
                Err(self.0.error(token.line, token.column, expected, Found::token(token.text)))
            }
        }
    }
}

#[cfg(test)]
mod tests;
