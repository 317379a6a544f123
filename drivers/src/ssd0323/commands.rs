//! The commands of an SSD0323, apart from what is done with them. Names are those of Solomon Systech's data sheet (SSD0323, "Command
//! Table" and "Command Descriptions"); unless stated otherwise one byte follows.

/// Columns of the graphic memory: bytes of a row, of two pixels each.
pub const COLUMNS: u8 = 64;
/// Rows of the graphic memory, of which the panel of 128 x 64 shows the first 64.
pub const ROWS: u8 = 80;

/// Set Column Address: the first column of the window, 0..=63, and the last. The next byte of data goes to the first.
pub const COLUMN_ADDRESS: u8 = 0x15;
/// Set Row Address: the first row of the window, 0..=79, and the last.
pub const ROW_ADDRESS: u8 = 0x75;
/// Set Contrast Current: 0..=127.
pub const CONTRAST: u8 = 0x81;
/// Set Current Range: a quarter. Nothing follows.
pub const QUARTER_CURRENT: u8 = 0x84;
/// Set Current Range: half. Nothing follows.
pub const HALF_CURRENT: u8 = 0x85;
/// Set Current Range: full. Nothing follows.
pub const FULL_CURRENT: u8 = 0x86;
/// Set Re-map: the bits [`REMAP_COLUMN`], [`REMAP_NIBBLE`], [`REMAP_VERTICAL`], [`REMAP_COM`] and [`REMAP_SPLIT`].
pub const REMAP: u8 = 0xA0;
/// Set Display Start Line: the row of the memory that is shown at the top, 0..=79.
pub const START_LINE: u8 = 0xA1;
/// Set Display Offset: the line of the panel at which that row is, 0..=79.
pub const DISPLAY_OFFSET: u8 = 0xA2;
/// Set Display Mode: what the memory has. Nothing follows.
pub const NORMAL: u8 = 0xA4;
/// Set Display Mode: all pixels at level 15. Nothing follows.
pub const ALL_ON: u8 = 0xA5;
/// Set Display Mode: all pixels off. Nothing follows.
pub const ALL_OFF: u8 = 0xA6;
/// Set Display Mode: 15 less the level of each pixel. Nothing follows.
pub const INVERSE: u8 = 0xA7;
/// Set Multiplex Ratio: lines of the panel less 1, 15..=79.
pub const MULTIPLEX: u8 = 0xA8;
/// Set Master Configuration: 2 without the DC-DC converter of the controller, 3 with it.
pub const MASTER: u8 = 0xAD;
/// Set Display Off: sleep. Nothing follows.
pub const OFF: u8 = 0xAE;
/// Set Display On. Nothing follows.
pub const ON: u8 = 0xAF;
/// Set Phase Length, in clocks: of reset in the low nibble, of precharge in the high one.
pub const PHASE_LENGTH: u8 = 0xB1;
/// Set Row Period, in clocks.
pub const ROW_PERIOD: u8 = 0xB2;
/// Set Display Clock Divide Ratio, less 1, in the low nibble; frequency of the oscillator in the high one.
pub const CLOCK: u8 = 0xB3;
/// Set Grey Scale Table. Eight bytes follow: how much longer the pulse of each level is than that of the level below, a nibble each.
pub const GREY_SCALE: u8 = 0xB8;
/// Set Precharge Voltage.
pub const PRECHARGE: u8 = 0xBC;
/// Set VCOMH Voltage.
pub const VCOMH: u8 = 0xBE;
/// Set Segment Low Voltage.
pub const SEGMENT_LOW: u8 = 0xBF;
/// No operation. Nothing follows.
pub const NOP: u8 = 0xE3;

/// Bit of [`REMAP`]: the columns are shown from right to left.
pub const REMAP_COLUMN: u8 = 0x01;
/// Bit of [`REMAP`]: of a byte's two pixels the high nibble is the left one, not the low one.
pub const REMAP_NIBBLE: u8 = 0x02;
/// Bit of [`REMAP`]: data goes down the columns of the window, not along its rows.
pub const REMAP_VERTICAL: u8 = 0x04;
/// Bit of [`REMAP`]: the common lines are scanned from the last to the first.
pub const REMAP_COM: u8 = 0x10;
/// Bit of [`REMAP`]: even common lines are at one side of the panel and odd ones at the other.
pub const REMAP_SPLIT: u8 = 0x40;

/// How a panel of 128 x 64 by OSRAM (Pictiva) is wired, as on the Stellaris evaluation board: with these bits its picture is upright and
/// the high nibble of a byte is the left pixel.
pub const PICTIVA: u8 = REMAP_SPLIT | REMAP_COM | REMAP_NIBBLE;

/// The commands that set up the controller for such a panel, all but the last, [`ON`]. Currents, voltages, times and the grey scale are those
/// of the evaluation board.
#[rustfmt::skip]
pub const SETUP: [u8; 36] = [
    OFF,
    CONTRAST, 50,
    HALF_CURRENT,
    REMAP, PICTIVA,
    START_LINE, 0,
    DISPLAY_OFFSET, 0,
    NORMAL,
    MULTIPLEX, 63,
    PHASE_LENGTH, 0x22,
    ROW_PERIOD, 70,
    CLOCK, 0xF1,
    SEGMENT_LOW, 0x0D,
    VCOMH, 0x02,
    PRECHARGE, 0x10,
    GREY_SCALE, 0x01, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65, 0x76,
    MASTER, 0x03,
];

/// Returns how many bytes follow a command; `None` for those of the graphic accelerator and those that do not exist.
pub const fn arguments(command: u8) -> Option<usize> {
    match command {
        QUARTER_CURRENT..=FULL_CURRENT | NORMAL..=INVERSE | OFF | ON | NOP => Some(0),
        CONTRAST | REMAP..=DISPLAY_OFFSET | MULTIPLEX | MASTER => Some(1),
        PHASE_LENGTH..=CLOCK | PRECHARGE | VCOMH | SEGMENT_LOW => Some(1),
        COLUMN_ADDRESS | ROW_ADDRESS => Some(2),
        GREY_SCALE => Some(8),
        _ => None,
    }
}

/// Returns the commands that set the window to the given first and last column and row, and the next byte of data to its first.
pub const fn window(columns: (u8, u8), rows: (u8, u8)) -> [u8; 6] {
    [COLUMN_ADDRESS, columns.0, columns.1, ROW_ADDRESS, rows.0, rows.1]
}
