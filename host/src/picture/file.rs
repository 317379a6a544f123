//! Pictures as files: PNG, PPM and PFM, films, and what the `image` crate writes.
//!
//! All but two hold what a display shows: levels of its guns, scaled to 8 bits, with no gamma applied and none
//! stated, so that they look as they do in the window. PFM and Radiance HDR hold linear light before any display,
//! unclamped.

use std::borrow::Cow;
use std::io::{self, Write};

use rta_core::color::Rgb;

use super::raster::{Size, fraction};
#[cfg(feature = "image")]
use film::FilmWriter;
pub use rta_args::value::file_type::FileType;

pub mod film;
#[cfg(feature = "image")]
pub mod other;
pub mod reading;

/// Text that is stored in a picture file whose format has room for it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Caption {
    /// The scene's title.
    pub title: String,
    /// The settings that it was traced and displayed with.
    pub settings: String,
}

/// A picture as a display shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct Displayed {
    /// Width and height in pixels.
    pub size: Size,
    /// Width over height of the screen it fills.
    pub aspect: f64,
    /// Its pixels, row by row from the top.
    pub pixels: Pixels,
}

/// The pixels of a [`Displayed`] picture, one for each place in its size.
#[derive(Clone, Debug, PartialEq)]
pub enum Pixels {
    /// Entries of a colour table.
    Indexed {
        /// The entries that were made, 1 to 256, with 8 bits a gun.
        palette: Vec<Rgb<u8>>,
        /// Index of an entry for each pixel.
        indices: Vec<u8>,
    },
    /// Colours with 8 bits a gun.
    Direct(Vec<Rgb<u8>>),
}

impl Displayed {
    /// Writes a picture file of any kind but those that hold linear light.
    ///
    /// # Errors
    /// Those of `out`, and [`io::ErrorKind::Unsupported`] where [`FileType::is_linear`].
    pub fn write(&self, file_type: FileType, caption: &Caption, mut out: &mut dyn Write) -> io::Result<()> {
        match file_type {
            FileType::Png => self.write_png(caption, out),
            FileType::Ppm => self.write_ppm(&mut out),
            #[cfg(feature = "image")]
            FileType::Bmp => self.write_bmp(out),
            #[cfg(feature = "image")]
            FileType::Gif => {
                let mut film = FilmWriter::new(file_type, self.shape(), (1, 1), None, caption, out)?;
                film.frame(self)?;
                film.finish()
            }
            #[cfg(feature = "image")]
            FileType::Tga => self.write_tga(out),
            #[cfg(feature = "image")]
            FileType::Qoi => self.write_qoi(out),
            #[cfg(feature = "image")]
            FileType::Hdr => Err(io::ErrorKind::Unsupported.into()),
            FileType::Pfm => Err(io::ErrorKind::Unsupported.into()),
        }
    }

    /// Returns its pixels in a row and in a column, and the shape of the screen that it fills.
    #[must_use]
    pub const fn shape(&self) -> (Size, f64) {
        (self.size, self.aspect)
    }

    /// Writes a PNG: indexed with its colour table, or with 8-bit RGB, and with the shape of its pixels (pHYs).
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_png(&self, caption: &Caption, out: impl Write) -> io::Result<()> {
        let mut info = info(self.size, self.aspect);
        let data = match &self.pixels {
            Pixels::Indexed { palette, indices } => {
                info.color_type = png::ColorType::Indexed;
                info.palette = Some(bytes(palette).into());
                indices.clone()
            }
            Pixels::Direct(pixels) => bytes(pixels),
        };
        let mut writer = header(info, caption, out)?;
        writer.write_image_data(&data)?;
        Ok(writer.finish()?)
    }

    /// Writes a binary PPM (P6) with 8 bits a gun.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_ppm(&self, out: &mut (impl Write + ?Sized)) -> io::Result<()> {
        write_ppm_header(self.size, out)?;
        out.write_all(&self.registers())
    }

    /// Returns the registers of all pixels one after the other: red, green, blue.
    fn registers(&self) -> Vec<u8> {
        bytes(&self.colors())
    }

    /// Returns the colours of all pixels, 8 bits a gun.
    #[must_use]
    pub fn colors(&self) -> Cow<'_, [Rgb<u8>]> {
        match &self.pixels {
            Pixels::Direct(pixels) => pixels.into(),
            Pixels::Indexed { palette, indices } => {
                let color = |index: &u8| palette.get(usize::from(*index)).copied().unwrap_or_default();
                indices.iter().map(color).collect()
            }
        }
    }
}

/// Returns the header of a PNG with 8-bit RGB, with the ratio of a pixel's sides (pHYs: pixels per unit along x and y) unless it
/// is square.
fn info(size: Size, aspect: f64) -> png::Info<'static> {
    let mut info = png::Info::with_size(size.width(), size.height());
    info.bit_depth = png::BitDepth::Eight;
    info.color_type = png::ColorType::Rgb;
    let (width, height) = fraction(aspect / size.ratio());
    // A pixel of 5 by 6 units is 6 pixels across for 5 down.
    info.pixel_dims = (width != height).then_some(png::PixelDimensions {
        xppu: height,
        yppu: width,
        unit: png::Unit::Unspecified,
    });
    info
}

/// Begins a PNG with its texts.
fn start<'a, W: Write>(info: png::Info<'a>, caption: &Caption, out: W) -> io::Result<png::Encoder<'a, W>> {
    let mut encoder = png::Encoder::with_info(out, info)?;
    encoder.add_text_chunk("Software".into(), concat!("rta ", env!("CARGO_PKG_VERSION")).into())?;
    encoder.add_itxt_chunk("Title".into(), caption.title.clone())?;
    encoder.add_itxt_chunk("Comment".into(), caption.settings.clone())?;
    Ok(encoder)
}

/// Writes the part of a PNG that comes before its pixels.
fn header<W: Write>(info: png::Info, caption: &Caption, out: W) -> io::Result<png::Writer<W>> {
    Ok(start(info, caption, out)?.write_header()?)
}

/// Writes a PNG with 8-bit RGB. `fill` writes the registers of its pixels, from left to right and from top to bottom.
///
/// # Errors
/// Those of `out` and of `fill`.
pub fn write_png_rows<E: From<io::Error>>(
    size: Size,
    aspect: f64,
    caption: &Caption,
    out: &mut dyn Write,
    fill: impl FnOnce(&mut dyn Write) -> Result<(), E>,
) -> Result<(), E> {
    let mut writer = header(info(size, aspect), caption, out)?;
    let mut rows = writer.stream_writer().map_err(io::Error::from)?;
    fill(&mut rows)?;
    rows.finish().map_err(io::Error::from)?;
    Ok(writer.finish().map_err(io::Error::from)?)
}

/// Returns the registers of all pixels one after the other: red, green, blue.
pub(crate) fn bytes(pixels: &[Rgb<u8>]) -> Vec<u8> {
    let mut bytes = vec![0; 3 * pixels.len()];
    for (registers, pixel) in bytes.as_chunks_mut().0.iter_mut().zip(pixels) {
        *registers = [pixel.r, pixel.g, pixel.b];
    }
    bytes
}

/// Writes the header of a binary PPM (P6) with 8 bits a gun.
///
/// # Errors
/// Those of `out`.
pub fn write_ppm_header(size: Size, out: &mut (impl Write + ?Sized)) -> io::Result<()> {
    write!(out, "P6\n{} {}\n255\n", size.width(), size.height())
}

/// Writes the header of a PFM: `PF`, little endian (scale -1.0). Rows follow from the bottom to the top.
///
/// # Errors
/// Those of `out`.
pub fn write_pfm_header(size: Size, out: &mut (impl Write + ?Sized)) -> io::Result<()> {
    write!(out, "PF\n{} {}\n-1.0\n", size.width(), size.height())
}

/// Writes pixels of a PFM: linear light as 32-bit floats, little endian.
///
/// # Errors
/// Those of `out`.
pub fn write_light(pixels: &[Rgb<f32>], out: &mut (impl Write + ?Sized)) -> io::Result<()> {
    out.write_all(&light_bytes(pixels))
}

/// Returns linear light as 32-bit floats, little endian: red, green, blue of all pixels one after the other.
pub(crate) fn light_bytes(pixels: &[Rgb<f32>]) -> Vec<u8> {
    pixels.iter().flat_map(|pixel| [pixel.r, pixel.g, pixel.b]).flat_map(f32::to_le_bytes).collect()
}

/// Reverses the order of rows of `columns` pixels.
pub fn flip<T>(pixels: &mut [T], columns: usize) {
    let mut rest = pixels;
    while rest.len() >= 2 * columns && columns > 0 {
        let (first, others) = rest.split_at_mut(columns);
        let (middle, last) = others.split_at_mut(others.len() - columns);
        first.swap_with_slice(last);
        rest = middle;
    }
}

#[cfg(test)]
mod tests;
