//! `rta bench --light`: light that goes round, beside another program. With `--peer povray` a room by two passes and by POV-Ray's radiosity, error
//! against cost of whole processes; with `--peer mitsuba` by [`paths`] of both.
//!
//! Two passes and radiosity are compared with the same picture of converged paths, after the scaling by one factor that suits best, since they need
//! not have one unit of light. Pixels in which a lamp is seen are left out.

use rta_core::color::Rgb;

use super::beside::process::Process;
use super::beside::{Place, Program, Rows, Work, own_program};
use super::povray::lit::Radiosity;
use super::povray::lit_scene;
use crate::args::{BenchArgs, Peer};
use crate::engine::{bands, interrupt};
use crate::picture::output::{self, Inputs};
use crate::study::error::StudyError;
use crate::study::report::Source;
use crate::study::report::light::raster;
use crate::study::report::light::room::Room;

pub mod paths;

/// Samples of the paths that both are compared with.
const PATHS: u32 = 1024;

/// A setting of rta's: what a patch sees; the most samples of a pixel, the tolerance within which it ends early, if it does, and places on a lamp
/// for each point that the eye sees; how the light is shown.
type Setting = (&'static str, (&'static str, Option<&'static str>, &'static str), &'static str);

/// Settings of rta's, from quick to good for each way.
const OURS: [Setting; 13] = [
    ("rays:16", ("4", Some(".03:1"), "2"), "indirect"),
    ("rays:32", ("4", Some(".03:1"), "2"), "indirect"),
    ("rays:64", ("4", Some(".02:1"), "2"), "indirect"),
    ("rays:64", ("4", Some(".02:1"), "4"), "indirect"),
    ("rays:64", ("8", Some(".02:1"), "4"), "indirect"),
    ("rays:64", ("8", Some(".0125:1"), "4"), "indirect"),
    ("rays:64", ("16", None, "4"), "indirect"),
    ("rays:64", ("8", Some(".015:1"), "4"), "cache:64:.2"),
    ("rays:64", ("8", Some(".01:1"), "4"), "cache:64:.2"),
    ("rays:64", ("16", Some(".01:1"), "4"), "cache:64:.2"),
    ("rays:256", ("16", Some(".01:1"), "4"), "cache:256:.15"),
    ("rays:16", ("4", None, "1"), "all"),
    ("rays:64", ("16", None, "1"), "all"),
];

const fn radiosity(
    (count, nearest): (u32, u32),
    error_bound: f64,
    recursion: u32,
    step: f64,
    smoothing: (f64, u32),
) -> Radiosity {
    Radiosity { lamp: 4, count, nearest, error_bound, recursion, step, smoothing }
}

/// Settings of POV-Ray's, from quick to good: more rays from a place, a smaller bound of the error, more places.
const THEIRS: [Radiosity; 6] = [
    radiosity((20, 4), 1.8, 2, 0.04, (0.1, 2)),
    radiosity((50, 5), 1.0, 5, 0.04, (0.1, 2)),
    radiosity((100, 5), 1.0, 5, 0.04, (0.1, 2)),
    radiosity((100, 5), 0.8, 5, 0.02, (0.05, 3)),
    radiosity((150, 5), 0.5, 5, 0.02, (0.05, 3)),
    radiosity((200, 5), 0.5, 5, 0.01, (0.05, 3)),
];

/// Runs `rta bench --light`.
///
/// # Errors
/// Those of reading a scene, and [`StudyError::Bench`] where a program fails.
pub fn run(args: &BenchArgs) -> Result<(), StudyError> {
    let sources = if args.scenes.is_empty() {
        vec![Source::cornell()?]
    } else {
        crate::study::report::sources(&args.scenes)?
    };
    let mut inputs = Inputs::default();
    sources.iter().for_each(|source| inputs.add(&source.scene.inputs));
    let mut text = String::new();
    for source in &sources {
        text += &match args.peer {
            Some(Peer::Mitsuba) => paths::compared(source, args)?,
            _ => compared(source, args)?,
        };
    }
    Ok(output::print(&text, &inputs)?)
}

/// Returns rta's work in a number format, on `scene.rta`.
fn ours((size, aspect): (&str, &str), program: &str, format: &str) -> Vec<Work> {
    let rta = |words: &[&str]| Process::new(program, words);
    let work = |&(factors, (samples, tolerance, split), shown): &Setting| {
        let mut solve = vec!["radiosity", "scene.rta", "-o", "light.txt", "--format", format];
        solve.extend(["--factors", factors]);
        let mut draw =
            vec!["render", "scene.rta", "-o", "ours.pfm", "--quiet", "--device", "none", "--threads", "1"];
        draw.extend(["--format", format, "--aspect", aspect]);
        draw.extend(["--size", size, "--light", "light.txt", "--light-as", shown, "--samples", samples]);
        if shown != "all" {
            draw.extend(["--split", split]);
            draw.extend(tolerance.into_iter().flat_map(|part| ["--tolerance", part]));
        }
        let way = match shown.strip_prefix("cache:") {
            Some(caching) => format!("irradiance cache {caching}"),
            None if shown == "all" => "radiosity alone".to_owned(),
            None => "two passes".to_owned(),
        };
        let within = tolerance.map_or(String::new(), |part| format!(", tolerance {part}"));
        Work {
            program: Program::Rta,
            settings: format!("{way}, {factors}, {samples} samples{within}, split {split}"),
            processes: vec![rta(&solve), rta(&draw)],
            picture: "ours.pfm".to_owned(),
        }
    };
    OURS.iter().map(work).collect()
}

fn compared(source: &Source, args: &BenchArgs) -> Result<String, StudyError> {
    let (size, aspect) = raster(&source.scene, 1, (args.size, None))?;
    let room = Room::new(source, (size, aspect))?;
    let stop = interrupt::watch();
    let reference = room.reference(PATHS, (&bands::pool(None)?, stop))?;
    let place = Place::new()?;
    place.write("scene.rta", &source.text)?;
    let all = size.to_string();
    let mut works = ours((&all, &aspect.to_string()), &own_program()?, &args.format.to_string());
    let description = &source.scene.description;
    for (number, radiosity) in THEIRS.iter().enumerate() {
        let text = lit_scene(description, description.model, (args.depth, aspect), radiosity);
        let name = format!("{number}.pov");
        place.write(&name, text.map_err(StudyError::bench)?.as_bytes())?;
        works.push(Work::povray(&name, radiosity.to_string(), Some(radiosity.smoothing), size));
    }
    let compare = |light: &[Rgb<f32>]| {
        let (factor, error) = reference.scaled_error(light);
        (Some(factor), error)
    };
    let rows = Rows::new(&works, args, (place.path(), size.pixels()), &|_, light| compare(light))?;
    Ok(rows.table(&source.title, &all))
}
