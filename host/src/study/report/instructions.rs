//! Retired instructions of every setting, counted by [`callgrind`]: the child traces setting after setting in a fixed
//! order.

use core::sync::atomic::AtomicBool;
use std::path::Path;

use rta_core::raster::Raster;
use rta_core::sampling::{Places, Sampling};

use super::bench::{bench, smaller};
use super::setting::{Limit, Method, samplings};
use crate::args::InstructionsArgs;
use crate::engine::EngineError;
use crate::engine::callgrind::{self, CountError};
use crate::request::error::RequestError;
use crate::request::scene_file::SceneFile;
use crate::study::error::StudyError;

/// The function that is counted, as callgrind is told: the end of its path, or that and what it is generic over. (To
/// callgrind, a star at the end is at least one letter.)
const COUNTED: [&str; 2] = ["*traced_pixels", "*traced_pixels*"];

/// Instructions are counted on every `STEP`th pixel of every `STEP`th row.
pub const STEP: u32 = 10;

/// The largest number of samples a pixel that are counted; a ray of more samples is taken to cost as much as one of these.
const MOST_SAMPLES: u32 = 4;

/// Returns the samples whose instructions stand for those of `sampling`: the same ones, or those of fewer samples a pixel.
#[must_use]
pub fn counted(sampling: Sampling) -> Sampling {
    let same =
        |other: &Sampling| other.samples() <= MOST_SAMPLES && other.is_jittered() == sampling.is_jittered();
    if same(&sampling) { sampling } else { samplings().into_iter().rfind(same).unwrap_or(sampling) }
}

/// The settings that the child traces, in their order.
pub fn order() -> impl Iterator<Item = (Method, Limit)> {
    let counted = samplings().into_iter().filter(|sampling| counted(*sampling) == *sampling);
    counted.flat_map(Method::with).flat_map(|method| Limit::all().map(move |limit| (method, limit)))
}

/// The child: traces everything in [`order`], and prints nothing.
///
/// # Errors
/// Those of reading a scene and making it ready.
pub fn run(args: &InstructionsArgs) -> Result<(), StudyError> {
    let scene = SceneFile::open(Path::new("-"))?;
    let failed = |source| RequestError::Engine { name: scene.source.clone(), source };
    let raster =
        Raster::new(args.size.width(), args.size.height()).map_err(EngineError::from).map_err(failed)?;
    for (method, limit) in order() {
        let bench = bench(&scene.description, args.aspect.ratio(), method.format).map_err(failed)?;
        bench.time(limit, method.sampling, smaller(raster, STEP)).map_err(failed)?;
    }
    Ok(())
}

/// Counts the instructions of all settings in [`order`] for the scene file `text`; `program` is this program.
/// If it is interrupted, the child is killed, which is an error.
///
/// # Errors
/// All of [`CountError`].
pub fn count(
    program: &Path,
    text: &[u8],
    (size, aspect): (&str, &str),
    stop: &AtomicBool,
) -> Result<Vec<u64>, CountError> {
    let args = ["instructions", "--size", size, "--aspect", aspect];
    callgrind::count(program, &args, text, &COUNTED, order().count(), stop)
}

#[cfg(test)]
mod tests {
    use rta_core::sampling::Places;

    use super::{counted, order};
    use crate::study::report::setting::samplings;

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
