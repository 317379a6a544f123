//! Where the samples of a pixel lie, and what spreads their rays.

use clap::{Args, ValueEnum};

use super::choice;
use crate::value::sampling::{AdaptiveValue, LampsValue, Samples};

/// Where the samples of a pixel lie, and what spreads their rays.
#[derive(Args, Clone, Debug, Default)]
pub struct SpreadingArgs {
    /// Samples of a pixel: with --sampler grid 1, 4, 9, 16 ... 1024, with sobol a power of two up to 16384
    ///
    /// [default: what a .rta says, else 1 on a grid and 16 of sobol]
    #[arg(long, value_name = "N", verbatim_doc_comment)]
    pub samples: Option<Samples>,
    /// Jitter the samples of a grid, each in its own cell, by this seed
    #[arg(long, value_name = "SEED", value_parser = choice::whole(0..=u32::MAX))]
    pub jitter: Option<u32>,
    /// Where the samples of a pixel lie
    ///
    /// [default: sobol where something spreads rays: a lens, motion, rough materials, --lamps; else grid]
    #[arg(long, value_enum, ignore_case = true, verbatim_doc_comment)]
    pub sampler: Option<SamplerKind>,
    /// Adaptive antialiasing: whitted, whitted:K or mitchell
    ///
    /// More rays where the light of neighbours differs: whitted cuts pixels in four twice where the light at their corners
    /// differs, whitted:K up to K times; mitchell has one ray a pixel, and nine where the contrast around it is high.
    #[arg(long, value_name = "WAY", conflicts_with_all = ["samples", "jitter", "sampler", "seed", "lamps", "split", "aperture", "integrator"])]
    pub aa: Option<AdaptiveValue>,
    /// How light is found: by Whitted's ray tree, by one path of light a sample, or by one cone over each pixel
    ///
    /// Paths (Kajiya 1986) are right in the mean, with noise that halves where --samples are four times as many. They take the place of
    /// ambient light, ask lamps at any of their places, and show no highlights but those of rough mirrors. --depth is the most bounces of a
    /// path [64 if nothing is said]. For a display light is cut to white sample by sample, which darkens what is brighter in part; in a PFM
    /// or HDR nothing is cut. Cones (Amanatides 1984) are a study in f64, also with --format f32, and not in fixed point: edges are smooth without
    /// samples, and what things before each other hide is a guess.
    #[arg(long, value_enum, ignore_case = true, default_value_t = IntegratorKind::Whitted)]
    pub integrator: IntegratorKind,
    /// What spreads rays
    #[command(flatten)]
    pub spread: SpreadArgs,
}

/// What spreads the rays of samples.
#[derive(Args, Clone, Debug, Default)]
pub struct SpreadArgs {
    /// Seed of --sampler sobol: pictures with different seeds have different noise [default: 0]
    #[arg(long, value_name = "N", value_parser = choice::whole(0..=u32::MAX))]
    pub seed: Option<u32>,
    /// How lamps with a radius or with edges are asked: point, fixed:K, area or cone [default: point]
    ///
    /// As points in their middles, at K fixed places (a square number), at places that differ from point to
    /// point, so that shadows have soft edges, or by one cone to the lamp, whose soft edges have no noise.
    #[arg(long, value_name = "LAMPS")]
    pub lamps: Option<LampsValue>,
    /// With --lamps area, shadow rays to a lamp from each point that the eye sees [default: 1]
    #[arg(long, value_name = "N", value_parser = choice::whole(1_u16..=1024))]
    pub split: Option<u16>,
    /// Radius of the camera's lens, instead of what the scene says; 0 is a pinhole
    #[arg(long, value_name = "LENGTH", value_parser = choice::length)]
    pub aperture: Option<f64>,
    /// Distance from the eye that is sharp, instead of what the scene says
    #[arg(long, value_name = "LENGTH", value_parser = choice::distance)]
    pub focus: Option<f64>,
}

/// How the light of a sample is found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum IntegratorKind {
    /// By the tree of reflected and transmitted rays (Whitted 1980)
    #[default]
    Whitted,
    /// By one path of light for each sample (Kajiya 1986)
    Paths,
    /// By one cone over each pixel instead of rays (Amanatides 1984): a study, in f64
    Cones,
}

/// Where the samples of a pixel lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum SamplerKind {
    /// On a regular or jittered grid; nothing is spread
    Grid,
    /// At the places of a scrambled Sobol sequence, and rays are spread over lens, lamps and rough surfaces
    Sobol,
}
