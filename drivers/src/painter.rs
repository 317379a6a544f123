//! Draws rows of light on any display through any colour table, dithered or not.

use rta_core::color::Rgb;

use crate::display::{Display, reduce};
use crate::dither::{Dither, Plain};
use crate::quantize::ColorTable;

/// Pixels quantised and written at a time, in a buffer of as many bytes on the stack.
const CHUNK: usize = 64;

/// Puts light on a display. It quantises it, loads the entries that the colour table has appended, and writes
/// the pixels, in this order, so that no pixel is ever shown in a colour that is not its own.
///
/// How finely the light is to be rounded before, [`Painter::light_max`] says: dithering needs all 8 bits, and a table that is looked up as the
/// guns show it, no more than their levels.
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
/// assert_eq!(painter.light_max(), 63);
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
pub struct Painter<D, T, H = Plain> {
    display: D,
    table: T,
    dither: H,
    /// How many entries of the table the display has loaded.
    loaded: usize,
}

impl<D: Display, T: ColorTable> Painter<D, T> {
    /// Takes a display and a colour table and loads the entries that the table already has. Nothing is dithered.
    ///
    /// # Errors
    /// Those of [`Display::set_colors`]; among them, the table has more entries than the display's, or levels beyond
    /// its guns.
    pub fn new(display: D, table: T) -> Result<Self, D::Error> {
        Self::dithered(display, table, Plain)
    }
}

impl<D: Display, T: ColorTable, H: Dither> Painter<D, T, H> {
    /// Takes a display, a colour table and a way of dithering, and loads the entries that the table already has.
    ///
    /// # Errors
    /// Those of [`Painter::new`].
    pub fn dithered(display: D, table: T, dither: H) -> Result<Self, D::Error> {
        let mut painter = Self { display, table, dither, loaded: 0 };
        painter.load_new_colors()?;
        Ok(painter)
    }

    /// Returns the highest level of the light that [`Painter::put_row`] takes: the display's `gun_max`, or 255.
    pub fn light_max(&self) -> u8 {
        self.dither.light_max(&self.table, self.display.capabilities().gun_max)
    }

    /// Draws pixels of row `y` from column `x` to the right, given as levels of 0..=[`light_max`](Painter::light_max). Any
    /// part of a row may be drawn by one call, also a single pixel, unless [`Diffusion`](crate::dither::Diffusion) asks for whole rows in
    /// order. The dithering may take the pixels from the end.
    ///
    /// # Errors
    /// Those of [`Display::set_colors`] and [`Display::put_pixels`]; some of the pixels may be drawn then.
    pub fn put_row(
        &mut self,
        x: u32,
        y: u32,
        light: impl IntoIterator<Item = Rgb<u8>, IntoIter: DoubleEndedIterator + ExactSizeIterator>,
    ) -> Result<(), D::Error> {
        let gun_max = self.display.capabilities().gun_max;
        let mut light = light.into_iter();
        let leftward = self.dither.start_row(x, y, light.len());
        // No screen has a column u32::MAX, so the display refuses a pixel after saturation.
        let (mut x, right) = (x, x.saturating_add(u32::try_from(light.len()).unwrap_or(u32::MAX)));
        if leftward {
            let mut x = right;
            while let Some(light) = light.next_back() {
                x = x.saturating_sub(1);
                self.dither.index(&mut self.table, gun_max, (x, y), light);
            }
        }
        loop {
            let mut indices = heapless::Vec::<u8, CHUNK>::new();
            let first = x;
            // A display is sent each row from left to right, whichever way it was dithered: not every one can be addressed freely.
            while !indices.is_full() {
                let index = if leftward {
                    if x == right {
                        break;
                    }
                    self.dither.drawn(x)
                } else {
                    let Some(light) = light.next() else { break };
                    self.dither.index(&mut self.table, gun_max, (x, y), light)
                };
                // Not full, so there is room.
                let _ = indices.push(index);
                x = x.saturating_add(1);
            }
            if indices.is_empty() {
                return Ok(());
            }
            self.load_new_colors()?;
            self.display.put_pixels(first, y, &indices)?;
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

    /// Loads the entries that the table has appended since the last call, as levels of the guns.
    fn load_new_colors(&mut self) -> Result<(), D::Error> {
        let gun_max = self.display.capabilities().gun_max;
        let as_light = self.table.light_max(gun_max) != gun_max;
        let entries = self.table.entries();
        while let (Some(new @ [_, ..]), Ok(first)) = (entries.get(self.loaded..), u8::try_from(self.loaded)) {
            if as_light {
                let mut levels = heapless::Vec::<_, CHUNK>::new();
                levels.extend(new.iter().take(CHUNK).map(|entry| entry.map(|level| reduce(level, gun_max))));
                self.display.set_colors(first, &levels)?;
                self.loaded += levels.len();
            } else {
                self.display.set_colors(first, new)?;
                self.loaded = entries.len();
            }
        }
        Ok(())
    }
}
