//! Picture files: textures of objects, and the sky.

use core::fmt;
#[cfg(feature = "images")]
use core::{cell::RefCell, panic::AssertUnwindSafe};
use std::collections::btree_map::Entry;
use std::path::{Path, PathBuf};
use std::sync::Arc;
#[cfg(feature = "images")]
use std::{
    fs::File,
    io::{self, BufRead, BufReader, Cursor, Seek},
    panic::catch_unwind,
};

#[cfg(feature = "images")]
use image::{DynamicImage, ImageDecoder, ImageError, ImageFormat, ImageReader, Limits, RgbImage};

use crate::description::{Description, Pattern, Pixels};

/// Sides of the largest picture that is decoded, in pixels.
pub const LARGEST_SIDE: u32 = 8192;

/// Memory that decoding may take for each pixel of the largest picture, in bytes: four parts of 16 bits, 512 MiB in all.
#[cfg(feature = "images")]
const PIXEL_MEMORY: u64 = 8;

/// What is put behind a JPEG file, a byte that ends what is before it and the mark of the end: the decoder of the version of `image` that
/// `Cargo.lock` holds never stops at a progressive file that is cut off behind the mark of a restart.
#[cfg(feature = "images")]
const JPEG_END: [u8; 3] = [0, 0xff, 0xd9];

/// A picture file of a scene that cannot be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PictureError {
    /// Where the picture is looked for.
    pub path: PathBuf,
    /// Line of the scene that names it, from 1; 0 for the sky.
    pub line: u32,
    /// Why.
    pub reason: String,
}

impl fmt::Display for PictureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { path, line, reason } = self;
        match line {
            0 => f.write_str("the picture of the sky")?,
            line => write!(f, "the picture of the texture in line {line}")?,
        }
        write!(f, ", {}: {reason}", path.display())
    }
}

impl core::error::Error for PictureError {}

impl Description {
    /// Returns the picture files that the scene names, each with the line that names it; 0 for the sky's.
    pub fn named_pictures(&self) -> impl Iterator<Item = (&str, u32)> {
        let textures = self.textures.iter().filter_map(|texture| match &texture.pattern {
            Pattern::Image { file, .. } => Some((file.as_str(), texture.line)),
            _ => None,
        });
        textures.chain(self.details.sky_map.as_deref().map(|file| (file, 0)))
    }

    /// Reads the pictures that the scene names, from files beside the scene's own in `folder`, and makes those smaller that have more than `most`
    /// pixels on a side. Returns the files. As long as a picture is not loaded it is white.
    ///
    /// # Errors
    /// The first picture that is not there, or broken, or larger than [`LARGEST_SIDE`].
    pub fn load_pictures(&mut self, folder: &Path, most: u32) -> Result<Vec<PathBuf>, PictureError> {
        let files = self.named_pictures().map(|(file, _)| folder.join(file)).collect();
        self.take_pictures(|file| Ok(Arc::new(open(&folder.join(file))?.reduced(most))))
            .map_err(|error| PictureError { path: folder.join(&error.path), ..error })?;
        Ok(files)
    }

    /// Takes the pictures that the scene names from wherever they are, which `picture` knows by the names of their files or says why not: see
    /// [`decode`] and [`Pixels::reduced`]. Each is asked for once.
    ///
    /// # Errors
    /// The first picture that is not had.
    pub fn take_pictures(
        &mut self,
        mut picture: impl FnMut(&str) -> Result<Arc<Pixels>, String>,
    ) -> Result<(), PictureError> {
        let named: Vec<_> = self.named_pictures().map(|(file, line)| (file.to_owned(), line)).collect();
        for (file, line) in named {
            if let Entry::Vacant(entry) = self.details.pictures.entry(file) {
                let failed = |reason| PictureError { path: entry.key().into(), line, reason };
                let pixels = picture(entry.key()).map_err(failed)?;
                entry.insert(pixels);
            }
        }
        if let Some(sky) = self.details.sky_map.as_ref().and_then(|file| self.details.pictures.get(file)) {
            // For what asks the sky without a direction, such as haze.
            (self.sky.horizon, self.sky.zenith) = (sky.mean(sky.height / 2), sky.mean(0));
        }
        Ok(())
    }
}

#[cfg(not(feature = "images"))]
fn open(_: &Path) -> Result<Pixels, String> {
    Err("this program was built without the reader of pictures (feature `images`)".into())
}

#[cfg(feature = "images")]
fn open(path: &Path) -> Result<Pixels, String> {
    let file = File::open(path).map_err(|error| error.to_string())?;
    DECODED.replace(Some(path.to_owned()));
    let pixels = decode(BufReader::new(file), path, LARGEST_SIDE);
    DECODED.replace(None);
    pixels
}

#[cfg(feature = "images")]
std::thread_local! {
    /// The picture file that a thread decodes.
    static DECODED: RefCell<Option<PathBuf>> = const { RefCell::new(None) };
}

/// Returns the picture file that this thread is decoding: for the panic hook of a program whose panics abort, as broken files can make
/// decoders panic.
#[cfg(feature = "images")]
#[must_use]
pub fn decoded() -> Option<PathBuf> {
    DECODED.try_with(|path| path.try_borrow().ok()?.clone()).ok()?
}

/// Reads a picture from the bytes of a file. The format is what they begin with, or else, as a TGA file does not say what it is, the ending of
/// `name`. Memory beside the file's own bytes, which may be held twice, is bounded by `largest`, whatever the file says of itself.
///
/// # Errors
/// A reason in one line: no picture, a broken one, or one without pixels or with more than `largest` on a side.
#[cfg(feature = "images")]
pub fn decode(file: impl BufRead + Seek, name: &Path, largest: u32) -> Result<Pixels, String> {
    // The decoder of JPEG files panics at some broken ones, most of all in debug builds, where it checks itself more. A program whose panics
    // abort, as those of this workspace's release builds do, ends there: its panic hook can ask for [`decoded`]. What a panic leaves half done is dropped.
    let pixels = catch_unwind(AssertUnwindSafe(|| decode_colors(file, name, largest)))
        .unwrap_or_else(|_| Err("broken in a way that its decoder does not expect".into()))?;
    let words = pixels.pixels().map(|pixel| {
        let [r, g, b] = pixel.0;
        u32::from_be_bytes([0, r, g, b])
    });
    Ok(Pixels { width: pixels.width(), height: pixels.height(), words: words.collect() })
}

#[cfg(feature = "images")]
fn decode_colors(file: impl BufRead + Seek, name: &Path, largest: u32) -> Result<RgbImage, String> {
    let told = |error: ImageError| error.to_string();
    let failed = |error: io::Error| error.to_string();
    let mut limits = Limits::default();
    limits.max_alloc = Some(PIXEL_MEMORY * u64::from(largest) * u64::from(largest));
    let mut reader = ImageReader::new(file);
    // What stands before the pixels takes memory too.
    reader.limits(limits.clone());
    if let Ok(format) = ImageFormat::from_path(name) {
        reader.set_format(format);
    }
    let reader = reader.with_guessed_format().map_err(failed)?;
    let mut decoder: Box<dyn ImageDecoder> = if reader.format() == Some(ImageFormat::Jpeg) {
        let mut bytes = Vec::new();
        reader.into_inner().read_to_end(&mut bytes).map_err(failed)?;
        bytes.extend(JPEG_END);
        let mut reader = ImageReader::with_format(Cursor::new(bytes), ImageFormat::Jpeg);
        reader.limits(limits.clone());
        Box::new(reader.into_decoder().map_err(told)?)
    } else {
        Box::new(reader.into_decoder().map_err(told)?)
    };
    let (width, height) = decoder.dimensions();
    if width.max(height) > largest {
        return Err(format!("{width} x {height} pixels, more than {largest} on a side"));
    }
    if width == 0 || height == 0 {
        return Err(format!("{width} x {height} pixels, none at all"));
    }
    // The decoder has what the picture itself leaves.
    limits.reserve(decoder.total_bytes()).map_err(told)?;
    decoder.set_limits(limits).map_err(told)?;
    Ok(DynamicImage::from_decoder(decoder).map_err(told)?.into_rgb8())
}
