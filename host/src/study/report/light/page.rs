//! The study as a page to read, as comma-separated values, and its pictures side by side.

use core::fmt::Write;

use rta_core::color::Rgb;

use super::diagram::{Axis, front};
use super::method::Method;
use super::{Row, STEP, Study};
use crate::picture::file::Displayed;
use crate::study::error::StudyError;
use crate::study::markdown::table;
use crate::study::sheet::{beside, cell, displayed, stacked, title};

/// How many times as bright as they are the differences from the reference are shown.
const BRIGHTER: f32 = 4.0;

/// The exponent of screens of today, for which the light of the pictures is coded, so that the dark parts of a room are seen.
const GAMMA: f32 = 2.2;

/// Errors for which the cheapest picture of each method is named, from large to small.
const TARGETS: [f64; 6] = [0.05, 0.03, 0.02, 0.015, 0.01, 0.007];

/// Returns all rows as comma-separated values. The last column, `cpu_s`, is the only one whose values differ from run to run.
///
/// # Errors
/// Those of writing to memory: none are expected.
pub fn csv(studies: &[Study]) -> Result<Vec<u8>, csv::Error> {
    let mut out = csv::Writer::from_writer(Vec::new());
    out.write_record([
        "scene",
        "method",
        "patches",
        "factors",
        "samples",
        "rays_solving",
        "rays_drawing",
        "instructions",
        "rmse",
        "cpu_s",
    ])?;
    for study in studies {
        for row in &study.rows {
            let [patches, factors] = row.solving.map_or_else(Default::default, |solving| {
                let patches = solving.patches.map_or_else(|| "scene".to_owned(), |side| side.to_string());
                [patches, solving.factors.to_string()]
            });
            let [solving, drawing] = row.rays.map(|rays| rays.to_string());
            out.write_record([
                study.title.clone(),
                row.method.name().to_owned(),
                patches,
                factors,
                row.samples.to_string(),
                solving,
                drawing,
                row.instructions.map_or_else(String::new, |count| format!("{count:.0}")),
                format!("{:.9}", row.error),
                format!("{:.5}", row.seconds),
            ])?;
        }
    }
    out.into_inner().map_err(|error| csv::Error::from(error.into_error()))
}

/// Returns the page in Markdown.
#[must_use]
pub fn markdown(studies: &[Study]) -> String {
    let mut page = format!("# Light that goes round\n\n{INTRODUCTION}\n\n{}\n", method());
    for study in studies {
        // Writing to a string does not fail.
        let _ = room(&mut page, study);
    }
    page
}

const INTRODUCTION: &str = "\
In a room most light comes from other surfaces, not straight from a lamp. This page sets the error of six ways to find it against what they
cost, on one diagram for each room, both logarithmic. Down is better, left is cheaper. Where a curve runs level, more work does not help,
because the method leaves something out; what that is, is told below.";

/// Returns what the methods are, and how they are measured.
fn method() -> String {
    let mut text = "## The methods, and what each leaves out\n".to_owned();
    for method in Method::ALL {
        let _ = write!(text, "\n**{}** ({}). {}\n", capital(method.name()), method.source(), method.bias());
    }
    let _ = write!(
        text,
        "\n## How it is measured\n\n\
         Pictures have 1/{STEP} of a scene's columns and rows, in f32; patches are solved in f64, by gathering with the light of lamps first. The error is \
         the RMSE of linear light against a picture of many paths with another seed, over all registers, each cut to white (1). Pixels in which \
         a lamp is seen, or its edge, are left out: what its edge takes is samples, whatever the method. A display shows no more than white, so all methods \
         but paths cut each sample to it before the mean; paths would get darker, and their light is kept. Rays are counted, those of the solution too. Instructions are callgrind's, for a small picture and \
         a small solution, times the rays of the whole over those of this part. CPU seconds are of one run on one thread. The cost of a picture with \
         solved light is that of solution and picture together, though one solution serves every eye. Everything but the seconds is the \
         same in every run of the same build.\n"
    );
    text
}

fn capital(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

fn room(page: &mut String, study: &Study) -> core::fmt::Result {
    let Study { title, size, rows, reference, ambient: [r, g, b], left_out, uncounted, .. } = study;
    writeln!(page, "\n## {title}\n")?;
    writeln!(
        page,
        "{size} pixels, whose mean light is {:.3}. The error of the {} paths a pixel themselves is estimated as {:.1e}. The ambient light \
         that suits best is {r:.4} {g:.4} {b:.4}.\n",
        reference.mean(),
        reference.samples,
        reference.error
    )?;
    if let Some(reason) = uncounted {
        writeln!(page, "No instructions were counted ({reason}); cost is rays.\n")?;
    } else if rows.iter().any(|row| row.instructions.is_none()) {
        writeln!(page, "No instructions were counted; cost is rays.\n")?;
    }
    if !left_out.is_empty() {
        let told: Vec<_> = left_out.iter().map(ToString::to_string).collect();
        writeln!(
            page,
            "No solution with {}: what emits would hold the middle of no patch.\n",
            told.join("; ")
        )?;
    }
    writeln!(page, "![Error against cost of all methods in {title}]({title}-light.svg)\n")?;
    writeln!(page, "![Error against CPU seconds of all methods in {title}]({title}-light-seconds.svg)\n")?;
    writeln!(
        page,
        "The best picture of each method, and below it {BRIGHTER} times what it differs from the paths, coded for a screen with a gamma of \
         {GAMMA}:\n\n\
         ![The room by all methods, and their differences from paths]({title}-light-pictures.png)\n"
    )?;
    writeln!(
        page,
        "The cheapest picture of each method for an error, by instructions or rays (- where none is so good):\n"
    )?;
    writeln!(page, "{}", cheapest(rows))?;
    writeln!(page, "The pictures of each method that none of its others beats, by instructions or rays:\n")?;
    writeln!(page, "{}", fronts(rows))
}

/// Returns a number of rays or of instructions in millions.
fn millions(count: f64) -> String {
    format!("{:.2}", count / 1e6)
}

fn cheapest(rows: &[Row]) -> String {
    let head: Vec<_> = ["error at most"].into_iter().chain(Method::ALL.map(Method::name)).collect();
    let lines = TARGETS.map(|target| {
        let costs = Method::ALL.map(|method| {
            let good = rows.iter().filter(|row| row.method == method && row.error <= target);
            let least = good.map(|row| Axis::Work.cost(row)).min_by(f64::total_cmp);
            least.map_or_else(|| "-".to_owned(), |cost| format!("{} M", millions(cost)))
        });
        [vec![target.to_string()], costs.into()].concat()
    });
    table(&head, &lines, 1)
}

fn fronts(rows: &[Row]) -> String {
    let lines: Vec<_> = Method::ALL
        .into_iter()
        .flat_map(|method| front(rows, Some(method), Axis::Work))
        .map(|row| {
            vec![
                row.method.name().to_owned(),
                row.solving.map_or_else(|| "-".to_owned(), |solving| solving.to_string()),
                row.samples.to_string(),
                millions(row.all_rays()),
                row.instructions.map_or_else(|| "-".to_owned(), millions),
                format!("{:.3}", row.seconds),
                format!("{:.5}", row.error),
            ]
        })
        .collect();
    let head = [
        "method",
        "patches of a quad, factors",
        "samples",
        "M rays",
        "M instructions",
        "CPU seconds",
        "RMSE",
    ];
    table(&head, &lines, 2)
}

/// Returns the best picture of each method beside the converged paths, and below each its difference from them.
///
/// # Errors
/// [`StudyError::Sheet`].
pub fn pictures(study: &Study) -> Result<Displayed, StudyError> {
    let Study { title: name, best, reference, rows, .. } = study;
    let shape = (study.size, study.aspect);
    let mut above = Vec::new();
    let mut below = Vec::new();
    for (method, light) in best {
        let errors = rows.iter().filter(|row| row.method == *method).map(|row| row.error);
        let error = errors.min_by(f64::total_cmp).unwrap_or_default();
        let apart: Vec<_> = light
            .iter()
            .zip(&reference.light)
            .zip(&reference.compared)
            .map(|((light, right), is_compared)| {
                let apart = light.zip(*right, |a, b| BRIGHTER * (a.min(1.0) - b.min(1.0)).abs());
                if *is_compared { apart } else { Rgb::default() }
            })
            .collect();
        above.push(cell(shape, &shown(light), method.name()));
        below.push(cell(shape, &shown(&apart), &format!("{BRIGHTER} x difference, {error:.4}")));
    }
    above.push(cell(shape, &shown(&reference.light), &format!("{} paths a pixel", reference.samples)));
    let (above, below) = (beside(&above), beside(&below));
    displayed(&stacked(&[title(above.width, &format!("{name}: light that goes round")), above, below]))
}

/// Returns light as a screen of today shows it.
fn shown(light: &[Rgb<f32>]) -> Vec<Rgb<u8>> {
    light
        .iter()
        .map(|light| light.map(|register| register.clamp(0.0, 1.0).powf(1.0 / GAMMA)).levels(u8::MAX))
        .collect()
}
