//! `rta bench`: how long pictures take on one core, and how many rays and instructions.
//!
//! | step | where |
//! | --- | --- |
//! | what is measured | [`case`], [`spheres`] |
//! | instructions under valgrind | [`child`] |
//! | the same scenes in POV-Ray | [`povray`], [`peer`] |
//! | error against cost, beside POV-Ray | [`beside`] |
//! | light that goes round, beside POV-Ray's radiosity | [`light`] |
//! | paths in a room, beside Mitsuba's | [`mod@mitsuba`], [`light`] |
//! | soft shadows and what is out of focus, beside POV-Ray's | [`spread`] |
//! | the table | [`markdown`] |
//! | instructions that are recorded, and counted again | [`drift`] |

use core::sync::atomic::{AtomicBool, Ordering};
use core::time::Duration;
use std::io::{self, Write};

use crate::args::{self, BenchArgs};
use crate::engine::callgrind::CountError;
use crate::engine::interrupt;
use crate::engine::progress::Progress;
use crate::picture::output::{self, Inputs};
use crate::study::error::StudyError;
use crate::study::markdown;
use rta_packets::tally::Rays;

pub mod beside;
pub mod case;
pub mod child;
pub mod drift;
pub mod light;
pub mod mitsuba;
pub mod peer;
pub mod povray;
pub mod spheres;
pub mod spread;

use case::{Case, Tracing};
use child::Work;
use peer::{Peer, Statistics};

/// The scenes that are measured before the random spheres, where no others are asked for.
const SCENES: [&str; 3] = ["juggler", "hall-22", "glass-2"];

/// The measurements of a scene.
struct Row {
    scene: String,
    objects: usize,
    raster: String,
    time: Duration,
    rays: Rays,
    instructions: Option<u64>,
    peer: Option<Statistics>,
    /// Until the picture is there, with one thread and with two.
    elapsed: Option<[Duration; 2]>,
}

/// Runs `rta bench`.
///
/// # Errors
/// All of [`StudyError`].
pub fn run(args: &BenchArgs) -> Result<(), StudyError> {
    if args.light {
        return light::run(args);
    }
    if args.peer == Some(args::Peer::Mitsuba) {
        return Err(StudyError::PathsAlone);
    }
    if args.spread {
        return spread::run(args);
    }
    let stop = interrupt::watch();
    if let Some(file) = &args.record {
        return drift::record(args, file, stop);
    }
    if let Some(file) = &args.check {
        return drift::check(args, file, stop);
    }
    let names: Vec<_> = if args.scenes.is_empty() {
        SCENES.into_iter().map(String::from).chain(spheres::COUNTS.map(spheres::name)).collect()
    } else {
        Vec::new()
    };
    let tracing = Tracing { format: args.format, size: args.size, depth: args.depth };
    let scenes = args.scenes.len() + names.len();
    let mut progress = Progress::new(u32::try_from(scenes).unwrap_or(u32::MAX));
    let mut bench = Bench { args, stop, uncounted: None };
    let (mut rows, mut inputs) = (Vec::new(), Inputs::default());
    // One after the other: of many large scenes only one is in memory.
    let files = args.scenes.iter().map(|path| Case::file(path, tracing));
    for (case, done) in files.chain(names.iter().map(|name| Case::named(name, tracing))).zip(1..) {
        let case = case?;
        inputs.add(&case.scene.inputs);
        rows.push(bench.row(&case)?);
        progress.reached(done);
    }
    drop(progress);
    if let Some(reason) = bench.uncounted {
        let _ = writeln!(io::stderr(), "rta: no instructions: {reason}");
    }
    Ok(output::print(&report(&rows, args), &inputs)?)
}

/// A bench under way.
struct Bench<'a> {
    args: &'a BenchArgs,
    stop: &'a AtomicBool,
    /// Why instructions were not counted.
    uncounted: Option<CountError>,
}

impl Bench<'_> {
    fn go_on(&self) -> Result<(), StudyError> {
        if self.stop.load(Ordering::Relaxed) { Err(StudyError::INTERRUPTED) } else { Ok(()) }
    }

    fn row(&mut self, case: &Case) -> Result<Row, StudyError> {
        let peer = self.args.peer.map(|_| Peer::new(case)).transpose().map_err(StudyError::bench)?;
        let (mut picture, mut time) = (case.picture()?, Duration::MAX);
        let mut statistics: Option<Statistics> = None;
        // In turn, so that whatever else the machine does meets both.
        for _ in 0..self.args.runs {
            self.go_on()?;
            time = time.min(case.time(&mut picture));
            if let Some(peer) = &peer {
                let now = peer.render().map_err(StudyError::bench)?;
                statistics = Some(statistics.filter(|before| before.time <= now.time).unwrap_or(now));
            }
        }
        drop(picture);
        let elapsed = if self.args.scaling { Some(self.elapsed(case)?) } else { None };
        let instructions = self.instructions(case);
        self.go_on()?;
        Ok(Row {
            scene: case.scene.title.clone(),
            objects: case.objects(),
            raster: case.size().to_string(),
            time,
            rays: case.engine().rays(),
            instructions,
            peer: statistics,
            elapsed,
        })
    }

    fn elapsed(&self, case: &Case) -> Result<[Duration; 2], StudyError> {
        let mut least = [Duration::MAX; 2];
        for _ in 0..self.args.runs {
            for (least, threads) in least.iter_mut().zip(1..) {
                *least = (*least).min(case.elapsed(threads, self.stop)?);
            }
        }
        Ok(least)
    }

    /// Counts the instructions of a scene; none after the first failure, since the others would fail too and take their time.
    fn instructions(&mut self, case: &Case) -> Option<u64> {
        let BenchArgs { format, size, depth, no_instructions, .. } = self.args;
        if *no_instructions || self.uncounted.is_some() {
            return None;
        }
        let (scene, text) = match &case.text {
            Some(text) => (child::INPUT, text.as_slice()),
            None => (case.scene.title.as_str(), [].as_slice()),
        };
        let work = Work { scenes: &[scene], formats: &[*format], size: *size, depth: *depth };
        match child::count(&work, text, self.stop) {
            Ok(counts) => counts.first().copied(),
            Err(reason) => {
                self.uncounted = Some(reason);
                None
            }
        }
    }
}

/// Returns a count as a float.
#[allow(clippy::cast_precision_loss)] // below 2^53
fn float(count: u64) -> f64 {
    count as f64
}

impl Row {
    /// Returns the number of rays of all kinds.
    fn all_rays(&self) -> f64 {
        float(self.rays.iter().sum())
    }

    /// Returns the nanoseconds that a ray takes.
    fn nanoseconds(&self) -> f64 {
        self.time.as_secs_f64() * 1e9 / self.all_rays()
    }

    fn cells(&self, args: &BenchArgs) -> Vec<String> {
        let mut cells = vec![
            self.scene.clone(),
            args.format.to_string(),
            self.raster.clone(),
            self.objects.to_string(),
            milliseconds(self.time),
        ];
        cells.extend(self.rays.map(|rays| rays.to_string()));
        cells.push(format!("{:.0}", self.nanoseconds()));
        let counted = self.instructions.map(|count| float(count) / self.all_rays());
        cells.push(counted.map_or_else(|| "-".to_owned(), |count| format!("{count:.0}")));
        if let Some(Statistics { time, rays }) = self.peer {
            let ratio = time.as_secs_f64() / self.time.as_secs_f64();
            cells.extend([milliseconds(time), rays.to_string(), format!("{ratio:.2}")]);
        }
        cells
    }
}

fn milliseconds(time: Duration) -> String {
    format!("{:.1}", time.as_secs_f64() * 1e3)
}

/// Returns the tables in Markdown.
fn report(rows: &[Row], args: &BenchArgs) -> String {
    let mut head = vec!["scene", "format", "raster", "objects", "CPU ms"];
    head.extend(["primary", "reflected", "transmitted", "shadow", "ns a ray", "instructions a ray"]);
    if args.peer.is_some() {
        head.extend(["povray ms", "its rays", "povray : rta"]);
    }
    let cells: Vec<_> = rows.iter().map(|row| row.cells(args)).collect();
    let mut text = markdown::table(&head, &cells, 3);
    // Only of what the program has made: a file may have such a name too.
    let points = rows.iter().filter(|_| args.scenes.is_empty());
    let points: Vec<_> =
        points.filter_map(|row| Some((spheres::count(&row.scene)?, row.nanoseconds()))).collect();
    if let Some((exponent, ratio)) = spheres::growth(&points) {
        text += &format!(
            "\nRandom spheres, 1000 to 100000: the time of a ray grows with the power {exponent:.3} of their number; \
             100000 take {ratio:.2} times as long as 1000.\n"
        );
    }
    let scaled = rows.iter().filter_map(|row| row.elapsed.map(|[one, two]| (&row.scene, one, two)));
    let scaled = scaled.map(|(scene, one, two)| {
        let ratio = one.as_secs_f64() / two.as_secs_f64();
        vec![scene.clone(), milliseconds(one), milliseconds(two), format!("{ratio:.2}")]
    });
    let scaled: Vec<_> = scaled.collect();
    if !scaled.is_empty() {
        let head = ["scene", "ms with 1 thread", "ms with 2 threads", "1 : 2"];
        text += &format!("\nElapsed time:\n\n{}", markdown::table(&head, &scaled, 1));
    }
    text
}
