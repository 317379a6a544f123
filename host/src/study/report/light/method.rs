//! The ways to find light that goes round, and how each is made better.

use core::fmt;

use rta_args::radiosity::Factors;
use rta_scenes::solution::{Caching, Shown};

/// A way to find the light of a room, from the simplest to the one without bias.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Whitted's ray tree, lamps as points, the rest a constant.
    Ambient,
    /// Rays to places all over the lamps, the rest a constant.
    Distributed,
    /// Light between the vertices of patches, nothing else.
    Radiosity,
    /// Lamps by rays, the rest by radiosity.
    TwoPasses,
    /// Two passes, between which indirect light is gathered at some of the places that the eye sees.
    Cache,
    /// Paths of light.
    Paths,
}

impl Method {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::Ambient, Self::Distributed, Self::Radiosity, Self::TwoPasses, Self::Cache, Self::Paths];

    /// Returns its name in tables and diagrams.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Ambient => "constant ambient light",
            Self::Distributed => "distributed rays",
            Self::Radiosity => "radiosity alone",
            Self::TwoPasses => "two passes",
            Self::Cache => "irradiance cache",
            Self::Paths => "paths",
        }
    }

    /// Returns who published it, when and where.
    #[must_use]
    pub const fn source(self) -> &'static str {
        match self {
            Self::Ambient => {
                "T. Whitted, \"An Improved Illumination Model for Shaded Display\", Communications of the ACM 23, 6 (1980)"
            }
            Self::Distributed => {
                "R. Cook, T. Porter, L. Carpenter, \"Distributed Ray Tracing\", SIGGRAPH 84; C. Verbeck, D. Greenberg, IEEE CG&A 4 (1984)"
            }
            Self::Radiosity => {
                "C. Goral, K. Torrance, D. Greenberg, B. Battaile, SIGGRAPH 84; M. Cohen, D. Greenberg, SIGGRAPH 85"
            }
            Self::TwoPasses => {
                "J. Wallace, M. Cohen, D. Greenberg, SIGGRAPH 87; F. Sillion, C. Puech, SIGGRAPH 89"
            }
            Self::Cache => {
                "G. Ward, F. Rubinstein, R. Clear, \"A Ray Tracing Solution for Diffuse Interreflection\", SIGGRAPH 88"
            }
            Self::Paths => {
                "J. Kajiya, \"The Rendering Equation\", SIGGRAPH 86; lamps and paths weighed: E. Veach, L. Guibas, SIGGRAPH 95"
            }
        }
    }

    /// Returns what it leaves out: the error that no number of rays takes away.
    #[must_use]
    pub const fn bias(self) -> &'static str {
        match self {
            Self::Ambient => {
                "Each lamp is a point in its middle that shines alike in all directions, so that the edges of shadows are sharp and what is beside a \
                 flat lamp is too bright. Light from other surfaces is the same constant \
                 everywhere, so that corners are too bright, the ceiling has no shape, and no wall colours its neighbours. Here the constant \
                 is the best that there is for this very picture; who has no paths to compare with has to guess it."
            }
            Self::Distributed => {
                "Lamps have their size, and shadows their soft edges. Light from other surfaces is still one constant."
            }
            Self::Radiosity => {
                "All light between diffuse surfaces, and no other: highlights and mirrors are the tracer's. It is known at the \
                 middles of patches and mixed between their vertices, so that an edge of a shadow is as wide as a patch, and light leaks under \
                 what stands on one. More rays do not help; more patches do."
            }
            Self::TwoPasses => {
                "Light straight from lamps is found for each point by rays, with all edges of shadows. What is between the vertices of patches is \
                 the light of other surfaces alone, which changes slowly; its small shadows, as in the corners at the foot of a block, are \
                 missed where patches are large. Light that lamps send by way of mirrors is found by the rays of patches alone."
            }
            Self::Cache => {
                "As two passes, but indirect light is gathered by rays from places that the eye sees, close to each other in corners and beside \
                 things, and patches are only what those rays end on. What is left is the noise of so many rays from a place, shadows smaller \
                 than places are close, and what mirrors show, which has the light of patches."
            }
            Self::Paths => {
                "Nothing but light that takes more than 64 bounces. The error is noise: it halves for four times as many samples."
            }
        }
    }

    /// Returns how it shows solved light, if it does.
    #[must_use]
    pub fn shown(self) -> Option<Shown> {
        match self {
            Self::Radiosity => Some(Shown::All),
            Self::TwoPasses => Some(Shown::Indirect),
            Self::Cache => Some(Shown::Cache(Caching::default())),
            Self::Ambient | Self::Distributed | Self::Paths => None,
        }
    }

    /// Returns the samples of its pictures: squares where they lie on a grid, else powers of two.
    #[must_use]
    pub const fn samples(self) -> &'static [u32] {
        match self {
            Self::Ambient | Self::Radiosity => &[1, 4, 16],
            Self::Distributed | Self::TwoPasses | Self::Cache => &[1, 4, 16, 64],
            Self::Paths => &[1, 4, 16, 64, 256],
        }
    }
}

/// How the light of patches is solved for, by gathering with the light of lamps first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Solving {
    /// Patches along both sides of each quad; without it those of the scene.
    pub patches: Option<u16>,
    /// What a patch sees.
    pub factors: Factors,
}

const fn by_rays(patches: Option<u16>, rays: u32) -> Solving {
    Solving { patches, factors: Factors::Rays(rays) }
}

const fn by_cells(side: u16) -> Solving {
    Solving { patches: None, factors: Factors::HemiCube(side) }
}

/// The solutions of a room: with more and more patches, with more and more rays, and by hemi-cubes.
pub const SOLVINGS: [Solving; 9] = [
    by_rays(Some(1), 64),
    by_rays(Some(2), 64),
    by_rays(Some(4), 64),
    by_rays(Some(8), 64),
    by_rays(None, 16),
    by_rays(None, 64),
    by_rays(None, 256),
    by_cells(10),
    by_cells(20),
];

impl fmt::Display for Solving {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.patches {
            None => f.write_str("scene's")?,
            Some(side) => write!(f, "{side} x {side}")?,
        }
        write!(f, ", {}", self.factors)
    }
}
