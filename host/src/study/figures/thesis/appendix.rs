//! The thesis's appendix: its machines, its compositions and the times that it reports, and what ours take.

use super::drawn::{coarser, traced_here};
use super::{Fineness, Tracing};
use crate::args::TracingArgs;
use crate::engine::Format;
use crate::picture::device::{Device, Target};
use crate::picture::file::Displayed;
use crate::request::Request;
use crate::request::scene_file::SceneFile;
use crate::study::error::StudyError;
use crate::study::palette::traced::Traced;

/// A machine of the thesis.
#[derive(Clone, Copy, Debug)]
pub struct Machine {
    /// Its name.
    pub name: &'static str,
    /// Raster, colours at once and of how many, screen.
    pub display: &'static str,
    /// Its processor, from other sources than the thesis.
    pub processor: &'static str,
    /// What stands for it here.
    pub here: &'static str,
}

/// The machines, in the order of the thesis's devices.
pub const MACHINES: [Machine; 3] = [
    Machine {
        name: "IBM PS/2, MCGA or VGA, mode 13h",
        display: "320 x 200, 256 colours of 262 144 (6 bits a gun), screen 4 : 3",
        processor: "model 25: 8086 at 8 MHz; model 60: 80286 at 10 MHz, with an 80287 where there is a coprocessor",
        here: "the registers of its display, emulated; a PC with an i486, under QEMU (the program's code has 32 bits, which neither model runs)",
    },
    Machine {
        name: "IBM RT PC 6150 or 6151 with graPHIGS",
        display: "1024 x 1024, 128 colours of 4096 (16 levels a gun), screen 1 : 1",
        processor: "ROMP; which clock it had is not known to us",
        here: "the calls of its display, emulated. No emulator of the machine is known, so there are no instructions of it",
    },
    Machine {
        name: "SUN SPARCstation 1 with PIXRECT",
        display: "1152 x 900, 256 colours of 16 777 216 (8 bits a gun), screen 1152 : 900",
        processor: "SPARC version 7 at 20 MHz, rated at 12.5 million instructions a second",
        here: "the calls of its display, emulated; a SPARCstation 5 with a cgthree, under QEMU",
    },
];

/// A time that the thesis reports.
#[derive(Clone, Copy, Debug)]
pub struct Reported {
    /// The machine.
    pub machine: &'static str,
    /// The picture, as far as it is known.
    pub picture: &'static str,
    /// The time.
    pub time: &'static str,
    /// The composition of ours that stands for it, by its name.
    pub ours: Option<&'static str>,
}

/// All times that are known to us.
pub const REPORTED: [Reported; 5] = [
    Reported {
        machine: "PS/2 model 25, without coprocessor",
        picture: "a picture; which is not known to us",
        time: "up to 4 h",
        ours: None,
    },
    Reported {
        machine: "PS/2 model 60, with coprocessor",
        picture: "pictures; which are not known to us",
        time: "6 to 30 min",
        ours: None,
    },
    Reported {
        machine: "PS/2 model 60",
        picture: "2 objects, one of them transparent, 320 x 200",
        time: "a little over 6 min",
        ours: Some("glass-2-vga"),
    },
    Reported {
        machine: "IBM RT PC",
        picture: "22 objects, half of them mirrors, 1024 x 1024",
        time: "1 h 15 min",
        ours: Some("hall-22-graphigs"),
    },
    Reported {
        machine: "SPARCstation",
        picture: "2 objects, one of them transparent, 1152 x 900",
        time: "almost 6 min",
        ours: Some("glass-2-pixrect"),
    },
];

/// A composition on a machine's display.
#[derive(Clone, Copy, Debug)]
pub struct Composition {
    /// Stem of its picture's name.
    pub name: &'static str,
    /// What is to be seen.
    pub what: &'static str,
    /// The machine.
    pub machine: &'static str,
    /// The scene's file.
    pub file: &'static str,
    /// The machine's display.
    pub device: Device,
}

/// All compositions.
pub const COMPOSITIONS: &[Composition] = &[
    Composition {
        name: "glass-2-vga",
        what: "2 objects, one of them transparent",
        machine: "PS/2",
        file: "glass-2.dat",
        device: Device::Vga,
    },
    Composition {
        name: "hall-22-graphigs",
        what: "22 objects, half of them mirrors",
        machine: "IBM RT PC",
        file: "hall-22.dat",
        device: Device::Graphigs,
    },
    Composition {
        name: "glass-2-pixrect",
        what: "2 objects, one of them transparent",
        machine: "SPARCstation 1",
        file: "glass-2.dat",
        device: Device::Pixrect,
    },
];

/// What a composition takes on this host.
#[derive(Clone, Debug)]
pub struct Run {
    /// The picture as the display shows it.
    pub shown: Displayed,
    /// Rays of all kinds.
    pub rays: u64,
    /// CPU seconds on one thread, of tracing alone, in each of [`FORMATS`].
    pub seconds: [f64; 2],
}

/// The number formats that times are told of: floating point as the thesis's program has it, and what boards without it take.
pub const FORMATS: [Format; 2] = [Format::F32, Format::Q16];

impl Composition {
    /// Draws it, and measures what it takes.
    pub(super) fn run(&self, fineness: Fineness, tracing: &Tracing) -> Result<Run, StudyError> {
        let missing = || StudyError::NoScene(self.file.to_owned());
        let scene = SceneFile::named(self.file.trim_end_matches(".dat")).ok_or_else(missing)??;
        let asked = |format: Format| {
            let asked = TracingArgs { format, ..TracingArgs::default() };
            let mut request = Request::of_scene(&asked, Target::On(self.device), &scene)?;
            request.size = Some(coarser(Target::On(self.device).size(), fineness));
            Ok::<_, StudyError>(request)
        };
        let mut seconds = [0.0; 2];
        let mut rays = 0;
        for (seconds, format) in seconds.iter_mut().zip(FORMATS) {
            let request = asked(format)?;
            let engine = request.engine(&scene)?;
            *seconds = traced_here(&engine, request.raster()?.0, tracing)?.1;
            if format == Format::F32 {
                rays = engine.rays().iter().sum();
            }
        }
        let request = asked(Format::F32)?;
        let traced = Traced::new(&request, &scene, tracing.pool, tracing.stop)?;
        let shown = traced.displayed(self.device, request.coloring)?;
        Ok(Run { shown, rays, seconds })
    }
}
