//! Writing through a buffer, with the first error as the system tells it.

use std::io::{self, BufWriter, Write};

/// Why an output is not written.
#[derive(Debug)]
pub enum Failure<E> {
    /// The system refuses to write.
    Write(io::Error),
    /// The content cannot be produced.
    Other(E),
}

impl<E> From<io::Error> for Failure<E> {
    fn from(source: io::Error) -> Self {
        Self::Write(source)
    }
}

/// A writer that keeps its first error, since encoders hand on only what an error says.
struct Watched<W> {
    to: W,
    failed: Option<io::Error>,
}

impl<W> Watched<W> {
    fn keep<T>(&mut self, done: io::Result<T>) -> io::Result<T> {
        done.map_err(|error| {
            let kind = error.kind();
            if kind != io::ErrorKind::Interrupted {
                self.failed.get_or_insert(error);
            }
            kind.into()
        })
    }
}

impl<W: Write> Write for Watched<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let done = self.to.write(bytes);
        self.keep(done)
    }

    fn flush(&mut self) -> io::Result<()> {
        let done = self.to.flush();
        self.keep(done)
    }
}

/// Lets `fill` write to `to` through a buffer, and returns `to` once it has taken everything.
pub(super) fn through<W: Write, E>(
    to: W,
    fill: impl FnOnce(&mut dyn Write) -> Result<(), Failure<E>>,
) -> Result<W, Failure<E>> {
    let mut out = BufWriter::new(Watched { to, failed: None });
    let filled = fill(&mut out).and_then(|()| Ok(out.flush()?));
    let (Watched { to, failed }, _) = out.into_parts();
    match (filled, failed) {
        (Err(Failure::Other(error)), _) => Err(Failure::Other(error)),
        (_, Some(source)) => Err(Failure::Write(source)),
        (filled, None) => filled.map(|()| to),
    }
}
