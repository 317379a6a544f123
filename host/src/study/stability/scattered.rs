//! Samples whose rays are spread, in one format beside `f64`: both spread them by the same numbers.

use fastrand::Rng;
use rta_core::raster::Raster;
use rta_core::ray::RayKind;
use rta_core::sampling::Places;
use rta_core::scene::{Hit, Object};
use rta_core::surface::Surface;
use rta_core::trace::Observer;
use rta_core::trace::decision::Start;
use rta_core::trace::dice::Sample;
use rta_packets::ShadowCache;
use rta_packets::picture::{Format, Picture, PictureError, Setup};
use rta_packets::tally::Tally;
use rta_scenes::description::Description;
use rta_scenes::narrow::Narrow;
use rta_scenes::sampler::{Sampler, Spreading};

use super::cases::Case;
use super::errors::Errors;
use super::exact::rounded;
use super::guard::guarded;
use super::outcome::Measured;

/// Pixels of a side: each sample is of another pixel, whose numbers are its own.
const SIDE: u32 = 1024;

/// Traces `count` samples from the scene's eye.
pub(super) fn block<S: Format>(
    case: &Case,
    (scene, spreading): (&Description, Spreading),
    count: usize,
    rng: &mut Rng,
    (measured, errors): (&mut Measured, &mut Errors),
) -> Result<(), PictureError> {
    let given = rounded::<S>(scene);
    let (tested, exact) =
        (pictures::<S>(case, &given, spreading)?, pictures::<f64>(case, &given, spreading)?);
    let mut unused = Seen::default();
    for (tested, exact) in tested.iter().zip(&exact).cycle().take(count) {
        let [x, y] = [(); 2].map(|()| rng.u32(0..SIDE));
        let sample = Sample { x, y, number: rng.u32(0..spreading.samples.samples()) };
        let mut seen = Seen::default();
        let light = guarded(|| light(&**tested, sample, &mut seen));
        let expected = guarded(|| self::light(&**exact, sample, &mut unused));
        measured.rays += seen.rays.0.iter().sum::<u64>();
        errors.take::<S>((light, seen.first), (expected, unused.first), measured);
    }
    Ok(())
}

/// The pictures of a case, one of each of its models.
type Pictures<S> = Vec<Box<dyn Picture<S>>>;

fn pictures<S: Format>(
    case: &Case,
    scene: &Description,
    spreading: Spreading,
) -> Result<Pictures<S>, PictureError> {
    let raster = Raster::new(SIDE, SIDE)?;
    let sampling = Sampler::Sobol(spreading);
    let setup = Setup { raster, aspect: 1.0, depth: case.depth, cutoff: None, sampling };
    case.models.iter().map(|&model| S::picture(scene, model, &setup)).collect()
}

fn light<S: Narrow>(
    picture: &dyn Picture<S>,
    sample: Sample,
    seen: &mut Seen,
) -> rta_core::color::Rgb<S::Light> {
    let Setup { raster, sampling, .. } = *picture.setup();
    let row = Places::row::<S::Unit>(&sampling, raster, sample.y);
    let place = sampling.place(raster, row, sample.x, sample.number);
    picture.sample(place, sample, &mut ShadowCache::default(), seen)
}

/// Counts rays, and keeps what the ray from the eye meets.
#[derive(Default)]
struct Seen {
    rays: Tally,
    is_first: bool,
    first: Option<Object>,
}

impl<S: rta_core::Scalar> Observer<S> for Seen {
    fn ray(&mut self, kind: RayKind, depth: u8, start: &Start<S>) {
        Observer::<S>::ray(&mut self.rays, kind, depth, start);
        self.is_first = kind == RayKind::Primary;
    }

    fn hit(&mut self, hit: Option<&Hit<S>>, _surface: Option<&Surface<S>>) {
        if self.is_first {
            self.first = hit.map(|hit| hit.object);
        }
    }

    fn shadow(&mut self, lamp: usize, start: &Start<S>) {
        Observer::<S>::shadow(&mut self.rays, lamp, start);
    }
}
