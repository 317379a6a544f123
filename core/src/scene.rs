//! A scene is borrowed data: one list for each kind of thing, in RAM or in flash.

mod four;
mod known;
mod nearest;
mod object;
mod shadow;

pub(crate) use four::Spots;
pub(crate) use known::Known;
pub use object::{Hit, Object};

use crate::bvh::Bvh;
use crate::color::Rgb;
use crate::hierarchy::Node;
use crate::illumination::Surface;
use crate::lanes::Lanes;
use crate::light::Lamp;
use crate::material::Material;
use crate::needs::Needs;
use crate::range::Limits;
use crate::ray::Ray;
use crate::scalar::{Light, Scalar, Unit};
pub use crate::shape::Floor;
use crate::shape::{Cone, Cylinder, Ellipsoid, Sphere, Spot, Triangle};
use crate::vector::{UnitVec3, UnitVector, Vec3, Vector};

/// A scene (rta-model section 1), but for the eye.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a, S: Scalar> {
    /// Vertical cylinders.
    pub cylinders: &'a [Cylinder<S>],
    /// Ellipsoids.
    pub ellipsoids: &'a [Ellipsoid<S>],
    /// Spheres.
    pub spheres: &'a [Sphere<S>],
    /// A hierarchy over the spheres, or nothing.
    pub hierarchy: &'a [Node<S>],
    /// Cones and cylinders between two points.
    pub cones: &'a [Cone<S>],
    /// Triangles.
    pub triangles: &'a [Triangle<S>],
    /// A hierarchy of boxes over ellipsoids, spheres, cones and triangles, or [`Bvh::NONE`].
    pub boxes: Bvh<'a, S>,
    /// What a machine with lanes goes by instead of the two hierarchies, or [`Lanes::NONE`].
    pub lanes: Lanes<'a>,
    /// Lamps.
    pub lamps: &'a [Lamp<S>],
    /// The floor, if there is one.
    pub floor: Option<Floor<S>>,
    /// What a ray sees that meets nothing.
    pub sky: Sky<S>,
    /// Ambient light.
    pub ambient: Rgb<S::Light>,
}

/// The sky: one colour at the horizon, one at the zenith and at the nadir, mixed by the square of the sine of the
/// elevation (Graham 1987).
#[derive(Clone, Copy, Debug)]
pub struct Sky<S: Scalar> {
    /// Radiance at the horizon.
    pub horizon: Rgb<S::Light>,
    /// Radiance at the zenith.
    pub zenith: Rgb<S::Light>,
}

impl<S: Scalar> Sky<S> {
    /// Radiance in a direction.
    fn radiance<N: Needs>(&self, direction: UnitVec3<S>) -> Rgb<S::Light> {
        // A sum of parts of one colour would be rounded.
        if !N::SKY_GRADIENT || self.horizon == self.zenith {
            return self.horizon;
        }
        let high = direction.z().times(direction.z());
        let low = S::Unit::ONE - high;
        self.horizon.zip(self.zenith, |horizon, zenith| horizon.times(low).plus(zenith.times(high)))
    }
}

impl<S: Scalar> Scene<'_, S> {
    /// An empty plain under a blue sky, by day.
    pub fn day() -> Self {
        let unit = |n| S::Unit::ratio(n, 100);
        let light = |r, g, b| Rgb::new(unit(r), unit(g), unit(b)).map(|part| S::Light::WHITE.times(part));
        Scene {
            cylinders: &[],
            ellipsoids: &[],
            spheres: &[],
            hierarchy: &[],
            cones: &[],
            triangles: &[],
            boxes: Bvh::NONE,
            lanes: Lanes::NONE,
            lamps: &[],
            floor: Some(Floor {
                colors: [Rgb::new(unit(85), unit(85), unit(80)), Rgb::new(unit(15), unit(17), unit(25))],
            }),
            sky: Sky { horizon: light(75, 82, 95), zenith: light(10, 22, 60) },
            ambient: light(30, 30, 32),
        }
    }

    /// A ray through this scene.
    #[inline]
    pub fn ray<N: Needs>(&self, origin: Vec3<S>, direction: UnitVec3<S>) -> Ray<S> {
        let is_asked = N::CYLINDERS && !self.cylinders.is_empty() && !self.is_laned::<N>();
        let plan = if is_asked { direction.plan() } else { None };
        Ray { origin, direction, plan }
    }

    /// What is seen along a ray: the surface of what it hits, or the radiance of a lamp or of the sky.
    #[cfg_attr(not(target_os = "none"), inline(always))]
    pub(crate) fn look<N: Needs>(&self, ray: &Ray<S>, limits: &Limits<S>) -> Seen<'_, S> {
        let hit = self.find::<N>(ray, limits.lid);
        if N::VISIBLE_LAMPS
            && let Some(Hit { object: Object::Lamp(i), .. }) = hit
            && let Some(lamp) = self.lamps.get(i)
        {
            return Seen::Light(lamp.radiance());
        }
        let found = hit.and_then(|hit| match hit.object {
            Object::Sphere(i) if N::SPHERES => {
                self.spheres.get(i).map(|s| (s.spot(ray, hit.distance), s.color, &s.material, s.radius))
            }
            _ => self.place::<N>(ray, hit, limits.reach),
        });
        let Some((spot, color, material, extent)) = found else {
            return Seen::Light(self.sky.radiance::<N>(ray.direction));
        };
        let inside = spot.normal.dot(ray.direction) > S::Unit::ZERO;
        let surface = Surface {
            point: spot.point,
            normal: if inside { -spot.normal } else { spot.normal },
            incoming: ray.direction,
            distance: spot.distance,
            inside,
            color,
            material,
        };
        Seen::Surface(surface, extent)
    }

    /// The place on what is no sphere, with its colour, its material and the size of the object. One arm for each kind; an
    /// index is always that of a thing in its list.
    #[cfg_attr(not(target_os = "none"), inline(never))] // so that a ray which meets a sphere does not prepare for it
    fn place<N: Needs>(&self, ray: &Ray<S>, hit: Hit<S>, reach: S) -> Option<Place<'_, S>> {
        let distance = hit.distance;
        match hit.object {
            Object::Floor if N::FLOOR => self.floor.as_ref().map(|floor| {
                let (spot, color) = floor.spot(ray, distance, reach);
                (spot, color, &Material::Opaque, S::ZERO)
            }),
            Object::Cylinder(i) if N::CYLINDERS => {
                self.cylinders.get(i).map(|c| (c.spot(ray, distance), c.color, &c.material, c.radius))
            }
            Object::Ellipsoid(i) if N::ELLIPSOIDS => self
                .ellipsoids
                .get(i)
                .map(|e| (e.spot(ray, distance), e.color, &e.material, e.extent.squashed(e.thickness))),
            Object::Cone(i) if N::CONES => {
                self.cones.get(i).map(|c| (c.spot(ray, distance), c.color, &c.material, c.extent()))
            }
            Object::Triangle(i) if N::TRIANGLES => {
                self.triangles.get(i).map(|t| (t.spot::<N>(ray, distance), t.color, &t.material, t.extent))
            }
            _ => None,
        }
    }
}

/// A place on a surface, with its colour, its material and the size of the object.
type Place<'a, S> = (Spot<S>, Rgb<<S as Scalar>::Unit>, &'a Material<S>, S);

/// What a ray sees.
pub(crate) enum Seen<'a, S: Scalar> {
    /// The sky or a lamp.
    Light(Rgb<S::Light>),
    /// A surface, and the size of the object it belongs to.
    Surface(Surface<'a, S>, S),
}
