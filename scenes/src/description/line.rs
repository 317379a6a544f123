//! The lines of a scene file that an error is about.

use core::fmt;

use rta_core::range::RangeError;
use rta_core::scene::Object;

use super::Description;

impl Description {
    /// Returns the line of the source where an object begins, from 1, if it is known.
    #[must_use]
    pub fn line(&self, object: Object) -> Option<u32> {
        let index = |i: u32| i as usize;
        let line = match object {
            Object::Floor => None,
            Object::Cylinder(i) => self.cylinders.get(index(i)).map(|object| object.line),
            Object::Ellipsoid(i) => self.ellipsoids.get(index(i)).map(|object| object.line),
            Object::Sphere(i) => self.spheres.get(index(i)).map(|object| object.line),
            Object::Cone(i) => self.cones.get(index(i)).map(|object| object.line),
            Object::Triangle(i) => self.triangles.get(index(i)).map(|object| object.line),
            Object::Lamp(i) => self.lamps.get(index(i)).map(|lamp| lamp.line),
        };
        line.filter(|line| *line > 0)
    }
}

/// An error of the range proof, with the lines of its objects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OutOfRange {
    /// The error.
    pub error: RangeError,
    lines: [Option<u32>; 2],
}

impl OutOfRange {
    /// Adds to an error about a scene the lines where its objects begin.
    #[must_use]
    pub fn new(error: RangeError, scene: &Description) -> Self {
        let line = |object: Option<Object>| object.and_then(|object| scene.line(object));
        Self { error, lines: error.objects().map(line) }
    }
}

impl fmt::Display for OutOfRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let known = || self.error.objects().into_iter().zip(self.lines);
        let line = |wanted| known().find(|(object, _)| *object == Some(wanted)).and_then(|(_, line)| line);
        self.error.with_lines(line).fmt(f)
    }
}

impl core::error::Error for OutOfRange {}
