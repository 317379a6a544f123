//! What arrives at the patches of a mesh, by each method.

use core::sync::atomic::{AtomicBool, Ordering};

use rta_core::accelerator::Accelerator;
use rta_core::color::Rgb;
use rta_core::needs::Everything;
use rta_core::radiosity::{Casts, End, Matrix, Shooter, Solver, Stop, View};
use rta_core::scalar::{Light, Scalar, Summed, Unit};
use rta_scenes::narrow::Narrow;

use super::{BandsError, RadiosityError};
use crate::engine::progress::Progress;

/// The part of what was emitted below which nothing more is shot.
const UNSHOT: f64 = 1.0 / 1000.0;

/// The most ends of rays that are kept from sweep to sweep, each in 32 bytes at most; rays of patches beyond are traced in each sweep.
const MOST_ENDS: usize = 1 << 23;

/// What arrives at the patches, and how it was found.
pub(super) struct Found<S: Scalar> {
    /// Straight from what emits.
    pub(super) direct: Vec<Rgb<S::Light>>,
    /// From other surfaces.
    pub(super) indirect: Vec<Rgb<S::Light>>,
    /// Sweeps, or shots.
    pub(super) rounds: u32,
    /// The largest change in the last sweep, or the part of what was emitted that is unshot.
    pub(super) left: f64,
    /// Whether that is small enough.
    pub(super) is_done: bool,
}

/// Gathers; `direct` is what arrives straight from what emits.
pub(super) fn gathered<S: Narrow, C: Casts<S>, A: Accelerator<S>>(
    solver: &Solver<'_, S, Everything, C, A>,
    direct: Vec<Rgb<S::Light>>,
    stop: Stop,
    interrupt: &AtomicBool,
) -> Result<Found<S>, RadiosityError> {
    let mesh = *solver.mesh();
    let mut reflected = vec![Rgb::BLACK; mesh.len()];
    let mut memory = A::Memory::default();
    // Seeing takes longer than all sweeps, but for what is not kept.
    let mut progress = Progress::new(u32::try_from(mesh.len()).unwrap_or(u32::MAX));
    let (mut ends, mut seen) = (Vec::<End<S>>::new(), Vec::new());
    for (patch, number) in mesh.patches().zip(1..) {
        if interrupt.load(Ordering::Relaxed) {
            return Err(BandsError::Interrupted.into());
        }
        if ends.len() >= MOST_ENDS {
            break;
        }
        let first = ends.len();
        let Some(whole) = solver.view(patch, &mut memory, |end| ends.push(end)) else { break };
        seen.push((first..ends.len(), whole));
        progress.reached(number);
    }
    let view = |number: usize| {
        let (range, whole) = seen.get(number)?;
        Some(View { ends: ends.get(range.clone())?, whole: *whole })
    };
    let mut sweeps = 0;
    let outcome = loop {
        let outcome = solver.sweep_kept(&mut reflected, Some(&direct), stop.bits, view)?;
        sweeps += 1;
        if interrupt.load(Ordering::Relaxed) {
            return Err(BandsError::Interrupted.into());
        }
        if outcome.is_done || sweeps >= u32::from(stop.sweeps) {
            break outcome;
        }
    };
    let white = Rgb::new(S::Unit::ONE, S::Unit::ONE, S::Unit::ONE);
    let indirect = mesh.patches().enumerate().map(|(number, patch)| match view(number) {
        Some(view) => solver.viewed(&view, &reflected, white),
        None => solver.indirect(patch, &reflected, &mut memory),
    });
    let indirect = indirect.collect();
    let left = S::light_to_f64(outcome.change);
    Ok(Found { direct, indirect, rounds: sweeps, left, is_done: outcome.is_done })
}

/// Shoots; `direct` is what arrives straight from what emits.
pub(super) fn shot<S: Narrow, C: Casts<S>, A: Accelerator<S>>(
    solver: &Solver<'_, S, Everything, C, A>,
    direct: Vec<Rgb<S::Light>>,
    most: u32,
    interrupt: &AtomicBool,
) -> Result<Found<S>, RadiosityError> {
    let mesh = *solver.mesh();
    let black = vec![Rgb::BLACK; mesh.len()];
    let (mut light, mut unshot) = (black.clone(), black);
    let mut memory = A::Memory::default();
    let mut shooter = Shooter::new(mesh, &mut light, &mut unshot)?;
    let mut progress = Progress::new(1000);
    let mut rounds = 0;
    let left = loop {
        let left = S::light_to_f64(shooter.left());
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 1000")]
        progress.reached(((1.0 - left.clamp(0.0, 1.0)) / (1.0 - UNSHOT) * 1000.0) as u32);
        let Some(source) = shooter.next().filter(|_| left >= UNSHOT && rounds < most) else { break left };
        if interrupt.load(Ordering::Relaxed) {
            return Err(BandsError::Interrupted.into());
        }
        shooter.shoot(source, |receiver| solver.disc_factor(receiver, source, &mut memory));
        rounds += 1;
    };
    // What emitters send by themselves is told apart; what is left is as if it went round evenly.
    let zero = S::Unit::ZERO;
    let indirect = mesh.patches().zip(&direct).map(|(patch, direct)| {
        let all = shooter.with_ambient(patch);
        let reflectance =
            mesh.quads().get(patch.quad).map_or(Rgb::new(zero, zero, zero), |quad| quad.reflectance);
        let register = |all: S::Light, emitted: S::Light, rho: S::Unit, direct: S::Light| {
            let [all, emitted, direct] = [all, emitted, direct].map(S::light_to_f64);
            let rho = S::unit_to_f64(rho);
            S::light(if rho > 0.0 { ((all - emitted) / rho - direct).max(0.0) } else { 0.0 })
        };
        let emitted = mesh.emitted(patch);
        Rgb::new(
            register(all.r, emitted.r, reflectance.r, direct.r),
            register(all.g, emitted.g, reflectance.g, direct.g),
            register(all.b, emitted.b, reflectance.b, direct.b),
        )
    });
    let indirect = indirect.collect();
    Ok(Found { direct, indirect, rounds, left, is_done: left < UNSHOT })
}

/// Solves the system whose factors are all kept: by elimination, or by sweeps.
pub(super) fn rows<S: Narrow>(
    matrix: &Matrix<'_, S>,
    by_elimination: bool,
    stop: Stop,
) -> Result<Found<S>, RadiosityError> {
    let mesh = *matrix.mesh();
    let count = mesh.len();
    let mut light = vec![Rgb::BLACK; count];
    let (rounds, left, is_done) = if by_elimination {
        let mut work = vec![S::Unit::ZERO; count * count];
        matrix.gauss(&mut light, &mut work)?;
        (1, 0.0, true)
    } else {
        let outcome = matrix.solve(&mut light, stop)?;
        (u32::from(outcome.sweeps), S::light_to_f64(outcome.change), outcome.is_done)
    };
    let emitted: Vec<_> = mesh.patches().map(|patch| mesh.emitted(patch)).collect();
    let from = |light: &[Rgb<S::Light>]| -> Vec<Rgb<S::Light>> {
        (0..count).map(|number| sum::<S>(matrix.row(number), light)).collect()
    };
    let direct = from(&emitted);
    let reflected: Vec<_> = light.iter().zip(&emitted).map(|(all, own)| less::<S>(*all, *own)).collect();
    Ok(Found { direct, indirect: from(&reflected), rounds, left, is_done })
}

/// Returns the sum of light times factors, which come to 1 at most.
fn sum<S: Scalar>(row: &[S::Unit], light: &[Rgb<S::Light>]) -> Rgb<S::Light> {
    let empty = <S::Light as Summed>::EMPTY;
    let sums = row.iter().zip(light).fold(Rgb::new(empty, empty, empty), |sums, (factor, light)| {
        sums.zip(*light, |sum, light| light.added(sum, *factor))
    });
    let whole = S::Light::WHITE.added(empty, S::Unit::ONE);
    sums.map(|sum| S::Light::mean(sum, whole, S::Unit::ONE))
}

/// Returns one light less another, register by register.
fn less<S: Narrow>(all: Rgb<S::Light>, own: Rgb<S::Light>) -> Rgb<S::Light> {
    all.zip(own, |all, own| S::light((S::light_to_f64(all) - S::light_to_f64(own)).max(0.0)))
}
