//! Dithering, held against what its papers say of it.

use rta_core::color::Rgb;
use rta_drivers::display::{Display, ReadBack, expand};
use rta_drivers::dither::{
    Cell, Damped, Diffusion, Dither, DitherError, FloydSteinberg, Ordered, Plain, bayer, ordered,
};
use rta_drivers::graphigs::{GraphigsDisplay, emulated};
use rta_drivers::painter::Painter;
use rta_drivers::quantize::{Adaptive, ColorTable, Palette, Uniform, nearest};

use crate::scattered;

/// Draws rows of light of 8 bits and returns the colours that are shown, 8 bits a gun.
fn shown(
    mut table: impl ColorTable,
    mut dither: impl Dither,
    gun_max: u8,
    rows: &[Vec<Rgb<u8>>],
) -> Vec<Vec<Rgb<u8>>> {
    let most = table.light_max(gun_max);
    let draw = |(y, row): (u32, &Vec<Rgb<u8>>)| {
        let leftward = dither.start_row(5, y, row.len());
        let mut places: Vec<_> = (0..row.len()).collect();
        if leftward {
            places.reverse();
        }
        let mut drawn = vec![Rgb::new(0, 0, 0); row.len()];
        for x in places {
            let index = dither.index(&mut table, gun_max, (5 + u32::try_from(x).unwrap(), y), row[x]);
            drawn[x] = table.entries()[usize::from(index)].map(|level| expand(level, most));
        }
        drawn
    };
    (7..).zip(rows).map(draw).collect()
}

pub(crate) fn gray(level: u8) -> Rgb<u8> {
    Rgb::new(level, level, level)
}

/// Error diffusion as a whole picture of wide numbers, each sum of errors cut to 8 bits as it goes down a row.
pub(crate) fn diffused(table: &Palette, weights: [i32; 4], rows: &[Vec<Rgb<u8>>]) -> Vec<Vec<Rgb<u8>>> {
    let width = rows[0].len();
    let [ahead, behind, below_ahead, sum] = weights;
    let mut down = vec![[0_i32; 3]; width + 2];
    let mut drawn = Vec::new();
    for (y, row) in rows.iter().enumerate() {
        let mut next = vec![[0_i32; 3]; width + 2];
        let mut side = [0; 3];
        let mut out = vec![Rgb::new(0, 0, 0); width];
        let step: isize = if y % 2 == 0 { 1 } else { -1 };
        for i in 0..width {
            let x = if step > 0 { i } else { width - 1 - i };
            let light = [row[x].r, row[x].g, row[x].b];
            let wanted: Vec<u8> = (0..3)
                .map(|gun| (i32::from(light[gun]) + down[x + 1][gun] + side[gun]).clamp(0, 255) as u8)
                .collect();
            let entry = table.entries()
                [usize::from(nearest(table.entries(), Rgb::new(wanted[0], wanted[1], wanted[2])).0)];
            out[x] = entry;
            let at = |offset: isize| (x as isize + 1 + offset) as usize;
            for (gun, shown) in [entry.r, entry.g, entry.b].into_iter().enumerate() {
                let lost = i32::from(wanted[gun]) - i32::from(shown);
                let part = |weight: i32| (weight * lost).div_euclid(16);
                side[gun] = part(ahead);
                next[at(-step)][gun] += part(behind);
                next[at(step)][gun] += part(below_ahead);
                next[at(0)][gun] += part(sum) - part(ahead) - part(behind) - part(below_ahead);
            }
        }
        drawn.push(out);
        down = next.iter().map(|error| error.map(|error| error.clamp(-128, 127))).collect();
    }
    drawn
}

#[test]
fn diffusion_is_that_of_the_papers() {
    let table = Palette::new(&scattered(200, 63), 63).unwrap();
    let rows: Vec<Vec<_>> = scattered(23 * 9, 255).chunks(23).map(<[_]>::to_vec).collect();
    let cells = [Cell::default(); 30];
    let dither = Diffusion::<FloydSteinberg, _>::new(cells, 23).unwrap();
    assert_eq!(shown(table.clone(), dither, 63, &rows), diffused(&table, [7, 3, 1, 16], &rows));
    let dither = Diffusion::<Damped, _>::new(cells, 23).unwrap();
    assert_eq!(shown(table.clone(), dither, 63, &rows), diffused(&table, [6, 3, 1, 14], &rows));
}

#[test]
fn diffusion_keeps_the_mean() {
    let (width, height) = (64, 64);
    for level in [3_u8, 50, 100, 127, 200, 252] {
        let rows = vec![vec![gray(level); width]; height];
        let table = Uniform::new(8, 255).unwrap();
        let dither = Diffusion::<FloydSteinberg, _>::new(vec![Cell::default(); width], width).unwrap();
        let sum: u32 =
            shown(table, dither, 255, &rows).iter().flatten().map(|color| u32::from(color.g)).sum();
        let mean = f64::from(sum) / (width * height) as f64;
        assert!((mean - f64::from(level)).abs() < 2.5, "{level}: {mean}");
    }
}

#[test]
fn diffusion_begins_anew_where_a_row_does_not_follow() {
    let row = scattered(16, 255);
    let table = Palette::new(&scattered(20, 63), 63).unwrap();
    let mut dither = Diffusion::<Damped, _>::new([Cell::default(); 16], 16).unwrap();
    let mut draw = |x, y| {
        let leftward = dither.start_row(x, y, row.len());
        let mut indices: Vec<u8> = Vec::new();
        for i in 0..16 {
            let i = if leftward { 15 - i } else { i };
            indices.push(dither.index(&mut &table, 63, (x + i, y), row[i as usize]));
        }
        (leftward, indices)
    };
    let first = draw(3, 7);
    assert!(!first.0);
    let second = draw(3, 8);
    assert!(second.0);
    assert_ne!(second.1.iter().rev().copied().collect::<Vec<_>>(), first.1);
    for (x, y) in [(3, 8), (3, 20), (4, 21), (4, 0)] {
        assert_eq!(draw(x, y), first, "{x}, {y}");
    }
}

#[test]
fn memory_for_less_than_a_row_is_refused() {
    assert_eq!(
        Diffusion::<Damped, _>::new([Cell::default(); 319], 320).err(),
        Some(DitherError { memory: 319, width: 320 })
    );
    assert_eq!(size_of::<[Cell; 320]>(), 1280);
}

#[test]
fn the_pattern_has_each_place_once_and_fills_evenly() {
    let places: Vec<_> = (0..64).map(|i| bayer(i % 8, i / 8)).collect();
    let mut sorted = places.clone();
    sorted.sort_unstable();
    assert!(sorted.iter().copied().eq(0..64));
    // Its first row, as it is printed.
    assert_eq!(places[..8], [0, 32, 8, 40, 2, 34, 10, 42]);
    assert_eq!(bayer(8 + 3, 16 + 5), bayer(3, 5));
    // Of each 2 x 2 pixels one is in each quarter of the order.
    for (x, y) in [(0, 0), (2, 4), (6, 6)] {
        let mut quarters = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(i, j)| bayer(x + i, y + j) / 16);
        quarters.sort_unstable();
        assert_eq!(quarters, [0, 1, 2, 3]);
    }
}

#[test]
fn ordered_dithering_mixes_neighbouring_levels_in_proportion() {
    for (colors, gun_max) in [(256, 63), (128, 15), (8, 255)] {
        let table = Uniform::new(colors, gun_max).unwrap();
        for level in [0_u8, 20, 77, 128, 199, 255] {
            let rows = vec![vec![gray(level); 16]; 16];
            let drawn = shown(table.clone(), Ordered::uniform(&table), gun_max, &rows);
            let mean = drawn.iter().flatten().map(|color| f64::from(color.r)).sum::<f64>() / 256.0;
            let distinct: std::collections::HashSet<_> =
                drawn.iter().flatten().map(|color| color.r).collect();
            assert!((mean - f64::from(level)).abs() < 6.0, "{colors} {level}: {mean}");
            assert!(distinct.len() <= 2);
        }
    }
}

#[test]
fn a_step_of_nothing_moves_nothing() {
    assert_eq!(ordered(gray(100), 3, 2, gray(0)), gray(100));
}

#[test]
fn a_table_that_grows_grows_by_the_pictures_own_colours() {
    let row: Vec<_> = (0..200).map(|i| gray(i / 2)).collect();
    let mut table = Adaptive::new(32).unwrap();
    let mut dither = Diffusion::<FloydSteinberg, _>::new(vec![Cell::default(); 200], 200).unwrap();
    dither.start_row(0, 0, 200);
    for (x, &light) in (0..).zip(&row) {
        dither.index(&mut table, 255, (x, 0), light);
    }
    assert_eq!(table.entries().len(), 32);
    assert!(table.entries().iter().all(|entry| row.contains(entry)));
}

#[test]
fn the_painter_draws_every_second_row_from_the_right() {
    let rows: Vec<Vec<_>> = scattered(150 * 5, 255).chunks(150).map(<[_]>::to_vec).collect();
    let table = Palette::new(&scattered(90, 15), 15).unwrap();
    let want = diffused(&table, [6, 3, 1, 14], &rows);
    let workstation = emulated::Workstation::new(vec![0; emulated::MEMORY_SIZE]);
    let screen = GraphigsDisplay::open(workstation, "IBM5081", emulated::WORKSTATION_TYPE).unwrap();
    let dither = Diffusion::<Damped, _>::new(vec![Cell::default(); 150], 150).unwrap();
    let mut painter = Painter::dithered(screen, &table, dither).unwrap();
    assert_eq!((painter.light_max(), painter.display().capabilities().gun_max), (255, 15));
    for (y, row) in (100..).zip(&rows) {
        painter.put_row(30, y, row.iter().copied()).unwrap();
    }
    painter.update().unwrap();
    let mut screen = painter.into_parts().0;
    let mut colors = vec![Rgb::new(0, 0, 0); table.entries().len()];
    screen.read_colors(0, &mut colors).unwrap();
    for (y, want) in (100..).zip(want) {
        let mut indices = [0; 150];
        screen.read_pixels(30, y, &mut indices).unwrap();
        let got: Vec<_> =
            indices.iter().map(|&index| colors[usize::from(index)].map(|level| expand(level, 15))).collect();
        assert_eq!(got, want, "row {y}");
    }
}

#[test]
fn without_dithering_light_is_what_the_table_takes() {
    let uniform = Uniform::new(256, 63).unwrap();
    assert_eq!(Plain.light_max(&uniform, 63), 63);
    assert_eq!(Ordered::uniform(&uniform).light_max(&uniform, 63), 255);
    assert_eq!(Plain.light_max(&Palette::new(&[], 63).unwrap(), 63), 255);
}
