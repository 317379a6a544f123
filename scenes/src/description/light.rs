//! Radiosity that was solved ahead, as a part of a scene.

use crate::space::Triple;

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
