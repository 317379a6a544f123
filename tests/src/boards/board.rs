//! The boards, and the pictures that each of them draws.

use std::path::PathBuf;

use rta::engine::Format;

/// A board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Board {
    /// Name on the command line and in tables.
    pub name: &'static str,
    /// Processor, for tables.
    pub processor: &'static str,
    /// Package in `tests/boards`.
    pub package: &'static str,
    /// The feature of the package that chooses it.
    pub feature: Option<&'static str>,
    /// Target of the compiler: a built-in name, or a target file of the package.
    pub target: &'static str,
    /// Linker to use where the compiler does not bring its own.
    pub linker: &'static str,
    /// Program name of the emulator.
    pub emulator: &'static str,
    /// Arguments of the emulator, without those that name the image.
    pub arguments: &'static [&'static str],
    /// How the picture leaves the board.
    pub output: Output,
}

/// How the picture leaves a board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Output {
    /// In two files that the program writes by semihosting; its reports are on the console.
    Semihosting,
    /// In two files that the WebAssembly module's host writes.
    Module,
    /// On a screen: the emulator takes a screendump, and the program sends the frame buffer over a serial line.
    Screen {
        /// Form in which the emulator takes the image.
        image: Image,
        /// Width, height and highest level of the screen.
        screen: (u32, u32, u8),
        /// Pixels of the screendump for each pixel of the screen, along each axis.
        zoom: u32,
    },
}

/// Form in which an emulator takes an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Image {
    /// The ELF file itself.
    Kernel,
    /// A floppy disk of 1.44 MB.
    Floppy,
    /// The contents of a boot PROM.
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

/// How the colours of a picture are chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colors {
    /// By the uniform table where the picture is streamed, by the tolerant one on a screen.
    Standard,
    /// By a palette made from samples of the picture.
    Sampled,
    /// By such a palette, with error diffusion.
    Dithered,
}

impl Colors {
    /// Returns its name, as images are told it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Standard => "standard",
            Self::Sampled => "sampled",
            Self::Dithered => "dithered",
        }
    }
}

/// A picture that one image draws.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// The scene's name.
    pub scene: &'static str,
    /// The scene file.
    pub file: PathBuf,
    /// The number format.
    pub format: Format,
    /// Whether the program holds only what this scene needs, or all that any scene may need.
    pub baked: bool,
    /// How its colours are chosen.
    pub colors: Colors,
    /// Width and height in pixels.
    pub size: (u32, u32),
}

impl Picture {
    /// Whether the picture is among those that `--brief` draws.
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
        // Error diffusion contains all that a palette takes.
        let palette = matches!(
            (board.name, self.scene, self.format),
            ("microbit", "opaque", Format::Q16) | ("mps2-an386", "juggler", Format::F32)
        );
        match self.colors {
            Colors::Standard => {
                if self.baked {
                    this_scene
                } else {
                    any_scene
                }
            }
            Colors::Sampled => palette,
            Colors::Dithered => palette || self.scene == "opaque" && self.format == Format::Q16,
        }
    }

    /// Returns what the program can draw, in words: the column "needs" of the footprint table.
    #[must_use]
    pub fn needs(&self) -> &'static str {
        match self.colors {
            Colors::Standard if self.baked => "baked",
            Colors::Standard => "Everything",
            // Baked too.
            colors => colors.name(),
        }
    }

    /// Returns the name of the picture in messages and files.
    #[must_use]
    pub fn title(&self, board: &Board) -> String {
        format!("{} {} {} {}", board.name, self.scene, self.format, self.needs())
    }
}

/// The raster of pictures that are streamed.
const STREAMED: (u32, u32) = (160, 100);

/// The scenes that are drawn: name, and file relative to the folder of the boards.
const SCENES: [(&str, &str); 4] = [
    ("opaque", "scenes/opaque.dat"),
    ("juggler", "../../scenes/juggler.dat"),
    ("glass-2", "../../scenes/glass-2.dat"),
    ("hall-22", "../../scenes/hall-22.dat"),
];

/// Number of target folders, in each of which one image at a time is built.
pub const TARGET_FOLDERS: usize = 2;

impl Board {
    /// Returns the number of the target folder, below [`TARGET_FOLDERS`], that the board's images are built in. Each
    /// target has one folder, so that its `core` is built once only, and each folder gets about half of the work.
    #[must_use]
    pub fn target_folder(&self) -> usize {
        usize::from(matches!(self.name, "mps2-an386" | "riscv" | "sparc" | "wasm"))
    }

    /// Whether the board draws a scene with palettes too: on the two boards that are compared in what they cost, all scenes; elsewhere one.
    fn is_colored(&self, scene: &str, format: Format) -> bool {
        match format {
            Format::Q16 => self.name == "microbit" || (scene == "opaque" && self.name != "pc-floppy"),
            _ => self.name == "mps2-an386",
        }
    }

    /// Returns the pictures that the board draws.
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
                let file = super::folder().join(file);
                let picture = Picture { scene, file, format, baked: true, colors: Colors::Standard, size };
                pictures.push(picture.clone());
                if everything {
                    pictures.push(Picture { baked: false, ..picture.clone() });
                }
                if self.is_colored(scene, format) {
                    let colors = [Colors::Sampled, Colors::Dithered];
                    pictures.extend(colors.map(|colors| Picture { colors, ..picture.clone() }));
                }
            }
        }
        pictures
    }
}
