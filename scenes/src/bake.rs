//! A scene file into Rust source: the scene as `static` data in one number format, for a firmware's flash.
//!
//! What the target is spared happens here: reading, narrowing, the range proof, the analysis of what the scene needs. A
//! baked scene is an admitted scene.
//!
//! In the firmware's `build.rs`:
//!
//! ```no_run
//! rta_scenes::bake("scene.dat", rta_scenes::bake::Format::Q16)?;
//! # Ok::<(), rta_scenes::bake::BakeError>(())
//! ```
//!
//! and in the firmware `include!(concat!(env!("OUT_DIR"), "/scene.rs"));`, which brings
//!
//! | item | what it is |
//! | --- | --- |
//! | `Number` | the number format, a [`Scalar`](rta_core::Scalar) |
//! | `Needs` | what the scene needs, a [`rta_core::needs::Needs`] |
//! | `SCENE` | the scene, an [`rta_core::range::Admitted`] |
//! | `CAMERA` | the eye, an [`rta_core::camera::Camera`] |
//! | `model` | a function that returns the illumination model |
//! | `models` | a function that returns it at each of the wavelengths, of which there is one as a rule |
//! | `WEIGHTS`, `FURTHER`, `DISPERSIVE` | what else a [`Spectrum`](rta_core::trace::Spectrum) has, all empty as a rule |
//! | `SAMPLES`, `SPREAD` | the samples of a pixel, a [`Sobol`](rta_core::sampling::Sobol), and what else a [`Distributed`](rta_core::trace::Distributed) has; `None` and nothing as a rule |
//! | `CUTTING`, `CONTRAST` | the [`Cutting`](rta_core::raster::corners::Cutting) of the pixels, and whether they have more samples where the [contrast](rta_core::raster::contrast) is high; `None` and `false` as a rule |
//! | `MOTIONS`, `Room` | what else a [`Moving`](rta_core::trace::moving::Moving) has: what moves, and the memory of it; empty as a rule |
//!
//! so that `Tracer::<_, _, Needs, 5>::new(&SCENE, Rta, 5)` draws it, by [`Corners`](rta_core::raster::corners::Corners) or
//! [`Contrasts`](rta_core::raster::contrast::Contrasts) where pixels are antialiased, whose rows are the program's. Where `SAMPLES` is not
//! `None`, that tracer is the first of a `Distributed`, and where `MOTIONS` is not empty, that is the first of a `Moving`.

use core::fmt;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

use rta_core::accelerator::Lists;
use rta_core::needs::Used;

use crate::accelerator::bvh;
use crate::description::Description;
use crate::error::SceneError;
pub use crate::format::Format;
use crate::lines::OutOfRange;
pub use crate::model::Model;
use crate::narrow::moving::proved;
use crate::narrow::{NarrowError, narrow};
use crate::pictures::PictureError;
use crate::sampler::{Adaptive, Lamps, Spreading};
use crate::shading::{Wavelengths, middle};
use crate::{in_format, read};

mod coats;
mod literal;
mod model;
mod module;
mod quads;
mod spectrum;
mod spreads;
#[cfg(test)]
mod tests;

use literal::Literal;

/// The most pixels on a side that a picture keeps in a baked scene: 16 KiB of flash for a square one.
pub const TEXELS: u32 = 64;

/// How a scene is baked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recipe {
    /// The number format.
    pub format: Format,
    /// Width over height of the screen that the whole picture fills, above 0.
    pub aspect: f64,
    /// The illumination model.
    pub model: Model,
    /// What spreads the rays of the samples; `None` for one sample in the middle of each pixel, a pinhole, point lamps, smooth surfaces, and
    /// what moves where it is in the middle of the time. Nothing is spread in a picture of several wavelengths.
    pub spreading: Option<Spreading>,
    /// Adaptive antialiasing, if there is any: then nothing is spread, as if `spreading` were `None`.
    pub adaptive: Option<Adaptive>,
    /// Whether the quads are in the source, so that the program can solve their radiosity. Those of a scene with solved light are in any case.
    pub radiosity: bool,
}

/// Samples of a pixel whose rays are spread, unless a scene or a recipe says how many.
pub const SAMPLES: u32 = 4;

impl Recipe {
    /// A recipe for a screen of 4 : 3 and the model `Rta`, by which nothing is spread.
    pub const fn new(format: Format) -> Self {
        Self {
            format,
            aspect: 4.0 / 3.0,
            model: Model::Rta,
            spreading: None,
            adaptive: None,
            radiosity: false,
        }
    }

    /// A recipe for a screen of 4 : 3 as a scene has it: the model that its format was made for, and where something spreads rays, its
    /// number of samples, or else [`SAMPLES`] of them. Lamps are points.
    pub fn of(format: Format, scene: &Description) -> Self {
        let spreading = Spreading::of(scene, Lamps::Point, SAMPLES);
        Self { model: scene.model, spreading, ..Self::new(format) }
    }
}

/// Why a scene cannot be baked.
#[derive(Debug)]
#[non_exhaustive]
pub enum BakeError {
    /// A file cannot be read or written.
    File {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// `OUT_DIR` is not set: [`bake`] was not called from a build script.
    NoBuildScript,
    /// The scene file is wrong.
    Scene(SceneError),
    /// A picture that the scene names cannot be used.
    Picture(PictureError),
    /// A number of the scene does not fit the number format.
    Narrow(NarrowError),
    /// A ray of the scene may leave the number format.
    Range(OutOfRange),
}

impl fmt::Display for BakeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File { path, source } => write!(f, "{}: {source}", path.display()),
            Self::NoBuildScript => f.write_str("OUT_DIR is not set: a scene is baked by a build script"),
            Self::Scene(error) => error.fmt(f),
            Self::Picture(error) => error.fmt(f),
            Self::Narrow(error) => error.fmt(f),
            Self::Range(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for BakeError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::File { source, .. } => Some(source),
            _ => None,
        }
    }
}

impl From<SceneError> for BakeError {
    fn from(error: SceneError) -> Self {
        Self::Scene(error)
    }
}

impl From<PictureError> for BakeError {
    fn from(error: PictureError) -> Self {
        Self::Picture(error)
    }
}

impl From<NarrowError> for BakeError {
    fn from(error: NarrowError) -> Self {
        Self::Narrow(error)
    }
}

/// Bakes the scene file `path` into `OUT_DIR`, under its own name with the extension `rs`, as [`Recipe::of`] has it, and tells Cargo to
/// do so again when the scene changes. Returns where the source is.
///
/// # Errors
/// Whatever keeps the scene from being baked.
pub fn bake(path: impl AsRef<Path>, format: Format) -> Result<PathBuf, BakeError> {
    bake_by(path, |scene| Recipe::of(format, scene))
}

/// Bakes the scene file `path` into `OUT_DIR`, as [`bake`] does, by `recipe`.
///
/// # Errors
/// Whatever keeps the scene from being baked.
pub fn bake_with(path: impl AsRef<Path>, recipe: &Recipe) -> Result<PathBuf, BakeError> {
    bake_by(path, |_| *recipe)
}

/// Bakes the scene file `path` into `OUT_DIR`, as [`bake`] does, by the recipe that `recipe` returns for the scene.
///
/// # Errors
/// Whatever keeps the scene from being baked.
pub fn bake_by(
    path: impl AsRef<Path>,
    recipe: impl FnOnce(&Description) -> Recipe,
) -> Result<PathBuf, BakeError> {
    let path = path.as_ref();
    let failed = |path: &Path| {
        let path = path.to_owned();
        move |source| BakeError::File { path, source }
    };
    depends_on(path);
    let folder = env::var_os("OUT_DIR").ok_or(BakeError::NoBuildScript)?;
    let text = fs::read(path).map_err(failed(path))?;
    let name = path.display().to_string();
    let mut scene = read(&text, &name)?;
    let pictures = scene.load_pictures(path.parent().unwrap_or_else(|| Path::new("")), TEXELS)?;
    pictures.iter().for_each(|path| depends_on(path));
    let source = module(&scene, &name, &recipe(&scene))?;
    let out = Path::new(&folder).join(path.file_stem().unwrap_or("scene".as_ref())).with_extension("rs");
    fs::write(&out, source).map_err(failed(&out))?;
    Ok(out)
}

/// Tells Cargo that what is baked depends on a file.
#[allow(clippy::disallowed_macros)] // Cargo reads it
fn depends_on(path: &Path) {
    println!("cargo::rerun-if-changed={}", path.display());
}

/// The Rust source of a scene that is called `name`.
///
/// # Errors
/// [`BakeError::Narrow`] and [`BakeError::Range`]: the scene does not fit the number format.
pub fn module(scene: &Description, name: &str, recipe: &Recipe) -> Result<String, BakeError> {
    in_format!(recipe.format, S => source::<S>(scene, name, recipe))
}

fn source<S: Literal>(scene: &Description, name: &str, recipe: &Recipe) -> Result<String, BakeError> {
    let unsolved = (recipe.radiosity && scene.details.light.is_none()).then(|| scene.unsolved());
    let drawn = unsolved.as_ref().unwrap_or(scene).drawn_by(recipe.model);
    let scene = &*drawn;
    let narrowed = narrow::<S>(scene, recipe.aspect)?;
    let hierarchy = bvh::build::<S>(scene);
    let limits = match hierarchy.bvh() {
        Some(bvh) => proved(&narrowed, bvh),
        None => proved(&narrowed, Lists),
    };
    let limits = limits.map_err(|error| BakeError::Range(OutOfRange::new(error, scene)))?;
    let wavelengths = Wavelengths::new(recipe.model, &scene.air, &narrowed, limits);
    let dispersive = wavelengths.dispersive();
    let is_still = wavelengths.is_dispersive() || recipe.adaptive.is_some();
    let spreading = recipe.spreading.as_ref().filter(|_| !is_still);
    let medium = scene.air.medium.filter(|_| !scene.lamps.is_empty());
    let used = Used {
        air_reach: scene.air.medium.is_some_and(|medium| medium.reach.is_some()),
        spread_air: medium.is_some_and(|medium| medium.shadows > 0 && medium.albedo > 0.0),
        ..recipe.model.used(&narrowed.scene())
    };
    let used = spreads::used(&narrowed, spreading, used);
    let mut source = String::new();
    // A String takes all that is written to it.
    let moves = |list: &str| spreads::moves(&narrowed, spreading, list);
    let lists = module::write(&mut source, name, (&narrowed, &hierarchy), limits, used, recipe, moves)
        .unwrap_or_default();
    let _ = quads::write(&mut source, &narrowed);
    let _ = spreads::write(&mut source, &narrowed, spreading, &lists);
    let _ = spreads::write_adaptive(&mut source, recipe.adaptive);
    let _ = spectrum::write(&mut source, &narrowed, &hierarchy, dispersive);
    let middle = middle(&narrowed, limits);
    let _ = model::write(
        &mut source,
        &narrowed,
        (recipe.model, &scene.air),
        (middle, wavelengths.is_dispersive()),
    );
    Ok(source)
}
