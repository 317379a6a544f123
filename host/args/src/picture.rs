//! Arguments of the commands that draw a picture: `rta show`, `rta render` and `rta hash`.

use std::path::PathBuf;

use clap::Args;

use super::choice;
use super::tracing::TracingArgs;
use crate::value::device::{Device, Target};
use crate::value::file_type::FileType;
use crate::value::rows::Rows;
use crate::value::sampling::ToleranceValue;
use crate::value::until::Until;
use rta_scenes::Format;

/// `rta show`.
#[derive(Args, Debug)]
#[command(
    mut_arg("frames", |frames| frames.help(SHOWN_FRAMES).long_help(SHOWN_FRAMES_AT_LENGTH)),
    mut_arg("rate", |rate| rate.help("Frames of the film in a second, once all are traced")),
    mut_arg("one_table", |one_table| one_table.requires("frames"))
)]
pub struct ShowArgs {
    /// Scene file (.rta, .dat, .nff or .p3f), or - for standard input; without one, the Juggler
    pub scene: Option<PathBuf>,
    /// The display to emulate, or none for 8 bits a gun without a colour table
    #[arg(short, long, value_enum, ignore_case = true, default_value_t = Target::On(Device::Vga))]
    pub device: Target,
    /// Show passes of 1, 1, 2, 4, ... samples until the estimated error is at most this, or the time is over: 0.004, 500ms, 30s, 2m
    ///
    /// As rta render has it. Without it, a picture whose rays are spread is shown in passes up to its --samples.
    #[arg(long, value_name = "ERROR|TIME", conflicts_with_all = ["frames", "samples", "jitter", "aa"])]
    pub until: Option<Until>,
    /// The scene's film.
    #[command(flatten)]
    pub film: FilmArgs,
    /// How the picture is traced.
    #[command(flatten)]
    pub tracing: TracingArgs,
}

impl Default for ShowArgs {
    fn default() -> Self {
        Self {
            scene: None,
            device: Target::On(Device::Vga),
            until: None,
            film: FilmArgs::default(),
            tracing: TracingArgs::default(),
        }
    }
}

/// `rta render`.
#[derive(Args, Debug)]
#[command(mut_arg("one_table", |one_table| one_table.requires("frames")))]
pub struct RenderArgs {
    /// Scene file (.rta, .dat, .nff or .p3f), or - for standard input
    pub scene: PathBuf,
    /// Trace only these rows, A to before B, into a part of the picture; rta merge makes pictures of parts
    ///
    /// For several machines, each with rows of its own and all else alike. A part of linear light, for a PFM or HDR, is asked for by --as.
    #[arg(long, value_name = "A..B", conflicts_with = "frames")]
    pub rows: Option<Rows>,
    /// Trace only these frames of the film, A to before B, into a part of it; rta merge makes films of parts
    #[arg(long, value_name = "A..B", requires = "frames", conflicts_with_all = ["rows", "one_table"])]
    pub only: Option<Rows>,
    /// Trace passes of 1, 1, 2, 4, ... samples until the estimated error is at most this, or the time is over: 0.004, 500ms, 30s, 2m
    ///
    /// The error is an rms of linear light, from 0 for black to 1 for white, over all pixels and registers, before the colours of a device.
    /// It is estimated by the spread of four scrambles of the samples (by seeds of their own, on some of the pixels). The picture is, byte
    /// for byte, the one of --sampler sobol with as many --samples as it ended with, which the last line tells; there is at least one, and
    /// there are at most 16384.
    #[arg(long, value_name = "ERROR|TIME", conflicts_with_all = ["rows", "only", "frames", "samples", "jitter", "aa"])]
    pub until: Option<Until>,
    /// With --until, an interrupt (Ctrl-C) writes the picture of the last complete pass, if there is one; without this, nothing
    #[arg(long, requires = "until")]
    pub keep: bool,
    /// End a pixel early where its samples and its neighbours' agree: where the standard error of their light is below this part of white
    ///
    /// Pixels take 4, 8, 16 ... samples of --sampler sobol, --samples at most (64 if nothing is said). M. Lee, R. Redner and S. Uselton,
    /// "Statistically Optimized Sampling for Distributed Ray Tracing", 1985. The last line tells how many a pixel has in the mean. .02 is
    /// hardly seen; what no sample of a pixel and of its neighbours meets is missed. .02:1 ends pixels after 1, 4, 8 ..., the first of them where
    /// neighbours have nearly the same light: smooth pictures take fewer samples, and more is missed.
    #[arg(long, value_name = "PART[:FEWEST]", conflicts_with_all = ["rows", "only", "frames", "until", "jitter", "aa"])]
    pub tolerance: Option<ToleranceValue>,
    /// What is drawn of it, and into which file.
    #[command(flatten)]
    pub drawing: DrawingArgs,
}

/// `rta merge`.
#[derive(Args, Debug)]
pub struct MergeArgs {
    /// Parts of a picture or of a film, in any order: files of rta render --rows or --only
    #[arg(required = true)]
    pub parts: Vec<PathBuf>,
    /// Picture file; its extension tells the kind (see --as); - is standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    /// Kind of picture, whatever the name of the file says [default: by the extension; png into pipes]
    #[arg(long = "as", value_enum, ignore_case = true, value_name = "TYPE")]
    pub file_type: Option<FileType>,
    /// Say nothing but errors
    #[arg(short, long)]
    pub quiet: bool,
}

/// `rta juggle`.
#[derive(Args, Debug)]
pub struct JuggleArgs {
    /// What is drawn, and into which file.
    #[command(flatten)]
    pub drawing: DrawingArgs,
}

/// A picture or a film, and its file.
#[derive(Args, Clone, Debug)]
pub struct DrawingArgs {
    /// Picture file; its extension tells the kind (see --as); - is standard output
    ///
    /// A PNG, BMP or GIF from a device is indexed, with the device's own colour table. PFM and HDR hold linear light, unclamped, and need
    /// --device none; a GIF needs a device.
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    /// The display to emulate, or none for 8 bits a gun without a colour table
    #[arg(short, long, value_enum, ignore_case = true, default_value_t = Target::On(Device::Vga))]
    pub device: Target,
    /// Kind of picture, whatever the name of the file says [default: by the extension; png into pipes]
    #[arg(long = "as", value_enum, ignore_case = true, value_name = "TYPE")]
    pub file_type: Option<FileType>,
    /// Say nothing but warnings and errors: no progress bar, and no line about the picture at the end
    #[arg(short, long)]
    pub quiet: bool,
    /// The scene's film.
    #[command(flatten)]
    pub film: FilmArgs,
    /// How the picture is traced.
    #[command(flatten)]
    pub tracing: TracingArgs,
}

/// Frames of a film in a second where nobody says another number.
const RATE: u16 = 20;

/// What `--frames` is to `rta show`, in a line.
const SHOWN_FRAMES: &str = "A film of so many frames, shown again and again: frame K is of the instant K/N";
/// And at length.
const SHOWN_FRAMES_AT_LENGTH: &str = "\
A film of so many frames, shown again and again: frame K is of the instant K/N

Each is the picture of --instant K/N, and is traced once; what is seen meanwhile is the last one that is complete. All are kept in memory.";

/// A film: the frames of a scene, one after the other in one file.
#[derive(Args, Clone, Copy, Debug)]
pub struct FilmArgs {
    /// A film of so many frames in a .gif, .png (animated) or .ppm (one after the other): frame K is of the instant K/N
    ///
    /// Each is, byte for byte, the picture of --instant K/N. The film is shown again and again.
    #[arg(long, value_name = "N", value_parser = choice::whole(1..=65_535_u32), conflicts_with = "instant")]
    pub frames: Option<u32>,
    /// Frames of the film in a second; a GIF rounds the time of each to hundredths of a second
    #[arg(long, value_name = "N", default_value_t = RATE, value_parser = choice::whole(1_u16..=50))]
    pub rate: u16,
    /// One colour table for all frames of the film, made from all of them, and not one for each
    #[arg(long)]
    pub one_table: bool,
}

impl Default for FilmArgs {
    /// No film.
    fn default() -> Self {
        Self { frames: None, rate: RATE, one_table: false }
    }
}

/// `rta hash`. Its number format is fixed point unless another is asked for: only there do all machines arrive at one hash.
#[derive(Args, Debug)]
#[command(mut_arg("format", |format| format.default_value(Format::Q16.name())))]
pub struct HashArgs {
    /// Scene file (.rta, .dat, .nff or .p3f), or - for standard input
    pub scene: PathBuf,
    /// The display
    #[arg(short, long, value_enum, ignore_case = true, default_value_t = Device::Vga)]
    pub device: Device,
    /// How the picture is traced.
    #[command(flatten)]
    pub tracing: TracingArgs,
}
