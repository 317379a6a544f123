//! `rta stability`: cases that break ray tracers, in every number format beside `f64`.
//!
//! | step | where |
//! | --- | --- |
//! | the cases | [`cases`] |
//! | where their rays start and go | [`aim`], [`body`] |
//! | numbers rounded to a format and read back | [`exact`] |
//! | the rays of one case in one format | [`mod@measure`], and `scattered` where they are spread |
//! | how far its light is off | `errors` |
//! | points that shadow themselves | [`acne`] |
//! | panics and overflows | [`guard`] |
//! | what comes out | [`table`] |
//!
//! The reference is given the same numbers as the format, rounded to the format, so the table shows what the arithmetic
//! does and not that a length of 0.001 has few digits in Q16.16.
//!
//! Rays take turns between two illumination models, and only two, so that the tables of all versions can be compared: `Rta`, with
//! attenuated lamps and weights of three registers, and `Whitted`, with halfway vectors and powers of cosines. Cases of their own put
//! each model of the list to the ends of what its parameters and its angles may be.
//!
//! Overflow is what debug assertions find: each operation of a fixed-point format checks its result in a build that has
//! them. The profile `checked` is the release build with them, and with panics that unwind, so that one ray's panic is a
//! count and not the end. In any other build panics and overflows are not counted and the table has question marks.

pub mod acne;
pub mod aim;
pub mod body;
pub mod cases;
mod errors;
pub mod exact;
pub mod guard;
pub mod measure;
pub mod outcome;
mod scattered;
pub mod table;
pub mod triple;

use core::sync::atomic::Ordering;
use std::fs;
use std::io::{self, Write};
use std::path::Path;
use std::sync::mpsc;

use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};

use crate::args::StabilityArgs;
use crate::engine::Format;
use crate::engine::progress::Progress;
use crate::engine::{bands, interrupt};
use crate::picture::error::PictureError;
use crate::picture::output::{self, Inputs, Output};
use crate::study::error::StudyError;
use cases::Case;
use measure::{Outcome, measure};

/// The formats that are put to the test; `f64` is the reference.
pub const FORMATS: [Format; 3] = [Format::F32, Format::Q16, Format::Q20];

/// One case in one format.
#[derive(Clone, Debug)]
pub struct Row {
    /// The case.
    pub case: String,
    /// The format.
    pub format: Format,
    /// Its outcome.
    pub outcome: Outcome,
}

/// Traces `cases` in all formats, with `samples` rays from the eye each, and calls `done` after each row with the
/// number of rows so far. The rows do not depend on the number of threads.
///
/// # Errors
/// [`BandsError`](bands::BandsError): there are no threads, or an interrupt arrived, which is an error once the rows that were begun
/// are completed.
pub fn rows(cases: &[Case], samples: usize, mut done: impl FnMut(u32)) -> Result<Vec<Row>, StudyError> {
    let stop = interrupt::watch();
    let work: Vec<_> = cases.iter().flat_map(|case| FORMATS.map(|format| (case, format))).collect();
    let (sender, receiver) = mpsc::channel();
    let mut rows = Vec::new();
    bands::pool(None)?.in_place_scope(|scope| {
        let work = &work;
        scope.spawn(move |_| {
            work.par_iter().enumerate().with_max_len(1).for_each_with(
                sender,
                |sender, (place, (case, format))| {
                    if !stop.load(Ordering::Relaxed) {
                        let outcome = measure(case, *format, samples);
                        // Nobody listens any more only after an interrupt.
                        let _ =
                            sender.send((place, Row { case: case.name.clone(), format: *format, outcome }));
                    }
                },
            );
        });
        for (count, row) in (1..).zip(receiver) {
            rows.push(row);
            done(count);
        }
    });
    if rows.len() < work.len() {
        return Err(StudyError::INTERRUPTED);
    }
    rows.sort_by_key(|(place, _)| *place);
    Ok(rows.into_iter().map(|(_, row)| row).collect())
}

/// Runs `rta stability`.
///
/// # Errors
/// Those of [`rows`], and [`PictureError::Write`] for the output; it is opened before the work.
pub fn run(args: &StabilityArgs) -> Result<(), StudyError> {
    let file = args.output.as_deref().map(|path| {
        let before = read(path)?;
        Ok::<_, StudyError>((path, before, Output::open(path, Inputs::NONE)?))
    });
    let file = file.transpose()?;
    let cases = cases::all();
    let mut progress = Progress::new(u32::try_from(cases.len() * FORMATS.len()).unwrap_or(u32::MAX));
    let rows = rows(&cases, args.rays, |count| progress.reached(count))?;
    drop(progress);
    output::print(&table::text(&rows), Inputs::NONE)?;
    if !guard::CHECKED {
        let _ = writeln!(
            io::stderr(),
            "rta: this build does not look for overflow: use cargo run --profile checked"
        );
    }
    if let Some((path, before, output)) = file {
        let profile = if guard::CHECKED { "--profile checked" } else { "--release" };
        let command = format!("cargo run {profile} -- stability --rays {} -o {}", args.rays, path.display());
        let part = format!("Made by `{command}`:\n\n{}", table::markdown(&rows));
        let text = table::into_markdown(&before, &part);
        output.write(text.as_bytes())?;
    }
    Ok(())
}

/// Returns the text of a file; empty if there is no such file yet.
fn read(path: &Path) -> Result<String, PictureError> {
    match fs::read_to_string(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(String::new()),
        other => other.map_err(|source| PictureError::write(path, source)),
    }
}
