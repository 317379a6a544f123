//! Picture files that are read to be compared: PNG.

use std::fs::File;
use std::io::{self, BufReader, Seek};
use std::path::Path;

use png::{BitDepth, ColorType, Decoder, Transformations};
use rta_core::color::Rgb;

use crate::picture::error::PictureError;
use crate::picture::output::Inputs;
use crate::picture::raster::Size;

/// A picture that was read from a file.
#[derive(Clone, Debug)]
pub struct ReadPicture {
    /// Width and height in pixels.
    pub size: Size,
    /// Width over height of the screen that it fills.
    pub aspect: f64,
    /// Its codes, row by row from the top, with 8 bits a register.
    pub pixels: Vec<Rgb<u8>>,
    /// The file, so that no output replaces it.
    pub inputs: Inputs,
}

impl ReadPicture {
    /// Reads a PNG of any kind without transparent pixels. Of registers of 16 bits the upper 8 are taken; what it says about gamma
    /// and colour profiles is passed over.
    ///
    /// # Errors
    /// [`PictureError::Read`].
    pub fn open(path: &Path) -> Result<Self, PictureError> {
        let read = File::open(path).and_then(|file| {
            let (size, aspect, pixels) = decoded(BufReader::new(&file))?;
            Ok(Self { size, aspect, pixels, inputs: Inputs::file(&file) })
        });
        read.map_err(|source| PictureError::Read { path: path.to_owned(), source })
    }
}

fn decoded(file: impl io::BufRead + Seek) -> io::Result<(Size, f64, Vec<Rgb<u8>>)> {
    let mut decoder = Decoder::new(file);
    decoder.set_transformations(Transformations::EXPAND | Transformations::STRIP_16);
    let mut reader = decoder.read_info()?;
    let size = Size::new(reader.info().width, reader.info().height).map_err(io::Error::other)?;
    // A pixel that is 6 across for 5 down is 5 wide for 6 high.
    let pixel = reader.info().pixel_dims.filter(|pixel| pixel.xppu > 0 && pixel.yppu > 0);
    let ratio = pixel.map_or(1.0, |pixel| f64::from(pixel.yppu) / f64::from(pixel.xppu));
    let length = reader.output_buffer_size().unwrap_or(usize::MAX);
    let mut bytes = Vec::new();
    bytes.try_reserve_exact(length).map_err(io::Error::other)?;
    bytes.resize(length, 0);
    let frame = reader.next_frame(&mut bytes)?;
    if frame.bit_depth != BitDepth::Eight {
        return Err(io::ErrorKind::Unsupported.into());
    }
    let pixels: Option<Vec<_>> = match frame.color_type {
        ColorType::Grayscale => bytes.iter().map(|&gray| opaque(gray, gray, gray, u8::MAX)).collect(),
        ColorType::GrayscaleAlpha => {
            bytes.as_chunks().0.iter().map(|&[gray, alpha]| opaque(gray, gray, gray, alpha)).collect()
        }
        ColorType::Rgb => bytes.as_chunks().0.iter().map(|&[r, g, b]| opaque(r, g, b, u8::MAX)).collect(),
        ColorType::Rgba => {
            bytes.as_chunks().0.iter().map(|&[r, g, b, alpha]| opaque(r, g, b, alpha)).collect()
        }
        ColorType::Indexed => return Err(io::ErrorKind::Unsupported.into()),
    };
    Ok((size, size.ratio() * ratio, pixels.ok_or_else(|| io::Error::other("it has transparent pixels"))?))
}

/// Returns the colour of a pixel that hides what is behind it.
fn opaque(r: u8, g: u8, b: u8, alpha: u8) -> Option<Rgb<u8>> {
    (alpha == u8::MAX).then_some(Rgb::new(r, g, b))
}
