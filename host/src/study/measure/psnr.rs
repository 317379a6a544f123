//! PSNR: the peak signal-to-noise ratio, a mean square over all registers of all pixels.

use core::fmt;

use rta_core::color::Rgb;

use super::Pair;

/// The peak signal-to-noise ratio of two pictures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Psnr {
    /// The pictures are equal in every code, so that there is no noise and the ratio has no bound.
    Equal,
    /// 10 log10(255^2 / mean square of the differences of codes), 0 or more.
    Decibels(f64),
}

impl fmt::Display for Psnr {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Equal => f.pad("equal"),
            Self::Decibels(decibels) => f.pad(&format!("{decibels:.2} dB")),
        }
    }
}

/// Returns the peak signal-to-noise ratio over the codes of sRGB of all three registers; the peak is 255.
#[must_use]
#[expect(
    clippy::cast_precision_loss,
    reason = "sums are below 2^53: 65535^2 pixels of up to 3 * 255^2 are below 2^50"
)]
pub fn psnr(pair: &Pair<'_>) -> Psnr {
    let squares = pair.reference.iter().zip(pair.test).map(|(color, other)| {
        let Rgb { r, g, b } = color.zip(*other, |code, other| u64::from(code.abs_diff(other)).pow(2));
        r + g + b
    });
    match squares.sum::<u64>() {
        0 => Psnr::Equal,
        sum => {
            let codes = 3.0 * pair.reference.len() as f64;
            Psnr::Decibels(10.0 * (255.0 * 255.0 * codes / sum as f64).log10())
        }
    }
}
