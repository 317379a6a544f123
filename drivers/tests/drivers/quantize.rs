//! Colour tables, held against plain searches over the colours of each device.

use std::collections::HashMap;

use rta_core::color::Rgb;
use rta_drivers::display::expand;
use rta_drivers::quantize::{Adaptive, BACKGROUND, ColorTable, TableError, Uniform, distance, nearest};

use crate::scattered;

/// Every colour whose three levels are multiples of `step` within 0..=`max`.
fn every(max: u8, step: usize) -> impl Iterator<Item = Rgb<u8>> {
    let levels = move || (0..=max).step_by(step);
    levels().flat_map(move |r| levels().flat_map(move |g| levels().map(move |b| Rgb::new(r, g, b))))
}

#[test]
fn sizes_are_what_the_documentation_says() {
    assert_eq!(size_of::<Adaptive>(), 1804);
    assert_eq!(size_of::<Uniform>(), 771);
}

#[test]
fn uniform_cubes_have_the_sides_expected() {
    for (colors, max, sides) in [
        (256, 63, (6, 7, 6)),
        (256, 255, (6, 7, 6)),
        (128, 15, (5, 5, 5)),
        (8, 15, (2, 2, 2)),
        (11, 15, (2, 2, 2)),
        (12, 15, (2, 3, 2)),
        (16, 15, (2, 3, 2)),
        (18, 15, (3, 3, 2)),
        (27, 15, (3, 3, 3)),
        (256, 1, (2, 2, 2)),
        (256, 3, (4, 4, 4)),
    ] {
        let table = Uniform::new(colors, max).unwrap();
        assert_eq!(table.sides(), Rgb::new(sides.0, sides.1, sides.2), "{colors} colours, guns to {max}");
        let entries = table.entries();
        assert_eq!(entries.len(), usize::from(sides.0) * usize::from(sides.1) * usize::from(sides.2));
        assert_eq!((entries[0], entries[entries.len() - 1]), (BACKGROUND, Rgb::new(max, max, max)));
        let unique: std::collections::HashSet<_> = entries.iter().collect();
        assert_eq!(unique.len(), entries.len());
    }
    assert_eq!(Uniform::new(7, 63).unwrap_err(), TableError::Colors { colors: 7, min: 8 });
    assert_eq!(Uniform::new(257, 63).unwrap_err(), TableError::Colors { colors: 257, min: 8 });
    assert_eq!(Uniform::new(256, 0).unwrap_err(), TableError::Guns);
}

#[test]
fn uniform_gives_the_nearest_entry_of_every_color() {
    for (colors, max, step) in [(256, 63, 3), (256, 63, 7), (128, 15, 1), (256, 255, 9), (20, 15, 1)] {
        let mut table = Uniform::new(colors, max).unwrap();
        let entries = table.entries().to_vec();
        for levels in every(max, step) {
            let index = table.index(levels);
            let (best, d) = nearest(&entries, levels);
            assert_eq!((index, distance(entries[usize::from(index)], levels)), (best, d), "{levels:?}");
        }
        for (index, &entry) in entries.iter().enumerate() {
            assert_eq!(usize::from(table.index(entry)), index);
        }
    }
}

/// The thesis's colour table in its plainest form: every colour is searched for in all entries.
struct Plain {
    entries: Vec<Rgb<u8>>,
    colors: usize,
    tolerance: u32,
}

impl Plain {
    fn index(&mut self, levels: Rgb<u8>) -> u8 {
        let best = (0..self.entries.len()).min_by_key(|&i| distance(self.entries[i], levels)).unwrap();
        if self.entries.len() < self.colors && distance(self.entries[best], levels) > self.tolerance {
            self.entries.push(levels);
            return u8::try_from(self.entries.len() - 1).unwrap();
        }
        u8::try_from(best).unwrap()
    }
}

#[test]
fn adaptive_agrees_with_the_plain_table() {
    for (colors, max, tolerance) in
        [(256, 63, 0), (128, 15, 0), (256, 255, 0), (256, 63, 30), (128, 15, 9), (1, 63, 0), (2, 63, 5)]
    {
        let mut table = Adaptive::new(colors).unwrap().with_tolerance(tolerance);
        let mut plain = Plain { entries: vec![BACKGROUND], colors: colors.into(), tolerance };
        // A sky of repeated neighbours, scattered colours twice over, then an even grid of all colours.
        let scattered = scattered(1500, max);
        let sky = (0..=max).flat_map(|g| [Rgb::new(0, g, max); 3]);
        let all = sky.chain(scattered.iter().copied()).chain(scattered.iter().rev().copied());
        for levels in all.chain(every(max, usize::from(max / 15))) {
            assert_eq!(table.index(levels), plain.index(levels), "{levels:?}, tolerance {tolerance}");
            assert_eq!(table.entries().len(), plain.entries.len());
        }
        assert_eq!(table.entries(), plain.entries);
    }
}

#[test]
fn adaptive_is_exact_while_there_is_room_and_nearest_after() {
    let mut table = Adaptive::new(256).unwrap();
    assert_eq!(table.entries(), [BACKGROUND]);
    let mut seen = HashMap::from([(BACKGROUND, 0_u8)]);
    for levels in scattered(4000, 63) {
        let before = table.entries().to_vec();
        let index = table.index(levels);
        // Old entries stay as they are; at most one is appended.
        assert_eq!(table.entries()[..before.len()], before);
        if let Some(&old) = seen.get(&levels) {
            assert_eq!(index, old);
            assert_eq!(table.entries().len(), before.len());
        } else if before.len() < 256 {
            assert_eq!(usize::from(index), before.len());
            assert_eq!(table.entries()[usize::from(index)], levels);
            seen.insert(levels, index);
        } else {
            assert_eq!(index, nearest(&before, levels).0);
        }
    }
    assert_eq!(table.entries().len(), 256);
}

#[test]
fn tolerance_leaves_room_below_a_smooth_sky() {
    let sky =
        || (0..4096_u32).map(|i| Rgb::new(u8::try_from(i / 64).unwrap(), 63, u8::try_from(i % 64).unwrap()));
    let entries = |tolerance| {
        let mut table = Adaptive::new(256).unwrap().with_tolerance(tolerance);
        sky().for_each(|levels| {
            let index = table.index(levels);
            let full = table.entries().len() == 256;
            assert!(full || distance(table.entries()[usize::from(index)], levels) <= tolerance);
        });
        table.entries().len()
    };
    assert_eq!(entries(0), 256);
    assert!(entries(50) < 200, "{}", entries(50));
}

#[test]
fn ties_go_to_the_lowest_index() {
    let entries = [Rgb::new(0, 0, 0), Rgb::new(4, 0, 0), Rgb::new(0, 4, 0), Rgb::new(4, 0, 0)];
    assert_eq!(nearest(&entries, Rgb::new(2, 0, 0)), (0, 4));
    assert_eq!(nearest(&entries, Rgb::new(4, 4, 0)), (1, 16));
    assert_eq!(nearest(&entries, Rgb::new(4, 0, 0)), (1, 0));
    assert_eq!(nearest(&[], Rgb::new(4, 0, 0)), (0, u32::MAX));
    assert_eq!(distance(Rgb::new(0, 255, 0), Rgb::new(255, 0, 255)), 195_075);
    for colors in [0, 257, u16::MAX] {
        assert_eq!(Adaptive::new(colors).unwrap_err(), TableError::Colors { colors, min: 1 });
    }
}

#[test]
fn expansion_is_linear_and_rounded() {
    for max in 1..=255_u8 {
        let mut last = None;
        for level in 0..=max {
            let exact = 255.0 * f64::from(level) / f64::from(max);
            let got = expand(level, max);
            assert!((f64::from(got) - exact).abs() <= 0.5, "{level} of {max}: {got}");
            assert!(last < Some(got));
            last = Some(got);
        }
        assert_eq!((expand(0, max), expand(max, max)), (0, 255));
    }
    assert_eq!(expand(200, 63), 255);
}
