//! `rta explain`: why a pixel is what it is in a number format, beside `f64`.
//!
//! Colours and levels, the two ray trees, the first decision that came out otherwise, and the operations that lost most.

use core::fmt::{self, Display, Write as _};

use rta_core::ray::RayKind;
use rta_paired::log::{Flip, Log, Operation};
use rta_paired::ray_tree::{HitKind, Step, Visibility};
use rta_paired::trail::{GUNS, Pixel};
use rta_scenes::description::Description;

use crate::args::{Choice, ExplainArgs};
use crate::engine::{EngineError, Format, Settings};
use crate::error::Error;
use crate::picture::device::Target;
use crate::picture::output;
use crate::picture::raster::Size;
use crate::request::Request;
use crate::request::scene_file::SceneFile;
use crate::study::trail::{self, lock_step, picture};

/// Operations that are printed.
const OPERATIONS: usize = 10;

/// A pixel in a number format and in `f64`.
#[derive(Debug)]
pub struct Explanation {
    /// The number format.
    pub format: Format,
    /// The pixel in the format, with the log of its lock step.
    pub pixel: Pixel,
    /// The pixel in `f64`.
    pub truth: Pixel,
}

/// Traces a pixel in the format of the settings, in `f64`, and in both in lock step. Returns none where the raster has no such
/// pixel.
///
/// # Errors
/// [`EngineError`] if the scene cannot be drawn with these settings.
pub fn explain(
    scene: &Description,
    settings: &Settings,
    x: u32,
    y: u32,
) -> Result<Option<Explanation>, EngineError> {
    let Some(pixel) = lock_step(scene, settings, x, y)? else { return Ok(None) };
    let truth = trail::pixel(scene, &reference(settings), x, y)?;
    Ok(truth.map(|truth| Explanation { format: settings.format, pixel, truth }))
}

/// Returns column and row of the pixel whose colour, as a display can show it, is farthest from that in `f64`.
///
/// # Errors
/// [`EngineError`] if the scene cannot be drawn with these settings.
pub fn worst(scene: &Description, settings: &Settings) -> Result<(u32, u32), EngineError> {
    let apart = |(a, b): (&Pixel, &Pixel)| {
        let registers = a.light.iter().zip(b.light);
        registers.map(|(a, b)| (a.clamp(0.0, 1.0) - b.clamp(0.0, 1.0)).abs()).fold(0.0, f64::max)
    };
    let (rough, truth) = (picture(scene, settings)?, picture(scene, &reference(settings))?);
    let errors = (0u32..).zip(rough.iter().zip(&truth).map(apart));
    let (worst, _) = errors.fold((0, 0.0), |most, next| if next.1 > most.1 { next } else { most });
    Ok((worst % settings.width, worst / settings.width))
}

fn reference(settings: &Settings) -> Settings {
    Settings { format: Format::F64, ..settings.clone() }
}

/// Runs `rta explain`.
///
/// # Errors
/// [`Error::PixelOutside`], and those of reading the scene, making it ready and writing to standard output.
pub fn run(args: &ExplainArgs) -> Result<(), Error> {
    let tracing = args.tracing();
    Request::of(&tracing, Target::None).raster()?;
    let scene = SceneFile::open_as(&args.scene, args.reading.into())?;
    let request = Request::of_scene(&tracing, Target::None, &scene)?;
    let (size, aspect) = request.raster()?;
    if let Choice::At(x, y) = args.pixel {
        inside(size, x, y)?;
    }
    let (width, height) = (size.width(), size.height());
    let (format, model, depth) = (request.format, request.model, request.depth);
    let settings = Settings { width, height, aspect, format, model, depth, ..Settings::default() };
    let fit = request.fit(aspect);
    let description = fit.scaled(&scene);
    let failed = |source| fit.engine_error(&scene, source);
    let (x, y) = match args.pixel {
        Choice::At(x, y) => (x, y),
        Choice::Worst => worst(&description, &settings).map_err(failed)?,
    };
    let explanation = explain(&description, &settings, x, y).map_err(failed)?;
    let explanation = explanation.ok_or(Error::PixelOutside { x, y, size })?;
    let title = format!("{}, pixel {x},{y} of {size}, model {model}, depth {depth}\n\n", scene.title);
    let text = format!("{title}{explanation}");
    Ok(output::print(&text, &scene.inputs)?)
}

fn inside(size: Size, x: u32, y: u32) -> Result<(), Error> {
    if x < size.width() && y < size.height() { Ok(()) } else { Err(Error::PixelOutside { x, y, size }) }
}

impl Display for Explanation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { format, pixel, truth } = self;
        colors(f, *format, pixel, truth)?;
        let parting = pixel.tree.parting(&truth.tree);
        let rays = pixel.tree.steps.len();
        match parting {
            None => writeln!(f, "\nbranches: the same in all rays ({rays})\n")?,
            Some(ray) => writeln!(f, "\nbranches: another one in ray {ray}\n")?,
        }
        tree(f, *format, &pixel.tree.steps, &truth.tree.steps)?;
        flips(f, *format, &pixel.log, parting)?;
        operations(f, *format, &pixel.log)
    }
}

/// Writes a number with so many decimals, or a large one with an exponent, so that columns stay columns.
fn fixed(number: f64, decimals: usize) -> String {
    if number.abs() < 1e6 || !number.is_finite() {
        format!("{number:.decimals$}")
    } else {
        format!("{number:.3e}")
    }
}

fn colors(f: &mut fmt::Formatter<'_>, format: Format, pixel: &Pixel, truth: &Pixel) -> fmt::Result {
    writeln!(f, "{:14}{:>12}{:>12}{:>12}", "", "red", "green", "blue")?;
    let line = |f: &mut fmt::Formatter<'_>, name: &str, [r, g, b]: [f64; 3]| {
        writeln!(f, "{name:14}{:>12}{:>12}{:>12}", fixed(r, 6), fixed(g, 6), fixed(b, 6))
    };
    line(f, &format.to_string(), pixel.light)?;
    line(f, "f64", truth.light)?;
    let mut error = pixel.light;
    for (error, truth) in error.iter_mut().zip(truth.light) {
        *error -= truth;
    }
    line(f, "error", error)?;
    for ((max, a), b) in GUNS.iter().zip(&pixel.levels).zip(&truth.levels) {
        write!(f, "{:14}", format!("of {max} levels"))?;
        for (a, b) in [(a.r, b.r), (a.g, b.g), (a.b, b.b)] {
            write!(f, "{:>12}", format!("{a}/{b} {:+}", i16::from(a) - i16::from(b)))?;
        }
        writeln!(f)?;
    }
    Ok(())
}

/// Writes the ray trees side by side; a line whose branches differ is marked.
fn tree(f: &mut fmt::Formatter<'_>, format: Format, ours: &[Step], theirs: &[Step]) -> fmt::Result {
    writeln!(f, "  ray                       {:34}{:34}", format.to_string(), "f64")?;
    for i in 0..ours.len().max(theirs.len()) {
        let (a, b) = (ours.get(i), theirs.get(i));
        let same = matches!((a, b), (Some(a), Some(b)) if a.is_like(b));
        let name = |step: Option<&Step>| step.map_or_else(String::new, branch);
        let (kind, other) = (name(a), name(b));
        let kind = if kind.is_empty() || kind == other { other } else { kind };
        let (a, b) = (a.map_or_else(|| "-".into(), meeting), b.map_or_else(|| "-".into(), meeting));
        let line = format!("{} {i:3} {kind:22}{a:34}{b}", if same { ' ' } else { '!' });
        writeln!(f, "{}", line.trim_end())?;
    }
    writeln!(f, "  lamps: 1 lit, 0 in shadow, * highlight, ~ too faint, - behind\n")
}

/// Returns the kind of a ray, indented by its depth.
fn branch(step: &Step) -> String {
    let kind = match step.kind {
        RayKind::Primary => "primary",
        RayKind::Reflected => "reflected",
        RayKind::Transmitted => "transmitted",
        RayKind::Shadow => "shadow",
    };
    format!("{:indent$}{kind}", "", indent = usize::from(step.depth).min(10))
}

/// Returns what a ray hit, and the visibility of each lamp from there.
fn meeting(step: &Step) -> String {
    let mut text = match step.hit {
        HitKind::Sky => "sky".into(),
        HitKind::Floor { odd: true } => "odd tile".into(),
        HitKind::Floor { odd: false } => "even tile".into(),
        HitKind::Object(object) => object.to_string(),
    };
    if let Some(distance) = step.distance {
        // Writing to a string does not fail.
        let _ = write!(text, " at {}", fixed(distance, 5));
    }
    if step.inside {
        text.push_str(" inside");
    }
    if step.total_reflection {
        text.push_str(" total");
    }
    for lamp in &step.lamps {
        text.push(' ');
        match *lamp {
            Visibility::Behind => text.push('-'),
            Visibility::Faint => text.push('~'),
            Visibility::Front { part, glint } => {
                let _ = write!(text, "{}", (part * 1000.0).round() / 1000.0);
                text.push_str(if glint { "*" } else { "" });
            }
        }
    }
    text
}

/// Writes the first flipped decision of the ray in which the trees part; all other differences follow from it.
fn flips(f: &mut fmt::Formatter<'_>, format: Format, log: &Log, parting: Option<usize>) -> fmt::Result {
    let Some(ray) = parting else {
        return writeln!(f, "flipped decisions: {}, none of which matters\n", log.flips.len());
    };
    let Some(flip) = log.flips.iter().filter(|flip| flip.ray <= ray).max_by_key(|flip| flip.ray) else {
        return writeln!(f, "flipped decision: none in lock step before ray {ray}\n");
    };
    let first = log.flips.iter().find(|other| other.ray == flip.ray).unwrap_or(flip);
    let Flip { question, place, ray, left, right } = first;
    writeln!(f, "flipped decision in ray {ray}: {question} at {}:{}", place.file(), place.line())?;
    for (name, left, right) in [(format.to_string(), left[0], right[0]), ("f64".into(), left[1], right[1])] {
        writeln!(f, "  {name:5}{:>20} {question} {}", fixed(left, 12), fixed(right, 12))?;
    }
    writeln!(f)
}

/// Writes the operations whose result has lost most against their operands; each place of the tracer once.
fn operations(f: &mut fmt::Formatter<'_>, format: Format, log: &Log) -> fmt::Result {
    let mut worst: Vec<&Operation> = log.operations.iter().collect();
    worst.sort_by(|a, b| b.growth().total_cmp(&a.growth()));
    let mut seen = std::collections::HashSet::new();
    worst.retain(|o| seen.insert((o.name, o.place)));
    writeln!(
        f,
        "{:>8}{:>8}{:>11}  {:>18}{:>18}  {:16}{:>3}  where",
        "worse by", "lost", "error", format, "f64", "operation", "ray"
    )?;
    writeln!(f, "{:>8}{:>8}{:>11}", "bits", "bits", "last place")?;
    for o in worst.into_iter().take(OPERATIONS) {
        let [result, twin] = o.result;
        writeln!(
            f,
            "{:8.1}{:8.1}{:>11}  {:>18}{:>18}  {:16}{:3}  {}:{}",
            o.growth(),
            o.bits_lost(),
            fixed(o.error, 1),
            fixed(result, 9),
            fixed(twin, 9),
            o.name,
            o.ray,
            o.place.file(),
            o.place.line()
        )?;
    }
    Ok(())
}

#[cfg(test)]
mod tests;
