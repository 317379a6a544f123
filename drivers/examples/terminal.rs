//! A driver of one's own: a terminal as a display, with a colour table that it does not have.
//! `cargo run -p rta-drivers --example terminal`

use std::io::{self, Write};

use rta_core::{Q16, prelude::*};
use rta_drivers::display::{Capabilities, Display, DriverError};
use rta_drivers::painter::Painter;
use rta_drivers::quantize::Adaptive;

const CAPABILITIES: Capabilities =
    Capabilities { width: 72, height: 54, colors: 64, gun_max: 255, aspect: (4, 3) };

/// A terminal that knows colours of 24 bits. A character shows two pixels, one above the other.
struct Terminal<W> {
    out: W,
    colors: [Rgb<u8>; CAPABILITIES.colors as usize],
    rows: [[u8; CAPABILITIES.width as usize]; CAPABILITIES.height as usize],
}

impl<W: Write> Terminal<W> {
    fn new(out: W) -> Self {
        let (colors, rows) = ([Rgb::default(); 64], [[0; 72]; 54]);
        Self { out, colors, rows }
    }
}

impl<W: Write> Display for Terminal<W> {
    type Error = DriverError<io::Error>;

    fn capabilities(&self) -> Capabilities {
        CAPABILITIES
    }

    fn set_colors(&mut self, first: u8, colors: &[Rgb<u8>]) -> Result<(), Self::Error> {
        CAPABILITIES.check_colors(first, colors)?;
        let entries = self.colors.iter_mut().skip(first.into());
        entries.zip(colors).for_each(|(entry, &color)| *entry = color);
        Ok(())
    }

    fn put_pixels(&mut self, x: u32, y: u32, indices: &[u8]) -> Result<(), Self::Error> {
        CAPABILITIES.check_pixels(x, y, indices.len())?;
        CAPABILITIES.check_indices(indices)?;
        let row = self.rows.get_mut(y as usize).into_iter().flatten().skip(x as usize);
        row.zip(indices).for_each(|(pixel, &index)| *pixel = index);
        Ok(())
    }

    /// Writes the picture. A terminal that cannot be written to is an error of the device.
    fn update(&mut self) -> Result<(), Self::Error> {
        let color = |index: &u8| self.colors.get(usize::from(*index)).copied().unwrap_or_default();
        for [upper, lower] in self.rows.as_chunks().0 {
            for (upper, lower) in upper.iter().map(color).zip(lower.iter().map(color)) {
                write!(self.out, "\x1b[38;2;{};{};{}m", upper.r, upper.g, upper.b)?;
                write!(self.out, "\x1b[48;2;{};{};{}m\u{2580}", lower.r, lower.g, lower.b)?;
            }
            writeln!(self.out, "\x1b[0m")?;
        }
        Ok(self.out.flush()?)
    }
}

/// Draws a mirror on a chequered floor on any display.
fn draw<D: Display<Error: 'static>>(display: D) -> Result<D, Box<dyn core::error::Error>> {
    let Capabilities { width, height, colors, gun_max, .. } = display.capabilities();
    let length = |n: i32| Q16::from_num(n);
    let gold = Rgb::new(Unit::ratio(9, 10), Unit::ratio(7, 10), Unit::ratio(3, 10));
    let ball = Sphere::new(Xyz::new(length(0), length(5), length(2)), length(2), gold, 0);
    let lamp = Lamp::white(Xyz::new(length(-4), length(0), length(6)), length(1), 60);
    let scene = Scene { spheres: &[ball], materials: &[Material::Mirror], lamps: &[lamp], ..Scene::day() };
    let eye = Xyz::new(length(0), length(-1), length(2));
    let camera = Camera::new(eye, UnitVec3::<Q16>::Y, Lens::new(1, 1, (4, 3)));
    let scene = scene.admit(&camera)?;
    let tracer: Tracer<_, _, Everything, 5> = Tracer::new(&scene, Rta, 5)?;
    let mut painter = Painter::new(display, Adaptive::tolerant(colors, gun_max)?)?;
    for y in 0..height {
        let row = Pixels::row(&tracer, &camera, Raster::new(width, height)?, y);
        painter.put_row(0, y, row.map(|light| light.levels(gun_max)))?;
    }
    painter.update()?;
    Ok(painter.into_parts().0)
}

fn main() -> Result<(), Box<dyn core::error::Error>> {
    draw(Terminal::new(io::stdout().lock()))?;
    Ok(())
}

#[test]
fn the_picture_is_shown_in_its_colours() {
    let terminal = draw(Terminal::new(Vec::new())).expect("memory takes it");
    let text = String::from_utf8(terminal.out).expect("text");
    assert_eq!(text.lines().count(), 27);
    assert!(text.lines().all(|line| line.matches('\u{2580}').count() == 72 && line.ends_with("\x1b[0m")));
    assert!(terminal.colors.iter().filter(|color| **color != Rgb::default()).count() > 20);
}
