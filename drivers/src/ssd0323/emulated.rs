//! An emulated SSD0323 with its panel: the commands as a state machine, the graphic memory, and what the panel shows.
//!
//! These work as in the controller:
//!
//! - the window of columns and rows, in which the address of data goes on along the rows or down the columns and begins anew at the end;
//! - commands whose bytes come one by one or many at a time, data between them or not;
//! - how the panel shows the memory: on or asleep, the four display modes, the start line, columns and nibbles the other way round.
//!
//! Currents, voltages, times and the grey scale change nothing here: levels stand for themselves. Of the wiring of the common lines it is
//! checked that it is the panel's. The display offset and the graphic accelerator are not modelled; their commands are counted as
//! [unknown](Oled::unknown).

use super::commands::{self as cmd, COLUMNS, ROWS};
use super::{HEIGHT, WIDTH};
use crate::bus::{CommandData, ShortMemory};

/// Bytes of the graphic memory: 80 rows of 64 bytes, two pixels a byte.
pub const MEMORY_SIZE: usize = COLUMNS as usize * ROWS as usize;

/// The most bytes that follow a command: the grey scale's.
const MOST_ARGUMENTS: usize = 8;

/// An emulated controller and its panel; the graphic memory is lent by the caller.
#[derive(Clone, Debug)]
pub struct Oled<M> {
    memory: M,
    /// The first and the last column of the window, and the one that data goes to.
    columns: Span,
    /// The first and the last row of the window, and the one that data goes to.
    rows: Span,
    /// The command whose bytes have not all come.
    open: heapless::Vec<u8, { 1 + MOST_ARGUMENTS }>,
    remap: u8,
    start_line: u8,
    contrast: u8,
    /// One of the four commands of the display mode.
    mode: u8,
    on: bool,
    unknown: u32,
}

/// One side of the window.
#[derive(Clone, Copy, Debug)]
struct Span {
    first: u8,
    last: u8,
    next: u8,
}

impl Span {
    const fn new(first: u8, last: u8) -> Self {
        Self { first, last, next: first }
    }

    /// Goes on by one, and returns whether it began anew.
    fn step(&mut self, size: u8) -> bool {
        let ends = self.next == self.last;
        // Where the last is before the first the address runs through the end of the memory.
        self.next = if ends { self.first } else { (self.next + 1) % size };
        ends
    }
}

impl<M: AsRef<[u8]> + AsMut<[u8]>> Oled<M> {
    /// Makes a controller after reset: asleep, its window all of the memory, which is left as it is.
    ///
    /// # Errors
    /// [`ShortMemory`] if `memory` has less than [`MEMORY_SIZE`] bytes.
    pub fn new(memory: M) -> Result<Self, ShortMemory> {
        let found = memory.as_ref().len();
        if found < MEMORY_SIZE {
            return Err(ShortMemory { needed: MEMORY_SIZE, found });
        }
        Ok(Self {
            memory,
            columns: Span::new(0, COLUMNS - 1),
            rows: Span::new(0, ROWS - 1),
            open: heapless::Vec::new(),
            remap: 0,
            start_line: 0,
            contrast: 0x40,
            mode: cmd::NORMAL,
            on: false,
            unknown: 0,
        })
    }

    /// Returns the level, 0..=15, that the panel shows at column `x` of row `y`; 0 outside, and where the common lines are not scanned as the
    /// panel is wired.
    pub fn shown(&self, x: u32, y: u32) -> u8 {
        const WIRING: u8 = cmd::REMAP_COM | cmd::REMAP_SPLIT;
        if !self.on || x >= WIDTH || y >= HEIGHT || self.remap & WIRING != WIRING {
            return 0;
        }
        let x = if self.remap & cmd::REMAP_COLUMN != 0 { WIDTH - 1 - x } else { x };
        let row = (y + u32::from(self.start_line)) % u32::from(ROWS);
        let at = row * u32::from(COLUMNS) + x / 2;
        let byte = self.memory.as_ref().get(at as usize).copied().unwrap_or(0);
        let high = x.is_multiple_of(2) == (self.remap & cmd::REMAP_NIBBLE != 0);
        let level = if high { byte >> 4 } else { byte & 15 };
        match self.mode {
            cmd::ALL_ON => 15,
            cmd::ALL_OFF => 0,
            cmd::INVERSE => 15 - level,
            _ => level,
        }
    }

    /// Returns the contrast, 0..=127.
    pub fn contrast(&self) -> u8 {
        self.contrast
    }

    /// Returns how many commands came that are not modelled, each byte of theirs counted.
    pub fn unknown(&self) -> u32 {
        self.unknown
    }

    /// Gives the graphic memory back.
    pub fn into_memory(self) -> M {
        self.memory
    }

    /// Takes the next byte of a command, and obeys once all have come.
    fn take(&mut self, byte: u8) {
        // Emptied when a command is complete, so there is room.
        let _ = self.open.push(byte);
        let Some((&command, arguments)) = self.open.split_first() else { return };
        match cmd::arguments(command) {
            None => self.unknown += 1,
            Some(count) if arguments.len() < count => return,
            Some(_) => {
                let argument = |i: usize| arguments.get(i).copied().unwrap_or(0);
                let (first, second) = (argument(0), argument(1));
                self.obey(command, first, second);
            }
        }
        self.open.clear();
    }

    fn obey(&mut self, command: u8, first: u8, second: u8) {
        match command {
            cmd::COLUMN_ADDRESS => self.columns = Span::new(first % COLUMNS, second % COLUMNS),
            cmd::ROW_ADDRESS => self.rows = Span::new(first % ROWS, second % ROWS),
            cmd::CONTRAST => self.contrast = first & 0x7F,
            cmd::REMAP => self.remap = first,
            cmd::START_LINE => self.start_line = first % ROWS,
            cmd::DISPLAY_OFFSET if first != 0 => self.unknown += 1,
            cmd::NORMAL..=cmd::INVERSE => self.mode = command,
            cmd::OFF => self.on = false,
            cmd::ON => self.on = true,
            _ => {}
        }
    }

    fn store(&mut self, byte: u8) {
        let at = usize::from(self.rows.next) * usize::from(COLUMNS) + usize::from(self.columns.next);
        if let Some(place) = self.memory.as_mut().get_mut(at) {
            *place = byte;
        }
        if self.remap & cmd::REMAP_VERTICAL != 0 {
            if self.rows.step(ROWS) {
                self.columns.step(COLUMNS);
            }
        } else if self.columns.step(COLUMNS) {
            self.rows.step(ROWS);
        }
    }
}

impl<M: AsRef<[u8]> + AsMut<[u8]>> CommandData for Oled<M> {
    fn command(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|&byte| self.take(byte));
    }

    fn data(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|&byte| self.store(byte));
    }
}
