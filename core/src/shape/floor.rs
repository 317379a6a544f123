//! The chequered floor `z = 0`: tiles of 3 x 3 units (Graham 1987).

use super::SurfacePoint;
use crate::color::Rgb;
use crate::ray::Ray;
use crate::scalar::Scalar;
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3, Vector};

/// The opaque floor.
#[derive(Clone, Copy, Debug)]
pub struct Floor<S: Scalar> {
    /// Reflectance of the tiles where `floor(x / 3) + floor(y / 3)` is even, and of the others.
    pub colors: [Rgb<S::Unit>; 2],
    /// Number of its material in the scene's list, from 0.
    pub material: u16,
}

impl<S: Scalar> Floor<S> {
    /// Returns the distance of the hit, from above or below, at most [`Scalar::FAR`]; `None` where the ray is parallel to the
    /// floor or leads away from it.
    pub fn intersect(&self, ray: &Ray<S>) -> Option<S> {
        let (height, rise) = (ray.origin.z(), ray.direction.z());
        let zero = UnitVec3::<S>::X.z();
        if height > S::ZERO && rise < zero {
            Some(height.over(-rise))
        } else if height < S::ZERO && rise > zero {
            Some((-height).over(rise))
        } else {
            None
        }
    }

    /// Returns the surface point of the hit at the distance `t`, and the reflectance of the tile there. Where `t` is beyond
    /// `floor_end`, the point is that of the floor above or below the ray's place at `floor_end`, the tile still that of the hit.
    pub fn point(&self, ray: &Ray<S>, t: S, floor_end: S) -> (SurfacePoint<S>, Rgb<S::Unit>) {
        let (o, d) = (ray.origin, ray.direction);
        let near = t <= floor_end;
        let place = o.along(d, if near { t } else { floor_end });
        let odd = if near {
            place.x().odd_tile() != place.y().odd_tile()
        } else {
            let (height, fall) = if o.z() < S::ZERO { (-o.z(), d.z()) } else { (o.z(), -d.z()) };
            o.x().odd_far_tile(d.x(), height, fall) != o.y().odd_far_tile(d.y(), height, fall)
        };
        let point = Vec3::<S>::new(place.x(), place.y(), S::ZERO);
        let [even_color, odd_color] = self.colors;
        (
            SurfacePoint { distance: t, point, normal: UnitVec3::<S>::Z },
            if odd { odd_color } else { even_color },
        )
    }
}
