//! Where the pictures of a failed test are kept.

use core::fmt;
use std::path::{Component, Path, PathBuf};
use std::{env, fs, io};

/// The files that show why a picture is not the golden one.
#[derive(Debug)]
#[non_exhaustive]
pub struct Kept {
    /// The picture that was drawn.
    pub drawn: PathBuf,
    /// The difference: black where both are equal, and brighter the more a gun differs, from 64 up to 255. None where there is
    /// no golden picture of this size.
    pub difference: Option<PathBuf>,
    /// Why they could not be written, if so.
    pub error: Option<io::Error>,
}

impl Kept {
    /// Writes the files, given as PNG; their names follow from that of the golden picture.
    pub(crate) fn write(
        golden: &Path,
        drawn: io::Result<Vec<u8>>,
        difference: Option<io::Result<Vec<u8>>>,
    ) -> Self {
        let path = folder().join(below(golden));
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let beside = path.with_file_name(format!("{stem}-difference.png"));
        let keep = |path: &Path, png: io::Result<Vec<u8>>| png.and_then(|png| write(path, &png)).err();
        let mut error = keep(&path, drawn);
        let difference = difference.map(|png| {
            error = error.take().or(keep(&beside, png));
            beside
        });
        Self { drawn: path, difference, error }
    }
}

/// Writes the lines of an error that name the files.
impl fmt::Display for Kept {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let drawn = self.drawn.display();
        if let Some(error) = &self.error {
            return write!(f, "\n  it cannot be shown in {drawn}: {error}");
        }
        write!(f, "\n  drawn:      {drawn}")?;
        match &self.difference {
            Some(difference) => write!(f, "\n  difference: {}", difference.display()),
            None => Ok(()),
        }
    }
}

/// Writes a file and makes its folder.
pub(crate) fn write(path: &Path, content: &[u8]) -> io::Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    fs::write(path, content)
}

/// Returns the folder `golden` in that of the build, which is never under version control: the test itself lies somewhere below
/// it, and Cargo marks it as a cache. Nothing at run time tells a library more: `CARGO_TARGET_TMPDIR` is known to the compiler
/// of the test alone. For a program that lies elsewhere it is the system's folder for temporary files.
fn folder() -> PathBuf {
    let test = env::current_exe().unwrap_or_default();
    let build = test.ancestors().find(|folder| folder.join("CACHEDIR.TAG").exists());
    build.map_or_else(env::temp_dir, Path::to_path_buf).join("golden")
}

/// Returns a path of its own below that folder: the package's name, and the golden picture's path inside the package.
fn below(golden: &Path) -> PathBuf {
    let package = env::var("CARGO_PKG_NAME").unwrap_or_default();
    let inside = env::current_dir().ok().and_then(|root| golden.strip_prefix(root).ok()).unwrap_or(golden);
    let names = inside.components().filter(|part| matches!(part, Component::Normal(_)));
    Path::new(&package).join(names.collect::<PathBuf>())
}
