//! The camera: a pinhole, and what a lens adds to it.

use crate::space::unit;

/// The pinhole camera. One side of its image plane is 1 unit long.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// The observer's position.
    pub eye: [f64; 3],
    /// The direction of view: of any length but zero.
    pub view: [f64; 3],
    /// Distance from the eye to the image plane, above 0.
    pub focal: f64,
    /// The side of the image plane that is 1 unit long; the other follows from the shape of the screen.
    pub side: Side,
    /// What is up in the picture, not along the direction of view; without it, the zenith.
    pub up: Option<[f64; 3]>,
}

/// A side of the image plane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Side {
    /// From left to right.
    #[default]
    Width,
    /// From bottom to top.
    Height,
}

impl Camera {
    /// A camera that is held upright, with an image plane 1 unit wide.
    #[must_use]
    pub const fn upright(eye: [f64; 3], view: [f64; 3], focal: f64) -> Self {
        Self { eye, view, focal, side: Side::Width, up: None }
    }

    /// The direction of view with length 1.
    ///
    /// It is scaled by its greatest component first, so that neither 1e300 nor 1e-300 leaves the range of `f64`.
    /// `None` if the direction is zero or not finite.
    #[must_use]
    pub fn direction(&self) -> Option<[f64; 3]> {
        unit(self.view)
    }
}

/// What a camera with a lens has that a pinhole has not. Nothing is clipped.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Optics {
    /// Distance from the eye that is sharp, above 0, along the direction of view; without it, the length of [`Camera::view`].
    pub focus: Option<f64>,
    /// Diameter of the lens, above 0.
    pub aperture: Option<f64>,
    /// When the shutter opens and closes.
    pub shutter: Option<[f64; 2]>,
    /// How far the eye moves in the time from 0 to 1; it keeps its direction.
    pub moves: Option<[f64; 3]>,
    /// Distance from the eye within which nothing is seen, above 0.
    pub hither: Option<f64>,
}

#[cfg(test)]
mod tests {
    use super::Camera;

    fn direction(view: [f64; 3]) -> Option<[f64; 3]> {
        Camera::upright([0.0; 3], view, 1.0).direction()
    }

    #[test]
    fn direction_neither_overflows_nor_vanishes() {
        for scale in [1e300, 1e-300, 1e-320, 1.0] {
            let [x, y, z] = direction([3.0 * scale, 0.0, -4.0 * scale]).expect("it is not zero");
            // Subnormals have few digits left: 1e-320 holds about three.
            let tolerance = if scale < 1e-307 { 1e-3 } else { 1e-15 };
            assert!((x - 0.6).abs() < tolerance && y == 0.0 && (z + 0.8).abs() < tolerance, "{x} {y} {z}");
        }
        assert_eq!(direction([0.0, 5e-324, 0.0]), Some([0.0, 1.0, 0.0]));
    }

    #[test]
    fn no_direction_of_nothing() {
        assert_eq!(direction([0.0, -0.0, 0.0]), None);
        assert_eq!(direction([f64::NAN, 1.0, 0.0]), None);
        assert_eq!(direction([f64::INFINITY, 1.0, 0.0]), None);
    }
}
