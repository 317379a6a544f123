//! A technique drawn: its picture, its error against paths of light, and its cost.

use core::sync::atomic::Ordering;
use std::path::Path;

use clap::Parser;
use cpu_time::ThreadTime;
use rta_core::color::Rgb;

use super::room::{PLAIN, Variant};
use super::technique::{Against, LENS, Technique, Way};
use super::{Fineness, Tracing};
use crate::args::{Cli, Command, RadiosityArgs, RenderArgs};
use crate::engine::Engine;
use crate::engine::radiosity;
use crate::picture::device::Target;
use crate::picture::output::{Inputs, write_text};
use crate::picture::raster::Size;
use crate::request::{Request, solution};
use crate::study::error::StudyError;
use crate::study::palette::traced;
use crate::study::report::measure::shown_error;

mod visible;

/// Stem of the name of the reference's picture.
pub const REFERENCE: &str = "paths";

/// Samples of each of the two pictures that are the reference together.
pub const SAMPLES: u32 = 256;

/// Their seeds: those of other pictures are 0.
const SEEDS: [u32; 2] = [24301, 24302];

/// Rows that are traced between two looks at whether the work is to end.
const ROWS: usize = 4;

/// A picture, its error and its cost.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// Pixels.
    pub size: Size,
    /// Width over height of the screen.
    pub aspect: f64,
    /// Linear light, row by row from the top.
    pub light: Vec<Rgb<f32>>,
    /// Root of the mean square of the differences of light, cut to 0 to 1, from that of paths; `None` where it is not compared.
    pub error: Option<f64>,
    /// What it takes.
    pub cost: Cost,
    /// The commands that draw it, in the folder of the page's pictures.
    pub commands: Vec<String>,
}

/// What a picture takes. All but the seconds is the same in every run.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cost {
    /// Rays of the picture, or steps of an algorithm of visibility.
    pub rays: u64,
    /// Whether they are steps: looks at one thing each, as `rta visibility` counts them.
    pub is_steps: bool,
    /// Rays with which light was solved before.
    pub solving: u64,
    /// CPU seconds on one thread, all together.
    pub seconds: f64,
}

/// The pictures that others are compared with.
#[derive(Clone, Debug)]
pub struct References {
    whole: Drawn,
    own: Drawn,
}

impl References {
    /// Draws them.
    pub(super) fn new(folder: &Path, fineness: Fineness, tracing: &Tracing) -> Result<Self, StudyError> {
        let reference = |scene: Variant, lens: &str| {
            let samples = (SAMPLES / (fineness.coarse * fineness.coarse)).max(4).next_power_of_two();
            let options = SEEDS.map(|seed| {
                format!("--integrator paths --samples {samples} --seed {seed}{}{lens}", separator(lens))
            });
            paths(scene, &options, (folder, fineness), tracing)
        };
        Ok(Self { whole: reference(PLAIN, "")?, own: reference(super::room::ROUGH, LENS)? })
    }

    /// Returns the picture of the scene as it is shipped; its error is what the two pictures tell of it that it is the mean of.
    #[must_use]
    pub const fn whole(&self) -> &Drawn {
        &self.whole
    }

    fn of(&self, against: Against) -> Option<&Drawn> {
        match against {
            Against::Paths => Some(&self.whole),
            Against::OwnPaths => Some(&self.own),
            Against::Nothing => None,
        }
    }
}

const fn separator(words: &str) -> &str {
    if words.is_empty() { "" } else { " " }
}

/// Returns the mean of two pictures of paths.
fn paths(
    scene: Variant,
    options: &[String; 2],
    (folder, fineness): (&Path, Fineness),
    tracing: &Tracing,
) -> Result<Drawn, StudyError> {
    let one = |options: &str| {
        let (args, command) = render((scene, REFERENCE), options)?;
        let (request, engine) = ready(scene, args, (folder, fineness))?;
        let (size, aspect) = request.raster()?;
        Ok::<_, StudyError>((
            traced::light(&engine, size, tracing.pool, tracing.stop)?,
            (size, aspect),
            command,
        ))
    };
    let [first, second] = options;
    let ((a, (size, aspect), command), (b, _, other)) = (one(first)?, one(second)?);
    let light = a.iter().zip(&b).map(|(a, b)| a.zip(*b, |a, b| (a + b) / 2.0)).collect();
    // Two independent pictures of equal noise: their mean has half of the difference between them.
    let error = Some(shown_error(&a, &b) / 2.0);
    Ok(Drawn { size, aspect, light, error, cost: Cost::default(), commands: vec![command, other] })
}

/// Reads the words of a command of the page.
fn parsed(words: &str) -> Result<Command, StudyError> {
    let cli = Cli::try_parse_from(words.split(' ')).ok();
    cli.and_then(|cli| cli.command).ok_or_else(|| StudyError::Figure { name: "thesis", source: words.into() })
}

/// Returns the arguments of a picture of a scene, and the command.
fn render((scene, name): (Variant, &str), options: &str) -> Result<(RenderArgs, String), StudyError> {
    let command =
        format!("rta render {}.rta -d none {options}{}-o {name}.png", scene.name, separator(options));
    match parsed(&command)? {
        Command::Render(args) => Ok((args, command)),
        _ => Err(StudyError::Figure { name: "thesis", source: command.into() }),
    }
}

/// Returns the request of a picture, and the scene made ready for it. What was solved lies in `folder`.
fn ready(
    scene: Variant,
    args: RenderArgs,
    (folder, fineness): (&Path, Fineness),
) -> Result<(Request, Engine), StudyError> {
    let mut tracing = args.drawing.tracing;
    tracing.light.light = tracing.light.light.map(|file| folder.join(file));
    let scene = scene.scene(tracing.reading.into())?;
    let mut request = Request::of_scene(&tracing, Target::None, &scene)?;
    request.size = request.size.map(|size| coarser(size, fineness));
    let engine = request.engine(&scene)?;
    Ok((request, engine))
}

/// Returns a coarser raster.
pub(super) fn coarser(size: Size, fineness: Fineness) -> Size {
    Size::clamped(fineness.side(size.width()), fineness.side(size.height()))
}

/// Traces a picture on this thread, and returns it with the seconds that it takes.
pub(super) fn traced_here(
    engine: &Engine,
    size: Size,
    tracing: &Tracing,
) -> Result<(Vec<Rgb<f32>>, f64), StudyError> {
    let mut light = vec![Rgb::default(); size.pixels()];
    let start = ThreadTime::now();
    for (first, rows) in (0..).step_by(ROWS).zip(light.chunks_mut(size.columns() * ROWS)) {
        if tracing.stop.load(Ordering::Relaxed) {
            return Err(StudyError::INTERRUPTED);
        }
        engine.linear_rows(first, rows);
    }
    Ok((light, start.elapsed().as_secs_f64()))
}

/// Draws a technique, if it is drawn.
pub(super) fn drawn(
    technique: &Technique,
    references: &References,
    (folder, fineness): (&Path, Fineness),
    tracing: &Tracing,
) -> Result<Option<Drawn>, StudyError> {
    match technique.way {
        Way::Absent(_) => Ok(None),
        Way::Visible { algorithm, shade } => {
            visible::visible(technique.name, (algorithm, shade), references, fineness).map(Some)
        }
        Way::Traced { scene, solved, options, against } => {
            let mut cost = Cost::default();
            let mut commands = Vec::new();
            let mut options = options.to_owned();
            if against == Against::OwnPaths {
                options += &format!(" {LENS}");
            }
            if let Some(solving) = solved {
                // Fewer patches for fewer pixels.
                let solving =
                    if fineness.coarse > 1 { format!("{solving} --patches 1") } else { solving.to_owned() };
                let file = format!("{}.txt", technique.name);
                let command = format!("rta radiosity {}.rta {solving} -o {file}", scene.name);
                (cost.solving, cost.seconds) = solve(scene, &command, folder, tracing)?;
                options = format!("--light {file} {options}");
                commands.push(command);
            }
            let (args, command) = render((scene, technique.name), &options)?;
            commands.push(command);
            let (request, engine) = ready(scene, args, (folder, fineness))?;
            let (size, aspect) = request.raster()?;
            let (light, seconds) = traced_here(&engine, size, tracing)?;
            cost.seconds += seconds;
            cost.rays = engine.rays().iter().sum();
            cost.solving += engine.rays_before();
            let error = references.of(against).map(|reference| shown_error(&light, &reference.light));
            Ok(Some(Drawn { size, aspect, light, error, cost, commands }))
        }
    }
}

/// Solves for light as a command of `rta radiosity` does, keeps it in its file, and returns the rays and the seconds that it takes.
fn solve(scene: Variant, command: &str, folder: &Path, tracing: &Tracing) -> Result<(u64, f64), StudyError> {
    let Command::Radiosity(args) = parsed(command)? else {
        return Err(StudyError::Figure { name: "thesis", source: command.into() });
    };
    let RadiosityArgs { reading, format, method, factors, patches, seed, sweeps, .. } = args;
    let scene = scene.scene(reading.into())?;
    let settings = radiosity::Settings { format, method, factors, patches, seed, sweeps };
    let start = ThreadTime::now();
    let failed =
        |source: radiosity::RadiosityError| StudyError::Figure { name: "thesis", source: source.into() };
    let solved = radiosity::solve(&scene.description, &settings, tracing.stop).map_err(failed)?;
    let seconds = start.elapsed().as_secs_f64();
    if let Some(file) = &args.output {
        let text = solution::text(&solved.solution, &scene.description);
        write_text(&folder.join(file), &text, Inputs::NONE)?;
    }
    Ok((solved.rays, seconds))
}
