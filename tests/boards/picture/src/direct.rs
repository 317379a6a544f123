//! The picture on a display with direct colour.

use rta_core::raster::{Pixels, Places, Raster};
use rta_core::trace::Trace;
use rta_drivers::direct::{DirectColor, DirectDisplay, DirectPainter};
use rta_drivers::dither::{Diffusion, DirectCell, FloydSteinberg};

use crate::{ADAPTIVE, DrawError, Drawing, HEIGHT, WIDTH, draw_sized, scene};

/// Draws the picture, `WIDTH` x `HEIGHT` from the upper left pixel, with error diffusion in each gun; calls `row` before the first row and
/// after each.
///
/// # Errors
/// Those of the display.
pub fn draw<D: DirectDisplay>(display: D, row: impl FnMut()) -> Result<D, DrawError<D::Error>> {
    draw_sized((WIDTH, HEIGHT), Direct { display, row })
}

/// A picture on a display with direct colour.
struct Direct<D, R> {
    display: D,
    row: R,
}

impl<D: DirectDisplay, R: FnMut()> Drawing for Direct<D, R> {
    type Display = D;
    type Error = D::Error;

    #[inline(always)] // it has one caller in a program
    fn draw(
        mut self,
        tracer: &impl Trace<scene::Number>,
        places: impl Places,
        raster: Raster,
    ) -> Result<D, DrawError<D::Error>> {
        const { assert!(!ADAPTIVE, "displays with direct colour have no antialiasing") };
        let mut cells = [DirectCell::<<D::Color as DirectColor>::Guns>::default(); WIDTH as usize];
        let diffusion = Diffusion::<FloydSteinberg, _, _>::new(&mut cells[..], raster.width() as usize);
        let diffusion = diffusion.map_err(DrawError::Dither)?;
        let mut painter = DirectPainter::dithered(self.display, diffusion);
        (self.row)();
        for y in 0..raster.height() {
            let light = Pixels::sampled(tracer, &scene::CAMERA, raster, places, y, y + 1);
            let light = light.map(|light| light.levels(u8::MAX));
            painter.put_row(0, y, light).map_err(DrawError::Display)?;
            (self.row)();
        }
        painter.update().map_err(DrawError::Display)?;
        Ok(painter.into_display())
    }
}
