//! Draws: the one user of [`Display`] and [`ColorTable`], for emulated and real devices alike.

use rta_core::color::Rgb;

use crate::display::Display;
use crate::quantize::ColorTable;

/// Pixels written at once; they wait on the stack.
const CHUNK: usize = 64;

/// Puts gun levels on a display: quantises them, loads the colours that the table has newly made, and
/// writes the pixels, in this order, so that no pixel is ever shown in a colour not its own.
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
    /// Entries of the table that the display has.
    loaded: usize,
}

impl<D: Display, T: ColorTable> Painter<D, T> {
    /// Takes a display and a table and loads the entries that the table already has.
    ///
    /// # Errors
    /// Those of [`Display::set_colors`]: the table is larger than the display's.
    pub fn new(display: D, table: T) -> Result<Self, D::Error> {
        let mut painter = Self { display, table, loaded: 0 };
        painter.load_new_colors()?;
        Ok(painter)
    }

    /// Draws gun levels, each register 0..=gun_max of the display, from (`x`, `y`) to the right. A row
    /// need not be whole: one pixel at a time is allowed.
    ///
    /// # Errors
    /// Those of the display; the row may then be drawn in part.
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
                // There is room for as many as are taken.
                let _ = indices.push(self.table.index(levels));
            }
            if indices.is_empty() {
                return Ok(());
            }
            self.load_new_colors()?;
            self.display.put_pixels(x, y, &indices)?;
            // Beyond u32 nothing is on a screen: the display refuses the next pixel.
            x = x.saturating_add(u32::try_from(indices.len()).unwrap_or(u32::MAX));
        }
    }

    /// Makes visible all that was drawn so far.
    ///
    /// # Errors
    /// Those of the display.
    pub fn update(&mut self) -> Result<(), D::Error> {
        self.display.update()
    }

    /// The display.
    pub fn display(&self) -> &D {
        &self.display
    }

    /// The display, to be read or driven in between.
    pub fn display_mut(&mut self) -> &mut D {
        &mut self.display
    }

    /// The colour table.
    pub fn table(&self) -> &T {
        &self.table
    }

    /// Gives both back.
    pub fn into_parts(self) -> (D, T) {
        (self.display, self.table)
    }

    fn load_new_colors(&mut self) -> Result<(), D::Error> {
        let entries = self.table.entries();
        if let (Some(new @ [_, ..]), Ok(first)) = (entries.get(self.loaded..), u8::try_from(self.loaded)) {
            self.display.set_colors(first, new)?;
            self.loaded = entries.len();
        }
        Ok(())
    }
}
