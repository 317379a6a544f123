//! Draws rows of gun levels on any display through any colour table.

use rta_core::color::Rgb;

use crate::display::Display;
use crate::quantize::ColorTable;

/// Pixels quantised and written at a time, in a buffer of as many bytes on the stack.
const CHUNK: usize = 64;

/// Puts gun levels on a display. It quantises them, loads the entries that the colour table has appended, and writes
/// the pixels, in this order, so that no pixel is ever shown in a colour that is not its own.
///
/// ```
/// use rta_core::color::Rgb;
/// use rta_drivers::display::{Display, ReadBack};
/// use rta_drivers::painter::Painter;
/// use rta_drivers::quantize::Adaptive;
/// use rta_drivers::vga13h::{Mode13h, emulated::Vga};
///
/// let mut memory = [0; 0x1_0000];
/// let screen = Mode13h::program(Vga::new(&mut memory[..])?);
/// let mut painter = Painter::new(screen, Adaptive::new(256)?)?;
/// painter.put_row(0, 100, (0..320_u16).map(|x| Rgb::new((x / 5) as u8, 0, 63)))?;
/// painter.update()?;
///
/// let (mut screen, table) = painter.into_parts();
/// let mut row = [0; 320];
/// screen.read_pixels(0, 100, &mut row)?;
/// assert_eq!((row[0], row[319]), (1, 64)); // 64 blues after the background
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Painter<D, T> {
    display: D,
    table: T,
    /// How many entries of the table the display has loaded.
    loaded: usize,
}

impl<D: Display, T: ColorTable> Painter<D, T> {
    /// Takes a display and a colour table and loads the entries that the table already has.
    ///
    /// # Errors
    /// Those of [`Display::set_colors`]; among them, the table has more entries than the display's, or levels beyond
    /// its guns.
    pub fn new(display: D, table: T) -> Result<Self, D::Error> {
        let mut painter = Self { display, table, loaded: 0 };
        painter.load_new_colors()?;
        Ok(painter)
    }

    /// Draws pixels of row `y` from column `x` to the right, given as gun levels of 0..=`gun_max` of the display. Any
    /// part of a row may be drawn by one call, also a single pixel.
    ///
    /// # Errors
    /// Those of [`Display::set_colors`] and [`Display::put_pixels`]; some of the pixels may be drawn then.
    pub fn put_row(
        &mut self,
        x: u32,
        y: u32,
        levels: impl IntoIterator<Item = Rgb<u8>>,
    ) -> Result<(), D::Error> {
        let mut levels = levels.into_iter();
        let mut x = x;
        loop {
            let mut indices = heapless::Vec::<u8, CHUNK>::new();
            for levels in levels.by_ref().take(CHUNK) {
                // Never full: no more are taken than the buffer holds.
                let _ = indices.push(self.table.index(levels));
            }
            if indices.is_empty() {
                return Ok(());
            }
            self.load_new_colors()?;
            self.display.put_pixels(x, y, &indices)?;
            // No screen has a column u32::MAX, so the display refuses a pixel after saturation.
            x = x.saturating_add(u32::try_from(indices.len()).unwrap_or(u32::MAX));
        }
    }

    /// Makes visible all that was drawn so far.
    ///
    /// # Errors
    /// Those of [`Display::update`].
    pub fn update(&mut self) -> Result<(), D::Error> {
        self.display.update()
    }

    /// Borrows the display.
    pub fn display(&self) -> &D {
        &self.display
    }

    /// Borrows the display to read it or to draw on it directly. Entries of the colour table that the painter has
    /// loaded must stay as they are.
    pub fn display_mut(&mut self) -> &mut D {
        &mut self.display
    }

    /// Borrows the colour table.
    pub fn table(&self) -> &T {
        &self.table
    }

    /// Gives the display and the colour table back.
    pub fn into_parts(self) -> (D, T) {
        (self.display, self.table)
    }

    /// Loads the entries that the table has appended since the last call.
    fn load_new_colors(&mut self) -> Result<(), D::Error> {
        let entries = self.table.entries();
        if let (Some(new @ [_, ..]), Ok(first)) = (entries.get(self.loaded..), u8::try_from(self.loaded)) {
            self.display.set_colors(first, new)?;
            self.loaded = entries.len();
        }
        Ok(())
    }
}
