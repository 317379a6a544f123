//! `rta bench --light --peer povray`: a room by two passes and by POV-Ray's radiosity, error against cost of whole processes.
//!
//! Both are compared with the same picture of converged paths, after the scaling by one factor that suits best, since they need not have one
//! unit of light. Pixels in which a lamp is seen are left out.

use std::path::Path;

use rta_core::color::Rgb;

use super::povray::lit::Radiosity;
use super::povray::lit_scene;
use crate::args::BenchArgs;
use crate::engine::callgrind::CountError;
use crate::engine::progress::Progress;
use crate::engine::{bands, interrupt};
use crate::picture::output::{self, Inputs};
use crate::study::error::StudyError;
use crate::study::markdown;
use crate::study::report::Source;
use crate::study::report::light::raster;
use crate::study::report::light::room::{Reference, Room};
use process::{Process, ProcessError};

pub mod pictures;
pub mod process;

/// Samples of the paths that both are compared with.
const PATHS: u32 = 1024;

/// Settings of rta's: patches along a side of a quad, or the scene's; what a patch sees; samples and split of the picture; how the light is
/// shown.
const OURS: [(Option<&str>, &str, &str, &str, &str); 13] = [
    (None, "rays:16", "1", "4", "indirect"),
    (Some("4"), "rays:16", "4", "1", "indirect"),
    (None, "rays:16", "4", "1", "indirect"),
    (None, "rays:64", "4", "1", "indirect"),
    (None, "rays:64", "4", "4", "indirect"),
    (None, "rays:64", "16", "1", "indirect"),
    (None, "rays:256", "16", "1", "indirect"),
    (None, "rays:64", "4", "2", "cache:64:.2"),
    (None, "rays:64", "8", "1", "cache:128:.15"),
    (None, "rays:64", "16", "1", "cache:64:.2"),
    (None, "rays:256", "16", "1", "cache:256:.15"),
    (None, "rays:16", "4", "1", "all"),
    (None, "rays:64", "16", "1", "all"),
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

/// One picture of one program.
struct Row {
    program: &'static str,
    settings: String,
    /// CPU seconds of all its processes.
    seconds: Option<f64>,
    instructions: Option<u64>,
    factor: f64,
    error: f64,
}

/// Runs `rta bench --light --peer povray`.
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
        text += &compared(source, args)?;
    }
    Ok(output::print(&text, &inputs)?)
}

/// The processes of a picture, and where it is then.
struct Work {
    program: &'static str,
    settings: String,
    processes: Vec<Process>,
    picture: String,
}

/// Returns rta's work in a number format, on `scene.rta`.
fn ours((size, aspect): (&str, &str), program: &str, format: &str) -> Vec<Work> {
    let rta = |words: &[&str]| Process::new(program, words);
    let work = |&(patches, factors, samples, split, shown): &(Option<&str>, &str, &str, &str, &str)| {
        let mut solve = vec!["radiosity", "scene.rta", "-o", "light.txt", "--format", format];
        solve.extend(["--factors", factors]);
        solve.extend(patches.into_iter().flat_map(|patches| ["--patches", patches]));
        let mut draw =
            vec!["render", "scene.rta", "-o", "ours.pfm", "--quiet", "--device", "none", "--threads", "1"];
        draw.extend(["--format", format, "--aspect", aspect]);
        draw.extend(["--size", size, "--light", "light.txt", "--light-as", shown, "--samples", samples]);
        if shown != "all" {
            draw.extend(["--split", split]);
        }
        let way = match shown.strip_prefix("cache:") {
            Some(caching) => format!("irradiance cache {caching}"),
            None if shown == "all" => "radiosity alone".to_owned(),
            None => "two passes".to_owned(),
        };
        Work {
            program: "rta",
            settings: format!(
                "{way}, patches {}, {factors}, {samples} samples, split {split}",
                patches.unwrap_or("scene's")
            ),
            processes: vec![rta(&solve), rta(&draw)],
            picture: "ours.pfm".to_owned(),
        }
    };
    OURS.iter().map(work).collect()
}

/// Returns POV-Ray's work, on `0.pov`, `1.pov` and so on.
fn theirs(width: &str, height: &str) -> Vec<Work> {
    let numbered = (0..).zip(&THEIRS);
    let work = |(number, radiosity): (u32, &Radiosity)| {
        let (input, size) = (format!("+I{number}.pov"), [format!("+W{width}"), format!("+H{height}")]);
        let mut words = vec![&*input, "+Otheirs.ppm", "+FP16", "File_Gamma=1.0", "+WT1"];
        let (threshold, depth) = radiosity.smoothing;
        let smoothing = [format!("+A{threshold}"), format!("+R{depth}")];
        words.extend(smoothing.iter().map(String::as_str));
        words.extend(["+AM2", "+Q9", "-D", "-V", "-GA"]);
        words.extend(size.iter().map(String::as_str));
        Work {
            program: "povray",
            settings: radiosity.to_string(),
            processes: vec![Process::new("povray", &words)],
            picture: "theirs.ppm".to_owned(),
        }
    };
    numbered.map(work).collect()
}

fn compared(source: &Source, args: &BenchArgs) -> Result<String, StudyError> {
    let (size, aspect) = raster(&source.scene, 1, (args.size, None))?;
    let room = Room::new(source, (size, aspect))?;
    let stop = interrupt::watch();
    let reference = room.reference(PATHS, (&bands::pool(None)?, stop))?;
    let folder = tempfile::tempdir().map_err(ProcessError::Folder).map_err(StudyError::bench)?;
    let write = |name: &str, text: &[u8]| {
        std::fs::write(folder.path().join(name), text)
            .map_err(ProcessError::Folder)
            .map_err(StudyError::bench)
    };
    write("scene.rta", &source.text)?;
    let description = &source.scene.description;
    for (number, radiosity) in THEIRS.iter().enumerate() {
        let text = lit_scene(description, description.model, (args.depth, aspect), radiosity);
        write(&format!("{number}.pov"), text.map_err(StudyError::bench)?.as_bytes())?;
    }
    let program = std::env::current_exe().map_err(ProcessError::Folder).map_err(StudyError::bench)?;
    let [all, width, height] = [size.to_string(), size.width().to_string(), size.height().to_string()];
    let mut works =
        ours((&all, &aspect.to_string()), &program.display().to_string(), &args.format.to_string());
    works.extend(theirs(&width, &height));
    let mut progress = Progress::new(u32::try_from(works.len()).unwrap_or(u32::MAX));
    let (mut rows, mut uncounted): (Vec<Row>, Option<CountError>) = (Vec::new(), None);
    for (work, done) in works.iter().zip(1..) {
        let mut row = measured(work, args, folder.path(), (&reference, size.pixels()))?;
        if !args.no_instructions && uncounted.is_none() {
            let counts = work.processes.iter().map(|process| process.count(folder.path(), stop));
            match counts.sum::<Result<u64, _>>() {
                Ok(count) => row.instructions = Some(count),
                Err(error) => uncounted = Some(error),
            }
        }
        if stop.load(core::sync::atomic::Ordering::Relaxed) {
            return Err(StudyError::INTERRUPTED);
        }
        rows.push(row);
        progress.reached(done);
    }
    drop(progress);
    let told = uncounted.map_or_else(String::new, |reason| format!("\nNo instructions: {reason}.\n"));
    Ok(format!("{}{told}", table(&source.title, &all, &rows)))
}

/// Runs the processes of a picture as often as it is asked for, and compares it.
fn measured(
    work: &Work,
    args: &BenchArgs,
    folder: &Path,
    (reference, pixels): (&Reference, usize),
) -> Result<Row, StudyError> {
    let mut seconds = Some(0.0);
    for _ in 0..args.runs {
        for process in &work.processes {
            let took = process.run(folder).map_err(StudyError::bench)?;
            seconds = seconds.zip(took).map(|(sum, took)| sum + took);
        }
    }
    let path = folder.join(&work.picture);
    let light: Vec<Rgb<f32>> =
        pictures::read(&path, pixels).map_err(ProcessError::Folder).map_err(StudyError::bench)?;
    let (factor, error) = reference.scaled_error(&light);
    let seconds = seconds.map(|sum| sum / f64::from(args.runs));
    Ok(Row {
        program: work.program,
        settings: work.settings.clone(),
        seconds,
        instructions: None,
        factor,
        error,
    })
}

/// Returns the table of all pictures, and for each of POV-Ray's how many times as much it takes as rta's cheapest that errs no more.
fn table(title: &str, size: &str, rows: &[Row]) -> String {
    let millions = |row: &Row| {
        #[allow(clippy::cast_precision_loss)] // below 2^53
        row.instructions.map(|count| count as f64 / 1e6)
    };
    let seconds = |row: &Row| row.seconds;
    let times = |row: &Row, cost: &dyn Fn(&Row) -> Option<f64>| {
        let good = rows.iter().filter(|own| own.program == "rta" && own.error <= row.error);
        let least = good.filter_map(cost).min_by(f64::total_cmp).filter(|least| *least > 0.0)?;
        (row.program == "povray").then(|| cost(row).map(|cost| cost / least))?
    };
    let told = |value: Option<f64>, places: usize| {
        value.map_or_else(|| "-".to_owned(), |value| format!("{value:.places$}"))
    };
    let cells = rows.iter().map(|row| {
        vec![
            row.program.to_owned(),
            row.settings.clone(),
            format!("{:.5}", row.error),
            format!("{:.3}", row.factor),
            told(row.seconds, 3),
            told(millions(row), 0),
            told(times(row, &seconds), 1),
            told(times(row, &millions), 1),
        ]
    });
    let head = [
        "program",
        "settings",
        "RMSE",
        "factor",
        "CPU s",
        "M instructions",
        "x CPU of rta",
        "x instructions",
    ];
    let cells: Vec<_> = cells.collect();
    format!("{title}, {size}:\n\n{}", markdown::table(&head, &cells, 2))
}
