//! Acne: points of a lit convex object on its own that lie in a shadow although they face the lamp. There is nothing to
//! throw one but the object itself, by rounding.

use fastrand::Rng;
use rta_core::light::Incident;
use rta_core::needs::Everything;
use rta_core::range::Admitted;
use rta_core::scalar::Unit;
use rta_core::surface::Surface;
use rta_core::vector::{LengthVector, UnitVec3, UnitVector, Vector};
use rta_core::world::Seen;
use rta_scenes::description::{self, Description, FallOff, Lamp};
use rta_scenes::narrow::{Narrow, Narrowed, narrow};

use super::body::Body;
use super::cases::Case;
use super::exact::rounded;
use super::guard::guarded;
use super::outcome::Measured;
use super::triple::{Triple, add, magnitude, sphere, unit};

/// Points that share an eye and a lamp.
const BLOCK: usize = 64;
/// Objects of a scene that are looked at, the first ones.
const OBJECTS: usize = 8;

/// Looks at about `points` points of the convex objects of a case, each object on its own.
///
/// Half the time eye and lamp are the case's own, so that a lamp inside an object lights it from inside; else they are
/// anywhere around it, from touching to 100 times its size away. Most points are near the border between light and
/// dark, where the way to the lamp is flattest. Reflected rays have to leave the object as well.
pub(super) fn search<S: Narrow>(case: &Case, points: usize, rng: &mut Rng, measured: &mut Measured) {
    let lone: Vec<Description> = alone(&case.scene).take(OBJECTS).collect();
    if lone.is_empty() {
        return;
    }
    for (block, scene) in (0..points.div_ceil(BLOCK)).zip(lone.iter().cycle()) {
        let mut scene = case.stand.place(scene, rng);
        let Some(body) = Body::all(&scene).next() else { continue };
        if block / lone.len() % 2 == 1 || scene.lamps.is_empty() {
            let mut around = || {
                let far = body.extent() * (1.0 + magnitude(rng, -3.0, 2.0));
                add(body.surface(sphere(rng)), sphere(rng), far)
            };
            scene.camera.eye = around();
            scene.lamps = vec![Lamp {
                position: around(),
                color: [1.0; 3],
                radius: 0.0,
                fall_off: FallOff::OfModel,
                line: 0,
            }];
        }
        scene.lamps.truncate(1);
        let given = rounded::<S>(&scene);
        let Ok(narrowed) = narrow::<S>(&given, 1.0) else { continue };
        let Ok(admitted) = narrowed.admit() else { continue };
        let Some(lamp) = given.lamps.first() else { continue };
        let inside = body.holds(lamp.position);
        for _ in 0..BLOCK {
            let direction = toward(&body, given.camera.eye, lamp.position, rng);
            match guarded(|| look(&narrowed, &admitted, direction, inside)) {
                Ok(Some(true)) => measured.acne.of += 1,
                Ok(Some(false)) => {
                    measured.acne.of += 1;
                    measured.acne.points += 1;
                    measured.acne.first.get_or_insert_with(|| {
                        format!(
                            "{body:?}, eye {:?}, lamp {:?}, {direction:?}",
                            given.camera.eye, lamp.position
                        )
                    });
                }
                Ok(None) => {}
                Err(failure) => measured.failed(failure),
            }
        }
    }
}

/// Each convex object of a scene with the lamps, opaque.
fn alone(scene: &Description) -> impl Iterator<Item = Description> {
    let mut empty = scene.clone();
    empty.lamps.iter_mut().for_each(|lamp| lamp.radius = 0.0); // a reflected ray is not to meet it
    (empty.spheres, empty.ellipsoids, empty.cylinders, empty.cones) = Default::default();
    (empty.triangles, empty.planes) = Default::default();
    empty.floor = None;
    let spheres = scene.spheres.iter().cloned().map(|mut sphere| {
        sphere.surface = description::Surface::Opaque;
        Description { spheres: vec![sphere], ..empty.clone() }
    });
    let ellipsoids = scene.ellipsoids.iter().cloned().map(|mut ellipsoid| {
        ellipsoid.surface = description::Surface::Opaque;
        Description { ellipsoids: vec![ellipsoid], ..empty.clone() }
    });
    let cylinders = scene.cylinders.iter().cloned().map(|mut cylinder| {
        cylinder.surface = description::Surface::Opaque;
        Description { cylinders: vec![cylinder], ..empty.clone() }
    });
    let cones = scene.cones.iter().cloned().map(|mut cone| {
        cone.surface = description::Surface::Opaque;
        // Without ends it is not convex: light falls in.
        cone.capped = true;
        Description { cones: vec![cone], ..empty.clone() }
    });
    spheres.chain(ellipsoids).chain(cylinders).chain(cones).collect::<Vec<_>>().into_iter()
}

/// A direction from the eye to the object: near its silhouette, anywhere, or near the border of light and dark.
fn toward(body: &Body, eye: Triple, lamp: Triple, rng: &mut Rng) -> Triple {
    match rng.u8(..4) {
        0 => body.past(eye, 1.0 - magnitude(rng, -9.0, 0.0), rng),
        1 => body.past(eye, rng.f64().sqrt(), rng),
        _ => match body.border(lamp, rng) {
            Some(place) => unit(add(place, eye, -1.0)),
            None => sphere(rng),
        },
    }
}

/// Whether the point in that direction sees the lamp and lets a reflected ray go; nothing if there is no such point, or
/// one that the lamp is on the other side of.
fn look<S: Narrow>(
    narrowed: &Narrowed<S>,
    scene: &Admitted<S>,
    direction: Triple,
    lamp_inside: bool,
) -> Option<bool> {
    let [x, y, z] = direction.map(S::unit);
    let direction: UnitVec3<S> = Vector::new(x, y, z);
    let ray = scene.ray::<Everything>(narrowed.camera.eye, direction);
    let hit = scene.closest::<Everything>(&ray)?;
    let Seen::Surface(surface) = scene.seen::<Everything>(&ray, Some(hit)) else { return None };
    let Surface { point, normal, inside, extent, .. } = surface;
    let incident = Incident::new(narrowed.lamps.first()?, point, normal)?;
    if incident.cosine <= S::Unit::ZERO || inside != lamp_inside {
        return None;
    }
    let (start, used) = point.leave(normal, incident.direction, extent);
    let shadow = scene.ray::<Everything>(start, incident.direction);
    let lit = scene.transmittance::<Everything>(&shadow, incident.distance - used, 0) == S::Unit::ONE;
    let reflected = direction.reflect(normal);
    let (start, _) = point.leave(normal, reflected, extent);
    // From inside, a reflected ray meets the object again, as it must.
    let away = inside || scene.closest::<Everything>(&scene.ray::<Everything>(start, reflected)).is_none();
    Some(lit && away)
}
