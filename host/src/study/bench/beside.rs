//! Pictures of rta beside those of another program: what each costs, by whole processes, and how far it is from a converged one.

use core::sync::atomic::Ordering;
use std::path::Path;

use rta_core::color::Rgb;
use tempfile::TempDir;

use self::process::{Process, ProcessError};
use crate::args::BenchArgs;
use crate::engine::callgrind::CountError;
use crate::engine::interrupt;
use crate::engine::progress::Progress;
use crate::picture::raster::Size;
use crate::study::error::StudyError;
use crate::study::markdown;

pub mod pictures;
pub mod process;

/// A program that makes a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Program {
    /// This one.
    Rta,
    /// POV-Ray.
    Povray,
}

impl Program {
    /// Returns its name in the table.
    const fn name(self) -> &'static str {
        match self {
            Self::Rta => "rta",
            Self::Povray => "povray",
        }
    }
}

/// The processes of a picture, and where it is then.
#[derive(Clone, Debug)]
pub struct Work {
    /// Whose they are.
    pub program: Program,
    /// What they are told.
    pub settings: String,
    /// What is run.
    pub processes: Vec<Process>,
    /// The file of the picture.
    pub picture: String,
}

/// What a picture is compared by: the factor that its light was scaled by, if it was, and the RMSE.
pub type Compared = (Option<f64>, f64);

/// One picture of one program.
struct Row {
    program: Program,
    settings: String,
    /// CPU seconds of all its processes.
    seconds: Option<f64>,
    instructions: Option<u64>,
    compared: Compared,
}

/// The pictures of both programs.
pub struct Rows {
    rows: Vec<Row>,
    uncounted: Option<CountError>,
}

/// The folder in which both programs work.
pub struct Place(TempDir);

impl Place {
    /// Makes one.
    ///
    /// # Errors
    /// [`StudyError::Bench`] where it cannot be made.
    pub fn new() -> Result<Self, StudyError> {
        tempfile::tempdir().map(Self).map_err(ProcessError::Folder).map_err(StudyError::bench)
    }

    /// Writes a file into it.
    ///
    /// # Errors
    /// [`StudyError::Bench`] where it cannot be written.
    pub fn write(&self, name: &str, text: &[u8]) -> Result<(), StudyError> {
        std::fs::write(self.path().join(name), text).map_err(ProcessError::Folder).map_err(StudyError::bench)
    }

    /// Returns its path.
    #[must_use]
    pub fn path(&self) -> &Path {
        self.0.path()
    }
}

/// Returns the path of this program.
///
/// # Errors
/// [`StudyError::Bench`] where the system does not tell it.
pub fn own_program() -> Result<String, StudyError> {
    let path = std::env::current_exe().map_err(ProcessError::Folder).map_err(StudyError::bench)?;
    Ok(path.display().to_string())
}

impl Work {
    /// Returns POV-Ray's work on a scene file, with one thread: its picture of linear light is in 16 bits. With `smoothing`, the light between
    /// neighbours from which on a pixel is refined (1 is white) and how often.
    #[must_use]
    pub fn povray(input: &str, settings: String, smoothing: Option<(f64, u32)>, size: Size) -> Self {
        let [input, width, height] =
            [format!("+I{input}"), format!("+W{}", size.width()), format!("+H{}", size.height())];
        let mut words = vec![&*input, "+Otheirs.ppm", "+FP16", "File_Gamma=1.0", "+WT1"];
        let refined = smoothing.map(|(threshold, depth)| [format!("+A{threshold:?}"), format!("+R{depth}")]);
        match &refined {
            Some(refined) => words.extend(refined.iter().map(String::as_str).chain(["+AM2"])),
            None => words.push("-A"),
        }
        words.extend(["+Q9", "-D", "-V", "-GA", &width, &height]);
        let picture = "theirs.ppm".to_owned();
        Self { program: Program::Povray, settings, processes: vec![Process::new("povray", &words)], picture }
    }

    /// Runs the processes once, and returns the linear light of so many pixels and the CPU seconds, if the system tells them.
    ///
    /// # Errors
    /// [`StudyError::Bench`] where a program fails.
    pub fn drawn(&self, folder: &Path, pixels: usize) -> Result<(Vec<Rgb<f32>>, Option<f64>), StudyError> {
        let mut seconds = Some(0.0);
        for process in &self.processes {
            let took = process.run(folder).map_err(StudyError::bench)?;
            seconds = seconds.zip(took).map(|(sum, took)| sum + took);
        }
        let light = pictures::read(&folder.join(&self.picture), pixels);
        Ok((light.map_err(ProcessError::Folder).map_err(StudyError::bench)?, seconds))
    }
}

impl Rows {
    /// Draws all pictures, of so many pixels, in a folder, as often as it is asked for, compares each and counts its instructions.
    ///
    /// # Errors
    /// [`StudyError::Bench`] where a program fails, and an interrupt.
    pub fn new(
        works: &[Work],
        args: &BenchArgs,
        (folder, pixels): (&Path, usize),
        compare: &dyn Fn(&Work, &[Rgb<f32>]) -> Compared,
    ) -> Result<Self, StudyError> {
        let stop = interrupt::watch();
        let mut progress = Progress::new(u32::try_from(works.len()).unwrap_or(u32::MAX));
        let mut rows = Self { rows: Vec::new(), uncounted: None };
        for (work, done) in works.iter().zip(1..) {
            let mut row = measured(work, args, (folder, pixels), compare)?;
            if !args.no_instructions && rows.uncounted.is_none() {
                let counts = work.processes.iter().map(|process| process.count(folder, stop));
                match counts.sum::<Result<u64, _>>() {
                    Ok(count) => row.instructions = Some(count),
                    Err(error) => rows.uncounted = Some(error),
                }
            }
            if stop.load(Ordering::Relaxed) {
                return Err(StudyError::INTERRUPTED);
            }
            rows.rows.push(row);
            progress.reached(done);
        }
        Ok(rows)
    }

    /// Returns the table of all pictures of a size, and for each of POV-Ray's how many times as much it takes as rta's cheapest that errs no
    /// more.
    #[must_use]
    pub fn table(&self, title: &str, size: &str) -> String {
        let is_scaled = self.rows.iter().any(|row| row.compared.0.is_some());
        let mut head = vec!["program", "settings", "RMSE"];
        head.extend(is_scaled.then_some("factor"));
        head.extend(["CPU s", "M instructions", "x CPU of rta", "x instructions"]);
        let cells: Vec<_> = self.rows.iter().map(|row| self.cells(row, is_scaled)).collect();
        let told = self.uncounted.as_ref().map(|reason| format!("\nNo instructions: {reason}.\n"));
        format!("{title}, {size}:\n\n{}{}", markdown::table(&head, &cells, 2), told.unwrap_or_default())
    }

    fn cells(&self, row: &Row, is_scaled: bool) -> Vec<String> {
        let told = |value: Option<f64>, places: usize| {
            value.map_or_else(|| "-".to_owned(), |value| format!("{value:.places$}"))
        };
        let (factor, error) = row.compared;
        let mut cells = vec![row.program.name().to_owned(), row.settings.clone(), format!("{error:.5}")];
        if is_scaled {
            cells.push(told(factor, 3));
        }
        cells.extend([told(row.seconds, 3), told(row.millions(), 0)]);
        cells.extend([told(self.times(row, |row| row.seconds), 1), told(self.times(row, Row::millions), 1)]);
        cells
    }

    /// Returns how many times as much a picture of another program takes as rta's cheapest that errs no more.
    fn times(&self, row: &Row, cost: impl Fn(&Row) -> Option<f64>) -> Option<f64> {
        let is_good = |own: &&Row| own.program == Program::Rta && own.compared.1 <= row.compared.1;
        let least = self.rows.iter().filter(is_good).filter_map(&cost).min_by(f64::total_cmp);
        let least = least.filter(|least| *least > 0.0)?;
        (row.program != Program::Rta).then(|| cost(row).map(|cost| cost / least))?
    }
}

impl Row {
    /// Returns the instructions in millions.
    fn millions(&self) -> Option<f64> {
        #[allow(clippy::cast_precision_loss)] // below 2^53
        self.instructions.map(|count| count as f64 / 1e6)
    }
}

/// Draws a picture as often as it is asked for, and compares it.
fn measured(
    work: &Work,
    args: &BenchArgs,
    place: (&Path, usize),
    compare: &dyn Fn(&Work, &[Rgb<f32>]) -> Compared,
) -> Result<Row, StudyError> {
    let (mut seconds, mut light) = (Some(0.0), Vec::new());
    for _ in 0..args.runs {
        let (drawn, took) = work.drawn(place.0, place.1)?;
        seconds = seconds.zip(took).map(|(sum, took)| sum + took);
        light = drawn;
    }
    Ok(Row {
        program: work.program,
        settings: work.settings.clone(),
        seconds: seconds.map(|sum| sum / f64::from(args.runs)),
        instructions: None,
        compared: compare(work, &light),
    })
}

#[cfg(test)]
mod tests {
    use super::{Program, Row, Rows};

    #[test]
    fn another_program_is_set_against_the_cheapest_that_errs_no_more() {
        let row = |program, error, instructions| Row {
            program,
            settings: String::new(),
            seconds: None,
            instructions: Some(instructions),
            compared: (None, error),
        };
        let (rta, povray) = (Program::Rta, Program::Povray);
        let rows = vec![
            row(rta, 0.004, 3_000_000),
            row(rta, 0.003, 2_000_000),
            row(rta, 0.001, 8_000_000),
            row(povray, 0.003, 12_000_000),
            row(povray, 0.002, 12_000_000),
            row(povray, 0.0005, 90_000_000),
        ];
        let rows = Rows { rows, uncounted: None };
        let times: Vec<_> = rows.rows.iter().map(|row| rows.times(row, Row::millions)).collect();
        assert_eq!(times, [None, None, None, Some(6.0), Some(1.5), None]);
        let text = rows.table("a scene", "8x8");
        assert!(text.starts_with("a scene, 8x8:\n\n") && !text.contains("factor"), "{text}");
    }
}
