//! Where the infinite objects, floor and vertical cylinders, end in a number format.

/// How far the infinite objects of a scene are seen and lit, as [`Scene::admit`](super::Scene::admit) finds it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits<S> {
    /// Distance from a ray's origin beyond which a place of the floor is lit as if it were at this distance.
    pub floor_end: S,
    /// A place of a vertical cylinder above this height, or below its negative, is lit as if it were there.
    pub cylinder_end: S,
}
