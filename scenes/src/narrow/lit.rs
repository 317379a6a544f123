//! Solved radiosity in one number format.

use core::f64::consts::PI;

use rta_core::color::Rgb;
use rta_core::radiosity::{Indirect, Mesh, Quad, Solution};
use rta_core::scalar::Scalar;
use rta_core::scene::Scene;

use super::check::Checker;
use super::quads::quads;
use super::{Narrow, NarrowError};
use crate::description::{Description, Shown, Solved};
use crate::solution::patch_areas;

/// Solved radiosity of a scene of one number format: what a core [`Indirect`] borrows.
#[derive(Clone, Debug)]
pub struct Lit<S: Scalar> {
    /// The quads.
    pub quads: Vec<Quad<S>>,
    /// What arrives at each patch, over pi.
    pub arriving: Vec<Rgb<S::Light>>,
    /// What arrives elsewhere, over pi: the mean over the area of the patches.
    pub elsewhere: Rgb<S::Light>,
}

impl<S: Narrow> Lit<S> {
    /// Returns the solved light of a scene, if it has any.
    ///
    /// # Errors
    /// What the format cannot hold.
    pub(super) fn of(description: &Description) -> Result<Option<Self>, NarrowError> {
        let Some(Solved { shown, solution }) = description.details.light.as_deref() else { return Ok(None) };
        let check = Checker::<S>::named("the solved radiosity");
        let (areas, mut sums, mut whole) = (patch_areas(description), [0.0; 3], 0.0);
        let mut arriving = Vec::with_capacity(solution.arriving.len());
        for (own, area) in solution.arriving.iter().zip(&areas) {
            let mut light = own.indirect;
            if *shown == Shown::All {
                light.iter_mut().zip(own.direct).for_each(|(sum, direct)| *sum += direct);
            }
            let light = light.map(|register| register / PI);
            sums.iter_mut().zip(light).for_each(|(sum, light)| *sum += area * light);
            whole += area;
            arriving.push(check.light(light)?);
        }
        let mean = sums.map(|sum| if whole > 0.0 { sum / whole } else { 0.0 });
        Ok(Some(Self { quads: quads(description)?, arriving, elsewhere: check.light(mean)? }))
    }

    /// Returns the light, borrowed, in its scene; `None` where it is not that of the scene.
    pub fn indirect<'a>(&'a self, scene: &Scene<'a, S>) -> Option<Indirect<'a, S>> {
        let mesh = Mesh::new(&self.quads, scene).ok()?;
        let arriving = Solution::new(mesh, &self.arriving).ok()?;
        Some(Indirect { arriving, elsewhere: self.elsewhere })
    }
}
