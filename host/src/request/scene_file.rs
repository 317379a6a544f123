//! Scene files: from a path, from standard input, or from the program itself.

use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::Path;

use rta_scenes::description::Description;
use rta_scenes::{Reading, shipped};

use super::error::RequestError;
use crate::picture::output::Inputs;

/// The largest scene file that is read on every machine, in bytes: some hundred thousand objects.
const LEAST_LIMIT: u64 = 64 << 20;

/// Returns the size of the largest scene file that is read, in bytes: an eighth of the machine's memory where that can be
/// told, since what is made of a file takes some times its size. The limit keeps the program from reading a device file or a
/// film until there is no memory left.
fn limit() -> u64 {
    let memory = fs::read_to_string("/proc/meminfo").ok();
    let total =
        memory.as_deref().and_then(|text| text.lines().find_map(|line| line.strip_prefix("MemTotal:")));
    let kilobytes: Option<u64> = total.and_then(|rest| rest.split_whitespace().next()?.parse().ok());
    kilobytes.map_or(LEAST_LIMIT, |size| (size.saturating_mul(1024) / 8).max(LEAST_LIMIT))
}

/// The most pixels on a side that a texture's picture keeps: as many as a window shows of it.
const TEXELS: u32 = 1024;

/// The contents of a scene file, and its names.
#[derive(Clone, Debug)]
pub struct SceneFile {
    /// The file's name for errors, as it was given.
    pub source: String,
    /// The file's name without folders and extension, for titles.
    pub title: String,
    /// The scene that the file describes.
    pub description: Description,
    /// The file itself, so that no output replaces it; nothing for a scene of the program.
    pub inputs: Inputs,
}

impl SceneFile {
    /// Returns the Juggler, which is part of the program.
    ///
    /// # Errors
    /// [`RequestError::Scene`] if the file is malformed.
    pub fn juggler() -> Result<Self, RequestError> {
        Self::parse("juggler.dat", "juggler", shipped::JUGGLER.as_bytes(), Reading::default())
    }

    /// Reads the scene file `path`, or standard input if it is `-`.
    ///
    /// # Errors
    /// [`RequestError::Read`] and [`RequestError::Scene`].
    pub fn open(path: &Path) -> Result<Self, RequestError> {
        Self::open_as(path, Reading::default())
    }

    /// Reads the scene file `path`, or standard input if it is `-`, as `reading` says. Warnings go to standard error.
    ///
    /// # Errors
    /// [`RequestError::Read`] and [`RequestError::Scene`].
    pub fn open_as(path: &Path, reading: Reading) -> Result<Self, RequestError> {
        Self::load(path, reading).map(|(scene, _)| scene)
    }

    /// Reads the scene file `path`, or standard input if it is `-`, and returns its text too.
    ///
    /// # Errors
    /// [`RequestError::Read`] and [`RequestError::Scene`].
    pub fn open_with_text(path: &Path) -> Result<(Self, Vec<u8>), RequestError> {
        Self::load(path, Reading::default())
    }

    fn load(path: &Path, reading: Reading) -> Result<(Self, Vec<u8>), RequestError> {
        let (name, title, text, inputs) = if path == Path::new("-") {
            let name = "standard input".to_owned();
            let text = read(io::stdin().lock(), &name, limit())?;
            (name, "stdin".to_owned(), text, Inputs::stdin())
        } else {
            let name = path.display().to_string();
            let file =
                File::open(path).map_err(|source| RequestError::Read { name: name.clone(), source })?;
            let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned());
            let text = read(&file, &name, limit())?;
            (name.clone(), stem.unwrap_or(name), text, Inputs::file(&file))
        };
        let mut scene = Self { inputs, ..Self::parse(&name, &title, &text, reading)? };
        let texels = reading.texels.unwrap_or(TEXELS);
        if texels > 0 {
            let folder = path.parent().unwrap_or_else(|| Path::new(""));
            let loaded = scene.description.load_pictures(folder, texels);
            loaded.map_err(|source| RequestError::Texture { name: scene.source.clone(), source })?;
        }
        Ok((scene, text))
    }

    /// Returns the three scenes of the thesis, which are part of the program, with their texts.
    ///
    /// # Errors
    /// [`RequestError::Scene`] if one of the files is malformed.
    pub fn shipped() -> Result<Vec<(Self, Vec<u8>)>, RequestError> {
        let scene = |(name, text): (&str, &str)| {
            let title = name.trim_end_matches(".dat");
            Ok((Self::parse(name, title, text.as_bytes(), Reading::default())?, text.as_bytes().to_vec()))
        };
        shipped::ALL.into_iter().map(scene).collect()
    }

    /// Returns the scene that is part of the program under this name, if there is one: one of the thesis, or `balls2`.
    ///
    /// # Errors
    /// [`RequestError::Scene`] if the file is malformed.
    pub fn named(title: &str) -> Option<Result<Self, RequestError>> {
        let all = shipped::ALL.into_iter().chain([("balls2.nff", shipped::BALLS_2)]);
        let stem = |name: &str| name.split('.').next() == Some(title);
        let (name, text) = all.into_iter().find(|(name, _)| stem(name))?;
        Some(Self::parse(name, title, text.as_bytes(), Reading::default()))
    }

    /// Returns the scene that a text of the program describes, in the language `.rta`.
    ///
    /// # Errors
    /// [`RequestError::Scene`] if the text is malformed.
    pub fn of_text(title: &str, text: &str, reading: Reading) -> Result<Self, RequestError> {
        Self::parse(&format!("{title}.rta"), title, text.as_bytes(), reading)
    }

    /// Returns the scene as it is at an instant of its film, 0 to 1.
    #[must_use]
    pub fn at(&self, instant: f64) -> Self {
        Self { description: self.description.at(instant), ..self.clone() }
    }

    fn parse(source: &str, title: &str, text: &[u8], reading: Reading) -> Result<Self, RequestError> {
        let description = rta_scenes::read_with(text, source, reading)?;
        let mut to = io::stderr().lock();
        for warning in &description.warnings {
            // Standard error may be closed: then nobody wants to know.
            let _ = writeln!(to, "rta: warning: {}", warning.of_file(source));
        }
        // A title goes into window titles and file names: what is not plain there is left out.
        let title =
            title.chars().map(|c| if c.is_control() || "/\\:".contains(c) { '_' } else { c }).collect();
        Ok(Self { source: source.to_owned(), title, description, inputs: Inputs::default() })
    }
}

fn read(file: impl Read, name: &str, limit: u64) -> Result<Vec<u8>, RequestError> {
    let failed = |source| RequestError::Read { name: name.to_owned(), source };
    let mut text = Vec::new();
    file.take(limit + 1).read_to_end(&mut text).map_err(failed)?;
    if text.len() as u64 > limit {
        let mebibytes = limit >> 20;
        let reason = format!("larger than {mebibytes} MiB, the limit on a machine with this much memory");
        return Err(failed(io::Error::other(reason)));
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::{LEAST_LIMIT, SceneFile, limit, read};
    use crate::request::error::RequestError;

    #[test]
    fn the_juggler_is_in_the_program() {
        assert_eq!(SceneFile::juggler().expect("it is well formed").description.spheres.len(), 70);
    }

    #[test]
    fn endless_input_is_refused() {
        let read = read(std::io::repeat(b'1'), "endless", 3 << 20);
        assert!(matches!(&read, Err(RequestError::Read { name, .. }) if name == "endless"));
        assert!(read.expect_err("too long").to_string().contains("larger than 3 MiB"));
        assert!(limit() >= LEAST_LIMIT);
    }
}
