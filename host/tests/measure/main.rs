//! The measures of pictures beside published values and other ways of computing them.
#![allow(clippy::indexing_slicing, reason = "a test may panic")]

mod analytic;
mod ciede2000;
mod reference;
mod scielab;

use rta::picture::raster::Size;
use rta::study::measure::{Pair, PixelsPerDegree};
use rta_core::color::Rgb;

/// Two pictures and their size.
struct Pictures {
    size: Size,
    reference: Vec<Rgb<u8>>,
    test: Vec<Rgb<u8>>,
}

impl Pictures {
    /// Returns pictures that are computed from the column and the row.
    fn drawn(
        (width, height): (u32, u32),
        reference: impl Fn(u32, u32) -> Rgb<u8>,
        test: impl Fn(u32, u32) -> Rgb<u8>,
    ) -> Self {
        let places = || (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        Self {
            size: Size::new(width, height).expect("within the limits"),
            reference: places().map(|(x, y)| reference(x, y)).collect(),
            test: places().map(|(x, y)| test(x, y)).collect(),
        }
    }

    /// Returns two pictures of one colour each.
    fn plain(size: (u32, u32), reference: Rgb<u8>, test: Rgb<u8>) -> Self {
        Self::drawn(size, |_, _| reference, |_, _| test)
    }

    fn pair(&self) -> Pair<'_> {
        Pair::new(&self.reference, &self.test, self.size).expect("both are of this size")
    }

    fn swapped(&self) -> Pair<'_> {
        Pair::new(&self.test, &self.reference, self.size).expect("both are of this size")
    }
}

const BLACK: Rgb<u8> = Rgb::new(0, 0, 0);
const WHITE: Rgb<u8> = Rgb::new(255, 255, 255);

fn pixels_per_degree(pixels: f64) -> PixelsPerDegree {
    PixelsPerDegree::new(pixels).expect("within the limits")
}

/// Returns registers that look random, by a hash of the place and of `seed`.
fn noise(seed: u32) -> impl Fn(u32, u32) -> Rgb<u8> {
    move |x, y| {
        let hash = (x + 57 * y + 1013 * seed).wrapping_mul(2_654_435_761);
        let hash = (hash ^ (hash >> 15)).wrapping_mul(2_246_822_519);
        let [r, g, b, _] = hash.to_le_bytes();
        Rgb::new(r, g, b)
    }
}

/// Panics where two maps differ by more than `tolerance` at a pixel.
#[track_caller]
fn assert_maps_close(got: &[f32], want: &[f32], tolerance: f32, what: &str) {
    assert_eq!(got.len(), want.len(), "{what}");
    for (place, (got, want)) in got.iter().zip(want).enumerate() {
        assert!((got - want).abs() <= tolerance, "{what}, pixel {place}: {got}, not {want}");
    }
}
