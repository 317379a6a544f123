//! FLIP beside the program of its authors, by the pairs of pictures in `pairs/`, whose README tells of them.

use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};

use png::{BitDepth, ColorType, Decoder, Transformations};
use rta::picture::raster::Size;
use rta::study::measure::{flip, mean};
use rta_core::color::Rgb;

use super::{Pictures, assert_maps_close, pixels_per_degree};

/// How far a mean and an error of a pixel may be from the authors', who compute in 32 bits.
const TOLERANCE: f32 = 2e-4;

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/measure/pairs").join(name)
}

/// Returns the bytes of a PNG, its kind and its size.
fn read(name: &str) -> (Vec<u8>, (ColorType, BitDepth), Size) {
    let mut decoder = Decoder::new(BufReader::new(File::open(file(name)).expect("a file of the pair")));
    decoder.set_transformations(Transformations::EXPAND & !Transformations::ALPHA);
    let mut reader = decoder.read_info().expect("a PNG");
    let mut bytes = vec![0; reader.output_buffer_size().expect("it is small")];
    let info = reader.next_frame(&mut bytes).expect("a picture");
    bytes.truncate(info.buffer_size());
    (bytes, (info.color_type, info.bit_depth), Size::new(info.width, info.height).expect("within the limits"))
}

/// Returns a picture of 8 bits a register.
fn picture(name: &str) -> (Vec<Rgb<u8>>, Size) {
    let (bytes, kind, size) = read(name);
    assert_eq!(kind, (ColorType::Rgb, BitDepth::Eight), "{name}");
    let (pixels, rest) = bytes.as_chunks();
    assert!(rest.is_empty(), "{name}");
    (pixels.iter().map(|&[r, g, b]| Rgb::new(r, g, b)).collect(), size)
}

/// Returns the maps of a pair below each other: 16 bits of gray, the highest is 1.
fn maps(name: &str) -> Vec<f32> {
    let (bytes, kind, _) = read(name);
    assert_eq!(kind, (ColorType::Grayscale, BitDepth::Sixteen), "{name}");
    let (levels, _) = bytes.as_chunks();
    levels.iter().map(|&level| f32::from(u16::from_be_bytes(level)) / f32::from(u16::MAX)).collect()
}

#[test]
fn flip_is_that_of_its_authors_at_every_pixel() {
    let mut means = csv::Reader::from_path(file("means.csv")).expect("a table");
    let mut rows: Vec<(String, f64, f64)> = means.deserialize().map(|row| row.expect("a mean")).collect();
    rows.sort_by(|(name, pixels, _), (other, other_pixels, _)| {
        name.cmp(other).then(pixels.total_cmp(other_pixels))
    });
    let mut pairs = 0;
    for rows in rows.chunk_by(|(name, ..), (other, ..)| name == other) {
        let name = &rows[0].0;
        let (reference, size) = picture(&format!("{name}-reference.png"));
        let (test, test_size) = picture(&format!("{name}-test.png"));
        assert_eq!(size, test_size, "{name}");
        let pictures = Pictures { size, reference, test };
        let maps = maps(&format!("{name}-flip.png"));
        assert_eq!(rows.len() * size.pixels(), maps.len(), "{name}");
        for ((_, pixels, want_mean), want) in rows.iter().zip(maps.chunks_exact(size.pixels())) {
            let map = flip::map(&pictures.pair(), pixels_per_degree(*pixels));
            let what = format!("{name} at {pixels} pixels a degree");
            assert_maps_close(&map, want, TOLERANCE, &what);
            assert!((mean(&map) - want_mean).abs() <= f64::from(TOLERANCE), "{what}: {}", mean(&map));
        }
        pairs += 1;
    }
    assert!(pairs >= 6, "only {pairs} pairs");
}
