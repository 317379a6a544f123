//! What goes over the serial bus, taken by a model of the controllers: commands, address window and graphic memory.

use core::cell::RefCell;
use core::convert::Infallible;
use std::rc::Rc;

use embedded_hal::delay::DelayNs;
use embedded_hal::digital::{self, OutputPin};
use embedded_hal::spi::{self, Operation, SpiDevice};
use rta_drivers::direct::{DirectDisplay, Levels};
use spi_picture::{Failure, draw, ili9341, st7789};

/// Commands of both controllers (MIPI Display Command Set).
const SLEEP_OUT: u8 = 0x11;
const INVERT_ON: u8 = 0x21;
const ON: u8 = 0x29;
const COLUMNS: u8 = 0x2A;
const ROWS: u8 = 0x2B;
const WRITE: u8 = 0x2C;
const ADDRESS_MODE: u8 = 0x36;
const PIXEL_FORMAT: u8 = 0x3A;

/// Bits of the address mode: columns and rows are exchanged; blue comes before red.
const EXCHANGED: u8 = 0x20;
const BGR: u8 = 0x08;

const WIDTH: usize = 320;
const HEIGHT: usize = 240;

/// A controller that has two bytes a pixel.
#[derive(Default)]
struct Controller {
    /// The D/C line is high: data.
    data: bool,
    /// Resets, and bytes that came before the first.
    resets: usize,
    early: usize,
    command: u8,
    arguments: Vec<u8>,
    /// First and last column and row of the window, and the address that the next pixel goes to.
    columns: (usize, usize),
    rows: (usize, usize),
    next: (usize, usize),
    awake: bool,
    on: bool,
    inverted: bool,
    mode: u8,
    format: u8,
    /// Windows that pixels were written to.
    writes: usize,
    pixels: usize,
    memory: Vec<Option<u16>>,
    /// Bytes after which the bus fails.
    fails_after: Option<usize>,
}

impl Controller {
    fn take(&mut self, byte: u8) {
        self.early += usize::from(self.resets == 0);
        if !self.data {
            assert!(self.arguments.is_empty() || self.command != WRITE, "half a pixel");
            (self.command, self.arguments) = (byte, Vec::new());
            match byte {
                SLEEP_OUT => self.awake = true,
                INVERT_ON => self.inverted = true,
                ON => self.on = true,
                WRITE => {
                    self.writes += 1;
                    self.next = (self.columns.0, self.rows.0);
                }
                _ => {}
            }
            return;
        }
        self.arguments.push(byte);
        match (self.command, self.arguments.as_slice()) {
            (ADDRESS_MODE, &[mode]) => self.mode = mode,
            (PIXEL_FORMAT, &[format]) => self.format = format,
            (COLUMNS, &[a, b, c, d]) => self.columns = (word(a, b), word(c, d)),
            (ROWS, &[a, b, c, d]) => self.rows = (word(a, b), word(c, d)),
            (WRITE, &[high, low]) => self.store(u16::from_be_bytes([high, low])),
            _ => {}
        }
    }

    /// Stores a pixel, and goes on along the window's rows.
    fn store(&mut self, pixel: u16) {
        self.arguments.clear();
        self.pixels += 1;
        let (x, y) = self.next;
        assert!(x < WIDTH && y < HEIGHT, "({x}, {y}) is not in the memory");
        self.memory.resize(WIDTH * HEIGHT, None);
        self.memory[y * WIDTH + x] = Some(pixel);
        self.next = match (x == self.columns.1, y == self.rows.1) {
            (false, _) => (x + 1, y),
            (true, false) => (self.columns.0, y + 1),
            (true, true) => (self.columns.0, self.rows.0),
        };
    }
}

fn word(high: u8, low: u8) -> usize {
    u16::from_be_bytes([high, low]).into()
}

type Shared = Rc<RefCell<Controller>>;

/// The bus, the D/C line, and the reset line.
struct Bus(Shared);
struct Dc(Shared);
struct Reset(Shared);
/// Nobody waits.
struct Now;

#[derive(Debug)]
struct Broken;

impl spi::Error for Broken {
    fn kind(&self) -> spi::ErrorKind {
        spi::ErrorKind::Other
    }
}

impl spi::ErrorType for Bus {
    type Error = Broken;
}

impl SpiDevice for Bus {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), Broken> {
        let mut controller = self.0.borrow_mut();
        for operation in operations {
            let Operation::Write(bytes) = operation else { panic!("the display is only written to") };
            for &byte in *bytes {
                if let Some(left) = &mut controller.fails_after {
                    *left = left.checked_sub(1).ok_or(Broken)?;
                }
                controller.take(byte);
            }
        }
        Ok(())
    }
}

impl digital::ErrorType for Dc {
    type Error = Infallible;
}

impl OutputPin for Dc {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.0.borrow_mut().data = false;
        Ok(())
    }
    fn set_high(&mut self) -> Result<(), Infallible> {
        self.0.borrow_mut().data = true;
        Ok(())
    }
}

impl digital::ErrorType for Reset {
    type Error = Infallible;
}

impl OutputPin for Reset {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.0.borrow_mut().resets += 1;
        Ok(())
    }
    fn set_high(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

impl DelayNs for Now {
    fn delay_ns(&mut self, _: u32) {}
}

/// The picture as levels, with neither driver nor bus.
struct Paper(Vec<u16>);

impl DirectDisplay for Paper {
    type Color = Levels<31, 63, 31>;
    type Error = Infallible;

    fn size(&self) -> (u32, u32) {
        (320, 240)
    }

    fn put_row(
        &mut self,
        _x: u32,
        _y: u32,
        colors: impl ExactSizeIterator<Item = Self::Color>,
    ) -> Result<(), Infallible> {
        let word = |Levels(c): Self::Color| u16::from(c.r) << 11 | u16::from(c.g) << 5 | u16::from(c.b);
        self.0.extend(colors.map(word));
        Ok(())
    }
}

/// Compares what a controller holds with the picture.
fn compare(controller: &Controller) {
    let want = draw(Paper(Vec::new())).unwrap().0;
    let got: Vec<u16> = controller.memory.iter().copied().map(Option::unwrap).collect();
    let wrong = got.iter().zip(&want).filter(|(got, want)| got != want).count();
    assert_eq!((got.len(), wrong), (WIDTH * HEIGHT, 0));
    let mut colors = want;
    colors.sort_unstable();
    colors.dedup();
    assert!(colors.len() > 100, "{} colours", colors.len());
    assert_eq!((controller.early, controller.resets), (0, 1));
    assert!(controller.awake && controller.on);
    // One window a row, and each pixel once.
    assert_eq!((controller.writes, controller.pixels), (HEIGHT, WIDTH * HEIGHT));
    // 16 bits a pixel, and the longer side is that of the columns.
    assert_eq!((controller.format & 7, controller.mode & EXCHANGED), (5, EXCHANGED));
}

#[test]
fn an_ili9341_holds_the_picture() {
    let shared = Shared::default();
    ili9341(Bus(shared.clone()), Dc(shared.clone()), Reset(shared.clone()), &mut Now).unwrap();
    let controller = shared.borrow();
    compare(&controller);
    assert!(!controller.inverted && controller.mode & BGR != 0);
}

#[test]
fn an_st7789_holds_the_picture() {
    let shared = Shared::default();
    st7789(Bus(shared.clone()), Dc(shared.clone()), Reset(shared.clone()), &mut Now).unwrap();
    let controller = shared.borrow();
    compare(&controller);
    assert!(controller.inverted && controller.mode & BGR == 0);
}

#[test]
fn a_bus_that_fails_is_told() {
    for (bytes, failure) in [(0, Failure::Setup), (5000, Failure::Display)] {
        let shared = Shared::default();
        shared.borrow_mut().fails_after = Some(bytes);
        let drawn = ili9341(Bus(shared.clone()), Dc(shared.clone()), Reset(shared.clone()), &mut Now);
        assert_eq!(drawn, Err(failure));
    }
}
