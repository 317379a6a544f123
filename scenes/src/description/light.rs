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
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Shown {
    /// In two passes: light from lamps is traced, and the solution's indirect light takes the place of ambient light.
    #[default]
    Indirect,
    /// In two passes too, but indirect light is gathered anew for each picture by rays from a few of the places that the eye sees, which end on the
    /// solution's patches, and mixed between those places.
    Cache(Caching),
    /// All light is the solution's; lamps are not asked.
    All,
}

/// How finely indirect light is gathered: the irradiance cache of G. Ward, F. Rubinstein and R. Clear, "A Ray Tracing Solution for Diffuse
/// Interreflection", SIGGRAPH 88.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Caching {
    /// Rays from a place, 1 or more; a power of two at best.
    pub rays: u32,
    /// The most by which the irradiance may be wrong between places, as a part of it, if it changed as fast as it can: above 0. Places
    /// are so far apart as this part of the harmonic mean distance of what they see.
    pub error: f64,
}

impl Default for Caching {
    /// 64 rays, and an error of .2.
    fn default() -> Self {
        Self { rays: 64, error: 0.2 }
    }
}

/// A solution as the light of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Solved {
    /// How it is shown.
    pub shown: Shown,
    /// The solution.
    pub solution: Solution,
}
