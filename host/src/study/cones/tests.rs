//! What is wrong in pixels of which the right light is known, and by how much; and how far pictures are from right ones.

use core::sync::atomic::AtomicBool;

use super::pictures::PICTURES;
use super::pixels::CASES;
use super::{Pixel, Study, page, pixel, ways};
use crate::engine::bands;

/// The light of the pixels by a cone, and the right light, in the order of the cases.
const KNOWN: &[(f64, f64)] = &[
    (0.506, 0.504),
    // The product of what two things leave.
    (0.256, 0.504),
    (0.25, 0.0),
    (0.0, 0.0),
    (0.5, 0.5),
    (0.253, 0.252),
    // Which is before which is told once for the whole pixel.
    (0.477, 0.576),
    (0.962, 0.962),
    (0.5, 0.5),
    // One place tells the light of all.
    (1.0, 0.5),
    (0.0, 0.25),
    (0.25, 0.25),
    (0.131, 0.255),
    (0.506, 0.508),
    (0.607, 0.436),
];

/// The most RMSE of the pictures by cones, and the most part that it is of that by one ray, in the order of the pictures.
const ERRORS: [(f64, f64); 5] = [(0.016, 0.2), (0.025, 0.29), (0.021, 0.27), (0.029, 0.22), (0.015, 0.34)];

#[test]
fn pixels() {
    assert_eq!(CASES.len(), KNOWN.len());
    for (case, &(known, right)) in CASES.iter().zip(KNOWN) {
        let Pixel { cone, rays } = pixel(&case.text()).expect("it is drawn");
        println!("{}: {cone:.4} {rays:.4}", case.name);
        assert!((cone - known).abs() < 0.005, "{}: {cone}, not {known}", case.name);
        assert!((rays - right).abs() < 0.005, "{}: {rays}, not {right}", case.name);
    }
}

#[test]
fn pictures() {
    let (pool, stop) = (bands::pool(None).expect("threads"), AtomicBool::new(false));
    let pictures = PICTURES.iter().map(|picture| ways(picture, ([32, 24], 256), &pool, &stop));
    let pictures = pictures.collect::<Result<Vec<_>, _>>().expect("nobody interrupts");
    for (ways, (most, part)) in pictures.iter().zip(ERRORS) {
        let error = |way: &str| {
            let row = ways.rows.iter().find(|row| row.way == way).expect("it is there");
            row.error.rmse
        };
        let (cone, ray, many) = (error("one cone"), error("1 ray"), error("64 samples"));
        println!("{}: {cone:.4}, {ray:.4}, {many:.4}", ways.title);
        assert!(cone < most && cone < part * ray, "{}: {cone}, {ray} by one ray", ways.title);
        // Rays are right in the end, and cones are not.
        assert!(many < cone, "{}: {cone}, {many} by 64 samples", ways.title);
    }
    let mut text = String::new();
    page::markdown(&mut text, &Study { pixels: Vec::new(), pictures });
    for words in ["# Cones", "| one cone ", "## mirrors, by cones", "4 x 4 rays"] {
        assert!(text.contains(words), "no {words:?} in {text}");
    }
}
