//! Arguments of the studies: `rta bench`, `rta report`, `rta figures`, `rta gallery`, `rta stability`, `rta palette`, `rta visibility` and
//! `rta difference`, and of their children under valgrind.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::choice;
use super::scene::ReadingArgs;
use super::tracing::TracingArgs;
use crate::value::degrees::PixelsPerDegree;
use crate::value::device::{Device, Target};
use crate::value::raster::{Aspect, Size};
use rta_packets::picture::MAX_DEPTH;
use rta_scenes::Format;

/// `rta bench`.
#[derive(Args, Clone, Debug)]
pub struct BenchArgs {
    /// Scene files (.dat or .nff); without one, the three that come with the program, and random spheres from 22 to 100000
    /// of which only the eye's rays are traced
    #[arg(conflicts_with_all = ["record", "check"])]
    pub scenes: Vec<PathBuf>,
    /// Number format
    #[arg(short, long, value_parser = choice::format(), ignore_case = true, default_value_t = Format::F32, conflicts_with_all = ["record", "check"])]
    pub format: Format,
    /// Pixels of the pictures [default: those of a .nff, else 320x200; of random spheres 512x512]
    #[arg(short, long, value_name = "WxH")]
    pub size: Option<Size>,
    /// Reflections and refractions that a ray is followed through
    #[arg(long, default_value_t = 5, value_name = "N", value_parser = choice::whole(0..=MAX_DEPTH))]
    pub depth: u32,
    /// Times that each picture is traced; the quickest counts
    #[arg(long, default_value_t = 5, value_name = "N", value_parser = choice::whole(1_u32..=10_000), conflicts_with_all = ["record", "check"])]
    pub runs: u32,
    /// Do not count instructions
    #[arg(long, conflicts_with_all = ["record", "check"])]
    pub no_instructions: bool,
    /// Trace with one thread and with two, and tell how much sooner two are done
    #[arg(long, conflicts_with_all = ["record", "check"])]
    pub scaling: bool,
    /// Another ray tracer that renders the same scenes in turn with rta
    #[arg(long, value_enum, ignore_case = true, value_name = "PROGRAM", conflicts_with_all = ["record", "check"])]
    pub peer: Option<Peer>,
    /// Compare light that goes round: a room by two passes, and by the other's radiosity; beside Mitsuba by paths of both
    ///
    /// The error of both is against a picture of converged paths, after the scaling by one factor that suits best; costs are CPU time and
    /// instructions of whole processes, and for paths the CPU time of drawing alone. Without a scene the Cornell box.
    #[arg(long, requires = "peer", conflicts_with_all = ["record", "check", "scaling"])]
    pub light: bool,
    /// Compare soft shadows and what is out of focus: at several settings of both, the error against a converged picture of its own
    ///
    /// Costs are CPU time and instructions of whole processes. Without a scene one with a lamp that is a ball, and one with a lens.
    #[arg(long, requires = "peer", conflicts_with_all = ["light", "record", "check", "scaling"])]
    pub spread: bool,
    /// Write the instructions of small pictures into a CSV file
    #[arg(long, value_name = "FILE", conflicts_with = "check")]
    pub record: Option<PathBuf>,
    /// Count the instructions of small pictures again and fail where there are over 5 % more than in a CSV file
    ///
    /// A file of another compiler, machine or profile is not compared. Without valgrind nothing is, which is an error
    /// where the environment variable CI is set.
    #[arg(long, value_name = "FILE")]
    pub check: Option<PathBuf>,
}

/// A ray tracer to compare with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Peer {
    /// POV-Ray 3.7, one thread: the time that it says tracing took, without parsing.
    Povray,
    /// Mitsuba 3, scalar, by its module for Python 3: paths in a room, with --light alone.
    Mitsuba,
}

/// `rta traced`.
#[derive(Args, Clone, Debug)]
pub struct TracedArgs {
    /// Names of scenes in the program, or - for a scene file on standard input.
    pub scenes: Vec<String>,
    /// Number formats, each with every scene.
    #[arg(long, value_parser = choice::format(), ignore_case = true, value_delimiter = ',')]
    pub format: Vec<Format>,
    /// Pixels.
    #[arg(long)]
    pub size: Option<Size>,
    /// Recursion depth.
    #[arg(long, default_value_t = 5)]
    pub depth: u32,
}

/// `rta report`.
#[derive(Args, Debug)]
pub struct ReportArgs {
    /// Scene files; without one, the three of the thesis, and with --light the Cornell box
    pub scenes: Vec<PathBuf>,
    /// Folder that the report is written to; it is made if it is not there
    #[arg(short, long, value_name = "FOLDER")]
    pub output: PathBuf,
    /// Compare the ways to find light that goes round: ambient light, radiosity, two passes, distributed rays and paths
    ///
    /// For rooms in which something emits: error against a picture of converged paths, rays, CPU time and instructions, on one
    /// diagram for each scene, with the pictures side by side.
    #[arg(long)]
    pub light: bool,
    /// Do not count instructions: cost is rays
    #[arg(long)]
    pub no_instructions: bool,
    /// Pixels of the pictures [default: 320x200, the most without --light; with it half of the scene's]; few are soon measured, and badly
    #[arg(long, value_name = "WxH", hide = true)]
    pub size: Option<Size>,
    /// Shape of the screen [default: 4:3; with --light the scene's].
    #[arg(long, value_name = "RATIO", hide = true)]
    pub aspect: Option<Aspect>,
}

/// `rta figures`.
#[derive(Args, Debug)]
pub struct FiguresArgs {
    /// Folder that the figures are written to; it is made if it is not there
    #[arg(short, long, value_name = "FOLDER")]
    pub output: PathBuf,
    /// The pictures of the second page are so many times lower and less wide; few pixels are soon drawn, and badly
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = choice::whole(1_u32..=32), hide = true)]
    pub coarse: u32,
}

/// `rta gallery`.
#[derive(Args, Debug)]
pub struct GalleryArgs {
    /// Folder that the pictures, their scenes and the page are written to; it is made if it is not there
    #[arg(short, long, value_name = "FOLDER", required_unless_present = "check", conflicts_with = "check")]
    pub output: Option<PathBuf>,
    /// Write nothing, and compare the pictures with those in a clone of the repository
    ///
    /// Sizes, shapes of pixels and colours count, of films all bytes. Diagrams of what was measured are not compared.
    #[arg(long, value_name = "FOLDER")]
    pub check: Option<PathBuf>,
    /// Leave out the diagrams of rta report, whose measurements take minutes
    #[arg(long, conflicts_with = "check")]
    pub no_report: bool,
}

/// `rta instructions`: the scene comes from standard input.
#[derive(Args, Debug)]
pub struct InstructionsArgs {
    /// Pixels of the pictures.
    #[arg(long)]
    pub size: Size,
    /// Shape of the screen.
    #[arg(long)]
    pub aspect: Aspect,
    /// The work of --light.
    #[arg(long)]
    pub light: bool,
}

/// `rta stability`.
#[derive(Args, Debug)]
pub struct StabilityArgs {
    /// Rays from the eye, for each case and format
    #[arg(long, default_value_t = 200_000, value_name = "N", value_parser = choice::whole(1_usize..=100_000_000))]
    pub rays: usize,
    /// Markdown file that gets the table too, in the place that is marked in it for that
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// `rta palette`: all tables and ditherings, so none is chosen.
#[derive(Args, Debug)]
#[command(mut_arg("table", |table| table.hide(true)), mut_arg("dither", |dither| dither.hide(true)))]
pub struct PaletteArgs {
    /// Scene file (.dat, .nff or .p3f), or - for standard input
    pub scene: PathBuf,
    /// The display to emulate [default: one after the other]
    #[arg(short, long, value_enum, ignore_case = true)]
    pub device: Option<Device>,
    /// Picture file that gets all the pictures side by side, reduced, each row after the one without a device
    #[arg(long, value_name = "FILE")]
    pub sheet: Option<PathBuf>,
    /// Do not count instructions
    #[arg(long)]
    pub no_instructions: bool,
    /// How the picture is traced.
    #[command(flatten)]
    pub tracing: TracingArgs,
}

/// `rta visibility`.
#[derive(Args, Debug)]
pub struct VisibilityArgs {
    /// Scene file (.rta, .dat, .nff or .p3f), or - for standard input
    pub scene: PathBuf,
    /// How the scene is read; --tessellate is 8 unless it is given
    #[command(flatten)]
    pub reading: ReadingArgs,
    /// Pixels of the picture [default: those of the scene, else 320x200]
    #[arg(short, long, value_name = "WxH")]
    pub size: Option<Size>,
    /// Shape of the screen that the picture fills [default: that of square pixels, but 320x200 is a 4:3 screen]
    #[arg(long, value_name = "RATIO")]
    pub aspect: Option<Aspect>,
    /// Also tell what the algorithms cost as faces grow, at about these numbers of them: 100,2500,60000 are those of the table of 1974
    #[arg(long, value_name = "N,N,...", value_delimiter = ',', value_parser = choice::whole(1_usize..=1_000_000))]
    pub faces: Vec<usize>,
    /// Picture file of what is seen, each triangle in a colour of its own
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// `rta indexing`: linear light comes from standard input, as the pixels of a PFM from the top.
#[derive(Args, Debug)]
pub struct IndexingArgs {
    /// The display.
    #[arg(long, value_enum)]
    pub device: Device,
    /// Pixels of the picture.
    #[arg(long)]
    pub size: Size,
    /// The most samples of which a colour table is made.
    #[arg(long)]
    pub table_samples: u32,
}

/// `rta difference`.
#[derive(Args, Debug)]
pub struct DifferenceArgs {
    /// PNG file of the picture as it should be
    pub reference: PathBuf,
    /// PNG file of the picture that is compared with it
    pub test: PathBuf,
    /// Pixels in one degree of the visual field: 13, 38 and 35 before the screens of vga, graphigs and pixrect
    #[arg(short, long, value_name = "N", default_value_t = PixelsPerDegree::DEFAULT)]
    pub pixels_per_degree: PixelsPerDegree,
}

/// `rta compare`: several models or displays, so none is chosen.
#[derive(Args, Debug)]
#[command(mut_arg("model", |model| model.hide(true)), mut_arg("table", |table| table.hide(true)))]
#[command(mut_arg("dither", |dither| dither.hide(true)))]
pub struct CompareArgs {
    /// Scene files, or - for standard input
    #[arg(required = true)]
    pub scenes: Vec<PathBuf>,
    /// Illumination models with commas between them, or all
    #[arg(long, value_name = "A,B,...", default_value = "all")]
    pub models: choice::Models,
    /// Displays with commas between them, in place of the models: each shows the scenes as they are, by the model that they were made for
    #[arg(
        long,
        value_enum,
        ignore_case = true,
        value_name = "A,B,...",
        value_delimiter = ',',
        conflicts_with = "models"
    )]
    pub devices: Vec<Target>,
    /// Picture file that gets the pictures side by side
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    /// How the pictures are traced.
    #[command(flatten)]
    pub tracing: TracingArgs,
}

/// `rta values`.
#[derive(Args, Debug)]
pub struct ValuesArgs {
    /// Text that states values, or - for standard input
    #[arg(value_name = "FILE")]
    pub text: PathBuf,
    /// Number format
    #[arg(short, long, value_parser = choice::format(), ignore_case = true, default_value_t = Format::F64)]
    pub format: Format,
    /// Error that a value may have, as a part of it [default: 1e-6 in f64, 1e-5 in f32, each function's own in fixed point]
    #[arg(long, value_name = "T", value_parser = tolerance)]
    pub tolerance: Option<f64>,
}

fn tolerance(text: &str) -> Result<f64, &'static str> {
    text.parse().ok().filter(|t: &f64| t.is_finite() && *t >= 0.0).ok_or("expected a number of 0 or more")
}
