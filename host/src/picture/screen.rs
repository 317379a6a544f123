//! An emulated device with a picture on it.
//!
//! The picture that is shown and saved is read back from the device, pixels and colour table, so that every picture has passed
//! through the device's own registers and memory.

use core::fmt;

use clap::ValueEnum;
use rta_core::color::Rgb;
use rta_drivers::display::{Capabilities, ReadBack, expand};
use rta_drivers::graphigs::{self, GraphigsDisplay, emulated::Workstation};
use rta_drivers::painter::Painter;
use rta_drivers::pixrect::{self, Cgthree, PixrectDisplay, emulated::Board};
use rta_drivers::quantize::{Adaptive, ColorTable, TableError, Uniform};
use rta_drivers::vga13h::{self, Mode13h, emulated::Vga};

use super::device::Device;
use super::error::PictureError;
use super::file::{Displayed, Pixels};
use super::raster::Size;

/// How the entries of a device's colour table are chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum TableKind {
    /// The thesis's way to the letter: built while the picture is drawn, the nearest entry once it is full.
    Adaptive,
    /// The thesis's way with a small tolerance: what is nearly an entry shares it, so that a smooth sky leaves room
    /// for what is below it.
    Tolerant,
    /// The same evenly spaced colours for every picture.
    Uniform,
}

impl TableKind {
    /// Returns a table of this kind for a device. An adaptive one has only black at first, a uniform one all its entries.
    ///
    /// # Errors
    /// [`TableError`] if the device has too few colours or levels for this kind.
    pub fn table(self, device: Capabilities) -> Result<Box<dyn ColorTable + Send>, TableError> {
        let Capabilities { colors, gun_max, .. } = device;
        Ok(match self {
            Self::Adaptive => Box::new(Adaptive::new(colors)?),
            Self::Tolerant => Box::new(Adaptive::tolerant(colors, gun_max)?),
            Self::Uniform => Box::new(Uniform::new(colors, gun_max)?),
        })
    }

    /// Returns the kind after this one, in a circle.
    #[must_use]
    pub const fn next(self) -> Self {
        match self {
            Self::Adaptive => Self::Tolerant,
            Self::Tolerant => Self::Uniform,
            Self::Uniform => Self::Adaptive,
        }
    }
}

impl fmt::Display for TableKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Adaptive => "adaptive",
            Self::Tolerant => "tolerant",
            Self::Uniform => "uniform",
        })
    }
}

/// A colour table of any kind.
pub(crate) struct Table(pub(crate) Box<dyn ColorTable + Send>);

impl ColorTable for Table {
    fn index(&mut self, levels: Rgb<u8>) -> u8 {
        self.0.index(levels)
    }

    fn entries(&self) -> &[Rgb<u8>] {
        self.0.entries()
    }
}

/// A painter on any of the devices: the operations that [`Screen`] needs, with one type of error.
trait Canvas: Send {
    fn put_row(&mut self, y: u32, levels: &[Rgb<u8>]) -> Result<(), PictureError>;
    fn update(&mut self) -> Result<(), PictureError>;
    /// Returns the entries made so far, as levels of the guns.
    fn colors(&mut self) -> Result<Vec<Rgb<u8>>, PictureError>;
    fn read_row(&mut self, y: u32, indices: &mut [u8]) -> Result<(), PictureError>;
}

impl<D: ReadBack<Error: Send + Sync + 'static> + Send> Canvas for Painter<D, Table> {
    fn put_row(&mut self, y: u32, levels: &[Rgb<u8>]) -> Result<(), PictureError> {
        Painter::put_row(self, 0, y, levels.iter().copied()).map_err(PictureError::display)
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
    /// Switches `device` on, with a window of `size` pixels that look as on a screen of shape `aspect`.
    ///
    /// # Errors
    /// [`PictureError::LargerThanDevice`], and [`PictureError::Display`] if the emulated device does not start.
    pub fn new(device: Device, table: TableKind, size: Size, aspect: f64) -> Result<Self, PictureError> {
        let whole = device.size();
        if size.width() > whole.width() || size.height() > whole.height() {
            return Err(PictureError::LargerThanDevice { size, device });
        }
        let table = table.table(device.capabilities()).map_err(PictureError::display)?;
        Ok(Self { canvas: switch_on(device, Table(table))?, device, size, aspect })
    }

    /// Draws whole rows of gun levels, from row `first` down.
    ///
    /// # Errors
    /// [`PictureError::Display`] if there are more rows than the screen has, or levels beyond its guns.
    pub fn put_rows(&mut self, first: u32, levels: &[Rgb<u8>]) -> Result<(), PictureError> {
        for (y, row) in (first..).zip(levels.chunks(self.size.columns())) {
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

fn switch_on(device: Device, table: Table) -> Result<Box<dyn Canvas>, PictureError> {
    fn paint(
        display: impl ReadBack<Error: Send + Sync + 'static> + Send + 'static,
        table: Table,
    ) -> Result<Box<dyn Canvas>, PictureError> {
        Ok(Box::new(Painter::new(display, table).map_err(PictureError::display)?))
    }
    match device {
        Device::Vga => {
            let board = Vga::new(vec![0; vga13h::emulated::MEMORY_SIZE]).map_err(PictureError::display)?;
            paint(Mode13h::program(board), table)
        }
        Device::Graphigs => {
            let workstation = Workstation::new(vec![0; graphigs::emulated::MEMORY_SIZE]);
            let kind = graphigs::emulated::WORKSTATION_TYPE;
            paint(GraphigsDisplay::open(workstation, "IBM5081", kind).map_err(PictureError::display)?, table)
        }
        Device::Pixrect => {
            let board = Board::new(vec![0; pixrect::emulated::MEMORY_SIZE]).map_err(PictureError::display)?;
            paint(PixrectDisplay::new(Cgthree::open(board)).map_err(PictureError::display)?, table)
        }
    }
}

#[cfg(test)]
mod tests {
    use rta_core::color::Rgb;

    use super::{Screen, TableKind};
    use crate::picture::device::Device;
    use crate::picture::file::Pixels;
    use crate::picture::raster::Size;

    const ALL: [Device; 3] = [Device::Vga, Device::Graphigs, Device::Pixrect];

    #[test]
    fn a_picture_comes_back_from_every_device_in_its_own_levels() {
        for device in ALL {
            for (table, entries) in
                [(TableKind::Adaptive, 4), (TableKind::Tolerant, 4), (TableKind::Uniform, 125)]
            {
                let max = device.capabilities().gun_max;
                let size = Size::new(2, 2).expect("small");
                let mut screen = Screen::new(device, table, size, 1.0).expect("it starts");
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
            let mut screen = Screen::new(Device::Pixrect, table, size, 1.0).expect("it starts");
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
            assert!(Screen::new(device, TableKind::Adaptive, larger, 1.0).is_err());
            let mut screen = Screen::new(device, TableKind::Adaptive, whole, 1.0).expect("it starts");
            assert!(screen.put_rows(whole.height(), &[Rgb::default()]).is_err(), "{device}");
            let max = device.capabilities().gun_max;
            if max < u8::MAX {
                assert!(screen.put_rows(0, &[Rgb::new(max + 1, 0, 0)]).is_err(), "{device}");
            }
        }
    }
}
