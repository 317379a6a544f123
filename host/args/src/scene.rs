//! Arguments of the commands that are about a scene without drawing it: `rta check` and `rta bake`.

use std::path::PathBuf;

use clap::Args;

use rta_scenes::Reading;
use rta_scenes::description::{Air, Shading};
use rta_scenes::pictures::LARGEST_SIDE;

use super::choice;
use super::light::LightArgs;
use crate::spreading::SpreadArgs;
use crate::value::device::Device;
use crate::value::raster::{Aspect, Size};
use crate::value::sampling::{AdaptiveValue, Samples};
use rta_scenes::{Format, Model};

/// How a scene file is read.
#[derive(Args, Clone, Copy, Debug, Default)]
pub struct ReadingArgs {
    /// Pass over lines of a .nff that begin with an unknown word, each with a warning
    #[arg(long)]
    pub lenient: bool,
    /// See polygons of a .nff only from where their corners run counterclockwise, not from both sides
    #[arg(long)]
    pub one_sided: bool,
    /// Air between the things of the scene: none, warnock, romney, haze:NEAR:FAR or fog:S [default: the scene's]
    ///
    /// warnock, warnock:D0, romney, romney:P and romney:P:D0 darken with the distance d from the eye, by (D0/d)^P, P being 1 and 4, D0 the
    /// length of the ray in the middle of the picture; haze has the colour of the horizon;
    /// fog:S and fog:R:G:B leave exp(-S d). Lengths are in units of the scene.
    #[arg(long, value_name = "AIR")]
    pub air: Option<Air>,
    /// The most pixels on a side that a picture of a texture or of the sky keeps [default: 1024, and 64 where it is baked]
    #[arg(long, value_name = "N", value_parser = choice::whole(1..=LARGEST_SIDE))]
    pub texels: Option<u32>,
    /// Wavelengths that glass is seen in, an odd number from 1 to 31; 0 for red, green and blue [default: the scene's]
    #[arg(long, value_name = "N", value_parser = wavelengths)]
    pub spectral: Option<u32>,
    /// Cut spheres and ellipsoids into meshes of 2 N x N quadrilaterals with normals, N from 2 to 64
    #[arg(long, value_name = "N", value_parser = choice::whole(2..=64_u32))]
    pub tessellate: Option<u32>,
    /// How all triangles with normals are shaded: normals, gouraud or bishop-weimer [default: the scene's]
    #[arg(long, value_name = "WAY", value_parser = shading, ignore_case = true)]
    pub shading: Option<Shading>,
    /// Mix normals and light of vertices on the screen, as scan-line programs do, for rays from the eye
    #[arg(long)]
    pub scanline: bool,
    /// The scene as it is at an instant of its film, 0 to 1 [default: 0, as its statements have it]
    #[arg(long, value_name = "TIME", value_parser = instant)]
    pub instant: Option<f64>,
}

/// The ways of shading by name.
const SHADINGS: [(&str, Shading); 3] =
    [("normals", Shading::Normals), ("gouraud", Shading::Gouraud), ("bishop-weimer", Shading::BishopWeimer)];

fn shading(text: &str) -> Result<Shading, String> {
    let known = SHADINGS.into_iter().find(|(name, _)| name.eq_ignore_ascii_case(text));
    known.map(|(_, shading)| shading).ok_or_else(|| "expected normals, gouraud or bishop-weimer".into())
}

fn instant(text: &str) -> Result<f64, &'static str> {
    text.parse().ok().filter(|instant| (0.0..=1.0).contains(instant)).ok_or("expected a number from 0 to 1")
}

fn wavelengths(text: &str) -> Result<u32, String> {
    let number = text.parse().ok().filter(|number: &u32| *number == 0 || *number < 32 && number % 2 == 1);
    number.ok_or_else(|| "expected an odd number from 1 to 31, or 0".into())
}

impl From<ReadingArgs> for Reading {
    fn from(args: ReadingArgs) -> Self {
        let ReadingArgs { lenient, one_sided, air, texels, spectral, tessellate, shading, scanline, instant } =
            args;
        Self {
            lenient,
            one_sided,
            air,
            texels,
            wavelengths: spectral,
            tessellate,
            shading,
            scanline,
            instant,
        }
    }
}

/// `rta check`.
#[derive(Args, Debug)]
pub struct CheckArgs {
    /// Scene file (.rta, .dat, .nff or .p3f), or - for standard input
    pub scene: PathBuf,
    /// How the scene is read
    #[command(flatten)]
    pub reading: ReadingArgs,
    /// Number format
    #[arg(short, long, value_parser = choice::format(), ignore_case = true, default_value_t = Format::Q16)]
    pub format: Format,
    /// Illumination model, of which is told what it does not use of the materials [default: the scene's]
    #[arg(short, long, value_parser = choice::model(), ignore_case = true)]
    pub model: Option<Model>,
    /// Shape of the screen
    #[arg(long, value_name = "RATIO", default_value = "4:3")]
    pub aspect: Aspect,
    /// Scale the scene by a power of two if it does not fit the number format (not one with a floor)
    #[arg(long)]
    pub fit: bool,
}

/// `rta convert`.
#[derive(Args, Debug)]
pub struct ConvertArgs {
    /// Scene file (.rta, .dat, .nff or .p3f), or - for standard input
    pub scene: PathBuf,
    /// How the scene is read
    #[command(flatten)]
    pub reading: ReadingArgs,
    /// Scene file, .rta or .dat; - is standard output, which is sent a .rta
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
}

/// `rta bake`.
#[derive(Args, Debug)]
pub struct BakeArgs {
    /// Scene file (.rta, .dat, .nff or .p3f), or - for standard input
    pub scene: PathBuf,
    /// How the scene is read
    #[command(flatten)]
    pub reading: ReadingArgs,
    /// Number format
    #[arg(short, long, value_parser = choice::format(), ignore_case = true, default_value_t = Format::Q16)]
    pub format: Format,
    /// Illumination model that the scene is drawn with, which decides what it needs [default: rta, or phong for .nff]
    #[arg(short, long, value_parser = choice::model(), ignore_case = true)]
    pub model: Option<Model>,
    /// Shape of the screen that the whole picture fills
    #[arg(long, value_name = "RATIO", default_value = "4:3")]
    pub aspect: Aspect,
    /// Samples of a pixel whose rays are spread, a power of two up to 16384
    ///
    /// [default: where something spreads rays (a lens, motion, rough materials, --lamps) what a .rta says, else 4; elsewhere
    /// one ray a pixel]
    #[arg(long, value_name = "N", verbatim_doc_comment)]
    pub samples: Option<Samples>,
    /// Adaptive antialiasing: whitted, whitted:K or mitchell
    ///
    /// The program keeps the rows that it needs, and draws the picture from the top to the bottom. Nothing is spread.
    #[arg(long, value_name = "WAY", conflicts_with_all = ["samples", "seed", "lamps", "split", "aperture", "light", "radiosity"])]
    pub aa: Option<AdaptiveValue>,
    /// What spreads rays
    #[command(flatten)]
    pub spread: SpreadArgs,
    /// Light that was solved: it is put into flash
    #[command(flatten)]
    pub light: LightArgs,
    /// Put the quads of the scene into the source, so that the program can solve for their radiosity itself
    #[arg(long, conflicts_with = "light")]
    pub radiosity: bool,
    /// Scale the scene by a power of two if it does not fit the number format (not one with a floor)
    #[arg(long)]
    pub fit: bool,
    /// Store the colour table of the whole picture on a device too, for a firmware that makes none itself
    #[arg(long, value_enum, ignore_case = true, value_name = "DEVICE")]
    pub palette: Option<Device>,
    /// Pixels of the picture whose colour table is stored [default: the device's]
    #[arg(long, value_name = "WxH", requires = "palette")]
    pub size: Option<Size>,
    /// Rust file; - is standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
}
