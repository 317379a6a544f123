//! Instructions of the emulated machines that stand for the thesis's, and what they would take at the clocks of the time.
//!
//! The boards of `tests/boards` count them as they draw (`cargo run --release -p rta-tests --bin boards -- pc sparc`, column "instructions"):
//! by their own timers, under an emulator whose clock goes on by a nanosecond for each instruction. That run fails where a count differs
//! from the one here by more than a twentieth.

use crate::engine::Format;

/// The compiler that built the images.
pub const COMPILER: &str = "rustc 1.96.0";

/// A processor of the time.
#[derive(Clone, Copy, Debug)]
pub struct Processor {
    /// The board, by its name in `tests/boards`.
    pub board: &'static str,
    /// What the board is.
    pub name: &'static str,
    /// What it stands for, and where clock and cycles are from.
    pub words: &'static str,
    /// Millions of cycles a second.
    pub megahertz: f64,
    /// Cycles that an instruction takes in the mean.
    pub cycles: f64,
}

/// The processors that boards have.
pub const PROCESSORS: [Processor; 2] = [
    Processor {
        board: "pc",
        name: "PC, i486, VGA",
        words: "i486 at 25 MHz, its first clock (Intel, 1989); 2 cycles an instruction are assumed. No PS/2 of the thesis has \
                one: it is the oldest Intel processor that runs the program as it is",
        megahertz: 25.0,
        cycles: 2.0,
    },
    Processor {
        board: "sparc",
        name: "SPARCstation 5, cgthree",
        words: "SPARCstation 1, 20 MHz and 12.5 million instructions a second (Sun, 1989), which is 1.6 cycles an instruction. It is \
                a SPARC version 7; the program is for version 8, whose multiplication is one instruction",
        megahertz: 20.0,
        cycles: 1.6,
    },
];

impl Processor {
    /// Returns the seconds that so many instructions would take.
    #[must_use]
    pub fn seconds(&self, instructions: u64) -> f64 {
        instructions as f64 * self.cycles / (self.megahertz * 1e6)
    }
}

/// A picture of a board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Counted {
    /// The board, by its name.
    pub board: &'static str,
    /// The scene, without its file's extension.
    pub scene: &'static str,
    /// Number format. The i486's program works f32 out by integers, without a coprocessor; the SPARC has one.
    pub format: Format,
    /// Width and height in pixels.
    pub size: (u32, u32),
    /// Instructions from the beginning to the last pixel.
    pub instructions: u64,
}

/// One of [`ALL`].
const fn counted(
    board: &'static str,
    scene: &'static str,
    format: Format,
    size: (u32, u32),
    instructions: u64,
) -> Counted {
    Counted { board, scene, format, size, instructions }
}

/// All that are recorded.
pub const ALL: &[Counted] = &[
    counted("pc", "glass-2", Format::F32, (320, 200), 4_175_721_709),
    counted("pc", "glass-2", Format::Q16, (320, 200), 547_103_101),
    counted("pc", "hall-22", Format::F32, (320, 200), 7_550_792_958),
    counted("pc", "hall-22", Format::Q16, (320, 200), 833_577_535),
    counted("sparc", "glass-2", Format::F32, (1152, 900), 5_460_391_500),
    counted("sparc", "glass-2", Format::Q16, (1152, 900), 11_763_442_500),
    counted("sparc", "hall-22", Format::F32, (320, 200), 619_809_500),
    counted("sparc", "hall-22", Format::Q16, (320, 200), 996_119_500),
];
