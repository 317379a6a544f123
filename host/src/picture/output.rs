//! Output files, all of them: checked before the work begins, and either complete or absent after it.
//!
//! An output that is one of the command's own inputs is refused. A file is written without a name, or under a hidden one where the
//! system has no files without names, and gets its name once it is complete.

use std::fs::{self, File, OpenOptions, Permissions};
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};

use super::error::PictureError;
use super::file::FileType;

mod inputs;
mod partial;
mod watched;

pub use inputs::Inputs;
pub use partial::discard;
use partial::{Partial, folder};
pub use watched::Failure;
use watched::through;

/// Names under which standard output is written as the stream that it is.
const STDOUT: [&str; 4] = ["-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];

/// A picture file that was found to be writable, before it is known what it is made of.
#[derive(Debug)]
pub struct PictureOutput {
    output: Output,
    file_type: FileType,
}

impl PictureOutput {
    /// Checks that `path` can be written, without changing a file that is there. `-` is standard output.
    ///
    /// The file type is `file_type`, or else that of the extension. Standard output, pipes and devices without an extension take a
    /// PNG.
    ///
    /// # Errors
    /// [`PictureError::UnknownExtension`], [`PictureError::Terminal`], and those of [`Output::open`].
    pub fn open(path: &Path, file_type: Option<FileType>) -> Result<Self, PictureError> {
        let extension = path.extension().and_then(|extension| extension.to_str());
        let known = file_type.or_else(|| FileType::of_extension(extension?));
        let output = Output::find(path)?;
        let file_type = match output.place {
            Place::Stdout if io::stdout().is_terminal() => {
                return Err(PictureError::Terminal(known.unwrap_or(FileType::Png)));
            }
            Place::Stdout | Place::Special(_) => known.unwrap_or(FileType::Png),
            Place::File { .. } => known.ok_or_else(|| PictureError::UnknownExtension(path.to_owned()))?,
        };
        Ok(Self { output, file_type })
    }

    /// Returns the type of picture file to write.
    #[must_use]
    pub const fn file_type(&self) -> FileType {
        self.file_type
    }

    /// Returns whether it is standard output.
    #[must_use]
    pub const fn is_stdout(&self) -> bool {
        matches!(self.output.place, Place::Stdout)
    }

    /// Returns the output to write to, which is none of `inputs`.
    ///
    /// # Errors
    /// [`PictureError::IsInput`] if it is.
    pub fn beside(self, inputs: &Inputs) -> Result<Output, PictureError> {
        self.output.beside(inputs)
    }
}

/// An output that was found to be writable, and to be no input.
#[derive(Debug)]
pub struct Output {
    path: PathBuf,
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
    /// Checks that `path` can be written and is none of `inputs`, without changing a file that is there. `-` is standard output.
    ///
    /// # Errors
    /// [`PictureError::IsInput`], and [`PictureError::Write`] for a folder, for a file or folder that may not be written, and for a
    /// folder that does not exist.
    pub fn open(path: &Path, inputs: &Inputs) -> Result<Self, PictureError> {
        Self::find(path)?.beside(inputs)
    }

    fn find(path: &Path) -> Result<Self, PictureError> {
        let place = Place::find(path).map_err(|source| PictureError::write(path, source))?;
        Ok(Self { path: path.to_owned(), place })
    }

    fn beside(self, inputs: &Inputs) -> Result<Self, PictureError> {
        let is_input = match &self.place {
            Place::Stdout => inputs.has_stdout(),
            Place::Special(_) => false,
            Place::File { path, .. } => inputs.has(path),
        };
        if is_input { Err(PictureError::IsInput(self.path)) } else { Ok(self) }
    }

    /// Writes `content`. On an error a file that was there is unchanged.
    ///
    /// # Errors
    /// [`PictureError::Write`], and [`PictureError::BrokenPipe`] if the reader of a pipe has gone.
    pub fn write(self, content: &[u8]) -> Result<(), PictureError> {
        self.fill(|out| out.write_all(content).map_err(Failure::<PictureError>::Write))
    }

    /// Lets `fill` write the whole content. A file gets its name when `fill` has succeeded: on an error a file that was there is
    /// unchanged, and there is no new one. Pipes and devices are written directly.
    ///
    /// # Errors
    /// [`PictureError::Write`], [`PictureError::BrokenPipe`] if the reader of a pipe has gone, and those of `fill`.
    pub fn fill<E: From<PictureError>>(
        self,
        fill: impl FnOnce(&mut dyn Write) -> Result<(), Failure<E>>,
    ) -> Result<(), E> {
        let filled = match self.place {
            Place::Stdout => through(io::stdout().lock(), fill).map(drop),
            Place::Special(file) => through(file, fill).map(drop),
            Place::File { path, permissions } => Partial::new(folder(&path), permissions.as_ref())
                .map_err(Failure::Write)
                .and_then(|partial| through(partial, fill))
                .and_then(|partial| partial.replace(&path).map_err(Failure::Write)),
        };
        filled.map_err(|failure| match failure {
            Failure::Write(source) => PictureError::write(&self.path, source).into(),
            Failure::Other(error) => error,
        })
    }
}

impl Place {
    /// Finds out what is at `path`, without changing it.
    fn find(path: &Path) -> io::Result<Self> {
        if STDOUT.iter().any(|name| path == Path::new(name)) {
            return Ok(Self::Stdout);
        }
        let there = fs::metadata(path).ok();
        if there.as_ref().is_some_and(|there| !there.is_file() && !there.is_dir()) {
            return OpenOptions::new().write(true).open(path).map(Self::Special);
        }
        if there.as_ref().is_some_and(fs::Metadata::is_dir) {
            return Err(io::ErrorKind::IsADirectory.into());
        }
        let path = follow(path)?;
        let within = folder(&path);
        fs::metadata(within)?;
        // Opened for appending, a file is not changed; the file beside it shows that its folder takes one.
        if there.is_some() {
            OpenOptions::new().append(true).open(&path)?;
        }
        let permissions = there.map(|there| there.permissions());
        Partial::new(within, permissions.as_ref())?;
        Ok(Self::File { path, permissions })
    }
}

/// Writes a text to `path`, which is none of `inputs`; `-` is standard output. On an error a file that was there is unchanged.
///
/// # Errors
/// Those of [`Output::open`] and [`Output::write`].
pub fn write_text(path: &Path, content: &str, inputs: &Inputs) -> Result<(), PictureError> {
    Output::open(path, inputs)?.write(content.as_bytes())
}

/// Writes a text to standard output at once, unless that is one of `inputs`.
///
/// # Errors
/// Those of [`write_text`].
pub fn print(text: &str, inputs: &Inputs) -> Result<(), PictureError> {
    write_text(Path::new("-"), text, inputs)
}

/// Writes `content` as a new file in the current folder and returns its name: `stem.png`, or with a number if that is taken.
///
/// # Errors
/// [`PictureError::Write`].
pub fn write_new(stem: &str, content: &[u8]) -> Result<PathBuf, PictureError> {
    let mut name = PathBuf::from(format!("{stem}.png"));
    let written = Partial::new(folder(&name), None)
        .and_then(|mut partial| partial.write_all(content).map(|()| partial))
        .and_then(|partial| {
            for number in 2_u32.. {
                match partial.name(&name) {
                    Err(taken) if taken.kind() == io::ErrorKind::AlreadyExists => {
                        name = PathBuf::from(format!("{stem}-{number}.png"));
                    }
                    other => return other,
                }
            }
            Err(io::ErrorKind::AlreadyExists.into())
        });
    written.map_err(|source| PictureError::write(&name, source))?;
    Ok(name)
}

/// Makes a folder for output files, and those it lies in, where there is none yet.
///
/// # Errors
/// [`PictureError::Write`].
pub fn make_folder(path: &Path) -> Result<(), PictureError> {
    let made = match fs::metadata(path) {
        Ok(there) if !there.is_dir() => Err(io::ErrorKind::NotADirectory.into()),
        _ => fs::create_dir_all(path),
    };
    made.map_err(|source| PictureError::write(path, source))
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

    use super::{Inputs, PictureOutput};
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
        let output = PictureOutput::open(&path, None).expect("writable");
        assert_eq!(output.file_type(), FileType::Ppm);
        assert!(names(folder.path()).is_empty());
        output.beside(Inputs::NONE).expect("no input").write(b"old").expect("written");
        PictureOutput::open(&path, Some(FileType::Pfm))
            .expect("writable")
            .beside(Inputs::NONE)
            .expect("no input")
            .write(b"new")
            .expect("written");
        assert_eq!(fs::read(&path).expect("the file"), b"new");
        assert_eq!(names(folder.path()), ["picture.PPM"]);
    }

    #[test]
    fn what_cannot_be_written_is_refused() {
        let folder = tempfile::tempdir().expect("a folder");
        for name in ["missing/a.png", ""] {
            let opened = PictureOutput::open(&folder.path().join(name), None);
            assert!(matches!(opened, Err(PictureError::Write { .. })), "{name}: {opened:?}");
        }
        for name in ["picture.jpg", "picture", ".png", "png"] {
            let opened = PictureOutput::open(&folder.path().join(name), None);
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
        PictureOutput::open(&link, None)
            .expect("writable")
            .beside(Inputs::NONE)
            .expect("no input")
            .write(b"first")
            .expect("written");
        fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).expect("permissions");
        PictureOutput::open(&link, None)
            .expect("writable")
            .beside(Inputs::NONE)
            .expect("no input")
            .write(b"second")
            .expect("written");
        assert!(link.is_symlink());
        assert_eq!(fs::read(&file).expect("the file"), b"second");
        assert_eq!(fs::metadata(&file).expect("the file").permissions().mode() & 0o777, 0o640);
    }
}
