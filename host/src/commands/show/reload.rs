//! Notices that the scene file has changed on disk.

use core::time::Duration;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Instant, SystemTime};

use rta_scenes::Reading;

/// Time between two looks at the file.
const INTERVAL: Duration = Duration::from_millis(250);

/// What tells two states of a file apart: when it was written, its length, and which file it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Stamp {
    written: Option<SystemTime>,
    length: u64,
    /// An editor that writes a new file and renames it leaves another number.
    inode: u64,
}

impl Stamp {
    /// Returns the state of a file; none while it is not there, as when an editor replaces it.
    fn of(path: &Path) -> Option<Self> {
        let file = fs::metadata(path).ok().filter(fs::Metadata::is_file)?;
        #[cfg(unix)]
        let inode = std::os::unix::fs::MetadataExt::ino(&file);
        #[cfg(not(unix))]
        let inode = 0;
        Some(Self { written: file.modified().ok(), length: file.len(), inode })
    }
}

/// A scene file that is watched.
#[derive(Clone, Debug)]
pub struct Watch {
    path: PathBuf,
    reading: Reading,
    /// The state that has been read.
    read: Option<Stamp>,
    /// Another state, seen at the last look. It is told of once it is seen twice, since a file may be looked at half-written.
    seen: Option<Stamp>,
    looked: Instant,
}

impl Watch {
    /// Watches a file that is about to be read, and will be read again as `reading` says.
    #[must_use]
    pub fn new(path: &Path, reading: Reading) -> Self {
        Self { path: path.to_owned(), reading, read: Stamp::of(path), seen: None, looked: Instant::now() }
    }

    /// Returns the file's path.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Returns how the file is read.
    #[must_use]
    pub const fn reading(&self) -> Reading {
        self.reading
    }

    /// Returns whether the file has changed since it was read, and takes it for read then. The file is not looked at more often than
    /// four times a second.
    pub fn has_changed(&mut self) -> bool {
        if self.looked.elapsed() < INTERVAL {
            return false;
        }
        self.looked = Instant::now();
        let now = Stamp::of(&self.path);
        let is_settled = now == self.seen;
        self.seen = now;
        let has_changed = now.is_some() && now != self.read && is_settled;
        if has_changed {
            self.read = now;
        }
        has_changed
    }

    /// Takes the file as it is for read.
    pub fn take(&mut self) {
        self.read = Stamp::of(&self.path);
    }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::time::Instant;

    use super::{INTERVAL, Reading, Watch};

    /// Whether a change is told of at one of the next three looks, and only once.
    fn is_told(watch: &mut Watch) -> bool {
        let mut times = 0;
        for _ in 0..3 {
            watch.looked = Instant::now().checked_sub(INTERVAL).expect("the system is up for longer");
            times += usize::from(watch.has_changed());
        }
        assert!(times < 2, "told {times} times");
        times == 1
    }

    #[test]
    fn a_change_is_told_of_once_and_in_whatever_way_it_was_made() {
        let folder = tempfile::tempdir().expect("a folder");
        let (path, other) = (folder.path().join("scene.dat"), folder.path().join("scene.new"));
        fs::write(&path, "1").expect("written");
        let mut watch = Watch::new(&path, Reading::default());
        assert!(!is_told(&mut watch));
        fs::write(&path, "1 2").expect("written");
        assert!(is_told(&mut watch), "written anew");
        fs::write(&other, "3 4").expect("written");
        fs::rename(&other, &path).expect("renamed");
        assert!(is_told(&mut watch), "replaced by one of its length");
        fs::remove_file(&path).expect("removed");
        assert!(!is_told(&mut watch), "nothing to be read");
        fs::write(&path, "5 6").expect("written");
        assert!(is_told(&mut watch), "there again");
        fs::write(&path, "7").expect("written");
        watch.take();
        assert!(!is_told(&mut watch), "read meanwhile");
    }

    #[test]
    fn a_file_that_is_still_being_written_is_not_read() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("scene.dat");
        fs::write(&path, "").expect("written");
        let mut watch = Watch::new(&path, Reading::default());
        for length in 1..5 {
            fs::write(&path, "x".repeat(length)).expect("written");
            assert!(!watch.has_changed(), "looked at too early");
            watch.looked = Instant::now().checked_sub(INTERVAL).expect("the system is up for longer");
            assert!(!watch.has_changed(), "{length} letters");
        }
    }
}
