//! What holds of all algorithms.
#![allow(clippy::indexing_slicing, clippy::cast_possible_truncation, reason = "a test may panic")]

use fastrand::Rng;

use rta_scenes::shipped;

use super::comparison::{Apart, Comparison};
use super::eye::Seen;
use super::faces::Faces;
use super::integer::{Cover, View};
use super::outcome::Outcome;
use super::samples::{layers, random, ring, sheet, view};
use super::scanplane::distance;
use super::{casting, page, painter, scanline, scanplane, subdivision, zbuffer};
use crate::picture::raster::Size;

/// Returns the picture that all algorithms agree on, byte for byte, but for the continuous one, whose samples may differ within 1e-9 of an edge.
fn agreed(view: &View) -> Vec<u32> {
    let truth = casting::exhaustive(view).expect("few").ids;
    let all = [
        casting::by_hierarchy,
        zbuffer::whole,
        zbuffer::banded,
        painter::painted,
        scanline::scanned,
        subdivision::subdivided,
    ];
    for (place, run) in all.into_iter().enumerate() {
        assert!(run(view).expect("few").ids == truth, "{place}");
    }
    let Outcome { ids, areas, .. } = scanplane::swept(view).expect("few");
    let width = view.raster.size.width();
    for (place, (own, truth)) in (0..).zip(ids.iter().zip(&truth)).filter(|(_, (own, truth))| own != truth) {
        let ray = view.raster.ray(place % width, place / width);
        let [own, truth] = [*own, *truth].map(|id| view.triangle(id));
        let far =
            [(own, truth), (truth, own)].map(|(one, other)| one.map_or(1.0, |one| distance(one, other, ray)));
        assert!(far[0].min(far[1]) < 1e-9, "{place}: {own:?} {truth:?} {far:?}");
    }
    // Pixels are samples of areas.
    let seen = truth.iter().filter(|id| **id != 0).count() as f64 / truth.len() as f64;
    let area = areas.expect("areas").iter().sum::<f64>();
    assert!((area - seen).abs() < 2.0 / f64::from(width), "{area} {seen}");
    truth
}

#[test]
fn the_scenes_of_the_program_agree() {
    for (name, text) in shipped::FILES {
        let scene = rta_scenes::read(text.as_bytes(), name).expect("a scene");
        let faces = Faces::new(&scene, 3);
        let raster = (Size::new(40, 30).expect("a size"), 4.0 / 3.0);
        let seen = Seen::new(&faces.all, &scene.camera, raster, 0.0).expect("it is seen");
        let comparison = Comparison::new(&seen.view);
        assert!(
            comparison.ids.iter().any(|id| *id != 0)
                && comparison.is_equal()
                && comparison.runs.iter().all(|(_, run)| run.is_ok()),
            "{name}"
        );
    }
}

#[test]
fn random_triangles_agree() {
    for seed in 0..3 {
        agreed(&view((61, 47), &random(seed, 100, 30_000)));
        agreed(&view((61, 47), &random(seed, 300, 3_000)));
    }
}

#[test]
fn triangles_without_an_order_are_cut() {
    let view = view((64, 64), &ring());
    let ids = agreed(&view);
    assert!((1..=3).all(|id| ids.contains(&id)));
    // Each of the three is before the next where they overlap.
    for (near, far) in [(1, 2), (2, 3), (3, 1)] {
        let both = |place: &u32| {
            let ray = view.raster.ray(place % 64, place / 64);
            [near, far].iter().all(|id| view.triangle(*id).is_some_and(|own| own.cover(ray) == Cover::Inside))
        };
        let common: Vec<_> = (0..64 * 64).filter(both).collect();
        assert!(
            !common.is_empty() && common.iter().all(|place| ids[*place as usize] == near),
            "{near} {far}"
        );
    }
    let counts = painter::painted(&view).expect("few").counts;
    assert!(counts.of("splits") >= Some(1) && counts.of("compares") == Some(0), "{counts}");
}

#[test]
fn a_pair_that_pierces_agrees() {
    let view = view(
        (50, 40),
        &[
            [[-900, -900, 800], [900, -800, 1600], [0, 900, 1200]],
            [[-900, 700, 1500], [800, 900, 700], [100, -900, 1150]],
        ],
    );
    let ids = agreed(&view);
    assert!([1, 2].iter().all(|id| ids.iter().filter(|own| *own == id).count() > 100));
    assert_eq!(painter::painted(&view).expect("few").counts.of("splits"), Some(1));
    assert_eq!(scanplane::swept(&view).expect("few").counts.of("piercing"), Some(1));
}

#[test]
fn shared_edges_are_covered_once() {
    let view = view((101, 83), &sheet(71));
    assert_eq!(view.triangles.len(), 2 * 71 * 71);
    let outcome = zbuffer::whole(&view).expect("few");
    assert!(outcome.ids.iter().all(|id| *id != 0));
    assert_eq!(outcome.counts.of("compares"), Some(101 * 83));
    assert_eq!(outcome.counts.of("writes"), Some(101 * 83));
    agreed(&super::samples::view((33, 31), &sheet(24)));
}

#[test]
fn the_buffer_is_written_as_often_as_records_are_set() {
    // The nearest so far is a record: of n in random order there are H(n), with the variance H(n) minus the sum of 1/k^2.
    let mut rng = Rng::with_seed(1);
    for (n, mean, seeds) in [
        (4, 2.083_333_333, 4000),
        (10, 2.928_968_254, 4000),
        (22, 3.690_813_250, 4000),
        (1000, 7.485_470_861, 300),
    ] {
        let view = view((1, 1), &layers(n));
        assert_eq!(view.triangles.len(), n as usize);
        let mut order: Vec<_> = (1..=n as usize).collect();
        let writes: Vec<_> = (0..seeds)
            .map(|_| {
                rng.shuffle(&mut order);
                zbuffer::buffered(&view, order.iter().copied(), 1).counts.of("writes").expect("a count")
                    as f64
            })
            .collect();
        let got = writes.iter().sum::<f64>() / f64::from(seeds);
        let variance: f64 = (1..=n).map(|k| 1.0 / k as f64 - 1.0 / (k * k) as f64).sum();
        // Five standard errors.
        assert!((got - mean).abs() < 5.0 * (variance / f64::from(seeds)).sqrt(), "{n}: {got}");
        if n == 22 {
            assert!((variance.sqrt() - 1.445_792_626).abs() < 1e-9);
            let spread =
                (writes.iter().map(|own| (own - got).powi(2)).sum::<f64>() / f64::from(seeds - 1)).sqrt();
            assert!((spread - 1.445_792_626).abs() < 0.08, "{spread}");
        }
    }
}

#[test]
fn the_order_decides_what_is_written() {
    let (view, pixels) = (view((5, 3), &layers(22)), 15);
    let writes = |outcome: Outcome| (outcome.counts.of("writes"), outcome.ids.iter().all(|id| *id == 1));
    assert_eq!(writes(zbuffer::buffered(&view, 1..=22, 3)), (Some(pixels), true));
    assert_eq!(writes(zbuffer::buffered(&view, (1..=22).rev(), 3)), (Some(22 * pixels), true));
    let painted = painter::painted(&view).expect("few");
    assert_eq!(painted.counts.of("splits"), Some(0));
    assert_eq!(writes(painted), (Some(22 * pixels), true));
}

#[test]
fn bands_of_a_row_compare_as_often_as_one_buffer() {
    for seed in 0..3 {
        let view = view((40, 31), &random(seed, 200, 20_000));
        let [whole, banded] = [zbuffer::whole, zbuffer::banded].map(|run| run(&view).expect("few"));
        for name in ["tests", "compares", "writes"] {
            assert_eq!(whole.counts.of(name), banded.counts.of(name), "{name}");
        }
        assert_eq!((whole.bytes, banded.bytes), (4 * 40 * 31, 4 * 40));
        // A scan-line covers the same pixels, and compares less, since a span is one.
        let scanned = scanline::scanned(&view).expect("few").counts;
        assert_eq!(scanned.of("covered"), whole.counts.of("compares"));
        assert_eq!(
            casting::exhaustive(&view).expect("few").counts.of("compares"),
            whole.counts.of("compares")
        );
    }
}

#[test]
fn of_equal_depths_the_lower_number_is_seen() {
    // The same square thrice, cut along both diagonals, and one more that begins in the middle of a pixel.
    let corners = [[-700, -700, 1000], [700, -700, 1000], [700, 700, 1000], [-700, 700, 1000]];
    let [a, b, c, d] = corners;
    let small = [[0, 0, 1000], [700, 0, 1000], [0, 700, 1000]];
    let twice = small.map(|vertex| vertex.map(|c| 2 * c));
    for all in
        [[[a, b, c], [a, c, d], [a, b, d], [b, c, d], small], [small, [b, c, d], [a, b, d], twice, [a, b, c]]]
    {
        let view = view((9, 9), &all);
        let ids = agreed(&view);
        let lowest = |place: usize| {
            let ray = view.raster.ray(place as u32 % 9, place as u32 / 9);
            view.each().find(|(_, own)| own.cover(ray) != Cover::Outside).map_or(0, |(id, _)| id)
        };
        assert_eq!(ids, (0..81).map(lowest).collect::<Vec<_>>());
    }
}

#[test]
fn corners_that_touch_a_face_agree() {
    // The corner of a tent on a wall, at the middle of a pixel, seen with either number first; and its ridge in the wall's plane.
    let wall = [[-2000, -2000, 1000], [2000, -2000, 1000], [0, 3000, 1000]];
    let behind = [[0, 0, 1000], [400, 100, 1500], [100, 400, 1500]];
    let ridge = [[-500, 0, 1000], [500, 0, 1000], [0, 900, 1800]];
    let before = [[0, 0, 1000], [300, 100, 800], [100, 300, 800]];
    for own in [behind, ridge, before] {
        for all in [[wall, own], [own, wall]] {
            agreed(&view((9, 9), &all));
        }
    }
}

#[test]
fn nothing_and_little_are_drawn() {
    for size in [(1, 1), (1, 9), (9, 1), (3, 2)] {
        assert!(agreed(&view(size, &[])).iter().all(|id| *id == 0));
        agreed(&view(size, &layers(3)));
        agreed(&view(size, &random(5, 40, 40_000)));
    }
    // Degenerate, on edge, and behind the eye.
    let none = [
        [[0, 0, 5]; 3],
        [[0, 0, 5], [1, 1, 6], [2, 2, 7]],
        [[0, 0, 5], [0, 5, 5], [0, 5, 9]],
        [[0, 0, -5], [5, 0, -5], [0, 5, -5]],
    ];
    assert!(view((4, 4), &none).triangles.is_empty());
}

#[test]
fn one_other_id_is_told() {
    let comparison = Comparison::new(&view((16, 16), &ring()));
    let told = |number: usize, apart| {
        let mut comparison = comparison.clone();
        let run = comparison.runs[number].1.as_mut().expect("it is run");
        run.apart = apart;
        let text = page::comparison(&comparison);
        assert_eq!(text.ends_with("all ids are equal\n"), comparison.is_equal());
        (comparison.is_equal(), text.matches("DIFFER").count())
    };
    let last = comparison.runs.len() - 1;
    let (at_edge, elsewhere) = (Apart { at_edges: 1, elsewhere: 0 }, Apart { at_edges: 0, elsewhere: 1 });
    assert_eq!(
        [told(2, Apart::default()), told(2, at_edge), told(2, elsewhere)],
        [(true, 0), (false, 2), (false, 2)]
    );
    // Only what rounds may differ at edges.
    assert_eq!([told(last, at_edge), told(last, elsewhere)], [(true, 0), (false, 2)]);
}
