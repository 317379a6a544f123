//! What moves while the shutter is open, in one number format.

use rta_core::Error;
use rta_core::accelerator::Accelerator;
use rta_core::light::Lamp;
use rta_core::scene::{Copies, Limits, Object, Scene};
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
    let one = |(object, by): (Object, [f64; 3])| {
        let motion = Motion { object, by: check.place(by, 0.0)? };
        // Where it is when the shutter opens and when it closes.
        for place in description.places(object) {
            for half in [-0.5, 0.5] {
                let mut end = place;
                end.iter_mut().zip(by).for_each(|(c, by)| *c += half * by);
                check.place(end, 0.0)?;
            }
        }
        Ok(motion)
    };
    moving.map(one).collect()
}

/// Proves that a scene, searched by an accelerator, fits its format: from all of its lens, and as long as the shutter is open.
pub(crate) fn proved<S: Narrow, A: Accelerator<S> + Copy>(
    scene: &Narrowed<S>,
    accelerator: A,
) -> Result<Limits<S>, Error> {
    let one = |scene: &Narrowed<S>| {
        let (own, camera) = (scene.scene(), &scene.camera);
        let admitted = match &scene.spreads.aperture {
            Some(aperture) => own.admit_lens((camera, aperture), accelerator),
            None => own.admit_with(camera, accelerator),
        };
        Ok(admitted?.limits)
    };
    // What holds when the shutter opens and when it closes does so in between, as everything moves along straight lines.
    scene.ends().iter().map(one).try_fold(one(scene)?, |all, end| Ok(all.with(&end?)))
}

impl<S: Narrow> Narrowed<S> {
    /// Returns the scene as it is when the shutter opens and when it closes; nothing where nothing moves.
    fn ends(&self) -> Vec<Self> {
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
