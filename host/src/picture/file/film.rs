//! Files that hold a film: GIF, animated PNG, and PPM, in which one picture follows another.

use std::io::{self, Write};

use rta_core::color::Rgb;

use super::{Caption, Displayed, FileType, Pixels, bytes, info, start};
use crate::picture::raster::Size;

/// A film that is being written, one frame after the other.
pub struct FilmWriter<'a> {
    kind: Kind<'a>,
}

enum Kind<'a> {
    #[cfg(feature = "image")]
    Gif {
        encoder: gif::Encoder<&'a mut dyn Write>,
        /// Hundredths of a second.
        delay: u16,
        /// Whether all frames have the table of the file.
        has_one_table: bool,
    },
    Png {
        writer: png::Writer<&'a mut dyn Write>,
        /// Whether pixels are entries of the table of the file.
        is_indexed: bool,
    },
    Ppm(&'a mut dyn Write),
}

impl<'a> FilmWriter<'a> {
    /// Begins a film of pictures of one shape: their size, and width over height of the screen that they fill. It has so many frames,
    /// and so many in a second. `table` is what all of them have; without it each frame of a GIF has its own, and a PNG has 24 bits a pixel,
    /// as its format has one table at most.
    ///
    /// # Errors
    /// [`io::ErrorKind::Unsupported`] for a file that [holds no films](FileType::holds_films), and those of `out`.
    pub fn new(
        file_type: FileType,
        (size, aspect): (Size, f64),
        (frames, rate): (u32, u16),
        table: Option<&[Rgb<u8>]>,
        caption: &Caption,
        out: &'a mut dyn Write,
    ) -> io::Result<Self> {
        let kind = match file_type {
            #[cfg(feature = "image")]
            FileType::Gif => gif_file(size, (frames, rate), table, caption, out)?,
            FileType::Png => {
                let mut info = info(size, aspect);
                if let Some(table) = table {
                    info.color_type = png::ColorType::Indexed;
                    info.palette = Some(bytes(table).into());
                }
                let mut encoder = start(info, caption, out)?;
                encoder.set_animated(frames, 0)?;
                encoder.set_frame_delay(1, rate)?;
                Kind::Png { writer: encoder.write_header()?, is_indexed: table.is_some() }
            }
            FileType::Ppm => Kind::Ppm(out),
            _ => return Err(io::ErrorKind::Unsupported.into()),
        };
        Ok(Self { kind })
    }

    /// Writes the next frame.
    ///
    /// # Errors
    /// Those of the file, and [`io::ErrorKind::Unsupported`] for a GIF of a picture without a colour table.
    pub fn frame(&mut self, picture: &Displayed) -> io::Result<()> {
        match &mut self.kind {
            #[cfg(feature = "image")]
            Kind::Gif { encoder, delay, has_one_table } => {
                let Pixels::Indexed { palette, indices } = &picture.pixels else {
                    return Err(io::ErrorKind::Unsupported.into());
                };
                let (width, height) = sides(picture.size);
                let table = (!*has_one_table).then(|| bytes(palette));
                let frame = gif::Frame {
                    width,
                    height,
                    delay: *delay,
                    palette: table,
                    buffer: indices.into(),
                    ..gif::Frame::default()
                };
                encoder.write_frame(&frame).map_err(gif_error)
            }
            Kind::Png { writer, is_indexed } => {
                match &picture.pixels {
                    Pixels::Indexed { indices, .. } if *is_indexed => writer.write_image_data(indices)?,
                    _ => writer.write_image_data(&picture.registers())?,
                }
                Ok(())
            }
            Kind::Ppm(out) => picture.write_ppm(out),
        }
    }

    /// Ends the film.
    ///
    /// # Errors
    /// Those of the file, also where there were too few frames or too many.
    pub fn finish(self) -> io::Result<()> {
        match self.kind {
            #[cfg(feature = "image")]
            Kind::Gif { encoder, .. } => encoder.into_inner().map(drop),
            Kind::Png { writer, .. } => Ok(writer.finish()?),
            Kind::Ppm(out) => out.flush(),
        }
    }
}

/// Begins a GIF. A film is shown again and again.
#[cfg(feature = "image")]
fn gif_file<'a>(
    size: Size,
    (frames, rate): (u32, u16),
    table: Option<&[Rgb<u8>]>,
    caption: &Caption,
    out: &'a mut dyn Write,
) -> io::Result<Kind<'a>> {
    let (width, height) = sides(size);
    let own = table.map(bytes).unwrap_or_default();
    let mut encoder = gif::Encoder::new(out, width, height, &own).map_err(gif_error)?;
    if frames > 1 {
        encoder.set_repeat(gif::Repeat::Infinite).map_err(gif_error)?;
    }
    let text = format!("{}: {}", caption.title, caption.settings);
    let comment = gif::AnyExtension::from(gif::Extension::Comment);
    // Parts of a GIF hold up to 255 bytes.
    let parts: Vec<_> = text.as_bytes().chunks(255).collect();
    encoder.write_raw_extension(comment, &parts)?;
    let delay = (200 / rate.max(1)).div_ceil(2);
    Ok(Kind::Gif { encoder, delay, has_one_table: table.is_some() })
}

/// Returns width and height, each at most 65535.
#[cfg(feature = "image")]
fn sides(size: Size) -> (u16, u16) {
    let side = |pixels| u16::try_from(pixels).unwrap_or(u16::MAX);
    (side(size.width()), side(size.height()))
}

#[cfg(feature = "image")]
fn gif_error(error: gif::EncodingError) -> io::Error {
    match error {
        gif::EncodingError::Io(error) => error,
        other => io::Error::other(other),
    }
}
