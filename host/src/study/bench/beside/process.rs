//! Programs that are run, and what they cost.

use core::sync::atomic::AtomicBool;
use std::fs;
use std::io;
use std::path::Path;
use std::process::{Command, Stdio};

use crate::engine::callgrind::{self, CountError};

/// Ticks of a second in which Linux counts the CPU time of processes.
const TICKS: f64 = 100.0;

/// Why a program did not do its work.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ProcessError {
    /// It cannot be started.
    #[error("{program} cannot be started: {source}")]
    Start {
        /// The program.
        program: String,
        /// What the system says.
        source: io::Error,
    },
    /// It ended with an error.
    #[error("{program} fails: {said}")]
    Failed {
        /// The program.
        program: String,
        /// The end of what it said.
        said: String,
    },
    /// Its files cannot be written or read.
    #[error("the files of both programs: {0}")]
    Folder(io::Error),
}

/// A program with its arguments.
#[derive(Clone, Debug)]
pub struct Process {
    program: String,
    arguments: Vec<String>,
}

impl Process {
    /// Returns a program with its arguments, separate words.
    #[must_use]
    pub fn new(program: &str, arguments: &[&str]) -> Self {
        Self { program: program.to_owned(), arguments: arguments.iter().map(ToString::to_string).collect() }
    }

    /// Runs it in a folder, and returns the CPU seconds that it takes, in user code and for it in the system, to a hundredth; `None` where the
    /// system does not tell.
    ///
    /// # Errors
    /// [`ProcessError::Start`] and [`ProcessError::Failed`].
    pub fn run(&self, folder: &Path) -> Result<Option<f64>, ProcessError> {
        let before = children();
        self.say(folder)?;
        Ok(before.zip(children()).map(|(before, after)| (after - before) / TICKS))
    }

    /// Runs it in a folder, and returns what it writes to its standard output.
    ///
    /// # Errors
    /// [`ProcessError::Start`] and [`ProcessError::Failed`].
    pub fn say(&self, folder: &Path) -> Result<String, ProcessError> {
        let ended = Command::new(&self.program)
            .args(&self.arguments)
            .current_dir(folder)
            .stdin(Stdio::null())
            .output()
            .map_err(|source| ProcessError::Start { program: self.program.clone(), source })?;
        if !ended.status.success() {
            let said = String::from_utf8_lossy(&ended.stderr);
            let lines: Vec<_> = said.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
            let said = lines.get(lines.len().saturating_sub(4)..).unwrap_or_default().join(" ");
            return Err(ProcessError::Failed { program: self.program.clone(), said });
        }
        Ok(String::from_utf8_lossy(&ended.stdout).into_owned())
    }

    /// Counts the instructions of the whole process, from its start to its end.
    ///
    /// # Errors
    /// Those of [`callgrind::whole`].
    pub fn count(&self, folder: &Path, stop: &AtomicBool) -> Result<u64, CountError> {
        callgrind::whole(&self.program, &self.arguments, folder, stop)
    }
}

/// Returns the CPU time of all processes that this one has waited for, in ticks.
fn children() -> Option<f64> {
    ticks(&fs::read_to_string("/proc/self/stat").ok()?)
}

/// Reads `cutime` and `cstime`, the 16th and the 17th field; the second is a name in parentheses that may hold anything.
fn ticks(stat: &str) -> Option<f64> {
    let mut fields = stat.rsplit_once(')')?.1.split_whitespace().skip(13);
    let mut next = || fields.next()?.parse::<f64>().ok();
    Some(next()? + next()?)
}

#[cfg(test)]
mod tests {
    use super::ticks;

    #[test]
    fn the_time_of_children_is_read() {
        let stat = "7 (a ) b) S 1 2 3 4 5 6 7 8 9 10 11 12 31 42 20 0 1";
        assert_eq!(ticks(stat), Some(73.0));
        assert_eq!(ticks("7 (a) S 1"), None);
        assert_eq!(ticks(""), None);
    }
}
