//! Picture files: textures of objects, and the sky.

use core::fmt;
use std::collections::btree_map::Entry;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::description::{Description, Pattern, Pixels};

/// Sides of the largest picture that is decoded, in pixels.
pub const LARGEST_SIDE: u32 = 8192;

/// Memory that decoding a picture may take, in bytes.
#[cfg(feature = "images")]
const MEMORY: u64 = 512 << 20;

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
    fn named_pictures(&self) -> impl Iterator<Item = (&str, u32)> {
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
        let named: Vec<_> = self.named_pictures().map(|(file, line)| (file.to_owned(), line)).collect();
        let mut files = Vec::new();
        for (file, line) in named {
            let path = folder.join(&file);
            if let Entry::Vacant(entry) = self.details.pictures.entry(file) {
                let failed = |reason| PictureError { path: path.clone(), line, reason };
                entry.insert(Arc::new(decode(&path).map_err(failed)?.reduced(most)));
            }
            files.push(path);
        }
        if let Some(sky) = self.details.sky_map.as_ref().and_then(|file| self.details.pictures.get(file)) {
            // For what asks the sky without a direction, such as haze.
            (self.sky.horizon, self.sky.zenith) = (sky.mean(sky.height / 2), sky.mean(0));
        }
        Ok(files)
    }
}

#[cfg(not(feature = "images"))]
fn decode(_: &Path) -> Result<Pixels, String> {
    Err("this program was built without the reader of pictures (feature `images`)".into())
}

#[cfg(feature = "images")]
fn decode(path: &Path) -> Result<Pixels, String> {
    let told = |error: image::ImageError| error.to_string();
    let open = || {
        let file = image::ImageReader::open(path).map_err(|error| error.to_string())?;
        file.with_guessed_format().map_err(|error| error.to_string())
    };
    let (width, height) = open()?.into_dimensions().map_err(told)?;
    if width.max(height) > LARGEST_SIDE {
        return Err(format!("{width} x {height} pixels, more than {LARGEST_SIDE} on a side"));
    }
    if width == 0 || height == 0 {
        return Err(format!("{width} x {height} pixels, none at all"));
    }
    let mut reader = open()?;
    let mut limits = image::Limits::default();
    limits.max_alloc = Some(MEMORY);
    reader.limits(limits);
    let pixels = reader.decode().map_err(told)?.into_rgb8();
    let words = pixels.pixels().map(|pixel| {
        let [r, g, b] = pixel.0;
        u32::from_be_bytes([0, r, g, b])
    });
    Ok(Pixels { width, height, words: words.collect() })
}
