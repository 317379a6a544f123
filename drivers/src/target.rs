//! Pictures on displays that have a driver for embedded-graphics: any [`DrawTarget`] is a [`DirectDisplay`].
//!
//! There is a `DrawTarget` for most displays that hang on a microcontroller: ILI9341, ST7789, SSD1306 and many more. [`Target`] sends each
//! row by one call of `fill_contiguous`, for which a driver sets the display's address window once and then streams the pixels; they are
//! traced as the driver asks for them. The target's colours may be all those of `embedded_graphics_core::pixelcolor`, or any other
//! [`DirectColor`].
//!
//! ```
//! use embedded_graphics_core::geometry::{OriginDimensions, Size};
//! use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
//! use embedded_graphics_core::{Pixel, draw_target::DrawTarget};
//! use rta_core::{Q16, prelude::*};
//! use rta_drivers::direct::{DirectDisplay, DirectPainter};
//! use rta_drivers::dither::Bayer;
//! use rta_drivers::target::Target;
//! # use core::convert::Infallible;
//!
//! /// Counts the pixels that are not black. A driver of a display would take its place.
//! struct Count(usize);
//! # impl OriginDimensions for Count {
//! #     fn size(&self) -> Size {
//! #         Size::new(160, 120)
//! #     }
//! # }
//! # impl DrawTarget for Count {
//! #     type Color = Rgb565;
//! #     type Error = Infallible;
//! #     fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
//! #         self.0 += pixels.into_iter().filter(|Pixel(_, color)| *color != Rgb565::BLACK).count();
//! #         Ok(())
//! #     }
//! # }
//!
//! let length = |n: i32| Q16::from_num(n);
//! let gold = Rgb::new(Unit::ratio(9, 10), Unit::ratio(7, 10), Unit::ratio(3, 10));
//! let ball = Sphere::new(Xyz::new(length(0), length(5), length(0)), length(2), gold, 0);
//! let lamp = Lamp::white(Xyz::new(length(-4), length(0), length(6)), length(1), 60);
//! let scene = Scene { spheres: &[ball], materials: &[Material::Shiny], lamps: &[lamp], ..Scene::day() };
//! let camera = Camera::new(Xyz::new(length(0), length(-1), length(0)), UnitVec3::<Q16>::Y, Lens::new(1, 1, (4, 3)));
//! let scene = scene.admit(&camera)?;
//! let tracer: Tracer<_, _, Everything, 5> = Tracer::new(&scene, Rta, 5)?;
//!
//! let mut display = Count(0);
//! let mut painter = DirectPainter::dithered(Target::new(&mut display), Bayer);
//! let (width, height) = painter.display().size();
//! let raster = Raster::new(width, height)?;
//! for y in 0..height {
//!     painter.put_row(0, y, Pixels::row(&tracer, &camera, raster, y).map(|light| light.levels(255)))?;
//! }
//! assert!(display.0 > 160 * 120 / 4);
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666, Rgb888,
    RgbColor,
};
use embedded_graphics_core::primitives::Rectangle;
use rta_core::color::Rgb;

use crate::direct::{DirectColor, DirectDisplay};
use crate::display::{DriverError, check_row};
use crate::guns::{One, Three};

/// A [`DrawTarget`] as a display: its upper left pixel is that of the target's bounding box.
#[derive(Debug)]
pub struct Target<'a, T> {
    target: &'a mut T,
}

impl<'a, T: DrawTarget> Target<'a, T> {
    /// Borrows a target to draw on.
    pub const fn new(target: &'a mut T) -> Self {
        Self { target }
    }
}

impl<T: DrawTarget<Color: DirectColor>> DirectDisplay for Target<'_, T> {
    type Color = T::Color;
    type Error = DriverError<T::Error>;

    fn size(&self) -> (u32, u32) {
        let Size { width, height } = self.target.bounding_box().size;
        (width, height)
    }

    fn put_row(
        &mut self,
        x: u32,
        y: u32,
        colors: impl ExactSizeIterator<Item = T::Color>,
    ) -> Result<(), Self::Error> {
        check_row(self.size(), x, y, colors.len())?;
        let Point { x: left, y: top } = self.target.bounding_box().top_left;
        let first = Point::new(left.saturating_add_unsigned(x), top.saturating_add_unsigned(y));
        // No longer than a row, by the check.
        let size = Size::new(u32::try_from(colors.len()).unwrap_or(u32::MAX), 1);
        Ok(self.target.fill_contiguous(&Rectangle::new(first, size), colors)?)
    }
}

/// Colours of three guns.
macro_rules! rgb {
    ($($Color:ident)*) => { $(
        impl DirectColor for $Color {
            type Guns = Three;
            const MAX: Rgb<u8> = Rgb::new(Self::MAX_R, Self::MAX_G, Self::MAX_B);
            fn from_levels(Rgb { r, g, b }: Rgb<u8>) -> Self {
                Self::new(r, g, b)
            }
        }
    )* };
}

/// Greys, each with its highest level.
macro_rules! gray {
    ($($Color:ident $max:literal)*) => { $(
        impl DirectColor for $Color {
            type Guns = One;
            const MAX: u8 = $max;
            fn from_levels(level: u8) -> Self {
                Self::new(level)
            }
        }
    )* };
}

rgb!(Rgb555 Bgr555 Rgb565 Bgr565 Rgb666 Bgr666 Rgb888 Bgr888);
gray!(Gray2 3 Gray4 15 Gray8 255);

impl DirectColor for BinaryColor {
    type Guns = One;
    const MAX: u8 = 1;
    fn from_levels(level: u8) -> Self {
        if level == 0 { Self::Off } else { Self::On }
    }
}
