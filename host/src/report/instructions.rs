//! Retired instructions, counted by callgrind.
//!
//! The program runs itself under valgrind: the child traces the setting after setting in a fixed order, counting only
//! inside the one function that traces pixels, and callgrind writes its counter down each time that function returns.
//! Counts are of the machine's own instructions and do not depend on its load, its clock or its caches.

use core::sync::atomic::{AtomicBool, Ordering};
use core::time::Duration;
use std::fs;
use std::io::{self, Write};
use std::path::Path;
use std::process::{Child, Command, Stdio};

use rta_core::raster::Raster;
use rta_core::sampling::Sampling;

use super::bench::{Lattice, bench};
use super::setting::{Limit, Method, samplings};
use crate::args::InstructionsArgs;
use crate::engine::EngineError;
use crate::error::Error;
use crate::fit::Hint;
use crate::scene::Scene;

/// The function that is counted, as callgrind is told: the end of its path, or that and what it is generic over. (To
/// callgrind, a star at the end is at least one letter.)
const COUNTED: [&str; 2] = ["*traced_pixels", "*traced_pixels*"];

/// Every how many pixels and rows one is counted.
pub const STEP: u32 = 10;

/// The most samples a pixel that are counted; of more, each is taken to cost what one of these does.
const MOST_SAMPLES: u32 = 4;

/// The samples that are counted in the place of `sampling`.
#[must_use]
pub fn counted(sampling: Sampling) -> Sampling {
    let same =
        |other: &Sampling| other.samples() <= MOST_SAMPLES && other.is_jittered() == sampling.is_jittered();
    if same(&sampling) { sampling } else { samplings().into_iter().rfind(same).unwrap_or(sampling) }
}

/// What the child traces, in its order.
pub fn order() -> impl Iterator<Item = (Method, Limit)> {
    let counted = samplings().into_iter().filter(|sampling| counted(*sampling) == *sampling);
    counted.flat_map(Method::with).flat_map(|method| Limit::all().map(move |limit| (method, limit)))
}

/// The child: traces everything in [`order`], and prints nothing.
///
/// # Errors
/// Those of reading a scene and making it ready.
pub fn run(args: &InstructionsArgs) -> Result<(), Error> {
    let scene = Scene::open(Path::new("-"))?;
    let failed = |source| Error::Engine { name: scene.source.clone(), source, fit: Hint::None };
    let raster =
        Raster::new(args.size.width(), args.size.height()).map_err(EngineError::from).map_err(failed)?;
    for (method, limit) in order() {
        let bench = bench(&scene.description, args.aspect.ratio(), method.format).map_err(failed)?;
        bench.time(limit, method.sampling, Lattice::every(raster, STEP)).map_err(failed)?;
    }
    Ok(())
}

/// Why there are no counts.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CountError {
    /// Valgrind cannot be started.
    #[error("valgrind cannot be started: {0}")]
    Valgrind(io::Error),
    /// It ended with an error.
    #[error("the program failed under valgrind: {0}")]
    Failed(String),
    /// Its files could not be read or written.
    #[error("callgrind's files: {0}")]
    Files(#[from] io::Error),
    /// The function that is counted is not in the symbol table, or was not called as often as it should.
    #[error("callgrind counted {found} settings of {expected}")]
    Incomplete {
        /// Counts in its files.
        found: usize,
        /// Settings.
        expected: usize,
    },
}

/// Counts the instructions of all settings in [`order`] for the scene file `text`; `program` is this program.
/// Interrupted, it returns what can be had.
///
/// # Errors
/// All of [`CountError`].
pub fn count(
    program: &Path,
    text: &[u8],
    (size, aspect): (&str, &str),
    stop: &AtomicBool,
) -> Result<Vec<u64>, CountError> {
    let folder = tempfile::tempdir()?;
    let mut command = Command::new("valgrind");
    command
        .args(["--quiet", "--tool=callgrind", "--dump-instr=no", "--dump-line=no", "--compress-strings=yes"])
        .args(COUNTED.map(|function| format!("--toggle-collect={function}")))
        .args(COUNTED.map(|function| format!("--dump-after={function}")))
        .arg(format!("--callgrind-out-file={}", folder.path().join("count").display()))
        .arg(program)
        .args(["instructions", "--size", size, "--aspect", aspect])
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::piped());
    let mut child = command.spawn().map_err(CountError::Valgrind)?;
    if let Some(mut input) = child.stdin.take() {
        // A child that does not read to the end says why itself.
        let _ = input.write_all(text);
    }
    wait(&mut child, stop)?;
    let output = child.wait_with_output()?;
    if !output.status.success() {
        return Err(CountError::Failed(String::from_utf8_lossy(&output.stderr).trim().to_owned()));
    }
    let expected = order().count();
    let read = |number: usize| fs::read_to_string(folder.path().join(format!("count.{number}")));
    let counts: Vec<_> = (1..=expected).map_while(|number| total(&read(number).ok()?)).collect();
    if counts.len() != expected || counts.contains(&0) {
        return Err(CountError::Incomplete { found: counts.len(), expected });
    }
    Ok(counts)
}

/// Waits for the end, or ends it.
fn wait(child: &mut Child, stop: &AtomicBool) -> io::Result<()> {
    while child.try_wait()?.is_none() {
        if stop.load(Ordering::Relaxed) {
            return child.kill();
        }
        std::thread::sleep(Duration::from_millis(50));
    }
    Ok(())
}

/// The counter in one of callgrind's files.
fn total(text: &str) -> Option<u64> {
    let line = text.lines().rev().find_map(|line| line.strip_prefix("totals:"))?;
    line.trim().parse().ok()
}

#[cfg(test)]
mod tests {
    use super::{counted, order, total};
    use crate::report::setting::samplings;

    #[test]
    fn totals_are_read_from_callgrinds_files() {
        let file = "# callgrind format\nversion: 1\ndesc: Trigger: --dump-after=x\nevents: Ir\nsummary: 12\n\n\
            fn=(1) x\n0 12\n\ntotals: 4567\n";
        assert_eq!(total(file), Some(4567));
        assert_eq!(total("version: 1\n"), None);
        assert_eq!(total("totals: many\n"), None);
    }

    #[test]
    fn few_samples_stand_for_many_of_their_kind() {
        let stands: Vec<_> =
            samplings().into_iter().map(|s| (counted(s).samples(), counted(s).is_jittered())).collect();
        let [regular, jittered] = [false, true];
        assert_eq!(
            stands,
            [
                (1, regular),
                (4, regular),
                (4, regular),
                (4, regular),
                (4, jittered),
                (4, jittered),
                (4, jittered)
            ]
        );
        assert_eq!(order().count(), 45 * 7);
    }
}
