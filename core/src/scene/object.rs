//! What a ray meets.

use core::fmt;

/// What a ray meets: which, in its list.
///
/// Of things that are equally near, the first in this order is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Object {
    /// The floor.
    Floor,
    /// A cylinder.
    Cylinder(usize),
    /// An ellipsoid.
    Ellipsoid(usize),
    /// A sphere.
    Sphere(usize),
    /// A cone, or a cylinder between two points.
    Cone(usize),
    /// A triangle.
    Triangle(usize),
    /// A visible lamp.
    Lamp(usize),
}

/// As a scene file counts: from 1.
impl fmt::Display for Object {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (name, index) = match *self {
            Self::Floor => return f.write_str("floor"),
            Self::Cylinder(i) => ("cylinder", i),
            Self::Ellipsoid(i) => ("ellipsoid", i),
            Self::Sphere(i) => ("sphere", i),
            Self::Cone(i) => ("cone", i),
            Self::Triangle(i) => ("triangle", i),
            Self::Lamp(i) => ("lamp", i),
        };
        write!(f, "{name} {}", index + 1)
    }
}

/// The nearest hit of a ray.
#[derive(Clone, Copy, Debug)]
pub struct Hit<S> {
    /// Distance as the search found it.
    pub distance: S,
    /// What was hit.
    pub object: Object,
}
