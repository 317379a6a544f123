//! Pictures on targets of embedded-graphics.

use core::fmt::Debug;
use std::collections::HashMap;

use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Dimensions, Point, Size};
use embedded_graphics_core::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, PixelColor, Rgb555, Rgb565, Rgb666,
    Rgb888,
};
use embedded_graphics_core::primitives::Rectangle;
use rta_core::color::Rgb;
use rta_drivers::direct::{DirectColor, DirectDisplay, DirectPainter};
use rta_drivers::display::DriverError;
use rta_drivers::dither::{Damped, Diffusion, DirectCell};
use rta_drivers::guns::Three;
use rta_drivers::target::Target;

use crate::scattered;

/// A target of 8 x 4 pixels whose bounding box does not begin at the origin. It refuses row `broken`.
struct Panel<C> {
    pixels: HashMap<(i32, i32), C>,
    fills: Vec<Rectangle>,
    broken: Option<i32>,
}

/// What [`Panel`] says when it refuses.
#[derive(Debug, PartialEq, Eq)]
struct Unplugged;

impl<C> Panel<C> {
    fn new() -> Self {
        Self { pixels: HashMap::new(), fills: Vec::new(), broken: None }
    }
}

impl<C> Dimensions for Panel<C> {
    fn bounding_box(&self) -> Rectangle {
        Rectangle::new(Point::new(-3, 7), Size::new(8, 4))
    }
}

impl<C: PixelColor> DrawTarget for Panel<C> {
    type Color = C;
    type Error = Unplugged;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Unplugged> {
        for Pixel(Point { x, y }, color) in pixels {
            if self.broken == Some(y) {
                return Err(Unplugged);
            }
            self.pixels.insert((x, y), color);
        }
        Ok(())
    }

    fn fill_contiguous<I: IntoIterator<Item = C>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), Unplugged> {
        self.fills.push(*area);
        let points = (0..).map(|i| area.top_left + Point::new(i, 0));
        self.draw_iter(points.zip(colors).map(|(point, color)| Pixel(point, color)))
    }
}

/// Draws eight colours on a panel and returns what it shows.
fn shown<C: PixelColor + DirectColor>(light: [Rgb<u8>; 8]) -> [C; 8] {
    let mut panel = Panel::new();
    DirectPainter::new(Target::new(&mut panel)).put_row(0, 2, light).unwrap();
    assert_eq!(panel.fills, [Rectangle::new(Point::new(-3, 9), Size::new(8, 1))]);
    assert_eq!(panel.pixels.len(), 8);
    core::array::from_fn(|i| panel.pixels[&(i32::try_from(i).unwrap() - 3, 9)])
}

const LIGHT: [Rgb<u8>; 8] = [
    Rgb::new(0, 0, 0),
    Rgb::new(255, 255, 255),
    Rgb::new(255, 0, 0),
    Rgb::new(0, 255, 0),
    Rgb::new(0, 0, 255),
    Rgb::new(128, 128, 128),
    Rgb::new(127, 127, 127),
    Rgb::new(10, 100, 200),
];

fn is<C: PixelColor + DirectColor + Debug>(want: [C; 8]) {
    assert_eq!(shown::<C>(LIGHT), want);
}

#[test]
fn each_colour_type_gets_its_nearest_levels() {
    // 10, 100 and 200 of 255 are 1.2, 12.2 and 24.3 of 31; 2.5, 24.7 and 49.4 of 63; 127 and 128 are 15.4 and 15.6, 31.4 and 31.6.
    macro_rules! five_bits {
        ($($C:ident)*) => { $( is([
            $C::new(0, 0, 0), $C::new(31, 31, 31), $C::new(31, 0, 0), $C::new(0, 31, 0), $C::new(0, 0, 31),
            $C::new(16, 16, 16), $C::new(15, 15, 15), $C::new(1, 12, 24),
        ]); )* };
    }
    macro_rules! sixteen_bits {
        ($($C:ident)*) => { $( is([
            $C::new(0, 0, 0), $C::new(31, 63, 31), $C::new(31, 0, 0), $C::new(0, 63, 0), $C::new(0, 0, 31),
            $C::new(16, 32, 16), $C::new(15, 31, 15), $C::new(1, 25, 24),
        ]); )* };
    }
    macro_rules! six_bits {
        ($($C:ident)*) => { $( is([
            $C::new(0, 0, 0), $C::new(63, 63, 63), $C::new(63, 0, 0), $C::new(0, 63, 0), $C::new(0, 0, 63),
            $C::new(32, 32, 32), $C::new(31, 31, 31), $C::new(2, 25, 49),
        ]); )* };
    }
    five_bits!(Rgb555 Bgr555);
    sixteen_bits!(Rgb565 Bgr565);
    six_bits!(Rgb666 Bgr666);
    is(LIGHT.map(|Rgb { r, g, b }| Rgb888::new(r, g, b)));
    is(LIGHT.map(|Rgb { r, g, b }| Bgr888::new(r, g, b)));
    // The luma of the last is (770 + 15000 + 5800) / 256 = 84.3.
    is([0, 255, 76, 149, 28, 128, 127, 84].map(Gray8::new));
    is([0, 15, 4, 9, 2, 8, 7, 5].map(Gray4::new));
    is([0, 3, 1, 2, 0, 2, 1, 1].map(Gray2::new));
    is([false, true, false, true, false, true, false, false].map(BinaryColor::from));
}

#[test]
fn rows_from_the_right_are_sent_from_the_left() {
    let rows: Vec<Vec<_>> = scattered(8 * 4, 255).chunks(8).map(<[_]>::to_vec).collect();
    let mut panel = Panel::<Rgb565>::new();
    let cells = [DirectCell::<Three>::default(); 8];
    let mut painter = DirectPainter::dithered(
        Target::new(&mut panel),
        Diffusion::<Damped, _, Three>::new(cells, 8).unwrap(),
    );
    for (y, row) in (0..).zip(&rows) {
        painter.put_row(0, y, row.iter().copied()).unwrap();
    }
    painter.update().unwrap();
    let mut dither = Diffusion::<Damped, _, Three>::new(cells, 8).unwrap();
    for (y, row) in (0..).zip(&rows) {
        use rta_drivers::dither::DirectDither;
        let leftward = dither.start_row(0, y, 8);
        assert_eq!(leftward, y % 2 == 1);
        for i in 0..8 {
            let x = if leftward { 7 - i } else { i };
            let light = row[x as usize];
            let Rgb { r, g, b } = dither.levels(Rgb::new(31, 63, 31), (x, y), light);
            let at = (i32::try_from(x).unwrap() - 3, i32::try_from(y).unwrap() + 7);
            assert_eq!(panel.pixels[&at], Rgb565::new(r, g, b), "({x}, {y})");
        }
    }
    assert_eq!(panel.fills.len(), 4);
}

#[test]
fn a_target_that_refuses_is_heard() {
    let mut panel = Panel::<Gray8>::new();
    panel.broken = Some(8);
    let mut painter = DirectPainter::new(Target::new(&mut panel));
    painter.put_row(0, 0, LIGHT).unwrap();
    assert_eq!(painter.put_row(0, 1, LIGHT), Err(DriverError::Device(Unplugged)));
    painter.put_row(0, 2, LIGHT).unwrap();
}

#[test]
fn what_leaves_the_target_is_not_sent() {
    let mut panel = Panel::<Gray8>::new();
    let mut target = Target::new(&mut panel);
    assert_eq!(target.size(), (8, 4));
    for (x, y, len) in [(0, 4, 1), (8, 0, 1), (1, 0, 8), (u32::MAX, u32::MAX, 1)] {
        let colors = vec![Gray8::new(1); len];
        assert_eq!(target.put_row(x, y, colors.into_iter()), Err(DriverError::OutOfBounds { x, y, len }));
    }
    target.put_row(7, 3, [Gray8::new(9)].into_iter()).unwrap();
    assert_eq!(panel.fills.len(), 1);
    assert_eq!(panel.pixels, HashMap::from([((4, 10), Gray8::new(9))]));
}
