//! The errors that end a study early.

use std::io;

use crate::engine::bands::BandsError;
use crate::engine::radiosity::RadiosityError;
use crate::picture::error::{PictureError, reason};
use crate::picture::raster::Size;
use crate::request::error::RequestError;
use crate::study::measure::MeasureError;

/// Why a study is not completed. It prints as one line.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StudyError {
    /// A scene cannot be read or traced.
    #[error(transparent)]
    Request(#[from] RequestError),
    /// A picture cannot be displayed, or a result cannot be written.
    #[error(transparent)]
    Picture(#[from] PictureError),
    /// The threads do not start, or the work was interrupted.
    #[error(transparent)]
    Bands(#[from] BandsError),
    /// Pictures cannot be measured.
    #[error(transparent)]
    Measure(#[from] MeasureError),
    /// Two pictures have different numbers of pixels.
    #[error("{} is {}, and {} is {}: only pictures of one size can be compared", reference.0, reference.1, test.0, test.1)]
    Sizes {
        /// The reference's file and size.
        reference: (String, Size),
        /// The other's.
        test: (String, Size),
    },
    /// The combinations of tables and ditherings cannot be counted or drawn side by side.
    #[error("the palette: {0}")]
    Palette(Box<dyn core::error::Error + Send + Sync>),
    /// Pictures cannot be put on one sheet.
    #[error("the contact sheet: {0}")]
    Sheet(Box<dyn core::error::Error + Send + Sync>),
    /// A colour table or a dithering was asked for where all are shown.
    #[error(
        "rta palette shows every colour table with every dithering: --table and --dither choose for rta show and rta render"
    )]
    EveryTable,
    /// The contact sheet was to go where the table goes.
    #[error("the table goes to standard output: --sheet needs the name of a file")]
    SheetToStdout,
    /// Pictures of ray trees were to be compared with Mitsuba.
    #[error("rta bench compares paths alone with mitsuba: --light --peer mitsuba")]
    PathsAlone,
    /// The program has no scene of its own by this name.
    #[error("there is no scene {0} in the program")]
    NoScene(String),
    /// Neither lamps nor a lens spread the rays of a scene.
    #[error("{0} has neither a lamp with a size nor a lens: nothing is spread")]
    Still(String),
    /// Valgrind, the other ray tracer or the file of recorded instructions fails.
    #[error("{0}")]
    Bench(Box<dyn core::error::Error + Send + Sync>),
    /// A text with stated values cannot be read.
    #[error("cannot read the values in {name}: {}", reason(source))]
    Text {
        /// The file, or `standard input`.
        name: String,
        /// What the system says.
        source: io::Error,
    },
    /// A value is stated of a function that is not known.
    #[error("line {line}: there is no function {name}; there are {names}")]
    Function {
        /// Line of the text.
        line: usize,
        /// The name.
        name: String,
        /// Those that are known.
        names: String,
    },
    /// A value is stated with too few or too many arguments.
    #[error("line {line}: {name} has the arguments ({arguments}), found {found} numbers")]
    Arguments {
        /// Line of the text.
        line: usize,
        /// The function.
        name: String,
        /// Its arguments.
        arguments: String,
        /// How many there are in the text.
        found: usize,
    },
    /// A stated value is off.
    #[error("a value is off")]
    Off,
    /// The rays of a picture have no common denominator below 2^31.
    #[error(
        "the rays of a picture of {0} with this shape of screen and focal distance are no integers below 2^31"
    )]
    Raster(Size),
    /// A picture was to go where the tables go.
    #[error("the tables go to standard output: -o needs the name of a file")]
    PictureToStdout,
    /// A scene's faces cannot be brought before the eye.
    #[error("the visible faces: {0}")]
    Visibility(Box<dyn core::error::Error + Send + Sync>),
    /// Algorithms of visibility disagree.
    #[error("the ids differ")]
    IdsDiffer,
    /// A scene's radiosity is not found.
    #[error("{scene}: {source}")]
    Radiosity {
        /// The name of the scene's file.
        scene: String,
        /// Why.
        source: RadiosityError,
    },
    /// The report's tables or diagrams cannot be made.
    #[error("the report: {0}")]
    Report(Box<dyn core::error::Error + Send + Sync>),
    /// A figure cannot be drawn.
    #[error("the figure {name}: {source}")]
    Figure {
        /// The figure.
        name: &'static str,
        /// The reason.
        source: Box<dyn core::error::Error + Send + Sync>,
    },
}

impl StudyError {
    /// The work was interrupted.
    pub(crate) const INTERRUPTED: Self = Self::Bands(BandsError::Interrupted);

    /// An error of a part of a benchmark.
    pub(crate) fn bench(source: impl core::error::Error + Send + Sync + 'static) -> Self {
        Self::Bench(Box::new(source))
    }

    /// An error of a part of the study of palettes.
    pub(crate) fn palette(source: impl core::error::Error + Send + Sync + 'static) -> Self {
        Self::Palette(Box::new(source))
    }

    /// An error of a part of a report.
    pub(crate) fn report(source: impl core::error::Error + Send + Sync + 'static) -> Self {
        Self::Report(Box::new(source))
    }
}
