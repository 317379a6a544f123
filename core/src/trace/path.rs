//! Paths of light, each followed to its end: what every other way of computing a picture is measured by.
//!
//! J. Kajiya, "The Rendering Equation", SIGGRAPH 86. Each sample of a pixel is one path. At each point that it meets, lamps are asked for
//! their light by a shadow ray, and then the path goes on in one direction by chance: as the diffuse light of all sides arrives, or as a
//! mirror or glass reflects or refracts it, smooth or rough. Its light is divided by the chance of that, so that the mean of many paths is
//! the light that arrives, with all the light that surfaces send each other. It replaces the scene's ambient light, and no term of a model
//! stands for it; a path that meets nothing ends in the sky.
//!
//! Of the model of illumination, [`Illumination::diffuse`] and [`Illumination::secondary`] are asked, and how its lamps and its air make light
//! less. A highlight is the image of a lamp in a rough mirror, and here it is just that: smooth mirrors show lamps that have a size, and
//! none that are points.
//!
//! The noise of a picture falls with the root of the number of paths or faster. In fixed point weights round and the largest saturate;
//! pictures are the same on all machines there, but no error is promised.

mod lamps;
mod lobes;

pub use lamps::{Asked, Emitter};
use lobes::{Left, Lobes, scaled};

use super::decision::Start;
use super::dice::{Sample, Thrown};
use super::distributed::Distributed;
use super::{Observer, Trace};
use crate::accelerator::{Accelerator, Lists};
use crate::camera::Camera;
use crate::color::Rgb;
use crate::illumination::{Illumination, Way, Weight};
use crate::needs::Needs;
use crate::ray::RayKind;
use crate::sampling::pairs::Purpose;
use crate::scalar::vector::{UnitVec3, Vec3};
use crate::scalar::{Light, Positive, Scalar, Unit};
use crate::scene::{Hit, Object};
use crate::surface::Surface;
use crate::world::Seen;

/// How paths are followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rules {
    /// The most bounces of a path between the eye and the surface, the sky or the lamp where its light comes from.
    pub bounces: u8,
    /// The first bounce at which any path may end by chance (Russian roulette; J. Arvo and D. Kirk, "Particle Transport and Image Synthesis",
    /// SIGGRAPH 90): it goes on with the chance of 4/3 of its largest register, .95 at most. Before it, paths end so whose registers are all
    /// below 3/4, and no others. `None` if none ends.
    pub roulette: Option<u8>,
    /// How lamps are asked at the points that a path meets.
    pub lamps: Asked,
    /// Whether lamps that paths meet as well are weighed against those meetings: E. Veach and L. Guibas, "Optimally Combining Sampling
    /// Techniques for Monte Carlo Rendering", SIGGRAPH 95, the balance heuristic. Otherwise diffuse surfaces see such lamps by shadow
    /// rays alone, and rough mirrors by the paths alone.
    pub weighs: bool,
}

impl Default for Rules {
    /// 64 bounces at most, roulette for any path from the fourth, one lamp at each point, weighed.
    fn default() -> Self {
        Self { bounces: 64, roulette: Some(4), lamps: Asked::One, weighs: true }
    }
}

/// A tracer that follows one path for each sample.
#[derive(Clone, Copy, Debug)]
pub struct Paths<'a, S: Scalar, M, N, const STACK: usize, A = Lists> {
    /// The tracer, what spreads, and the seed. Lamps are asked at any of their places, whatever is said of that; the tracer's depth and its
    /// cut-off are for ray trees.
    pub spread: Distributed<'a, S, M, N, STACK, A>,
    /// The lamps whose light paths meet on triangles, in the order of their numbers and of those of the triangles.
    pub emitters: &'a [Emitter<S>],
    /// How they are followed.
    pub rules: Rules,
}

/// Where a path goes next.
struct Path<S: Scalar> {
    start: Start<S>,
    kind: RayKind,
    /// What of the light from there arrives in the pixel, over the chance that the path goes there.
    weight: Rgb<S::Power>,
    /// How the path left the surface before.
    left: Left<S>,
}

impl<'a, S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize, A: Accelerator<S>>
    Paths<'a, S, M, N, STACK, A>
{
    /// Returns the light of a path.
    fn follow<O: Observer<S> + ?Sized>(
        &self,
        start: Start<S>,
        dice: &Thrown<S>,
        memory: &mut A::Memory,
        observer: &mut O,
    ) -> Rgb<S::Light> {
        let whole = S::Unit::ONE.positive();
        let weight = Rgb::new(whole, whole, whole);
        let mut path = Path { start, kind: RayKind::Primary, weight, left: Left::Sharp };
        let mut light = Rgb::BLACK;
        for bounce in 0..=self.rules.bounces {
            let mut own = Rgb::BLACK;
            let next = self.step(path, (bounce, dice), &mut own, memory, observer);
            observer.light(own);
            light = light.plus(own);
            match next {
                Some(next) => path = next,
                None => break,
            }
        }
        light
    }

    /// Follows a path to the next thing that it meets, which is `bounce` bounces away from the eye. Adds what arrives from there to the
    /// light, and returns where the path goes on.
    fn step<O: Observer<S> + ?Sized>(
        &self,
        mut path: Path<S>,
        (bounce, dice): (u8, &Thrown<S>),
        light: &mut Rgb<S::Light>,
        memory: &mut A::Memory,
        observer: &mut O,
    ) -> Option<Path<S>> {
        let tracer = &self.spread.tracer;
        observer.ray(path.kind, bounce, &path.start);
        let ray = tracer.ray(path.start);
        let hit = tracer.scene.accelerator().closest::<N>(tracer.scene, &ray, memory);
        let ray = if A::WITH_PLAN { ray } else { tracer.scene.planned::<N>(ray, hit.as_ref()) };
        let (met, sent) = match tracer.scene.seen::<N>(&ray, hit) {
            Seen::Light(sent) => (None, sent),
            Seen::Surface(mut surface) => {
                if let Some(hit) = &hit {
                    tracer.scene.cover::<N>(&mut surface, hit.object, path.kind);
                }
                let is_bright = N::EMISSION && !tracer.scene.scene.coats.is_empty();
                let sent =
                    if is_bright { tracer.scene.emitted(surface.number, surface.inside) } else { Rgb::BLACK };
                (Some(surface), sent)
            }
        };
        observer.hit(hit.as_ref(), met.as_ref());
        if M::ALONG {
            self.pass(&mut path, (hit.as_ref(), met.as_ref()), light, memory);
        }
        if sent != Rgb::BLACK {
            let part = self.counted(&path.left, path.start.direction, hit.as_ref(), met.as_ref());
            *light = light.plus(scaled::<S>(sent.map(|light| light.times(part)), path.weight));
        }
        let surface = met?;
        // Node 1 is where the ray from the eye ends.
        let node = u32::from(bounce) + 1;
        let most = self.rules.roulette.map(|first| {
            let may_all_end = bounce.saturating_add(1) >= first;
            if may_all_end { S::Unit::ratio(19, 20) } else { S::Unit::ONE }
        });
        let lobes = Lobes::of::<M, N>(&tracer.model, &surface, (dice, node), (path.weight, most));
        if lobes.is_black() {
            return None;
        }
        if bounce == self.rules.bounces {
            observer.cut();
            return None;
        }
        // Where there is nothing to choose, no numbers are drawn for it.
        let asks_one = self.rules.lamps == Asked::One && self.count() > 1;
        let [which, how] =
            if asks_one || lobes.is_rough() { dice.words(Purpose::Choice, node) } else { [0; 2] };
        let direct = self.lit((&surface, &lobes), (which, dice, node), memory, observer);
        *light = light.plus(scaled::<S>(direct, path.weight));
        let (lobe, pair) = lobes.choose(dice.words(Purpose::Lobe, node), how)?;
        let next = lobes.follow::<N>(lobe, &surface, pair)?;
        let weight = path.weight.zip(next.part, Positive::times);
        if N::SURROUNDINGS && surface.surroundings && lobe == lobes::REFLECTED {
            let sky = tracer.scene.scene.radiance::<N>(next.start.direction);
            *light = light.plus(scaled::<S>(sky, weight));
            return None;
        }
        let kind = if lobe == lobes::TRANSMITTED { RayKind::Transmitted } else { RayKind::Reflected };
        Some(Path { start: next.start, kind, weight, left: next.left })
    }

    /// Takes from a path what is lost on the way to what it meets, and adds the light that is scattered into it on the way.
    fn pass(
        &self,
        path: &mut Path<S>,
        (hit, surface): (Option<&Hit<S>>, Option<&Surface<'a, S>>),
        light: &mut Rgb<S::Light>,
        memory: &mut A::Memory,
    ) {
        let tracer = &self.spread.tracer;
        let (kind, start, lamps) = (path.kind, path.start, tracer.scene.scene.lamps);
        let length = hit.map(|hit| hit.distance);
        let way = Way { kind, start, length, surface, shift: None, lamps };
        let lit = |place, lamp| tracer.reached(place, lamp, memory);
        if let Some(passage) = tracer.model.along::<N>(&way, lit) {
            *light = light.plus(scaled::<S>(passage.veil, path.weight));
            let left = passage.weight.registers().map(S::Unit::positive);
            path.weight = path.weight.zip(left, Positive::times);
        }
    }

    /// Returns the part, 0 to 1, that counts of the light of what a path meets in a direction: not what shadow rays have told already.
    fn counted(
        &self,
        left: &Left<S>,
        direction: UnitVec3<S>,
        hit: Option<&Hit<S>>,
        surface: Option<&Surface<S>>,
    ) -> S::Unit {
        let Some(hit) = hit else { return S::Unit::ONE };
        let emitter = match (hit.object, surface) {
            (Object::Lamp(number), None) => return self.counted_of(left, (number, direction), None),
            (Object::Triangle(number), Some(_)) => self.emitter_of(number),
            _ => None,
        };
        match (emitter, surface) {
            (Some(emitter), Some(surface)) => {
                self.counted_of(left, (emitter.lamp, direction), Some((emitter, surface)))
            }
            _ => S::Unit::ONE,
        }
    }
}

impl<S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize, A: Accelerator<S>> Trace<S>
    for Paths<'_, S, M, N, STACK, A>
{
    type Memory = A::Memory;
    const SPREADS: bool = true;

    /// As sample 0 of the first pixel.
    fn trace<O: Observer<S> + ?Sized>(
        &self,
        origin: Vec3<S>,
        direction: UnitVec3<S>,
        memory: &mut A::Memory,
        observer: &mut O,
    ) -> Rgb<S::Light> {
        self.follow(Start { origin, direction }, &self.spread.dice(Sample::default()), memory, observer)
    }

    fn sample<O: Observer<S> + ?Sized>(
        &self,
        camera: &Camera<S>,
        place: (S::Unit, S::Unit),
        sample: Sample,
        memory: &mut A::Memory,
        observer: &mut O,
    ) -> Rgb<S::Light> {
        let dice = self.spread.dice(sample);
        self.follow(self.spread.start(camera, place, &dice), &dice, memory, observer)
    }
}

#[cfg(test)]
#[cfg(feature = "f64")]
#[allow(clippy::indexing_slicing, reason = "a test may panic")]
mod tests;
