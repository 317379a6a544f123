//! `rta check`: the proof that a scene fits a number format, or why it does not.

use std::io::{self, Write};
use std::path::Path;

use rta_core::range::{Bound, Magnitude, RangeError};
use rta_core::scene::Object;
use rta_core::{Q16, Q20};
use rta_scenes::description::Description;
use rta_scenes::narrow::{Narrow, NarrowError, narrow};

use crate::args::CheckArgs;
use crate::engine::Format;
use crate::error::Error;
use crate::request::fit::Fit;
use crate::request::scene_file::SceneFile;

/// The formats in the order in which they are suggested: fixed point first, the finest that fits.
const SUGGESTED: [Format; 4] = [Format::Q20, Format::Q16, Format::F32, Format::F64];

/// What was found of a scene in a number format.
#[derive(Debug)]
pub struct Verdict {
    /// The rows of the proof; none where the scene's numbers cannot even be written in the format.
    pub rows: Vec<Bound>,
    /// Why the scene is refused, if it is.
    pub refused: Option<Refusal>,
}

/// Why a scene is refused.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Refusal {
    /// A number of the scene does not fit the format.
    #[error(transparent)]
    Narrow(#[from] NarrowError),
    /// A row of the proof does not hold.
    #[error(transparent)]
    Range(#[from] RangeError),
}

/// Tries the proof.
pub fn verdict(scene: &Description, format: Format, aspect: f64) -> Verdict {
    match format {
        Format::F32 => prove::<f32>(scene, aspect),
        Format::F64 => prove::<f64>(scene, aspect),
        Format::Q16 => prove::<Q16>(scene, aspect),
        Format::Q20 => prove::<Q20>(scene, aspect),
    }
}

fn prove<S: Narrow>(scene: &Description, aspect: f64) -> Verdict {
    match narrow::<S>(scene, aspect) {
        Err(error) => Verdict { rows: Vec::new(), refused: Some(error.into()) },
        Ok(narrowed) => Verdict {
            rows: narrowed.scene().prove(&narrowed.camera).bounds.to_vec(),
            refused: narrowed.scene().admit(&narrowed.camera).err().map(Refusal::from),
        },
    }
}

/// Whether a format admits a scene.
pub fn admits(scene: &Description, format: Format, aspect: f64) -> bool {
    fn admits<S: Narrow>(scene: &Description, aspect: f64) -> bool {
        narrow::<S>(scene, aspect).is_ok_and(|narrowed| narrowed.scene().admit(&narrowed.camera).is_ok())
    }
    match format {
        Format::F32 => admits::<f32>(scene, aspect),
        Format::F64 => admits::<f64>(scene, aspect),
        Format::Q16 => admits::<Q16>(scene, aspect),
        Format::Q20 => admits::<Q20>(scene, aspect),
    }
}

/// The formats other than `format` that admit the scene, the finest fixed point first.
pub fn alternatives(scene: &Description, format: Format, aspect: f64) -> Vec<Format> {
    let fits = |f: &Format| *f != format && admits(scene, *f, aspect);
    SUGGESTED.into_iter().filter(fits).collect()
}

/// Prints the proof.
///
/// # Errors
/// What keeps the scene from being read, and [`Error::Refused`] where the format does not admit it.
pub fn run(args: &CheckArgs) -> Result<(), Error> {
    let scene = SceneFile::open(&args.scene)?;
    let aspect = args.aspect.ratio();
    let fit = Fit { format: args.format, aspect, model: None, asked: args.fit };
    let description = fit.scaled(&scene);
    let Verdict { rows, refused } = verdict(&description, args.format, aspect);
    print(&table(&scene.title, args.format, &rows))?;
    let Some(reason) = refused else {
        return print(&format!("{} is admitted to {}\n", scene.title, args.format));
    };
    Err(fit.refused(&scene, reason))
}

fn print(text: &str) -> Result<(), Error> {
    io::stdout()
        .lock()
        .write_all(text.as_bytes())
        .map_err(|error| Error::write(Path::new("standard output"), error))
}

fn value(size: Magnitude) -> f64 {
    let (mantissa, exponent) = size.parts();
    f64::from(mantissa) * 2f64.powi(exponent.max(-1100))
}

/// A number in at most six digits.
fn digits(value: f64) -> String {
    if value == 0.0 || (1e-3..1e7).contains(&value) {
        let decimals = if value >= 1e4 {
            0
        } else if value >= 10.0 {
            2
        } else {
            4
        };
        format!("{value:.decimals$}")
    } else {
        format!("{value:.3e}")
    }
}

fn object(object: Option<Object>) -> String {
    object.map_or_else(|| "-".into(), |object| object.to_string())
}

fn table(title: &str, format: Format, rows: &[Bound]) -> String {
    let mut lines = Vec::with_capacity(rows.len() + 4);
    if !rows.is_empty() {
        lines.push(format!("{title} in {format}: every quantity over all rays of the scene\n"));
        let [name, bound, limit, headroom] = ["quantity", "bound", "limit", "headroom"];
        lines.push(format!("{name:32} {bound:>12} {limit:>12} {headroom:>11}  set by"));
    }
    for row in rows {
        let (bound, limit) = (value(row.bound), value(row.limit));
        let headroom = match (limit / bound).log2() {
            bits if bits.is_finite() => format!("{bits:+.1} bits"),
            _ => "all".into(),
        };
        let mark = if row.holds() { ' ' } else { '!' };
        let (name, by) = (row.quantity.name(), object(row.object));
        lines.push(format!(
            "{name:32} {:>12} {:>12} {headroom:>11}{mark} {by}",
            digits(bound),
            digits(limit)
        ));
    }
    lines.push(String::new());
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use rta_scenes::{dat, shipped};

    use super::*;

    #[test]
    fn shipped_scenes_are_admitted_to_every_format() {
        for (name, text) in shipped::ALL {
            let scene = dat::read(text.as_bytes(), name).expect("a shipped scene");
            for format in SUGGESTED {
                let verdict = verdict(&scene, format, 4.0 / 3.0);
                assert!(verdict.refused.is_none(), "{name} in {format}: {:?}", verdict.refused);
                assert_eq!(verdict.rows.len(), 12);
            }
        }
    }

    #[test]
    fn a_wide_scene_is_refused_by_name_and_another_format_suggested() {
        let mut scene = dat::read(shipped::GLASS_2.as_bytes(), "glass-2.dat").expect("a shipped scene");
        scene.lamps.iter_mut().for_each(|lamp| lamp.position = [0.0, 1500.0, 900.0]);
        let refusal = verdict(&scene, Format::Q20, 1.0).refused.expect("it is too wide").to_string();
        assert!(
            refusal.starts_with("lamp 1 is out of the number format's range: distance between two places 17"),
            "{refusal}"
        );
        assert!(refusal.ends_with("beyond the largest 1536"), "{refusal}");
        assert_eq!(alternatives(&scene, Format::Q20, 1.0), [Format::Q16, Format::F32, Format::F64]);
    }

    #[test]
    fn a_mirror_that_makes_light_is_refused() {
        let mut scene = dat::read(shipped::HALL_22.as_bytes(), "hall-22.dat").expect("a shipped scene");
        scene.spheres.iter_mut().for_each(|sphere| sphere.color = [1.1, 0.5, 0.5]);
        let refusal = verdict(&scene, Format::Q16, 1.0).refused.expect("its weights grow").to_string();
        assert!(refusal.contains("sphere 1") && refusal.contains("weight of a ray"), "{refusal}");
        assert!(verdict(&scene, Format::F32, 1.0).refused.is_none());
    }
}
