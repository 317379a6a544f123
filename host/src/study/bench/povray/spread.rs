//! Rays that are spread, for POV-Ray: lamps with a size, and a lens.

use core::fmt;

use rta_core::camera::Camera;
use rta_core::vector::Vector;
use rta_scenes::description::Lamp;
use rta_scenes::narrow::Narrowed;

use super::{File, vector};

/// How well POV-Ray finds soft shadows and what is out of focus.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// Places on a lamp along each side.
    pub lamp: u16,
    /// How often a lamp is cut where its corners differ before all of its places are asked; `None` to ask all at once.
    pub adaptive: Option<u32>,
    /// Samples of the lens: the most, and the confidence and the variance at which there are enough.
    pub lens: (u32, f64, f64),
    /// Light between neighbours from which on a pixel is refined, 1 is white, and how often; `None` for one sample a pixel.
    pub smoothing: Option<(f64, u32)>,
}

impl Spread {
    /// Returns what is told of the settings, of what is in a scene: lamps with a size, a lens.
    #[must_use]
    pub fn told(&self, has_large_lamps: bool, has_lens: bool) -> String {
        let mut told = Vec::new();
        if has_large_lamps {
            told.push(format!("area_light {0} x {0}", self.lamp));
            told.extend(self.adaptive.map(|level| format!("adaptive {level}")));
        }
        if has_lens {
            let (samples, confidence, variance) = self.lens;
            told.push(format!("blur_samples {samples}, confidence {confidence}, variance {variance}"));
        }
        told.extend(self.smoothing.map(|(threshold, depth)| format!("+A{threshold} +R{depth}")));
        told.join(", ")
    }
}

/// What makes a light source a ball of some radius.
pub(super) struct Ball<'s>(pub(super) &'s Lamp, pub(super) &'s Spread);

impl fmt::Display for Ball<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(Lamp { radius, .. }, Spread { lamp: places, adaptive, .. }) = self;
        if *radius <= 0.0 {
            return Ok(());
        }
        // A disc that always faces the point.
        let (u, v) = (vector([2.0 * radius, 0.0, 0.0]), vector([0.0, 2.0 * radius, 0.0]));
        write!(f, " area_light {u}, {v}, {places}, {places} jitter circular orient")?;
        adaptive.map_or(Ok(()), |level| write!(f, " adaptive {level}"))
    }
}

impl File<'_> {
    /// Returns what makes the camera a lens, if it is one.
    pub(super) fn lens(&self, scene: &Narrowed<f64>, spread: Option<&Spread>) -> String {
        let Some((spread, aperture)) = spread.zip(scene.spreads.aperture.as_ref()) else {
            return String::new();
        };
        let Camera { eye, forward, .. } = scene.camera;
        // What is sharp is as many focal distances away as the shift goes into the radius.
        let sharp = eye + forward * (aperture.radius / aperture.shift);
        let (samples, confidence, variance) = spread.lens;
        // Its rays start within a quarter of its aperture: so converged pictures are nearest to rta's (scenes/lens.rta at 32 x 24: .014 apart, and
        // .037 with half of it).
        format!(
            " focal_point {} aperture {:?} blur_samples {samples} confidence {confidence:?} variance {variance:?}",
            vector([sharp.x(), sharp.y(), sharp.z()]),
            4.0 * aperture.radius
        )
    }
}
