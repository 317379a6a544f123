//! The report of all pictures: the table, and what is wrong with programs whose pictures are right.

use rta::engine::Format;
use rta::study::figures::thesis::counted::{self, Counted};

use super::board::Board;
use super::footprint::Footprint;
use super::picture::{Colors, Picture};
use super::row::{PRIMITIVES, Row};

/// Returns, in words, which programs for the opaque scene alone have functions in them that it does not need.
#[must_use]
pub fn superfluous(rows: &[Row]) -> Vec<String> {
    let of = |board: &Board, format, baked| {
        rows.iter().find(|row| {
            let Picture { scene, format: this, baked: own, colors, .. } = row.picture;
            let is_standard = colors == Colors::Standard;
            row.board == *board && is_standard && (scene, this, own) == ("opaque", format, baked)
        })
    };
    let mut found = Vec::new();
    for baked in rows.iter().filter(|row| row.picture.scene == "opaque" && row.picture.baked) {
        let name = baked.picture.title(&baked.board);
        if !baked.primitives.is_empty() {
            found.push(format!("{name}: it has functions of {}", baked.primitives.join(", ")));
        }
        let Some(everything) = of(&baked.board, baked.picture.format, false) else { continue };
        if baked.picture.format == Format::Q16 && everything.primitives != PRIMITIVES {
            found.push(format!("{name}: names of functions tell nothing, as Everything's do not"));
        }
        if let (Some(few), Some(all)) = (&baked.footprint, &everything.footprint)
            && few.text * 100 > all.text * 65
        {
            found.push(format!("{name}: {} bytes of code, of {} with Everything", few.text, all.text));
        }
    }
    found
}

/// Returns, in words, how footprints differ from those on the page; nothing where another compiler made those.
#[must_use]
pub fn drift(now: &[Footprint], (compiler, then): &(String, Vec<Footprint>), version: &str) -> Vec<String> {
    if compiler != version {
        println!("footprints were recorded with {compiler}: not compared with {version}");
        return Vec::new();
    }
    let recorded = |row: &Footprint| then.iter().find(|then| then.key == row.key);
    now.iter()
        .flat_map(|row| match recorded(row) {
            Some(then) => row.drift(then),
            None => vec![format!("{}: not in FOOTPRINT.md", row.key.join(" "))],
        })
        .collect()
}

/// Returns, in words, which pictures take instructions that differ from those on the thesis's page by more than a twentieth; nothing where
/// another compiler made the images.
#[must_use]
pub fn miscounted(rows: &[Row], version: &str) -> Vec<String> {
    let mut wrong = Vec::new();
    for recorded in counted::ALL.iter().filter(|_| version == counted::COMPILER) {
        let Counted { board, scene, format, size, instructions: then } = *recorded;
        let own = rows.iter().find(|row| {
            let Picture { baked, buffered, antialiased, colors, model, .. } = row.picture;
            let is_plain =
                baked && !buffered && antialiased.is_none() && colors == Colors::Standard && model.is_none();
            let picture = (row.board.name, row.picture.scene, row.picture.format, row.picture.size);
            is_plain && picture == (board, scene, format, size)
        });
        // Not all pictures are drawn each time.
        let Some(Row { instructions, .. }) = own else { continue };
        if instructions.is_none_or(|now| now.abs_diff(then) * 20 > then) {
            wrong.push(format!("{board} {scene} {format}: instructions {then} -> {instructions:?}"));
        }
    }
    wrong
}

/// Prints a line for each picture.
pub fn print_table(rows: &[Row]) {
    println!(
        "\n{:16} {:12} {:8} {:4} {:14} {:>9} {:>6} {:>6} {:>8} {:>12}  hash",
        "board", "processor", "scene", "", "needs", "raster", "stack", ".text", "a pixel", "instructions"
    );
    for Row { board, picture, hash, stack, footprint, instructions, .. } in rows {
        let (width, height) = picture.size;
        let word = |figure: Option<u64>| figure.map_or_else(String::new, |figure| figure.to_string());
        println!(
            "{:16} {:12} {:8} {:4} {:14} {:>9} {:>6} {:>6} {:>8} {:>12}  {hash:016x}",
            board.name,
            board.processor,
            picture.scene,
            picture.format.to_string(),
            picture.needs(),
            format!("{width}x{height}"),
            word(*stack),
            word(footprint.as_ref().map(|row| row.text)),
            word(footprint.as_ref().map(|row| row.instructions)),
            word(*instructions),
        );
    }
    println!();
}
