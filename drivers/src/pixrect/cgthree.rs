//! The Sun cgthree frame buffer: the pixrect of a SPARCstation's screen.
//!
//! Sources: Brooktree, "Bt458 RAMDAC" data sheet (registers, address auto-increment); for the board, the cgthree
//! drivers of the BSDs and Linux, which write the colormap a word at a time, four entries in three words.

use rta_core::color::Rgb;

use super::colormap::{check_colormap, split_guns};
use super::{CAPABILITIES, Pixrect, PixrectError};
use crate::bus::{Memory, Registers};

/// Offsets, in bytes from the board's first register, and values of the registers of a cgthree.
pub mod registers {
    /// Bt458 address register: the entry of the colormap or the control register that is accessed next. The driver
    /// writes an entry as a word and a control register as a byte.
    pub const BT458_ADDRESS: u32 = 0x00;
    /// Bt458 colormap: takes red, green and blue in turn, 0..=255 each, packed in words from the most significant
    /// byte; the address advances after blue.
    pub const BT458_COLORMAP: u32 = 0x04;
    /// The Bt458 control register whose number is in the address register.
    pub const BT458_CONTROL: u32 = 0x08;
    /// Control register of the board, outside the Bt458.
    pub const CONTROL: u32 = 0x10;
    /// Bit 6 of [`CONTROL`], video enable: the screen is on.
    pub const VIDEO_ENABLE: u8 = 0x40;

    /// Bt458 register 4, read mask: it is ANDed with every pixel on the way to the colormap.
    pub const READ_MASK: u8 = 4;
    /// Bt458 register 5, blink mask: the planes whose bit is 1 blink.
    pub const BLINK_MASK: u8 = 5;
    /// Bt458 register 6, command register.
    pub const COMMAND: u8 = 6;
    /// Bit 6 of [`COMMAND`], RAM enable: pixels go through the colormap; otherwise overlay colour 0 is shown. With
    /// all other bits 0 the pixels are multiplexed 4:1 and there are no overlays.
    pub const RAM_ENABLE: u8 = 0x40;
    /// Bt458 register 7, test register: 0 in normal use.
    pub const TEST: u8 = 7;
}

use registers as reg;

/// Driver of a cgthree of 1152 x 900 over a bus that has its registers (offset 0 = 50400000h on a
/// SPARCstation 5) and its frame buffer (offset 0 = 50800000h).
///
/// The board's colormap is loaded in groups of four entries, so the driver keeps a copy of it (768 bytes) to fill
/// up a group. [`Pixrect::pr_getcolormap`] reads this copy too, because boards differ in what they answer when their
/// colormap is read.
#[derive(Clone, Debug)]
pub struct Cgthree<B> {
    bus: B,
    colormap: [Rgb<u8>; 256],
    planes: u8,
}

impl<B: Registers + Memory> Cgthree<B> {
    /// Sets up the Bt458, loads a black colormap and switches the video on. The frame buffer is left as it is.
    pub fn open(bus: B) -> Self {
        let mut board = Self { bus, colormap: [Rgb::new(0, 0, 0); 256], planes: 0xFF };
        let setup =
            [(reg::READ_MASK, 0xFF), (reg::BLINK_MASK, 0), (reg::COMMAND, reg::RAM_ENABLE), (reg::TEST, 0)];
        for (register, value) in setup {
            board.bus.write8(reg::BT458_ADDRESS, register);
            board.bus.write8(reg::BT458_CONTROL, value);
        }
        board.load(0, 256);
        let control = board.bus.read8(reg::CONTROL);
        board.bus.write8(reg::CONTROL, control | reg::VIDEO_ENABLE);
        board
    }

    /// Borrows the bus, for example to plug a monitor into an emulated board.
    pub fn bus(&self) -> &B {
        &self.bus
    }

    /// Gives the bus back. The video stays on.
    pub fn release(self) -> B {
        self.bus
    }

    /// Loads the entries `first..end` from the copy, and those that share a group of four with them.
    fn load(&mut self, first: usize, end: usize) {
        let aligned = first & !3;
        let entries = self.colormap.get(aligned..end.next_multiple_of(4)).unwrap_or(&[]);
        if let (Ok(address), Some(_)) = (u32::try_from(aligned), entries.first()) {
            self.bus.write32(reg::BT458_ADDRESS, address);
        }
        for group in entries.as_chunks::<4>().0 {
            let [a, b, c, d] = *group;
            self.bus.write32(reg::BT458_COLORMAP, u32::from_be_bytes([a.r, a.g, a.b, b.r]));
            self.bus.write32(reg::BT458_COLORMAP, u32::from_be_bytes([b.g, b.b, c.r, c.g]));
            self.bus.write32(reg::BT458_COLORMAP, u32::from_be_bytes([c.b, d.r, d.g, d.b]));
        }
    }
}

/// Returns the offset of a pixel in the frame buffer and how many of the `len` pixels from there to the right are on
/// the screen.
fn span(x: u32, y: u32, len: usize) -> (u32, usize) {
    if x >= CAPABILITIES.width || y >= CAPABILITIES.height {
        return (0, 0);
    }
    let room = usize::try_from(CAPABILITIES.width - x).unwrap_or(usize::MAX);
    (y * CAPABILITIES.width + x, len.min(room))
}

impl<B: Registers + Memory> Pixrect for Cgthree<B> {
    fn size(&self) -> (u32, u32) {
        (CAPABILITIES.width, CAPABILITIES.height)
    }

    fn depth(&self) -> u8 {
        8
    }

    fn planes(&self) -> u8 {
        self.planes
    }

    /// Sets the plane mask. The board has none, so operations read the pixels whose planes they must keep.
    fn pr_putattributes(&mut self, planes: u8) {
        self.planes = planes;
    }

    fn read_row(&mut self, x: u32, y: u32, pixels: &mut [u8]) {
        let (offset, len) = span(x, y, pixels.len());
        if let Some(pixels) = pixels.get_mut(..len) {
            self.bus.read(offset, pixels);
        }
    }

    fn write_row(&mut self, x: u32, y: u32, pixels: &[u8]) {
        let (offset, len) = span(x, y, pixels.len());
        if let Some(pixels) = pixels.get(..len) {
            self.bus.write(offset, pixels);
        }
    }

    fn pr_putcolormap(
        &mut self,
        index: usize,
        red: &[u8],
        green: &[u8],
        blue: &[u8],
    ) -> Result<(), PixrectError> {
        check_colormap(index, red.len(), green.len(), blue.len())?;
        let entries = self.colormap.iter_mut().skip(index);
        for (((entry, &r), &g), &b) in entries.zip(red).zip(green).zip(blue) {
            *entry = Rgb::new(r, g, b);
        }
        if !red.is_empty() {
            self.load(index, index + red.len());
        }
        Ok(())
    }

    fn pr_getcolormap(
        &mut self,
        index: usize,
        red: &mut [u8],
        green: &mut [u8],
        blue: &mut [u8],
    ) -> Result<(), PixrectError> {
        check_colormap(index, red.len(), green.len(), blue.len())?;
        split_guns(self.colormap.get(index..).unwrap_or(&[]), red, green, blue);
        Ok(())
    }
}
