//! Paths: how camera, lamps and objects move in the frames of a film.

use rta_core::scene::Object;

use super::{Description, LampShape};
use crate::space::{Triple, difference, unit};

/// A path through space. What moves along it stands where the scene places it at the instant 0, and from there on is moved by what the
/// path has moved since then.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    /// Its name.
    pub name: String,
    /// Whether it goes straight from place to place; otherwise it is a Catmull-Rom spline through them.
    pub linear: bool,
    /// At least two, from the earliest to the latest.
    pub keyframes: Vec<Keyframe>,
}

/// An instant and where a path is then.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Keyframe {
    /// From 0, the beginning of the film, to 1, its end.
    pub time: f64,
    /// A place.
    pub place: [f64; 3],
}

/// How the camera moves.
#[derive(Clone, Debug, PartialEq)]
pub struct Journey {
    /// The path of the eye, by its name.
    pub path: String,
    /// The place that the camera looks at all the time; without it, its direction stays.
    pub aim: Option<[f64; 3]>,
}

impl Path {
    /// Returns where the path is at an instant. Before the first keyframe and after the last it stands still.
    ///
    /// Between keyframes it is a cubic Hermite curve whose velocity at a keyframe is that from its neighbour before to its neighbour
    /// behind (E. Catmull and R. Rom, "A Class of Local Interpolating Splines", Computer Aided Geometric Design, 1974, for keyframes that
    /// need not be equally far apart). At the ends it is that to the only neighbour; a path from 0 to 1 that ends where it begins goes
    /// round, and has its neighbours across the seam.
    #[must_use]
    pub fn place(&self, instant: f64) -> [f64; 3] {
        let keys = &self.keyframes;
        let behind = keys.iter().position(|key| key.time > instant).unwrap_or(keys.len());
        let (Some(from), Some(to)) =
            (behind.checked_sub(1).and_then(|before| keys.get(before)), keys.get(behind))
        else {
            let end = if behind == 0 { keys.first() } else { keys.last() };
            return end.map_or([0.0; 3], |end| end.place);
        };
        let span = to.time - from.time;
        let s = (instant - from.time) / span;
        let [before, after] = [self.velocity(behind - 1, span), self.velocity(behind, span)];
        let place = core::array::from_fn(|axis| {
            let [a, b, u, v] = [&from.place, &to.place, &before, &after].map(|of| component(of, axis));
            if self.linear {
                return a + (b - a) * s;
            }
            let (rest, turned) = (1.0 - s, 3.0 - 2.0 * s);
            (1.0 - s * s * turned) * a + s * s * turned * b + s * rest * (rest * u - s * v)
        });
        // Between places as far apart as f64 has them there may be none.
        if place.iter().all(|part| part.is_finite()) { place } else { from.place }
    }

    /// Returns how far the path goes in the time `span` at the speed that it has at a keyframe.
    fn velocity(&self, key: usize, span: f64) -> Triple {
        let keys = &self.keyframes;
        let last = keys.len().saturating_sub(1);
        let goes_round = keys
            .first()
            .zip(keys.last())
            .is_some_and(|(first, last)| first.place == last.place && first.time == 0.0 && last.time == 1.0);
        // The keyframe, and how many films later.
        let (before, behind) = match key {
            0 if goes_round => ((last.saturating_sub(1), -1.0), (1, 0.0)),
            0 => ((0, 0.0), (1, 0.0)),
            _ if key < last => ((key - 1, 0.0), (key + 1, 0.0)),
            _ if goes_round => ((key - 1, 0.0), (1, 1.0)),
            _ => ((key - 1, 0.0), (key, 0.0)),
        };
        let [Some(before), Some(behind)] = [before, behind]
            .map(|(key, films)| keys.get(key).map(|key| Keyframe { time: key.time + films, ..*key }))
        else {
            return [0.0; 3];
        };
        let share = span / (behind.time - before.time);
        difference(behind.place, before.place).map(|part| part * share)
    }

    /// Returns how far the path has moved what goes along it at an instant.
    fn moved(&self, instant: f64) -> Triple {
        difference(self.place(instant), self.place(0.0))
    }
}

fn component(place: &Triple, axis: usize) -> f64 {
    place.get(axis).copied().unwrap_or_default()
}

/// Moves a place.
fn shift(place: &mut Triple, by: Triple) {
    for (part, by) in place.iter_mut().zip(by) {
        *part = (*part + by).clamp(f64::MIN, f64::MAX);
    }
}

impl Description {
    /// Returns whether anything moves.
    #[must_use]
    pub fn moves(&self) -> bool {
        let details = &self.details;
        details.journey.is_some()
            || !details.lamp_paths.is_empty()
            || details.objects.values().any(|detail| detail.along.is_some())
    }

    /// Returns the scene as it is at an instant of the film, 0 to 1: one in which nothing moves. At 0 it is as its statements have it.
    ///
    /// A camera that would stand in the place that it looks at keeps its direction. Textures stay where they are.
    #[must_use]
    pub fn at(&self, instant: f64) -> Self {
        let mut scene = self.clone();
        let paths = core::mem::take(&mut scene.details.paths);
        let moved = |name: &str| {
            let path = paths.iter().find(|path| path.name == name);
            path.map_or([0.0; 3], |path| path.moved(instant))
        };
        if let Some(Journey { path, aim }) = scene.details.journey.take() {
            shift(&mut scene.camera.eye, moved(&path));
            let view = aim.map(|aim| difference(aim, scene.camera.eye));
            if let Some(view) = view.filter(|view| unit(*view).is_some()) {
                scene.camera.view = view;
            }
        }
        for (number, path) in core::mem::take(&mut scene.details.lamp_paths) {
            let by = moved(&path);
            if let Some(lamp) = scene.lamps.get_mut(number) {
                shift(&mut lamp.position, by);
            }
            if let Some(LampShape::Area { corner, .. }) = scene.details.lamps.get_mut(&number) {
                shift(corner, by);
            }
        }
        let mut details = core::mem::take(&mut scene.details.objects);
        for (object, detail) in &mut details {
            if let Some(path) = detail.along.take() {
                scene.shift(*object, moved(&path));
            }
        }
        details.retain(|_, detail| *detail != Default::default());
        scene.details.objects = details;
        scene
    }

    /// Returns whether something moves while the shutter is open.
    #[must_use]
    pub fn has_motion(&self) -> bool {
        self.details.objects.values().any(|detail| detail.moves.is_some())
    }

    /// Returns when the shutter opens and closes: from 0 to 1 where nothing is said.
    fn shutter(&self) -> [f64; 2] {
        self.optics.shutter.unwrap_or([0.0, 1.0])
    }

    /// Returns the scene as it is in the middle of the time that the shutter is open, from -1/2 to 1/2.
    #[must_use]
    pub fn in_the_middle(&self) -> Self {
        let mut scene = self.clone();
        let [opening, closing] = self.shutter();
        for (&object, detail) in &self.details.objects {
            if let Some(moves) = detail.moves {
                scene.shift(object, moves.map(|c| c * f64::midpoint(opening, closing)));
            }
        }
        for moves in scene.details.objects.values_mut().filter_map(|detail| detail.moves.as_mut()) {
            moves.iter_mut().for_each(|c| *c *= closing - opening);
        }
        scene.optics.shutter = Some([-0.5, 0.5]);
        scene
    }

    /// Returns the scene as it is in the middle of the time that the shutter is open, in which nothing moves.
    #[must_use]
    pub fn stopped(&self) -> Self {
        let mut scene = self.in_the_middle();
        scene.details.objects.values_mut().for_each(|detail| detail.moves = None);
        scene
    }

    /// Returns how far an object is moved when the shutter opens and when it closes.
    pub(crate) fn swept(&self, object: Object) -> Option<[Triple; 2]> {
        let moves = self.details.objects.get(&object)?.moves?;
        Some(self.shutter().map(|time| moves.map(|c| c * time)))
    }

    /// Returns the places of an object that move with it: its centre, the ends of its axis, or its corners.
    pub(crate) fn places(&self, object: Object) -> Vec<Triple> {
        let place = |number: u32| usize::try_from(number).unwrap_or(usize::MAX);
        match object {
            Object::Ellipsoid(i) => self.ellipsoids.get(place(i)).map(|own| vec![own.position]),
            Object::Sphere(i) => self.spheres.get(place(i)).map(|own| vec![own.position]),
            Object::Cylinder(i) => {
                self.cylinders.get(place(i)).map(|own| vec![[own.position[0], own.position[1], 0.0]])
            }
            Object::Plane(i) => self.planes.get(place(i)).map(|own| vec![own.point]),
            Object::Cone(i) => self.cones.get(place(i)).map(|own| vec![own.base, own.apex]),
            Object::Triangle(i) => self.triangles.get(place(i)).map(|own| own.vertices.to_vec()),
            _ => None,
        }
        .unwrap_or_default()
    }

    /// Moves an object.
    fn shift(&mut self, object: Object, by: Triple) {
        let place = |number: u32| usize::try_from(number).unwrap_or(usize::MAX);
        let one = |object: Option<&mut Triple>| object.map_or((), |object| shift(object, by));
        match object {
            Object::Ellipsoid(i) => one(self.ellipsoids.get_mut(place(i)).map(|own| &mut own.position)),
            Object::Sphere(i) => one(self.spheres.get_mut(place(i)).map(|own| &mut own.position)),
            Object::Cylinder(i) => one(self.cylinders.get_mut(place(i)).map(|own| &mut own.position)),
            Object::Plane(i) => one(self.planes.get_mut(place(i)).map(|own| &mut own.point)),
            Object::Cone(i) => {
                if let Some(own) = self.cones.get_mut(place(i)) {
                    shift(&mut own.base, by);
                    shift(&mut own.apex, by);
                }
            }
            Object::Triangle(i) => {
                let own = self.triangles.get_mut(place(i));
                own.into_iter().flat_map(|own| &mut own.vertices).for_each(|vertex| shift(vertex, by));
            }
            _ => {}
        }
    }
}
