//! Arguments of `rta explain`.

use core::str::FromStr;
use std::path::PathBuf;

use clap::Args;

use super::choice;
use super::scene::ReadingArgs;
use super::tracing::TracingArgs;
use crate::value::raster::{Aspect, Size};
use rta_packets::picture::MAX_DEPTH;
use rta_scenes::{Format, Model};

/// The pixel to explain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    /// Column from the left and row from the top, both from 0.
    At(u32, u32),
    /// The pixel whose colour in the format is farthest from that in `f64`.
    Worst,
}

impl FromStr for Choice {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        const EXPECTED: &str = "expected X,Y from 0,0 in the upper left corner, or worst";
        if text == "worst" {
            return Ok(Self::Worst);
        }
        let (x, y) = text.split_once(',').ok_or(EXPECTED)?;
        Ok(Self::At(x.parse().map_err(|_| EXPECTED)?, y.parse().map_err(|_| EXPECTED)?))
    }
}

/// `rta explain`.
#[derive(Args, Debug)]
pub struct ExplainArgs {
    /// Scene file (.rta, .dat, .nff or .p3f), or - for standard input
    pub scene: PathBuf,
    /// How the scene is read
    #[command(flatten)]
    pub reading: ReadingArgs,
    /// Column and row from 0,0 in the upper left corner, or worst: the one whose colour is farthest off
    #[arg(short, long, value_name = "X,Y")]
    pub pixel: Choice,
    /// Number format that is put beside f64
    #[arg(short, long, default_value_t = Format::Q16, value_parser = choice::tested_format(), ignore_case = true)]
    pub format: Format,
    /// Illumination model [default: what the scene was made for: rta, or phong for .nff]
    #[arg(short, long, value_parser = choice::model(), ignore_case = true)]
    pub model: Option<Model>,
    /// Reflections and refractions that a ray is followed through; 0 is what the eye sees directly
    ///
    /// [default: what a .rta says, else 5]
    #[arg(long, value_name = "N", value_parser = choice::whole(0..=MAX_DEPTH), verbatim_doc_comment)]
    pub depth: Option<u32>,
    /// Pixels of the picture [default: those of the scene, else 320x200]
    #[arg(short, long, value_name = "WxH")]
    pub size: Option<Size>,
    /// Shape of the screen, as 4:3 or 1.333 [default: square pixels, except that 320x200 is a 4:3 screen]
    #[arg(long, value_name = "RATIO")]
    pub aspect: Option<Aspect>,
    /// Scale the scene by a power of two if it does not fit the number format (not one with a floor)
    #[arg(long)]
    pub fit: bool,
}

impl ExplainArgs {
    /// Returns how the picture is traced to which the pixel belongs: one ray through the middle of each pixel.
    #[must_use]
    pub fn tracing(&self) -> TracingArgs {
        let Self { reading, format, model, depth, size, aspect, fit, .. } = *self;
        TracingArgs { reading, format, model, depth, size, aspect, fit, ..TracingArgs::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::Choice;

    #[test]
    fn pixels_are_read() {
        assert_eq!("12,34".parse(), Ok(Choice::At(12, 34)));
        assert_eq!("worst".parse(), Ok(Choice::Worst));
        for text in ["", "1", "1,", ",1", "-1,2", "1,2,3", "best", "1.5,2"] {
            assert!(text.parse::<Choice>().is_err(), "{text}");
        }
    }
}
