//! Where what has no end, the floor and the vertical cylinders, ends in a number format.

/// How far a scene is seen and lit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits<S> {
    /// A place of the floor that is seen from farther away is lit as if it were this far.
    pub floor_end: S,
    /// Vertical cylinders are seen between this height and its negative.
    pub cylinder_end: S,
}
