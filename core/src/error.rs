//! Errors. They occur only before a picture is drawn, never while it is drawn.

use core::fmt;

use crate::quantity::{Bound, Cause};
use crate::scene::Object;

/// The reason why a scene, a depth or a raster is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Error {
    /// A quantity of the scene exceeds its limit in the number format.
    Exceeds(Bound),
    /// A radius is not above 0 (a lamp's: below 0).
    Radius(Object),
    /// A reflectance is below 0.
    Color(Object),
    /// The number of a material is beyond the scene's list.
    Material(Object),
    /// A node of a hierarchy is wrong: see [`Accelerator::check`](crate::accelerator::Accelerator::check).
    Hierarchy(usize),
    /// The recursion depth exceeds the capacity of the ray stack, or the weight of a ray may not fit the number format there.
    Depth {
        /// The depth that was asked for.
        depth: u32,
        /// The greatest depth for which there is room, and at which weights fit.
        capacity: usize,
    },
    /// A side of the raster is 0 or too long.
    Raster {
        /// Pixels in a row.
        width: u32,
        /// Rows.
        height: u32,
    },
}

impl Error {
    /// Returns the objects that cause the error: none, one, or two that are too far apart.
    pub fn objects(&self) -> [Option<Object>; 2] {
        match *self {
            Self::Exceeds(Bound { object, other: Some(Cause::Object(other)), .. }) => [object, Some(other)],
            Self::Exceeds(Bound { object, .. }) => [object, None],
            Self::Radius(object) | Self::Color(object) | Self::Material(object) => [Some(object), None],
            _ => [None; 2],
        }
    }

    /// Writes the error with the lines of its objects in a scene file, where `line` knows them.
    ///
    /// # Errors
    /// Those of the formatter.
    pub fn write(&self, f: &mut fmt::Formatter<'_>, line: impl Fn(Object) -> Option<u32>) -> fmt::Result {
        let named = |object| {
            let line = &line;
            fmt::from_fn(move |f| match object {
                Cause::Eye => f.write_str("the observer"),
                Cause::Object(Object::Floor) => f.write_str("the floor"),
                Cause::Object(object) => {
                    write!(f, "{object}")?;
                    line(object).map_or(Ok(()), |line| write!(f, " (line {line})"))
                }
            })
        };
        match *self {
            Self::Exceeds(Bound { quantity, bound, limit, object, other }) => {
                write!(f, "{}", named(object.map_or(Cause::Eye, Cause::Object)))?;
                match other {
                    Some(other) => write!(f, " and {} are", named(other)),
                    None => f.write_str(" is"),
                }?;
                write!(f, " out of the number format's range: {quantity} {bound}, beyond the largest {limit}")
            }
            Self::Radius(object) => {
                let object = named(Cause::Object(object));
                write!(f, "{object} has a radius that is not above 0 in the number format")
            }
            Self::Color(object) => {
                write!(f, "{} has a colour with a negative register", named(Cause::Object(object)))
            }
            Self::Material(object) => {
                write!(f, "{} has a material that the scene has not", named(Cause::Object(object)))
            }
            Self::Hierarchy(node) => {
                write!(f, "node {node} of the hierarchy does not contain its objects, or leads nowhere")
            }
            Self::Depth { depth, capacity } => {
                write!(
                    f,
                    "a recursion depth of {depth} exceeds {capacity}, the deepest for this stack and this scene"
                )
            }
            Self::Raster { width, height } => {
                let most = u16::MAX;
                write!(f, "a raster of {width} x {height} pixels: each side must be 1 to {most}")
            }
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write(f, |_| None)
    }
}

impl core::error::Error for Error {}
