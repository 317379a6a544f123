//! What moves while the shutter is open, in one number format.

use rta_core::light::Lamp;
use rta_core::scene::{Copies, Object, Scene};
use rta_core::shape::{Cone, Cylinder, Ellipsoid, Plane, Sphere, Triangle};
use rta_core::trace::moving::{Motion, Room};

use super::check::Checker;
use super::{Narrow, NarrowError, Narrowed};
use crate::description::Description;

/// Returns how the objects of a scene move, which is as it is in the [middle](Description::in_the_middle) of the time.
pub(super) fn motions<S: Narrow>(description: &Description) -> Result<Vec<Motion<S>>, NarrowError> {
    let moves =
        |(&object, detail): (&Object, &crate::description::Detail)| detail.moves.map(|by| (object, by));
    let moving = description.details.objects.iter().filter_map(moves);
    let check = Checker::<S>::named("the motion of an object");
    moving.map(|(object, by)| Ok(Motion { object, by: check.place(by, 0.0)? })).collect()
}

impl<S: Narrow> Narrowed<S> {
    /// Returns the scene as it is when the shutter opens and when it closes; nothing where nothing moves.
    pub(super) fn ends(&self) -> Vec<Self> {
        if self.spreads.motions.is_empty() {
            return Vec::new();
        }
        let half = S::unit(0.5);
        [-half, half]
            .map(|time| {
                let mut end = self.clone();
                let Self { cylinders, ellipsoids, spheres, cones, triangles, planes, lamps, .. } = &mut end;
                let mut copies = Copies { cylinders, ellipsoids, spheres, cones, triangles, planes, lamps };
                self.spreads.motions.iter().for_each(|motion| motion.put(&mut copies, &self.scene(), time));
                end
            })
            .into()
    }
}

/// Lists of a scene in which something moves.
#[derive(Debug)]
pub struct Held<S: Narrow> {
    cylinders: Vec<Cylinder<S>>,
    ellipsoids: Vec<Ellipsoid<S>>,
    spheres: Vec<Sphere<S>>,
    cones: Vec<Cone<S>>,
    triangles: Vec<Triangle<S>>,
    planes: Vec<Plane<S>>,
    lamps: Vec<Lamp<S>>,
}

impl<S: Narrow> Default for Held<S> {
    fn default() -> Self {
        Self {
            cylinders: Vec::new(),
            ellipsoids: Vec::new(),
            spheres: Vec::new(),
            cones: Vec::new(),
            triangles: Vec::new(),
            planes: Vec::new(),
            lamps: Vec::new(),
        }
    }
}

impl<S: Narrow> Room<S> for Held<S> {
    fn copies<'c>(&'c mut self, scene: &Scene<S>, motions: &[Motion<S>]) -> Copies<'c, S> {
        for motion in motions {
            match motion.object {
                Object::Cylinder(_) => copy(&mut self.cylinders, scene.cylinders),
                Object::Ellipsoid(_) => copy(&mut self.ellipsoids, scene.ellipsoids),
                Object::Sphere(_) => copy(&mut self.spheres, scene.spheres),
                Object::Cone(_) => copy(&mut self.cones, scene.cones),
                Object::Triangle(_) => copy(&mut self.triangles, scene.triangles),
                Object::Plane(_) => copy(&mut self.planes, scene.planes),
                Object::Lamp(_) => copy(&mut self.lamps, scene.lamps),
                Object::Floor => {}
            }
        }
        let Self { cylinders, ellipsoids, spheres, cones, triangles, planes, lamps } = self;
        Copies { cylinders, ellipsoids, spheres, cones, triangles, planes, lamps }
    }
}

/// Copies a list, unless that was done.
fn copy<T: Copy>(copy: &mut Vec<T>, list: &[T]) {
    if copy.len() != list.len() {
        *copy = list.to_vec();
    }
}
