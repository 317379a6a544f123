//! Pictures as files: PNG, PPM and PFM.
//!
//! PNG and PPM hold what a display shows: levels of its guns, scaled to 8 bits, with no gamma applied and none
//! stated, so that they look as they do in the window. PFM holds linear light before any display, unclamped.

use core::fmt;
use std::io::{self, Write};

use clap::ValueEnum;
use rta_core::color::Rgb;

use super::raster::{Size, fraction};

/// The kinds of picture file that are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum FileType {
    /// Portable Network Graphics: with the device's colour table if there is a device.
    Png,
    /// Portable pixmap, binary (P6): the same colours without a table.
    Ppm,
    /// Portable float map (PF), little endian: linear light, needs `--device none`.
    Pfm,
}

impl FileType {
    /// The type that the extension of a file name stands for, in upper or lower case.
    #[must_use]
    pub fn of_extension(extension: &str) -> Option<Self> {
        Self::from_str(extension, true).ok()
    }
}

impl fmt::Display for FileType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Png => "PNG",
            Self::Ppm => "PPM",
            Self::Pfm => "PFM",
        })
    }
}

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
        match &self.pixels {
            Pixels::Direct(pixels) => out.write_all(&bytes(pixels)),
            Pixels::Indexed { palette, indices } => {
                let color = |index: &u8| palette.get(usize::from(*index)).copied().unwrap_or_default();
                out.write_all(&bytes(&indices.iter().map(color).collect::<Vec<_>>()))
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

/// Writes the part of a PNG that comes before its pixels.
fn header<W: Write>(info: png::Info, caption: &Caption, out: W) -> io::Result<png::Writer<W>> {
    let mut encoder = png::Encoder::with_info(out, info)?;
    encoder.add_text_chunk("Software".into(), concat!("rta ", env!("CARGO_PKG_VERSION")).into())?;
    encoder.add_itxt_chunk("Title".into(), caption.title.clone())?;
    encoder.add_itxt_chunk("Comment".into(), caption.settings.clone())?;
    Ok(encoder.write_header()?)
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
    let registers = pixels.iter().flat_map(|pixel| [pixel.r, pixel.g, pixel.b]);
    out.write_all(&registers.flat_map(f32::to_le_bytes).collect::<Vec<u8>>())
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
mod tests {
    use rta_core::color::Rgb;

    use std::io::Write;

    use super::{
        Caption, Displayed, FileType, Pixels, bytes, flip, write_light, write_pfm_header, write_png_rows,
    };
    use crate::picture::raster::Size;

    const RED: Rgb<u8> = Rgb::new(255, 0, 0);
    const GRAY: Rgb<u8> = Rgb::new(85, 85, 85);

    fn indexed() -> Displayed {
        let pixels = Pixels::Indexed { palette: vec![RED, GRAY], indices: vec![0, 1, 1, 0, 0, 1] };
        Displayed { size: Size::new(3, 2).expect("small"), aspect: 1.5 * 5.0 / 6.0, pixels }
    }

    #[test]
    fn extensions_name_types_in_any_case() {
        assert_eq!(FileType::of_extension("PNG"), Some(FileType::Png));
        assert_eq!(FileType::of_extension("pfm"), Some(FileType::Pfm));
        assert_eq!(FileType::of_extension("jpg"), None);
        assert_eq!(FileType::of_extension(""), None);
    }

    #[test]
    fn an_indexed_png_keeps_its_table_shape_and_words() {
        let mut file = Vec::new();
        let caption = Caption { title: "Spheres \u{3b1}".into(), settings: "depth 5".into() };
        indexed().write_png(&caption, &mut file).expect("memory takes it");
        let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().expect("a PNG");
        let mut indices = [9; 6];
        reader.next_frame(&mut indices).expect("six pixels");
        reader.finish().expect("an end");
        assert_eq!(indices, [0, 1, 1, 0, 0, 1]);
        let info = reader.info();
        assert_eq!(info.color_type, png::ColorType::Indexed);
        assert_eq!(info.palette.as_deref(), Some(&[255, 0, 0, 85, 85, 85][..]));
        let shape = info.pixel_dims.expect("the pixels are not square");
        assert_eq!((shape.xppu, shape.yppu), (6, 5));
        assert!(info.uncompressed_latin1_text.iter().any(|chunk| chunk.keyword == "Software"));
        let title = info.utf8_text.iter().find(|chunk| chunk.keyword == "Title").expect("a title");
        assert_eq!(title.get_text().expect("text"), "Spheres \u{3b1}");
    }

    #[test]
    fn square_pixels_need_no_word() {
        let picture = Displayed { aspect: 1.5, ..indexed() };
        let mut file = Vec::new();
        picture.write_png(&Caption::default(), &mut file).expect("memory takes it");
        let reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().expect("a PNG");
        assert!(reader.info().pixel_dims.is_none());
    }

    #[test]
    fn a_ppm_has_the_colours_of_the_table() {
        let (mut table, mut direct) = (Vec::new(), Vec::new());
        indexed().write_ppm(&mut table).expect("memory takes it");
        let pixels = Pixels::Direct(vec![RED, GRAY, GRAY, RED, RED, GRAY]);
        Displayed { pixels, ..indexed() }.write_ppm(&mut direct).expect("memory takes it");
        assert_eq!(table, direct);
        assert_eq!(table, b"P6\n3 2\n255\n\xff\0\0UUUUUU\xff\0\0\xff\0\0UUU");
    }

    #[test]
    fn a_pfm_is_in_little_endian() {
        let mut file = Vec::new();
        let pixels = [Rgb::new(0.0, 40_000.0, 0.25), Rgb::new(1.0, 2.0, -0.5)];
        write_pfm_header(Size::new(1, 2).expect("small"), &mut file).expect("memory takes it");
        write_light(&pixels, &mut file).expect("memory takes it");
        let numbers: Vec<u8> =
            [0.0_f32, 40_000.0, 0.25, 1.0, 2.0, -0.5].into_iter().flat_map(f32::to_le_bytes).collect();
        assert_eq!(file, [b"PF\n1 2\n-1.0\n".as_slice(), &numbers].concat());
    }

    #[test]
    fn rows_are_flipped() {
        for (rows, want) in [(0, vec![]), (1, vec![0, 1]), (2, vec![2, 3, 0, 1]), (3, vec![4, 5, 2, 3, 0, 1])]
        {
            let mut pixels: Vec<i32> = (0..2 * rows).collect();
            flip(&mut pixels, 2);
            assert_eq!(pixels, want);
        }
    }

    #[test]
    fn rows_of_a_png_one_by_one_are_the_picture() {
        let size = Size::new(2, 3).expect("small");
        let pixels = [RED, GRAY, GRAY, RED, RED, GRAY];
        let mut file = Vec::new();
        let fill = |rows: &mut dyn Write| pixels.chunks(4).try_for_each(|part| rows.write_all(&bytes(part)));
        write_png_rows(size, size.ratio(), &Caption::default(), &mut file, fill).expect("memory takes it");
        let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().expect("a PNG");
        let mut got = [9; 18];
        reader.next_frame(&mut got).expect("six pixels");
        assert_eq!(got.as_slice(), bytes(&pixels));
    }
}
