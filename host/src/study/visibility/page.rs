//! What `rta visibility` prints: tables in Markdown.

use super::algorithm::ALL;
use super::comparison::{Apart, Comparison};
use super::eye::Seen;
use super::faces::Faces;
use super::growth::{Cost, Crossing, FACES, TABLE};
use crate::study::markdown::table;

/// Returns a line about what there is to be seen.
#[must_use]
pub fn head(title: &str, rows: u32, faces: &Faces, seen: &Seen) -> String {
    let Seen { view, scale, outside, clipped, degenerate, turned } = seen;
    let mut text = format!(
        "{title}, tessellate {rows}, {}: {} faces, {} triangles before the eye (faces outside {outside}, clipped {clipped}; triangles degenerate \
         {degenerate}, turned away {turned}), 2^{scale} units a length\n",
        view.raster.size,
        faces.all.len(),
        view.triangles.len(),
    );
    if let Some(reach) = faces.reach {
        let reach = if reach < 1e6 { format!("{reach:.4}") } else { format!("{reach:.4e}") };
        text += &format!(
            "planes, the floor and infinite cylinders end {reach} from the place nearest to the eye\n"
        );
    }
    if faces.lamps > 0 {
        text += &format!("left out: lamps {}\n", faces.lamps);
    }
    text
}

/// Returns the table of all algorithms, and what they counted.
#[must_use]
pub fn comparison(of: &Comparison) -> String {
    let head = ["algorithm", "ids", "pixels apart", "steps", "bytes", "ms"];
    let verdict = |is_equal: bool| if is_equal { "equal" } else { "DIFFER" }.to_owned();
    let mut rows: Vec<_> = of
        .runs
        .iter()
        .map(|(algorithm, run)| match run {
            Ok(run) => vec![
                algorithm.name.to_owned(),
                verdict(run.is_equal(algorithm)),
                run.apart.pixels().to_string(),
                run.outcome.counts.steps().to_string(),
                run.outcome.bytes.to_string(),
                format!("{:.1}", run.milliseconds),
            ],
            Err(_) => [algorithm.name, "left out", "", "", "", ""].map(str::to_owned).to_vec(),
        })
        .collect();
    let Apart { elsewhere, .. } = of.tracer;
    let apart = of.tracer.pixels().to_string();
    rows.push(
        ["rta's tracer, f64".to_owned(), verdict(elsewhere == 0), apart]
            .into_iter()
            .chain([const { String::new() }; 3])
            .collect(),
    );
    let mut text = table(&head, &rows, 2) + "\n";
    for (algorithm, run) in &of.runs {
        let counts = run.as_ref().map_or_else(ToString::to_string, |run| run.outcome.counts.to_string());
        text += &format!("- {} ({}): {counts}\n", algorithm.name, algorithm.source);
    }
    let seen = of.ids.iter().filter(|id| **id != 0).count() as f64 / of.ids.len().max(1) as f64;
    let areas = of.runs.iter().find_map(|(_, run)| run.as_ref().ok()?.outcome.areas.as_ref());
    let area = areas.map_or_else(String::new, |areas| format!(", {:.9} by areas", areas.iter().sum::<f64>()));
    text += &format!("- part of the picture that is covered: {seen:.9} by pixels{area}\n");
    text + if of.is_equal() { "all ids are equal\n" } else { "ids DIFFER\n" }
}

/// Returns the table of costs beside that of 1974, and where costs cross.
#[must_use]
pub fn growth(costs: &[Cost], crossings: &[Crossing]) -> String {
    let least =
        costs.first().and_then(|cost| cost.steps.iter().flatten().min()).map_or(1.0, |steps| *steps as f64);
    let heads: Vec<_> = costs.iter().map(|cost| cost.faces.to_string()).collect();
    let head: Vec<_> = ["steps at faces"].into_iter().chain(heads.iter().map(String::as_str)).collect();
    let row = |name: &str, cells: Vec<String>| [vec![name.to_owned()], cells].concat();
    let mut rows = vec![row("tessellate", costs.iter().map(|cost| cost.rows.to_string()).collect())];
    rows.push(row("triangles before the eye", costs.iter().map(|cost| cost.triangles.to_string()).collect()));
    for (place, algorithm) in ALL.iter().enumerate() {
        let steps = |cost: &Cost| cost.steps.get(place).copied().flatten();
        let relative = |cost: &Cost| {
            steps(cost).map_or("left out".into(), |steps| format!("{:.2}", steps as f64 / least))
        };
        rows.push(row(algorithm.name, costs.iter().map(relative).collect()));
    }
    let mut text = table(&head, &rows, 1) + "\n";
    let heads = FACES.map(|faces| faces.to_string());
    let head: Vec<_> =
        ["Sutherland, Sproull and Schumacker"].into_iter().chain(heads.iter().map(String::as_str)).collect();
    let rows: Vec<_> =
        TABLE.iter().map(|(name, costs)| row(name, costs.map(|cost| cost.to_string()).to_vec())).collect();
    text += &(table(&head, &rows, 1) + "\n");
    for Crossing { few, many, faces } in crossings {
        text += &format!("- {few} is cheaper than {many} below {faces:.0} faces, and dearer above\n");
    }
    text
}
