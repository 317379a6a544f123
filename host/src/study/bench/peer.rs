//! POV-Ray, run on the same picture.

use core::time::Duration;
use std::fs;
use std::io;
use std::process::{Command, Stdio};

use tempfile::TempDir;

use super::case::Case;
use super::povray;
use crate::engine::EngineError;
use crate::picture::raster::Size;

/// Why POV-Ray's time could not be measured.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PeerError {
    /// POV-Ray cannot be started.
    #[error("povray cannot be started: {0}")]
    Start(io::Error),
    /// POV-Ray ended with an error.
    #[error("povray does not render {scene}: {reason}")]
    Failed {
        /// The scene.
        scene: String,
        /// The end of its output.
        reason: String,
    },
    /// Its output does not state the time.
    #[error("povray does not tell how long {0} took: is it version 3.7?")]
    NoTime(String),
    /// The scene's camera cannot be expressed in POV-Ray's terms.
    #[error(transparent)]
    Camera(#[from] EngineError),
    /// The temporary folder cannot be made or written.
    #[error("the folder for povray: {0}")]
    Folder(io::Error),
}

/// The statistics that POV-Ray prints of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Statistics {
    /// CPU time of tracing, without parsing and building.
    pub time: Duration,
    /// Rays of all kinds by its own count, which includes rays that are too deep to be traced, and one more shadow ray for each
    /// transparent object on the way to a lamp.
    pub rays: u64,
}

/// A scene as POV-Ray reads it, in a folder of its own.
pub struct Peer {
    folder: TempDir,
    scene: String,
    size: Size,
}

impl Peer {
    /// Writes the scene.
    ///
    /// # Errors
    /// [`PeerError::Folder`] and [`PeerError::Camera`].
    pub fn new(case: &Case) -> Result<Self, PeerError> {
        let folder = tempfile::tempdir().map_err(PeerError::Folder)?;
        let aspect = case.engine().settings().aspect;
        let text = povray::scene(&case.scene.description, case.request.model, case.request.depth, aspect)?;
        fs::write(folder.path().join("scene.pov"), text).map_err(PeerError::Folder)?;
        Ok(Self { folder, scene: case.scene.title.clone(), size: case.size() })
    }

    /// Renders the picture.
    ///
    /// # Errors
    /// All of [`PeerError`].
    pub fn render(&self) -> Result<Statistics, PeerError> {
        // One thread, no smoothing of edges, no window, linear light, and of its words the statistics alone.
        let ended = Command::new("povray")
            .args(["+Iscene.pov", "+Oscene.ppm", "+FP", "File_Gamma=1.0", "+WT1", "-A", "+Q9", "-D", "-V"])
            .args(["-GD", "-GR", "-GW", "+GF", "+GS"])
            .args([format!("+W{}", self.size.width()), format!("+H{}", self.size.height())])
            .current_dir(self.folder.path())
            .stdin(Stdio::null())
            .output()
            .map_err(PeerError::Start)?;
        let said = String::from_utf8_lossy(&ended.stderr);
        if !ended.status.success() {
            let scene = self.scene.clone();
            return Err(PeerError::Failed { scene, reason: last_words(&said) });
        }
        statistics(&said).ok_or_else(|| PeerError::NoTime(self.scene.clone()))
    }
}

/// Returns the last lines of the output, which tell the error.
fn last_words(said: &str) -> String {
    let lines: Vec<_> = said.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
    lines.get(lines.len().saturating_sub(4)..).unwrap_or_default().join(" ")
}

/// Reads the statistics at the end of a rendering.
fn statistics(said: &str) -> Option<Statistics> {
    let lines = said.lines().map(str::trim);
    let after_word = |word| lines.clone().find_map(|line| line.strip_prefix(word)?.split_whitespace().next());
    // Without lamps it says nothing of rays to them.
    let shadow: u64 = after_word("Shadow Ray Tests:").unwrap_or("0").parse().ok()?;
    let rays = after_word("Rays:")?.parse::<u64>().ok()? + shadow;
    let after = lines.clone().skip_while(|line| !line.starts_with("Trace Time:")).nth(1)?;
    let (seconds, _) = after.strip_prefix("using 1 thread(s) with ")?.split_once(" CPU-seconds")?;
    let time = Duration::try_from_secs_f64(seconds.parse().ok()?).ok()?;
    Some(Statistics { time, rays })
}

#[cfg(test)]
mod tests {
    use core::time::Duration;

    use super::{Statistics, last_words, statistics};

    const SAID: &str = "\
  Parse Time:       0 hours  0 minutes  0 seconds (0.500 seconds)
              using 1 thread(s) with 0.400 CPU-seconds total
Pixels:            64000   Samples:               0   Smpls/Pxl: 0.00
Rays:              75156   Saved:                 0   Max Level: 2/6
Shadow Ray Tests:             40968   Succeeded:                  3267
  Trace Time:       0 hours  0 minutes  0 seconds (0.066 seconds)
              using 1 thread(s) with 0.047 CPU-seconds total
POV-Ray finished
";

    #[test]
    fn the_time_of_tracing_is_read() {
        let time = Duration::from_millis(47);
        assert_eq!(statistics(SAID), Some(Statistics { time, rays: 75_156 + 40_968 }));
        let unlit = SAID.replace("Shadow Ray Tests", "Nothing");
        assert_eq!(statistics(&unlit), Some(Statistics { time, rays: 75_156 }));
        assert_eq!(statistics(&SAID.replace("using 1", "using 2")), None);
        assert_eq!(statistics(&SAID.replace("Trace Time", "Time")), None);
        assert_eq!(statistics(""), None);
    }

    #[test]
    fn an_error_is_its_last_lines() {
        assert_eq!(last_words("\n a \nb\n\nc\nd\n e\n"), "b c d e");
        assert_eq!(last_words(""), "");
    }
}
