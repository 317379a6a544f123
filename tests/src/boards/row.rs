//! One picture of one board: built, booted, compared, and summed up as a row of the table.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use super::board::{Board, Output};
use super::footprint::Footprint;
use super::machine::{self, Outcome};
use super::picture::Picture;
use super::toolchain::Toolchain;
use super::{Failure, compare, elf, expected};

/// Primitives that the opaque scene does not have, by the names of their modules.
pub const PRIMITIVES: [&str; 2] = ["cylinder", "ellipsoid"];

/// A picture that came out right.
#[derive(Clone, Debug)]
pub struct Row {
    /// The board.
    pub board: Board,
    /// The picture.
    pub picture: Picture,
    /// The hash of the picture as boards without a screen stream it: of 160 x 100 pixels, or of its own raster where the board reports none; of a DOS program the picture that it shows.
    pub hash: u64,
    /// Bytes of stack, if reported.
    pub stack: Option<u64>,
    /// Those of [`PRIMITIVES`] that are part of the name of one of the program's functions.
    pub primitives: Vec<&'static str>,
    /// The files of the illumination models and of air that the program's code is from, below the core's folder `illumination`; none for
    /// WebAssembly, which is no ELF file.
    pub sources: BTreeSet<String>,
    /// Instructions from the beginning to the last pixel, if reported.
    pub instructions: Option<u64>,
    /// Memory and instructions of the image, where the board reports stack and instructions.
    pub footprint: Option<Footprint>,
}

impl Row {
    /// Builds, boots and compares one picture; writes the files that the board wrote into a folder of `keep`, if there
    /// is one.
    ///
    /// # Errors
    /// The compiler's and the emulator's, and whatever is not as it must be.
    pub fn draw(
        board: Board,
        toolchain: Toolchain,
        picture: Picture,
        keep: Option<&Path>,
    ) -> Result<Self, Failure> {
        let room = tempfile::tempdir()?;
        let image = room.path().join("image");
        fs::copy(toolchain.build(&board, &picture)?, &image)?;
        let outcome = machine::run(&board, &image, picture.scene, room.path())?;
        if let Some(keep) = keep {
            let folder = keep.join(picture.title(&board).replace(' ', "-"));
            fs::create_dir_all(&folder)?;
            for file in fs::read_dir(room.path())?.flatten().filter(|file| file.path().is_file()) {
                fs::copy(file.path(), folder.join(file.file_name()))?;
            }
        }
        let want = expected::shown(&picture, board.output)?;
        compare::picture(&outcome.drawn, &want)?;
        if let Some(dump) = &outcome.screendump {
            match board.output {
                Output::Screen { screen, zoom, .. } => {
                    compare::screen(dump, &want, picture.size, screen, zoom as usize)?;
                }
                Output::Panel { size: (width, height), zoom } => {
                    let screen = (width, height, u8::MAX);
                    compare::screen(dump, &want, picture.size, screen, zoom as usize)?;
                }
                Output::Semihosting | Output::Module | Output::File { .. } => {}
            }
        }
        let hash = match outcome.hash {
            Some(_) => expected::streamed(&picture, (160, 100))?.hash((160, 100))?,
            None => want.hash(picture.size)?,
        };
        // A file has the whole colour table; its pixels and the entries that they use are those of the picture.
        if !matches!(board.output, Output::File { .. }) {
            let own = outcome.hash.map_or_else(|| outcome.drawn.hash(picture.size), Ok)?;
            if own != hash {
                return Err(format!("its hash is {own:016x}, not {hash:016x}").into());
            }
        }
        let image = fs::read(&image)?;
        let footprint = footprint_of(&board, &picture, &outcome, &image)?;
        let mut primitives = Vec::new();
        if footprint.is_some() {
            for name in PRIMITIVES {
                if elf::mentions(&image, name)? {
                    primitives.push(name);
                }
            }
        }
        let sources = if board.output == Output::Module {
            BTreeSet::new()
        } else {
            elf::sources(&image, "illumination/")?
        };
        let Outcome { stack, instructions, .. } = outcome;
        Ok(Self { board, picture, hash, stack, primitives, sources, instructions, footprint })
    }
}

fn footprint_of(
    board: &Board,
    picture: &Picture,
    outcome: &Outcome,
    image: &[u8],
) -> Result<Option<Footprint>, Failure> {
    let (Some(stack), Some(before), Some(instructions)) =
        (outcome.stack, outcome.before, outcome.instructions)
    else {
        return Ok(None);
    };
    let elf::Sizes { text, rodata, ram } = elf::sizes(image)?;
    let (width, height) = picture.size;
    let instructions = (instructions - before) / (u64::from(width) * u64::from(height));
    let key = [board.name, picture.scene, &picture.format.to_string(), picture.needs()].map(str::to_owned);
    Ok(Some(Footprint { key, text, rodata, ram, stack, before, instructions }))
}
