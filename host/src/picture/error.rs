//! What can go wrong with a picture between the tracer and its file or its emulated device.

use core::ops::Range;
use std::io;
use std::path::{Path, PathBuf};

use super::device::Device;
use super::file::FileType;
use super::raster::Size;

/// Why a picture cannot be shown or written. It prints as one line that names the file or the device it is about.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PictureError {
    /// The picture has more pixels than the device.
    #[error("{size} does not fit {device}, which has {}; rta render --device none draws any size", device.size())]
    LargerThanDevice {
        /// The picture.
        size: Size,
        /// The device.
        device: Device,
    },
    /// The name of the output does not tell what kind of file to write.
    #[error("{}: no known picture format; use a name in {}, or --as", .0.display(), FileType::extensions())]
    UnknownExtension(PathBuf),
    /// A picture file cannot be read.
    #[error("cannot read the picture {}: {}", .path.display(), reason(source))]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system says, or what is wrong with the file.
        source: io::Error,
    },
    /// A file of linear light was asked for something that has none.
    #[error("{0} holds linear light before any display; this is what displays show")]
    NotLinear(FileType),
    /// Linear light was asked of a display.
    #[error("{file_type} holds linear light before any display: it needs --device none, not {device}")]
    LinearFromDevice {
        /// The kind of picture file.
        file_type: FileType,
        /// The device.
        device: Device,
    },
    /// A file with a colour table was asked for a picture without one.
    #[error("a {0} has a colour table, which --device none has not")]
    NeedsTable(FileType),
    /// A film was asked of a kind of file that holds one picture.
    #[error("a {0} holds one picture: a film needs a .gif, .png or .ppm")]
    OnePicture(FileType),
    /// Parts hold light of another kind than the file.
    #[error(
        "the parts do not hold the light of a {0}: linear light is what rta render --rows --as pfm traces, levels what it traces else"
    )]
    OtherLight(FileType),
    /// There are no such rows of the picture, or frames of the film.
    #[error("there are no {what} {}..{}: they are 0..{all}", some.start, some.end)]
    NoSuchPart {
        /// Rows, or frames.
        what: &'static str,
        /// Which.
        some: Range<u32>,
        /// How many there are.
        all: u32,
    },
    /// The output cannot be written.
    #[error("cannot write {}: {}", name(path), reason(source))]
    Write {
        /// The output.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// The output is a file that its content is made from.
    #[error("cannot write {}: the output is the input itself", name(.0))]
    IsInput(PathBuf),
    /// A picture was to be written to a terminal.
    #[error("standard output is a terminal: send the {0} to a file or a pipe")]
    Terminal(FileType),
    /// The driver or the emulated device refuses what the program does with it.
    #[error("the display: {0}")]
    Display(Box<dyn core::error::Error + Send + Sync>),
    /// Not enough memory for the picture.
    #[error("not enough memory for a picture of {0}")]
    Memory(Size),
    /// The frames of a film take more memory than the window keeps of them.
    #[error(
        "{frames} frames of {size} take {} MiB, and the window keeps at most {}: fewer --frames or a smaller --size, or a file by rta render",
        bytes.div_ceil(1 << 20),
        most >> 20
    )]
    Film {
        /// How many.
        frames: u32,
        /// Of each.
        size: Size,
        /// Of all.
        bytes: u64,
        /// The limit that they exceed.
        most: u64,
    },
    /// The reader of a pipe has closed it. The program ends without a word and without an error status.
    #[error("standard output is closed")]
    BrokenPipe,
}

impl PictureError {
    /// An error of a driver.
    pub(crate) fn display(source: impl core::error::Error + Send + Sync + 'static) -> Self {
        Self::Display(Box::new(source))
    }

    /// An error about writing `path`; it is [`PictureError::BrokenPipe`] where the reader of a pipe has closed it.
    #[must_use]
    pub fn write(path: &Path, source: io::Error) -> Self {
        match source.kind() {
            io::ErrorKind::BrokenPipe => Self::BrokenPipe,
            _ => Self::Write { path: path.to_owned(), source },
        }
    }
}

/// The name of an output in a message.
pub(crate) fn name(path: &Path) -> String {
    if path == Path::new("-") { "standard output".to_owned() } else { path.display().to_string() }
}

/// The system's description of an error, without its number.
pub(crate) fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    match text.find(" (os error") {
        Some(end) => text.chars().take(end).collect(),
        None => text,
    }
}
