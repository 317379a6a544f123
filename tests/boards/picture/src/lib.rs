//! The picture that every board draws, and what it reports of itself.

#![no_std]

mod antialiased;
pub mod console;
pub mod direct;
pub mod elapsed;
pub mod stream;

use core::marker::PhantomData;

use rta_core::Scalar;
use rta_core::accelerator::Accelerator;
use rta_core::color::Rgb;
use rta_core::radiosity::{Indirect, Mesh, Solution, Solver};
use rta_core::range::Admitted;
use rta_core::raster::lattice::Lattice;
use rta_core::raster::{Center, Pixels, Places, Raster};
use rta_core::trace::dice::Spread;
use rta_core::trace::moving::Moving;
use rta_core::trace::{Distributed, Spectrum, Trace, Tracer};
use rta_core::zbuffer::{Told, ZBuffer};
use rta_drivers::checksum::{Checksum, Unseen};
use rta_drivers::display::{Capabilities, Display};
use rta_drivers::dither::{Cell, Damped, Diffusion, Dither, DitherError};
use rta_drivers::painter::Painter;
use rta_drivers::quantize::{Adaptive, ColorTable, Palette, TableError, Uniform, variance_cut};

include!(concat!(env!("OUT_DIR"), "/choice.rs"));

/// Recursion depth.
pub const DEPTH: u8 = 5;

/// How the colours of the picture are chosen.
#[derive(Clone, Copy, PartialEq, Eq)]
#[allow(dead_code, reason = "one of them is chosen when the scene is baked")]
enum Colors {
    /// By the board's own table.
    Standard,
    /// By a palette made from samples of the picture.
    Sampled,
    /// By such a palette, with error diffusion.
    Dithered,
}

/// The most samples of which a palette is made: a sixteenth of the pixels of 160 x 100. They are 3 KiB on the stack.
const SAMPLES: usize = 1024;

/// The colour table of boards that stream their picture: in flash, and it costs no RAM.
static TABLE: Uniform = match Uniform::new(256, 63) {
    Ok(table) => table,
    Err(_) => panic!("256 colours and 64 levels are enough for a cube"),
};

/// The colour table of boards that stream their picture.
pub fn table() -> &'static Uniform {
    &TABLE
}

/// The colour table of boards with a screen: made while the picture is drawn.
pub const fn adaptive(gun_max: u8) -> Adaptive {
    match Adaptive::tolerant(256, gun_max) {
        Ok(table) => table,
        Err(_) => panic!("256 colours are a table"),
    }
}

/// Why there is no picture.
#[derive(Debug)]
pub enum DrawError<E> {
    /// The tracer refuses raster or depth.
    Tracer(rta_core::Error),
    /// No palette can be made for the display.
    Table(TableError),
    /// The memory for a row is too small.
    Dither(DitherError),
    /// The display's own.
    Display(E),
}

/// Draws the picture, `WIDTH` x `HEIGHT` from (`left`, `top`); calls `row` before the first row and after each.
///
/// # Errors
/// Those of the display.
pub fn draw<D: Display, T: ColorTable>(
    display: D,
    table: T,
    origin: (u32, u32),
    row: impl FnMut(),
) -> Result<D, DrawError<D::Error>> {
    draw_sized((WIDTH, HEIGHT), Indexed { display, table, origin, row })
}

/// What a board with a screen tells of the picture: its raster, and [`checksum`].
///
/// It is generic, as [`checksum`] is, for the sake of boards that do not call it: no tracer is compiled for it there, and
/// theirs is not optimised with another caller in view.
pub fn facts<T: ColorTable>(table: T) -> [(&'static str, u64); 3] {
    [("width", WIDTH.into()), ("height", HEIGHT.into()), ("hash", checksum(table))]
}

/// The hash of the picture as boards without a screen stream it, in 160 x 100 pixels of 64 levels, with [`table`] unless a palette is
/// made for it. It is the same on all
/// boards, whatever their own screens are like.
pub fn checksum<T: ColorTable>(table: T) -> u64 {
    let (width, height) = (160, 100);
    let unseen = Unseen(Capabilities { width, height, colors: 256, gun_max: 63, aspect: (4, 3) });
    let drawing = Indexed { display: Checksum::new(unseen), table, origin: (0, 0), row: || () };
    match draw_sized((width, height), drawing) {
        Ok(sum) => sum.value(),
        Err(_) => 0,
    }
}

/// Whether the picture is one of several wavelengths.
const SPECTRAL: bool = !scene::WEIGHTS.is_empty();

/// Whether rays are spread.
const SPREADS: bool = scene::SAMPLES.is_some();

/// Whether something moves while the shutter is open.
const MOVES: bool = !scene::MOTIONS.is_empty() || scene::SPREAD.eye.is_some();

/// Whether pixels are antialiased where light differs.
const ADAPTIVE: bool = scene::CUTTING.is_some() || scene::CONTRAST;

/// Pixels of the longest row: of the board's own picture, or of that of [`checksum`].
const ROW: usize = if WIDTH > 160 { WIDTH as usize } else { 160 };

/// The tracer of the baked scene with its model, by whichever accelerator it has.
type Traced<'a, M, A> = Tracer<'a, scene::Number, M, Needs, { DEPTH as usize }, A>;

/// Such a tracer behind a Z-buffer, whose row takes the board's own picture and that of [`checksum`].
type Buffered<'a, M, A> = ZBuffer<'a, scene::Number, M, Needs, { DEPTH as usize }, ROW, A>;

/// What is done with the tracer of the scene.
trait Drawing {
    /// What has been drawn on.
    type Display;
    /// The display's error.
    type Error;

    /// Draws the picture of a tracer, with the samples that `places` names.
    fn draw(
        self,
        tracer: &impl Trace<scene::Number>,
        places: impl Places,
        raster: Raster,
    ) -> Result<Self::Display, DrawError<Self::Error>>;
}

fn draw_sized<D: Drawing>(
    (width, height): (u32, u32),
    drawing: D,
) -> Result<D::Display, DrawError<D::Error>> {
    let raster = Raster::new(width, height).map_err(DrawError::Tracer)?;
    let scene = if BAKED { &scene::SCENE } else { core::hint::black_box(&scene::SCENE) };
    let [model, further @ ..] = scene::models();
    if BUFFERED {
        let told = Told::of(scene);
        let buffer: Buffered<'_, _, _> =
            ZBuffer::new(&told, model, DEPTH.into(), raster).map_err(DrawError::Tracer)?;
        return drawing.draw(&buffer, Center, raster);
    }
    let tracer: Traced<'_, _, _> = Tracer::new(scene, model, DEPTH.into()).map_err(DrawError::Tracer)?;
    if SPECTRAL {
        let mut scenes = scene::FURTHER.iter();
        let further = further.map(|model| {
            let scene = scenes.next().unwrap_or(scene);
            Tracer::new(scene, model, DEPTH.into()).unwrap_or(tracer)
        });
        let (weights, dispersive) = (&scene::WEIGHTS[..], &scene::DISPERSIVE[..]);
        let spectrum = Spectrum { weights, first: tracer, further: &further, dispersive };
        return drawing.draw(&spectrum, Center, raster);
    }
    if SPREADS && let Some(samples) = scene::SAMPLES {
        if scene::PATCHES > 0 {
            let mut memory = [[Rgb::BLACK; scene::PATCHES]; 2];
            let indirect = indirect(scene, &mut memory);
            let spread = Spread { indirect, ..scene::SPREAD };
            return drawing.draw(
                &Distributed { tracer, spread: &spread, seed: samples.seed() },
                samples,
                raster,
            );
        }
        let still = Distributed { tracer, spread: &scene::SPREAD, seed: samples.seed() };
        if MOVES {
            let room = PhantomData::<fn() -> scene::Room>;
            return drawing.draw(&Moving { still, motions: &scene::MOTIONS, room }, samples, raster);
        }
        return drawing.draw(&still, samples, raster);
    }
    drawing.draw(&tracer, Center, raster)
}

/// Radiance of the scene's format.
type Light = <scene::Number as Scalar>::Light;

/// Returns the indirect light of the scene, as it was solved ahead or else as it is solved now, in the memory.
// By itself, so that what it needs of the stack is free again when the picture is drawn.
#[inline(never)]
fn indirect<'a, A: Accelerator<scene::Number>>(
    scene: &Admitted<'a, scene::Number, A>,
    memory: &'a mut [[Rgb<Light>; scene::PATCHES]; 2],
) -> Option<Indirect<'a, scene::Number>> {
    let mesh = Mesh::new(&scene::QUADS, &scene.scene).ok()?;
    if !scene::ARRIVING.is_empty() {
        let arriving = Solution::new(mesh, &scene::ARRIVING).ok()?;
        return Some(Indirect { arriving, elsewhere: scene::ELSEWHERE });
    }
    let [reflected, arriving] = memory;
    let elsewhere = Solver::<_, Needs, _, A>::indirect_light(scene, mesh, reflected, arriving).ok()?;
    Some(Indirect { arriving: Solution::new(mesh, arriving).ok()?, elsewhere })
}

/// A picture on a display with a colour table.
struct Indexed<D, T, R> {
    display: D,
    table: T,
    origin: (u32, u32),
    /// Called before the first row and after each.
    row: R,
}

impl<D: Display, T: ColorTable, R: FnMut()> Drawing for Indexed<D, T, R> {
    type Display = D;
    type Error = D::Error;

    #[inline(always)] // it has one caller in a program
    fn draw(
        self,
        tracer: &impl Trace<scene::Number>,
        places: impl Places,
        raster: Raster,
    ) -> Result<D, DrawError<D::Error>> {
        let Self { display, table, origin, row } = self;
        if COLORS == Colors::Standard {
            return paint(
                tracer,
                (places, raster),
                Painter::new(display, table).map_err(DrawError::Display)?,
                origin,
                row,
            );
        }
        let mut palette = palette(tracer, raster, display.capabilities()).map_err(DrawError::Table)?;
        if COLORS == Colors::Dithered {
            let mut cells = [Cell::default(); ROW];
            if let Ok(diffusion) = Diffusion::<Damped, _>::new(&mut cells[..], raster.width() as usize) {
                let painter =
                    Painter::dithered(display, &mut palette, diffusion).map_err(DrawError::Display)?;
                return paint(tracer, (places, raster), painter, origin, row);
            }
        }
        paint(
            tracer,
            (places, raster),
            Painter::new(display, &mut palette).map_err(DrawError::Display)?,
            origin,
            row,
        )
    }
}

/// Makes a palette for the picture on a display, from samples of it.
// By itself, so that the samples' memory is free again when the picture is drawn.
#[inline(never)]
fn palette(
    tracer: &impl Trace<scene::Number>,
    raster: Raster,
    display: Capabilities,
) -> Result<Palette, TableError> {
    let mut memory = [Rgb::new(0, 0, 0); SAMPLES];
    let lattice = Lattice::new(raster, SAMPLES);
    let light = Pixels::sampled(tracer, &scene::CAMERA, lattice.grid(), lattice, 0, lattice.grid().height());
    let light = light.map(|light| light.levels(u8::MAX));
    variance_cut(&mut memory, light, lattice.grid().width(), display.colors, display.gun_max)
}

fn paint<D: Display, T: ColorTable, H: Dither>(
    tracer: &impl Trace<scene::Number>,
    (places, raster): (impl Places, Raster),
    mut painter: Painter<D, T, H>,
    (left, top): (u32, u32),
    mut row: impl FnMut(),
) -> Result<D, DrawError<D::Error>> {
    row();
    if ADAPTIVE {
        antialiased::put_rows(tracer, raster, &mut painter, (left, top), row)?;
        painter.update().map_err(DrawError::Display)?;
        return Ok(painter.into_parts().0);
    }
    let most = painter.light_max();
    for y in 0..raster.height() {
        let light = Pixels::sampled(tracer, &scene::CAMERA, raster, places, y, y + 1);
        let light = light.map(|light| light.levels(most));
        painter.put_row(left, top + y, light).map_err(DrawError::Display)?;
        row();
    }
    painter.update().map_err(DrawError::Display)?;
    Ok(painter.into_parts().0)
}

/// `name`, a blank, `value` in sixteen hexadecimal digits, and the end of the line: a report without `core::fmt`.
pub fn report(name: &str, value: u64, mut put: impl FnMut(u8)) {
    for byte in name.bytes() {
        put(byte);
    }
    put(b' ');
    for digit in (0..16).rev() {
        let nibble = (value >> (4 * digit)).to_le_bytes()[0] & 15;
        put(if nibble < 10 { b'0' + nibble } else { b'a' + nibble - 10 });
    }
    put(b'\n');
}
