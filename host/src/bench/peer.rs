//! POV-Ray, run on the same picture.

use core::time::Duration;
use std::fs;
use std::io;
use std::process::{Command, Stdio};

use tempfile::TempDir;

use super::case::Case;
use super::povray;
use crate::engine::EngineError;
use crate::raster::Size;

/// Why there is no time of POV-Ray's.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PeerError {
    /// It cannot be started.
    #[error("povray cannot be started: {0}")]
    Start(io::Error),
    /// It ended with an error.
    #[error("povray does not render {scene}: {reason}")]
    Failed {
        /// The scene.
        scene: String,
        /// Its last words.
        reason: String,
    },
    /// It said nothing of its time.
    #[error("povray does not tell how long {0} took: is it version 3.7?")]
    NoTime(String),
    /// The scene's camera cannot be turned into its.
    #[error(transparent)]
    Camera(#[from] EngineError),
    /// The temporary folder.
    #[error("the folder for povray: {0}")]
    Folder(io::Error),
}

/// What POV-Ray says of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Statistics {
    /// CPU time of tracing, without parsing and building.
    pub time: Duration,
    /// Rays but for those to lamps.
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

/// What an error ends with.
fn last_words(said: &str) -> String {
    let lines: Vec<_> = said.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
    lines.get(lines.len().saturating_sub(4)..).unwrap_or_default().join(" ")
}

/// Reads the statistics at the end of a rendering.
fn statistics(said: &str) -> Option<Statistics> {
    let mut lines = said.lines().map(str::trim).skip_while(|line| !line.starts_with("Rays:"));
    let rays = lines.next()?.split_whitespace().nth(1)?.parse().ok()?;
    let after = lines.skip_while(|line| !line.starts_with("Trace Time:")).nth(1)?;
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
  Trace Time:       0 hours  0 minutes  0 seconds (0.066 seconds)
              using 1 thread(s) with 0.047 CPU-seconds total
POV-Ray finished
";

    #[test]
    fn the_time_of_tracing_is_read() {
        assert_eq!(statistics(SAID), Some(Statistics { time: Duration::from_millis(47), rays: 75_156 }));
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
