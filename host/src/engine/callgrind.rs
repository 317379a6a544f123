//! Retired instructions, counted by callgrind.
//!
//! The program runs itself under valgrind: the child does one piece of work after the other in a fixed order, counting
//! only inside the one function that does it, and callgrind writes its counter down each time that function returns.
//! Counts are of the machine's own instructions and do not depend on its load, its clock or its caches.

use core::sync::atomic::{AtomicBool, Ordering};
use core::time::Duration;
use std::fs;
use std::io::{self, Write};
use std::path::Path;
use std::process::{Child, Command, Stdio};

/// Why instructions could not be counted.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CountError {
    /// Valgrind cannot be started.
    #[error("valgrind cannot be started: {0}")]
    Valgrind(io::Error),
    /// The program under valgrind ended with an error.
    #[error("the program failed under valgrind: {0}")]
    Failed(String),
    /// Callgrind's files could not be read or written.
    #[error("callgrind's files: {0}")]
    Files(#[from] io::Error),
    /// The function that is counted is not in the symbol table, or was not called as often as it should.
    #[error("callgrind counted {found} calls of {expected}")]
    Incomplete {
        /// Counts found in callgrind's files.
        found: usize,
        /// Calls that should have been counted.
        expected: usize,
    },
}

/// Whether valgrind is installed.
#[must_use]
pub fn is_installed() -> bool {
    Command::new("valgrind")
        .arg("--version")
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok_and(|status| status.success())
}

/// Counts the instructions of each call of `functions` (as callgrind is told them) in `program`, which is run with `args`
/// and `input` on its standard input, and makes `expected` such calls. Once `stop`
/// is true the program is killed, which is [`CountError::Failed`].
///
/// # Errors
/// All of [`CountError`].
pub fn count(
    program: &Path,
    args: &[&str],
    input: &[u8],
    functions: &[&str],
    expected: usize,
    stop: &AtomicBool,
) -> Result<Vec<u64>, CountError> {
    let folder = tempfile::tempdir()?;
    let mut command = Command::new("valgrind");
    command
        .args(["--quiet", "--tool=callgrind", "--dump-instr=no", "--dump-line=no", "--compress-strings=yes"])
        .args(functions.iter().map(|function| format!("--toggle-collect={function}")))
        .args(functions.iter().map(|function| format!("--dump-after={function}")))
        .arg(format!("--callgrind-out-file={}", folder.path().join("count").display()))
        .arg(program)
        .args(args)
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::piped());
    let mut child = command.spawn().map_err(CountError::Valgrind)?;
    if let Some(mut pipe) = child.stdin.take() {
        // A child that does not read to the end says why itself.
        let _ = pipe.write_all(input);
    }
    wait(&mut child, stop)?;
    let output = child.wait_with_output()?;
    if !output.status.success() {
        return Err(CountError::Failed(String::from_utf8_lossy(&output.stderr).trim().to_owned()));
    }
    let read = |number: usize| fs::read_to_string(folder.path().join(format!("count.{number}")));
    let counts: Vec<_> = (1..=expected).map_while(|number| total(&read(number).ok()?)).collect();
    if counts.len() != expected || counts.contains(&0) {
        return Err(CountError::Incomplete { found: counts.len(), expected });
    }
    Ok(counts)
}

/// Counts the instructions of a whole program, run in `folder` with `arguments`, from its start to its end. Once `stop` is true it is
/// killed, which is [`CountError::Failed`].
///
/// # Errors
/// All of [`CountError`].
pub fn whole(
    program: &str,
    arguments: &[String],
    folder: &Path,
    stop: &AtomicBool,
) -> Result<u64, CountError> {
    let own = tempfile::tempdir()?;
    let (counts, words) = (own.path().join("count"), own.path().join("words"));
    let mut child = Command::new("valgrind")
        .args(["--quiet", "--tool=callgrind", "--dump-instr=no", "--dump-line=no"])
        .arg(format!("--callgrind-out-file={}", counts.display()))
        .arg(program)
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        // Into a file: a pipe that nobody empties would stop a program that says much.
        .stderr(fs::File::create(&words)?)
        .spawn()
        .map_err(CountError::Valgrind)?;
    wait(&mut child, stop)?;
    if !child.wait()?.success() {
        return Err(CountError::Failed(String::from_utf8_lossy(&fs::read(&words)?).trim().to_owned()));
    }
    total(&fs::read_to_string(&counts)?).ok_or(CountError::Incomplete { found: 0, expected: 1 })
}

/// Waits until the process ends, or kills it once `stop` becomes true.
fn wait(child: &mut Child, stop: &AtomicBool) -> io::Result<()> {
    while child.try_wait()?.is_none() {
        if stop.load(Ordering::Relaxed) {
            return child.kill();
        }
        std::thread::sleep(Duration::from_millis(50));
    }
    Ok(())
}

/// Returns the instructions that one of callgrind's files has counted, if it is such a file.
fn total(text: &str) -> Option<u64> {
    let line = text.lines().rev().find_map(|line| line.strip_prefix("totals:"))?;
    line.trim().parse().ok()
}

#[cfg(test)]
mod tests {
    use super::total;

    #[test]
    fn totals_are_read_from_callgrinds_files() {
        let file = "# callgrind format\nversion: 1\ndesc: Trigger: --dump-after=x\nevents: Ir\nsummary: 12\n\n\
            fn=(1) x\n0 12\n\ntotals: 4567\n";
        assert_eq!(total(file), Some(4567));
        assert_eq!(total("version: 1\n"), None);
        assert_eq!(total("totals: many\n"), None);
    }
}
