//! Displays without a colour table: levels, dithering, and rows that leave the screen.

use core::convert::Infallible;

use rta_core::color::Rgb;
use rta_drivers::direct::{DirectColor, DirectDisplay, DirectPainter, Gray, Levels};
use rta_drivers::display::{DriverError, check_row, expand, reduce};
use rta_drivers::dither::{
    Bayer, Damped, Diffusion, DirectCell, DirectDither, DitherError, FloydSteinberg, Plain,
};
use rta_drivers::guns::{Guns, One, Three, luma};
use rta_drivers::quantize::Palette;

use crate::dither::{diffused, gray};
use crate::scattered;

/// Columns and rows of [`Paper`].
const WIDTH: u32 = 40;
const HEIGHT: u32 = 32;

/// A display that keeps what is sent to it, and how often it was told to show it.
struct Paper<C> {
    rows: Vec<Vec<C>>,
    updates: usize,
}

impl<C: DirectColor + Default> Paper<C> {
    fn new() -> Self {
        Self { rows: vec![vec![C::default(); WIDTH as usize]; HEIGHT as usize], updates: 0 }
    }
}

impl<C: DirectColor> DirectDisplay for Paper<C> {
    type Color = C;
    type Error = DriverError<Infallible>;

    fn size(&self) -> (u32, u32) {
        (WIDTH, HEIGHT)
    }

    fn put_row(
        &mut self,
        x: u32,
        y: u32,
        colors: impl ExactSizeIterator<Item = C>,
    ) -> Result<(), Self::Error> {
        check_row(self.size(), x, y, colors.len())?;
        let row = self.rows[y as usize][x as usize..].iter_mut();
        row.zip(colors).for_each(|(pixel, color)| *pixel = color);
        Ok(())
    }

    fn update(&mut self) -> Result<(), Self::Error> {
        self.updates += 1;
        Ok(())
    }
}

/// Draws rows of light from the left edge and the top.
fn draw<C, H>(dither: H, rows: &[Vec<Rgb<u8>>]) -> Vec<Vec<C>>
where
    C: DirectColor + Default,
    H: DirectDither<C::Guns>,
{
    let mut painter = DirectPainter::dithered(Paper::<C>::new(), dither);
    for (y, row) in (0..).zip(rows) {
        painter.put_row(0, y, row.iter().copied()).unwrap();
    }
    painter.update().unwrap();
    let paper = painter.into_display();
    assert_eq!(paper.updates, 1);
    paper.rows
}

fn diffusion<W, G: Guns>() -> Diffusion<W, Vec<DirectCell<G>>, G>
where
    W: rta_drivers::dither::Weights,
{
    let cells = vec![DirectCell::<G>::default(); WIDTH as usize];
    Diffusion::<W, _, G>::new(cells, WIDTH as usize).unwrap()
}

#[test]
fn without_dithering_each_level_is_the_nearest() {
    let light: Vec<_> = scattered(WIDTH as usize, 255);
    let rows = [light.clone()];
    let drawn = draw::<Levels<31, 63, 31>, _>(Plain, &rows);
    let far = |level: u8, shown: u8, max: u8| {
        (i32::from(level) * i32::from(max) - i32::from(shown) * 255).unsigned_abs()
    };
    let near = |level: u8, max: u8| (0..=max).min_by_key(|&shown| far(level, shown, max)).unwrap();
    for (Levels(got), light) in drawn[0].iter().zip(&light) {
        assert_eq!(*got, Rgb::new(near(light.r, 31), near(light.g, 63), near(light.b, 31)));
    }
    for (Gray(got), &light) in draw::<Gray<15>, _>(Plain, &rows)[0].iter().zip(&light) {
        assert_eq!(*got, near(luma(light), 15));
    }
    for (Gray(got), &light) in draw::<Gray<1>, _>(Plain, &rows)[0].iter().zip(&light) {
        assert_eq!(*got, u8::from(luma(light) >= 128));
    }
}

#[test]
fn luma_weighs_green_most_and_keeps_grey() {
    // 77 * 200 + 150 * 100 + 29 * 50 = 31850 = 124.4 * 256
    assert_eq!(luma(Rgb::new(200, 100, 50)), 124);
    assert_eq!(One::of_light(Rgb::new(200, 100, 50)), 124);
    assert_eq!(Three::of_light(Rgb::new(200, 100, 50)), Rgb::new(200, 100, 50));
    assert!((0..=255).all(|level| luma(gray(level)) == level));
}

/// Returns the mean of a picture of one grey, of all its pixels and guns, in 8 bits.
fn mean<C: DirectColor + Default>(
    dither: impl DirectDither<C::Guns>,
    level: u8,
    shown: impl Fn(C) -> f64,
) -> f64 {
    let rows = vec![vec![gray(level); WIDTH as usize]; HEIGHT as usize];
    let drawn = draw::<C, _>(dither, &rows);
    drawn.into_iter().flatten().map(shown).sum::<f64>() / f64::from(WIDTH * HEIGHT)
}

#[test]
fn dithering_keeps_the_mean() {
    let rgb565 = |Levels(c): Levels<31, 63, 31>| {
        (f64::from(expand(c.r, 31)) + f64::from(expand(c.g, 63)) + f64::from(expand(c.b, 31))) / 3.0
    };
    let gray4 = |Gray(level): Gray<15>| f64::from(expand(level, 15));
    let binary = |Gray(level): Gray<1>| f64::from(expand(level, 1));
    for level in [0, 3, 50, 100, 127, 200, 252, 255] {
        let close =
            |mean: f64, within: f64| assert!((mean - f64::from(level)).abs() <= within, "{level}: {mean}");
        close(mean(diffusion::<FloydSteinberg, Three>(), level, rgb565), 0.5);
        close(mean(diffusion::<FloydSteinberg, One>(), level, gray4), 0.5);
        close(mean(diffusion::<FloydSteinberg, One>(), level, binary), 2.5);
        // Half of a 64th of a step; levels of 5 and 6 bits are rounded to 8.
        close(mean(Bayer, level, rgb565), 0.5);
        close(mean(Bayer, level, gray4), 17.0 / 128.0);
        close(mean(Bayer, level, binary), 255.0 / 128.0);
    }
    // Without dithering it is not kept.
    assert_eq!(mean(Plain, 100, binary), 0.0);
}

#[test]
fn guns_of_all_256_levels_are_left_as_they_are() {
    let rows: Vec<_> =
        scattered((WIDTH * 4) as usize, 255).chunks(WIDTH as usize).map(<[_]>::to_vec).collect();
    let equal = |drawn: Vec<Vec<Levels<255, 255, 255>>>| {
        for (drawn, row) in drawn.iter().zip(&rows) {
            assert!(drawn.iter().map(|Levels(color)| color).eq(row));
        }
    };
    equal(draw(Plain, &rows));
    equal(draw(Bayer, &rows));
    equal(draw(diffusion::<FloydSteinberg, Three>(), &rows));
}

#[test]
fn the_pattern_is_within_one_level() {
    let most = Rgb::new(31, 63, 31);
    for (i, light) in (0..).zip(scattered(5000, 255)) {
        let levels = DirectDither::<Three>::levels(&mut Bayer, most, (i % 8, i / 8), light);
        let within = |light: u8, level: u8, max: u8| {
            (f64::from(light) * f64::from(max) / 255.0 - f64::from(level)).abs() <= 1.0
        };
        assert!(
            within(light.r, levels.r, 31) && within(light.g, levels.g, 63) && within(light.b, levels.b, 31)
        );
    }
}

#[test]
fn diffusion_in_one_gun_is_that_of_the_papers_on_a_palette_of_greys() {
    let greys: Vec<_> = (0..16).map(gray).collect();
    let table = Palette::new(&greys, 15).unwrap();
    let light = scattered((WIDTH * HEIGHT) as usize, 255);
    let rows: Vec<Vec<_>> = light
        .chunks(WIDTH as usize)
        .map(|row| row.iter().map(|&light| gray(luma(light))).collect())
        .collect();
    let levels = |rows: &[Vec<Rgb<u8>>]| -> Vec<Vec<Gray<15>>> {
        rows.iter().map(|row| row.iter().map(|color| Gray(reduce(color.r, 15))).collect()).collect()
    };
    let drawn: Vec<Vec<Gray<15>>> = draw(diffusion::<FloydSteinberg, One>(), &rows);
    assert_eq!(drawn, levels(&diffused(&table, [7, 3, 1, 16], &rows)));
    let drawn: Vec<Vec<Gray<15>>> = draw(diffusion::<Damped, One>(), &rows);
    assert_eq!(drawn, levels(&diffused(&table, [6, 3, 1, 14], &rows)));
}

#[test]
fn each_of_three_guns_is_diffused_by_itself() {
    let rows: Vec<Vec<_>> =
        scattered((WIDTH * HEIGHT) as usize, 255).chunks(WIDTH as usize).map(<[_]>::to_vec).collect();
    let of = |gun: fn(&Rgb<u8>) -> u8| -> Vec<Vec<Rgb<u8>>> {
        rows.iter().map(|row| row.iter().map(|color| gray(gun(color))).collect()).collect()
    };
    let colors: Vec<Vec<Levels<31, 63, 7>>> = draw(diffusion::<Damped, Three>(), &rows);
    let reds: Vec<Vec<Gray<31>>> = draw(diffusion::<Damped, One>(), &of(|color| color.r));
    let greens: Vec<Vec<Gray<63>>> = draw(diffusion::<Damped, One>(), &of(|color| color.g));
    let blues: Vec<Vec<Gray<7>>> = draw(diffusion::<Damped, One>(), &of(|color| color.b));
    for (y, row) in colors.iter().enumerate() {
        for (x, Levels(color)) in row.iter().enumerate() {
            let want = Rgb::new(reds[y][x].0, greens[y][x].0, blues[y][x].0);
            assert_eq!(*color, want, "({x}, {y})");
        }
    }
}

#[test]
fn rows_that_leave_the_screen_are_refused() {
    let mut painter = DirectPainter::new(Paper::<Gray<15>>::new());
    for (x, y, len) in [(0, HEIGHT, 1), (WIDTH, 0, 1), (1, 0, WIDTH as usize), (u32::MAX, 0, 2)] {
        let row = vec![gray(255); len];
        assert_eq!(painter.put_row(x, y, row), Err(DriverError::OutOfBounds { x, y, len }));
    }
    assert!(painter.display().rows.iter().flatten().all(|pixel| *pixel == Gray(0)));
    painter.put_row(WIDTH - 1, HEIGHT - 1, [gray(255)]).unwrap();
    painter.put_row(WIDTH, HEIGHT - 1, []).unwrap();
    let mut display = painter.into_display();
    assert_eq!(display.rows[HEIGHT as usize - 1][WIDTH as usize - 1], Gray(15));
    // A borrowed display is one too.
    DirectPainter::new(&mut display).put_row(0, 0, [gray(128)]).unwrap();
    assert_eq!(display.rows[0][0], Gray(8));
}

#[test]
fn memory_for_error_diffusion_is_small_and_checked() {
    assert_eq!((size_of::<DirectCell<Three>>(), size_of::<DirectCell<One>>()), (6, 2));
    let short = Diffusion::<Damped, _, One>::new([DirectCell::<One>::default(); 127], 128);
    assert_eq!(short.err(), Some(DitherError { memory: 127, width: 128 }));
}
