//! Compares a picture with a hash and with a golden picture.

use std::env;
use std::io::ErrorKind;
use std::path::Path;

use rta_core::color::Rgb;

use crate::error::{Difference, Mismatch};
use crate::file::{Colors, encode, read, registers};
use crate::kept::{Kept, write};
use crate::picture::Picture;

/// The environment variable that makes [`Picture::is_golden`] write the golden picture anew, if it is neither empty nor `0`.
pub const BLESS: &str = "RTA_BLESS";

impl Picture {
    /// Compares the picture's [`hash`](Picture::hash) with the number that `rta hash` prints, or a board.
    ///
    /// # Errors
    /// [`Mismatch::Hash`] with both numbers.
    pub fn has_hash(&self, golden: u64) -> Result<(), Mismatch> {
        let drawn = self.hash();
        if drawn == golden { Ok(()) } else { Err(Mismatch::Hash { drawn, golden }) }
    }

    /// Compares what is seen, the colours of all pixels in 8 bits a gun, with the PNG file `golden`; or, if the environment
    /// variable [`RTA_BLESS`](BLESS) is set, makes the picture the golden one and writes that file.
    ///
    /// How the PNG is encoded makes no difference: indexed, grey or in RGB, however compressed. Which number an entry of the
    /// colour table has is no matter of what is seen; the hash covers it.
    ///
    /// After a failure the picture that was drawn, and if the golden one has its size a picture of the difference, are in the
    /// folder `golden` of the build (`target/golden`), by the name of the package and the path of the golden picture in it. They
    /// do not lie beside the golden picture, so that nothing of a failed run gets into version control.
    ///
    /// # Errors
    /// [`Mismatch::Pixels`], [`Mismatch::Size`], [`Mismatch::Missing`] and [`Mismatch::Unreadable`], each with what was found; and
    /// [`Mismatch::Write`] if the golden picture cannot be written.
    pub fn is_golden(&self, golden: impl AsRef<Path>) -> Result<(), Mismatch> {
        let golden = golden.as_ref();
        if env::var_os(BLESS).is_some_and(|value| !value.is_empty() && value != "0") {
            let written = self.png().and_then(|png| write(golden, &png));
            return written.map_err(|source| Mismatch::Write { golden: golden.to_owned(), source });
        }
        let read = match read(golden) {
            Ok(read) => read,
            Err(error) => {
                let (golden, kept) = (golden.to_owned(), Kept::write(golden, self.png(), None));
                return Err(match error.kind() {
                    ErrorKind::NotFound => Mismatch::Missing { golden, kept },
                    _ => Mismatch::Unreadable { golden, source: error, kept },
                });
            }
        };
        self.equals(&read, golden)
    }

    fn equals(&self, read: &Colors, golden: &Path) -> Result<(), Mismatch> {
        let (drawn, other) = (self.size(), (read.width, read.height));
        if drawn != other {
            let kept = Kept::write(golden, self.png(), None);
            return Err(Mismatch::Size { golden: golden.to_owned(), drawn, golden_size: other, kept });
        }
        let colors = self.colors();
        let apart: Vec<_> =
            colors.iter().zip(&read.pixels).map(|(drawn, golden)| drawn.zip(*golden, u8::abs_diff)).collect();
        let Some(first) = apart.iter().position(|apart| *apart != Rgb::default()) else { return Ok(()) };
        let color = |pixels: &[Rgb<u8>]| pixels.get(first).copied().unwrap_or_default();
        // Small differences are made visible.
        let seen = |apart: u8| if apart == 0 { 0 } else { apart.saturating_mul(4).max(64) };
        let difference = encode(drawn, None, &registers(apart.iter().map(|apart| apart.map(seen))));
        let place = |index: usize| u32::try_from(index).unwrap_or(u32::MAX);
        let columns = drawn.0 as usize;
        Err(Mismatch::Pixels(Box::new(Difference {
            golden: golden.to_owned(),
            differing: apart.iter().filter(|apart| **apart != Rgb::default()).count(),
            pixels: apart.len(),
            largest: apart.iter().map(|apart| apart.r.max(apart.g).max(apart.b)).max().unwrap_or(0),
            x: place(first % columns),
            y: place(first / columns),
            drawn_color: color(&colors),
            golden_color: color(&read.pixels),
            kept: Kept::write(golden, self.png(), Some(difference)),
        })))
    }
}
