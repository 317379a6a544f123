//! Where in its source the things of a scene begin, and errors that tell it.

use core::fmt;

use rta_core::Error;
use rta_core::scene::Object;

use crate::description::Description;

impl Description {
    /// Returns the line of the source where an object begins, from 1, if it has one.
    #[must_use]
    pub fn line_of(&self, object: Object) -> Option<u32> {
        fn of<T>(list: &[T], number: u32, line: impl Fn(&T) -> u32) -> Option<u32> {
            list.get(usize::try_from(number).ok()?).map(line)
        }
        let line = match object {
            Object::Cylinder(i) => of(&self.cylinders, i, |cylinder| cylinder.line),
            Object::Ellipsoid(i) => of(&self.ellipsoids, i, |ellipsoid| ellipsoid.line),
            Object::Sphere(i) => of(&self.spheres, i, |sphere| sphere.line),
            Object::Cone(i) => of(&self.cones, i, |cone| cone.line),
            Object::Triangle(i) => of(&self.triangles, i, |triangle| triangle.line),
            Object::Plane(i) => of(&self.planes, i, |plane| plane.line),
            Object::Lamp(i) => of(&self.lamps, i, |lamp| lamp.line),
            Object::Floor => None,
        };
        line.filter(|line| *line > 0)
    }

    /// Returns the scene with every `line` set to 0 and without warnings: two files say the same if these are equal.
    #[must_use]
    pub fn without_lines(mut self) -> Self {
        self.cylinders.iter_mut().for_each(|cylinder| cylinder.line = 0);
        self.ellipsoids.iter_mut().for_each(|ellipsoid| ellipsoid.line = 0);
        self.spheres.iter_mut().for_each(|sphere| sphere.line = 0);
        self.cones.iter_mut().for_each(|cone| cone.line = 0);
        self.triangles.iter_mut().for_each(|triangle| triangle.line = 0);
        self.planes.iter_mut().for_each(|plane| plane.line = 0);
        self.lamps.iter_mut().for_each(|lamp| lamp.line = 0);
        self.materials.iter_mut().for_each(|material| material.line = 0);
        self.textures.iter_mut().for_each(|texture| texture.line = 0);
        self.warnings.clear();
        self
    }
}

/// An error of the range proof, with the lines of its objects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OutOfRange {
    /// The error.
    pub error: Error,
    lines: [Option<u32>; 2],
}

impl OutOfRange {
    /// Adds to an error about a scene the lines where its objects begin.
    #[must_use]
    pub fn new(error: Error, scene: &Description) -> Self {
        let line = |object: Option<Object>| object.and_then(|object| scene.line_of(object));
        Self { error, lines: error.objects().map(line) }
    }
}

impl fmt::Display for OutOfRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let known = || self.error.objects().into_iter().zip(self.lines);
        let line = |wanted| known().find(|(object, _)| *object == Some(wanted)).and_then(|(_, line)| line);
        self.error.write(f, line)
    }
}

impl core::error::Error for OutOfRange {}
