//! A file that is being written and must not be seen before it is complete.

use std::fs::{self, File, Permissions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use tempfile::{Builder, NamedTempFile};

/// A file without a name, which the system deletes whatever ends the program, or one with a hidden name where the system or the
/// file system knows no others. It is gone when dropped.
#[derive(Debug)]
pub(super) enum Partial {
    #[cfg(target_os = "linux")]
    Unnamed(File),
    Hidden(Hidden),
}

/// A hidden file that is deleted when dropped, and by [`discard`].
#[derive(Debug)]
pub(super) struct Hidden(NamedTempFile);

/// Paths of the hidden files that there are now.
static HIDDEN: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Deletes all files that are not complete. It is for the end of the program in the middle of its work: nothing may be written
/// afterwards.
pub fn discard() {
    for path in HIDDEN.lock().unwrap_or_else(PoisonError::into_inner).drain(..) {
        // Nobody is left to be told.
        let _ = fs::remove_file(path);
    }
}

impl Partial {
    /// Creates a file in `folder` with the permissions given, or with those of any new file.
    ///
    /// # Errors
    /// Those of the system.
    pub(super) fn new(folder: &Path, permissions: Option<&Permissions>) -> io::Result<Self> {
        #[cfg(target_os = "linux")]
        let partial = match unnamed::create(folder) {
            Some(file) => Self::Unnamed(file),
            None => Self::Hidden(Hidden::new(folder)?),
        };
        #[cfg(not(target_os = "linux"))]
        let partial = Self::Hidden(Hidden::new(folder)?);
        if let Some(permissions) = permissions {
            partial.file().set_permissions(permissions.clone())?;
        }
        Ok(partial)
    }

    fn file(&self) -> &File {
        match self {
            #[cfg(target_os = "linux")]
            Self::Unnamed(file) => file,
            Self::Hidden(hidden) => hidden.0.as_file(),
        }
    }

    /// Gives the file its name in the folder that it was created in. A file of that name is replaced in one step.
    ///
    /// # Errors
    /// Those of the system; then the old file is still there.
    pub(super) fn replace(self, path: &Path) -> io::Result<()> {
        match self {
            #[cfg(target_os = "linux")]
            Self::Unnamed(file) => match unnamed::link(&file, path) {
                // A link replaces nothing, so that the file first gets a name beside the old one.
                Err(taken) if taken.kind() == io::ErrorKind::AlreadyExists => {
                    let hidden = names().make_in(folder(path), |name| unnamed::link(&file, name))?;
                    Ok(hidden.into_temp_path().persist(path)?)
                }
                other => other,
            },
            Self::Hidden(hidden) => Ok(fs::rename(hidden.0.path(), path)?),
        }
    }

    /// Gives the file its name in the folder that it was created in, unless there is a file of that name.
    ///
    /// # Errors
    /// Those of the system; [`io::ErrorKind::AlreadyExists`] where the name is taken.
    pub(super) fn name(&self, path: &Path) -> io::Result<()> {
        match self {
            #[cfg(target_os = "linux")]
            Self::Unnamed(file) => unnamed::link(file, path),
            // A second name, in place of the hidden one, which goes when this is dropped.
            Self::Hidden(hidden) => match fs::hard_link(hidden.0.path(), path) {
                // Some file systems have no links: there the name is taken first, and then replaced.
                Err(error) if error.kind() != io::ErrorKind::AlreadyExists => {
                    File::create_new(path)?;
                    fs::rename(hidden.0.path(), path)
                }
                other => other,
            },
        }
    }
}

impl Write for Partial {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file().flush()
    }
}

impl Hidden {
    fn new(folder: &Path) -> io::Result<Self> {
        let mut hidden = HIDDEN.lock().unwrap_or_else(PoisonError::into_inner);
        let file = names().tempfile_in(folder).map_err(|error| io::Error::from(error.kind()))?;
        hidden.push(file.path().to_owned());
        Ok(Self(file))
    }
}

impl Drop for Hidden {
    fn drop(&mut self) {
        HIDDEN.lock().unwrap_or_else(PoisonError::into_inner).retain(|path| path != self.0.path());
    }
}

fn names() -> Builder<'static, 'static> {
    let mut names = Builder::new();
    names.prefix(".rta-").suffix(".part");
    // As of any other new file, not for the owner alone.
    #[cfg(unix)]
    names.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    names
}

/// Returns the folder of a file.
pub(super) fn folder(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Files without a name.
#[cfg(target_os = "linux")]
mod unnamed {
    use std::fs::{self, File};
    use std::io;
    use std::os::fd::AsRawFd;
    use std::path::{Path, PathBuf};

    use rustix::fs::{AtFlags, CWD, Mode, OFlags, linkat, open};

    /// Returns a new file, or none where the file system has no unnamed files, or nothing can be created, or there is no `/proc`
    /// through which the file could get its name.
    pub(super) fn create(folder: &Path) -> Option<File> {
        let flags = OFlags::TMPFILE | OFlags::WRONLY | OFlags::CLOEXEC;
        let file = File::from(open(folder, flags, Mode::from_raw_mode(0o666)).ok()?);
        fs::metadata(name(&file)).is_ok().then_some(file)
    }

    /// Gives the file a name, which must not exist.
    pub(super) fn link(file: &File, path: &Path) -> io::Result<()> {
        Ok(linkat(CWD, name(file), CWD, path, AtFlags::SYMLINK_FOLLOW)?)
    }

    fn name(file: &File) -> PathBuf {
        format!("/proc/self/fd/{}", file.as_raw_fd()).into()
    }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::io::{self, Write};

    use super::{Hidden, Partial, discard};

    #[test]
    fn both_kinds_replace_a_file_or_leave_it() {
        let folder = tempfile::tempdir().expect("a folder");
        let hidden = || Hidden::new(folder.path()).map(Partial::Hidden);
        let any = || Partial::new(folder.path(), None);
        for new in [&hidden as &dyn Fn() -> io::Result<Partial>, &any] {
            let (first, second) = (folder.path().join("first"), folder.path().join("second"));
            let filled = |text: &[u8]| {
                let mut partial = new().expect("a file");
                partial.write_all(text).expect("it is written");
                partial
            };
            for text in [b"one", b"two"] {
                filled(text).replace(&first).expect("it has its name");
                assert_eq!(fs::read(&first).expect("it is there"), text);
            }
            let partial = filled(b"three");
            let taken = partial.name(&first).expect_err("there is one");
            assert_eq!(taken.kind(), io::ErrorKind::AlreadyExists);
            partial.name(&second).expect("it has its name");
            drop(partial);
            assert_eq!(fs::read(&second).expect("it is there"), b"three");
            drop(filled(b"four"));
            assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 2, "nothing else stays");
            fs::remove_file(second).expect("it was there");
        }
        let unfinished = hidden().expect("a file");
        discard();
        assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 1);
        drop(unfinished);
    }
}
