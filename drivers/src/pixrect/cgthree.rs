//! The Sun cgthree frame buffer: the pixrect of a SPARCstation's screen.
//!
//! Sources: Brooktree, "Bt458 RAMDAC" data sheet (registers, address auto-increment); the SBus cgthree's
//! registers as its drivers in the BSDs and Linux know them: the colormap is written a word at a time, four
//! entries in three words.

use rta_core::color::Rgb;

use super::{CAPABILITIES, Pixrect, PixrectError, check_colormap, split_guns};
use crate::bus::{Memory, Registers};

/// Offsets and values of the board's registers.
pub mod registers {
    /// Bt458 address register: an entry of the colormap (as a word) or a control register (as a byte).
    pub const BT458_ADDRESS: u32 = 0x00;
    /// Bt458 colormap: red, green, blue in turn, packed in words from the most significant byte; the
    /// address advances after blue.
    pub const BT458_COLORMAP: u32 = 0x04;
    /// The Bt458 control register that the address names.
    pub const BT458_CONTROL: u32 = 0x08;
    /// Control register of the frame buffer.
    pub const CONTROL: u32 = 0x10;
    /// Bit of [`CONTROL`]: video is on.
    pub const VIDEO_ENABLE: u8 = 0x40;

    /// Bt458 register 4, read mask: ANDed with every pixel.
    pub const READ_MASK: u8 = 4;
    /// Bt458 register 5, blink mask: planes that blink.
    pub const BLINK_MASK: u8 = 5;
    /// Bt458 register 6, command.
    pub const COMMAND: u8 = 6;
    /// Bit of [`COMMAND`]: pixels go through the colormap, not to overlay colour 0. The other bits 0 mean
    /// 4:1 multiplexing and no overlays.
    pub const RAM_ENABLE: u8 = 0x40;
    /// Bt458 register 7, test.
    pub const TEST: u8 = 7;
}

use registers as reg;

/// Driver of a cgthree of 1152 x 900 over a bus that has its registers (offset 0 = 50400000h on a
/// SPARCstation 5) and its frame buffer (offset 0 = 50800000h).
///
/// The board's colormap is loaded in groups of four entries, so the driver keeps a copy of it (768 bytes),
/// which is also what [`Pixrect::pr_getcolormap`] reads, as boards differ in what they answer.
#[derive(Clone, Debug)]
pub struct Cgthree<B> {
    bus: B,
    colormap: [Rgb<u8>; 256],
    planes: u8,
}

impl<B: Registers + Memory> Cgthree<B> {
    /// Sets up the Bt458, loads a black colormap and switches the video on. The frame buffer is left as it
    /// is.
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

    /// The bus, to look at what is behind it.
    pub fn bus(&self) -> &B {
        &self.bus
    }

    /// Gives the bus back. The video stays on.
    pub fn release(self) -> B {
        self.bus
    }

    /// Loads the groups of four that have entries `first..end`.
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

/// Offset of a pixel in the frame buffer and how many of `len` pixels from there are on the screen.
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

    /// The board has no plane mask: operations read what they must not change.
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
