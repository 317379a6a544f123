//! The SSD0323: its commands, its memory, and what the panel shows.

use rta_core::color::Rgb;
use rta_drivers::bus::{CommandData, ShortMemory};
use rta_drivers::direct::{DirectDisplay, DirectPainter, Gray};
use rta_drivers::display::DriverError;
use rta_drivers::dither::Bayer;
use rta_drivers::guns::luma;
use rta_drivers::ssd0323::commands as cmd;
use rta_drivers::ssd0323::emulated::{MEMORY_SIZE, Oled};
use rta_drivers::ssd0323::{HalfByte, Ssd0323};

use crate::scattered;

fn oled() -> Oled<Vec<u8>> {
    Oled::new(vec![0x55; MEMORY_SIZE]).unwrap()
}

/// A controller that is on and wired to the panel, with nothing else set.
fn wired() -> Oled<Vec<u8>> {
    let mut oled = oled();
    oled.command(&[cmd::REMAP, cmd::PICTIVA, cmd::ON]);
    oled
}

/// What is sent over the bus: true for data.
#[derive(Default)]
struct Wire(Vec<(bool, u8)>);

impl CommandData for Wire {
    fn command(&mut self, bytes: &[u8]) {
        self.0.extend(bytes.iter().map(|&byte| (false, byte)));
    }
    fn data(&mut self, bytes: &[u8]) {
        self.0.extend(bytes.iter().map(|&byte| (true, byte)));
    }
}

#[test]
fn the_driver_sends_known_commands_and_the_panel_is_on_and_black() {
    let oled = Ssd0323::program(oled()).release();
    assert_eq!((oled.unknown(), oled.contrast()), (0, 50));
    assert!((0..64).all(|y| (0..128).all(|x| oled.shown(x, y) == 0)));
    assert!(oled.into_memory().iter().all(|&byte| byte == 0));
}

#[test]
fn a_row_is_a_window_and_its_bytes() {
    let mut panel = Ssd0323::program(Wire::default());
    let before = panel.bus().0.len();
    panel.put_row(6, 33, [1, 2, 15, 0, 7, 7].map(Gray).into_iter()).unwrap();
    panel.set_contrast(200);
    let sent = panel.release().0.split_off(before);
    let commands = [0x15, 3, 5, 0x75, 33, 33].map(|byte| (false, byte));
    let data = [0x12, 0xF0, 0x77].map(|byte| (true, byte));
    assert_eq!(sent[..9], [commands.as_slice(), &data].concat());
    assert_eq!(sent[9..], [(false, 0x81), (false, 127)]);
}

#[test]
fn the_panel_shows_what_is_drawn() {
    let rows: Vec<Vec<_>> = scattered(128 * 64, 255).chunks(128).map(<[_]>::to_vec).collect();
    let mut painter = DirectPainter::dithered(Ssd0323::program(oled()), Bayer);
    for (y, row) in (0..).zip(&rows) {
        painter.put_row(0, y, row.iter().copied()).unwrap();
    }
    // A part of a row, later.
    painter.put_row(126, 63, [Rgb::new(0, 0, 0), Rgb::new(255, 255, 255)]).unwrap();
    painter.update().unwrap();
    let oled = painter.into_display().release();
    for (y, row) in (0..).zip(&rows) {
        for (x, &light) in (0..).zip(row) {
            if (y, x) < (63, 126) {
                let exact = f64::from(luma(light)) / 17.0;
                assert!((f64::from(oled.shown(x, y)) - exact).abs() < 1.0, "({x}, {y})");
            }
        }
    }
    assert_eq!((oled.shown(126, 63), oled.shown(127, 63)), (0, 15));
    assert_eq!((oled.shown(128, 0), oled.shown(0, 64)), (0, 0));
}

#[test]
fn what_leaves_the_panel_or_parts_a_byte_is_not_sent() {
    let mut panel = Ssd0323::program(Wire::default());
    let before = panel.bus().0.len();
    for (x, y, len) in [(0, 64, 2), (128, 0, 2), (2, 0, 128), (u32::MAX, 0, 2)] {
        let row = vec![Gray(1); len].into_iter();
        assert_eq!(panel.put_row(x, y, row), Err(DriverError::OutOfBounds { x, y, len }));
    }
    for (x, len) in [(1, 2), (0, 1), (1, 1), (127, 1)] {
        let row = vec![Gray(1); len].into_iter();
        assert_eq!(panel.put_row(x, 0, row), Err(DriverError::Device(HalfByte)));
    }
    panel.put_row(128, 0, [].into_iter()).unwrap();
    assert_eq!(panel.bus().0.len(), before);
    assert_eq!(HalfByte.to_string(), "the pixels begin or end within a byte of two");
}

#[test]
fn data_runs_through_the_window_and_begins_anew() {
    let mut oled = wired();
    oled.command(&cmd::window((2, 3), (10, 11)));
    oled.data(&[0x12, 0x34, 0x56, 0x78, 0x9A]);
    let at = |oled: &Oled<_>, row: u32| [4, 5, 6, 7].map(|x| oled.shown(x, row));
    assert_eq!(at(&oled, 10), [9, 10, 3, 4]);
    assert_eq!(at(&oled, 11), [5, 6, 7, 8]);
    assert_eq!((oled.shown(3, 10), oled.shown(8, 10), oled.shown(4, 12)), (5, 5, 5));
    oled.command(&[cmd::REMAP, cmd::PICTIVA | cmd::REMAP_VERTICAL]);
    oled.command(&cmd::window((2, 3), (10, 11)));
    oled.data(&[0x12, 0x34, 0x56, 0x78]);
    assert_eq!(at(&oled, 10), [1, 2, 5, 6]);
    assert_eq!(at(&oled, 11), [3, 4, 7, 8]);
}

#[test]
fn a_command_may_come_in_parts() {
    let mut oled = wired();
    for byte in cmd::window((1, 1), (0, 0)) {
        oled.command(&[byte]);
    }
    oled.data(&[0xAB]);
    assert_eq!([2, 3].map(|x| oled.shown(x, 0)), [10, 11]);
    oled.command(&[cmd::CONTRAST]);
    oled.data(&[0xCD]); // data does not end a command
    oled.command(&[0xFF]);
    assert_eq!(oled.contrast(), 127);
    assert_eq!([2, 3].map(|x| oled.shown(x, 0)), [12, 13]);
    // The graphic accelerator's, and one that does not exist.
    oled.command(&[0x2E, 0xFE]);
    assert_eq!(oled.unknown(), 2);
}

#[test]
fn the_panel_shows_the_memory_as_it_is_told_to() {
    let mut oled = wired();
    oled.command(&cmd::window((0, 63), (0, 79)));
    oled.data(&[0x12]);
    let left = |oled: &Oled<_>| [0, 1].map(|x| oled.shown(x, 0));
    assert_eq!(left(&oled), [1, 2]);
    for (mode, shown) in
        [(cmd::INVERSE, [14, 13]), (cmd::ALL_ON, [15, 15]), (cmd::ALL_OFF, [0, 0]), (cmd::NORMAL, [1, 2])]
    {
        oled.command(&[mode]);
        assert_eq!(left(&oled), shown);
    }
    oled.command(&[cmd::REMAP, cmd::PICTIVA & !cmd::REMAP_NIBBLE]);
    assert_eq!(left(&oled), [2, 1]);
    oled.command(&[cmd::REMAP, cmd::PICTIVA | cmd::REMAP_COLUMN]);
    assert_eq!([127, 126].map(|x| oled.shown(x, 0)), [1, 2]);
    oled.command(&[cmd::REMAP, cmd::PICTIVA & !cmd::REMAP_COM]);
    assert_eq!(left(&oled), [0, 0]);
    oled.command(&[cmd::REMAP, cmd::PICTIVA, cmd::START_LINE, 76]);
    assert_eq!([0, 1].map(|x| oled.shown(x, 4)), [1, 2]);
    oled.command(&[cmd::OFF]);
    assert_eq!(oled.shown(0, 4), 0);
}

#[test]
fn memory_that_is_too_small_is_refused() {
    let short = Oled::new([0; MEMORY_SIZE - 1]).err();
    assert_eq!(short, Some(ShortMemory { needed: 5120, found: 5119 }));
}
