//! The command line of rta: its commands, their options and the values of those. Nothing is done with them here.
#![forbid(unsafe_code)]

mod advice;
mod choice;
mod explain;
pub mod light;
mod pages;
mod picture;
pub mod radiosity;
mod scene;
pub mod spreading;
mod study;
mod tracing;
pub mod value;

use clap::{Parser, Subcommand};

pub use advice::parse;
pub use explain::{Choice, ExplainArgs};
pub use pages::{CompletionsArgs, ManArgs};
pub use picture::{DrawingArgs, FilmArgs, HashArgs, JuggleArgs, MergeArgs, RenderArgs, ShowArgs};
pub use radiosity::RadiosityArgs;
pub use scene::{BakeArgs, CheckArgs, ConvertArgs, ReadingArgs};
pub use study::{
    BenchArgs, CompareArgs, DifferenceArgs, FiguresArgs, GalleryArgs, IndexingArgs, InstructionsArgs,
    PaletteArgs, Peer, ReportArgs, StabilityArgs, TracedArgs, ValuesArgs, VisibilityArgs,
};
pub use tracing::TracingArgs;

const EXAMPLES: &str = "\
Examples:
  rta                                               the Juggler on a PS/2
  rta glass-2.dat -d pixrect                        a scene on a SPARCstation, as rta show does
  rta render hall-22.dat -o hall.png --format q16   traced in fixed point, as firmware does
  rta render hall-22.dat -o hall.pfm --device none --size 640x480
  rta render - -o - --device none --as ppm <hall-22.dat | pnmtopng >hall.png
  rta render balls2.nff -o balls.png --device none  an NFF scene, as large as it says

rta help scene tells the language of a scene file.
Short options of a picture are the keys of its window: -d device, -m model, -f format, -t table.
Status: 0 if all went well, 2 after any error, 130 if interrupted.";

/// A Whitted ray tracer in fixed point and float, on the displays of 1990
///
/// Without a command, rta shows a scene, or without one the Juggler (Eric Graham, 1987) as an IBM PS/2 would.
#[derive(Debug, Parser)]
#[command(name = "rta", version, after_help = EXAMPLES, max_term_width = 100, override_usage = "rta [SCENE] [OPTIONS OF rta show]\n       rta <COMMAND>")]
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
    /// The picture grows finer as it is traced, and in passes where its rays are spread. Keys: D next device, M next illumination model, F next number format,
    /// T next colour table, X next dithering, + and - (or up and down) depth, R read the scene file again (a change on disk does so by
    /// itself), S save as a PNG in the current folder once the picture is complete, P palette, I the pixel under the
    /// mouse, F11 full screen, H or F1 these keys, Esc or Q leave. A film: space pauses it or goes on, comma and full stop (or left
    /// and right) go one frame back or on.
    ///
    /// With no display (neither DISPLAY nor WAYLAND_DISPLAY, or no window to be had) the picture or the film is written as a
    /// PNG into the current folder. No file is ever overwritten by this command.
    Show(ShowArgs),
    /// Trace a scene into a picture file
    ///
    /// The file appears complete or not at all: it gets its name, or replaces a file of that name, at the end. Pipes and
    /// devices are written directly. A line on standard error tells of the picture. The bytes do not depend on the number of threads.
    #[command(after_help = EXAMPLES)]
    Render(RenderArgs),
    /// Draw the Juggler's film: Eric Graham's figure of 1987, whose three balls fly
    ///
    /// 24 frames, as his, unless --frames says otherwise; all options are those of rta render, and the scene is scenes/juggler.rta.
    Juggle(JuggleArgs),
    /// Make a picture or a film of its parts, which several machines traced by rta render --rows or --only
    ///
    /// It is, byte for byte, the one that rta render makes of the whole. Parts that are cut off or damaged, overlap, leave a gap, or
    /// belong to other settings or another scene are refused.
    Merge(MergeArgs),
    /// Solve for the light that diffuse surfaces send to each other
    ///
    /// Quads, boxes, triangles and polygons are divided into patches, and what each receives from all others is found: once, for all
    /// eyes (Goral, Torrance, Greenberg and Battaile 1984). One row for each quad with the mean of its radiosity, which is pi times
    /// the radiance of its surface, and the energy balance. What emits is a quad whose material says so. The solution is kept with -o.
    Radiosity(RadiosityArgs),
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
    /// Write a scene in another format: .rta says all, .dat what the thesis could
    ///
    /// The picture stays as it is. The language of a .rta is told by rta help scene.
    Convert(ConvertArgs),
    /// Print a hash of a scene's picture on a device
    ///
    /// 64 bits over the pixels and the colours that the device is sent. In fixed point, which is what this command traces in
    /// unless told otherwise, every machine arrives at the same number: a port that prints it too draws the right bytes.
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
    ///
    /// Of scenes whose rays can be spread, the page and spreading.csv also have error against cost for samples, sampler, lamps,
    /// antialiasing and splitting, slopes of log error over log samples, and the variances of a pixel with the best --split.
    ///
    /// With --light it compares instead how light that goes round in a room is found, by all methods from ambient light to paths: light.md,
    /// light.csv, and for each scene its diagrams and its pictures.
    Report(ReportArgs),
    /// Draw the thesis's figures again, and run its techniques and times again: two pages
    ///
    /// What surfaces reflect, glass bends and air takes away, as curves of the functions that pictures are made with, and
    /// spheres by every model. In the folder it leaves index.html with captions, formulas and sources, and each figure
    /// as a PNG, a diagram also as an SVG. Beside it thesis.html has the techniques of the thesis's table 3.1, each as a picture of one
    /// room with its year, paper, error against paths of light and cost, and the machines, compositions and times of its appendix with
    /// those of this host; its pictures, scenes and solutions are in the folder thesis. It takes a minute or two.
    Figures(FiguresArgs),
    /// Draw every picture of the documents, on one page with the commands that draw them
    ///
    /// In the folder it leaves index.html, the pictures where the commands put them, and the scenes that they are drawn from, so that each
    /// command can be tried in it. Files of these names that are there already are replaced. It takes about a minute, and some more for the
    /// diagram of rta report, where instructions are counted. With --check, status 1 if a picture is not the one in the repository.
    Gallery(GalleryArgs),
    /// Measure how long pictures take on one core
    ///
    /// Each is traced several times by one thread, by the same code as a picture file without a device, and the least
    /// CPU time counts. Rays are counted apart, by kind, and so are retired instructions (where valgrind is installed).
    /// Of random spheres the table is followed by how the time of a ray grows with their number.
    Bench(BenchArgs),
    /// Show a scene by every colour table with every dithering
    ///
    /// Of each device one table: how visible the difference from the picture without a device is, FLIP (0 to 1) at the device's own
    /// pixels a degree of the visual field and at the 67 of a screen of today, S-CIELAB at the device's, PSNR; and what turning a
    /// pixel's light into an index costs, as retired instructions (where valgrind is installed) and as bytes of RAM. The default
    /// has a star.
    Palette(PaletteArgs),
    /// Tell how visible the difference of two pictures is
    ///
    /// FLIP (0 to 1) and S-CIELAB at a distance, which is a number of pixels in one degree of the visual field, and PSNR. Codes are
    /// read as sRGB.
    Difference(DifferenceArgs),
    /// List the illumination models: year, author, formula, rays and cost
    Models,
    /// Draw scenes by several illumination models, or on several displays, side by side on one sheet
    Compare(CompareArgs),
    /// Compare stated values of illumination models with what the program computes
    ///
    /// A text states a value as name(arguments) = number, as in fresnel(1.52,80) = 0.390949863; everything else in it is passed
    /// over. Each is printed with the number that is computed, the one that is stated, the relative error, and ok or OFF. The
    /// functions are those that pictures are drawn with. For students, and for whoever ports a model. Status 1 if a value is off.
    Values(ValuesArgs),
    /// Find what is seen by six algorithms side by side: Z-buffer, ray casting, painter, scan-line, area subdivision, scan-plane
    ///
    /// The scene is cut into triangles (--tessellate), which are clipped and snapped to integers before the eye, so that all comparisons
    /// are exact and each algorithm must come to the same triangle at each pixel. One row for each: whether its ids are equal, the steps that it took
    /// (looks at one thing: a test, a comparison, a write), its memory, CPU time. The scan-plane finds areas, and may differ within 1e-9 of
    /// an edge; rta's own tracer in f64 within 2^-30. What would take an algorithm too long is left out. Status 1 if ids differ.
    ///
    /// With --faces a table of the steps as faces grow, beside that of Sutherland, Sproull and Schumacker (1974), and where the costs of two
    /// algorithms cross.
    Visibility(VisibilityArgs),
    /// Print a script that completes commands and options in a shell
    ///
    /// For bash: rta completions bash >~/.local/share/bash-completion/completions/rta
    Completions(CompletionsArgs),
    /// Write the manual pages: rta.1, and one of each command
    Man(ManArgs),
    /// What `rta help scene` is.
    #[command(hide = true)]
    Language,
    /// What `rta bench` runs under valgrind.
    #[command(hide = true)]
    Traced(TracedArgs),
    /// What `rta report` runs under valgrind.
    #[command(hide = true)]
    Instructions(InstructionsArgs),
    /// What `rta palette` runs under valgrind.
    #[command(hide = true)]
    Indexing(IndexingArgs),
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

/// The code of the README, compiled and run with the other examples.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
