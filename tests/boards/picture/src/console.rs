//! What the board does on its serial line once the picture is drawn.
//!
//! It says `READY` and then obeys commands of one byte:
//!
//! - `D`: sends what the hardware holds, read back through the driver: 768 bytes of the colour table
//!   (red, green, blue of entry 0, and so on), then the picture's indices, row by row;
//! - `Q`: ends.

use rta_core::color::Rgb;
use rta_drivers::display::ReadBack;

/// A serial line.
pub trait Serial {
    /// Sends a byte.
    fn put(&mut self, byte: u8);
    /// Waits for a byte.
    fn get(&mut self) -> u8;

    /// Sends several bytes.
    fn put_all(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.put(byte);
        }
    }
}

/// Obeys until `Q`. The picture's upper left pixel is at `origin`.
///
/// # Errors
/// Those of the display.
pub fn serve<D: ReadBack>(
    serial: &mut impl Serial,
    display: &mut D,
    origin: (u32, u32),
) -> Result<(), D::Error> {
    serial.put_all(b"READY\n");
    loop {
        match serial.get() {
            b'D' => dump(serial, display, origin)?,
            b'Q' => return Ok(()),
            // Noise of a line that has just been plugged in.
            _ => {}
        }
    }
}

fn dump<D: ReadBack>(
    serial: &mut impl Serial,
    display: &mut D,
    (left, top): (u32, u32),
) -> Result<(), D::Error> {
    for entry in 0..=u8::MAX {
        let mut color = [Rgb::new(0, 0, 0)];
        display.read_colors(entry, &mut color)?;
        let [Rgb { r, g, b }] = color;
        serial.put_all(&[r, g, b]);
    }
    for y in 0..crate::HEIGHT {
        let mut row = [0; crate::WIDTH as usize];
        display.read_pixels(left, top + y, &mut row)?;
        serial.put_all(&row);
    }
    Ok(())
}
