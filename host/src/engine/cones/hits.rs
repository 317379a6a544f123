//! What a cone meets: the parts of it that things cover, from near to far.

use core::ops::ControlFlow;

use rta_core::needs::Everything;
use rta_core::ray::Ray;
use rta_core::scalar::Scalar;
use rta_core::scene::{Object, Visit};
use rta_core::shape::{Look, Primitive, Sphere};
use rta_core::vector::Vec3;
use rta_core::world::World;

use super::beam::Beam;
use super::cover::Covered;
use super::order::{Body, Met, Own, sort};
use super::outline::convex;

/// The most things that a cone keeps apart; the parts of those behind are given to the last of them.
pub const MOST: usize = 8;

/// What a cone has just left, which it cannot meet at once.
#[derive(Clone, Copy, Debug)]
pub struct Left {
    /// The thing: itself, if it is flat, or if the cone is outside of it.
    pub object: Object,
    /// Whether the cone is outside of it, where it meets no other face of a convex body either.
    pub is_outside: bool,
}

/// All that a cone meets.
#[derive(Clone, Debug)]
pub struct Hits {
    /// The things, from near to far.
    pub met: Vec<Met>,
    /// The part that is left of the cone behind all of them.
    pub left: f64,
}

/// A scene whose things are looked for in cones.
#[derive(Clone, Copy, Debug)]
pub struct Search<'s> {
    /// The scene.
    pub world: &'s World<'s, f64>,
    /// The bodies of the triangles, by a number for each.
    pub bodies: &'s [u32],
}

impl Search<'_> {
    /// Returns which body a thing is, or is a face of.
    fn own(&self, object: Object) -> Own {
        let body = match object {
            Object::Triangle(number) => self.bodies.get(number as usize).copied(),
            _ => None,
        };
        body.map_or(Own::Thing(object), Own::Faces)
    }

    /// Returns what a cone meets.
    pub fn hits(&self, beam: &Beam, left: Option<Left>) -> Hits {
        let mut found = Found { search: self, beam, left, met: Vec::new() };
        found.floor();
        found.lamps();
        // It never ends the search.
        let _ = self.world.scene.each::<Everything>(&mut found);
        let mut met = found.met;
        sort(&mut met, |object, ray| self.distance(object, ray));
        seen(met)
    }

    /// Returns the distance at which a ray meets a thing, if it does.
    fn distance(&self, object: Object, ray: &Ray<f64>) -> Option<f64> {
        struct Meeting<'r>(&'r Ray<f64>, Option<f64>);
        impl Visit<f64> for Meeting<'_> {
            fn run<P: Primitive<f64>>(&mut self, _first: Object, run: &[P]) -> ControlFlow<()> {
                self.1 = run.first().and_then(|primitive| primitive.intersect(self.0, f64::FAR));
                ControlFlow::Break(())
            }
        }
        let scene = &self.world.scene;
        match object {
            Object::Floor => scene.floor.as_ref().and_then(|floor| floor.intersect(ray)),
            Object::Lamp(i) => scene
                .lamps
                .get(i as usize)
                .and_then(|lamp| Sphere::distance(lamp.position, lamp.radius, ray, f64::FAR)),
            _ => {
                let mut meeting = Meeting(ray, None);
                // It ends with the one thing.
                let _ = scene.one::<Everything>(object, &mut meeting);
                meeting.1
            }
        }
    }
}

/// The visitor that collects what is in a cone.
struct Found<'f> {
    search: &'f Search<'f>,
    beam: &'f Beam,
    left: Option<Left>,
    met: Vec<Met>,
}

impl Found<'_> {
    fn floor(&mut self) {
        let world = self.search.world;
        let Some(floor) = &world.scene.floor else { return };
        let covered = self.beam.plane(Vec3::<f64>::Z, self.beam.origin.z);
        self.add((Object::Floor, false), covered, [0.0; 2], |ray| floor.intersect(ray));
    }

    fn lamps(&mut self) {
        for (i, lamp) in (0..).zip(self.search.world.scene.lamps) {
            if lamp.radius > 0.0 {
                let (center, radius) = (lamp.position, lamp.radius);
                let (covered, middle) = (self.beam.sphere(center, radius), self.beam.toward(center));
                let meet = |ray: &Ray<f64>| Sphere::distance(center, radius, ray, f64::FAR);
                self.add((Object::Lamp(i), false), covered, middle, meet);
            }
        }
    }

    /// Returns the ray at a place of the cone, with a plan where there are vertical cylinders.
    fn ray(&self, place: [f64; 2]) -> Ray<f64> {
        let Ray { origin, direction, .. } = self.beam.ray(place);
        self.search.world.ray::<Everything>(origin, direction)
    }

    /// Returns where the middle of a thing is seen; of an endless cylinder, the place of its axis that is nearest to that of the cone.
    fn inner(&self, object: Object, center: Vec3<f64>) -> [f64; 2] {
        let Object::Cylinder(_) = object else { return self.beam.toward(center) };
        let (axis, way) = (self.beam.axis, self.beam.origin - center);
        // Where the two lines are nearest: of a cone along the cylinder, beside its origin.
        let square = 1.0 - axis.z * axis.z;
        let along = if square > 1e-12 { (axis.z * way.z - way.dot(axis)) / square } else { 0.0 };
        let height = self.beam.origin.z + along.max(0.0) * axis.z;
        self.beam.toward(Vec3::<f64>::new(center.x, center.y, height))
    }

    /// Returns whether a thing is what the cone has just left: itself if it is not left to its inside, the faces in its plane, and those of its
    /// body that are seen from behind, out of which the edge of the cone seems to come.
    fn has_left(&self, object: Object, is_behind: bool) -> bool {
        let Some(left) = self.left else { return false };
        if object == left.object {
            return true;
        }
        let triangles = self.search.world.scene.triangles;
        let triangle = |object| match object {
            Object::Triangle(number) => triangles.get(number as usize),
            _ => None,
        };
        let (Some(own), Some(other)) = (triangle(left.object), triangle(object)) else { return false };
        let is_same = self.search.own(object) == self.search.own(left.object);
        let [corner, ..] = own.vertices;
        let height = |place: Vec3<f64>| (place - corner).dot(own.normal).abs();
        let is_level = other.vertices.into_iter().all(|place| height(place) <= 1e-9 * own.extent);
        is_level || (is_same && is_behind && left.is_outside)
    }

    /// Adds a thing that covers a part of the cone. The ray in the middle of the part tells where the cone meets it; where that misses it, as
    /// the outline is not quite as it is seen from here, one that is nearer to `middle`, the place where the thing's own middle is seen.
    fn add(
        &mut self,
        (object, is_behind): (Object, bool),
        covered: Option<Covered>,
        middle: [f64; 2],
        meet: impl Fn(&Ray<f64>) -> Option<f64>,
    ) {
        let Some(Covered { part, place: [x, y] }) = covered else { return };
        if self.has_left(object, is_behind) {
            return;
        }
        let between = |step: u32| {
            let step = f64::from(step) / 8.0;
            [x + (middle[0] - x) * step, y + (middle[1] - y) * step]
        };
        let hit = (0..=8).find_map(|step| {
            let ray = self.ray(between(step));
            meet(&ray).map(|distance| (ray, distance))
        });
        let Some((ray, distance)) = hit else { return };
        let along = (ray.origin + ray.direction * distance - self.beam.origin).dot(self.beam.axis);
        let body = Body { own: self.search.own(object), is_behind };
        self.met.push(Met { object, ray, distance, along, part, seen: 0.0, body });
    }
}

impl Visit<f64> for Found<'_> {
    fn run<P: Primitive<f64>>(&mut self, first: Object, run: &[P]) -> ControlFlow<()> {
        for (i, primitive) in (0..).zip(run) {
            let object = first.after(i);
            let Look { center, radius, .. } = primitive.look();
            if P::IS_FINITE && !self.beam.may_meet(center, radius) {
                continue;
            }
            let (scene, number) = (&self.search.world.scene, i as usize);
            let (covered, is_behind) = match object {
                Object::Sphere(_) => (self.beam.sphere(center, radius), false),
                Object::Plane(_) => scene.planes.get(number).map_or((None, false), |plane| {
                    let height = (self.beam.origin - plane.center).dot(plane.normal);
                    (self.beam.plane(plane.normal, height), false)
                }),
                Object::Triangle(_) => scene.triangles.get(number).map_or((None, false), |triangle| {
                    let [corner, ..] = triangle.vertices;
                    let is_behind = (self.beam.origin - corner).dot(triangle.normal) < 0.0;
                    let covered = (!(is_behind && triangle.one_sided)).then_some(triangle.vertices);
                    (covered.and_then(|corners| self.beam.polygon(corners)), is_behind)
                }),
                _ => {
                    let meets = |place| primitive.intersect(&self.ray(place), f64::FAR).is_some();
                    (convex(self.inner(object, center), meets), false)
                }
            };
            let middle = self.inner(object, center);
            self.add((object, is_behind), covered, middle, |ray| primitive.intersect(ray, f64::FAR));
        }
        ControlFlow::Continue(())
    }
}

/// Tells how much is seen of each thing, of what a cone meets from near to far: faces of one body beside each other, and what is left by
/// different bodies as if it were left by chance.
fn seen(mut met: Vec<Met>) -> Hits {
    let behind: f64 = met.iter().skip(MOST).map(|met| met.part).sum();
    met.truncate(MOST);
    if let Some(last) = met.last_mut() {
        last.part = (last.part + behind).min(1.0);
    }
    // What each body covers so far, by its faces that are seen from the front, and from behind.
    let mut bodies: Vec<(Own, [f64; 2])> = Vec::new();
    let mut left = 1.0;
    for met in &mut met {
        let known = bodies.iter().position(|(own, _)| *own == met.body.own);
        let known = known.unwrap_or_else(|| {
            bodies.push((met.body.own, [0.0; 2]));
            bodies.len() - 1
        });
        let Some((_, covered)) = bodies.get_mut(known) else { continue };
        let [front, back] = covered;
        let before = front.max(*back);
        let side = if met.body.is_behind { back } else { front };
        *side = (*side + met.part).min(1.0);
        let more = (covered[0].max(covered[1]) - before).max(0.0);
        // Of what the others leave.
        met.seen = if before < 1.0 { left * more / (1.0 - before) } else { 0.0 };
        left -= met.seen;
        if left < 1e-9 {
            left = 0.0;
        }
    }
    met.retain(|met| met.seen > 0.0);
    Hits { met, left }
}
