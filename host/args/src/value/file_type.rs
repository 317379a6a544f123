//! The kinds of picture file.

use core::fmt;

use clap::ValueEnum;

/// The kinds of picture file that are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum FileType {
    /// Portable Network Graphics: with the device's colour table if there is a device.
    Png,
    /// Portable pixmap, binary (P6): the same colours without a table.
    #[value(alias = "pnm")]
    Ppm,
    /// Portable float map (PF), little endian: linear light, needs `--device none`.
    Pfm,
    /// Windows bitmap: with the device's colour table if there is a device.
    #[cfg(feature = "image")]
    Bmp,
    /// Graphics Interchange Format: with the device's colour table, also for films.
    #[cfg(feature = "image")]
    Gif,
    /// Truevision TGA with 24 bits a pixel.
    #[cfg(feature = "image")]
    Tga,
    /// Quite OK Image with 24 bits a pixel.
    #[cfg(feature = "image")]
    Qoi,
    /// Radiance HDR (RGBE): linear light, needs `--device none`.
    #[cfg(feature = "image")]
    Hdr,
}

impl FileType {
    /// Returns whether the file holds linear light before any display, which no device has.
    #[must_use]
    pub const fn is_linear(self) -> bool {
        match self {
            Self::Pfm => true,
            #[cfg(feature = "image")]
            Self::Hdr => true,
            _ => false,
        }
    }

    /// Returns whether the file holds a whole film, in which one frame follows another.
    #[must_use]
    pub const fn holds_films(self) -> bool {
        match self {
            Self::Png | Self::Ppm => true,
            #[cfg(feature = "image")]
            Self::Gif => true,
            _ => false,
        }
    }

    /// Returns whether the file cannot do without a colour table.
    #[must_use]
    pub const fn needs_table(self) -> bool {
        match self {
            #[cfg(feature = "image")]
            Self::Gif => true,
            _ => false,
        }
    }

    /// Returns the extensions of all types, as part of an error message.
    #[must_use]
    pub fn extensions() -> String {
        let all = Self::value_variants().iter().map(|file_type| format!(".{file_type}").to_lowercase());
        all.collect::<Vec<_>>().join(", ")
    }

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
            #[cfg(feature = "image")]
            Self::Bmp => "BMP",
            #[cfg(feature = "image")]
            Self::Gif => "GIF",
            #[cfg(feature = "image")]
            Self::Tga => "TGA",
            #[cfg(feature = "image")]
            Self::Qoi => "QOI",
            #[cfg(feature = "image")]
            Self::Hdr => "HDR",
        })
    }
}
