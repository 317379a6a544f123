//! The errors that end a study early.

use crate::engine::bands::BandsError;
use crate::picture::error::PictureError;
use crate::request::error::RequestError;

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
    /// The program has no scene of its own by this name.
    #[error("there is no scene {0} in the program")]
    NoScene(String),
    /// Valgrind, the other ray tracer or the file of recorded instructions fails.
    #[error("{0}")]
    Bench(Box<dyn core::error::Error + Send + Sync>),
    /// The report's tables or diagrams cannot be made.
    #[error("the report: {0}")]
    Report(Box<dyn core::error::Error + Send + Sync>),
}

impl StudyError {
    /// The work was interrupted.
    pub(crate) const INTERRUPTED: Self = Self::Bands(BandsError::Interrupted);

    /// An error of a part of a benchmark.
    pub(crate) fn bench(source: impl core::error::Error + Send + Sync + 'static) -> Self {
        Self::Bench(Box::new(source))
    }

    /// An error of a part of a report.
    pub(crate) fn report(source: impl core::error::Error + Send + Sync + 'static) -> Self {
        Self::Report(Box::new(source))
    }
}
