//! What every display of this crate must do, whichever device is behind it.

use rta_core::color::Rgb;
use rta_drivers::display::{DriverError, ReadBack};
use rta_drivers::graphigs::{self, GraphigsDisplay, emulated::Workstation};
use rta_drivers::painter::Painter;
use rta_drivers::pixrect::{self, Cgthree, PixrectDisplay, emulated::Board};
use rta_drivers::quantize::{Adaptive, ColorTable, Uniform};
use rta_drivers::vga13h::{self, Mode13h, emulated::Vga};

fn vga() -> Mode13h<Vga<Vec<u8>>> {
    Mode13h::program(Vga::new(vec![0x55; vga13h::emulated::MEMORY_SIZE]).unwrap())
}

fn graphigs() -> GraphigsDisplay<Workstation<Vec<u8>>> {
    let machine = Workstation::new(vec![0x55; graphigs::emulated::MEMORY_SIZE]);
    GraphigsDisplay::open(machine, "IBM5081", graphigs::emulated::WORKSTATION_TYPE).unwrap()
}

fn pixrect() -> PixrectDisplay<Cgthree<Board<Vec<u8>>>> {
    let board = Board::new(vec![0; pixrect::emulated::MEMORY_SIZE]).unwrap();
    PixrectDisplay::new(Cgthree::open(board)).unwrap()
}

/// A colour of levels 0..=`max` for each entry of a table: black for entry 0, different ones for entries
/// close together.
fn color(index: u16, max: u8) -> Rgb<u8> {
    let part = |n: u16| u8::try_from(n % (u16::from(max) + 1)).unwrap();
    Rgb::new(part(index), part(index / 2), part(index / 7))
}

/// Loads the whole table in pieces of different lengths, draws the four corners and one row, and reads all of
/// it back.
fn holds_what_it_is_given<D: ReadBack>(mut display: D) {
    let has = display.capabilities();
    let table: Vec<_> = (0..has.colors).map(|i| color(i, has.gun_max)).collect();
    let mut first = 0;
    for len in (1..).map(|n| n * 3) {
        let piece = &table[first..(first + len).min(table.len())];
        display.set_colors(u8::try_from(first).unwrap(), piece).unwrap();
        first += piece.len();
        if first == table.len() {
            break;
        }
    }
    let mut read = vec![Rgb::new(0, 0, 0); table.len()];
    display.read_colors(0, &mut read).unwrap();
    assert_eq!(read, table);
    // A single entry is loaded without changing its neighbours.
    display.set_colors(5, &[color(9, has.gun_max)]).unwrap();
    display.read_colors(4, &mut read[..3]).unwrap();
    assert_eq!(read[..3], [table[4], table[9], table[6]]);

    let (right, bottom) = (has.width - 1, has.height - 1);
    let last = u8::try_from(has.colors - 1).unwrap();
    for (x, y, index) in [(0, 0, 1), (right, 0, 2), (0, bottom, 3), (right, bottom, last)] {
        display.put_pixels(x, y, &[index]).unwrap();
    }
    let row: Vec<u8> = (0..has.width).map(|x| u8::try_from(x % u32::from(has.colors)).unwrap()).collect();
    display.put_pixels(0, 1, &row).unwrap();
    display.update().unwrap();
    let mut pixel = [0];
    for (x, y, index) in [(0, 0, 1), (right, 0, 2), (0, bottom, 3), (right, bottom, last)] {
        display.read_pixels(x, y, &mut pixel).unwrap();
        assert_eq!(pixel[0], index, "at ({x}, {y})");
    }
    let mut back = vec![0; row.len()];
    display.read_pixels(0, 1, &mut back).unwrap();
    assert_eq!(back, row);
    display.put_pixels(7, 1, &[]).unwrap();
    display.put_pixels(right, 1, &[1]).unwrap();
    display.read_pixels(right - 1, 1, &mut back[..2]).unwrap();
    assert_eq!(back[..2], [row[row.len() - 2], 1]);
}

/// Pixels outside the screen, entries beyond the table and levels beyond the guns are refused, and a refused
/// call changes nothing.
fn refuses_what_leaves_it<D, E>(mut display: D)
where
    D: ReadBack<Error = DriverError<E>>,
    E: core::fmt::Debug + PartialEq + core::error::Error + 'static,
{
    let has = display.capabilities();
    display.put_pixels(0, 0, &[1, 1]).unwrap();
    for (x, y, len) in [
        (has.width, 0, 1),
        (has.width - 1, 0, 2),
        (0, has.height, 1),
        (u32::MAX, 0, 1),
        (0, u32::MAX, 1),
        (u32::MAX, u32::MAX, 2),
        (has.width - 1, has.height - 1, 2),
        (0, 0, usize::try_from(has.width).unwrap() + 1),
    ] {
        let refused = Err(DriverError::OutOfBounds { x, y, len });
        assert_eq!(display.put_pixels(x, y, &vec![2; len]), refused);
        assert_eq!(display.read_pixels(x, y, &mut vec![0; len]), refused);
    }
    let mut pixels = [0; 2];
    display.read_pixels(0, 0, &mut pixels).unwrap();
    assert_eq!(pixels, [1, 1]);
    display.read_pixels(has.width - 2, has.height - 1, &mut pixels).unwrap();
    assert_eq!(pixels, [0, 0]);

    let last = u8::try_from(has.colors - 1).unwrap();
    let two = [Rgb::new(1, 1, 1); 2];
    let before = [Rgb::new(3, 2, 1)];
    display.set_colors(last, &before).unwrap();
    let beyond = Err(DriverError::ColorTable { first: last, len: 2 });
    assert_eq!(display.set_colors(last, &two), beyond);
    assert_eq!(display.read_colors(last, &mut two.clone()), beyond);
    if let Some(level) = has.gun_max.checked_add(1) {
        let refused = Err(DriverError::Level { level, max: has.gun_max });
        assert_eq!(display.set_colors(last, &[Rgb::new(0, 0, level)]), refused);
    }
    if let Some(index) = last.checked_add(1) {
        assert_eq!(display.put_pixels(0, 0, &[0, index]), Err(DriverError::Index { index }));
    }
    let mut after = [Rgb::new(0, 0, 0)];
    display.read_colors(last, &mut after).unwrap();
    assert_eq!(after, before);
}

#[test]
fn every_display_holds_what_it_is_given() {
    holds_what_it_is_given(vga());
    holds_what_it_is_given(Mode13h::after_bios({
        let mut machine = Vga::new(vec![0; vga13h::emulated::MEMORY_SIZE]).unwrap();
        machine.bios_mode_13h();
        machine
    }));
    holds_what_it_is_given(vga().with_retrace_wait(100));
    holds_what_it_is_given(graphigs());
    holds_what_it_is_given(pixrect());
    holds_what_it_is_given(&mut pixrect());
}

#[test]
fn emulated_devices_take_the_bytes_they_say() {
    assert!(size_of::<Vga<()>>() <= 850, "{}", size_of::<Vga<()>>());
    assert!(size_of::<Board<()>>() <= 800, "{}", size_of::<Board<()>>());
    assert!(size_of::<Workstation<()>>() <= 820, "{}", size_of::<Workstation<()>>());
}

#[test]
fn every_display_refuses_what_leaves_it() {
    refuses_what_leaves_it(vga());
    refuses_what_leaves_it(graphigs());
    refuses_what_leaves_it(pixrect());
}

/// The pixel at (`x`, `y`) of a picture with more colours than any table has, levels 0..=`max`.
fn rainbow(x: u32, y: u32, max: u8) -> Rgb<u8> {
    let part = |n: u32| u8::try_from(n % (u32::from(max) + 1)).unwrap();
    Rgb::new(part(x / 3 + y), part(x / 5), part(y / 2))
}

/// Paints `width` x `height` pixels of the rainbow, then checks that the device holds the table's entries and
/// that each pixel has the index of its colour. Returns the display.
fn paints<D: ReadBack>(display: D, table: impl ColorTable, width: u32, height: u32) -> D {
    let has = display.capabilities();
    let mut painter = Painter::new(display, table).unwrap();
    for y in 0..height {
        painter.put_row(0, y, (0..width).map(|x| rainbow(x, y, has.gun_max))).unwrap();
    }
    painter.update().unwrap();
    let (mut display, mut table) = painter.into_parts();
    let entries = table.entries().to_vec();
    let mut loaded = entries.clone();
    display.read_colors(0, &mut loaded).unwrap();
    assert_eq!(loaded, entries);
    for y in 0..height {
        let mut row = vec![0; usize::try_from(width).unwrap()];
        display.read_pixels(0, y, &mut row).unwrap();
        for (x, &index) in (0..).zip(&row) {
            let levels = rainbow(x, y, has.gun_max);
            let got = entries[usize::from(index)];
            // Either the exact colour or, once the table was full, the entry that stands for it.
            assert!(got == levels || table.index(levels) == index, "at ({x}, {y})");
        }
    }
    display
}

#[test]
fn the_painter_loads_colors_as_they_are_made() {
    paints(vga(), Adaptive::new(256).unwrap(), 320, 40);
    paints(vga(), Uniform::new(256, 63).unwrap(), 320, 40);
    paints(graphigs(), Adaptive::new(128).unwrap(), 1024, 20);
    paints(graphigs(), Uniform::new(128, 15).unwrap(), 1024, 20);
    paints(pixrect(), Adaptive::new(256).unwrap(), 1152, 20);
    paints(pixrect(), Uniform::new(256, 255).unwrap(), 1152, 20);
}

#[test]
fn a_monitor_shows_what_was_painted() {
    let screen = paints(vga(), Adaptive::new(256).unwrap(), 16, 16);
    let monitor = screen.bus().monitor().unwrap();
    let screen = paints(graphigs(), Adaptive::new(128).unwrap(), 16, 8);
    let board = paints(pixrect(), Adaptive::new(256).unwrap(), 16, 16);
    let tube = board.pixrect().bus().monitor().unwrap();
    for (x, y) in [(0, 0), (15, 0), (0, 7), (15, 7), (8, 3)] {
        assert_eq!(monitor.pixel(x, y), Some(rainbow(x, y, 63)));
        assert_eq!(screen.api().pixel(x, y), Some(rainbow(x, y, 15)));
        assert_eq!(tube.pixel(x, y), Some(rainbow(x, y, 255)));
    }
    assert_eq!(monitor.pixel(320, 0), None);
    assert_eq!(monitor.pixel(0, 200), None);
    assert_eq!(screen.api().pixel(1024, 0), None);
    assert_eq!(tube.pixel(0, 900), None);
    assert_eq!(tube.pixel(u32::MAX, u32::MAX), None);
}

#[test]
fn the_painter_refuses_with_the_display() {
    // A table with more entries than the display's.
    assert!(Painter::new(graphigs(), Uniform::new(256, 15).unwrap()).is_err());
    let mut painter = Painter::new(vga(), Adaptive::new(256).unwrap()).unwrap();
    assert!(painter.put_row(0, 0, vec![Rgb::new(1, 1, 1); 321]).is_err());
    assert!(painter.put_row(u32::MAX - 1, 0, vec![Rgb::new(1, 1, 1); 200]).is_err());
    assert!(painter.put_row(0, 200, [Rgb::new(1, 1, 1)]).is_err());
    // A level the DAC does not have is refused where it would be loaded.
    let error = painter.put_row(0, 0, [Rgb::new(64, 0, 0)]).unwrap_err();
    assert_eq!(error.to_string(), "gun level 64 is above 63");
}
