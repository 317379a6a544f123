//! The picture files that the `image` crate writes: BMP, TGA, QOI and Radiance HDR.

use std::io::{self, Write};

use image::codecs::bmp::BmpEncoder;
use image::codecs::hdr::HdrEncoder;
use image::codecs::qoi::QoiEncoder;
use image::codecs::tga::TgaEncoder;
use image::{ExtendedColorType, ImageEncoder, ImageError};
use rta_core::color::Rgb;

use super::{Displayed, Pixels};
use crate::picture::raster::Size;

impl Displayed {
    /// Writes a BMP: with its colour table, or with 24 bits a pixel. It does not tell the shape of the pixels.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_bmp(&self, mut out: &mut dyn Write) -> io::Result<()> {
        let (width, height) = (self.size.width(), self.size.height());
        let mut encoder = BmpEncoder::new(&mut out);
        match &self.pixels {
            Pixels::Direct(_) => encoder.encode(&self.registers(), width, height, ExtendedColorType::Rgb8),
            Pixels::Indexed { palette, indices } => {
                let palette: Vec<_> = palette.iter().map(|color| [color.r, color.g, color.b]).collect();
                encoder.encode_with_palette(indices, width, height, ExtendedColorType::L8, Some(&palette))
            }
        }
        .map_err(io_error)
    }

    /// Writes a TGA with 24 bits a pixel.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_tga(&self, out: &mut dyn Write) -> io::Result<()> {
        self.encode(TgaEncoder::new(out))
    }

    /// Writes a QOI with 24 bits a pixel.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_qoi(&self, out: &mut dyn Write) -> io::Result<()> {
        self.encode(QoiEncoder::new(out))
    }

    fn encode(&self, encoder: impl ImageEncoder) -> io::Result<()> {
        let (width, height) = (self.size.width(), self.size.height());
        encoder.write_image(&self.registers(), width, height, ExtendedColorType::Rgb8).map_err(io_error)
    }
}

/// Writes linear light as a Radiance HDR: three mantissas of 8 bits with a common exponent.
///
/// # Errors
/// Those of `out`.
pub fn write_hdr(size: Size, pixels: &[Rgb<f32>], out: &mut dyn Write) -> io::Result<()> {
    let pixels: Vec<_> = pixels.iter().map(|light| image::Rgb([light.r, light.g, light.b])).collect();
    HdrEncoder::new(out).encode(&pixels, size.columns(), size.height() as usize).map_err(io_error)
}

fn io_error(error: ImageError) -> io::Error {
    match error {
        ImageError::IoError(error) => error,
        other => io::Error::other(other),
    }
}
