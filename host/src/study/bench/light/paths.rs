//! `rta bench --light --peer mitsuba`: paths of both programs in a room, error and CPU time of drawing at the same numbers of samples.

use rta_core::color::Rgb;

use crate::args::BenchArgs;
use crate::engine::{bands, interrupt};
use crate::study::bench::beside::process::{Process, ProcessError};
use crate::study::bench::beside::{Place, pictures};
use crate::study::bench::mitsuba::script;
use crate::study::error::StudyError;
use crate::study::markdown;
use crate::study::report::Source;
use crate::study::report::light::method::Method;
use crate::study::report::light::raster;
use crate::study::report::light::room::Room;

/// Samples of a pixel.
const SAMPLES: [u32; 3] = [4, 16, 64];

/// Samples of the paths that both are compared with.
const REFERENCE: u32 = 4096;

/// What both programs need for a number of samples: CPU seconds of all runs, and the picture of the last.
#[derive(Clone, Debug, Default)]
struct Both {
    seconds: [f64; 2],
    light: [Vec<Rgb<f32>>; 2],
}

/// Returns the table of a room.
///
/// # Errors
/// Those of [`Room::new`], and [`StudyError::Bench`] for another scene than the script knows and where Python or Mitsuba fails.
pub(super) fn compared(source: &Source, args: &BenchArgs) -> Result<String, StudyError> {
    let (size, aspect) = raster(&source.scene, 1, (args.size, None))?;
    let told = script(&source.scene.description, &source.title, (size, aspect), &SAMPLES);
    let told = told.map_err(StudyError::bench)?;
    let room = Room::new(source, (size, aspect))?;
    let place = Place::new()?;
    place.write("draw.py", told.as_bytes())?;
    let engines = SAMPLES.iter().map(|&samples| room.engine((Method::Paths, samples), None));
    let engines: Vec<_> = engines.collect::<Result<_, _>>()?;
    let mut both = SAMPLES.map(|_| Both::default());
    let stop = interrupt::watch();
    // In turn, so that whatever else the machine does meets both.
    for run in 0..args.runs {
        let process = Process::new("python3", &["draw.py", &run.to_string()]);
        let said = process.say(place.path()).map_err(StudyError::bench)?;
        let seconds = seconds(&said).ok_or_else(|| untold(&said)).map_err(StudyError::bench)?;
        for (((samples, engine), both), theirs) in SAMPLES.iter().zip(&engines).zip(&mut both).zip(seconds) {
            let (light, ours) = room.drawn(engine);
            let path = place.path().join(format!("theirs-{samples}.pfm"));
            let read = pictures::read(&path, size.pixels()).map_err(ProcessError::Folder);
            both.light = [light, read.map_err(StudyError::bench)?];
            both.seconds = [both.seconds[0] + ours, both.seconds[1] + theirs];
        }
        if stop.load(core::sync::atomic::Ordering::Relaxed) {
            return Err(StudyError::INTERRUPTED);
        }
    }
    let reference = room.reference(REFERENCE, (&bands::pool(None)?, stop))?;
    let mut cells = Vec::new();
    for (samples, both) in SAMPLES.iter().zip(&both) {
        let [ours, theirs] = both.seconds.map(|seconds| seconds / f64::from(args.runs));
        for (program, seconds, light) in [("rta", ours, &both.light[0]), ("mitsuba", theirs, &both.light[1])]
        {
            let (factor, error) = reference.scaled_error(light);
            cells.push(vec![
                program.to_owned(),
                samples.to_string(),
                format!("{error:.5}"),
                format!("{factor:.3}"),
                format!("{seconds:.3}"),
                format!("{:.2}", seconds / ours),
            ]);
        }
    }
    let head = ["program", "samples", "RMSE", "factor", "CPU s", "x CPU of rta"];
    Ok(format!("{}, {size}, paths:\n\n{}", source.title, markdown::table(&head, &cells, 1)))
}

/// Returns the CPU seconds that the script tells, in the order of [`SAMPLES`].
fn seconds(said: &str) -> Option<[f64; SAMPLES.len()]> {
    let mut all = [0.0; SAMPLES.len()];
    let mut lines = said.lines();
    for (samples, seconds) in SAMPLES.iter().zip(&mut all) {
        let (number, told) = lines.next()?.split_once(' ')?;
        *seconds = (number.parse() == Ok(*samples)).then(|| told.parse().ok())??;
    }
    Some(all)
}

fn untold(said: &str) -> ProcessError {
    ProcessError::Failed { program: "python3".to_owned(), said: format!("it tells no times: {said}") }
}

#[cfg(test)]
mod tests {
    use super::seconds;

    #[test]
    fn times_are_read() {
        assert_eq!(seconds("4 0.25\n16 1.0\n64 4.5\n"), Some([0.25, 1.0, 4.5]));
        assert_eq!(seconds("4 0.25\n64 4.5\n16 1.0\n"), None);
        assert_eq!(seconds("4 0.25\n16 1.0\n"), None);
    }
}
