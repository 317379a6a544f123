//! The chequered floor `z = 0`, whose tiles have 3 x 3 units (Graham 1987) or another size.

use super::SurfacePoint;
use crate::color::Rgb;
use crate::light::cone::LampCone;
use crate::needs::Needs;
use crate::ray::Ray;
use crate::scalar::Scalar;
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3, Vector};

/// The opaque floor.
#[derive(Clone, Copy, Debug)]
pub struct Floor<S: Scalar> {
    /// Reflectance of the tiles where `floor(x / tile) + floor(y / tile)` is even, and of the others.
    pub colors: [Rgb<S::Unit>; 2],
    /// Side of a tile, above 0; `None` for 3, which takes no division.
    pub tile: Option<S>,
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

    /// Returns the part of a lamp that the floor hides.
    pub fn hidden(&self, cone: &LampCone<S>) -> S::Unit {
        cone.half_space(cone.apex.z(), cone.lamp.z(), UnitVec3::<S>::Z)
    }

    /// Returns the surface point of the hit at the distance `t`, and the reflectance of the tile there. Where `t` is beyond
    /// `floor_end`, the point is that of the floor above or below the ray's place at `floor_end`, the tile still that of the hit.
    pub fn point<N: Needs>(&self, ray: &Ray<S>, t: S, floor_end: S) -> (SurfacePoint<S>, Rgb<S::Unit>) {
        let (o, d) = (ray.origin, ray.direction);
        let tile = if N::TILES { self.tile } else { None };
        let near = t <= floor_end;
        let place = o.along(d, if near { t } else { floor_end });
        let odd = if near {
            place.x().odd_tile(tile) != place.y().odd_tile(tile)
        } else {
            let (height, fall) = if o.z() < S::ZERO { (-o.z(), d.z()) } else { (o.z(), -d.z()) };
            o.x().odd_far_tile(d.x(), height, fall, tile) != o.y().odd_far_tile(d.y(), height, fall, tile)
        };
        let point = Vec3::<S>::new(place.x(), place.y(), S::ZERO);
        let [even_color, odd_color] = self.colors;
        (
            SurfacePoint { distance: t, point, normal: UnitVec3::<S>::Z },
            if odd { odd_color } else { even_color },
        )
    }
}
