//! Paths: how camera, lamps and objects move in the frames of a film.

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

    /// Returns whether the path ends where it begins, as a film that is shown again and again does.
    fn goes_round(&self) -> bool {
        let ends = self.keyframes.first().zip(self.keyframes.last());
        ends.is_some_and(|(first, last)| first.place == last.place && first.time == 0.0 && last.time == 1.0)
    }

    /// Returns how far the path goes in the time `span` at the speed that it has at a keyframe.
    fn velocity(&self, key: usize, span: f64) -> Triple {
        let keys = &self.keyframes;
        let last = keys.len().saturating_sub(1);
        let goes_round = self.goes_round();
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

    /// Returns how far the path has moved what goes along it at an instant. Beyond the end of a film one that goes round does so.
    fn moved(&self, instant: f64) -> Triple {
        let is_within = (0.0..=1.0).contains(&instant) || !self.goes_round();
        difference(self.place(if is_within { instant } else { instant.rem_euclid(1.0) }), self.place(0.0))
    }

    /// Returns how the path carries what goes along it at an instant, while a shutter with times of its own is open.
    fn carried(&self, instant: f64, shutter: Option<[f64; 2]>) -> Carried {
        let Some([opening, closing]) = shutter else {
            let by = self.moved(instant);
            return Carried { by, moves: None, middle: by };
        };
        let [from, to] = [opening, closing].map(|time| self.moved(instant + time));
        // A shutter that opens for no time at all shows where the path is then.
        let velocity = if closing == opening { 0.0 } else { 1.0 / (closing - opening) };
        let moves = difference(to, from).map(|part| (part * velocity).clamp(f64::MIN, f64::MAX));
        let at = |time: f64| {
            let mut by = from;
            shift(&mut by, moves.map(|part| part * (time - opening)));
            by
        };
        Carried { by: at(0.0), moves: Some(moves), middle: at(f64::midpoint(opening, closing)) }
    }
}

/// How a path carries what goes along it.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Carried {
    /// How far it is carried at the instant itself, from where it stands.
    pub(super) by: Triple,
    /// How far it moves from there in the time from 0 to 1; `None` where nothing moves while the shutter is open.
    pub(super) moves: Option<Triple>,
    /// How far it is carried in the middle of the time that the shutter is open.
    middle: Triple,
}

fn component(place: &Triple, axis: usize) -> f64 {
    place.get(axis).copied().unwrap_or_default()
}

/// Moves a place.
pub(super) fn shift(place: &mut Triple, by: Triple) {
    for (part, by) in place.iter_mut().zip(by) {
        *part = (*part + by).clamp(f64::MIN, f64::MAX);
    }
}

impl Description {
    /// Returns whether anything goes along a path.
    #[must_use]
    pub fn moves(&self) -> bool {
        let details = &self.details;
        details.journey.is_some()
            || !details.lamp_paths.is_empty()
            || details.objects.values().any(|detail| detail.along.is_some())
    }

    /// Returns the scene as it is at an instant of the film, 0 to 1: one in which nothing goes along a path. At 0 it is as its statements have
    /// it.
    ///
    /// Where the shutter has times of its own, what goes along a path has the path's velocity while it is open: it moves evenly from where
    /// the path is when the shutter opens to where it is when it closes.
    ///
    /// A camera that would stand in the place that it looks at keeps its direction. Textures stay where they are.
    #[must_use]
    pub fn at(&self, instant: f64) -> Self {
        let mut scene = self.clone();
        scene.details.paths.clear();
        let carried = |path: &str| self.carried(path, instant);
        if let Some(Journey { path, aim }) = scene.details.journey.take() {
            let Carried { by, moves, middle } = carried(&path);
            let seen_from = |mut eye: Triple| {
                shift(&mut eye, middle);
                eye
            };
            let view = aim.map(|aim| difference(aim, seen_from(scene.camera.eye)));
            shift(&mut scene.camera.eye, by);
            add(&mut scene.optics.moves, moves);
            if let Some(view) = view.filter(|view| unit(*view).is_some()) {
                scene.camera.view = view;
            }
        }
        for (number, path) in core::mem::take(&mut scene.details.lamp_paths) {
            let Carried { by, moves, .. } = carried(&path);
            scene.shift_lamp(number, by);
            if let Some(moves) = moves {
                let all = scene.details.lamp_moves.entry(number).or_default();
                shift(all, moves);
            }
        }
        let mut details = core::mem::take(&mut scene.details.objects);
        for (object, detail) in &mut details {
            if let Some(path) = detail.along.take() {
                let Carried { by, moves, .. } = carried(&path);
                scene.shift(*object, by);
                add(&mut detail.moves, moves);
            }
        }
        details.retain(|_, detail| *detail != Default::default());
        scene.details.objects = details;
        scene
    }

    /// Returns how a path carries what goes along it at an instant.
    pub(super) fn carried(&self, path: &str, instant: f64) -> Carried {
        let path = self.details.paths.iter().find(|own| own.name == path);
        path.map_or(Carried::default(), |path| path.carried(instant, self.optics.shutter))
    }

    /// Moves a lamp, by its number from 0.
    pub(super) fn shift_lamp(&mut self, number: usize, by: Triple) {
        if let Some(lamp) = self.lamps.get_mut(number) {
            shift(&mut lamp.position, by);
        }
        if let Some(LampShape::Area { corner, .. }) = self.details.lamps.get_mut(&number) {
            shift(corner, by);
        }
    }
}

/// Adds how far something moves along a path to how far it moves besides.
fn add(all: &mut Option<Triple>, moves: Option<Triple>) {
    if let Some(moves) = moves {
        shift(all.get_or_insert_default(), moves);
    }
}
