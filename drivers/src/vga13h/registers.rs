//! Ports of a VGA and the register values of mode 13h.
//!
//! Source: IBM, "PS/2 Hardware Interface Technical Reference, Video Subsystem". The ports are those that a VGA has
//! while bit 0 of its miscellaneous output register is 1 (colour); with 0 (monochrome), 3Dxh are at 3Bxh.

/// Attribute controller: takes an index and its data in turn, told apart by a flip-flop. The data is read at the
/// next port.
pub const ATTRIBUTE: u16 = 0x3C0;
/// Miscellaneous output register, for writing.
pub const MISC_WRITE: u16 = 0x3C2;
/// Sequencer index; data is at the next port.
pub const SEQUENCER: u16 = 0x3C4;
/// Pel mask: it is ANDed with every pixel on its way to the DAC.
pub const PEL_MASK: u16 = 0x3C6;
/// DAC: writing sets the index to read from; reading returns the state in bits 0 and 1, 3 while colours are read
/// and 0 while they are written.
pub const DAC_READ_INDEX: u16 = 0x3C7;
/// DAC: writing sets the index to write to.
pub const DAC_WRITE_INDEX: u16 = 0x3C8;
/// DAC: the levels of red, green and blue in turn, 0..=63 each; the index advances after blue.
pub const DAC_DATA: u16 = 0x3C9;
/// Miscellaneous output register, for reading.
pub const MISC_READ: u16 = 0x3CC;
/// Graphics controller index; data is at the next port.
pub const GRAPHICS: u16 = 0x3CE;
/// CRT controller index; data is at the next port.
pub const CRTC: u16 = 0x3D4;
/// Input status register 1. Reading it also resets the flip-flop of the attribute controller: the next write to
/// [`ATTRIBUTE`] is an index.
pub const INPUT_STATUS_1: u16 = 0x3DA;

/// Bit 3 of [`INPUT_STATUS_1`]: the beam is in its vertical retrace.
pub const VERTICAL_RETRACE: u8 = 0x08;
/// Bit 0 of [`INPUT_STATUS_1`]: no pixel is being displayed, because of a horizontal or a vertical retrace.
pub const DISPLAY_DISABLED: u8 = 0x01;
/// Bit 5 of the attribute index: the picture is shown through the palette registers, which cannot be written
/// meanwhile; with 0 the screen is dark.
pub const PALETTE_ADDRESS_SOURCE: u8 = 0x20;
/// The CRTC register whose bit 7 write-protects registers 0 to 7.
pub const CRTC_PROTECT_INDEX: u8 = 0x11;
/// Bit 7 of CRTC register 11h: registers 0 to 7 are write-protected.
pub const CRTC_PROTECT: u8 = 0x80;

/// Miscellaneous output of mode 13h: pixel clock 25.175 MHz, 400 lines, memory enabled, ports of a colour display.
pub const MISC: u8 = 0x63;
/// Sequencer registers 0 to 4 of mode 13h: chain 4, by which the four planes appear as one linear window.
pub const SEQUENCER_VALUES: [u8; 5] = [0x03, 0x01, 0x0F, 0x00, 0x0E];
/// CRTC registers 0 to 18h of mode 13h: timings of 400 lines, on which each of the 200 rows is shown twice.
pub const CRTC_VALUES: [u8; 25] = [
    0x5F, 0x4F, 0x50, 0x82, 0x54, 0x80, 0xBF, 0x1F, 0x00, 0x41, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x9C,
    0x8E, 0x8F, 0x28, 0x40, 0x96, 0xB9, 0xA3, 0xFF,
];
/// Graphics controller registers 0 to 8 of mode 13h: shifting for 256 colours, the window of 64 KiB at A0000h.
pub const GRAPHICS_VALUES: [u8; 9] = [0x00, 0x00, 0x00, 0x00, 0x00, 0x40, 0x05, 0x0F, 0xFF];
/// Attribute controller registers 0 to 14h of mode 13h: the palette is the identity, pixels are 8 bits wide.
pub const ATTRIBUTE_VALUES: [u8; 21] = [
    0x00, 0x01, 0x02, 0x03, 0x04, 0x05, 0x06, 0x07, 0x08, 0x09, 0x0A, 0x0B, 0x0C, 0x0D, 0x0E, 0x0F, 0x41,
    0x00, 0x0F, 0x00, 0x00,
];
