//! What can go wrong between the command line and a scene that is ready to be traced.

use core::fmt;
use std::io;

use rta_args::value::sampling::{NotASquare, Samples};
use rta_scenes::error::{Found, SceneError};
use rta_scenes::fit::FloorError;
use rta_scenes::pictures::PictureError as LoadError;

use crate::engine::admission::Refusal;
use crate::engine::{EngineError, Format};
use crate::picture::error::{PictureError, reason};
use crate::picture::raster::{RasterError, Size};

/// Why a request cannot be met. It prints as one line that names the scene file or the option it is about.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RequestError {
    /// The scene file cannot be opened or read.
    #[error("cannot read the scene {name}: {}", reason(source))]
    Read {
        /// The file, or `standard input`.
        name: String,
        /// What the system says.
        source: io::Error,
    },
    /// The scene file is not a scene.
    #[error("{_0}{}", lenient_helps(_0))]
    Scene(#[from] SceneError),
    /// The file of solved radiosity cannot be opened or read.
    #[error("cannot read the radiosity {name}: {}", reason(source))]
    NoLight {
        /// The file.
        name: String,
        /// What the system says.
        source: io::Error,
    },
    /// Light that a picture solves for by itself is indirect light.
    #[error("--light solve is indirect light alone: --light-as all is for a file of rta radiosity")]
    Unsolved,
    /// Light is gathered for a scene in which something moves.
    #[error("--light-as cache is for scenes in which nothing moves, and in this one something does")]
    Gathered,
    /// Light is gathered for a program that has what was solved.
    #[error(
        "--light-as cache gathers light for each picture anew, and a baked program has the light of the patches"
    )]
    Kept,
    /// It is none of the scene.
    #[error("{name}: {source}")]
    Light {
        /// The file.
        name: String,
        /// Why.
        source: SolutionError,
    },
    /// A picture that the scene names cannot be used.
    #[error("{name}: {source}")]
    Texture {
        /// Name of the scene.
        name: String,
        /// Which picture, and why not.
        source: LoadError,
    },
    /// The scene cannot be traced as asked.
    #[error("{name}: {source}")]
    Engine {
        /// Name of the scene.
        name: String,
        /// Why not.
        source: EngineError,
    },
    /// The number format does not admit the scene.
    #[error("{name} does not fit {format}: {reason}{}{fit}", fitting(others))]
    Refused {
        /// Name of the scene.
        name: String,
        /// The format.
        format: Format,
        /// Why not.
        reason: Box<Refusal>,
        /// The formats that do admit it.
        others: Vec<Format>,
        /// What scaling it could do.
        fit: Hint,
    },
    /// A scene is to be written in a format that is only read, or not even that.
    #[error("{name}: scenes are written as .rta or .dat")]
    SceneType {
        /// The file that was to be written.
        name: String,
    },
    /// A scene says more than a `.dat` can.
    #[error(
        "{name} says more than a .dat can: spheres, ellipsoids and vertical cylinders of the types 0 to 3 on an opaque floor, under lamps of the model rta, seen by an upright camera; .rta says all"
    )]
    Unsayable {
        /// Name of the scene.
        name: String,
    },
    /// The scene file states a raster that no picture can have.
    #[error("{name} is made for {width}x{height} pixels: {reason}; --size sets others")]
    SceneSize {
        /// Name of the scene.
        name: String,
        /// Pixels in a row.
        width: u32,
        /// Rows.
        height: u32,
        /// The limit that they exceed.
        reason: RasterError,
    },
    /// The pixels of the device and the size of the picture make a screen too narrow or too wide.
    #[error("a picture of {size} is too narrow or too wide: {reason}")]
    Shape {
        /// The picture.
        size: Size,
        /// The limit that it exceeds.
        reason: RasterError,
    },
    /// A colour table or dithering was asked for, but no device.
    #[error("--table and --dither are about the colour table of a device, and --device none has none")]
    TableWithoutDevice,
    /// A number of samples that fills no grid.
    #[error("--samples {samples} do not fill a grid: it takes {reason}; --sampler sobol takes any number")]
    Samples {
        /// The number.
        samples: Samples,
        /// What it should be.
        reason: NotASquare,
    },
    /// An option of the other sampler.
    #[error("--jitter is about the cells of a grid, and --sampler sobol has none; its noise has a --seed")]
    OfGrid,
    /// An option of the other sampler.
    #[error("{_0} is about rays that are spread, which those of --sampler grid and of --aa are not")]
    OfSobol(&'static str),
    /// A grid of samples for a picture that is traced in passes.
    #[error("{_0} adds samples to those that are there, and a --sampler grid has all of its samples at once")]
    Passes(&'static str),
    /// An option about samples, for a picture that has none.
    #[error("{_0} is about samples, and --integrator cones has one cone over each pixel instead")]
    OfCones(&'static str),
    /// Cones in fixed point.
    #[error("--integrator cones is a study in f64, and {_0} is fixed point")]
    FixedCones(Format),
    /// Paths in a scene whose light was solved ahead.
    #[error("--integrator paths finds all light itself, and --light has it solved ahead")]
    Solved,
    /// Paths in a scene in which something moves.
    #[error("--integrator paths is for scenes in which nothing moves, and in this one something does")]
    Moving,
    /// An option that spreads rays, for a picture of several wavelengths.
    #[error(
        "{_0} is about rays that are spread, and those of several wavelengths are not; --spectral 0 traces one"
    )]
    Spectral(&'static str),
    /// The picture does not fit its device.
    #[error(transparent)]
    Picture(#[from] PictureError),
}

/// What scaling could do for a scene that was refused. It prints as the end of an error message.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Hint {
    /// There is nothing to say about scaling.
    None,
    /// `--fit` would scale the scene by this factor.
    Factor(f64),
    /// `--fit` was given, but a scene with a floor cannot be scaled.
    Floor,
    /// `--fit` was given, but no scale helps.
    NoScale,
}

impl fmt::Display for Hint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::None => Ok(()),
            Self::Factor(factor) => write!(f, "; --fit would scale it by {}", PowerOfTwo(*factor)),
            Self::Floor => write!(f, "; --fit: {FloorError}"),
            Self::NoScale => f.write_str("; --fit finds no scale at which it fits"),
        }
    }
}

/// The factor of a scale, which is a power of two. It prints as a short number.
pub(super) struct PowerOfTwo(pub(super) f64);

impl fmt::Display for PowerOfTwo {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if (1e-6..1e9).contains(&self.0) { self.0.fmt(f) } else { write!(f, "2^{}", self.0.log2()) }
    }
}

/// Names the option that reads past an unknown line, as part of an error message.
const fn lenient_helps(error: &SceneError) -> &'static str {
    match error.found {
        Found::Unknown(_) => "; --lenient reads past such lines",
        _ => "",
    }
}

/// Names the formats that admit a scene, as part of an error message; empty if there are none.
fn fitting(formats: &[Format]) -> String {
    if formats.is_empty() {
        return String::new();
    }
    let names: Vec<_> = formats.iter().map(Format::to_string).collect();
    format!("; it fits {}", names.join(", "))
}

/// Why a text is no solution of a scene.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SolutionError {
    /// The text is none of a solution.
    #[error("line {line}: expected {expected}")]
    Malformed {
        /// The line, from 1.
        line: usize,
        /// What was expected.
        expected: &'static str,
    },
    /// It is that of another scene, or the scene has changed.
    #[error(
        "it is the solution of another scene: its hash is {found:016x}, and that of this scene {scene:016x}"
    )]
    Other {
        /// The hash that it has.
        found: u64,
        /// The scene's.
        scene: u64,
    },
    /// It does not have one line for each patch.
    #[error("it has {found} patches, and the scene {scene}")]
    Patches {
        /// How many there are.
        found: usize,
        /// How many there should be.
        scene: usize,
    },
}
