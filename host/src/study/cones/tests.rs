//! What is wrong in pixels of which the right light is known, and by how much; and how far pictures are from right ones.

use core::sync::atomic::AtomicBool;

use super::pixels::CASES;
use super::{Pixel, page, pixel, study};

/// The light of the pixels by a cone, and the right light, in the order of the cases.
const KNOWN: &[(f64, f64)] = &[
    (0.5, 0.5),
    // The product of what two things leave.
    (0.25, 0.5),
    (0.25, 0.0),
    (0.0, 0.0),
    (0.5, 0.5),
];

#[test]
fn pixels() {
    for (at, case) in CASES.iter().enumerate() {
        let Pixel { cone, rays } = pixel(&case.text()).expect("it is drawn");
        println!("{}: {cone:.4} {rays:.4}", case.name);
        if let Some(&(known, right)) = KNOWN.get(at) {
            assert!((cone - known).abs() < 0.02, "{}: {cone}, not {known}", case.name);
            assert!((rays - right).abs() < 0.02, "{}: {rays}, not {right}", case.name);
        }
    }
}

#[test]
fn pictures() {
    let study = study(&AtomicBool::new(false)).expect("nobody interrupts");
    let mut text = String::new();
    page::markdown(&mut text, &study);
    println!("{text}");
}
