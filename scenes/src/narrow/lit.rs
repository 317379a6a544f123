//! Solved radiosity in one number format.

use core::f64::consts::PI;

use rta_core::color::Rgb;
use rta_core::radiosity::{Corners, Indirect, Mesh, Quad, Solution};
use rta_core::scalar::Scalar;
use rta_core::scene::Scene;

use super::check::Checker;
use super::quads::quads;
use super::{Narrow, NarrowError};
use crate::description::{Arriving, Caching, Description, Shown, Solved};
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
    /// What arrives at the corners of each patch, over pi, once it is kept; else none.
    pub corners: Vec<Corners<S>>,
    /// What is needed to gather it anew for a picture, where that is asked for.
    pub gathering: Option<Gathering<S>>,
}

/// What is needed to gather indirect light at places of a picture.
#[derive(Clone, Debug)]
pub struct Gathering<S: Scalar> {
    /// How finely.
    pub caching: Caching,
    /// The radiosity of each patch without what it emits: X of [`Solver`](rta_core::radiosity::Solver).
    pub reflected: Vec<Rgb<S::Light>>,
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
        let (quads, elsewhere) = (quads(description)?, check.light(mean)?);
        let gathering = match shown {
            Shown::Cache(caching) => {
                let reflected = reflected(&quads, &solution.arriving, &check)?;
                Some(Gathering { caching: *caching, reflected })
            }
            Shown::Indirect | Shown::All => None,
        };
        Ok(Some(Self { quads, arriving, elsewhere, corners: Vec::new(), gathering }))
    }

    /// Keeps what arrives at the corners of patches in `scene`, its own, so that it need not be computed for each point that is seen.
    pub(crate) fn keep(&mut self, scene: &Scene<S>) {
        let Some(Indirect { arriving, .. }) = self.indirect(scene) else { return };
        let corners = arriving.mesh().patches().map(|patch| arriving.corners(patch)).collect();
        self.corners = corners;
    }

    /// Returns the light, borrowed, in its scene; `None` where it is not that of the scene.
    pub fn indirect<'a>(&'a self, scene: &Scene<'a, S>) -> Option<Indirect<'a, S>> {
        let mesh = Mesh::new(&self.quads, scene).ok()?;
        let arriving = Solution::new(mesh, &self.arriving).ok()?;
        let arriving = arriving.with_corners(&self.corners).unwrap_or(arriving);
        Some(Indirect { arriving, elsewhere: self.elsewhere })
    }
}

/// Returns the radiosity of each patch without what it emits, from what arrives there.
fn reflected<S: Narrow>(
    quads: &[Quad<S>],
    arriving: &[Arriving],
    check: &Checker<S>,
) -> Result<Vec<Rgb<S::Light>>, NarrowError> {
    let of_patches = quads.iter().flat_map(|quad| core::iter::repeat_n(quad.reflectance, quad.len()));
    let one = |(Rgb { r, g, b }, own): (Rgb<S::Unit>, &Arriving)| {
        let mut light = own.direct;
        for ((light, indirect), part) in light.iter_mut().zip(own.indirect).zip([r, g, b]) {
            *light = (*light + indirect) * S::unit_to_f64(part);
        }
        check.light(light)
    };
    of_patches.zip(arriving).map(one).collect()
}
