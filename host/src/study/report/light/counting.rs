//! Instructions of every method, counted by [`callgrind`]: the child solves and draws a little by each, and what a ray takes there it takes in
//! all of that method's pictures.

use core::sync::atomic::AtomicBool;
use std::path::Path;
use std::sync::Arc;

use rta_args::radiosity::Factors;
use rta_scenes::solution::Solved;

use super::Row;
use super::method::{Method, Solving};
use super::room::{Light, Room};
use crate::args::InstructionsArgs;
use crate::engine::Engine;
use crate::engine::callgrind::{self, CountError};
use crate::picture::raster::Size;
use crate::request::scene_file::SceneFile;
use crate::study::error::StudyError;
use crate::study::report::Source;
use crate::study::report::study::Setup;

/// The function that is counted, as callgrind is told: one for solving and drawing, since of two whose names begin alike it counts neither.
const COUNTED: [&str; 1] = ["*light_is_found"];

/// Pictures that are counted have a `STEP`th of the columns and rows.
const STEP: u32 = 4;

/// Samples of theirs.
const SAMPLES: u32 = 4;

/// The solution that is counted, and that is in the pictures.
const SOLVING: Solving = Solving { patches: None, factors: Factors::Rays(4) };

/// Why nothing was counted.
#[derive(Debug)]
pub enum Failed {
    /// Callgrind did not.
    Count(CountError),
    /// The rays could not be traced.
    Study(StudyError),
}

impl From<StudyError> for Failed {
    fn from(error: StudyError) -> Self {
        Self::Study(error)
    }
}

/// What a ray takes: instructions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Counts {
    /// Of a solution.
    solving: f64,
    /// Of the picture by each method.
    drawing: [f64; Method::ALL.len()],
}

/// The child's side: solves and draws, and prints nothing.
///
/// # Errors
/// Those of reading a scene and making it ready.
pub fn run(args: &InstructionsArgs) -> Result<(), StudyError> {
    let scene = SceneFile::open(Path::new("-"))?;
    let source = Source { title: scene.title.clone(), scene, text: Vec::new() };
    rays(&source, (args.size, args.aspect.ratio())).map(|_| ())
}

/// Solves and draws what is counted, and returns the rays: those of the solution, and of each picture.
fn rays(source: &Source, raster: (Size, f64)) -> Result<[u64; 1 + Method::ALL.len()], StudyError> {
    let room = Room::new(source, raster)?;
    let stop = AtomicBool::new(false);
    let light = light_is_found(&room, Work::Solution, &stop)?.0;
    let mut rays = [light.as_ref().map_or(0, |light| light.rays); 1 + Method::ALL.len()];
    for (rays, method) in rays.iter_mut().skip(1).zip(Method::ALL) {
        let shown = light.as_ref().zip(method.shown()).map(|(light, shown)| light.shown(shown));
        let asked = ((method, SAMPLES), shown.as_ref());
        let work = if method == Method::Cache {
            // What is gathered for a picture is a part of it.
            Work::Picture(asked)
        } else {
            Work::Drawing(room.engine(asked.0, asked.1)?)
        };
        if let (_, Some(engine)) = light_is_found(&room, work, &stop)? {
            *rays = engine.rays_before() + engine.rays().into_iter().sum::<u64>();
        }
    }
    Ok(rays)
}

/// What is counted.
enum Work<'a> {
    /// A solution.
    Solution,
    /// A picture whose scene is ready.
    Drawing(Engine),
    /// A picture, with what makes its scene ready.
    Picture(((Method, u32), Option<&'a Arc<Solved>>)),
}

/// Solves or draws, and returns the solution, or the tracer. Callgrind is told its name, so it must not be inlined.
#[inline(never)]
fn light_is_found(
    room: &Room,
    work: Work,
    stop: &AtomicBool,
) -> Result<(Option<Light>, Option<Engine>), StudyError> {
    let engine = match work {
        Work::Solution => return Ok((core::hint::black_box(room.solved(SOLVING, stop))?, None)),
        Work::Drawing(engine) => engine,
        Work::Picture((method, light)) => room.engine(method, light)?,
    };
    core::hint::black_box(room.drawn(&engine));
    Ok((None, Some(engine)))
}

impl Counts {
    /// Counts; `program` is this program.
    ///
    /// # Errors
    /// [`Failed`].
    #[allow(clippy::cast_precision_loss)] // below 2^53
    pub fn of(source: &Source, setup: Setup, program: &Path) -> Result<Self, Failed> {
        let side = |pixels: u32| (pixels / STEP).max(1);
        let size = Size::clamped(side(setup.size.width()), side(setup.size.height()));
        let [size_told, aspect] = [size.to_string(), setup.aspect.to_string()];
        let args = ["instructions", "--light", "--size", &size_told, "--aspect", &aspect];
        let expected = 1 + Method::ALL.len();
        let counts = callgrind::count(program, &args, &source.text, &COUNTED, expected, setup.stop);
        let counts = counts.map_err(Failed::Count)?;
        let rays = rays(source, (size, setup.aspect))?;
        let mut of_ray = counts.iter().zip(rays).map(|(count, rays)| *count as f64 / rays.max(1) as f64);
        let solving = of_ray.next().unwrap_or_default();
        let mut drawing = [0.0; Method::ALL.len()];
        drawing.iter_mut().zip(of_ray).for_each(|(of_method, of_ray)| *of_method = of_ray);
        Ok(Self { solving, drawing })
    }

    /// Gives all rows their instructions, in proportion to the rays.
    #[allow(clippy::cast_precision_loss)] // below 2^53
    pub fn put(self, rows: &mut [Row]) {
        for row in rows {
            let own = Method::ALL.iter().zip(self.drawing).find(|(method, _)| **method == row.method);
            let [solution, picture] = row.rays.map(|rays| rays as f64);
            row.instructions = own.map(|(_, drawing)| solution * self.solving + picture * drawing);
        }
    }
}
