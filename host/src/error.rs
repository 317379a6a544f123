//! Everything that ends a command with an error: the errors of the rooms, gathered.
//!
//! Each room has an error type of its own. Only [`commands`](crate::commands) and `main` use this one.

use rta_scenes::bake::BakeError;

use crate::engine::bands::BandsError;
use crate::engine::radiosity::RadiosityError;
use crate::picture::error::PictureError;
use crate::picture::part::MergeError;
use crate::picture::raster::Size;
use crate::request::error::RequestError;
use crate::study::error::StudyError;

/// Why a command fails. It prints as one line that names what it is about.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The scene cannot be read, or not be traced as asked.
    #[error(transparent)]
    Request(#[from] RequestError),
    /// The picture cannot be displayed or written.
    #[error(transparent)]
    Picture(#[from] PictureError),
    /// The threads do not start, or the work was interrupted.
    #[error(transparent)]
    Bands(#[from] BandsError),
    /// A study is not completed.
    #[error(transparent)]
    Study(#[from] StudyError),
    /// The scene cannot be turned into Rust source.
    #[error(transparent)]
    Bake(#[from] BakeError),
    /// A scene's radiosity is not found.
    #[error("{scene}: {source}")]
    Radiosity {
        /// The name of the scene's file.
        scene: String,
        /// Why.
        source: RadiosityError,
    },
    /// Parts make no picture.
    #[error(transparent)]
    Merge(#[from] MergeError),
    /// A frame of a film cannot be drawn.
    #[error("frame {number}, the instant {instant}: {source}")]
    Frame {
        /// Its number, from 0.
        number: u32,
        /// Its instant.
        instant: f64,
        /// Why.
        source: Box<Self>,
    },
    /// A picture of the gallery cannot be drawn.
    #[error("{command}: {source}")]
    Gallery {
        /// The command that draws it.
        command: &'static str,
        /// Why.
        source: Box<Self>,
    },
    /// What the gallery has as a command draws no pictures.
    #[error("it draws no pictures")]
    NoPictures,
    /// Pictures of the gallery are not those in the repository.
    #[error("pictures differ")]
    PicturesDiffer,
    /// The picture has no such pixel.
    #[error("pixel {x},{y} is outside the picture, which has columns 0 to {} and rows 0 to {}", size.width() - 1, size.height() - 1)]
    PixelOutside {
        /// Column.
        x: u32,
        /// Row.
        y: u32,
        /// The picture.
        size: Size,
    },
}

impl Error {
    /// Whether an interrupt or a request to terminate ended the work.
    #[must_use]
    pub fn is_interruption(&self) -> bool {
        match self {
            Self::Bands(BandsError::Interrupted)
            | Self::Study(StudyError::Bands(BandsError::Interrupted)) => true,
            Self::Frame { source, .. } | Self::Gallery { source, .. } => source.is_interruption(),
            _ => false,
        }
    }

    /// Whether a comparison is completed and found a difference, which it has printed.
    #[must_use]
    pub const fn is_difference(&self) -> bool {
        matches!(self, Self::Study(StudyError::Off) | Self::PicturesDiffer)
    }

    /// Whether the reader of standard output has closed it, which is no error of the program's.
    #[must_use]
    pub const fn is_broken_pipe(&self) -> bool {
        matches!(
            self,
            Self::Picture(PictureError::BrokenPipe)
                | Self::Study(StudyError::Picture(PictureError::BrokenPipe))
        )
    }
}
