//! Radiosity that was solved ahead, as the light of a scene.

use std::sync::Arc;

use crate::description::{Description, Quad, bilinear};
use crate::space::{Triple, cross, difference, length};

/// What arrives at a patch: irradiance, linear RGB.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Arriving {
    /// Straight from what emits.
    pub direct: Triple,
    /// From all other surfaces.
    pub indirect: Triple,
}

/// The radiosity of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// Patches along u and v of each quad, where they are not those of the scene.
    pub patches: Option<u16>,
    /// What arrives at the patches, in the order of their quads.
    pub arriving: Vec<Arriving>,
}

/// How a solution is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shown {
    /// In two passes: light from lamps is traced, and the solution's indirect light takes the place of ambient light.
    #[default]
    Indirect,
    /// All light is the solution's; lamps are not asked.
    All,
}

/// A solution as the light of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Solved {
    /// How it is shown.
    pub shown: Shown,
    /// The solution.
    pub solution: Solution,
}

/// Returns the number of patches of all quads.
#[must_use]
pub fn patch_count(quads: &[Quad]) -> usize {
    quads.iter().map(|quad| quad.patches.map(usize::from).iter().product::<usize>()).sum()
}

impl Description {
    /// Returns the scene with light that is still to be solved.
    #[must_use]
    pub fn unsolved(&self) -> Self {
        let solution = Solution { patches: None, arriving: Vec::new() };
        self.lit_by(&Arc::new(Solved { shown: Shown::Indirect, solution }))
    }

    /// Returns the scene with solved light. Its triangles are those of [`Description::meshed`].
    #[must_use]
    pub fn lit_by(&self, light: &Arc<Solved>) -> Self {
        let mut scene = self.meshed(light.solution.patches);
        scene.details.light = Some(Arc::clone(light));
        scene
    }
}

/// Returns the areas of the patches of a scene's quads, in their order: of each, that of its two triangles.
#[must_use]
pub fn patch_areas(scene: &Description) -> Vec<f64> {
    let mut areas = Vec::with_capacity(patch_count(&scene.quads));
    for quad in &scene.quads {
        let Some(corners) = quad.corners(&scene.triangles) else { continue };
        let [nu, nv] = quad.patches;
        let place =
            |i: u16, j: u16| bilinear(corners, [f64::from(i) / f64::from(nu), f64::from(j) / f64::from(nv)]);
        let half = |a, b, c| length(cross(difference(b, a), difference(c, a))) / 2.0;
        for (i, j) in (0..nv).flat_map(|j| (0..nu).map(move |i| (i, j))) {
            let [a, b, c, d] = [place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)];
            areas.push(half(a, b, c) + half(a, c, d));
        }
    }
    areas
}
