//! Firmware that draws a picture and sends it through a serial port, as text: `cargo run -p rta-core --example ball`.
//!
//! All but the last function is what a microcontroller would run: no heap, no operating system, no floating point.
#![no_std]

extern crate std;

use core::fmt::{self, Write};

use rta_core::{Q16, prelude::*};

/// Characters in a row, twice as high as they are wide, and rows: a screen of 4 : 3.
const SIZE: (u32, u32) = (80, 30);
/// Characters from dark to bright.
const INK: &[u8] = b" .:-=+*#%@";

/// Draws a mirror on a chequered floor; `port` takes one character after the other.
fn draw(port: &mut impl Write) -> Result<fmt::Result, rta_core::Error> {
    let length = |n: i32| Q16::from_num(n);
    let silver = Rgb::new(Unit::ratio(9, 10), Unit::ratio(9, 10), Unit::ratio(9, 10));
    let ball = Sphere::new(Xyz::new(length(0), length(6), length(2)), length(2), silver, 0);
    let lamp = Lamp::white(Xyz::new(length(-4), length(0), length(6)), length(1), 60);
    let scene = Scene { spheres: &[ball], materials: &[Material::Mirror], lamps: &[lamp], ..Scene::day() };
    let eye = Xyz::new(length(0), length(-1), length(2));
    let camera = Camera::new(eye, UnitVec3::<Q16>::Y, Lens::new(1, 1, (4, 3)));
    let scene = scene.admit(&camera)?; // no ray can overflow
    let tracer: Tracer<_, _, Everything, 5> = Tracer::new(&scene, Rta, 5)?;
    let raster = Raster::new(SIZE.0, SIZE.1)?;
    let mut row = || {
        for y in 0..SIZE.1 {
            for light in Pixels::row(&tracer, &camera, raster, y) {
                let levels = light.levels(85); // three of them make a byte
                let brightness = usize::from(levels.r + levels.g + levels.b);
                let ink = INK.get(brightness * INK.len() / 256).copied().unwrap_or(b'?');
                port.write_char(char::from(ink))?;
            }
            port.write_char('\n')?;
        }
        Ok(())
    };
    Ok(row())
}

fn main() -> Result<(), rta_core::Error> {
    let mut picture = std::string::String::new();
    let sent = draw(&mut picture)?;
    assert!(sent.is_ok(), "a string takes all");
    std::print!("{picture}");
    Ok(())
}

#[test]
fn a_picture_is_sent() {
    let mut picture = std::string::String::new();
    assert_eq!(draw(&mut picture), Ok(Ok(())));
    assert!(picture.lines().count() == 30 && picture.lines().all(|row| row.len() == 80), "{picture}");
    // The sky is bright and the floor has dark tiles.
    assert!(picture.contains("%%%") && picture.contains("   "), "{picture}");
}
