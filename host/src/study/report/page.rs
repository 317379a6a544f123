//! The study as a page to read.

use core::fmt::Write;

use super::diagram::{cost, front};
use super::instructions;
use super::study::{DEVICES, REPEATS, Row, Study, TIME_STEP, TRUTH_STEP};
use crate::picture::raster::Size;
use rta_core::sampling::Places;

/// Errors for which the cheapest setting is named: one level of guns with 3 to 10 bits.
const TARGETS: [u32; 7] = [7, 15, 31, 63, 127, 255, 1023];

/// Returns the page in Markdown. `aspect` is the width of the screen over its height.
#[must_use]
pub fn markdown(studies: &[Study], size: Size, aspect: f64) -> String {
    let mut page = String::from("# Error against run time\n");
    // Writing to a string does not fail.
    let _ = write!(page, "\n{}\n\n{}\n", INTRODUCTION, machine());
    for study in studies {
        let _ = scene(&mut page, study);
    }
    let _ = write!(page, "\n## How it was measured\n\n{}", method(size, aspect));
    page
}

const INTRODUCTION: &str = "\
Each diagram sets the error of a picture against what it costs, both logarithmic. A curve is a method: a number format
with a number of samples a pixel. A point on it is a setting: a recursion depth (0 to 8) and a contribution cut-off. Down
is better, left is cheaper: whatever has another point below it and to its left is not worth using. What is left is
the Pareto front, drawn in black; choose from it. Where a curve runs level, what it varies does not matter any more and
another error is the largest: with one sample a pixel that is nearly always sampling.

Instructions are those of the machine below, which has floating point in hardware. Fixed point is for machines that have
not: there every float operation is tens or hundreds of instructions, and the curve of f32 lies far to the right.";

fn machine() -> String {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let processor = std::fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| {
        let line = text.lines().find(|line| line.starts_with("model name"))?;
        line.split_once(':').map(|(_, name)| name.trim().to_owned())
    });
    let processor = processor.unwrap_or_else(|| "unknown processor".to_owned());
    let build =
        if cfg!(debug_assertions) { "a debug build, whose costs mean nothing" } else { "a release build" };
    let (arch, system, version) = (std::env::consts::ARCH, std::env::consts::OS, env!("CARGO_PKG_VERSION"));
    format!("Machine: {processor}, {cores} cores, {arch}, {system}; rta {version}, {build}.")
}

fn scene(page: &mut String, study: &Study) -> core::fmt::Result {
    let Study { title, size: (objects, lamps), rows, uncounted } = study;
    writeln!(page, "\n## {title}\n")?;
    writeln!(page, "{objects} objects, {lamps} lamp{}.\n", if *lamps == 1 { "" } else { "s" })?;
    writeln!(page, "![Error against run time of {title}]({title}.svg)\n")?;
    if let Some(reason) = uncounted {
        writeln!(page, "No instructions were counted ({reason}); cost is rays.\n")?;
    } else if rows.iter().any(|row| row.instructions.is_none()) {
        writeln!(page, "No instructions were counted; cost is rays.\n")?;
    }
    writeln!(page, "The cheapest setting for each error (RMSE, all errors together but the display's):\n")?;
    cheapest(page, rows, |row| row.total.rmse)?;
    writeln!(
        page,
        "\nThe cheapest with one sample a pixel, for the errors of tracing alone (rounding, depth and cut-off, against \
         f64 with depth 32 and one sample too):\n"
    )?;
    let single: Vec<_> = rows.iter().filter(|row| row.method.sampling.samples() == 1).cloned().collect();
    cheapest(page, &single, |row| row.tracing.rmse)?;
    writeln!(
        page,
        "\nThe Pareto front, without points whose error is less than 1 % below that of the one before:\n"
    )?;
    writeln!(page, "{HEAD} RMSE | worst | PSNR | within 1/255 |\n{RULE} --- | --- | --- | --- |")?;
    for row in front(rows).into_iter().filter_map(|at| rows.get(at)) {
        let total = row.total;
        let share = 100.0 * total.within;
        let (setting, psnr) = (setting(row), total.psnr());
        writeln!(page, "{setting} {:.5} | {:.3} | {psnr:.1} dB | {share:.2} % |", total.rmse, total.worst)?;
    }
    writeln!(page, "\nThe errors apart, without a cut-off, at depth 5:\n")?;
    apart(page, rows)
}

const HEAD: &str = "| format | samples | depth | cut-off | instructions | rays | CPU seconds |";
const RULE: &str = "| --- | --- | --- | --- | --- | --- | --- |";

/// Returns the cells that name a setting and its costs.
fn setting(row: &Row) -> String {
    let (method, limit) = (row.method, row.limit);
    let jittered = if method.sampling.is_jittered() { " jittered" } else { "" };
    let instructions = row.instructions.map_or_else(|| "-".to_owned(), millions);
    let rays = millions(row.all_rays());
    format!(
        "| {} | {}{jittered} | {} | {} | {instructions} | {rays} | {:.3} |",
        method.format,
        method.sampling.samples(),
        limit.depth,
        if limit.cutoff == crate::engine::Cutoff::OFF { "none".to_owned() } else { limit.cutoff.to_string() },
        row.seconds
    )
}

#[allow(clippy::cast_precision_loss)] // three digits are shown
fn millions(count: u64) -> String {
    format!("{:.2} M", count as f64 / 1e6)
}

/// Writes for each target the cheapest of `rows` whose error is at most that.
fn cheapest(page: &mut String, rows: &[Row], error: impl Fn(&Row) -> f64) -> core::fmt::Result {
    writeln!(page, "| error at most {HEAD} error |\n| --- {RULE} --- |")?;
    for target in TARGETS {
        let good = rows.iter().filter(|row| error(row) <= 1.0 / f64::from(target));
        match good.min_by(|a, b| cost(a).total_cmp(&cost(b))) {
            Some(row) => writeln!(page, "| 1/{target} {} {:.5} |", setting(row), error(row))?,
            None => writeln!(page, "| 1/{target} | none of the settings | | | | | | | |")?,
        }
    }
    Ok(())
}

/// Writes the errors of each method at depth 5.
fn apart(page: &mut String, rows: &[Row]) -> core::fmt::Result {
    write!(page, "| format | samples | rounding | beyond 1/255 | truncation | sampling | total |")?;
    for device in DEVICES {
        write!(page, " {device}, levels |")?;
    }
    writeln!(page, "\n{}", "| --- ".repeat(7 + DEVICES.len()) + "|")?;
    let whole = |row: &&Row| row.limit.depth == 5 && row.limit.cutoff == crate::engine::Cutoff::OFF;
    for row in rows.iter().filter(whole) {
        let jittered = if row.method.sampling.is_jittered() { " jittered" } else { "" };
        write!(
            page,
            "| {} | {}{jittered} | {:.2e} | {:.3} % | {:.2e} | {:.2e} | {:.2e} |",
            row.method.format,
            row.method.sampling.samples(),
            row.rounding.rmse,
            100.0 * (1.0 - row.rounding.within),
            row.truncation.rmse,
            row.sampling.rmse,
            row.total.rmse
        )?;
        for display in row.display {
            write!(page, " {:.2} |", display.rmse)?;
        }
        writeln!(page)?;
    }
    Ok(())
}

fn method(size: Size, aspect: f64) -> String {
    let count = instructions::STEP;
    format!(
        "\
Pictures of {size} pixels on a screen of {aspect:.3} : 1, with the thesis's model. Every register is cut to 0 to 1, in
each sample before the samples are averaged: a display shows no more, and one glint would outweigh all else.

| error | of | against | on |
| --- | --- | --- | --- |
| rounding | the format | f64 with the same depth, cut-off and samples | all pixels |
| truncation | f64 with this depth and cut-off | f64 with depth 32 and no cut-off, the same samples | all pixels |
| sampling | f64 with depth 32 and these samples | f64 with depth 32 and 1024 regular samples | every {TRUTH_STEP}nd pixel of every {TRUTH_STEP}nd row |
| tracing | the format with this depth and cut-off | f64 with depth 32 and no cut-off, the same samples | all pixels |
| total | the format with all settings | f64 with depth 32 and 1024 regular samples | every {TRUTH_STEP}nd pixel of every {TRUTH_STEP}nd row |
| display | what a device shows, with its own colour table and dithering | the picture before | all pixels, in levels of the device's guns |

RMSE is over all registers of all pixels; PSNR is for a peak of 1; `within` is the share of pixels that are within one
level of 1/255 (of the device's own for the display) in every register. The pictures of all depths and cut-offs come from
one walk of each ray tree, and are those that tracing with that depth and cut-off gives, to the last bit.

Rays are counted, on all pixels. Instructions are callgrind's, without starting up and without displays, on every
{count}th pixel of every {count}th row, for 1 and 4 samples a pixel, times the rays of the whole picture over those of
this part; 9 and 16 samples take what as many rays of 4 samples take. CPU seconds are the median of {REPEATS} runs of
one thread on every {TIME_STEP}th pixel of every {TIME_STEP}th row, scaled up in the same way. Everything but the
seconds is the same in every run of the same build.
"
    )
}
