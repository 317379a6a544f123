//! What the tests share: a folder, a scene in it, and the program run there.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// A small scene with one of everything, each number of which some test spoils.
pub(crate) const SCENE: &str = "\
0 -10 2   0 1 0   1
1   5 5 0   0.5 0.5 0.5   0.4   0
1   -2 0 1   1 0 0   1 0.5 0.25   1
2   0 0 1   1 1 1   1   2
    2 1 1   0 1 1   0.75   3 0.25 0.75 1.5
1   4 -8 6   80 80 80   0.5
1 1 0   0 1 0   0.2 0.2 0.2   0.7 0.7 1   0.2 0.2 1
";

/// A folder of its own for each test, with `scene.dat` in it.
pub(crate) struct Folder(tempfile::TempDir);

impl Folder {
    pub(crate) fn new() -> Self {
        let folder = Self(tempfile::tempdir().unwrap());
        fs::write(folder.path("scene.dat"), SCENE).unwrap();
        folder
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub(crate) fn scene(&self, name: &str, text: impl AsRef<[u8]>) {
        fs::write(self.path(name), text).unwrap();
    }

    /// Runs rta in the folder, without a display.
    pub(crate) fn rta(&self, args: &[&str]) -> Output {
        self.command(args).output().unwrap()
    }

    pub(crate) fn command(&self, args: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_rta"));
        command.args(args).current_dir(self.0.path()).stdin(Stdio::null());
        command.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY");
        command
    }

    pub(crate) fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<_> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    /// Runs rta and sees that it complains as it should: on standard error, after warnings if there are any, with status 2, without
    /// a panic, with all of `words`, and without a new file.
    pub(crate) fn refuses(&self, args: &[&str], words: &[&str]) {
        let before = self.names();
        let Output { status, stdout, stderr } = self.rta(args);
        let message = String::from_utf8(stderr).unwrap();
        assert_eq!(status.code(), Some(2), "{args:?}: {message}");
        assert!(stdout.is_empty(), "{args:?}");
        let error = message.lines().find(|line| !line.starts_with("rta: warning: "));
        assert!(error.is_some_and(|line| line.starts_with("rta: error: ")), "{args:?}: {message}");
        for word in words {
            assert!(message.contains(word), "{args:?}: no {word:?} in {message}");
        }
        assert!(!message.contains("panicked"), "{args:?}: {message}");
        assert_eq!(self.names(), before, "{args:?}");
    }

    /// Writes `bad.dat` with this text and sees that every command that traces a scene refuses it, with its name and all of `words`.
    pub(crate) fn refuses_scene(&self, text: impl AsRef<[u8]>, words: &[&str]) {
        self.scene("bad.dat", text);
        let words = [&["bad.dat"], words].concat();
        self.refuses(&["render", "bad.dat", "-o", "out.png"], &words);
        self.refuses(&["render", "bad.dat", "-o", "out.pfm", "--device", "none"], &words);
        self.refuses(&["show", "bad.dat"], &words);
    }

    pub(crate) fn renders(&self, args: &[&str]) -> Vec<u8> {
        let args = [&["render", "--quiet"], args].concat();
        let Output { status, stdout, stderr } = self.rta(&args);
        assert!(status.success() && stderr.is_empty(), "{args:?}: {}", String::from_utf8_lossy(&stderr));
        stdout
    }

    /// Runs rta without a complaint and returns the text that it prints.
    pub(crate) fn prints(&self, args: &[&str]) -> String {
        let Output { status, stdout, stderr } = self.rta(args);
        assert!(status.success() && stderr.is_empty(), "{args:?}: {}", String::from_utf8_lossy(&stderr));
        String::from_utf8(stdout).unwrap()
    }
}

/// The scene with its one `old` replaced.
pub(crate) fn spoilt(old: &str, new: &str) -> String {
    assert_eq!(SCENE.matches(old).count(), 1, "{old}");
    SCENE.replace(old, new)
}

pub(crate) fn decoder(path: &Path) -> png::Reader<std::io::BufReader<fs::File>> {
    png::Decoder::new(std::io::BufReader::new(fs::File::open(path).unwrap())).read_info().unwrap()
}
