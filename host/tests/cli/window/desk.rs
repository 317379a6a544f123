//! A window of `rta show` on a screen of its own, with keyboard and mouse.

use core::time::Duration;
use std::fs;
use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;

use crate::folder::Folder;

/// The longest that anything may take, on a slow machine with much else to do.
pub(super) const PATIENCE: Duration = Duration::from_secs(60);

/// Whether the tools are there.
pub(super) fn has_tools() -> bool {
    let runs = |tool: &str, option: &str| {
        let tool = Command::new(tool).arg(option).stdout(Stdio::null()).stderr(Stdio::null()).status();
        // Each of them prints its help or version; not all of them call that a success.
        tool.is_ok()
    };
    let all = runs("xdotool", "version") && runs("import", "-version") && runs("Xvfb", "-help");
    assert!(all || std::env::var_os("CI").is_none(), "Xvfb, xdotool and ImageMagick are needed");
    all
}

/// Two servers that start at the same time may choose the same number, and there is one pointer and focus for each.
static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());

/// An X server with a screen of its own. It ends when this is dropped.
struct Server {
    process: Child,
    display: String,
    _turn: MutexGuard<'static, ()>,
}

impl Server {
    fn new(size: &str) -> Self {
        let turn = ONE_AT_A_TIME.lock().unwrap_or_else(PoisonError::into_inner);
        let mut server = Command::new("Xvfb");
        // With -noreset the server does not begin anew whenever its last client has gone.
        server.args(["-noreset", "-displayfd", "1", "-screen", "0", &format!("{size}x24")]);
        let mut process = server.stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap();
        let mut number = String::new();
        BufReader::new(process.stdout.as_mut().unwrap()).read_line(&mut number).unwrap();
        Self { process, display: format!(":{}", number.trim()), _turn: turn }
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // Asked to end, it removes its socket.
        let _ = Command::new("kill").arg(self.process.id().to_string()).status();
        let _ = self.process.wait();
    }
}

/// The program in a window. It ends when this is dropped, before its server does.
pub(super) struct Desk {
    pub(super) program: Child,
    window: String,
    server: Server,
}

impl Drop for Desk {
    fn drop(&mut self) {
        let _ = self.program.kill();
        let _ = self.program.wait();
    }
}

impl Desk {
    /// Starts `rta show` in `folder` on a screen of `size`, and waits for its window.
    pub(super) fn new(folder: &Folder, size: &str, args: &[&str]) -> Self {
        let server = Server::new(size);
        let mut program = Command::new(env!("CARGO_BIN_EXE_rta"));
        program.arg("show").args(args).current_dir(folder.path("")).stdin(Stdio::null());
        program.env("DISPLAY", &server.display).env_remove("WAYLAND_DISPLAY");
        program.stdout(fs::File::create(folder.path("out.txt")).unwrap());
        program.stderr(fs::File::create(folder.path("err.txt")).unwrap());
        let program = program.spawn().unwrap();
        let mut desk = Self { program, window: String::new(), server };
        // The pointer begins in the middle of the screen.
        desk.xdotool(&["mousemove", "0", "0"]);
        desk.window = desk.xdotool(&["search", "--sync", "--onlyvisible", "--name", "^rta: "]);
        desk.xdotool(&["windowfocus", "--sync", &desk.window]);
        desk
    }

    pub(super) fn xdotool(&self, args: &[&str]) -> String {
        let output =
            Command::new("xdotool").args(args).env("DISPLAY", &self.server.display).output().unwrap();
        assert!(output.status.success(), "{args:?}: {output:?}");
        String::from_utf8(output.stdout).unwrap().trim().to_owned()
    }

    pub(super) fn press(&self, key: &str) {
        self.xdotool(&["key", key]);
    }

    /// Moves the mouse to a place of the window.
    pub(super) fn point(&self, x: usize, y: usize) {
        let (x, y) = (x.to_string(), y.to_string());
        self.xdotool(&["mousemove", "--window", &self.window, &x, &y]);
    }

    pub(super) fn title(&self) -> String {
        self.xdotool(&["getwindowname", &self.window])
    }

    /// The window's pixels as 0RGB, row by row.
    pub(super) fn shot(&self) -> Vec<u32> {
        let mut import = Command::new("import");
        import.args(["-window", &self.window, "-depth", "8", "rgb:-"]).env("DISPLAY", &self.server.display);
        let bytes = import.output().unwrap().stdout;
        let packed = |rgb: &[u8]| u32::from_be_bytes([0, rgb[0], rgb[1], rgb[2]]);
        bytes.chunks_exact(3).map(packed).collect()
    }

    /// Takes screenshots until one is as `want` says.
    pub(super) fn awaits(&self, what: &str, want: impl Fn(&[u32]) -> bool) -> Vec<u32> {
        let begun = Instant::now();
        loop {
            let shot = self.shot();
            if want(&shot) {
                return shot;
            }
            assert!(begun.elapsed() < PATIENCE, "{what}: {}", self.title());
            std::thread::sleep(Duration::from_millis(50));
        }
    }

    pub(super) fn geometry(&self) -> [usize; 4] {
        let text = self.xdotool(&["getwindowgeometry", "--shell", &self.window]);
        ["X", "Y", "WIDTH", "HEIGHT"].map(|name| {
            let line = text.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix('='));
            line.unwrap().parse().unwrap()
        })
    }

    pub(super) fn resizes_to(&self, want: [usize; 4]) {
        let begun = Instant::now();
        while self.geometry() != want {
            assert!(begun.elapsed() < PATIENCE, "{:?}, not {want:?}", self.geometry());
            std::thread::sleep(Duration::from_millis(20));
        }
    }
}
