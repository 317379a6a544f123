//! The kinds of colour tables and of dithering that a page offers, by the names that they have in `rta render`.

use rta_core::color::Rgb;
use rta_drivers::display::Capabilities;
use rta_drivers::quantize::{
    Adaptive, ColorTable, MAX_SAMPLES, SAMPLES, TableError, Uniform, refined, variance_cut,
};

/// How the entries of the colour table are chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TableKind {
    /// Made for the picture before it is drawn, from [`SAMPLES`] of its pixels.
    Sampled,
    /// Made from all pixels of the picture, as far as there is memory for them.
    Baked,
    /// Made from all pixels and moved to where it is best for them.
    Frame,
    /// Built while the picture is drawn; what is nearly an entry shares it.
    Tolerant,
    /// Built while the picture is drawn.
    Adaptive,
    /// Evenly spaced colours.
    Uniform,
}

/// How dithering spreads what rounding to the colour table loses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum DitherKind {
    /// Not at all.
    None,
    /// Error diffusion of seven eighths of the error.
    Fs,
    /// Error diffusion of all of it, by Floyd and Steinberg.
    Fs7351,
    /// A fixed pattern of 8 x 8 thresholds.
    Bayer,
}

impl TableKind {
    /// All kinds with their names.
    pub(crate) const ALL: [(&str, Self); 6] = [
        ("sampled", Self::Sampled),
        ("baked", Self::Baked),
        ("frame", Self::Frame),
        ("tolerant", Self::Tolerant),
        ("adaptive", Self::Adaptive),
        ("uniform", Self::Uniform),
    ];

    /// Returns how many of the picture's pixels have to be known, at most, before it is drawn.
    pub(crate) const fn samples(self) -> usize {
        match self {
            Self::Sampled => SAMPLES,
            Self::Baked | Self::Frame => MAX_SAMPLES,
            Self::Tolerant | Self::Adaptive | Self::Uniform => 0,
        }
    }

    /// Returns the table for a display. `samples` are the colours, 8 bits a gun, of a grid of pixels that is `width` wide; none
    /// where [`TableKind::samples`] is 0.
    ///
    /// # Errors
    /// [`TableError`] if the display has too few colours or levels for this kind.
    pub(crate) fn table(
        self,
        display: &Capabilities,
        samples: &[Rgb<u8>],
        width: u32,
    ) -> Result<Table, TableError> {
        let Capabilities { colors, gun_max, .. } = *display;
        let mut memory = vec![Rgb::default(); samples.len()];
        let light = || samples.iter().copied();
        let mut cut = || variance_cut(&mut memory, light(), width, colors, gun_max);
        Ok(Table(match self {
            Self::Sampled | Self::Baked => Box::new(cut()?),
            Self::Frame => {
                let begin = cut()?;
                Box::new(refined(begin, &mut memory, light(), width, gun_max)?)
            }
            Self::Tolerant => Box::new(Adaptive::tolerant(colors, gun_max)?),
            Self::Adaptive => Box::new(Adaptive::new(colors)?),
            Self::Uniform => Box::new(Uniform::new(colors, gun_max)?),
        }))
    }

    /// Returns the dithering that a picture with this table has unless another is asked for: error diffusion for a table made for
    /// the picture on fine pixels.
    pub(crate) fn dithering(self, display: &Capabilities) -> DitherKind {
        if self == Self::Sampled && display.has_fine_pixels() { DitherKind::Fs } else { DitherKind::None }
    }
}

impl DitherKind {
    /// All kinds with their names.
    pub(crate) const ALL: [(&str, Self); 4] =
        [("none", Self::None), ("fs", Self::Fs), ("fs7351", Self::Fs7351), ("bayer", Self::Bayer)];
}

/// A colour table of any kind.
pub(crate) struct Table(Box<dyn ColorTable>);

impl ColorTable for Table {
    fn light_max(&self, gun_max: u8) -> u8 {
        self.0.light_max(gun_max)
    }

    fn index(&mut self, color: Rgb<u8>) -> u8 {
        self.0.index(color)
    }

    fn index_near(&mut self, pixel: Rgb<u8>, color: Rgb<u8>, gun_max: u8) -> u8 {
        self.0.index_near(pixel, color, gun_max)
    }

    fn entries(&self) -> &[Rgb<u8>] {
        self.0.entries()
    }
}
