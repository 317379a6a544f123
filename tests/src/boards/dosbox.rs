//! DOSBox: runs the DOS program from a batch file, on a screen of its own, and tells how that ended.

use core::time::Duration;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::Instant;

use rta_drivers::display::{expand, reduce};

use super::expected::Indexed;
use super::{Failure, elf, pcx};

/// Time that a run may take.
const PATIENCE: Duration = Duration::from_secs(600);

/// Time between two looks at what has come.
const PAUSE: Duration = Duration::from_millis(200);

/// The highest level of a VGA's guns.
const GUN_MAX: u8 = 63;

/// Errorlevels are told apart up to this one.
const LEVELS: u8 = 16;

/// When a key is pressed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// Never.
    None,
    /// When the file is there.
    Complete,
    /// From the start, again and again.
    Early,
}

/// A run.
#[derive(Clone, Copy, Debug)]
pub struct Session<'a> {
    /// A line of the batch file before the program.
    pub before: &'a str,
    /// The program's arguments.
    pub arguments: &'a str,
    /// Its setting `cycles`: `max`, or `fixed` and the thousands of instructions a second.
    pub cycles: &'a str,
    /// The most bytes that a file may have, if there is a limit.
    pub limit: Option<u32>,
    /// When a key is pressed.
    pub key: Key,
}

impl<'a> Session<'a> {
    /// Returns a run as fast as it can be, with a key at its end.
    #[must_use]
    pub const fn new(arguments: &'a str) -> Self {
        Self { before: "", arguments, cycles: "max", limit: None, key: Key::Complete }
    }
}

/// How a run ended.
#[derive(Clone, Debug)]
pub struct Ended {
    /// The errorlevel that the next line of the batch file saw.
    pub level: u8,
    /// What the program said.
    pub said: String,
}

/// A process that is ended when this is dropped.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        // One that has ended has no number of its own any more.
        if !matches!(self.0.try_wait(), Ok(None)) {
            return;
        }
        // Asked first: a killed X server leaves its lock.
        let _ = Command::new("kill").arg(self.0.id().to_string()).stderr(Stdio::null()).status();
        for _ in 0..100 {
            if !matches!(self.0.try_wait(), Ok(None)) {
                return;
            }
            thread::sleep(Duration::from_millis(50));
        }
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// A folder that is a drive of DOSBox, with the program on it.
#[derive(Clone, Debug)]
pub struct Drive {
    /// The folder.
    pub folder: PathBuf,
    /// The program's file.
    pub program: &'static str,
}

/// Makes a folder a drive, and writes the program on it: RTA.COM, or RTA.EXE where it does not fit a segment.
///
/// # Errors
/// The image is no ELF file of the DOS program.
pub fn drive(image: &Path, folder: &Path) -> Result<Drive, Failure> {
    let memory = elf::flat(&fs::read(image)?, 0x100)?;
    // A .COM file is read into one segment, at whose end DOS puts the stack.
    let (program, file) =
        if memory.len() <= 0xFC00 { ("RTA.COM", memory) } else { ("RTA.EXE", exe(&memory)?) };
    fs::create_dir_all(folder)?;
    fs::write(folder.join(program), file)?;
    Ok(Drive { folder: folder.to_owned(), program })
}

/// Returns a program in the form of an .EXE file that DOS starts as it starts a .COM file, but for the stack, which comes after it.
fn exe(memory: &[u8]) -> Result<Vec<u8>, Failure> {
    /// Bytes of the header.
    const HEADER: usize = 32;
    /// Paragraphs of the stack until the program has its own.
    const STACK: u16 = 64;
    let size = HEADER + memory.len();
    let pages = u16::try_from(size.div_ceil(512))?;
    let paragraphs = u16::try_from(memory.len().div_ceil(16))?;
    let words = [
        u16::from_le_bytes(*b"MZ"),
        u16::try_from(size % 512)?,
        pages,
        0, // no relocations
        u16::try_from(HEADER / 16)?,
        STACK,  // paragraphs beyond the file, at least
        0xFFFF, // at most: all that there are
        paragraphs,
        STACK * 16,
        0, // no checksum
        0x100,
        0xFFF0, // cs: 16 paragraphs before the program, where DOS has put what it tells of it
        28,     // where relocations would be
        0,
        0,
        0,
    ];
    let mut file: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    file.extend(memory);
    Ok(file)
}

impl Drive {
    /// Runs a session.
    ///
    /// # Errors
    /// A program that is needed cannot be started, the session does not end, or the batch file does not go on after the program.
    pub fn run(&self, session: &Session<'_>) -> Result<Ended, Failure> {
        let room = tempfile::tempdir()?;
        let settings = room.path().join("dosbox.conf");
        fs::write(&settings, configuration(session, &self.folder))?;
        fs::write(self.folder.join("RUN.BAT"), batch(session, self.program))?;
        let (_screen, display) = screen()?;
        let mut shell = Command::new("sh");
        // The limit is that of files that DOSBox writes, in blocks of 512 bytes: a full disk to the program in it.
        let limit = session
            .limit
            .map_or_else(String::new, |bytes| format!("trap '' XFSZ; ulimit -f {}; ", bytes / 512));
        shell.arg("-c").arg(format!("{limit}exec dosbox -conf \"$0\"")).arg(&settings);
        shell.env("DISPLAY", &display).env("SDL_VIDEODRIVER", "x11").env("SDL_AUDIODRIVER", "dummy");
        shell.env("HOME", room.path()).current_dir(room.path());
        let words = room.path().join("words");
        let file = fs::File::create(&words)?;
        shell.stdin(Stdio::null()).stdout(file.try_clone()?).stderr(file);
        let mut running = Running(shell.spawn()?);
        let begin = Instant::now();
        while begin.elapsed() < PATIENCE {
            if let Some(status) = running.0.try_wait()? {
                let level = fs::read_to_string(self.folder.join("LEVEL.TXT"));
                let level = level.map_err(|_| {
                    let words = fs::read(&words).unwrap_or_default();
                    format!("the program did not come back, {status}: {}", String::from_utf8_lossy(&words))
                })?;
                let said = fs::read(self.folder.join("SAID.TXT"))?;
                let said = String::from_utf8_lossy(&said).into_owned();
                return Ok(Ended { level: level.trim().parse()?, said });
            }
            thread::sleep(PAUSE);
            let pressed = match session.key {
                Key::None => false,
                Key::Complete => self.has_picture(),
                Key::Early => true,
            };
            if pressed {
                press(&display)?;
            }
        }
        Err("DOSBox does not end".into())
    }

    /// Returns whether there is a file RTA.PCX.
    #[must_use]
    pub fn has_picture(&self) -> bool {
        self.folder.join("RTA.PCX").exists()
    }

    /// Reads the picture that the program wrote, in levels of a VGA's guns.
    ///
    /// # Errors
    /// There is none, or it is not as it must be.
    pub fn picture(&self) -> Result<Indexed, Failure> {
        let (size, mut picture) = pcx::decode(&fs::read(self.folder.join("RTA.PCX"))?)?;
        if size != (320, 200) {
            return Err(format!("the picture has {size:?} pixels").into());
        }
        for color in &mut picture.colors {
            let level = color.map(|level| reduce(level, GUN_MAX));
            if level.map(|level| expand(level, GUN_MAX)) != *color {
                return Err(format!("{color:?} is no colour of a VGA").into());
            }
            *color = level;
        }
        Ok(picture)
    }
}

/// Presses a key in DOSBox's window, if there is one yet.
fn press(display: &str) -> Result<(), Failure> {
    Command::new("xdotool")
        .args(["search", "--onlyvisible", "--name", "DOSBox", "windowfocus", "key", "x"])
        .env("DISPLAY", display)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()?;
    Ok(())
}

/// Starts an X server on a display that it chooses itself, and returns the display's name.
fn screen() -> Result<(Running, String), Failure> {
    let mut server = Command::new("Xvfb");
    server.args(["-displayfd", "1", "-noreset", "-screen", "0", "800x600x24", "-nolisten", "tcp"]);
    let mut server = server.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::null()).spawn()?;
    let output = server.stdout.take();
    let running = Running(server);
    let mut number = String::new();
    BufReader::new(output.ok_or("no output of Xvfb")?).read_line(&mut number)?;
    let number = number.trim();
    if number.is_empty() { Err("Xvfb does not start".into()) } else { Ok((running, format!(":{number}"))) }
}

/// Returns DOSBox's settings.
fn configuration(session: &Session<'_>, drive: &Path) -> String {
    let cycles = session.cycles;
    format!(
        "[cpu]\ncore=normal\ncycles={cycles}\n[mixer]\nnosound=true\n\
         [autoexec]\nmount c \"{}\"\nc:\ncall run.bat\nexit\n",
        drive.display()
    )
}

/// Returns the batch file that runs the program and then writes its errorlevel. Where keys are pressed from the start, it also waits for
/// one of them, which proves that the keyboard is as it was.
fn batch(session: &Session<'_>, program: &str) -> String {
    let Session { before, arguments, .. } = session;
    let mut lines =
        vec!["@echo off".to_owned(), (*before).to_owned(), format!("{program} {arguments} > SAID.TXT")];
    lines.extend((1..=LEVELS).rev().map(|level| format!("if errorlevel {level} goto level{level}")));
    lines.extend((0..=LEVELS).flat_map(|level| {
        [format!(":level{level}"), format!("echo {level} > LEVEL.TXT"), "goto end".to_owned()]
    }));
    lines.push(":end".to_owned());
    if session.key == Key::Early {
        lines.push("pause > nul".to_owned());
    }
    lines.join("\r\n") + "\r\n"
}
