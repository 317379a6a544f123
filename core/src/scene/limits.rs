//! Where the infinite objects, floor and vertical cylinders, end in a number format, and how deep rays may go.

/// How far the infinite objects of a scene are seen and lit, and how deep its rays may go, as
/// [`Scene::admit`](super::Scene::admit) finds it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits<S> {
    /// Distance from a ray's origin beyond which a place of the floor is lit as if it were at this distance.
    pub floor_end: S,
    /// A place of a vertical cylinder above this height, or below its negative, is lit as if it were there.
    pub cylinder_end: S,
    /// The greatest depth of a ray at which its weight fits the number format. It is 255 where no surface sends back more light
    /// than it receives.
    pub depth: u8,
}
