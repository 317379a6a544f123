//! Air in the numbers of a format.

use rta_core::color::Rgb;
use rta_core::illumination::air::{self, Distance, Fog, Haze};
use rta_core::illumination::fade::Phase;
use rta_core::illumination::{Passage, Way};
use rta_core::needs::Needs;
use rta_core::scalar::{Light, Scalar};
use rta_core::scene::Sky;
use rta_core::vector::Vec3;

use super::check::{Checker, exponent};
use super::{Narrow, NarrowError};
use crate::description::{Air, Attenuation, Fading, Medium};

/// How light fades around a model, chosen when the program runs.
#[derive(Clone, Copy, Debug)]
pub enum Layer<S: Scalar> {
    /// With the distance from the eye.
    Distance(Distance<S>),
    /// In haze.
    Haze(Haze<S>),
}

impl<S: Scalar> air::Air<S> for Layer<S> {
    fn passage<N: Needs>(
        &self,
        way: &Way<S>,
        length: Option<S>,
        lit: impl FnMut(Vec3<S>, usize) -> S::Unit,
    ) -> Option<Passage<S, Rgb<S::Unit>>> {
        match self {
            Self::Distance(air) => air.passage::<N>(way, length, lit),
            Self::Haze(air) => air.passage::<N>(way, length, lit),
        }
    }
}

/// What surrounds a model: how light fades, and a medium.
pub type Layers<S> = (Option<Layer<S>>, Option<air::Medium<S>>);

/// The fewest and the most places along a ray that light of lamps is taken at.
const FEWEST_PLACES: u32 = 16;
const MOST_PLACES: u32 = 4096;

/// The most forward or backward that a medium scatters.
const MOST_FORWARD: f64 = 0.9;

/// The most that a medium may take of light over its reach: what is left is e to the power of minus this.
const MOST_DEPTH: f64 = 1023.0;

/// Checks the reach of a medium: its optical depth.
pub(super) fn check_reach<S: Narrow>(air: &Air) -> Result<(), NarrowError> {
    let Some((medium, reach)) = air.medium.and_then(|medium| Some((medium, medium.reach?))) else {
        return Ok(());
    };
    let densest = medium.extinction.into_iter().fold(0.0, f64::max);
    let check = Checker::<S>::named("the medium");
    check.at_most("the reach", reach, S::largest())?;
    check.at_most("the extinction times the reach", densest * reach, MOST_DEPTH).map(|_| ())
}

/// Returns the layers of air for a scene with that sky and ambient light, under a model whose lamps fade with the distance or do not;
/// `middle` is the length of the ray in the middle of its
/// picture. Lengths beyond the format's largest are cut to it: no ray is longer.
pub fn layers<S: Narrow>(
    air: &Air,
    (middle, fades): (S, bool),
    sky: &Sky<S>,
    ambient: Rgb<S::Light>,
) -> Layers<S> {
    let length = |length: f64| S::length(length.clamp(0.0, S::largest()));
    let fading = air.attenuation.map(|Attenuation { fading, from, color }| {
        let by = |p: f64| {
            let reference = from.map_or(middle, length);
            Layer::Distance(Distance { exponent: exponent(p), reference })
        };
        match fading {
            Fading::Warnock => by(1.0),
            Fading::Romney(p) => by(p),
            Fading::Haze([near, far]) => {
                let color = color.map_or(sky.horizon, |color| {
                    let [r, g, b] = color.map(|register| S::light(register.clamp(0.0, S::LARGEST_LIGHT)));
                    Rgb::new(r, g, b)
                });
                Layer::Haze(Haze { near: length(near), far: length(far), color })
            }
        }
    });
    let medium = air.medium.map(|Medium { extinction, albedo, anisotropy, shadows, reach }| {
        let [r, g, b] = extinction.map(|s| <S as Narrow>::power(s * core::f64::consts::LOG2_E));
        let (albedo, forward) = (S::unit(albedo), S::unit(anisotropy.clamp(-MOST_FORWARD, MOST_FORWARD)));
        let places = shadows.clamp(FEWEST_PLACES, MOST_PLACES).next_power_of_two();
        air::Medium {
            fog: Fog { density: Rgb::new(r, g, b), glow: ambient.map(|light| light.times(albedo)) },
            albedo,
            phase: Phase { forward },
            halvings: u8::try_from(places.ilog2()).unwrap_or(u8::MAX),
            shadows: shadows > 0,
            reach: reach.map(|reach| length(reach.max(S::SMALLEST_RADIUS))),
            fades,
        }
    });
    (fading, medium)
}
