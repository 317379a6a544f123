//! A scene with its limits: what is seen along a ray.

use crate::color::Rgb;
use crate::material::Material;
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

    /// Returns the distance at which a ray meets the floor, if there is a floor and the ray meets it.
    pub fn floor<N: Needs>(&self, ray: &Ray<S>) -> Option<S> {
        if N::FLOOR { self.scene.floor.as_ref().and_then(|floor| floor.intersect(ray)) } else { None }
    }

    /// Returns what is seen along a ray whose nearest hit is `hit`.
    #[cfg_attr(not(target_os = "none"), inline(always))]
    pub fn seen<N: Needs>(&self, ray: &Ray<S>, hit: Option<Hit<S>>) -> Seen<'a, S> {
        let Some(Hit { distance, object }) = hit else { return self.sky::<N>(ray) };
        let found = match object {
            Object::Lamp(i) if N::VISIBLE_LAMPS => {
                return match self.scene.lamps.get(index(i)) {
                    Some(lamp) => Seen::Light(lamp.radiance()),
                    None => self.sky::<N>(ray),
                };
            }
            Object::Floor if N::FLOOR => self.scene.floor.as_ref().map(|floor| {
                let (point, color) = floor.point(ray, distance, self.limits.floor_end);
                (point, color, &Material::Opaque, S::ZERO)
            }),
            _ => {
                let is_cylinder = N::CYLINDERS && matches!(object, Object::Cylinder(_));
                let planned;
                let ray = if is_cylinder && ray.plan.is_none() {
                    planned = self.ray::<N>(ray.origin, ray.direction);
                    &planned
                } else {
                    ray
                };
                self.scene.point::<N>(object, ray, distance).map(|(point, look)| {
                    let Look { color, material, extent, .. } = look;
                    (point, color, material, extent)
                })
            }
        };
        let Some((spot, color, material, extent)) = found else {
            return self.sky::<N>(ray);
        };
        let SurfacePoint { distance, point, normal, face } = spot;
        let inside = normal.dot(ray.direction) > S::Unit::ZERO;
        let (normal, face) = if inside { (-normal, face.map(|face| -face)) } else { (normal, face) };
        let incoming = ray.direction;
        Seen::Surface(Surface { point, normal, face, incoming, distance, inside, extent, color, material })
    }

    fn sky<N: Needs>(&self, ray: &Ray<S>) -> Seen<'a, S> {
        Seen::Light(self.scene.sky.radiance::<N>(ray.direction))
    }
}
