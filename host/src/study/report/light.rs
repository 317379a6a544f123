//! `rta report --light`: all ways to find the light that goes round in a room, on one work-precision diagram.
//!
//! | step | where |
//! | --- | --- |
//! | the ways, and how each is made better | [`method`] |
//! | a room ready to be drawn by each of them, and its picture of converged paths | [`room`] |
//! | instructions under valgrind | [`counting`] |
//! | the files | [`diagram`], [`page`] |
//!
//! A picture's error is the RMSE of its light against converged paths, cut to white, over all pixels in which nothing is seen that emits.

use std::path::Path;
use std::sync::Arc;

use rayon::ThreadPool;
use rta_core::color::Rgb;
use rta_scenes::solution::{self, Shown};

use crate::args::{ReportArgs, ShowArgs};
use crate::engine::callgrind::CountError;
use crate::engine::progress::Progress;
use crate::engine::{bands, interrupt};
use crate::picture::device::Target;
use crate::picture::file::Caption;
use crate::picture::output::{self, Failure, Inputs, Output};
use crate::picture::raster::Size;
use crate::request::Request;
use crate::request::scene_file::SceneFile;
use crate::study::error::StudyError;
use crate::study::plot;

use super::study::Setup;
use super::{Source, sources};
use counting::Counts;
use diagram::{Axis, Diagram};
use method::{Method, SOLVINGS, Solving};
use room::{Reference, Room, timed};

pub mod counting;
pub mod diagram;
pub mod method;
pub mod page;
pub mod room;

/// A side of the pictures is a `STEP`th as long as that of the scene's.
pub const STEP: u32 = 2;

/// Samples of the paths that all pictures are compared with.
pub const REFERENCE: u32 = 4096;

/// One picture with its error and its cost.
#[derive(Clone, Debug)]
pub struct Row {
    /// How its light was found.
    pub method: Method,
    /// How the patches were solved, if they were.
    pub solving: Option<Solving>,
    /// Samples of a pixel.
    pub samples: u32,
    /// RMSE of its light against the reference, 1 is white.
    pub error: f64,
    /// Rays of the solution, and of the picture.
    pub rays: [u64; 2],
    /// CPU seconds of both on one thread.
    pub seconds: f64,
    /// Instructions of both, where they were counted.
    pub instructions: Option<f64>,
}

impl Row {
    /// Rays of the solution and of the picture.
    #[must_use]
    #[allow(clippy::cast_precision_loss)] // below 2^53
    pub fn all_rays(&self) -> f64 {
        self.rays.iter().sum::<u64>() as f64
    }
}

/// The study of one room.
#[derive(Debug)]
pub struct Study {
    /// The scene's name in file names and titles.
    pub title: String,
    /// Pixels of the pictures.
    pub size: Size,
    /// Width over height of the screen.
    pub aspect: f64,
    /// All pictures, method by method.
    pub rows: Vec<Row>,
    /// The picture of each method with the least error, linear light.
    pub best: Vec<(Method, Vec<Rgb<f32>>)>,
    /// The picture that all are compared with.
    pub reference: Reference,
    /// The ambient light that suits the room best, linear RGB.
    pub ambient: [f64; 3],
    /// Solutions that are left out, since a quad emits in a part that holds the middle of none of so many patches.
    pub left_out: Vec<Solving>,
    /// Why no instructions were counted.
    pub uncounted: Option<CountError>,
}

/// Runs `rta report --light`.
///
/// # Errors
/// All of [`StudyError`].
pub fn run(args: &ReportArgs) -> Result<(), StudyError> {
    let sources = if args.scenes.is_empty() { vec![Source::cornell()?] } else { sources(&args.scenes)? };
    output::make_folder(&args.output)?;
    let files = Files::open(&args.output, &sources)?;
    let program = std::env::current_exe().ok().filter(|_| !args.no_instructions);
    let (pool, stop) = (bands::pool(None)?, interrupt::watch());
    let study = |source: &Source| {
        let (size, aspect) =
            raster(&source.scene, STEP, (args.size, args.aspect.map(|aspect| aspect.ratio())))?;
        study(source, Setup { size, aspect, program: program.as_deref(), stop }, REFERENCE, &pool)
    };
    let studies = sources.iter().map(study).collect::<Result<Vec<_>, _>>()?;
    files.write(&studies)
}

/// Returns the pixels and the shape of a scene's pictures: those that are asked for, else a `step`th of the scene's columns and rows.
///
/// # Errors
/// Those of a scene's size.
pub(in crate::study) fn raster(
    scene: &SceneFile,
    step: u32,
    (size, aspect): (Option<Size>, Option<f64>),
) -> Result<(Size, f64), StudyError> {
    let request = Request::of(&ShowArgs::default().tracing, Target::None).for_scene(None, scene)?;
    let (whole, natural) = request.raster()?;
    let side = |pixels: u32| (pixels / step).max(1);
    let size = size.unwrap_or(Size::clamped(side(whole.width()), side(whole.height())));
    Ok((size, aspect.unwrap_or(natural)))
}

/// Makes the study of a room: every method with every solution and number of samples, compared with `reference` samples of paths.
///
/// # Errors
/// Those of [`Room::new`] and [`Room::solved`].
pub fn study(source: &Source, setup: Setup, reference: u32, pool: &ThreadPool) -> Result<Study, StudyError> {
    let mut room = Room::new(source, (setup.size, setup.aspect))?;
    let reference = room.reference(reference, (pool, setup.stop))?;
    room.suit_ambient(&reference)?;
    let (mut solved, mut left_out) = (Vec::new(), Vec::new());
    for solving in SOLVINGS {
        setup.go_on()?;
        match room.solved(solving, setup.stop)? {
            Some(light) => solved.push((solving, light)),
            None => left_out.push(solving),
        }
    }
    let mut rows = Vec::new();
    let mut best: Vec<(Method, Vec<Rgb<f32>>)> = Vec::new();
    let mut progress = Progress::new(u32::try_from(Method::ALL.len()).unwrap_or(u32::MAX));
    for (done, method) in (1..).zip(Method::ALL) {
        let mut least = f64::INFINITY;
        let mut picture = Vec::new();
        // Methods without patches have one curve of samples.
        let solutions: Vec<Option<&(Solving, room::Light)>> =
            if method.shown().is_some() { solved.iter().map(Some).collect() } else { vec![None] };
        for solution in solutions {
            let shown = solution.zip(method.shown()).map(|((_, light), shown)| light.shown(shown));
            for &samples in method.samples() {
                setup.go_on()?;
                let (engine, making) = timed(|| room.engine((method, samples), shown.as_ref()));
                let engine = engine?;
                let (light, drawing) = room.drawn(&engine);
                let before = engine.rays_before();
                // What gathers light for a picture has its share in the cost.
                let seconds = if before > 0 { making + drawing } else { drawing };
                let error = reference.error(&light);
                rows.push(Row {
                    method,
                    solving: solution.map(|(solving, _)| *solving),
                    samples,
                    error,
                    rays: [
                        solution.map_or(0, |(_, light)| light.rays),
                        before + engine.rays().into_iter().sum::<u64>(),
                    ],
                    seconds: seconds + solution.map_or(0.0, |(_, light)| light.seconds),
                    instructions: None,
                });
                if error < least {
                    (least, picture) = (error, light);
                }
            }
        }
        best.push((method, picture));
        progress.reached(done);
    }
    let uncounted = match setup.program.map(|program| Counts::of(source, setup, program)) {
        Some(Ok(counts)) => {
            counts.put(&mut rows);
            None
        }
        Some(Err(counting::Failed::Count(error))) => Some(error),
        Some(Err(counting::Failed::Study(error))) => return Err(error),
        None => None,
    };
    setup.go_on()?;
    let Setup { size, aspect, .. } = setup;
    let (title, ambient) = (source.title.clone(), room.ambient());
    Ok(Study { title, size, aspect, rows, best, reference, ambient, left_out, uncounted })
}

impl room::Light {
    /// Returns the light as it is shown.
    fn shown(&self, shown: Shown) -> Arc<solution::Solved> {
        Arc::new(solution::Solved { shown, solution: self.solution.clone() })
    }
}

/// The files of the report, each found to be writable and none of the scenes.
struct Files {
    csv: Output,
    page: Output,
    /// Of each scene the diagrams over the deterministic cost and over CPU time, as SVG and PNG, and the pictures side by side.
    scenes: Vec<([Output; 4], Output)>,
}

impl Files {
    fn open(folder: &Path, sources: &[Source]) -> Result<Self, StudyError> {
        let mut inputs = Inputs::default();
        sources.iter().for_each(|source| inputs.add(&source.scene.inputs));
        let open = |name: &str| Output::open(&folder.join(name), &inputs);
        let mut scenes = Vec::new();
        for Source { title, .. } in sources {
            let diagrams = [
                open(&format!("{title}-light.svg"))?,
                open(&format!("{title}-light.png"))?,
                open(&format!("{title}-light-seconds.svg"))?,
                open(&format!("{title}-light-seconds.png"))?,
            ];
            scenes.push((diagrams, open(&format!("{title}-light-pictures.png"))?));
        }
        Ok(Self { csv: open("light.csv")?, page: open("light.md")?, scenes })
    }

    fn write(self, studies: &[Study]) -> Result<(), StudyError> {
        self.csv.write(&page::csv(studies).map_err(StudyError::report)?)?;
        for (study, ([svg, png, seconds_svg, seconds_png], pictures)) in studies.iter().zip(self.scenes) {
            for (axis, svg, png) in [(Axis::Work, svg, png), (Axis::Seconds, seconds_svg, seconds_png)] {
                let drawing = Diagram { study, axis };
                svg.write(plot::svg(&drawing).map_err(StudyError::report)?.as_bytes())?;
                let diagram = plot::displayed(&drawing).map_err(StudyError::report)?;
                let caption = study.caption("error against cost of ways to find light that goes round");
                png.fill(|out| Ok::<_, Failure<StudyError>>(diagram.write_png(&caption, out)?))?;
            }
            let sheet = page::pictures(study)?;
            let caption = study.caption("light that goes round, by several ways");
            pictures.fill(|out| Ok::<_, Failure<StudyError>>(sheet.write_png(&caption, out)?))?;
        }
        Ok(self.page.write(page::markdown(studies).as_bytes())?)
    }
}

impl Study {
    fn caption(&self, settings: &str) -> Caption {
        Caption { title: self.title.clone(), settings: settings.to_owned() }
    }
}
