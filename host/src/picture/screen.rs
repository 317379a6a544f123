//! An emulated device with a picture on it.
//!
//! The picture that is shown and saved is read back from the device, pixels and colour table, so that every picture has passed
//! through the device's own registers and memory.

use core::fmt;

use rta_core::color::Rgb;
use rta_core::raster::Raster;
use rta_core::raster::lattice::Lattice;
use rta_drivers::display::{ReadBack, expand};
use rta_drivers::graphigs::{self, GraphigsDisplay, emulated::Workstation};
use rta_drivers::painter::Painter;
use rta_drivers::pixrect::{self, Cgthree, PixrectDisplay, emulated::Board};
use rta_drivers::quantize::ColorTable;
use rta_drivers::vga13h::{self, Mode13h, emulated::Vga};

use super::coloring::{Coloring, Dithering, Table};
use super::device::Device;
use super::error::PictureError;
use super::file::{Displayed, Pixels};
use super::raster::Size;

/// A painter on any of the devices: the operations that [`Screen`] needs, with one type of error.
trait Canvas: Send {
    fn put_row(&mut self, y: u32, light: &[Rgb<u8>]) -> Result<(), PictureError>;
    fn update(&mut self) -> Result<(), PictureError>;
    /// Returns the entries made so far, as levels of the guns.
    fn colors(&mut self) -> Result<Vec<Rgb<u8>>, PictureError>;
    fn read_row(&mut self, y: u32, indices: &mut [u8]) -> Result<(), PictureError>;
}

impl<D: ReadBack<Error: Send + Sync + 'static> + Send> Canvas for Painter<D, Table, Dithering> {
    fn put_row(&mut self, y: u32, light: &[Rgb<u8>]) -> Result<(), PictureError> {
        Painter::put_row(self, 0, y, light.iter().copied()).map_err(PictureError::display)
    }

    fn update(&mut self) -> Result<(), PictureError> {
        Painter::update(self).map_err(PictureError::display)
    }

    fn colors(&mut self) -> Result<Vec<Rgb<u8>>, PictureError> {
        let mut colors = vec![Rgb::default(); self.table().entries().len()];
        self.display_mut().read_colors(0, &mut colors).map_err(PictureError::display)?;
        Ok(colors)
    }

    fn read_row(&mut self, y: u32, indices: &mut [u8]) -> Result<(), PictureError> {
        self.display_mut().read_pixels(0, y, indices).map_err(PictureError::display)
    }
}

/// An emulated device with a picture in its raster, in the upper left corner.
pub struct Screen {
    canvas: Box<dyn Canvas>,
    device: Device,
    size: Size,
    aspect: f64,
}

impl fmt::Debug for Screen {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Screen")
            .field("device", &self.device)
            .field("size", &self.size)
            .finish_non_exhaustive()
    }
}

impl Screen {
    /// Switches `device` on, with a window of `size` pixels that look as on a screen of shape `aspect`. If the colour table is made from
    /// the picture, `light` is asked for the colours, 8 bits a gun, of the pixels of a grid.
    ///
    /// # Errors
    /// [`PictureError::LargerThanDevice`], [`PictureError::Display`] if the emulated device does not start, and those of `light`.
    pub fn new<E: From<PictureError>>(
        (device, coloring): (Device, Coloring),
        (size, aspect): (Size, f64),
        light: impl FnOnce(Lattice) -> Result<Vec<Rgb<u8>>, E>,
    ) -> Result<Self, E> {
        Self::with(device, (size, aspect), parts(device, coloring, size, light)?)
    }

    /// Switches `device` on with a colour table that is made from samples, colours with 8 bits a gun of a grid that is `width` of them
    /// wide. There may be none if [`Coloring::samples`] is 0.
    ///
    /// # Errors
    /// Those of [`Screen::new`].
    pub fn of_samples(
        (device, coloring): (Device, Coloring),
        (size, aspect): (Size, f64),
        (samples, width): (&[Rgb<u8>], u32),
    ) -> Result<Self, PictureError> {
        let capabilities = device.capabilities();
        let table = coloring.table(capabilities, samples, width).map_err(PictureError::display)?;
        let dithering = coloring.dithering(capabilities, size.columns()).map_err(PictureError::display)?;
        Self::with(device, (size, aspect), (Table(table), dithering))
    }

    /// Switches `device` on with a colour table and a dithering.
    ///
    /// # Errors
    /// Those of [`Screen::new`].
    pub fn with<E: From<PictureError>>(
        device: Device,
        (size, aspect): (Size, f64),
        parts: (Table, Dithering),
    ) -> Result<Self, E> {
        let whole = device.size();
        if size.width() > whole.width() || size.height() > whole.height() {
            return Err(PictureError::LargerThanDevice { size, device }.into());
        }
        Ok(Self { canvas: switch_on(device, parts)?, device, size, aspect })
    }

    /// Draws whole rows of light, from row `first` down, in levels of 0..=[`Coloring::light_max`].
    ///
    /// # Errors
    /// [`PictureError::Display`] if there are more rows than the screen has, or levels beyond its guns.
    pub fn put_rows(&mut self, first: u32, light: &[Rgb<u8>]) -> Result<(), PictureError> {
        for (y, row) in (first..).zip(light.chunks(self.size.columns())) {
            self.canvas.put_row(y, row)?;
        }
        self.canvas.update()
    }

    /// Returns the picture that the device shows, read back from it. The colour table is expanded to 8 bits a gun.
    ///
    /// # Errors
    /// [`PictureError::Display`] if the device does not answer.
    pub fn picture(&mut self) -> Result<Displayed, PictureError> {
        let gun_max = self.device.capabilities().gun_max;
        let colors = self.canvas.colors()?;
        let palette = colors.into_iter().map(|color| color.map(|level| expand(level, gun_max))).collect();
        let mut indices = vec![0; self.size.pixels()];
        for (y, row) in (0..).zip(indices.chunks_mut(self.size.columns())) {
            self.canvas.read_row(y, row)?;
        }
        Ok(Displayed { size: self.size, aspect: self.aspect, pixels: Pixels::Indexed { palette, indices } })
    }
}

/// Returns the grid of a picture of `size` of whose pixels a colour table is made, or the part of the table that is this picture's
/// where it is made from so many `frames` alike. Without samples it has one pixel.
///
/// # Errors
/// [`PictureError::Display`] if no raster has this size.
pub(crate) fn lattice(coloring: Coloring, size: Size, frames: u32) -> Result<Lattice, PictureError> {
    let raster = Raster::new(size.width(), size.height()).map_err(PictureError::display)?;
    let frames = usize::try_from(frames).unwrap_or(usize::MAX);
    Ok(Lattice::new(raster, (coloring.samples() / frames.max(1)).max(1)))
}

/// Returns the colour table and the dithering of a picture on a device.
///
/// # Errors
/// [`PictureError::Display`] if the device has too few colours or levels for them, and those of `light`.
pub(crate) fn parts<E: From<PictureError>>(
    device: Device,
    coloring: Coloring,
    size: Size,
    light: impl FnOnce(Lattice) -> Result<Vec<Rgb<u8>>, E>,
) -> Result<(Table, Dithering), E> {
    let capabilities = device.capabilities();
    let lattice = lattice(coloring, size, 1)?;
    let samples = if coloring.samples() == 0 { Vec::new() } else { light(lattice)? };
    let table =
        coloring.table(capabilities, &samples, lattice.grid().width()).map_err(PictureError::display)?;
    let dithering = coloring.dithering(capabilities, size.columns()).map_err(PictureError::display)?;
    Ok((Table(table), dithering))
}

fn switch_on(device: Device, parts: (Table, Dithering)) -> Result<Box<dyn Canvas>, PictureError> {
    fn paint(
        display: impl ReadBack<Error: Send + Sync + 'static> + Send + 'static,
        (table, dithering): (Table, Dithering),
    ) -> Result<Box<dyn Canvas>, PictureError> {
        Ok(Box::new(Painter::dithered(display, table, dithering).map_err(PictureError::display)?))
    }
    match device {
        Device::Vga => {
            let board = Vga::new(vec![0; vga13h::emulated::MEMORY_SIZE]).map_err(PictureError::display)?;
            paint(Mode13h::program(board), parts)
        }
        Device::Graphigs => {
            let workstation = Workstation::new(vec![0; graphigs::emulated::MEMORY_SIZE]);
            let kind = graphigs::emulated::WORKSTATION_TYPE;
            paint(GraphigsDisplay::open(workstation, "IBM5081", kind).map_err(PictureError::display)?, parts)
        }
        Device::Pixrect => {
            let board = Board::new(vec![0; pixrect::emulated::MEMORY_SIZE]).map_err(PictureError::display)?;
            paint(PixrectDisplay::new(Cgthree::open(board)).map_err(PictureError::display)?, parts)
        }
    }
}

#[cfg(test)]
mod tests {
    use rta_core::color::Rgb;

    use super::Screen;
    use crate::picture::coloring::{Coloring, DitherKind, TableKind};
    use crate::picture::device::Device;
    use crate::picture::error::PictureError;
    use crate::picture::file::Pixels;
    use crate::picture::raster::Size;

    const ALL: [Device; 3] = [Device::Vga, Device::Graphigs, Device::Pixrect];

    /// A screen whose table is not made from the picture.
    fn screen(device: Device, table: TableKind, size: Size) -> Result<Screen, PictureError> {
        let coloring = Coloring { table, dither: DitherKind::None, samples: 0 };
        Screen::new((device, coloring), (size, 1.0), |_| Ok(Vec::new()))
    }

    #[test]
    fn a_picture_comes_back_from_every_device_in_its_own_levels() {
        for device in ALL {
            for (table, entries) in
                [(TableKind::Adaptive, 4), (TableKind::Tolerant, 4), (TableKind::Uniform, 125)]
            {
                let max = device.capabilities().gun_max;
                let size = Size::new(2, 2).expect("small");
                let mut screen = self::screen(device, table, size).expect("it starts");
                let colors =
                    [Rgb::new(max, 0, 0), Rgb::new(0, max, 0), Rgb::new(0, 0, max), Rgb::new(0, 0, 0)];
                screen.put_rows(0, &colors).expect("in range");
                let picture = screen.picture().expect("it answers");
                let Pixels::Indexed { palette, indices } = picture.pixels else { panic!("no table") };
                assert!(palette.len() >= entries, "{device} {table}: {}", palette.len());
                let shown =
                    indices.iter().map(|index| palette.get(usize::from(*index)).copied().expect("an entry"));
                assert!(shown.eq(colors.map(|color| color.map(|level| if level == max { 255 } else { 0 }))));
            }
        }
    }

    #[test]
    fn a_tolerant_table_keeps_room() {
        let size = Size::new(256, 1).expect("small");
        let mut entries = Vec::new();
        for table in [TableKind::Adaptive, TableKind::Tolerant] {
            let mut screen = self::screen(Device::Pixrect, table, size).expect("it starts");
            let grays: Vec<_> = (0..=255).map(|level| Rgb::new(level, level, level)).collect();
            screen.put_rows(0, &grays).expect("in range");
            let Pixels::Indexed { palette, .. } = screen.picture().expect("it answers").pixels else {
                panic!()
            };
            entries.push(palette.len());
        }
        // Black, and every seventh gray from there.
        assert_eq!(entries, [256, 37]);
    }

    #[test]
    fn what_the_guns_and_the_raster_do_not_have_is_an_error() {
        for device in ALL {
            let whole = device.size();
            let larger = Size::new(whole.width() + 1, whole.height()).expect("not too large");
            assert!(screen(device, TableKind::Adaptive, larger).is_err());
            let mut screen = self::screen(device, TableKind::Adaptive, whole).expect("it starts");
            assert!(screen.put_rows(whole.height(), &[Rgb::default()]).is_err(), "{device}");
            let max = device.capabilities().gun_max;
            if max < u8::MAX {
                assert!(screen.put_rows(0, &[Rgb::new(max + 1, 0, 0)]).is_err(), "{device}");
            }
        }
    }
}
