//! What of illumination models and air is in programs that draw with one model, and how much larger they are than with another.
//!
//! What is in a program is told by the source files of its line table: code has them even where it is inlined and has no
//! symbol. They do not tell functions without code, nor tables apart from the code that reads them.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use rta_scenes::bake::Model;

use super::Failure;
use super::board::Output;
use super::picture::{HAZE, LIMITS, MEASURED, MODELS};
use super::row::Row;

/// Makes the names of the models' types, in the order of the core's list.
macro_rules! types {
    ($($Model:ident $name:literal $facts:tt)*) => { [$((stringify!($Model), Model::$Model)),*] };
}

/// The folder of the models, and of air, in the core.
const FOLDER: &str = "illumination/";

/// Returns the path of a model's source file from [`FOLDER`] on.
fn file(model: Model) -> String {
    format!("{FOLDER}{}.rs", model.name().replace('-', "_"))
}

/// Returns the files of the models that are allowed where `model` draws: its own, and of the models that it consists of, which are those
/// that its code names. So Kay's and Greenberg's surfaces are Whitted's, and Newell's are Phong's.
fn parts(model: Model) -> Result<BTreeSet<String>, Failure> {
    let types = rta_core::with_models!(types);
    let core = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../core/src");
    let (mut parts, mut open) = (BTreeSet::new(), vec![model]);
    while let Some(model) = open.pop() {
        if !parts.insert(file(model)) {
            continue;
        }
        let text = fs::read_to_string(core.join(file(model)))?;
        let code = text.lines().take_while(|line| !line.starts_with("#[cfg(test)]"));
        let code = code.filter(|line| !line.trim_start().starts_with("//"));
        let words: BTreeSet<_> =
            code.flat_map(|line| line.split(|c: char| !c.is_alphanumeric() && c != '_')).collect();
        open.extend(types.iter().filter(|(name, _)| words.contains(name)).map(|&(_, model)| model));
    }
    Ok(parts)
}

/// Returns, in words, which programs have code of a model that they do not draw with, or of air where the scene has none; and which
/// show no code where there must be some, so that they would tell nothing.
///
/// # Errors
/// A model's source file cannot be read.
pub fn strange(rows: &[Row]) -> Result<Vec<String>, Failure> {
    let all: BTreeSet<_> = Model::ALL.iter().map(|&model| file(model)).collect();
    let mut found = Vec::new();
    for Row { board, picture, sources, .. } in rows.iter().filter(|row| row.board.output != Output::Module) {
        // Without another, the scenes are drawn by the thesis's model.
        let model = picture.model.unwrap_or(Model::Rta);
        let is_air = |path: &&String| path.starts_with("illumination/air") || path.contains("/airlight");
        let parts = parts(model)?;
        let mut wrong: Vec<_> =
            sources.intersection(&all).filter(|path| !parts.contains(*path)).cloned().collect();
        let air = sources.iter().filter(is_air);
        if picture.scene == HAZE.0 {
            if air.count() == 0 {
                found.push(format!("{}: no code of air, so the others tell nothing", picture.title(board)));
            }
        } else {
            wrong.extend(air.cloned());
        }
        if !wrong.is_empty() {
            found.push(format!("{}: it has code of {}", picture.title(board), wrong.join(", ")));
        }
        if !sources.contains(&file(model)) {
            found.push(format!("{}: no code of its model, so the others tell nothing", picture.title(board)));
        }
    }
    Ok(found)
}

/// Prints how much larger programs for the Cortex-M0 are with each model than with `whitted`, and returns, in words, which are larger
/// than they may be.
#[must_use]
pub fn large(rows: &[Row]) -> Vec<String> {
    let text = |scene: &str, model: Model| {
        let of = |row: &&Row| {
            let picture = &row.picture;
            row.board.name == "microbit" && picture.scene == scene && picture.model == Some(model)
        };
        rows.iter().find(of).and_then(|row| row.footprint.as_ref()).map(|footprint| footprint.text)
    };
    let mut found = Vec::new();
    for scene in [MODELS.0].into_iter().chain(MEASURED.map(|(scene, _)| scene)) {
        let Some(base) = text(scene, Model::Whitted) else { continue };
        println!("microbit {scene} q16: {base} bytes of code with whitted");
        for &model in Model::ALL.iter().filter(|&&model| model != Model::Whitted) {
            let Some(text) = text(scene, model) else { continue };
            let more = text.cast_signed() - base.cast_signed();
            let limit = LIMITS.iter().find(|(limited, _)| *limited == model && scene != MODELS.0);
            let words = limit.map_or_else(String::new, |(_, most)| format!(" of at most {most}"));
            println!("  {:14} {more:+}{words}", model.name());
            if limit.is_some_and(|&(_, most)| more > most) {
                found.push(format!("microbit {scene} q16 {model}: {more:+} bytes of code{words}"));
            }
        }
    }
    found
}
