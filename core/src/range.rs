//! Range is proved, not hoped for: a scene is admitted to a number format before it may be drawn.
//!
//! The proof is a conservative bound. Eye, objects and lamps lie in the box `|x|, |y|, |z| <= WORLD`. A ray starts in
//! that box, since it starts at the eye or on an object (or on the floor up to [`Scalar::REACH`] away, for shadow rays
//! only), and what it meets lies in it too; so every displacement is a difference of two such points, every length is at
//! most the box's diagonal, and both fit the format with their squares: see the constants of [`Scalar`]. Components of
//! unit vectors and reflectances stay below 2, radiances saturate by design. Cylinders are seen up to the box's lid.

use core::fmt;
use core::ops::Deref;

use crate::camera::Camera;
use crate::color::Rgb;
use crate::scalar::{Scalar, Unit};
use crate::scene::{Object, Scene};
use crate::vector::{Vec3, Vector};

/// A scene that fits its number format together with an eye.
#[derive(Clone, Copy, Debug)]
pub struct Admitted<'a, S: Scalar> {
    scene: Scene<'a, S>,
}

impl<'a, S: Scalar> Deref for Admitted<'a, S> {
    type Target = Scene<'a, S>;
    fn deref(&self) -> &Self::Target {
        &self.scene
    }
}

/// What of an object does not fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Quantity {
    /// A coordinate, together with the radius, leaves [`Scalar::WORLD`].
    Position,
    /// A radius is not above 0 (a lamp's: below 0).
    Radius,
    /// A reflectance is below 0.
    Color,
}

/// Why a scene is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct RangeError {
    /// The object, by its place in its list; nothing for the eye.
    pub object: Option<Object>,
    /// What of it does not fit.
    pub quantity: Quantity,
}

impl fmt::Display for RangeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.object {
            None => write!(f, "the eye")?,
            Some(Object::Floor) => write!(f, "the floor")?,
            Some(Object::Cylinder(i)) => write!(f, "cylinder {}", i + 1)?,
            Some(Object::Ellipsoid(i)) => write!(f, "ellipsoid {}", i + 1)?,
            Some(Object::Sphere(i)) => write!(f, "sphere {}", i + 1)?,
            Some(Object::Lamp(i)) => write!(f, "lamp {}", i + 1)?,
        }
        f.write_str(match self.quantity {
            Quantity::Position => " lies outside the number format's world",
            Quantity::Radius => " has a radius that is not above 0 in the number format",
            Quantity::Color => " has a colour with a negative register",
        })
    }
}

impl core::error::Error for RangeError {}

impl<'a, S: Scalar> Scene<'a, S> {
    /// Proves that no ray of this scene, seen from this eye, leaves the number format.
    ///
    /// # Errors
    /// The first object that does not fit, and what of it.
    pub fn admit(self, camera: &Camera<S>) -> Result<Admitted<'a, S>, RangeError> {
        let check = |object, place: Vec3<S>, radius: S, color: Rgb<S::Unit>| {
            let fits = |c: S| c <= S::WORLD - radius && c >= radius - S::WORLD;
            let is_negative = |c: S::Unit| c < S::Unit::ZERO;
            let quantity = if radius < S::ZERO
                || (radius == S::ZERO && !matches!(object, None | Some(Object::Lamp(_) | Object::Floor)))
            {
                Quantity::Radius
            } else if radius > S::WORLD || !fits(place.x()) || !fits(place.y()) || !fits(place.z()) {
                Quantity::Position
            } else if is_negative(color.r) || is_negative(color.g) || is_negative(color.b) {
                Quantity::Color
            } else {
                return Ok(());
            };
            Err(RangeError { object, quantity })
        };
        let white = Rgb::new(S::Unit::ONE, S::Unit::ONE, S::Unit::ONE);
        check(None, camera.eye, S::ZERO, white)?;
        for (i, c) in self.cylinders.iter().enumerate() {
            check(Some(Object::Cylinder(i)), c.center, c.radius, c.color)?;
        }
        for (i, e) in self.ellipsoids.iter().enumerate() {
            let zero_radius = !(e.radii.x() > S::ZERO && e.radii.y() > S::ZERO && e.radii.z() > S::ZERO);
            check(
                Some(Object::Ellipsoid(i)),
                e.center,
                if zero_radius { S::ZERO } else { e.extent },
                e.color,
            )?;
        }
        for (i, s) in self.spheres.iter().enumerate() {
            check(Some(Object::Sphere(i)), s.center, s.radius, s.color)?;
        }
        for (i, l) in self.lamps.iter().enumerate() {
            check(Some(Object::Lamp(i)), l.position, l.radius, l.tint)?;
        }
        if let Some(floor) = &self.floor {
            let [even, odd] = floor.colors;
            let origin = Vec3::<S>::new(S::ZERO, S::ZERO, S::ZERO);
            check(Some(Object::Floor), origin, S::ZERO, even)?;
            check(Some(Object::Floor), origin, S::ZERO, odd)?;
        }
        Ok(Admitted { scene: self })
    }
}
