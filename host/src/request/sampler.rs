//! Where the samples of a pixel lie, and what spreads their rays, as the options and the scene have it.

use core::fmt;

use rta_args::spreading::{IntegratorKind, SamplerKind, SpreadingArgs};
use rta_args::value::sampling::{AdaptiveValue, LampsValue, Samples};
use rta_core::sampling::{Places, Sobol};
use rta_scenes::Format;
use rta_scenes::description::Description;
use rta_scenes::sampler::{
    Integrator, Lamps, Sampler, Spreading, is_spectral, lamps as natural_lamps, spreads,
};

use super::error::RequestError;

/// Samples of a pixel where rays are spread and neither the command line nor the scene says how many.
pub const SPREAD: u32 = 16;

/// The most bounces of a path where nobody says another number.
pub const BOUNCES: u8 = 64;

/// The most samples of a pixel that ends early where its samples agree.
const SETTLED: u32 = 64;

/// Returns the sampler that the options ask for; where they leave it open, by the scene, and where that does, `several` samples of which the
/// rays are spread.
///
/// # Errors
/// [`RequestError::Samples`] for a number that fills no grid, [`RequestError::OfGrid`] and [`RequestError::OfSobol`] for an option of the
/// other sampler, [`RequestError::OfCones`] for one of samples where there are cones, [`RequestError::Spectral`] for one that spreads the rays of several wavelengths, [`RequestError::Moving`] for paths in a scene in which
/// something moves.
pub fn sampler(
    asked: &SpreadingArgs,
    scene: Option<&Description>,
    several: u32,
) -> Result<Sampler, RequestError> {
    if let Some(AdaptiveValue(adaptive)) = asked.aa {
        return Ok(Sampler::Adaptive(adaptive));
    }
    let spread = &asked.spread;
    if asked.integrator == IntegratorKind::Cones {
        let others = [
            (asked.samples.is_some(), "--samples"),
            (asked.jitter.is_some(), "--jitter"),
            (asked.sampler.is_some(), "--sampler"),
            (spread.seed.is_some(), "--seed"),
            (spread.lamps.is_some(), "--lamps"),
            (spread.split.is_some(), "--split"),
        ];
        let other = others.into_iter().find_map(|(is_asked, option)| is_asked.then_some(option));
        return other.map_or(Ok(Sampler::Cones), |option| Err(RequestError::OfCones(option)));
    }
    let lamps = spread.lamps.map_or(Lamps::Point, |LampsValue(lamps)| lamps);
    let is_of_paths = asked.integrator == IntegratorKind::Paths;
    if is_of_paths && scene.is_some_and(Description::has_motion) {
        return Err(RequestError::Moving);
    }
    let of_sobol = [
        (is_of_paths, "--integrator paths"),
        (lamps != Lamps::Point, "--lamps"),
        (spread.seed.is_some(), "--seed"),
        (spread.split.is_some(), "--split"),
        (spread.aperture.is_some_and(|radius| radius > 0.0), "--aperture"),
    ];
    let of_sobol = of_sobol.into_iter().find_map(|(is_asked, option)| is_asked.then_some(option));
    if let (Some(option), true) = (of_sobol, scene.is_some_and(is_spectral)) {
        return Err(RequestError::Spectral(option));
    }
    let spreads = || scene.is_some_and(|scene| spreads(scene, spread.aperture.or(scene.optics.aperture)));
    let natural = if asked.jitter.is_none() && (of_sobol.is_some() || spreads()) {
        SamplerKind::Sobol
    } else {
        SamplerKind::Grid
    };
    let said = scene.and_then(|scene| scene.settings.samples).and_then(Samples::of);
    let samples = asked.samples.or(said);
    match (asked.sampler.unwrap_or(natural), of_sobol) {
        (SamplerKind::Sobol, _) if asked.jitter.is_some() => Err(RequestError::OfGrid),
        (SamplerKind::Grid, Some(option)) => Err(RequestError::OfSobol(option)),
        (SamplerKind::Grid, None) => {
            // A scene may be made for a number that fills no grid; then it is drawn with one sample.
            let said = said.filter(|samples| samples.grid(None).is_ok());
            let samples = asked.samples.or(said).unwrap_or(Samples::ONE);
            let grid = samples.grid(asked.jitter);
            Ok(Sampler::Grid(grid.map_err(|reason| RequestError::Samples { samples, reason })?))
        }
        (SamplerKind::Sobol, _) => {
            let samples = samples.map_or(several, Samples::count);
            let samples = Sobol::new(samples, spread.seed.unwrap_or(0)).ok_or(RequestError::OfGrid)?;
            let lamps = match (spread.lamps, scene) {
                (None, Some(scene)) => natural_lamps(scene),
                _ => lamps,
            };
            let integrator = match asked.integrator {
                IntegratorKind::Whitted | IntegratorKind::Cones => Integrator::Whitted,
                IntegratorKind::Paths => Integrator::Paths { bounces: BOUNCES, is_cut: true },
            };
            Ok(Sampler::Sobol(Spreading { samples, lamps, split: spread.split.unwrap_or(1), integrator }))
        }
    }
}

/// Returns the sampler of a picture that is traced in passes, as `option` has it: that of the options, or a sequence where they would have a
/// grid.
///
/// # Errors
/// [`RequestError::Passes`] for a grid that is asked for, [`RequestError::OfCones`] for a picture by cones, [`RequestError::Spectral`] for a picture of several wavelengths.
pub fn passes(
    sampler: Sampler,
    (asked, option): (&SpreadingArgs, &'static str),
    scene: &Description,
) -> Result<Sampler, RequestError> {
    if sampler == Sampler::Cones {
        return Err(RequestError::OfCones(option));
    }
    if asked.sampler == Some(SamplerKind::Grid) {
        return Err(RequestError::Passes(option));
    }
    if is_spectral(scene) {
        return Err(RequestError::Spectral(option));
    }
    let samples = Sobol::new(SPREAD, 0).ok_or(RequestError::Passes(option))?;
    let plain = Spreading { samples, lamps: Lamps::Point, split: 1, integrator: Integrator::Whitted };
    Ok(Sampler::Sobol(sampler.spreading().copied().unwrap_or(plain)))
}

/// Returns the sampler of a picture whose pixels end early: that of passes, with the most samples that a pixel may take.
///
/// # Errors
/// Those of [`passes`].
pub fn settling(
    sampler: Sampler,
    asked: &SpreadingArgs,
    scene: &Description,
) -> Result<Sampler, RequestError> {
    let most = asked.samples.map_or(SETTLED, Samples::count);
    Ok(with_samples(passes(sampler, (asked, "--tolerance"), scene)?, most))
}

/// Returns the sampler with so many samples of its sequence; a grid stays as it is.
#[must_use]
pub fn with_samples(sampler: Sampler, samples: u32) -> Sampler {
    let Sampler::Sobol(spreading) = sampler else { return sampler };
    let samples = Sobol::new(samples, spreading.samples.seed()).unwrap_or(spreading.samples);
    Sampler::Sobol(Spreading { samples, ..spreading })
}

/// Returns the sampler whose paths, where it has any, have so many bounces at most, if it is said, and whose light is kept as it is for
/// linear light.
#[must_use]
pub fn with_paths(sampler: Sampler, most: Option<u32>, is_linear: bool) -> Sampler {
    match sampler {
        Sampler::Sobol(spreading @ Spreading { integrator: Integrator::Paths { bounces, is_cut }, .. }) => {
            let bounces = most.map_or(bounces, |most| u8::try_from(most).unwrap_or(u8::MAX));
            let integrator = Integrator::Paths { bounces, is_cut: is_cut && !is_linear };
            Sampler::Sobol(Spreading { integrator, ..spreading })
        }
        _ => sampler,
    }
}

/// Returns the number format of a picture by cones for which `asked` is asked: they are in `f64`, whichever float that is.
///
/// # Errors
/// [`RequestError::FixedCones`] for fixed point.
pub const fn cones_format(asked: Format) -> Result<Format, RequestError> {
    match asked {
        Format::F32 | Format::F64 => Ok(Format::F64),
        Format::Q16 | Format::Q20 => Err(RequestError::FixedCones(asked)),
    }
}

/// Returns whether samples are paths.
#[must_use]
pub fn is_of_paths(sampler: &Sampler) -> bool {
    let integrator = sampler.spreading().map(|spreading| spreading.integrator);
    matches!(integrator, Some(Integrator::Paths { .. }))
}

/// Puts the lens of the options into a scene.
pub fn put_lens(asked: (Option<f64>, Option<f64>), scene: &mut Description) {
    let (aperture, focus) = asked;
    if let Some(radius) = aperture {
        scene.optics.aperture = Some(2.0 * radius).filter(|diameter| *diameter > 0.0);
    }
    scene.optics.focus = focus.or(scene.optics.focus);
}

/// What a caption says of the samples; nothing of one in the middle of the pixel.
pub struct Told<'a>(pub &'a Sampler);

impl fmt::Display for Told<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Sampler::Grid(_) if *self.0 == Sampler::CENTER => Ok(()),
            Sampler::Grid(grid) => {
                let kind = if grid.is_jittered() { "jittered" } else { "regular" };
                write!(f, ", {} {kind} samples a pixel", grid.samples())
            }
            Sampler::Adaptive(adaptive) => write!(f, ", antialiasing {}", AdaptiveValue(*adaptive)),
            Sampler::Cones => f.write_str(", cones"),
            Sampler::Sobol(Spreading { samples, lamps, split, integrator }) => {
                write!(f, ", {} sobol samples a pixel, seed {}", samples.samples(), samples.seed())?;
                if let Integrator::Paths { bounces, .. } = integrator {
                    return write!(f, ", paths of at most {bounces} bounces");
                }
                match lamps {
                    Lamps::Point => Ok(()),
                    lamps => write!(f, ", lamps {}, split {split}", LampsValue(*lamps)),
                }
            }
        }
    }
}
