//! Output files: checked before the work begins, and either complete or absent after it.

use std::fs::{self, File, OpenOptions, Permissions};
use std::io::{self, BufWriter, IsTerminal, Write};
use std::path::{Path, PathBuf};

use super::error::PictureError;
use super::file::FileType;

/// An output that was found to be writable.
#[derive(Debug)]
pub struct Output {
    path: PathBuf,
    file_type: FileType,
    place: Place,
}

#[derive(Debug)]
enum Place {
    /// Standard output.
    Stdout,
    /// A pipe or a device: written as it is, never replaced.
    Special(File),
    /// A file in a folder: what was there is replaced at the end, and keeps its permissions.
    File { path: PathBuf, permissions: Option<Permissions> },
}

impl Output {
    /// Checks that `path` can be written, without changing a file that is there. `-` is standard output.
    ///
    /// The file type is `file_type`, or else that of the extension. Standard output, pipes and devices without an extension take a
    /// PNG.
    ///
    /// # Errors
    /// [`PictureError::UnknownExtension`], [`PictureError::Terminal`], and [`PictureError::Write`] for a folder, for a file or folder
    /// that may not be written, and for a folder that does not exist.
    pub fn open(path: &Path, file_type: Option<FileType>) -> Result<Self, PictureError> {
        let extension = path.extension().and_then(|extension| extension.to_str());
        let known = file_type.or_else(|| FileType::of_extension(extension?));
        let place = Place::find(path)?;
        let file_type = match place {
            Place::Stdout if io::stdout().is_terminal() => {
                return Err(PictureError::Terminal(known.unwrap_or(FileType::Png)));
            }
            Place::Stdout | Place::Special(_) => known.unwrap_or(FileType::Png),
            Place::File { .. } => known.ok_or_else(|| PictureError::UnknownExtension(path.to_owned()))?,
        };
        Ok(Self { path: path.to_owned(), file_type, place })
    }

    /// Returns the type of picture file to write.
    #[must_use]
    pub const fn file_type(&self) -> FileType {
        self.file_type
    }

    /// Writes `content`. On an error a file that was there is unchanged.
    ///
    /// # Errors
    /// [`PictureError::Write`], and [`PictureError::BrokenPipe`] if the reader of a pipe has gone.
    pub fn write(self, content: &[u8]) -> Result<(), PictureError> {
        self.fill(|out| out.write_all(content).map_err(Failure::<PictureError>::Write))
    }

    /// Lets `fill` write a temporary file in the same folder, and renames it to its place at the end. On an error a file that was
    /// there is unchanged. Pipes and devices are written directly.
    ///
    /// # Errors
    /// [`PictureError::Write`], [`PictureError::BrokenPipe`] if the reader of a pipe has gone, and those of `fill`.
    pub fn fill<E: From<PictureError>>(
        self,
        fill: impl FnOnce(&mut dyn Write) -> Result<(), Failure<E>>,
    ) -> Result<(), E> {
        self.place.fill(fill).map_err(|failure| match failure {
            Failure::Write(source) => PictureError::write(&self.path, source).into(),
            Failure::Other(error) => error,
        })
    }
}

impl Place {
    /// Finds out what is at `path`, without changing it.
    fn find(path: &Path) -> Result<Self, PictureError> {
        let failed = |source| PictureError::write(path, source);
        if path == Path::new("-") || path == Path::new("/dev/stdout") {
            return Ok(Self::Stdout);
        }
        let there = fs::metadata(path).ok();
        if there.as_ref().is_some_and(|there| !there.is_file() && !there.is_dir()) {
            return OpenOptions::new().write(true).open(path).map(Self::Special).map_err(failed);
        }
        if there.as_ref().is_some_and(fs::Metadata::is_dir) {
            return Err(failed(io::ErrorKind::IsADirectory.into()));
        }
        let path = follow(path).map_err(failed)?;
        // Opened for appending, a file is not changed; the file beside it shows that its folder takes one.
        if there.is_some() {
            OpenOptions::new().append(true).open(&path).map_err(failed)?;
        }
        let permissions = there.map(|there| there.permissions());
        beside(&path, permissions.as_ref()).map_err(failed)?;
        Ok(Self::File { path, permissions })
    }

    fn fill<E>(self, fill: impl FnOnce(&mut dyn Write) -> Result<(), Failure<E>>) -> Result<(), Failure<E>> {
        match self {
            Self::Stdout => {
                let mut out = BufWriter::new(io::stdout().lock());
                fill(&mut out)?;
                out.flush()?;
            }
            Self::Special(file) => {
                let mut out = BufWriter::new(file);
                fill(&mut out)?;
                out.flush()?;
            }
            Self::File { path, permissions } => {
                let mut out = BufWriter::new(beside(&path, permissions.as_ref())?);
                fill(&mut out)?;
                let file = out.into_inner().map_err(io::IntoInnerError::into_error)?;
                file.persist(&path).map_err(io::Error::from)?;
            }
        }
        Ok(())
    }
}

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

/// Writes a text to `path`, where `-` is standard output. On an error a file that was there is unchanged.
///
/// # Errors
/// [`PictureError::Write`], and [`PictureError::BrokenPipe`] if the reader of a pipe has gone.
pub fn write_text(path: &Path, content: &str) -> Result<(), PictureError> {
    Output { path: path.to_owned(), file_type: FileType::Png, place: Place::find(path)? }
        .write(content.as_bytes())
}

/// Writes a text to standard output at once.
///
/// # Errors
/// [`PictureError::Write`], and [`PictureError::BrokenPipe`] if the reader of a pipe has closed it.
pub fn print(text: &str) -> Result<(), PictureError> {
    let mut out = io::stdout().lock();
    let written = out.write_all(text.as_bytes()).and_then(|()| out.flush());
    written.map_err(|source| PictureError::write(Path::new("standard output"), source))
}

/// Writes `content` as a new file in the current folder and returns its name: `stem.png`, or with a number if that is taken.
///
/// # Errors
/// [`PictureError::Write`].
pub fn write_new(stem: &str, content: &[u8]) -> Result<PathBuf, PictureError> {
    let mut name = PathBuf::from(format!("{stem}.png"));
    let failed = |path: &Path, source| PictureError::write(path, source);
    let mut file = beside(&name, None).map_err(|source| failed(&name, source))?;
    file.write_all(content).map_err(|source| failed(&name, source))?;
    let mut number = 2_u32;
    loop {
        match file.persist_noclobber(&name) {
            Ok(_) => return Ok(name),
            Err(taken) if taken.error.kind() == io::ErrorKind::AlreadyExists => file = taken.file,
            Err(other) => return Err(failed(&name, other.error)),
        }
        name = PathBuf::from(format!("{stem}-{number}.png"));
        number += 1;
    }
}

/// Creates a temporary file in the folder of `path`, deleted when dropped. It gets the permissions given, or those of any new
/// file.
fn beside(path: &Path, permissions: Option<&Permissions>) -> io::Result<tempfile::NamedTempFile> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    fs::metadata(folder)?;
    let mut builder = tempfile::Builder::new();
    builder.prefix(".rta-").suffix(".part");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(Permissions::from_mode(0o666));
    }
    let file = builder.tempfile_in(folder).map_err(|error| io::Error::from(error.kind()))?;
    if let Some(permissions) = permissions {
        fs::set_permissions(file.path(), permissions.clone())?;
    }
    Ok(file)
}

/// Follows symbolic links to their end, so that the file behind them is replaced and not the link.
fn follow(path: &Path) -> io::Result<PathBuf> {
    /// The number of links that Linux follows, too.
    const LINKS: usize = 40;
    let mut path = path.to_owned();
    for _ in 0..LINKS {
        match fs::read_link(&path) {
            Ok(target) => path = path.parent().unwrap_or(Path::new("")).join(target),
            Err(_) => return Ok(path),
        }
    }
    Err(io::Error::other("too many symbolic links"))
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::Output;
    use crate::picture::error::PictureError;
    use crate::picture::file::FileType;

    fn names(folder: &std::path::Path) -> Vec<String> {
        let entries = fs::read_dir(folder).expect("a folder");
        entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect()
    }

    #[test]
    fn opening_leaves_nothing_and_writing_leaves_the_file_alone() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("picture.PPM");
        let output = Output::open(&path, None).expect("writable");
        assert_eq!(output.file_type(), FileType::Ppm);
        assert!(names(folder.path()).is_empty());
        output.write(b"old").expect("written");
        Output::open(&path, Some(FileType::Pfm)).expect("writable").write(b"new").expect("written");
        assert_eq!(fs::read(&path).expect("the file"), b"new");
        assert_eq!(names(folder.path()), ["picture.PPM"]);
    }

    #[test]
    fn what_cannot_be_written_is_refused() {
        let folder = tempfile::tempdir().expect("a folder");
        for name in ["missing/a.png", ""] {
            let opened = Output::open(&folder.path().join(name), None);
            assert!(matches!(opened, Err(PictureError::Write { .. })), "{name}: {opened:?}");
        }
        for name in ["picture.jpg", "picture", ".png", "png"] {
            let opened = Output::open(&folder.path().join(name), None);
            assert!(matches!(opened, Err(PictureError::UnknownExtension(_))), "{name}: {opened:?}");
        }
        assert!(names(folder.path()).is_empty());
    }

    #[cfg(unix)]
    #[test]
    fn a_link_stays_a_link_and_permissions_stay() {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let folder = tempfile::tempdir().expect("a folder");
        let (link, file) = (folder.path().join("link.png"), folder.path().join("file.png"));
        symlink("file.png", &link).expect("a link");
        Output::open(&link, None).expect("writable").write(b"first").expect("written");
        fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).expect("permissions");
        Output::open(&link, None).expect("writable").write(b"second").expect("written");
        assert!(link.is_symlink());
        assert_eq!(fs::read(&file).expect("the file"), b"second");
        assert_eq!(fs::metadata(&file).expect("the file").permissions().mode() & 0o777, 0o640);
    }
}
