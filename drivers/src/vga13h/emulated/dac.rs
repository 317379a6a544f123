//! The digital-to-analogue converter of a VGA: 256 colours of 3 x 6 bits behind four ports.

use rta_core::color::Rgb;

use crate::vga13h::CAPABILITIES;

/// The converter's colours and the state of its ports.
#[derive(Clone, Debug)]
pub(super) struct Dac {
    /// Levels of 0..=63.
    colors: [Rgb<u8>; 256],
    /// Pel mask, ANDed with every pixel.
    pub(super) mask: u8,
    /// The last index was set for reading, not for writing.
    pub(super) reading: bool,
    pub(super) write_index: u8,
    read_index: u8,
    /// Levels received so far; the colour takes all three together when blue arrives.
    latch: Rgb<u8>,
    /// The gun whose level is next: 0 for red, 1 for green, 2 for blue.
    gun: u8,
}

impl Dac {
    /// All colours black, and a pel mask that lets nothing through.
    pub(super) const RESET: Self = Self {
        colors: [Rgb::new(0, 0, 0); 256],
        mask: 0,
        reading: false,
        write_index: 0,
        read_index: 0,
        latch: Rgb::new(0, 0, 0),
        gun: 0,
    };

    /// The colour of entry `index`.
    pub(super) fn color(&self, index: u8) -> Rgb<u8> {
        self.colors.get(usize::from(index)).copied().unwrap_or_default()
    }

    /// Sets the index to read from or to write to, and begins with red.
    pub(super) fn start(&mut self, index: u8, reading: bool) {
        *(if reading { &mut self.read_index } else { &mut self.write_index }) = index;
        self.reading = reading;
        self.gun = 0;
    }

    /// Takes the level of the next gun; the upper two bits are ignored.
    pub(super) fn write(&mut self, value: u8) {
        let value = value & CAPABILITIES.gun_max;
        match self.gun {
            0 => self.latch.r = value,
            1 => self.latch.g = value,
            _ => {
                self.latch.b = value;
                if let Some(color) = self.colors.get_mut(usize::from(self.write_index)) {
                    *color = self.latch;
                }
                self.write_index = self.write_index.wrapping_add(1);
            }
        }
        self.gun = (self.gun + 1) % 3;
    }

    /// Returns the level of the next gun.
    pub(super) fn read(&mut self) -> u8 {
        let color = self.color(self.read_index);
        let value = match self.gun {
            0 => color.r,
            1 => color.g,
            _ => {
                self.read_index = self.read_index.wrapping_add(1);
                color.b
            }
        };
        self.gun = (self.gun + 1) % 3;
        value
    }
}
