//! Mode 13h, register by register.

use rta_core::color::Rgb;
use rta_drivers::bus::{Memory, Ports, ShortMemory};
use rta_drivers::display::{Display, ReadBack};
use rta_drivers::vga13h::emulated::{MEMORY_SIZE, NotMode13h, RETRACE_PERIOD, Vga};
use rta_drivers::vga13h::{Mode13h, registers as reg};

/// One access of a driver to its bus.
#[derive(Clone, Debug, PartialEq)]
enum Access {
    /// Port and value written.
    Out(u16, u8),
    /// Port read.
    In(u16),
    /// Offset in video memory and bytes written.
    Write(u32, Vec<u8>),
    /// Offset in video memory and number of bytes read.
    Read(u32, usize),
}
use Access::{In, Out, Read, Write};

/// A bus that records every access; a port reads FFh, and memory that is read is left as it was.
#[derive(Default)]
struct Recorder(Vec<Access>);

impl Ports for Recorder {
    fn out8(&mut self, port: u16, value: u8) {
        self.0.push(Out(port, value));
    }
    fn in8(&mut self, port: u16) -> u8 {
        self.0.push(In(port));
        0xFF
    }
}

impl Memory for Recorder {
    fn write(&mut self, offset: u32, bytes: &[u8]) {
        self.0.push(Write(offset, bytes.to_vec()));
    }
    fn read(&mut self, offset: u32, bytes: &mut [u8]) {
        self.0.push(Read(offset, bytes.len()));
    }
}

fn vga() -> Vga<Vec<u8>> {
    Vga::new(vec![0; MEMORY_SIZE]).unwrap()
}

#[test]
fn programming_the_mode_is_this_sequence() {
    let mut accesses = Mode13h::program(Recorder::default()).release().0;
    let mut wanted = vec![Out(0x3C2, 0x63)];
    let indexed = |wanted: &mut Vec<Access>, port: u16, values: &str| {
        for (index, value) in (0..).zip(values.split(' ')) {
            wanted.extend([Out(port, index), Out(port + 1, u8::from_str_radix(value, 16).unwrap())]);
        }
    };
    indexed(&mut wanted, 0x3C4, "03 01 0F 00 0E");
    wanted.extend([Out(0x3D4, 0x11), In(0x3D5), Out(0x3D5, 0x7F)]);
    let crtc = "5F 4F 50 82 54 80 BF 1F 00 41 00 00 00 00 00 00 9C 8E 8F 28 40 96 B9 A3 FF";
    indexed(&mut wanted, 0x3D4, crtc);
    indexed(&mut wanted, 0x3CE, "00 00 00 00 00 40 05 0F FF");
    let attribute = "00 01 02 03 04 05 06 07 08 09 0A 0B 0C 0D 0E 0F 41 00 0F 00 00";
    for (index, value) in (0..).zip(attribute.split(' ')) {
        let value = u8::from_str_radix(value, 16).unwrap();
        wanted.extend([In(0x3DA), Out(0x3C0, index), Out(0x3C0, value)]);
    }
    wanted.extend([In(0x3DA), Out(0x3C0, 0x20), Out(0x3C6, 0xFF)]);
    let cleared = accesses.split_off(wanted.len());
    assert_eq!(accesses, wanted);
    let mut end = 0;
    for piece in cleared {
        let Write(offset, bytes) = piece else { panic!("{piece:?} while clearing") };
        assert_eq!(offset, end);
        assert!(bytes.iter().all(|&b| b == 0));
        end += u32::try_from(bytes.len()).unwrap();
    }
    assert_eq!(end, 0x1_0000);
}

#[test]
fn after_the_bios_only_what_an_mcga_shares_is_touched() {
    let mut mode = Mode13h::after_bios(Recorder::default());
    mode.set_colors(254, &[Rgb::new(1, 2, 3), Rgb::new(4, 5, 63)]).unwrap();
    mode.put_pixels(319, 199, &[9]).unwrap();
    mode.read_colors(7, &mut [Rgb::new(0, 0, 0)]).unwrap();
    mode.read_pixels(10, 2, &mut [0; 3]).unwrap();
    assert_eq!(
        mode.release().0,
        [
            Out(0x3C6, 0xFF),
            Out(0x3C8, 254),
            Out(0x3C9, 1),
            Out(0x3C9, 2),
            Out(0x3C9, 3),
            Out(0x3C9, 4),
            Out(0x3C9, 5),
            Out(0x3C9, 63),
            Write(63_999, vec![9]),
            Out(0x3C7, 7),
            In(0x3C9),
            In(0x3C9),
            In(0x3C9),
            Read(650, 3),
        ]
    );
}

#[test]
fn the_retrace_is_waited_for_but_not_for_ever() {
    // The recorder's retrace bit is always set, so the beginning of a retrace is never seen.
    let mut mode = Mode13h::after_bios(Recorder::default()).with_retrace_wait(5);
    mode.set_colors(0, &[]).unwrap();
    let accesses = mode.release().0;
    assert_eq!(accesses[1..], [In(0x3DA), In(0x3DA), In(0x3DA), In(0x3DA), In(0x3DA), Out(0x3C8, 0)]);

    let mut mode = Mode13h::program(vga());
    assert!(mode.wait_retrace(RETRACE_PERIOD.into()) || mode.wait_retrace(RETRACE_PERIOD.into()));
    assert!(!mode.wait_retrace(u32::from(RETRACE_PERIOD) - 1));
    assert!(mode.wait_retrace(2 * u32::from(RETRACE_PERIOD)));
    assert!(!mode.wait_retrace(0));
    // The status register reads 00h while pixels are displayed and 09h in the retrace, once in a period.
    let mut machine = mode.release();
    let seen: Vec<u8> = (0..3 * RETRACE_PERIOD).map(|_| machine.in8(0x3DA)).collect();
    assert_eq!(seen.iter().filter(|&&s| s == 0x09).count(), 3);
    assert!(seen.iter().all(|&s| s == 0 || s == 0x09));
}

#[test]
fn a_monitor_names_the_register_that_is_wrong() {
    assert_eq!(vga().monitor().unwrap_err(), NotMode13h { port: 0x3C2, index: None, found: 0, wanted: 0x63 });
    let programmed = Mode13h::program(vga()).release();
    assert!(programmed.monitor().is_ok());
    let mut by_bios = vga();
    by_bios.bios_mode_13h();
    assert!(by_bios.monitor().is_ok());

    // Each indexed register in turn gets a wrong value.
    for (port, count) in [(reg::SEQUENCER, 5), (reg::CRTC, 25), (reg::GRAPHICS, 9)] {
        for index in 0..count {
            let mut spoilt = programmed.clone();
            spoilt.out8(reg::CRTC, 0x11);
            spoilt.out8(reg::CRTC + 1, 0x0E); // unlock
            spoilt.out8(port, index);
            let value = spoilt.in8(port + 1);
            spoilt.out8(port + 1, value ^ 0x40);
            let cursor = port == reg::CRTC && matches!(index, 0x0A | 0x0B | 0x0E | 0x0F);
            match spoilt.monitor() {
                Ok(_) => assert!(cursor, "{port:X}h index {index:X}h"),
                Err(e) => assert_eq!((e.port, e.index, e.found), (port, Some(index), value ^ 0x40)),
            }
        }
    }
    for index in 0..21 {
        let mut spoilt = programmed.clone();
        spoilt.in8(reg::INPUT_STATUS_1);
        spoilt.out8(reg::ATTRIBUTE, index);
        spoilt.out8(reg::ATTRIBUTE, 0x30);
        spoilt.out8(reg::ATTRIBUTE, 0x20);
        match spoilt.monitor() {
            Ok(_) => assert_eq!(index, 0x11, "the border may have any colour"),
            Err(e) => assert_eq!((e.port, e.index, e.found), (reg::ATTRIBUTE, Some(index), 0x30)),
        }
    }
    // Without bit 5 of the attribute index the screen is dark.
    let mut dark = programmed;
    dark.in8(reg::INPUT_STATUS_1);
    dark.out8(reg::ATTRIBUTE, 0);
    let error = dark.monitor().unwrap_err();
    assert_eq!(error.to_string(), "not in mode 13h: register 3C0h is 00h, wanted 20h");
}

#[test]
fn the_dac_counts_latches_and_masks() {
    let mut machine = vga();
    machine.out8(0x3C8, 254);
    for value in [1, 2, 3, 0xFF, 0x7F, 0x40, 7, 8, 9] {
        machine.out8(0x3C9, value);
    }
    assert_eq!(machine.in8(0x3C8), 1, "the index wraps after 255");
    assert_eq!(machine.in8(0x3C7), 0, "state: writing");
    machine.out8(0x3C7, 254);
    assert_eq!(machine.in8(0x3C7), 3, "state: reading");
    let read: Vec<u8> = (0..9).map(|_| machine.in8(0x3C9)).collect();
    assert_eq!(read, [1, 2, 3, 63, 63, 0, 7, 8, 9]);

    // Red and green without blue change nothing; writing an index starts the sequence anew.
    machine.out8(0x3C8, 10);
    machine.out8(0x3C9, 50);
    machine.out8(0x3C9, 51);
    machine.out8(0x3C7, 10);
    assert_eq!([machine.in8(0x3C9), machine.in8(0x3C9), machine.in8(0x3C9)], [0, 0, 0]);
    machine.out8(0x3C8, 10);
    for value in [1, 2, 3] {
        machine.out8(0x3C9, value);
    }
    machine.out8(0x3C7, 10);
    assert_eq!([machine.in8(0x3C9), machine.in8(0x3C9), machine.in8(0x3C9)], [1, 2, 3]);
}

#[test]
fn the_pel_mask_is_applied_on_the_way_to_the_screen() {
    let mut mode = Mode13h::program(vga());
    mode.set_colors(0x0F, &[Rgb::new(1, 2, 3)]).unwrap();
    mode.set_colors(0xFF, &[Rgb::new(4, 5, 6)]).unwrap();
    mode.put_pixels(2, 1, &[0xFF]).unwrap();
    assert_eq!(mode.bus().monitor().unwrap().pixel(2, 1), Some(Rgb::new(4, 5, 6)));
    let mut machine = mode.release();
    machine.out8(0x3C6, 0x0F);
    assert_eq!(machine.in8(0x3C6), 0x0F);
    assert_eq!(machine.monitor().unwrap().pixel(2, 1), Some(Rgb::new(1, 2, 3)));
    let mut mode = Mode13h::after_bios(machine);
    let mut pixel = [0];
    mode.read_pixels(2, 1, &mut pixel).unwrap();
    assert_eq!(pixel, [0xFF]);
}

#[test]
fn the_attribute_flip_flop_and_its_lock() {
    let mut machine = vga();
    machine.out8(0x3C0, 0x03);
    // Bit 0 of the miscellaneous output is still 0, so the status register is at 3BAh; reading 3DAh does not
    // reset the flip-flop and the next write is data.
    machine.in8(0x3DA);
    machine.out8(0x3C0, 0x09);
    assert_eq!((machine.in8(0x3C0), machine.in8(0x3C1)), (0x03, 0x09));
    machine.out8(0x3C2, 0x63);
    machine.out8(0x3C0, 0x03); // index
    machine.out8(0x3C0, 0x2A); // data
    machine.out8(0x3C0, 0x04); // index again
    assert_eq!((machine.in8(0x3C0), machine.in8(0x3C1)), (0x04, 0));
    machine.in8(0x3DA); // resets the flip-flop: the next write is an index, not the data of register 4
    machine.out8(0x3C0, 0x03);
    assert_eq!((machine.in8(0x3C0), machine.in8(0x3C1)), (0x03, 0x2A));
    machine.in8(0x3DA);
    machine.out8(0x3C0, 0x23); // the palette goes to the screen and is locked
    machine.out8(0x3C0, 0x15);
    assert_eq!(machine.in8(0x3C1), 0x2A);
    machine.out8(0x3C0, 0x31); // the border's colour, register 11h, is never locked
    machine.out8(0x3C0, 0x15);
    assert_eq!(machine.in8(0x3C1), 0x15);
    machine.out8(0x3C0, 0x03);
    machine.out8(0x3C0, 0xFF); // a palette register has six bits
    assert_eq!(machine.in8(0x3C1), 0x3F);
    machine.out8(0x3C0, 0x1F); // no such register
    machine.out8(0x3C0, 0x01);
    assert_eq!(machine.in8(0x3C1), 0xFF);
}

#[test]
fn the_crtc_is_write_protected() {
    let mut machine = vga();
    let write = |machine: &mut Vga<Vec<u8>>, index, value| {
        machine.out8(0x3D4, index);
        machine.out8(0x3D5, value);
        machine.in8(0x3D5)
    };
    // With bit 0 of the miscellaneous output 0 the CRTC is at 3B4h.
    assert_eq!(write(&mut machine, 1, 0x12), 0xFF);
    machine.out8(0x3C2, 0x63);
    assert_eq!(machine.in8(0x3CC), 0x63);
    assert_eq!(write(&mut machine, 1, 0x12), 0x12);
    assert_eq!(write(&mut machine, 0x11, 0x80), 0x80);
    for index in 0..7 {
        let before = if index == 1 { 0x12 } else { 0 };
        assert_eq!(write(&mut machine, index, 0xFF), before, "register {index}");
    }
    assert_eq!(write(&mut machine, 7, 0xFF), 0x10, "bit 4 of register 7 is never locked");
    assert_eq!(write(&mut machine, 8, 0x55), 0x55);
    assert_eq!(write(&mut machine, 0x11, 0x00), 0x00);
    assert_eq!(write(&mut machine, 7, 0xEF), 0xEF);
    assert_eq!(write(&mut machine, 0x19, 1), 0xFF, "no such register");
    // The driver unlocks the registers before it programs them.
    write(&mut machine, 0x11, 0x80);
    assert!(Mode13h::program(machine).bus().monitor().is_ok());
}

#[test]
fn the_window_is_there_when_the_registers_open_it() {
    let mut machine = vga();
    let mut bytes = [0; 4];
    machine.write(0, &[1, 2, 3, 4]);
    machine.read(0, &mut bytes);
    assert_eq!(bytes, [0xFF; 4], "closed after reset");
    machine.bios_mode_13h();
    machine.read(0, &mut bytes);
    assert_eq!(bytes, [0; 4], "and nothing was written");
    machine.write(0xFFFE, &[1, 2, 3, 4]);
    machine.read(0xFFFE, &mut bytes);
    assert_eq!(bytes, [1, 2, 0xFF, 0xFF], "64 KiB and no more");
    machine.write(u32::MAX, &[1, 2]);
    machine.read(u32::MAX, &mut bytes);
    assert_eq!(bytes, [0xFF; 4]);
    // The map mask keeps planes from being written; with chain 4 the plane is the address mod 4.
    machine.out8(0x3C4, 2);
    machine.out8(0x3C5, 0x05);
    machine.write(1, &[9; 4]);
    machine.read(1, &mut bytes);
    assert_eq!(bytes, [0, 9, 0, 9]);
    for (port, index, value) in [(0x3C4, 4, 0x06), (0x3CE, 6, 0x0D)] {
        let mut closed = machine.clone();
        closed.out8(port, index);
        closed.out8(port + 1, value);
        closed.read(1, &mut bytes);
        assert_eq!(bytes, [0xFF; 4], "{port:X}h index {index}");
    }
    assert_eq!(Vga::new([0; 100]).unwrap_err(), ShortMemory { needed: 65_536, found: 100 });
    assert_eq!((machine.in8(0x60), machine.in8(0x3D8)), (0xFF, 0xFF));
}
