//! Radiosity that was solved ahead, as the light of a scene.

use std::sync::Arc;

use crate::description::{Description, Quad, bilinear};
use crate::space::{cross, difference, length};

pub use crate::description::{Arriving, Caching, Shown, Solution, Solved};

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
