//! Where the samples of a pixel lie, and what spreads their rays.

use rta_core::color::Rgb;
use rta_core::raster::Raster;
pub use rta_core::raster::corners::Cutting;
pub use rta_core::sampling::Sobol;
use rta_core::sampling::{Places, Sampling};
use rta_core::scalar::{Light, Unit};
pub use rta_core::trace::dice::Lamps;

use crate::description::{Description, Material, Shown};

/// Where the samples of a pixel lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sampler {
    /// On a grid: nothing is spread, the lens is a pinhole, surfaces are smooth, and lamps are points.
    Grid(Sampling),
    /// At the places of a sequence, and their rays are spread.
    Sobol(Spreading),
    /// More of them where the light of neighbours differs.
    Adaptive(Adaptive),
    /// None: one cone over each pixel (J. Amanatides 1984), in a program that has such pictures.
    Cones,
}

/// A way of adaptive antialiasing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Adaptive {
    /// At the corners of pixels, which are cut where the light there differs (T. Whitted 1980).
    Whitted(Cutting),
    /// One in each pixel, and eight more where the contrast around it is high (D. Mitchell 1987).
    Mitchell,
}

/// Samples whose rays are spread.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Spreading {
    /// Number of samples and seed.
    pub samples: Sobol,
    /// How lamps with a size are asked for their light.
    pub lamps: Lamps,
    /// Places on a lamp that are asked for each point that the eye sees, 1 or more.
    pub split: u16,
    /// How the light of a sample is found.
    pub integrator: Integrator,
}

/// How the light of a sample is found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Integrator {
    /// By its ray tree (T. Whitted 1980).
    #[default]
    Whitted,
    /// By a path of light (J. Kajiya 1986): [`Paths`](rta_core::trace::Paths). Nothing moves then, and lamps are asked at any of their places.
    Paths {
        /// The most bounces of a path.
        bounces: u8,
        /// Whether light is cut to white before the mean is taken, as it is for a display; otherwise it is kept as it is.
        is_cut: bool,
    },
}

impl Spreading {
    /// Returns how the rays of a scene are spread where nobody says more: nothing is where nothing in it spreads them. `samples` is the number
    /// of samples where the scene has none, a power of two.
    #[must_use]
    pub fn of(scene: &Description, lamps: Lamps, samples: u32) -> Option<Self> {
        let lamps = if lamps == Lamps::Point { self::lamps(scene) } else { lamps };
        let spreads = lamps != Lamps::Point && !is_spectral(scene) || spreads(scene, scene.optics.aperture);
        let samples = Sobol::new(scene.settings.samples.unwrap_or(samples), 0)?;
        spreads.then_some(Self { samples, lamps, split: 1, integrator: Integrator::Whitted })
    }
}

/// Returns how the lamps of a scene are asked where nobody says more: as points, or, where [quads](crate::description::Quad) emit light, at
/// places that differ from point to point.
#[must_use]
pub fn lamps(scene: &Description) -> Lamps {
    let is_whole = scene.details.light.as_ref().is_some_and(|light| light.shown == Shown::All);
    if scene.has_emitters() && !is_whole { Lamps::Area } else { Lamps::Point }
}

/// Returns whether something in a scene spreads rays by itself, seen by a lens of the size `aperture`, if there is one: that lens, motion,
/// a quad that emits light, solved light, a rough material, or a model's own lobes; nothing in a picture of several wavelengths.
#[must_use]
pub fn spreads(scene: &Description, aperture: Option<f64>) -> bool {
    let is_rough = |own: &Material| own.roughness.is_some_and(|roughness| roughness > 0.0);
    let has_lens = aperture.is_some_and(|aperture| aperture > 0.0);
    let has_emitters = scene.has_emitters() || scene.details.light.is_some();
    let has_more = has_emitters || scene.has_motion() || scene.has_lobes();
    !is_spectral(scene) && (has_lens || has_more || scene.materials.iter().any(is_rough))
}

/// Returns whether the picture of a scene has several wavelengths, whose rays are not spread.
#[must_use]
pub fn is_spectral(scene: &Description) -> bool {
    let is_dispersive = scene.materials.iter().any(|own| own.dispersion.is_some());
    scene.settings.wavelengths.is_some_and(|count| count > 0) && is_dispersive
}

impl Sampler {
    /// One sample, in the middle of the pixel.
    pub const CENTER: Self = Self::Grid(Sampling::CENTER);

    /// Returns whether the samples are jittered on a grid.
    #[must_use]
    pub const fn is_jittered(&self) -> bool {
        match self {
            Self::Grid(sampling) => sampling.is_jittered(),
            Self::Sobol(_) | Self::Adaptive(_) | Self::Cones => false,
        }
    }

    /// Returns what spreads the rays, if anything does.
    #[must_use]
    pub const fn spreading(&self) -> Option<&Spreading> {
        match self {
            Self::Grid(_) | Self::Adaptive(_) | Self::Cones => None,
            Self::Sobol(spreading) => Some(spreading),
        }
    }
}

impl From<Sampling> for Sampler {
    fn from(sampling: Sampling) -> Self {
        Self::Grid(sampling)
    }
}

/// With adaptive antialiasing pixels have one sample in the middle here, as with cones: how many rays they take is seen only when they are
/// traced.
impl Places for Sampler {
    /// The number of the row.
    type Row<U: Unit> = u32;

    fn samples(&self) -> u32 {
        match self {
            Self::Grid(sampling) => sampling.samples(),
            Self::Sobol(spreading) => spreading.samples.samples(),
            Self::Adaptive(_) | Self::Cones => Sampling::CENTER.samples(),
        }
    }

    fn row<U: Unit>(&self, _raster: Raster, y: u32) -> u32 {
        y
    }

    fn place<U: Unit>(&self, raster: Raster, row: u32, x: u32, sample: u32) -> (U, U) {
        match self {
            Self::Grid(sampling) => sampling.place(raster, row, x, sample),
            Self::Sobol(spreading) => spreading.samples.place(raster, row, x, sample),
            Self::Adaptive(_) | Self::Cones => Sampling::CENTER.place(raster, row, x, sample),
        }
    }

    fn add<L: Light>(&self, sum: Rgb<L>, light: Rgb<L>) -> Rgb<L> {
        match self {
            Self::Grid(sampling) => sampling.add(sum, light),
            Self::Sobol(spreading) => spreading.samples.add(sum, light),
            Self::Adaptive(_) | Self::Cones => Sampling::CENTER.add(sum, light),
        }
    }

    fn mean<L: Light>(&self, sum: Rgb<L>) -> Rgb<L> {
        match self {
            Self::Grid(sampling) => sampling.mean(sum),
            Self::Sobol(spreading) => spreading.samples.mean(sum),
            Self::Adaptive(_) | Self::Cones => Sampling::CENTER.mean(sum),
        }
    }
}
