//! Files of solved radiosity: what arrives at the patches of a scene.
//!
//! ```text
//! rta radiosity 1
//! scene 93f0a1c2d4e5b677
//! patches 3
//! 54
//! .31 .3 .28  .1 .09 .08
//! ...
//! ```
//!
//! The second line is a hash of the scene's objects, lamps and materials: a solution is for that scene alone, seen from anywhere. The third
//! is the number of patches along u and v where all quads were given one, or 0. Then comes the number of patches, and a line for each, in
//! the order of the quads of [`Description::meshed`]: the irradiance from what emits, and that from all other surfaces; linear RGB each.

use core::fmt::Write;
use std::fs;
use std::sync::Arc;

use rta_drivers::checksum::Fnv;
use rta_scenes::description::Description;
use rta_scenes::solution::{Arriving, Shown, Solution, Solved, patch_count};

use super::error::{RequestError, SolutionError};
use super::scene_file::SceneFile;
use crate::args::light::{LightArgs, ShownValue};

/// What stands for light that a picture solves for by itself.
const SOLVE: &str = "solve";

/// The words that a file begins with.
const HEADER: &str = "rta radiosity 1";

/// Statements that do not change what arrives anywhere.
const APART: [&str; 9] =
    ["camera", "picture", "model", "path", "attenuation", "medium", "spectral", "sky", "ambient"];

/// Returns the hash of what decides the radiosity of a scene: its objects, lamps and materials.
#[must_use]
pub fn fingerprint(scene: &Description) -> u64 {
    let mut hash = Fnv::EMPTY;
    for line in scene.to_rta().lines() {
        let is_apart = line.split(' ').next().is_some_and(|word| APART.contains(&word));
        line.bytes().chain([b'\n']).filter(|_| !is_apart).for_each(|byte| hash.add(byte));
    }
    hash.value()
}

/// Returns the solved light that the options name, for its scene.
///
/// # Errors
/// [`RequestError::NoLight`] where the file cannot be read, [`RequestError::Light`] where it is no solution of the scene, and
/// [`RequestError::Gathered`] for light that is gathered where something moves.
pub fn open(asked: &LightArgs, scene: &SceneFile) -> Result<Option<Arc<Solved>>, RequestError> {
    let Some(path) = &asked.light else { return Ok(None) };
    let ShownValue(shown) = asked.light_as;
    if matches!(shown, Shown::Cache(_)) && scene.description.has_motion() {
        return Err(RequestError::Gathered);
    }
    if path.as_os_str() == SOLVE {
        return match shown {
            Shown::Indirect | Shown::Cache(_) => {
                let solution = Solution { patches: None, arriving: Vec::new() };
                Ok(Some(Arc::new(Solved { shown, solution })))
            }
            Shown::All => Err(RequestError::Unsolved),
        };
    }
    let name = path.display().to_string();
    let text =
        fs::read_to_string(path).map_err(|source| RequestError::NoLight { name: name.clone(), source })?;
    let solution = read(&text, &scene.description).map_err(|source| RequestError::Light { name, source })?;
    Ok(Some(Arc::new(Solved { shown, solution })))
}

/// Returns a solution as a text, for the scene that it is of.
#[must_use]
pub fn text(solution: &Solution, scene: &Description) -> String {
    let (hash, patches, count) = (fingerprint(scene), solution.patches.unwrap_or(0), solution.arriving.len());
    let mut text = format!("{HEADER}\nscene {hash:016x}\npatches {patches}\n{count}\n");
    for Arriving { direct: [r, g, b], indirect: [s, h, c] } in &solution.arriving {
        // A String takes all that is written to it.
        let _ = writeln!(text, "{r} {g} {b}  {s} {h} {c}");
    }
    text
}

/// Reads a solution of a scene.
///
/// # Errors
/// [`SolutionError`].
pub fn read(text: &str, scene: &Description) -> Result<Solution, SolutionError> {
    let mut lines = (1..).zip(text.lines());
    let mut next = |expected| {
        let (line, text) = lines.next().unwrap_or((0, ""));
        (text, SolutionError::Malformed { line: line.max(1), expected })
    };
    let (head, error) = next(HEADER);
    if head.trim_end() != HEADER {
        return Err(error);
    }
    let (text, error) = next("\"scene\" and a hash of 16 hexadecimal digits");
    let found = text.strip_prefix("scene ").and_then(|hash| u64::from_str_radix(hash.trim_end(), 16).ok());
    let (found, own) = (found.ok_or(error)?, fingerprint(scene));
    if found != own {
        return Err(SolutionError::Other { found, scene: own });
    }
    let (text, error) = next("\"patches\" and a number, 0 for those of the scene");
    let patches = text.strip_prefix("patches ").and_then(|number| number.trim_end().parse().ok());
    let patches = Some(patches.ok_or(error)?).filter(|&patches| patches > 0);
    let (text, error) = next("the number of patches");
    let count: usize = text.trim_end().parse().map_err(|_| error)?;
    let needed = patch_count(&scene.meshed(patches).quads);
    if count != needed {
        return Err(SolutionError::Patches { found: count, scene: needed });
    }
    let mut arriving = Vec::with_capacity(count);
    for _ in 0..count {
        let (text, error) = next("six numbers, 0 or more: direct and indirect irradiance");
        let numbers = text
            .split_ascii_whitespace()
            .map(|word| word.parse::<f64>().ok().filter(|number| number.is_finite() && *number >= 0.0));
        let numbers: Option<Vec<f64>> = numbers.collect();
        let [r, g, b, s, h, c] = numbers.as_deref().unwrap_or_default() else { return Err(error) };
        arriving.push(Arriving { direct: [*r, *g, *b], indirect: [*s, *h, *c] });
    }
    Ok(Solution { patches, arriving })
}
