//! The Sun cgthree under PIXRECT, register by register.

use rta_core::color::Rgb;
use rta_drivers::bus::{Memory, Registers, ShortMemory};
use rta_drivers::pixrect::emulated::{Blank, Board, MEMORY_SIZE};
use rta_drivers::pixrect::{Cgthree, Pixrect, PixrectError};

/// An emulated board after reset, its frame buffer cleared.
pub(crate) fn board() -> Board<Vec<u8>> {
    Board::new(vec![0; MEMORY_SIZE]).unwrap()
}

/// A bus that records the register writes, as pairs of offset and value, and passes every access on to an
/// emulated board.
struct Recorder {
    board: Board<Vec<u8>>,
    writes: Vec<(u32, u32)>,
}

impl Recorder {
    fn new() -> Self {
        Self { board: board(), writes: Vec::new() }
    }
}

impl Registers for Recorder {
    fn write8(&mut self, offset: u32, value: u8) {
        self.writes.push((offset, value.into()));
        self.board.write8(offset, value);
    }
    fn read8(&mut self, offset: u32) -> u8 {
        self.board.read8(offset)
    }
    fn write32(&mut self, offset: u32, value: u32) {
        self.writes.push((offset, value));
        self.board.write32(offset, value);
    }
}

impl Memory for Recorder {
    fn write(&mut self, offset: u32, bytes: &[u8]) {
        self.board.write(offset, bytes);
    }
    fn read(&mut self, offset: u32, bytes: &mut [u8]) {
        self.board.read(offset, bytes);
    }
}

#[test]
fn opening_a_cgthree_is_this_sequence() {
    let writes = Cgthree::open(Recorder::new()).release().writes;
    let bt458 = [(0, 4), (8, 0xFF), (0, 5), (8, 0), (0, 6), (8, 0x40), (0, 7), (8, 0), (0, 0)];
    assert_eq!(writes[..9], bt458);
    assert_eq!(writes[9..201], [(4, 0); 192]);
    assert_eq!(writes[201..], [(0x10, 0x40)]);
}

#[test]
fn the_colormap_is_loaded_in_words_of_whole_groups() {
    let mut screen = Cgthree::open(Recorder::new());
    let start = screen.bus().writes.len();
    // Entries 3 to 6 are in two groups of four: 0 to 3 and 4 to 7.
    screen.pr_putcolormap(3, &[1, 4, 7, 10], &[2, 5, 8, 11], &[3, 6, 9, 12]).unwrap();
    let groups =
        [(0, 0), (4, 0), (4, 0), (4, 0x0001_0203), (4, 0x0405_0607), (4, 0x0809_0A0B), (4, 0x0C00_0000)];
    assert_eq!(screen.bus().writes[start..], groups);
    screen.pr_putcolormap(255, &[20], &[21], &[22]).unwrap();
    assert_eq!(screen.bus().writes[start + groups.len()..], [(0, 252), (4, 0), (4, 0), (4, 0x0014_1516)]);
    screen.pr_put(1151, 899, 255).unwrap();
    assert_eq!(screen.bus().board.monitor().unwrap().pixel(1151, 899), Some(Rgb::new(20, 21, 22)));

    let before = screen.bus().writes.len();
    for (index, r, g) in [(256, 1, 1), (255, 2, 2), (usize::MAX, 1, 1), (0, 257, 257), (0, 2, 1)] {
        let (red, green) = (vec![9; r], vec![9; g]);
        assert_eq!(screen.pr_putcolormap(index, &red, &green, &red), Err(PixrectError::Colormap));
        let (mut red, mut green, mut blue) = (red.clone(), green.clone(), red);
        let read = screen.pr_getcolormap(index, &mut red, &mut green, &mut blue);
        assert_eq!(read, Err(PixrectError::Colormap));
    }
    screen.pr_putcolormap(256, &[], &[], &[]).unwrap();
    assert_eq!(screen.bus().writes.len(), before, "refused and empty calls write nothing");
    let (mut r, mut g, mut b) = ([0; 4], [0; 4], [0; 4]);
    screen.pr_getcolormap(3, &mut r, &mut g, &mut b).unwrap();
    assert_eq!((r, g, b), ([1, 4, 7, 10], [2, 5, 8, 11], [3, 6, 9, 12]));
}

#[test]
fn the_bt458_counts_in_bytes_and_words() {
    let mut screen = Cgthree::open(board()).release();
    screen.write8(0x00, 255);
    for value in [1, 2, 3, 4, 5, 6] {
        screen.write8(0x04, value); // 255, then 0: the address wraps
    }
    screen.write8(0x04, 99); // red alone changes nothing
    screen.write32(0x00, 1); // and an address starts the sequence anew
    screen.write32(0x04, 0x0708_090A);
    screen.write32(0x04, 0x0B0C_0D0E);
    screen.write(0, &[255, 0, 1, 2, 3]);
    let monitor = screen.monitor().unwrap();
    let shown: Vec<_> = (0..5).map(|x| monitor.pixel(x, 0).unwrap()).collect();
    let rgb = Rgb::new;
    assert_eq!(shown, [rgb(1, 2, 3), rgb(4, 5, 6), rgb(7, 8, 9), rgb(10, 11, 12), rgb(0, 0, 0)]);
    // The read mask is applied on the way to the screen.
    screen.write8(0x00, 4);
    screen.write8(0x08, 0x01);
    assert_eq!(screen.read8(0x08), 1);
    assert_eq!(screen.monitor().unwrap().pixel(3, 0), Some(rgb(4, 5, 6)));
    assert_eq!(screen.monitor().unwrap().pixel(0, 0), Some(rgb(7, 8, 9)));
    screen.write8(0x00, 6);
    screen.write8(0x08, 0);
    assert_eq!(screen.monitor().unwrap_err(), Blank::RamOff);
    screen.write8(0x10, 0);
    assert_eq!(screen.monitor().unwrap_err(), Blank::VideoOff);
    for offset in [0x04, 0x0C, 0x20, u32::MAX] {
        screen.write8(offset, 1);
        assert_eq!(screen.read8(offset), 0, "{offset:X}h");
    }
    let short = Board::new(vec![0; 10]).unwrap_err();
    assert_eq!(short, ShortMemory { needed: 1_036_800, found: 10 });
}

#[test]
fn the_frame_buffer_ends_with_the_screen() {
    let mut machine = board();
    let mut bytes = [0; 3];
    machine.write(1_036_798, &[1, 2, 3]);
    machine.read(1_036_798, &mut bytes);
    assert_eq!(bytes, [1, 2, 0xFF]);
    machine.write(u32::MAX, &[1, 2, 3]);
    machine.read(u32::MAX, &mut bytes);
    assert_eq!(bytes, [0xFF; 3]);
    // A row that leaves the screen on the right does not go on in the next.
    let mut screen = Cgthree::open(machine);
    screen.write_row(1150, 0, &[7; 5]);
    assert_eq!([screen.pr_get(1150, 0), screen.pr_get(1151, 0), screen.pr_get(0, 1)], [Ok(7), Ok(7), Ok(0)]);
    screen.write_row(0, 900, &[7; 5]);
    screen.write_row(u32::MAX, u32::MAX, &[7; 5]);
}
