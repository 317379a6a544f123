//! How a device's few colours stand for a picture's many: the kinds of colour table and of dithering.

use core::fmt;

use clap::ValueEnum;
use rta_drivers::quantize;

/// The samples of which a table is made unless another number is asked for.
#[allow(clippy::cast_possible_truncation, reason = "it is 4096")]
pub const SAMPLES: u32 = quantize::SAMPLES as u32;

/// How the entries of a device's colour table are chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum TableKind {
    /// Made for the picture before it is drawn, from samples of it.
    Sampled,
    /// Made from all pixels of the picture, as `rta bake --palette` stores it.
    Baked,
    /// Made from all pixels and moved to where it is best for them, by k-means: for machines with the memory.
    Frame,
    /// The thesis's way with a small tolerance: what is nearly an entry shares it, so that a smooth sky leaves room
    /// for what is below it.
    Tolerant,
    /// The thesis's way to the letter: built while the picture is drawn, the nearest entry once it is full.
    Adaptive,
    /// Evenly spaced colours, alike for every picture.
    Uniform,
}

/// How dithering spreads what rounding to the colour table loses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum DitherKind {
    /// Every pixel gets the entry nearest to it.
    None,
    /// Error diffusion of 6, 3, 4 and 1 sixteenths; an eighth of the error is lost.
    #[value(alias = "fs6341")]
    Fs,
    /// Error diffusion of 7, 3, 5 and 1 sixteenths, as Floyd and Steinberg published it.
    Fs7351,
    /// A fixed pattern of 8 x 8 thresholds, for uniform tables.
    #[value(alias = "bayer8")]
    Bayer,
}

impl TableKind {
    /// Returns the kind after this one, in a circle.
    #[must_use]
    pub fn next(self) -> Self {
        after(Self::value_variants(), &self)
    }
}

impl DitherKind {
    /// Returns the kind after this one, in a circle.
    #[must_use]
    pub fn next(self) -> Self {
        after(Self::value_variants(), &self)
    }
}

fn after<T: Copy + PartialEq>(all: &[T], one: &T) -> T {
    all.iter().skip_while(|other| *other != one).nth(1).or(all.first()).copied().unwrap_or(*one)
}

/// The value's name on the command line.
fn named(value: &impl ValueEnum, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    value.to_possible_value().map_or(Ok(()), |value| f.write_str(value.get_name()))
}

impl fmt::Display for TableKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        named(self, f)
    }
}

impl fmt::Display for DitherKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        named(self, f)
    }
}
