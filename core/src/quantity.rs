//! The quantities that the range proof bounds.

use core::fmt;

use crate::scalar::Magnitude;
use crate::scene::Object;

/// A quantity that the proof bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Quantity {
    /// A coordinate of the eye or of the outside of an object.
    Coordinate,
    /// The distance between any two places of the scene, and between origin and hit of a ray.
    Distance,
    /// A distance to a place of the floor, and a coordinate of that place.
    Reach,
    /// The height beyond which vertical cylinders are lit as if they were there, up and down; 0 where there are none.
    CylinderEnd,
    /// The square of a distance.
    Square,
    /// The sum of three products of a length with a unit, before it is rounded.
    Product,
    /// A component of a unit vector, a cosine, a coefficient.
    Component,
    /// A component of the vector from the eye to a place of the image plane.
    ImagePlane,
    /// The reflectance of a surface: its colour, or that times its coefficient of diffuse or of ambient light where it is above 1.
    Reflectance,
    /// The weight of a ray of this depth or a lesser one: a product of as many reflectances.
    Weight(u8),
    /// The largest radius of an ellipsoid over its smallest.
    Thinness,
    /// Four times the distance by which a ray's origin is pushed off a surface; its limit is the smallest radius.
    Clearance,
    /// Radiance, which saturates by design.
    Radiance,
    /// The radiosity of a patch: the largest that is emitted, over 1 less the largest reflectance.
    Radiosity,
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Coordinate => "coordinate",
            Self::Distance => "distance between two places",
            Self::Reach => "distance to the floor's end",
            Self::CylinderEnd => "height at which cylinders end",
            Self::Square => "squared distance",
            Self::Product => "sum of three products",
            Self::Component => "component of a unit vector",
            Self::ImagePlane => "component of the image plane",
            Self::Reflectance => "reflectance",
            Self::Weight(depth) => return write!(f, "weight of a ray at depth {depth}"),
            Self::Thinness => "largest over smallest radius",
            Self::Clearance => "four times a ray's clearance",
            Self::Radiance => "radiance (saturates)",
            Self::Radiosity => "radiosity",
        })
    }
}

/// A row of the proof: the quantity never exceeds its bound, and must not exceed its limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bound {
    /// The quantity that is bounded.
    pub quantity: Quantity,
    /// The largest size it can have.
    pub bound: Magnitude,
    /// The largest size it may have.
    pub limit: Magnitude,
    /// The object that causes the bound; `None` for the eye, or where no object does.
    pub object: Option<Object>,
    /// Of a distance between two places, what is at its other end, where that is something else.
    pub other: Option<Cause>,
}

/// What is at an end of a distance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// The eye.
    Eye,
    /// An object.
    Object(Object),
}

impl Bound {
    /// Returns whether the bound is within the limit, or the quantity saturates.
    pub fn holds(&self) -> bool {
        self.bound <= self.limit || self.quantity == Quantity::Radiance
    }
}
