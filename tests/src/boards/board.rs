//! The boards, and the pictures that each of them draws.

use std::path::PathBuf;

use rta::engine::Format;

/// A board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Board {
    /// What it is called on the command line and in tables.
    pub name: &'static str,
    /// Its processor.
    pub processor: &'static str,
    /// Its package.
    pub package: &'static str,
    /// The feature of the package that chooses it.
    pub feature: Option<&'static str>,
    /// The target; a file of the package where the compiler has none of that name.
    pub target: &'static str,
    /// The linker where the compiler's own is missing.
    pub linker: &'static str,
    /// The emulator's program.
    pub emulator: &'static str,
    /// What the emulator is told, but for the image.
    pub arguments: &'static [&'static str],
    /// How the picture comes out.
    pub output: Output,
}

/// How a board's picture comes out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Output {
    /// Two files that it writes by semihosting; its reports are on the console.
    Semihosting,
    /// Two files that the module's host writes.
    Module,
    /// A screen, of which a screendump is taken, and which is read back over a serial line.
    Screen {
        /// How the image is handed over.
        image: Image,
        /// Width, height and highest level of the screen.
        screen: (u32, u32, u8),
        /// Pixels of the screendump for each of the screen's.
        zoom: u32,
    },
}

/// What an emulator takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Image {
    /// The ELF file itself.
    Kernel,
    /// A floppy disk of 1.44 MB.
    Floppy,
    /// A boot PROM.
    Prom,
}

const CORTEX_M: &[&str] = &[
    "-nographic",
    "-monitor",
    "none",
    "-serial",
    "none",
    "-semihosting-config",
    "enable=on,target=native",
    "-icount",
    "shift=0,sleep=off",
];

const PC: &[&str] = &[
    "-cpu",
    "486",
    "-m",
    "8",
    "-vga",
    "std",
    "-display",
    "none",
    "-device",
    "isa-debug-exit,iobase=0xf4,iosize=0x04",
];

/// A board of ARM's M profile.
const fn cortex_m(name: &'static str, processor: &'static str, target: &'static str) -> Board {
    Board {
        name,
        processor,
        package: "cortex-m",
        feature: Some(name),
        target,
        linker: "ld.lld",
        emulator: "qemu-system-arm",
        arguments: CORTEX_M,
        output: Output::Semihosting,
    }
}

/// A PC with a VGA.
const fn pc(name: &'static str, feature: &'static str, image: Image) -> Board {
    Board {
        name,
        processor: "i486",
        package: "pc",
        feature: Some(feature),
        target: "i486-none",
        linker: "ld.lld",
        emulator: "qemu-system-i386",
        arguments: PC,
        output: Output::Screen { image, screen: (320, 200, 63), zoom: 2 },
    }
}

/// All boards.
pub const ALL: [Board; 8] = [
    cortex_m("microbit", "Cortex-M0", "thumbv6m-none-eabi"),
    cortex_m("lm3s6965evb", "Cortex-M3", "thumbv7m-none-eabi"),
    cortex_m("mps2-an386", "Cortex-M4F", "thumbv7em-none-eabihf"),
    Board {
        name: "riscv",
        processor: "RV32IMC",
        package: "riscv",
        feature: None,
        target: "riscv32imc-unknown-none-elf",
        linker: "ld.lld",
        emulator: "qemu-system-riscv32",
        arguments: &[
            "-M",
            "virt",
            "-bios",
            "none",
            "-display",
            "none",
            "-monitor",
            "none",
            "-serial",
            "stdio",
            "-semihosting-config",
            "enable=on,target=native",
            "-icount",
            "shift=0,sleep=off",
        ],
        output: Output::Semihosting,
    },
    pc("pc", "multiboot", Image::Kernel),
    pc("pc-floppy", "floppy", Image::Floppy),
    Board {
        name: "sparc",
        processor: "SPARC v8",
        package: "sparc",
        feature: None,
        target: "sparc-unknown-none-elf",
        linker: "sparc64-linux-gnu-ld",
        emulator: "qemu-system-sparc",
        arguments: &["-M", "SS-5", "-vga", "cg3", "-g", "1152x900x8", "-m", "32", "-display", "none"],
        output: Output::Screen { image: Image::Prom, screen: (1152, 900, 255), zoom: 1 },
    },
    Board {
        name: "wasm",
        processor: "WebAssembly",
        package: "wasm",
        feature: None,
        target: "wasm32-unknown-unknown",
        linker: "wasm-ld",
        emulator: "node",
        arguments: &[],
        output: Output::Module,
    },
];

/// What one image draws.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// The scene's name.
    pub scene: &'static str,
    /// The scene file.
    pub file: PathBuf,
    /// The number format.
    pub format: Format,
    /// Whether the program is for this scene alone, or for any.
    pub baked: bool,
    /// Width and height in pixels.
    pub size: (u32, u32),
}

impl Picture {
    /// Whether the picture is drawn where time is short.
    #[must_use]
    pub fn is_brief(&self, board: &Board) -> bool {
        let any_scene = matches!(
            (board.name, self.scene, self.format),
            ("microbit", "opaque", Format::Q16) | ("mps2-an386", "opaque", Format::F32)
        );
        // Every scene on two boards, and the one that another has; elsewhere the least and the most that there is.
        let this_scene = match self.format {
            Format::Q16 if matches!(board.name, "microbit" | "riscv" | "pc-floppy") => true,
            Format::Q16 => matches!(self.scene, "opaque" | "glass-2"),
            _ => self.scene == "juggler",
        };
        if self.baked { this_scene } else { any_scene }
    }

    /// What the program can draw, in words.
    #[must_use]
    pub fn needs(&self) -> &'static str {
        if self.baked { "baked" } else { "Everything" }
    }

    /// What the picture is called.
    #[must_use]
    pub fn title(&self, board: &Board) -> String {
        format!("{} {} {} {}", board.name, self.scene, self.format, self.needs())
    }
}

/// The raster of pictures that are streamed.
const STREAMED: (u32, u32) = (160, 100);

/// The scenes that are drawn: name and file, from the folder of the boards.
const SCENES: [(&str, &str); 4] = [
    ("opaque", "scenes/opaque.dat"),
    ("juggler", "../../scenes/juggler.dat"),
    ("glass-2", "../../scenes/glass-2.dat"),
    ("hall-22", "../../scenes/hall-22.dat"),
];

/// Number of target folders, in each of which one image at a time is built.
pub const TARGET_FOLDERS: usize = 2;

impl Board {
    /// The target folder that its images are built in: always the same for a target, whose `core` is built once only, and
    /// about half of the work for each.
    #[must_use]
    pub fn target_folder(&self) -> usize {
        usize::from(matches!(self.name, "mps2-an386" | "riscv" | "sparc" | "wasm"))
    }

    /// The pictures that the board draws.
    #[must_use]
    pub fn pictures(&self) -> Vec<Picture> {
        let mut pictures = Vec::new();
        for (scene, file) in SCENES {
            for format in [Format::Q16, Format::F32] {
                // Size and instructions are told for boards with flash; the PC's second image is there to be booted.
                let everything = self.output == Output::Semihosting;
                if self.name == "pc-floppy" && (scene != "juggler" || format != Format::Q16) {
                    continue;
                }
                let size = match self.output {
                    Output::Screen { screen: (width, height, _), .. }
                        if (self.name == "sparc" && scene == "glass-2" && format == Format::Q16)
                            || self.package == "pc" =>
                    {
                        (width, height)
                    }
                    Output::Screen { .. } => (320, 200),
                    Output::Semihosting | Output::Module => STREAMED,
                };
                for baked in [true, false] {
                    if baked || everything {
                        let file = super::folder().join(file);
                        pictures.push(Picture { scene, file, format, baked, size });
                    }
                }
            }
        }
        pictures
    }
}
