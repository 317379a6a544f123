//! Instructions of small pictures, recorded in a file and counted again later: a change that makes the tracer slower is found
//! without a quiet machine.

use core::fmt::Write;
use core::sync::atomic::AtomicBool;
use std::path::Path;
use std::{fs, io};

use super::case::{Case, Tracing};
use super::child::{self, Work};
use crate::args::BenchArgs;
use crate::engine::Format;
use crate::engine::callgrind;
use crate::picture::output::{self, Inputs, Output};
use crate::picture::raster::Size;
use crate::study::error::StudyError;

/// The scenes whose instructions are counted.
const SCENES: [&str; 4] = ["juggler", "hall-22", "glass-2", "balls2"];
/// The formats in which each is traced.
const FORMATS: [Format; 2] = [Format::F32, Format::Q16];
/// Pixels of the pictures.
const SIZE: (u32, u32) = (64, 40);
/// By how much a count may grow before that is a failure: a twentieth.
const DRIFT: u64 = 20;
/// The beginning of the line that names the compiler.
const COMPILER: &str = "# compiler: ";

/// Returns the compiler that made this program, its target and its optimisation, as a record names them.
#[must_use]
pub fn build() -> String {
    let checked = if cfg!(debug_assertions) { ", with debug assertions" } else { "" };
    format!("{}{checked}", env!("RTA_BUILD"))
}

/// The instructions of a picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Scene and number format.
    pub key: [String; 2],
    /// Rays of all kinds.
    pub rays: u64,
    /// Instructions of the whole picture.
    pub instructions: u64,
}

/// Why a record is not compared, or how it differs.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum DriftError {
    /// The file cannot be read.
    #[error("cannot read {file}: {source}")]
    Read {
        /// The file.
        file: String,
        /// What the system says.
        source: io::Error,
    },
    /// The file is not a record of instructions.
    #[error("{file} is not a record of instructions: {reason}")]
    NotARecord {
        /// The file.
        file: String,
        /// Why not.
        reason: String,
    },
    /// Some pictures take over 5 % more instructions than recorded.
    #[error("more instructions than in {file}, by over 5 %:\n{rows}")]
    Dearer {
        /// The file.
        file: String,
        /// The pictures.
        rows: String,
    },
    /// Valgrind is not installed, on a machine of continuous integration.
    #[error("nothing is checked: valgrind is not installed")]
    NoValgrind,
}

/// Counts the instructions of all pictures.
fn count(args: &BenchArgs, stop: &AtomicBool) -> Result<Vec<Entry>, StudyError> {
    let size = match args.size {
        Some(size) => size,
        None => Size::new(SIZE.0, SIZE.1).map_err(StudyError::bench)?,
    };
    let work = Work { scenes: &SCENES, formats: &FORMATS, size: Some(size), depth: args.depth };
    let counts = child::count(&work, &[], stop).map_err(StudyError::bench)?;
    let order = SCENES.iter().flat_map(|scene| FORMATS.map(|format| (*scene, format)));
    let entry = |((scene, format), instructions): ((&str, Format), u64)| {
        let case = Case::named(scene, Tracing { format, size: Some(size), depth: args.depth })?;
        let key = [scene.to_owned(), format.to_string()];
        Ok(Entry { key, rays: case.engine().rays().iter().sum(), instructions })
    };
    order.zip(counts).map(entry).collect()
}

/// Returns the text of a record with these counts.
fn page(entries: &[Entry]) -> String {
    let mut page = format!("{COMPILER}{}\nscene,format,rays,instructions,instructions_a_ray\n", build());
    for Entry { key: [scene, format], rays, instructions } in entries {
        // A String takes all that is written to it.
        let _ = writeln!(page, "{scene},{format},{rays},{instructions},{}", instructions / (*rays).max(1));
    }
    page
}

/// Returns the compiler and the counts that a record states.
fn parse(page: &str) -> Result<(&str, Vec<Entry>), String> {
    let named = page.lines().find_map(|line| line.strip_prefix(COMPILER));
    let compiler = named.ok_or("it names no compiler")?;
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(page.as_bytes());
    /// Scene, format, rays, instructions, instructions a ray.
    type Row = (String, String, u64, u64, u64);
    let rows: Result<Vec<Row>, _> = reader.deserialize().collect();
    let entry = |(scene, format, rays, instructions, _)| Entry { key: [scene, format], rays, instructions };
    Ok((compiler, rows.map_err(|error| error.to_string())?.into_iter().map(entry).collect()))
}

/// Returns a line for each picture whose count differs by more than a twentieth: those that grew, and those that shrank.
fn drift(now: &[Entry], then: &[Entry]) -> Result<[Vec<String>; 2], String> {
    let mut drifted = [Vec::new(), Vec::new()];
    for entry in now {
        let [scene, format] = &entry.key;
        let before = then.iter().find(|other| other.key == entry.key);
        let before = before.ok_or_else(|| format!("it has no {scene} in {format}"))?.instructions;
        let instructions = entry.instructions;
        if instructions.abs_diff(before) * DRIFT > before {
            let [grew, shrank] = &mut drifted;
            let place = if instructions > before { grew } else { shrank };
            place.push(format!("  {scene} {format}: {before} -> {instructions}"));
        }
    }
    Ok(drifted)
}

/// `rta bench --record`.
///
/// # Errors
/// Those of counting the instructions and of writing the file.
pub fn record(args: &BenchArgs, file: &Path, stop: &AtomicBool) -> Result<(), StudyError> {
    let output = Output::open(file, Inputs::NONE)?;
    Ok(output.write(page(&count(args, stop)?).as_bytes())?)
}

/// `rta bench --check`.
///
/// # Errors
/// [`DriftError`] in [`StudyError::Bench`], and those of counting the instructions.
pub fn check(args: &BenchArgs, file: &Path, stop: &AtomicBool) -> Result<(), StudyError> {
    let name = || file.display().to_string();
    let page = fs::read_to_string(file)
        .map_err(|source| StudyError::bench(DriftError::Read { file: name(), source }))?;
    let not_a_record = |reason| StudyError::bench(DriftError::NotARecord { file: name(), reason });
    let (compiler, then) = parse(&page).map_err(not_a_record)?;
    if compiler != build() {
        return say(&format!("not compared: {} is of {compiler}, and this is {}", name(), build()));
    }
    if !callgrind::is_installed() {
        if std::env::var_os("CI").is_some() {
            return Err(StudyError::bench(DriftError::NoValgrind));
        }
        return say("skipped: valgrind is not installed");
    }
    let [grew, shrank] = drift(&count(args, stop)?, &then).map_err(not_a_record)?;
    if !shrank.is_empty() {
        say(&format!(
            "fewer instructions than in {}, by over 5 %: record them anew\n{}",
            name(),
            shrank.join("\n")
        ))?;
    }
    if grew.is_empty() {
        return say(&format!("no picture takes over 5 % more instructions than in {}", name()));
    }
    Err(StudyError::bench(DriftError::Dearer { file: name(), rows: grew.join("\n") }))
}

fn say(line: &str) -> Result<(), StudyError> {
    Ok(output::print(&format!("{line}\n"), Inputs::NONE)?)
}

#[cfg(test)]
mod tests {
    use super::{Entry, build, drift, page, parse};

    fn entry(instructions: u64) -> Entry {
        Entry { key: ["hall-22", "q16"].map(str::to_owned), rays: 100, instructions }
    }

    #[test]
    fn a_file_says_what_it_was_made_of() {
        let entries = [entry(70_099), Entry { rays: 0, ..entry(1) }];
        let page = page(&entries);
        assert_eq!(parse(&page), Ok((build().as_str(), entries.to_vec())));
        assert!(page.contains("hall-22,q16,100,70099,700\n") && build().starts_with("rustc "), "{page}");
        assert!(parse("scene,format\n").expect_err("no compiler").contains("compiler"));
        assert!(parse(&page.replace("70099", "many")).is_err());
    }

    #[test]
    fn drift_is_more_than_a_twentieth_and_has_a_side() {
        let drift = |now, then| drift(&[entry(now)], &[entry(then)]).expect("the same rows");
        assert_eq!(drift(10_500, 10_000), [vec![], Vec::<String>::new()]);
        assert_eq!(drift(10_501, 10_000), [vec!["  hall-22 q16: 10000 -> 10501".to_owned()], vec![]]);
        assert_eq!(drift(9_499, 10_000), [vec![], vec!["  hall-22 q16: 10000 -> 9499".to_owned()]]);
        assert!(super::drift(&[entry(1)], &[]).expect_err("a row is missing").contains("hall-22 in q16"));
    }
}
