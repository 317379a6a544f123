//! Air in the numbers of a format.

use rta_core::color::Rgb;
use rta_core::illumination::air::{self, Distance, Fog, Haze};
use rta_core::illumination::{Passage, Way};
use rta_core::needs::Needs;
use rta_core::scalar::Scalar;
use rta_core::scene::Sky;
use rta_core::vector::Vec3;

use super::Narrow;
use super::check::exponent;
use crate::air::Air;

/// The layer of air around a model, chosen when the program runs.
#[derive(Clone, Copy, Debug)]
pub enum Layer<S: Scalar> {
    /// Light fades with the distance from the eye.
    Distance(Distance<S>),
    /// Haze.
    Haze(Haze<S>),
    /// Fog.
    Fog(Fog<S>),
}

impl<S: Scalar> air::Air<S> for Layer<S> {
    fn passage<N: Needs>(
        &self,
        way: &Way<S>,
        length: S,
        lit: impl FnMut(Vec3<S>, usize) -> S::Unit,
    ) -> Option<Passage<S, Rgb<S::Unit>>> {
        match self {
            Self::Distance(air) => air.passage::<N>(way, length, lit),
            Self::Haze(air) => air.passage::<N>(way, length, lit),
            Self::Fog(air) => air.passage::<N>(way, length, lit),
        }
    }
}

impl<S: Narrow> Layer<S> {
    /// Returns the layer of that air for a scene with the sky `sky`; `middle` is the length of the ray in the middle of its picture. Lengths beyond
    /// the format's largest are cut to it: no ray is longer.
    #[must_use]
    #[allow(clippy::new_ret_no_self, reason = "clear air is no layer")]
    pub fn new(air: Air, middle: S, sky: &Sky<S>) -> Option<Self> {
        let length = |length: f64| S::length(length.clamp(0.0, S::largest()));
        match air {
            Air::Clear => None,
            Air::Distance { exponent: p, reference } => {
                let reference = reference.map_or(middle, length);
                Some(Layer::Distance(Distance { exponent: exponent(p), reference }))
            }
            Air::Haze { near, far, color } => {
                let color = color.map_or(sky.horizon, |color| {
                    let [r, g, b] = color.map(|register| S::light(register.clamp(0.0, S::LARGEST_LIGHT)));
                    Rgb::new(r, g, b)
                });
                Some(Layer::Haze(Haze { near: length(near), far: length(far), color }))
            }
            Air::Fog { extinction } => {
                let [r, g, b] = extinction.map(|s| <S as Narrow>::power(s * core::f64::consts::LOG2_E));
                Some(Layer::Fog(Fog { density: Rgb::new(r, g, b) }))
            }
        }
    }
}
