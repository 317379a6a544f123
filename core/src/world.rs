//! A scene with its limits: what is seen along a ray.

mod cover;

use crate::color::Rgb;
use crate::needs::Needs;
use crate::ray::Ray;
use crate::scalar::vector::{UnitVec3, UnitVector, Vec3};
use crate::scalar::{Scalar, Unit};
use crate::scene::{Hit, Limits, Object, Scene, index};
use crate::shape::{Look, SurfacePoint};
use crate::surface::Surface;

/// A scene, and how far its infinite objects are seen.
#[derive(Clone, Copy, Debug)]
pub struct World<'a, S: Scalar> {
    /// The scene.
    pub scene: Scene<'a, S>,
    /// How far floor and vertical cylinders are seen and lit.
    pub limits: Limits<S>,
}

/// What is seen along a ray.
#[derive(Clone, Copy, Debug)]
pub enum Seen<'a, S: Scalar> {
    /// The radiance of the sky or of a visible lamp.
    Light(Rgb<S::Light>),
    /// A surface, which an illumination model shades.
    Surface(Surface<'a, S>),
}

impl<'a, S: Scalar> World<'a, S> {
    /// Returns a ray for which all objects of the scene can be tested: with a plan where there are vertical cylinders.
    pub fn ray<N: Needs>(&self, origin: Vec3<S>, direction: UnitVec3<S>) -> Ray<S> {
        let ray = Ray::new(origin, direction);
        let has_cylinders = N::CYLINDERS && !self.scene.cylinders.is_empty();
        if has_cylinders { ray.with_plan(self.limits.cylinder_end) } else { ray }
    }

    /// Returns a ray with its plan where it needs one for [`World::seen`]: where its nearest hit is a vertical cylinder. It is for
    /// rays that were searched for without a plan.
    pub fn planned<N: Needs>(&self, ray: Ray<S>, hit: Option<&Hit<S>>) -> Ray<S> {
        let is_cylinder = |hit: &Hit<S>| N::CYLINDERS && matches!(hit.object, Object::Cylinder(_));
        if hit.is_some_and(is_cylinder) { ray.with_plan(self.limits.cylinder_end) } else { ray }
    }

    /// Returns the distance at which a ray meets the floor, if there is a floor and the ray meets it.
    pub fn floor<N: Needs>(&self, ray: &Ray<S>) -> Option<S> {
        if N::FLOOR { self.scene.floor.as_ref().and_then(|floor| floor.intersect(ray)) } else { None }
    }

    /// Returns what is seen along a ray, with its plan if that is a vertical cylinder, whose nearest hit is `hit`. A surface is not
    /// [covered](World::cover) yet.
    #[cfg_attr(not(target_os = "none"), inline(always))]
    pub fn seen<N: Needs>(&self, ray: &Ray<S>, hit: Option<Hit<S>>) -> Seen<'a, S> {
        if N::VISIBLE_LAMPS
            && let Some(Hit { object: Object::Lamp(i), .. }) = hit
            && let Some(lamp) = self.scene.lamps.get(index(i))
        {
            return Seen::Light(lamp.radiance());
        }
        let found = hit.and_then(|Hit { distance, object }| match object {
            Object::Floor if N::FLOOR => self.scene.floor.as_ref().map(|floor| {
                let (point, color) = floor.point::<N>(ray, distance, self.limits.floor_end);
                (point, color, floor.material, S::ZERO, None)
            }),
            _ => self.scene.point::<N>(object, ray, distance).map(|(point, look)| {
                let Look { color, material, extent, .. } = look;
                let face = if N::NORMALS { self.scene.face::<N>(object) } else { None };
                (point, color, material, extent, face)
            }),
        });
        let Some((spot, color, number, extent, face)) = found else {
            return Seen::Light(self.scene.radiance::<N>(ray.direction));
        };
        let SurfacePoint { distance, point, normal } = spot;
        let inside = normal.dot(ray.direction) > S::Unit::ZERO;
        let normal = if inside { -normal } else { normal };
        // It is on the same side of the ray.
        let face = face.map(|face| if inside { -face } else { face });
        let incoming = ray.direction;
        let material = self.scene.material(number);
        Seen::Surface(Surface {
            point,
            normal,
            face,
            incoming,
            distance,
            inside,
            extent,
            color,
            material,
            surroundings: false,
            mesh: None,
            number,
        })
    }
}
