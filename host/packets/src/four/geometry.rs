//! Places on surfaces and the rays that leave them, four at once.

use glam::{BVec4A, Vec3, Vec4};
use rta_core::Scalar;
use rta_core::material::Glass;
use rta_core::needs::Everything;
use rta_core::ray::Ray;
use rta_core::shape::{Floor, Primitive, Sphere};

use super::vector::{Vec3x4, lane, one_ref, set};
use crate::leaf::Bits;

/// Four rays side by side.
#[derive(Clone, Copy)]
pub(crate) struct Ray4 {
    pub(crate) origin: Vec3x4,
    pub(crate) direction: Vec3x4,
}

impl Ray4 {
    /// Returns one of them, made ready for nothing.
    #[inline(always)]
    pub(crate) fn lane(&self, k: usize) -> Ray<f32> {
        Ray::new(self.origin.lane(k), self.direction.lane(k))
    }

    /// Which of them meet a sphere ahead, and how far away: four times [`Sphere::intersect`](Primitive::intersect). The centre and the radius are given four
    /// times.
    #[inline(always)]
    pub(crate) fn meet_sphere(&self, center: Vec3x4, radius: Vec4) -> (BVec4A, Vec4) {
        let (displacement, zero) = (center - self.origin, Vec4::ZERO);
        let along = displacement.dot(self.direction);
        let across = displacement - self.direction.scale(along);
        let (across, square) = (across.dot(across), radius * radius);
        let is_met = across.cmple(square);
        if !is_met.any() {
            return (is_met, zero);
        }
        let half = (square - across).max(zero).sqrt();
        let (near, far) = (along - half, along + half);
        let t = Vec4::select(near.cmpgt(zero), near, far);
        (is_met & t.cmpgt(zero), t)
    }
}

/// Places on four surfaces: four times [`SurfacePoint`](rta_core::shape::SurfacePoint).
#[derive(Clone, Copy)]
pub(crate) struct SurfacePoint4 {
    pub(crate) distance: Vec4,
    pub(crate) point: Vec3x4,
    pub(crate) normal: Vec3x4,
}

impl SurfacePoint4 {
    /// Nothing.
    pub(crate) const ZERO: Self =
        Self { distance: Vec4::ZERO, point: Vec3x4([Vec4::ZERO; 3]), normal: Vec3x4([Vec4::ZERO; 3]) };

    /// Where the rays in `which` meet spheres at the distances `t`: four times [`Sphere::point`](Primitive::point).
    #[inline(always)]
    pub(crate) fn on_spheres(spheres: [&Sphere<f32>; 4], which: u32, rays: &Ray4, t: Vec4) -> Self {
        let four = |number: fn(&Sphere<f32>) -> f32| {
            let [a, b, c, d] = spheres;
            Vec4::new(number(a), number(b), number(c), number(d))
        };
        let center = Vec3x4::new(spheres.map(|sphere| sphere.center));
        let (radius, inverse) = (four(|sphere| sphere.radius), four(|sphere| sphere.inverse_radius));
        let direction = rays.direction;
        let displacement = center - rays.origin;
        let b = displacement.dot(direction);
        let beside = (direction.scale(b) - displacement).scale(inverse);
        let past = beside.dot(direction);
        let foot = beside.plus(direction, -past);
        let square = Vec4::ONE - foot.dot(foot);
        let half = square.sqrt();
        let offset = Vec4::select(t.cmpgt(b), half, -half);
        let normal = foot.plus(direction, offset);
        let excess = normal.dot(normal) - Vec4::ONE;
        let normal = normal.plus(normal, excess * Vec4::splat(-0.5));
        let mut spots =
            Self { distance: b + radius * (offset - past), point: center.plus(normal, radius), normal };
        let missed = which & square.cmplt(Vec4::ZERO).bitmask();
        if missed != 0 {
            spots.mend(missed, spheres, rays, t);
        }
        spots
    }

    /// Where the search saw a tangent but there is a miss by less than its rounding.
    #[cold]
    #[inline(never)]
    fn mend(&mut self, missed: u32, spheres: [&Sphere<f32>; 4], rays: &Ray4, t: Vec4) {
        for k in Bits(missed) {
            let spot = one_ref(&spheres, k).point::<Everything>(&rays.lane(k), lane(&t, k));
            set(&mut self.distance, k, spot.distance);
            self.point.set(k, spot.point);
            self.normal.set(k, spot.normal);
        }
    }
}

/// The unit vectors along four vectors, their lengths and the reciprocals of these, and a bit for each that is none as the vector
/// was 0: four times [`normalize`](rta_core::vector::LengthVector::normalize).
#[inline(always)]
pub(crate) fn normalize(vectors: Vec3x4) -> (Vec3x4, Vec4, Vec4, u32) {
    let length = vectors.dot(vectors).sqrt();
    let inverse = length.recip();
    (vectors.scale(inverse), length, inverse, (!inverse.cmplt(Vec4::INFINITY)).bitmask())
}

/// Where four rays start that leave surfaces, and how much of them that uses up: four times [`leave`](rta_core::vector::LengthVector::leave).
#[inline(always)]
pub(crate) fn leave(point: Vec3x4, normal: Vec3x4, direction: Vec3x4, extent: Vec4) -> (Vec3x4, Vec4) {
    let step = Vec4::splat(8.0 * f32::EPSILON) * (point.largest() + extent);
    let cosine = normal.dot(direction);
    let twice = step + step;
    let (half, quarter) = (cosine.cmpge(Vec4::splat(0.5)), cosine.cmpge(Vec4::splat(0.25)));
    let along = Vec3x4::select(quarter, direction, normal);
    let way = Vec4::select(half, twice, Vec4::select(quarter, twice + step + step, step));
    (point.plus(along, way), Vec4::splat(6.0) * step)
}

/// Which of four rays meet the floor, and how far away: four times [`Floor::intersect`](rta_core::shape::Floor::intersect).
#[inline(always)]
pub(crate) fn to_floor(rays: &Ray4) -> (BVec4A, Vec4) {
    let ([_, _, height], [_, _, rise], zero) = (rays.origin.0, rays.direction.0, Vec4::ZERO);
    let down = height.cmpgt(zero) & rise.cmplt(zero);
    let up = height.cmplt(zero) & rise.cmpgt(zero);
    (down | up, (height.abs() / rise.abs()).min(Vec4::splat(f32::FAR)))
}

/// Directions through the image plane: four times [`Camera::direction`](rta_core::camera::Camera::direction).
#[inline(always)]
pub(crate) fn through_plane(forward: Vec3, right: Vec3, up: Vec3, x: Vec4, y: Vec4) -> Vec3x4 {
    let place = Vec3x4::splat(forward).plus(Vec3x4::splat(right), x).plus(Vec3x4::splat(up), y);
    let (direction, _, inverse, _) = normalize(place);
    Vec3x4::select(inverse.cmplt(Vec4::INFINITY), direction, Vec3x4::splat(forward))
}

/// Which of four coordinates lie in an odd one of the floor's tiles of that side: four times
/// [`Scalar::odd_tile`](rta_core::Scalar::odd_tile).
#[inline(always)]
fn odd_tiles(place: Vec4, side: Vec4) -> Vec4 {
    let tile = (place / side).floor();
    tile - (tile * Vec4::splat(0.5)).floor() * Vec4::splat(2.0)
}

/// The places of a floor at the distances `t` along four rays, none of which is far away, and a bit for each that lies in a
/// tile of the second colour: four times [`Floor::point`](rta_core::shape::Floor::point).
#[inline(always)]
pub(crate) fn on_floor(floor: &Floor<f32>, rays: &Ray4, t: Vec4) -> (Vec3x4, u32) {
    let side = Vec4::splat(floor.tile.unwrap_or(3.0));
    let Vec3x4([x, y, _]) = rays.origin.plus(rays.direction, t);
    (Vec3x4([x, y, Vec4::ZERO]), odd_tiles(x, side).cmpne(odd_tiles(y, side)).bitmask())
}

/// Four times [`reflect`](rta_core::vector::UnitVector::reflect).
#[inline(always)]
pub(crate) fn reflect(incoming: Vec3x4, normal: Vec3x4) -> Vec3x4 {
    incoming - normal.scale(Vec4::splat(2.0) * incoming.dot(normal))
}

/// The transmitted rays, and which of them are none: four times [`refract`](rta_core::trace::decision::refract).
#[inline(always)]
pub(crate) fn refract(
    incoming: Vec3x4,
    normal: Vec3x4,
    inside: BVec4A,
    glasses: [&Glass<f32>; 4],
) -> (Vec3x4, u32) {
    let ([a, b, c, d], one) = (glasses, Vec4::ONE);
    let eta = Vec4::new(a.eta, b.eta, c.eta, d.eta);
    let denser = BVec4A::new(a.denser, b.denser, c.denser, d.denser);
    let into_denser = inside ^ denser;
    let cosine = -normal.dot(incoming);
    let slanted = eta * cosine;
    let pick = |into, out_of| Vec4::select(into_denser, into, out_of);
    let (first, second, minus) = (pick(one, cosine), pick(slanted, eta), pick(eta, one));
    let square = (first - minus) * (first + minus) + second * second;
    let along = pick(slanted, cosine) - square.sqrt();
    let (direction, _, inverse, _) = normalize(incoming.scale(pick(eta, one)).plus(normal, along));
    (direction, (square.cmplt(Vec4::ZERO) | !inverse.cmplt(Vec4::INFINITY)).bitmask())
}
