//! What can go wrong between the command line and the picture.

use std::io;
use std::path::{Path, PathBuf};

use crate::commands::check::Refusal;
use crate::engine::{EngineError, Format};
use crate::picture::device::Device;
use crate::picture::file::FileType;
use crate::picture::raster::Size;
use crate::request::fit::Hint;

/// Everything that ends the program with an error. It prints as one line that names the file it is about.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The scene file cannot be opened or read.
    #[error("cannot read the scene {name}: {}", reason(source))]
    Read {
        /// The file, or `standard input`.
        name: String,
        /// What the system says.
        source: io::Error,
    },
    /// The scene file is not a scene.
    #[error(transparent)]
    Scene(#[from] rta_scenes::error::SceneError),
    /// The scene cannot be traced as asked.
    #[error("{name}: {source}{fit}")]
    Engine {
        /// Name of the scene.
        name: String,
        /// Why not.
        source: EngineError,
        /// Whether it could be scaled.
        fit: Hint,
    },
    /// The number format does not admit the scene.
    #[error("{name} does not fit {format}: {reason}{}{fit}", takers(others))]
    Refused {
        /// Name of the scene.
        name: String,
        /// The format.
        format: Format,
        /// Why not.
        reason: Box<Refusal>,
        /// The formats that do admit it.
        others: Vec<Format>,
        /// Whether it could be scaled.
        fit: Hint,
    },
    /// The scene file asks for a picture that cannot be.
    #[error("{name} is made for {width}x{height} pixels: {reason}; --size sets others")]
    SceneSize {
        /// Name of the scene.
        name: String,
        /// Pixels in a row.
        width: u32,
        /// Rows.
        height: u32,
        /// The limits.
        reason: crate::picture::raster::RasterError,
    },
    /// The picture has more pixels than the device.
    #[error("{size} does not fit {device}, which has {}", device.size())]
    LargerThanDevice {
        /// The picture.
        size: Size,
        /// The device.
        device: Device,
    },
    /// The pixels of the device and the size of the picture make a screen too narrow or too wide.
    #[error("a picture of {size} is too narrow or too wide: {reason}")]
    Shape {
        /// The picture.
        size: Size,
        /// The limits.
        reason: crate::picture::raster::RasterError,
    },
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
    /// The name of the output does not tell what kind of file to write.
    #[error("{}: no known picture format; use a name in .png, .ppm or .pfm, or --as", .0.display())]
    UnknownExtension(PathBuf),
    /// Linear light was asked of a display.
    #[error("a PFM holds linear light before any display: it needs --device none, not {0}")]
    LinearFromDevice(Device),
    /// The output cannot be written.
    #[error("cannot write {}: {}", path.display(), reason(source))]
    Write {
        /// The output.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// A picture was to be written to a terminal.
    #[error("standard output is a terminal: send the {0} to a file or a pipe")]
    Terminal(FileType),
    /// The emulated device refuses what the program does with it.
    #[error("the display: {0}")]
    Display(Box<dyn core::error::Error + Send + Sync>),
    /// The program has no scene of its own by this name.
    #[error("there is no scene {0} in the program")]
    NoScene(String),
    /// What a bench needs besides the program is not there, or says no.
    #[error("{0}")]
    Bench(Box<dyn core::error::Error + Send + Sync>),
    /// The report cannot be put together.
    #[error("the report: {0}")]
    Report(Box<dyn core::error::Error + Send + Sync>),
    /// Not enough memory for the picture.
    #[error("not enough memory for a picture of {0}")]
    Memory(Size),
    /// The threads could not be started.
    #[error("cannot start the threads: {0}")]
    Threads(#[from] rayon::ThreadPoolBuildError),
    /// An interrupt or a request to terminate arrived.
    #[error("interrupted")]
    Interrupted,
    /// The other end of standard output went away. Nobody is told.
    #[error("standard output is closed")]
    BrokenPipe,
}

impl Error {
    /// An error of a driver.
    pub(crate) fn display(source: impl core::error::Error + Send + Sync + 'static) -> Self {
        Self::Display(Box::new(source))
    }

    /// An error of a part of a bench.
    pub(crate) fn bench(source: impl core::error::Error + Send + Sync + 'static) -> Self {
        Self::Bench(Box::new(source))
    }

    /// An error of a part of a report.
    pub(crate) fn report(source: impl core::error::Error + Send + Sync + 'static) -> Self {
        Self::Report(Box::new(source))
    }

    /// An error about writing `path`, except that a pipe nobody reads any more is [`Error::BrokenPipe`].
    #[must_use]
    pub fn write(path: &Path, source: io::Error) -> Self {
        match source.kind() {
            io::ErrorKind::BrokenPipe => Self::BrokenPipe,
            _ => Self::Write { path: path.to_owned(), source },
        }
    }
}

/// The formats that take what another did not.
fn takers(formats: &[Format]) -> String {
    if formats.is_empty() {
        return String::new();
    }
    let names: Vec<_> = formats.iter().map(Format::to_string).collect();
    format!("; it fits {}", names.join(", "))
}

/// The system's words without its number.
fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    match text.find(" (os error") {
        Some(end) => text.chars().take(end).collect(),
        None => text,
    }
}
