//! `rta check`: the proof that a scene fits a number format, or why it does not.

use rta_core::range::{Bound, Cause};
use rta_core::scalar::Magnitude;
use rta_core::scene::Object;
use rta_scenes::description::Description;
use rta_scenes::unused::{Unused, unused};

use crate::args::CheckArgs;
use crate::engine::admission::{Verdict, verdict};
use crate::engine::{Format, Model};
use crate::error::Error;
use crate::picture::output::print;
use crate::request::fit::Fit;
use crate::request::scene_file::SceneFile;

/// Runs `rta check`: prints the proof.
///
/// # Errors
/// Those of reading the scene and of writing to standard output, and [`RequestError::Refused`](crate::request::error::RequestError::Refused) where the format does not admit it.
pub fn run(args: &CheckArgs) -> Result<(), Error> {
    let scene = SceneFile::open_as(&args.scene, args.reading.into())?;
    let aspect = args.aspect.ratio();
    let fit = Fit { format: args.format, aspect, model: args.model, depth: 0, asked: args.fit };
    let description = fit.scaled(&scene);
    let Verdict { rows, refused } = verdict(&description, args.format, aspect);
    print(&table(&scene.title, args.format, &rows), &scene.inputs)?;
    print(&spare(&scene.description, args.model.unwrap_or(scene.description.model)), &scene.inputs)?;
    let Some(reason) = refused else {
        fit.advise(&scene);
        let line = format!("{} is admitted to {}\n", scene.title, args.format);
        return Ok(print(&line, &scene.inputs)?);
    };
    Err(fit.refused(&scene, reason).into())
}

/// Returns a line for each material that states what the model does not use.
fn spare(scene: &Description, model: Model) -> String {
    let line = |Unused { material, line, properties }: Unused| {
        let defined = if line == 0 { String::new() } else { format!(" (line {line})") };
        format!("{model} does not use of the material {material}{defined}: {}\n", properties.join(", "))
    };
    unused(scene, model).into_iter().map(line).collect()
}

fn value(size: Magnitude) -> f64 {
    let (mantissa, exponent) = size.parts();
    f64::from(mantissa) * 2f64.powi(exponent.max(-1100))
}

/// Formats a number with about six digits.
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
        let other = match row.other {
            Some(Cause::Object(other)) => format!(", {other}"),
            Some(Cause::Eye) => ", the observer".into(),
            None => String::new(),
        };
        let (name, by) = (row.quantity.to_string(), object(row.object) + &other);
        lines.push(format!(
            "{name:32} {:>12} {:>12} {headroom:>11}{mark} {by}",
            digits(bound),
            digits(limit)
        ));
    }
    lines.push(String::new());
    lines.join("\n")
}
