//! The pinhole camera, and what a lens adds to it.

use crate::ray::Start;
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3};
use crate::scalar::{Scalar, Unit};

/// Focal distance and size of the image plane. Only the ratios of the three numbers matter; the largest is 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lens<U> {
    /// Focal distance.
    pub focal: U,
    /// Width of the image plane.
    pub width: U,
    /// Height of the image plane.
    pub height: U,
}

impl<U: Unit> Lens<U> {
    /// Returns a lens of the focal distance `numerator / denominator`, in widths of the image plane. `aspect` is width and
    /// height of the screen, not of the raster (4 and 3 for a PS/2). A 0 counts as 1.
    pub fn new(numerator: u16, denominator: u16, aspect: (u16, u16)) -> Self {
        let n = |n: u16| i64::from(n.max(1));
        // In units of 1 / (denominator x aspect.0) of the width.
        let focal = n(numerator) * n(aspect.0);
        let width = n(denominator) * n(aspect.0);
        let height = n(denominator) * n(aspect.1);
        let largest = focal.max(width).max(height);
        Self {
            focal: U::ratio(focal, largest),
            width: U::ratio(width, largest),
            height: U::ratio(height, largest),
        }
    }
}

/// A pinhole camera: an eye, and an image plane in front of it. Its three vectors have the lengths of a [`Lens`].
#[derive(Clone, Copy, Debug)]
pub struct Camera<S: Scalar> {
    /// The observer's position.
    pub eye: Vec3<S>,
    /// From the eye to the centre of the image plane.
    pub forward: UnitVec3<S>,
    /// From the left edge of the image plane to the right.
    pub right: UnitVec3<S>,
    /// From the bottom edge of the image plane to the top.
    pub up: UnitVec3<S>,
}

impl<S: Scalar> Camera<S> {
    /// Returns an upright camera that looks along `view`, a vector of any length above 0 and below 2; a `view` of 0 counts as
    /// north. Where the camera looks straight up or down, its right is east.
    pub fn new(eye: Vec3<S>, view: UnitVec3<S>, lens: Lens<S::Unit>) -> Self {
        let unit = |v: UnitVec3<S>| v.normalize().map(|(v, _)| v);
        let forward = unit(view).unwrap_or(UnitVec3::<S>::Y);
        let right = unit(forward.cross(UnitVec3::<S>::Z)).unwrap_or(UnitVec3::<S>::X);
        let up = right.cross(forward);
        Self {
            eye,
            forward: forward.scale(lens.focal),
            right: right.scale(lens.width),
            up: up.scale(lens.height),
        }
    }

    /// Returns the unit direction of the ray through a place of the image plane: `x` from -1/2 at the left edge to 1/2 at the
    /// right, `y` from -1/2 at the bottom to 1/2 at the top.
    pub fn direction(&self, x: S::Unit, y: S::Unit) -> UnitVec3<S> {
        // The image plane does not go through the eye, so the way to it is never 0.
        self.place(x, y).normalize().map_or(self.forward, |(direction, _)| direction)
    }

    /// Returns the way from the eye to a place of the image plane.
    fn place(&self, x: S::Unit, y: S::Unit) -> UnitVec3<S> {
        self.forward.plus(self.right, x).plus(self.up, y)
    }

    /// Returns the ray through a place of the image plane from a spot of a lens, for a spot on the unit disc. All rays of one place
    /// meet where the ray through the lens's middle meets the plane that is sharp (Cook, Porter and Carpenter, SIGGRAPH 84).
    pub fn through(
        &self,
        aperture: &Aperture<S>,
        (x, y): (S::Unit, S::Unit),
        spot: [S::Unit; 2],
    ) -> Start<S> {
        let [right, up] = spot;
        let [eastward, upward] = aperture.axes;
        let [shift_right, shift_up] = spot.map(|c| -c.times(aperture.shift));
        let way = self.place(x, y).plus(eastward, shift_right).plus(upward, shift_up);
        let origin =
            self.eye.along(eastward, aperture.radius.scale(right)).along(upward, aperture.radius.scale(up));
        Start { origin, direction: way.normalize().map_or(self.forward, |(direction, _)| direction) }
    }
}

/// A lens: a disc around the eye, parallel to the image plane.
///
/// A point at the depth z is seen as a disc of the radius `a f |z - z_f| / (z z_f)` on the image plane, for the radius a of the lens, the
/// focal distance f and the depth z_f that is sharp.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aperture<S: Scalar> {
    /// Its radius a, 0 or more.
    pub radius: S,
    /// `a f / z_f`, in the unit of the camera's vectors, below 1: how far the way to a place of the image plane is shifted from the rim of the
    /// lens.
    pub shift: S::Unit,
    /// Unit vectors to the right and up.
    pub axes: [UnitVec3<S>; 2],
}
