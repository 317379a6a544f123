//! The command line.

mod bench;

use std::path::PathBuf;

pub use bench::{BenchArgs, Peer, TracedArgs};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser, Subcommand, ValueEnum};

use crate::commands::explain::Choice;
use crate::engine::{Format, MAX_DEPTH, Model};
use crate::error::Error;
use crate::picture::device::{Device, Target};
use crate::picture::file::FileType;
use crate::picture::raster::{Aspect, Size};
use crate::picture::screen::TableKind;
use crate::request::Request;
use crate::request::sampling::{Cutoff, Samples};
use crate::request::scene_file::SceneFile;

const EXAMPLES: &str = "\
Examples:
  rta                                               the Juggler on a PS/2
  rta show glass-2.dat --device pixrect             a scene on a SPARCstation
  rta render hall-22.dat -o hall.png --format q16   traced in fixed point, as firmware does
  rta render hall-22.dat -o hall.pfm --device none --size 640x480
  rta render - -o - --device none --as ppm <hall-22.dat | pnmtopng >hall.png
  rta render balls2.nff -o balls.png --device none  an NFF scene, as large as it says

Status: 0 if all went well, 2 after any error, 130 if interrupted.";

/// A Whitted ray tracer in fixed point and float, on the displays of 1990
///
/// Without a command, rta shows the Juggler (Eric Graham, 1987) as an IBM PS/2 would.
#[derive(Debug, Parser)]
#[command(name = "rta", version, after_help = EXAMPLES, max_term_width = 100)]
pub struct Cli {
    /// What to do; nothing is `show`.
    #[command(subcommand)]
    pub command: Option<Command>,
}

/// What the program does.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Show a scene in a window, on the screen of a device
    ///
    /// The picture fills in as it is traced. Keys: D next device, M next illumination model, F next number
    /// format, T next colour table, + and - (or up and down) depth, R trace again, S save as a PNG in the current
    /// folder, H or F1 these keys, Esc or Q leave.
    ///
    /// With no display (neither DISPLAY nor WAYLAND_DISPLAY, or no window to be had) the picture is written as a
    /// PNG into the current folder. No file is ever overwritten by this command.
    Show(ShowArgs),
    /// Trace a scene into a picture file
    ///
    /// The file appears complete or not at all: it is written beside its place and renamed at the end. Pipes and
    /// devices are written directly. The bytes do not depend on the number of threads.
    #[command(after_help = EXAMPLES)]
    Render(RenderArgs),
    /// Put every number format through the cases that break ray tracers, beside f64
    ///
    /// One row for each case and format: panics, overflows, lights that are no number, points that shadow themselves,
    /// wrong hits and misses, and the error in levels of 255. Overflow is found by builds that check every operation:
    /// cargo run --profile checked -- stability.
    Stability(StabilityArgs),
    /// Prove that a scene fits a number format
    ///
    /// One row for each quantity of the tracer: the largest size it can have over all rays of the scene, the
    /// largest the format holds, how many bits are left, and which object sets the bound. A scene that is refused
    /// is an error that names the row, and the formats that take it.
    Check(CheckArgs),
    /// Turn a scene into Rust source: static data for a firmware's flash
    ///
    /// The scene in one number format, with what it needs of the tracer, after the proof that it fits. The target reads
    /// no file, builds no table and, in fixed point, computes no float. A build script does the same with
    /// rta_scenes::bake.
    Bake(BakeArgs),
    /// Print a hash of a scene's picture on a device
    ///
    /// 64 bits over the pixels and the colours that the device is sent. In fixed point every machine arrives at the same
    /// number: a port that prints it too draws the right bytes.
    Hash(HashArgs),
    /// Tell why a pixel is what it is in a number format, beside f64
    ///
    /// Its colour in both, its ray tree in both, the first decision that came out otherwise with both operands, and the
    /// operations of the tracer that lost most, each with its place in the source.
    Explain(ExplainArgs),
    /// Measure error against run time
    ///
    /// Every combination of number format, recursion depth, contribution cut-off and samples a pixel is traced, its
    /// error measured apart (rounding, truncation, sampling, display) and together, and its cost as rays, as retired
    /// instructions (where valgrind is installed) and as CPU seconds. It takes minutes. In the folder it leaves
    /// report.md, which names the cheapest setting for each error, report.csv with everything, and for each scene
    /// a work-precision diagram in SVG and PNG.
    Report(ReportArgs),
    /// Measure how long pictures take on one core
    ///
    /// Each is traced several times by one thread, by the same code as a picture file without a device, and the least
    /// CPU time counts. Rays are counted apart, by kind, and so are retired instructions (where valgrind is installed).
    /// Of random spheres the table is followed by how the time of a ray grows with their number.
    Bench(BenchArgs),
    /// What `rta bench` runs under valgrind.
    #[command(hide = true)]
    Traced(TracedArgs),
    /// What `rta report` runs under valgrind.
    #[command(hide = true)]
    Instructions(InstructionsArgs),
}

/// `rta show`.
#[derive(Args, Debug)]
pub struct ShowArgs {
    /// Scene file (.dat or .nff), or - for standard input; without one, the Juggler
    pub scene: Option<PathBuf>,
    /// The display to emulate
    #[arg(long, value_enum, default_value_t = Device::Vga)]
    pub device: Device,
    /// How the picture is traced.
    #[command(flatten)]
    pub tracing: TracingArgs,
}

/// `rta check`.
#[derive(Args, Debug)]
pub struct CheckArgs {
    /// Scene file (.dat or .nff), or - for standard input
    pub scene: PathBuf,
    /// Number format
    #[arg(long, value_enum, default_value_t = Format::Q16)]
    pub format: Format,
    /// Shape of the screen
    #[arg(long, value_name = "RATIO", default_value = "4:3")]
    pub aspect: Aspect,
    /// Scale the scene by a power of two if it does not fit the number format (not one with a floor)
    #[arg(long)]
    pub fit: bool,
}

/// `rta bake`.
#[derive(Args, Debug)]
pub struct BakeArgs {
    /// Scene file (.dat or .nff), or - for standard input
    pub scene: PathBuf,
    /// Number format
    #[arg(long, value_enum, default_value_t = Format::Q16)]
    pub format: Format,
    /// Illumination model that the scene is drawn with, which decides what it needs [default: rta, or phong for .nff]
    #[arg(long, value_enum)]
    pub model: Option<Model>,
    /// Shape of the screen that the whole picture fills
    #[arg(long, value_name = "RATIO", default_value = "4:3")]
    pub aspect: Aspect,
    /// Scale the scene by a power of two if it does not fit the number format (not one with a floor)
    #[arg(long)]
    pub fit: bool,
    /// Rust file; - is standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
}

/// `rta hash`.
#[derive(Args, Debug)]
pub struct HashArgs {
    /// Scene file (.dat or .nff), or - for standard input
    pub scene: PathBuf,
    /// The display
    #[arg(long, value_enum, default_value_t = Device::Vga)]
    pub device: Device,
    /// How the picture is traced.
    #[command(flatten)]
    pub tracing: TracingArgs,
}

/// `rta explain`.
#[derive(Args, Debug)]
pub struct ExplainArgs {
    /// Scene file (.dat or .nff), or - for standard input
    pub scene: PathBuf,
    /// Column and row from 0,0 in the upper left corner, or worst: the one whose colour is farthest off
    #[arg(long, value_name = "X,Y")]
    pub pixel: Choice,
    /// Number format that is put beside f64
    #[arg(long, default_value = "q16", value_parser = PossibleValuesParser::new(["f32", "q16", "q20"])
        .try_map(|name| Format::from_str(&name, false)))]
    pub format: Format,
    /// Illumination model [default: what the scene was made for: rta, or phong for .nff]
    #[arg(long, value_enum)]
    pub model: Option<Model>,
    /// Reflections and refractions that a ray is followed through; 0 is what the eye sees directly
    #[arg(long, default_value_t = 5, value_name = "N", value_parser = clap::value_parser!(u32).range(..=i64::from(MAX_DEPTH)))]
    pub depth: u32,
    /// Pixels of the picture [default: those of a .nff, else 320x200]
    #[arg(long, value_name = "WxH")]
    pub size: Option<Size>,
    /// Shape of the screen, as 4:3 or 1.333 [default: square pixels, except that 320x200 is a 4:3 screen]
    #[arg(long, value_name = "RATIO")]
    pub aspect: Option<Aspect>,
    /// Scale the scene by a power of two if it does not fit the number format (not one with a floor)
    #[arg(long)]
    pub fit: bool,
}

impl ExplainArgs {
    /// The picture to which the pixel belongs: one ray through the middle of each pixel, without a device.
    #[must_use]
    pub fn tracing(&self) -> TracingArgs {
        let Self { format, model, depth, size, aspect, fit, .. } = *self;
        TracingArgs { format, model, depth, size, aspect, fit, ..ShowArgs::default().tracing }
    }
}

/// `rta render`.
#[derive(Args, Debug)]
pub struct RenderArgs {
    /// Scene file (.dat or .nff), or - for standard input
    pub scene: PathBuf,
    /// Picture file: .png, .ppm or .pfm; - is standard output
    ///
    /// A PNG from a device is indexed, with the device's own colour table. A PFM holds linear light, unclamped,
    /// and needs --device none.
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    /// The display to emulate, or none for 8 bits a gun without a colour table
    #[arg(long, value_enum, default_value_t = Target::On(Device::Vga))]
    pub device: Target,
    /// Kind of picture, whatever the name of the file says [default: by the extension; png into pipes]
    #[arg(long = "as", value_enum, value_name = "TYPE")]
    pub file_type: Option<FileType>,
    /// How the picture is traced.
    #[command(flatten)]
    pub tracing: TracingArgs,
}

/// `rta stability`.
#[derive(Args, Debug)]
pub struct StabilityArgs {
    /// Rays from the eye, for each case and format
    #[arg(long, default_value_t = 200_000, value_name = "N")]
    pub rays: usize,
    /// Markdown file that gets the table too, in the place that is marked in it for that
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// `rta report`.
#[derive(Args, Debug)]
pub struct ReportArgs {
    /// Scene files (.dat or .nff); without one, the three that come with the program
    pub scenes: Vec<PathBuf>,
    /// Folder that the report is written to; it is made if it is not there
    #[arg(short, long, value_name = "FOLDER")]
    pub output: PathBuf,
    /// Do not count instructions: cost is rays
    #[arg(long)]
    pub no_instructions: bool,
    /// Pixels of the pictures, up to 320x200; few are soon measured, and badly
    #[arg(long, value_name = "WxH", default_value = "320x200", hide = true)]
    pub size: Size,
    /// Shape of the screen.
    #[arg(long, value_name = "RATIO", default_value = "4:3", hide = true)]
    pub aspect: Aspect,
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
}

/// How a picture is traced, for every command.
#[derive(Args, Clone, Debug)]
pub struct TracingArgs {
    /// Number format of the tracer
    #[arg(long, value_enum, default_value_t = Format::F32)]
    pub format: Format,
    /// Illumination model [default: what the scene was made for: rta, or phong for .nff]
    #[arg(long, value_enum)]
    pub model: Option<Model>,
    /// Reflections and refractions that a ray is followed through; 0 is what the eye sees directly
    #[arg(long, default_value_t = 5, value_name = "N", value_parser = clap::value_parser!(u32).range(..=i64::from(MAX_DEPTH)))]
    pub depth: u32,
    /// A ray that would bring less than this part of its light into the pixel is not traced: 1/64, or 0 for all
    #[arg(long, value_name = "PART", default_value_t = Cutoff::OFF)]
    pub cutoff: Cutoff,
    /// Samples of a pixel, on a square grid: 1, 4, 9, 16 ... 1024
    #[arg(long, value_name = "N", default_value_t = Samples::ONE)]
    pub samples: Samples,
    /// Jitter the samples, each in its own cell of the grid, by this seed
    #[arg(long, value_name = "SEED")]
    pub jitter: Option<u32>,
    /// Colour table of the device
    #[arg(long, value_enum, default_value_t = TableKind::Tolerant)]
    pub table: TableKind,
    /// Pixels of the picture [default: the device's; with --device none those of a .nff, else 320x200]
    ///
    /// On a device the picture is a window in its raster, so it may not be larger, and its pixels keep their
    /// shape. Up to 65535 pixels a side; with --device none only a band of rows is held in memory.
    #[arg(long, value_name = "WxH")]
    pub size: Option<Size>,
    /// Shape of the screen that the picture fills, as 4:3 or 1.333
    ///
    /// [default: the device's shape, or the shape that its pixels give a window of --size; with --device none
    /// square pixels, except that 320x200 is a 4:3 screen]
    #[arg(long, value_name = "RATIO", verbatim_doc_comment)]
    pub aspect: Option<Aspect>,
    /// Scale the scene by a power of two if it does not fit the number format (not one with a floor)
    #[arg(long)]
    pub fit: bool,
    /// Threads that trace [default: one for each core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
}

impl TracingArgs {
    /// The request that these arguments make of `target`, whatever the scene: with the thesis's model where they name
    /// none.
    #[must_use]
    pub fn request(&self, target: Target) -> Request {
        let Self { format, depth, cutoff, table, size, aspect, fit, .. } = *self;
        let model = self.model.unwrap_or(Model::Rta);
        let sampling = self.samples.sampling(self.jitter);
        Request { target, table, format, model, depth, cutoff, sampling, size, aspect, fit }
    }

    /// The same for a scene.
    ///
    /// # Errors
    /// Those of [`Request::for_scene`].
    pub fn request_for(&self, target: Target, scene: &SceneFile) -> Result<Request, Error> {
        self.request(target).for_scene(self.model, scene)
    }
}

impl Default for ShowArgs {
    fn default() -> Self {
        let tracing = TracingArgs {
            format: Format::F32,
            model: None,
            depth: 5,
            cutoff: Cutoff::OFF,
            samples: Samples::ONE,
            jitter: None,
            table: TableKind::Tolerant,
            size: None,
            aspect: None,
            fit: false,
            threads: None,
        };
        Self { scene: None, device: Device::Vga, tracing }
    }
}

#[cfg(test)]
mod tests {
    use clap::{CommandFactory, Parser};

    use super::{Cli, Command, ShowArgs};

    #[test]
    fn the_definition_is_sound() {
        Cli::command().debug_assert();
    }

    #[test]
    fn no_command_is_show_without_options() {
        let cli = Cli::try_parse_from(["rta", "show"]).expect("a command");
        let Some(Command::Show(args)) = cli.command else { panic!("not show") };
        assert_eq!(format!("{args:?}"), format!("{:?}", ShowArgs::default()));
    }
}
