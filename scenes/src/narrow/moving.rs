//! What moves while the shutter is open, in one number format.

use rta_core::Error;
use rta_core::accelerator::Accelerator;
use rta_core::light::Lamp;
use rta_core::scene::{Copies, Limits, Object, Scene};
use rta_core::shape::{Cone, Cylinder, Ellipsoid, Plane, Sphere, Triangle};
use rta_core::trace::moving::{Motion, Room, moved};
use rta_core::vector::Vec3;

use super::check::Checker;
use super::{Narrow, NarrowError, Narrowed};
use crate::description::Description;

/// Returns how the objects of a scene move, which is as it is in the [middle](Description::in_the_middle) of the time.
pub(super) fn motions<S: Narrow>(description: &Description) -> Result<Vec<Motion<S>>, NarrowError> {
    let details = &description.details;
    let objects = details.objects.iter().filter_map(|(&object, detail)| Some((object, detail.moves?)));
    let lamp = |(&number, &by): (&usize, &[f64; 3])| Some((Object::Lamp(u32::try_from(number).ok()?), by));
    let lamps = details.lamp_moves.iter().filter_map(lamp);
    let check = Checker::<S>::named("the motion of an object");
    let one = |(object, by)| {
        let motion = Motion { object, by: check.place(by, 0.0)? };
        description.places(object).into_iter().try_for_each(|place| ends(&check, place, by))?;
        Ok(motion)
    };
    objects.chain(lamps).map(one).collect()
}

/// Returns how far the eye moves, if it does.
pub(super) fn eye<S: Narrow>(description: &Description) -> Result<Option<Vec3<S>>, NarrowError> {
    let Some(by) = description.optics.moves else { return Ok(None) };
    let check = Checker::<S>::named("the motion of the eye");
    ends(&check, description.camera.eye, by)?;
    check.place(by, 0.0).map(Some)
}

/// Checks where a place is when the shutter opens and when it closes.
fn ends<S: Narrow>(check: &Checker<S>, place: [f64; 3], by: [f64; 3]) -> Result<(), NarrowError> {
    [-0.5, 0.5].into_iter().try_for_each(|half| {
        let mut end = place;
        end.iter_mut().zip(by).for_each(|(c, by)| *c += half * by);
        check.place(end, 0.0).map(|_| ())
    })
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
        if self.spreads.motions.is_empty() && self.spreads.eye.is_none() {
            return Vec::new();
        }
        let half = S::unit(0.5);
        [-half, half]
            .map(|time| {
                let mut end = self.clone();
                let Self { cylinders, ellipsoids, spheres, cones, triangles, planes, lamps, .. } = &mut end;
                let mut copies = Copies { cylinders, ellipsoids, spheres, cones, triangles, planes, lamps };
                self.spreads.motions.iter().for_each(|motion| motion.put(&mut copies, &self.scene(), time));
                if let Some(by) = self.spreads.eye {
                    end.camera.eye = end.camera.eye + moved::<S>(by, time);
                }
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
