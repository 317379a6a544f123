//! Palettes, held against plain searches, and the way they are made from samples.

use std::collections::HashSet;

use rta_core::color::Rgb;
use rta_drivers::display::{expand, reduce};
use rta_drivers::quantize::{
    BACKGROUND, ColorTable, MAX_SAMPLES, Palette, TableError, distance, nearest, refined, variance_cut,
};

use crate::scattered;

const BLACK: Rgb<u8> = Rgb::new(0, 0, 0);

fn made(samples: &[Rgb<u8>], width: u32, colors: u16, gun_max: u8) -> Palette {
    let mut memory = vec![BLACK; samples.len()];
    variance_cut(&mut memory, samples.iter().copied(), width, colors, gun_max).expect("a palette")
}

/// The sum of the squared distances of colours from the entries that stand for them.
fn error(palette: &Palette, colors: &[Rgb<u8>]) -> u64 {
    let entry = |color| palette.entries()[usize::from(palette.nearest(color))];
    colors.iter().map(|&color| u64::from(distance(entry(color), color))).sum()
}

#[test]
fn a_palette_takes_what_the_documentation_says() {
    // 840 on a processor of 32 bits.
    assert_eq!(size_of::<Palette>(), 768 + 64 + 2 * size_of::<usize>());
}

#[test]
fn the_entry_found_is_the_nearest_and_of_equal_ones_the_first() {
    for (count, gun_max) in [(0, 63), (1, 255), (7, 15), (100, 3), (127, 15), (255, 63), (255, 255)] {
        let palette = Palette::new(&scattered(count, gun_max), gun_max).expect("a palette");
        let grays = (0..=255).map(|level| Rgb::new(level, level, level));
        for color in scattered(20_000, 255).into_iter().chain(grays) {
            assert_eq!(palette.nearest(color), nearest(palette.entries(), color).0, "{count}: {color:?}");
        }
    }
    // All the sums are equal, and so are the distances of two.
    let level = [Rgb::new(40, 0, 0), Rgb::new(0, 20, 0), Rgb::new(0, 0, 40), Rgb::new(20, 0, 20)];
    let palette = Palette::new(&level, 255).expect("a palette");
    for color in scattered(20_000, 50) {
        assert_eq!(palette.nearest(color), nearest(palette.entries(), color).0, "{color:?}");
    }
}

#[test]
fn entries_are_black_and_each_colour_once() {
    let colors = [Rgb::new(63, 0, 0), BLACK, Rgb::new(1, 2, 3), Rgb::new(63, 0, 0), Rgb::new(99, 0, 0)];
    let palette = Palette::new(&colors, 63).expect("a palette");
    assert_eq!(palette.entries(), [BACKGROUND, Rgb::new(4, 8, 12), Rgb::new(255, 0, 0)]);
    let levels: Vec<_> = palette.levels(63).collect();
    assert_eq!(levels, [BACKGROUND, Rgb::new(1, 2, 3), Rgb::new(63, 0, 0)]);
    assert_eq!(Palette::new(&colors, 0).unwrap_err(), TableError::Guns);
    let grays: Vec<_> = (0..=255).map(|level| Rgb::new(level, level, level)).collect();
    assert_eq!(Palette::new(&grays, 255).expect("256 with black").entries().len(), 256);
    let one_more: Vec<_> = grays.into_iter().chain([Rgb::new(1, 0, 0)]).collect();
    assert_eq!(Palette::new(&one_more, 255).unwrap_err(), TableError::Colors { colors: 257, min: 1 });
}

#[test]
fn levels_and_light_convert_both_ways() {
    for max in 1..=255 {
        assert!((0..=max).all(|level| reduce(expand(level, max), max) == level), "{max}");
        for light in 0..=255_u8 {
            let error = i32::from(reduce(light, max)) * 510 - i32::from(light) * 2 * i32::from(max);
            assert!(error.abs() <= 255, "{light} of {max}");
        }
    }
}

#[test]
fn few_colours_are_all_kept() {
    let colors: Vec<_> =
        scattered(100, 63).iter().map(|color| color.map(|level| expand(level, 63))).collect();
    let samples: Vec<_> = colors.iter().copied().cycle().take(4096).collect();
    let palette = made(&samples, 64, 256, 63);
    let kept: HashSet<_> = palette.entries().iter().copied().collect();
    assert!(colors.iter().all(|color| kept.contains(color)));
    assert_eq!(palette.entries().len(), colors.iter().chain([&BLACK]).collect::<HashSet<_>>().len());
}

#[test]
fn a_cut_goes_where_most_of_the_spread_is() {
    // Two heaps of greens and one far red: black, and three entries, are the means of the three.
    let (low, high, red) = ([10, 12, 14], [200, 202, 204], Rgb::new(250, 0, 0));
    let greens = low.iter().chain(&high).map(|&g| Rgb::new(0, g, 0));
    let samples: Vec<_> = greens.cycle().take(60).chain([red; 9]).collect();
    let palette = made(&samples, 69, 4, 255);
    assert_eq!(palette.entries(), [BACKGROUND, Rgb::new(0, 12, 0), red, Rgb::new(0, 202, 0)]);
}

#[test]
fn more_entries_lose_less_and_the_order_of_samples_does_not_matter() {
    let samples = scattered(4096, 255);
    let mut errors = Vec::new();
    for colors in [2, 4, 16, 64, 256] {
        let palette = made(&samples, 64, colors, 255);
        assert!(palette.entries().len() <= usize::from(colors));
        let backward: Vec<_> = samples.iter().rev().copied().collect();
        assert_eq!(palette.entries(), made(&backward, 64, colors, 255).entries());
        errors.push(error(&palette, &samples));
    }
    assert!(errors.windows(2).all(|pair| pair[1] < pair[0]), "{errors:?}");
    // A cube of 6 x 7 x 6 is not far from the best for colours that are everywhere.
    let uniform = 3.0 * (255.0_f64 / 6.0).powi(2) / 12.0 * 4096.0;
    assert!((errors[4] as f64) < 1.3 * uniform, "{errors:?}, {uniform}");
}

#[test]
fn many_samples_do_not_overflow() {
    let samples: Vec<_> = (0..MAX_SAMPLES)
        .map(|i| if i % 2 == 0 { Rgb::new(255, 255, 255) } else { Rgb::new(254, 0, 255) })
        .collect();
    let palette = made(&samples, 1024, 256, 255);
    assert_eq!(palette.entries(), [BACKGROUND, Rgb::new(254, 0, 255), Rgb::new(255, 255, 255)]);
}

#[test]
fn a_sky_between_two_levels_gets_both() {
    // 100 is between the levels 5 (85) and 6 (102) of 15.
    let sky = [Rgb::new(100, 100, 100); 4096];
    let palette = made(&sky, 64, 128, 15);
    for level in [85, 102] {
        assert!(palette.entries().contains(&Rgb::new(level, level, level)), "{:?}", palette.entries());
    }
}

#[test]
fn refined_entries_are_the_means_of_their_samples() {
    let gray = |level| Rgb::new(level, level, level);
    let light = |level| gray(expand(level, 63));
    let samples = [[light(10); 3], [light(14); 3], [light(60); 3]].concat();
    let mut memory = [BLACK; 9];
    let mut refine =
        |palette| refined(palette, &mut memory, samples.iter().copied(), 3, 63).expect("a palette");
    let got = refine(Palette::new(&[gray(20), gray(40)], 63).expect("a palette"));
    assert_eq!(got.levels(63).collect::<Vec<_>>(), [gray(0), gray(12), gray(60)]);
    assert_eq!(refine(got.clone()).entries(), got.entries());
    // An entry without samples stays where it is.
    let got = refine(Palette::new(&[gray(12), gray(60), gray(63)], 63).expect("a palette"));
    assert_eq!(got.levels(63).collect::<Vec<_>>(), [gray(0), gray(12), gray(60), gray(63)]);
}

#[test]
fn a_refined_palette_is_nearer_to_the_samples_whatever_their_order() {
    for (colors, gun_max) in [(16, 255), (128, 63), (256, 255)] {
        let samples = scattered(4096, 255);
        let begin = made(&samples, 64, colors, gun_max);
        let refine = |light: &mut dyn Iterator<Item = Rgb<u8>>| {
            refined(begin.clone(), &mut vec![BLACK; 4096], light, 64, gun_max).expect("a palette")
        };
        let got = refine(&mut samples.iter().copied());
        assert!(error(&got, &samples) < error(&begin, &samples), "{colors}");
        assert_eq!(got.entries(), refine(&mut samples.iter().rev().copied()).entries());
    }
    let none = Palette::new(&[], 63).expect("black");
    assert_eq!(refined(none, &mut [], [], 1, 63).unwrap_err(), TableError::Samples { samples: 0 });
}

#[test]
fn what_makes_no_palette_is_an_error() {
    let sample = [Rgb::new(1, 2, 3)];
    let cut = |memory: &mut [Rgb<u8>], colors, gun_max| {
        variance_cut(memory, sample, 1, colors, gun_max).map(|palette| palette.entries().len())
    };
    assert_eq!(cut(&mut [BLACK], 2, 63), Ok(2));
    assert_eq!(cut(&mut [BLACK], 1, 63), Err(TableError::Colors { colors: 1, min: 2 }));
    assert_eq!(cut(&mut [BLACK], 257, 63), Err(TableError::Colors { colors: 257, min: 2 }));
    assert_eq!(cut(&mut [BLACK], 2, 0), Err(TableError::Guns));
    assert_eq!(cut(&mut [], 2, 63), Err(TableError::Samples { samples: 0 }));
    let many = core::iter::repeat_n(BLACK, MAX_SAMPLES + 1);
    let error = variance_cut(&mut vec![BLACK; MAX_SAMPLES + 1], many, 1, 2, 63).unwrap_err();
    assert_eq!(error, TableError::Samples { samples: MAX_SAMPLES + 1 });
}
