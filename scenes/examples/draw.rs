//! Reads a scene file, brings it into fixed point and writes its picture as a PPM:
//! `cargo run -p rta-scenes --example draw scenes/hall-22.dat >hall.ppm`. Without a file it draws one that comes with rta.

use std::io::{self, Write};

use rta_core::{Q16, prelude::*};
use rta_scenes::narrow::narrow;
use rta_scenes::{OutOfRange, read, shipped};

/// Draws a scene in `width` x `height` pixels, which fill a screen of 4 : 3.
fn draw(
    text: &[u8],
    name: &str,
    (width, height): (u32, u32),
    mut out: impl Write,
) -> Result<(), Box<dyn core::error::Error>> {
    let described = read(text, name)?;
    for warning in &described.warnings {
        eprintln!("warning: {}", warning.of_file(name));
    }
    // From f64 into the number format.
    let scene = narrow::<Q16>(&described, 4.0 / 3.0)?;
    // The proof that no ray leaves the number format. An error names the line of the object that does not fit.
    let admitted = scene.admit();
    let admitted = admitted.map_err(|error| OutOfRange::new(error, &described))?;
    let tracer: Tracer<_, _, Everything, 5> = Tracer::new(&admitted, Rta, 5)?;
    write!(out, "P6\n{width} {height}\n255\n")?;
    for light in Pixels::new(&tracer, &scene.camera, Raster::new(width, height)?) {
        let Rgb { r, g, b } = light.levels(255);
        out.write_all(&[r, g, b])?;
    }
    Ok(out.flush()?)
}

fn main() -> Result<(), Box<dyn core::error::Error>> {
    let out = io::BufWriter::new(io::stdout().lock());
    match std::env::args().nth(1) {
        Some(file) => draw(&std::fs::read(&file)?, &file, (320, 240), out),
        None => draw(shipped::JUGGLER.as_bytes(), "juggler.dat", (320, 240), out),
    }
}

#[test]
fn a_picture_is_written() {
    let mut picture = Vec::new();
    draw(shipped::JUGGLER.as_bytes(), "juggler.dat", (32, 24), &mut picture).expect("it is drawn");
    assert_eq!(picture.len(), "P6\n32 24\n255\n".len() + 3 * 32 * 24);
    let error = draw(b"0 0", "short.dat", (1, 1), &mut picture).expect_err("no scene");
    assert!(error.to_string().starts_with("short.dat:1:4: expected"), "{error}");
}
