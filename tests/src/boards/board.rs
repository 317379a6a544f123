//! The boards.

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
    /// On a panel of greys without a colour table, which the program cannot read: the emulator takes a screendump. The picture is as large
    /// as the panel. The program reports over a serial line.
    Panel {
        /// Width and height in pixels.
        size: (u32, u32),
        /// Pixels of the screendump for each pixel of the panel, along each axis.
        zoom: u32,
    },
    /// In a PCX file that a DOS program writes of what its screen shows. One program draws all scenes.
    File {
        /// Width, height and highest level of the screen.
        screen: (u32, u32, u8),
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

const OLED: &[&str] = &[
    "-M",
    "lm3s6965evb",
    "-display",
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
    "-icount",
    "shift=0,sleep=off",
];

const SPARC: &[&str] = &[
    "-M",
    "SS-5",
    "-vga",
    "cg3",
    "-g",
    "1152x900x8",
    "-m",
    "32",
    "-display",
    "none",
    "-icount",
    "shift=0,sleep=off",
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

/// A PC under DOS, whose program writes a file.
pub const DOS: Board = Board {
    name: "pc-dos",
    processor: "i486",
    package: "pc",
    feature: Some("dos"),
    target: "i486-none",
    linker: "ld.lld",
    emulator: "dosbox",
    arguments: &[],
    output: Output::File { screen: (320, 200, 63) },
};

/// All boards.
pub const ALL: [Board; 10] = [
    cortex_m("microbit", "Cortex-M0", "thumbv6m-none-eabi"),
    cortex_m("lm3s6965evb", "Cortex-M3", "thumbv7m-none-eabi"),
    Board {
        arguments: OLED,
        output: Output::Panel { size: (128, 64), zoom: 4 },
        ..cortex_m("lm3s6965evb-oled", "Cortex-M3", "thumbv7m-none-eabi")
    },
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
    DOS,
    Board {
        name: "sparc",
        processor: "SPARC v8",
        package: "sparc",
        feature: None,
        target: "sparc-unknown-none-elf",
        linker: "sparc64-linux-gnu-ld",
        emulator: "qemu-system-sparc",
        arguments: SPARC,
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

/// Number of target folders, in each of which one image at a time is built.
pub const TARGET_FOLDERS: usize = 2;

impl Board {
    /// Returns the programs that the board is run with: its emulator, and what that needs.
    #[must_use]
    pub fn programs(&self) -> Vec<&'static str> {
        let screen: &[_] =
            if matches!(self.output, Output::File { .. }) { &["Xvfb", "xdotool"] } else { &[] };
        [&[self.emulator], screen].concat()
    }

    /// Returns the number of the target folder, below [`TARGET_FOLDERS`], that the board's images are built in. Each
    /// target has one folder, so that its `core` is built once only, and each folder gets about half of the work.
    #[must_use]
    pub fn target_folder(&self) -> usize {
        usize::from(matches!(self.name, "mps2-an386" | "riscv" | "sparc" | "wasm"))
    }
}
