//! Triangles for tests.
#![allow(clippy::indexing_slicing, reason = "a test may panic")]

use fastrand::Rng;

use super::integer::{Raster, Triangle, Vector, View};
use crate::picture::raster::Size;

/// Returns the view of triangles in a picture that is 2 wide and 2 high at distance 1. Those that are degenerate are left out.
pub(crate) fn view((width, height): (u32, u32), triangles: &[[Vector; 3]]) -> View {
    let size = Size::new(width, height).expect("a size");
    let raster = Raster::new(size, (1, 1), 0.5).expect("a raster");
    let triangles =
        triangles.iter().filter_map(|vertices| Some(Triangle::new(*vertices, &raster)?.0)).collect();
    View { raster, triangles }
}

/// Returns random triangles before the eye, with sides of up to `side`; most of them pierce each other.
pub(crate) fn random(seed: u64, count: usize, side: i64) -> Vec<[Vector; 3]> {
    let mut rng = Rng::with_seed(seed);
    let mut triangle = || {
        let z = rng.i64(1000..65_000);
        let middle = [rng.i64(-z..=z), rng.i64(-z..=z), z];
        [0; 3].map(|_| {
            let [x, y, z] = middle.map(|c| (c + rng.i64(-side..=side) / 2).clamp(-65_535, 65_535));
            [x, y, z.max(1)]
        })
    };
    (0..count).map(|_| triangle()).collect()
}

/// Returns `layers` triangles that cover the whole picture, one behind the other, from the nearest.
pub(crate) fn layers(layers: i64) -> Vec<[Vector; 3]> {
    (0..layers)
        .map(|layer| 1000 + 20 * layer)
        .map(|z| [[-3 * z, -z, z], [3 * z, -z, z], [0, 3 * z, z]])
        .collect()
}

/// Three bars of which each is before the next and behind the one before it.
pub(crate) fn ring() -> Vec<[Vector; 3]> {
    let bar = |turn: usize| {
        // A third of a turn each: (x, y) to (-(x + 87 y / 50) / 2, ...) in whole numbers.
        let (cos, sin) = [(1000, 0), (-500, 866), (-500, -866)][turn];
        [(-900, -495, 1400), (700, -420, 700), (700, -120, 700)].map(|(x, y, z)| {
            let (x, y) = ((cos * x - sin * y) / 1000, (sin * x + cos * y) / 1000);
            // Perspective takes none of it away.
            [x * z / 1000, y * z / 1000, z]
        })
    };
    (0..3).map(bar).collect()
}

/// A bent sheet of `2 side^2` triangles that share edges and fill the picture.
pub(crate) fn sheet(side: i64) -> Vec<[Vector; 3]> {
    let vertex = |i: i64, j: i64| {
        let z = 20_000 + 53 * ((i * i + 3 * j * j + 7 * i * j) % 97);
        // One place more than the picture on all sides.
        let place = |c: i64| (2 * c - side) * z * 11 / (10 * side);
        [place(i), place(j), z]
    };
    let cells = (0..side).flat_map(|j| (0..side).map(move |i| (i, j)));
    let pair = |(i, j): (i64, i64)| {
        let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
        [[a, b, c], [a, c, d]]
    };
    cells.flat_map(pair).collect()
}
