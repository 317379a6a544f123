//! The footprint table: memory and instructions of each image, as the boards reported them, compared with those
//! recorded.

use core::fmt::Write;

use super::Failure;

/// Memory and instructions that an image takes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Footprint {
    /// Board, scene, number format and needs.
    pub key: [String; 4],
    /// Bytes of code.
    pub text: u64,
    /// Bytes of constants.
    pub rodata: u64,
    /// Bytes of static RAM.
    pub ram: u64,
    /// Bytes of stack, from reset on.
    pub stack: u64,
    /// Instructions before the first row, in which the palette is made if there is one.
    pub before: u64,
    /// Instructions a pixel, without those.
    pub instructions: u64,
}

/// Share by which a figure may change before that is a failure: a twentieth.
const DRIFT: u64 = 20;

const HEAD: &str = "\
# Footprints

What each board's image takes, with `Everything` (a program for any scene that it is given) and with the needs of the one
baked scene. Written by `cargo run --release -p rta-tests --bin boards -- --write`; continuous integration fails where
a figure drifts by more than 5 %.

- `.text`, `.rodata`, RAM: bytes of code, constants (the scene and a colour table of 771 bytes among them) and static variables of
  the whole image; built with opt-level s. Of the code, start-up, the stream to the host and the reports take about 840 bytes on the
  Cortex-M0, 770 on the M3, 800 on the M4F and 830 on RISC-V: what an image has that only writes constant rows.
- Stack: bytes from reset to the end of the picture, at depth 5.
- Needs: `sampled` is the baked scene with a palette made from 1024 samples of the picture (3 KiB, and 2 KiB of boxes, all on the stack until the
  palette stands; the palette itself is 840 bytes); `dithered`, that with error diffusion (4 bytes for each of the 160 columns); all other rows
  are drawn in the uniform table, which lies in flash. On `lm3s6965evb-oled` there is no table: 128 x 64 pixels of 16 greys, with error
  diffusion in one gun (2 bytes for each of the 128 columns, on the stack).
- Needs `Z-buffer`: the baked scene, whose rays from the eye are found by a Z-buffer of one row.
- Needs `aa whitted` and `aa mitchell`: the baked scene, with adaptive antialiasing; its rows, packed to 3 bytes a pixel, and a row of pixels are on
  the stack.
- Before: instructions before the first row, where the palette is made: 1000 rays, and the cuts.
- Instructions: retired a pixel, with all that is done from there to the last of the picture. They are instructions, not
  cycles: the emulator models no pipeline and no wait states of a flash memory.
";

const COLUMNS: &str = "| board | scene | format | needs | .text | .rodata | RAM | stack | before | instructions a pixel |\n\
                       | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";

/// Returns the page as text, with the `version` of the compiler that built the images.
#[must_use]
pub fn page(rows: &[Footprint], version: &str) -> String {
    let mut page = format!("{HEAD}\nCompiler: {version}\n\n{COLUMNS}");
    for Footprint { key: [board, scene, format, needs], text, rodata, ram, stack, before, instructions } in
        rows
    {
        // A String takes all that is written to it.
        let _ = writeln!(
            page,
            "| {board} | {scene} | {format} | {needs} | {text} | {rodata} | {ram} | {stack} | {before} | {instructions} |"
        );
    }
    page
}

/// Reads a page: returns the version of the compiler and the rows.
///
/// # Errors
/// The text is no such page.
pub fn parse(page: &str) -> Result<(String, Vec<Footprint>), Failure> {
    let version =
        page.lines().find_map(|line| line.strip_prefix("Compiler: ")).ok_or("it names no compiler")?;
    let mut rows = Vec::new();
    for line in page.lines().skip_while(|line| !line.starts_with("| ---")).skip(1) {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        let [board, scene, format, needs, numbers @ ..] = cells.as_slice() else {
            return Err(format!("{line}: too few columns").into());
        };
        let numbers: Result<Vec<u64>, _> = numbers.iter().map(|number| number.parse()).collect();
        let [text, rodata, ram, stack, before, instructions] =
            numbers?.try_into().map_err(|_| format!("{line}: not six numbers"))?;
        let key = [board, scene, format, needs].map(|&word| word.to_owned());
        rows.push(Footprint { key, text, rodata, ram, stack, before, instructions });
    }
    Ok((version.to_owned(), rows))
}

impl Footprint {
    fn figures(&self) -> [(&'static str, u64); 6] {
        [
            (".text", self.text),
            (".rodata", self.rodata),
            ("RAM", self.ram),
            ("stack", self.stack),
            ("instructions before the first row", self.before),
            ("instructions", self.instructions),
        ]
    }

    /// Returns, in words, the figures that differ from `recorded` by more than a twentieth.
    #[must_use]
    pub fn drift(&self, recorded: &Self) -> Vec<String> {
        let pairs = self.figures().into_iter().zip(recorded.figures());
        let drifted = pairs.filter(|((_, now), (_, then))| now.abs_diff(*then) * DRIFT > *then);
        drifted
            .map(|((name, now), (_, then))| format!("{}: {name} {then} -> {now}", self.key.join(" ")))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::{Footprint, page, parse};

    fn row(text: u64) -> Footprint {
        let key = ["microbit", "opaque", "q16", "baked"].map(str::to_owned);
        Footprint { key, text, rodata: 1500, ram: 0, stack: 700, before: 90, instructions: 9000 }
    }

    #[test]
    fn a_page_says_what_it_was_made_of() {
        let rows = [row(7000), row(7001)];
        let (version, parsed) = parse(&page(&rows, "rustc 1.96.0")).expect("a page");
        assert_eq!((version.as_str(), parsed.as_slice()), ("rustc 1.96.0", &rows[..]));
    }

    #[test]
    fn drift_is_more_than_a_twentieth_either_way() {
        assert!(row(7350).drift(&row(7000)).is_empty());
        assert_eq!(row(7351).drift(&row(7000)), ["microbit opaque q16 baked: .text 7000 -> 7351"]);
        assert_eq!(row(6649).drift(&row(7000)).len(), 1);
    }
}
