//! `rta palette`: a scene on a device by every colour table with every dithering, and how different each picture looks from the one
//! without a device.
//!
//! | step | where |
//! | --- | --- |
//! | the picture, traced once for a device | [`traced`] |
//! | a combination's picture and its measures | [`row`] |
//! | bytes of RAM | [`memory`] |
//! | instructions under valgrind | [`instructions`] |
//! | the contact sheet | [`sheet`] |

use core::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::io::{self, Write};
use std::path::Path;
use std::sync::Mutex;

use clap::ValueEnum;
use rayon::ThreadPool;
use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};

use crate::args::PaletteArgs;
use crate::engine::callgrind::CountError;
use crate::engine::progress::Progress;
use crate::engine::{bands, interrupt};
use crate::picture::coloring::{Coloring, DitherKind, SAMPLES, TableKind};
use crate::picture::device::{Device, Target};
use crate::picture::error::PictureError;
use crate::picture::file::Caption;
use crate::picture::output::{self, Failure, PictureOutput};
use crate::request::Request;
use crate::request::scene_file::SceneFile;
use crate::study::error::StudyError;
use crate::study::markdown;

pub mod instructions;
pub mod memory;
pub mod row;
pub mod sheet;
pub mod traced;

use row::Row;
use traced::Traced;

/// Returns every table with every dithering, table by table.
#[must_use]
pub fn colorings(samples: u32) -> Vec<Coloring> {
    let dithers = || DitherKind::value_variants().iter();
    let of = |table: &TableKind| {
        dithers().map(|dither| Coloring { table: *table, dither: *dither, samples }).collect()
    };
    TableKind::value_variants().iter().map(of).collect::<Vec<Vec<_>>>().concat()
}

/// A scene on a device.
#[derive(Debug)]
pub struct Shown {
    /// The device.
    pub device: Device,
    /// The picture.
    pub traced: Traced,
    /// The scene and the settings.
    pub caption: Caption,
    /// Every combination, in the order of [`colorings`].
    pub rows: Vec<Row>,
}

/// Runs `rta palette`. The contact sheet is written once everything is measured.
///
/// # Errors
/// All of [`StudyError`] that concern options, a scene, a device or an output.
pub fn run(args: &PaletteArgs) -> Result<(), StudyError> {
    let tracing = &args.tracing;
    if tracing.table.is_some() || tracing.dither.is_some() {
        return Err(StudyError::EveryTable);
    }
    let devices = args.device.map_or_else(|| Device::value_variants().to_vec(), |device| vec![device]);
    for device in &devices {
        Request::of(tracing, Target::On(*device)).raster()?;
    }
    let sheet = args.sheet.as_deref().map(sheet_output).transpose()?;
    let scene = SceneFile::open_as(&args.scene, tracing.reading.into())?;
    let sheet =
        sheet.map(|output| Ok::<_, PictureError>((output.file_type(), output.beside(&scene.inputs)?)));
    let sheet = sheet.transpose()?;
    let study = Study { args, scene: &scene, pool: bands::pool(tracing.threads)?, stop: interrupt::watch() };
    let combinations = colorings(SAMPLES).len();
    let steps = u32::try_from(devices.len() * (1 + combinations)).unwrap_or(u32::MAX);
    let progress = Mutex::new(Progress::new(steps));
    let done = AtomicU32::new(0);
    let step = || {
        let done = done.fetch_add(1, Ordering::Relaxed) + 1;
        // A bar that is held by another thread is drawn by that one.
        if let Ok(mut progress) = progress.try_lock() {
            progress.reached(done);
        }
    };
    let mut uncounted = None;
    let shown = devices.iter().map(|&device| study.shown(device, &step, &mut uncounted));
    let shown = shown.collect::<Result<Vec<_>, _>>()?;
    drop(progress);
    if let Some(reason) = uncounted {
        let _ = writeln!(io::stderr(), "rta: no instructions: {reason}");
    }
    let tables: Vec<_> = shown.iter().map(table).collect();
    output::print(&tables.join("\n"), &scene.inputs)?;
    if let Some((file_type, output)) = sheet {
        let sheet = sheet::sheet(&shown)?;
        let caption = Caption {
            title: scene.title.clone(),
            settings: "every colour table with every dithering".into(),
        };
        output.fill(|out| sheet.write(file_type, &caption, out).map_err(Failure::<StudyError>::Write))?;
    }
    Ok(())
}

/// Opens the file of the contact sheet, which is none that holds linear light.
fn sheet_output(path: &Path) -> Result<PictureOutput, StudyError> {
    let output = PictureOutput::open(path, None)?;
    if output.is_stdout() {
        return Err(StudyError::SheetToStdout);
    }
    if output.file_type().is_linear() {
        return Err(PictureError::NotLinear(output.file_type()).into());
    }
    Ok(output)
}

/// A study under way.
struct Study<'a> {
    args: &'a PaletteArgs,
    scene: &'a SceneFile,
    pool: ThreadPool,
    stop: &'a AtomicBool,
}

impl Study<'_> {
    /// Traces the scene for a device and measures every combination; `step` is called after each. Why instructions are not counted, if
    /// they are not, is left in `uncounted`.
    fn shown(
        &self,
        device: Device,
        step: &(impl Fn() + Sync),
        uncounted: &mut Option<CountError>,
    ) -> Result<Shown, StudyError> {
        let request = Request::of_scene(&self.args.tracing, Target::On(device), self.scene)?;
        let traced = Traced::new(&request, self.scene, &self.pool, self.stop)?;
        let samples = request.coloring.samples;
        let counts = if self.args.no_instructions || uncounted.is_some() {
            None
        } else {
            match instructions::count(device, samples, &traced, self.stop) {
                Ok(counts) => Some(counts),
                Err(error) => {
                    *uncounted = Some(error);
                    None
                }
            }
        };
        step();
        let colorings = colorings(samples);
        let measured = |(place, coloring): (usize, &Coloring)| {
            if self.stop.load(Ordering::Relaxed) {
                return Err(StudyError::INTERRUPTED);
            }
            let row = Row::measured(device, *coloring, &traced)?;
            step();
            let instructions = counts.as_ref().and_then(|counts| counts.get(place)).copied();
            Ok(Row { instructions, ..row })
        };
        let rows: Result<_, _> =
            self.pool.install(|| colorings.par_iter().enumerate().with_max_len(1).map(measured).collect());
        Ok(Shown { device, caption: request.caption(self.scene), rows: rows?, traced })
    }
}

/// Returns the table of a device in Markdown, below a line that says what it is of.
fn table(shown: &Shown) -> String {
    let Shown { device, caption, rows, traced } = shown;
    let own = format!("FLIP at {}", device.pixels_per_degree());
    let head = ["", "table", "dither", &own, "FLIP at 67", "S-CIELAB", "PSNR", "instructions", "RAM"];
    let cells = rows.iter().map(|row| {
        let mark = if row.is_default(*device) { "*" } else { "" };
        vec![
            mark.to_owned(),
            row.coloring.table.to_string(),
            row.coloring.dither.to_string(),
            format!("{:.4}", row.own.flip),
            format!("{:.4}", row.fine),
            format!("{:.3}", row.own.scielab),
            row.own.psnr.to_string(),
            row.instructions.map_or_else(String::new, |count| format!("{count:.0}")),
            row.memory.to_string(),
        ]
    });
    let settings = caption.settings.split_once(", format").map_or("", |(_, settings)| settings);
    let table = markdown::table(&head, &cells.collect::<Vec<_>>(), 3);
    format!("{} on {device}, {}, format{settings}\n\n{table}", caption.title, traced.size)
}
