//! The error of the display: few levels, and a colour table with few entries.

use rta_core::color::Rgb;

use super::measure::Difference;
use crate::picture::coloring::{Coloring, on_grid};
use crate::picture::device::Device;
use crate::picture::error::PictureError;
use crate::picture::file::Pixels;
use crate::picture::raster::Size;
use crate::picture::screen::Screen;

/// Returns how far the picture that a device shows is from the linear light it is sent, in levels of its guns. The picture fills
/// a screen of the shape `aspect : 1`.
///
/// # Errors
/// [`PictureError::LargerThanDevice`] and [`PictureError::Display`].
pub fn error(
    device: Device,
    (size, aspect): (Size, f64),
    picture: &[Rgb<f32>],
) -> Result<Difference, PictureError> {
    let most = device.capabilities().gun_max;
    let coloring = Coloring::of(device);
    let sent: Vec<_> =
        picture.iter().map(|light| light.levels(coloring.light_max(device.capabilities()))).collect();
    let mut screen = Screen::new((device, coloring), (size, aspect), |lattice| {
        Ok::<_, PictureError>(on_grid(&sent, size, lattice))
    })?;
    screen.put_rows(0, &sent)?;
    let shown: Vec<_> = match screen.picture()?.pixels {
        Pixels::Direct(pixels) => pixels.into_iter().map(|color| light(color, most)).collect(),
        Pixels::Indexed { palette, indices } => {
            let color = |index: u8| palette.get(usize::from(index)).copied().unwrap_or_default();
            indices.into_iter().map(|index| light(color(index), most)).collect()
        }
    };
    let most = f64::from(most);
    let Difference { rmse, worst, within } = Difference::between(&shown, picture, 1.0 / most);
    Ok(Difference { rmse: rmse * most, worst: worst * most, within })
}

/// The level of a gun, as its share of `most`, from what it was expanded to in 8 bits.
fn light(shown: Rgb<u8>, most: u8) -> Rgb<f32> {
    let level = |shown: u8| (f32::from(shown) * f32::from(most) / 255.0).round();
    shown.map(|shown| level(shown) / f32::from(most))
}
