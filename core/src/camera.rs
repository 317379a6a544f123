//! The pinhole camera.

use crate::scalar::vector::{UnitVec3, UnitVector, Vec3};
use crate::scalar::{Scalar, Unit};

/// Shape of the pyramid of vision: only the ratios of the three numbers matter, and the largest is 1.
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
    /// A lens of the focal distance `numerator / denominator`, in widths of the image plane, for a screen of the shape
    /// `aspect` (4 : 3 of a PS/2: the screen's, not the raster's). A 0 counts as 1.
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

/// Eye and image plane.
#[derive(Clone, Copy, Debug)]
pub struct Camera<S: Scalar> {
    /// The observer's position.
    pub eye: Vec3<S>,
    /// To the centre of the image plane.
    pub forward: UnitVec3<S>,
    /// From the left edge of the image plane to the right.
    pub right: UnitVec3<S>,
    /// From the bottom edge of the image plane to the top.
    pub up: UnitVec3<S>,
}

impl<S: Scalar> Camera<S> {
    /// A camera that looks along `view`, a vector of any length above 0 and below 2, and is held upright: `up` leans
    /// towards the zenith. Looking straight up or down, the right is east. (No view at all is north.)
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

    /// Direction of the ray through a place of the image plane: `x` and `y` from -1/2, left and bottom, to 1/2.
    pub fn direction(&self, x: S::Unit, y: S::Unit) -> UnitVec3<S> {
        let place = self.forward.plus(self.right, x).plus(self.up, y);
        // The image plane does not go through the eye, so the way to it is never 0.
        place.normalize().map_or(self.forward, |(direction, _)| direction)
    }
}
