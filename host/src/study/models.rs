//! `rta models`: what the illumination models are, and what each costs.

use core::time::Duration;
use std::time::Instant;

use rta_core::Q16;
use rta_core::illumination::table::Tabled;
use rta_core::scalar::Scalar;
use rta_core::trace::Pending;
use rta_scenes::in_model;

use super::error::StudyError;
use super::markdown;
use crate::engine::{Engine, Model, Settings};
use crate::picture::output::{Inputs, print};
use crate::request::scene_file::SceneFile;

/// A picture of each model is drawn so often; the quickest time counts.
const TIMES: u32 = 5;

/// Returns the bytes of a row of a model's own parameters and of a waiting ray, in q16 on this machine.
fn bytes<S: Scalar, M: Tabled<S>>(_: &M) -> [usize; 2] {
    [size_of::<M::Row>(), size_of::<Pending<S, M::Weight>>()]
}

/// Returns the quickest time that a small picture of the scene takes.
fn time(scene: &SceneFile, model: Model) -> Result<Duration, StudyError> {
    let settings = Settings { width: 160, height: 100, model, ..Settings::default() };
    let engine = Engine::new(&scene.description, &settings).map_err(StudyError::report)?;
    let mut light = vec![rta_core::color::Rgb::new(0.0, 0.0, 0.0); 160 * 100];
    let times = (0..TIMES).map(|_| {
        let start = Instant::now();
        engine.linear_rows(0, &mut light);
        start.elapsed()
    });
    Ok(times.min().unwrap_or_default())
}

/// Runs `rta models`: prints the list.
///
/// # Errors
/// Those of drawing the Juggler and of writing to standard output.
pub fn run() -> Result<(), StudyError> {
    let scene = SceneFile::juggler()?;
    let whitted = time(&scene, Model::Whitted)?.as_secs_f64();
    let rows = Model::ALL.iter().map(|&model| {
        let facts = model.facts();
        let [row, ray] = in_model!(model, model => bytes::<Q16, _>(&model));
        let time = time(&scene, model)?.as_secs_f64() / whitted;
        let words = [model.name(), facts.year, facts.author, facts.formula, facts.rays].map(str::to_owned);
        Ok([words.to_vec(), vec![row.to_string(), ray.to_string(), format!("{time:.2}")]].concat())
    });
    let rows = rows.collect::<Result<Vec<_>, StudyError>>()?;
    let head = ["model", "year", "author", "formula", "rays", "row", "waiting ray", "time"];
    let table = markdown::table(&head, &rows, 5);
    let text = format!(
        "{table}\nC colour, N normal, L to the lamp, V to the eye, R reflected, H halfway between L and V; I light of a lamp, E where it \
         fades,\nIa ambient, Ir and It of the reflected and the transmitted ray; S what reaches the surface of a lamp; d length of the ray.\n\
         Bytes in q16: of a row of the model's own parameters of a material, and of a ray that waits. Time beside whitted, the Juggler in f32.\n"
    );
    print(&text, &Inputs::default()).map_err(StudyError::from)
}
