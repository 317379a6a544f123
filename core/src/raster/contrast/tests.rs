//! Edges through a pixel, against the exact part of it that they cover, and the rays that they take.

use super::{Contrasts, SAMPLES};
use crate::color::Rgb;
use crate::raster::corners::Packed;
use crate::raster::edge::{Edge, camera, random_edges};
use crate::raster::{Places, Raster};
use crate::sampling::Sobol;

const SEED: u32 = 7;

/// Returns the picture of an edge, and its rays.
fn drawn<const PIXELS: usize>(edge: &Edge, (width, height): (u32, u32)) -> ([f64; PIXELS], u64) {
    let (camera, raster) = (camera(), Raster::new(width, height).expect("small"));
    let mut memory = [Rgb::BLACK; 120];
    let (memory, _) = memory.split_at_mut(3 * usize::try_from(width).expect("small"));
    let mut rows = Contrasts::new(edge, (&camera, raster), SEED, memory, 0).expect("room");
    let (mut lights, mut at) = ([0.0; PIXELS], 0);
    while rows.next_row(|light| {
        lights[at] = light.r;
        at += 1;
    }) {}
    assert_eq!(at, PIXELS);
    (lights, rows.rays())
}

#[test]
fn edges_are_as_good_as_nine_samples() {
    let (mut n, mut sums) = (0.0, [0.0; 2]);
    for (edge, cover) in random_edges() {
        // The pixel in the middle of nine.
        let wide = Edge { distance: edge.distance / 3.0, ..edge };
        let (lights, _) = drawn::<9>(&wide, (3, 3));
        let error = lights[4] - cover;
        sums = [sums[0] + error * error, sums[1] + error];
        n += 1.0;
    }
    let (rms, mean) = (libm::sqrt(sums[0] / n), sums[1] / n);
    // Between regular grids of 4 samples, .0867, and of 16, .0304.
    assert!((rms / 0.0647 - 1.0).abs() < 0.05, "{rms}");
    assert!(mean.abs() < 1e-3, "{mean}");
}

#[test]
fn pixels_beside_another_light_have_nine_rays() {
    let edge = Edge { normal: [0.8, 0.6], distance: 0.07 };
    let (lights, rays) = drawn::<1200>(&edge, (40, 30));
    let raster = Raster::new(40, 30).expect("small");
    let places = Sobol::new(SAMPLES, SEED).expect("few");
    let light = |x: u32, y: u32, sample| -> f64 {
        let (right, up) = places.place::<f64>(raster, y, x, sample);
        if right * edge.normal[0] + up * edge.normal[1] < edge.distance { 1.0 } else { 0.0 }
    };
    let mut want_rays = 0;
    for (i, got) in (0u32..).zip(lights) {
        let (x, y) = (i % 40, i / 40);
        let own = light(x, y, 0);
        let around = (x.saturating_sub(1)..=(x + 1).min(39))
            .flat_map(|x| (y.saturating_sub(1)..=(y + 1).min(29)).map(move |y| (x, y)));
        let is_edge = around.into_iter().any(|(x, y)| (light(x, y, 0) - own).abs() > 0.5);
        let samples = if is_edge { SAMPLES } else { 1 };
        let want = (0..samples).map(|sample| light(x, y, sample)).sum::<f64>() / f64::from(samples);
        assert!((got - want).abs() < 1e-12, "pixel {x}, {y}: {got} instead of {want}");
        want_rays += u64::from(samples);
    }
    assert_eq!(rays, want_rays);
    assert!((1200..1200 * 9 / 3).contains(&rays), "{rays}");
}

#[test]
fn contrast_below_the_threshold_of_a_register_is_no_edge() {
    // (max - min) / (max + min): 0.3 is that of green.
    for (dark, is_edge) in [(0.53, true), (0.545, false)] {
        let edge = Edge { normal: [1.0, 0.0], distance: 0.0 };
        let (camera, raster) = (camera(), Raster::new(8, 8).expect("small"));
        let tracer = crate::raster::edge::Tinted { edge, dark: [1.0, dark, 1.0] };
        let mut memory = [Rgb::BLACK; 24];
        let mut rows = Contrasts::new(&tracer, (&camera, raster), SEED, &mut memory, 0).expect("room");
        while rows.next_row(|_| ()) {}
        assert_eq!(rows.rays(), if is_edge { 64 + 8 * 16 } else { 64 }, "{dark}");
    }
}

#[test]
fn rows_may_begin_anywhere_and_be_packed() {
    let edge = Edge { normal: [0.8, 0.6], distance: 0.07 };
    let (whole, _) = drawn::<1200>(&edge, (40, 30));
    let (camera, raster) = (camera(), Raster::new(40, 30).expect("small"));
    for first in [1, 2, 7, 29] {
        // Black and white are levels of every display.
        let mut memory = [Packed::<63>::default(); 120];
        let rows = Contrasts::new(&edge, (&camera, raster), SEED, &mut memory, first);
        let mut at = usize::try_from(first).expect("small") * 40;
        assert!(rows.expect("room").next_row(|light| {
            assert!((light.g - whole[at]).abs() < 1e-12, "{at}");
            at += 1;
        }));
    }
    let mut memory = [Rgb::BLACK; 119];
    assert!(Contrasts::new(&edge, (&camera, raster), SEED, &mut memory, 0).is_none());
}
