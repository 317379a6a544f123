//! The emulators: runs an image and collects its picture and reports.

use core::time::Duration;
use std::fs;
use std::io::{Read, Write};
use std::os::unix::net::UnixStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::Instant;

use rta_core::color::Rgb;

use super::board::{Board, Image, Output};
use super::dosbox::{self, Session};
use super::expected::{Indexed, greys};
use super::qmp::Qmp;
use super::{Failure, elf, folder};

/// Time that a board may take.
const PATIENCE: Duration = Duration::from_secs(600);

/// Picture and reports of a board.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The picture as the board sent it.
    pub drawn: Indexed,
    /// The screendump, where there is a screen.
    pub screendump: Option<Screendump>,
    /// Bytes of stack used, if reported.
    pub stack: Option<u64>,
    /// Instructions before the first row, if reported.
    pub before: Option<u64>,
    /// Instructions to the last pixel, if reported.
    pub instructions: Option<u64>,
    /// The hash that the board computed itself, if reported.
    pub hash: Option<u64>,
}

/// A screendump, 8 bits a gun.
#[derive(Clone, Debug)]
pub struct Screendump {
    /// Width and height in pixels.
    pub size: (usize, usize),
    /// The pixels, row by row.
    pub pixels: Vec<[u8; 3]>,
}

/// A running emulator, which is ended when this is dropped.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

impl Running {
    fn wait(&mut self) -> Result<i32, Failure> {
        let begin = Instant::now();
        while begin.elapsed() < PATIENCE {
            if let Some(status) = self.0.try_wait()? {
                return Ok(status.code().unwrap_or(-1));
            }
            thread::sleep(Duration::from_millis(5));
        }
        Err("the emulator does not end".into())
    }
}

/// Runs an image and returns its picture and reports; `scene` is what it draws, and `room` an empty folder for the files that
/// are written meanwhile.
///
/// # Errors
/// The emulator cannot be started, the board reports a failure, or it says nothing for ten minutes.
pub fn run(board: &Board, image: &Path, scene: &str, room: &Path) -> Result<Outcome, Failure> {
    match board.output {
        Output::Semihosting => {
            let mut command = Command::new(board.emulator);
            if board.package == "cortex-m" {
                command.args(["-M", board.name]);
            }
            command.args(board.arguments).arg("-kernel").arg(image);
            streamed(command, room)
        }
        Output::Module => {
            let mut command = Command::new(board.emulator);
            command.arg(folder().join("wasm/run.mjs")).arg(image).arg(room);
            streamed(command, room)
        }
        Output::Screen { image: kind, .. } => screened(board, kind, image, room),
        Output::Panel { zoom, .. } => paneled(board, image, room, zoom as usize),
        Output::File { .. } => filed(image, scene, room),
    }
}

fn filed(image: &Path, scene: &str, room: &Path) -> Result<Outcome, Failure> {
    let drive = dosbox::drive(image, room)?;
    let ended = drive.run(&Session::new(scene))?;
    if ended.level != 0 || !ended.said.is_empty() {
        return Err(format!("errorlevel {}: {}", ended.level, ended.said).into());
    }
    Ok(Outcome {
        drawn: drive.picture()?,
        screendump: None,
        stack: None,
        before: None,
        instructions: None,
        hash: None,
    })
}

fn streamed(mut command: Command, room: &Path) -> Result<Outcome, Failure> {
    // Either stream may have the reports, by machine; what the emulator itself says does no harm there.
    let words = room.join("words");
    let file = fs::File::create(&words)?;
    command.current_dir(room).stdin(Stdio::null()).stdout(file.try_clone()?).stderr(file);
    let status = Running(command.spawn()?).wait()?;
    let words = String::from_utf8_lossy(&fs::read(&words)?).into_owned();
    if status != 0 {
        return Err(format!("exit code {status}: {words}").into());
    }
    let loads = fs::read(room.join("colors.raw"))?;
    Ok(Outcome {
        drawn: Indexed { colors: table(&loads)?, pixels: fs::read(room.join("pixels.raw"))? },
        screendump: None,
        stack: report(&words, "stack"),
        before: report(&words, "before"),
        instructions: report(&words, "instructions"),
        hash: report(&words, "hash"),
    })
}

/// Returns the colour table after a sequence of loads, each of which is the first entry, the number of colours less 1,
/// and the colours.
fn table(mut loads: &[u8]) -> Result<Vec<Rgb<u8>>, Failure> {
    let mut colors = Vec::new();
    while let [first, less, rest @ ..] = loads {
        let count = usize::from(*less) + 1;
        let (new, rest) = rest.split_at_checked(3 * count).ok_or("the colours end too early")?;
        colors.truncate(usize::from(*first));
        colors.extend(new.as_chunks::<3>().0.iter().map(|&[r, g, b]| Rgb::new(r, g, b)));
        loads = rest;
    }
    Ok(colors)
}

/// Returns the value of the report `name`, which is a line of the name, a blank and hexadecimal digits.
fn report(words: &str, name: &str) -> Option<u64> {
    let value = |line: &str| u64::from_str_radix(line.strip_prefix(name)?.strip_prefix(' ')?.trim(), 16).ok();
    words.lines().find_map(value)
}

/// Writes the image in the form that the emulator takes and returns the arguments that name it.
fn hand_over(kind: Image, image: &Path, room: &Path) -> Result<Vec<String>, Failure> {
    let written = |name: &str, bytes: &[u8]| -> Result<PathBuf, Failure> {
        let path = room.join(name);
        fs::write(&path, bytes)?;
        Ok(path)
    };
    let elf = fs::read(image)?;
    Ok(match kind {
        Image::Kernel => vec!["-kernel".into(), image.display().to_string()],
        Image::Floppy => {
            // The boot sector is at 7C00h. A disk of any other size is taken for one of another geometry.
            let mut disk = elf::flat(&elf, 0x7c00)?;
            if disk.len() > 1_474_560 {
                return Err("the image does not fit a floppy disk".into());
            }
            disk.resize(1_474_560, 0);
            let path = written("floppy.img", &disk)?;
            let drive = format!("file={},format=raw,if=floppy", path.display());
            vec!["-drive".into(), drive, "-boot".into(), "a".into()]
        }
        Image::Prom => {
            let path = written("prom.bin", &elf::flat(&elf, 0x7000_0000)?)?;
            vec!["-bios".into(), path.display().to_string()]
        }
    })
}

/// A machine that shows its picture and waits for a command on its serial line.
struct Waiting {
    running: Running,
    line: UnixStream,
    /// What it has said.
    words: String,
    screendump: Screendump,
}

/// Runs an image until it is `READY`.
fn wait_ready(board: &Board, kind: Image, image: &Path, room: &Path) -> Result<Waiting, Failure> {
    let (qmp, line) = (room.join("qmp"), room.join("serial"));
    let mut command = Command::new(board.emulator);
    command
        .args(board.arguments)
        .args(hand_over(kind, image, room)?)
        .args(["-monitor", "none", "-no-reboot", "-qmp"])
        .arg(format!("unix:{},server=on,wait=off", qmp.display()))
        .arg("-chardev")
        .arg(format!("socket,id=line,path={},server=on,wait=on", line.display()))
        .args(["-serial", "chardev:line"])
        .current_dir(room)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    let running = Running(command.spawn()?);
    let mut line = connect(&line)?;
    line.set_read_timeout(Some(PATIENCE))?;
    let words = until(&mut line, b"READY\n")?;
    let file = room.join("screen.ppm");
    Qmp::connect(&qmp)?.screendump(&file)?;
    Ok(Waiting { running, line, words, screendump: ppm(&fs::read(&file)?)? })
}

fn screened(board: &Board, kind: Image, image: &Path, room: &Path) -> Result<Outcome, Failure> {
    let Waiting { mut running, mut line, words, screendump } = wait_ready(board, kind, image, room)?;
    line.write_all(b"D")?;
    let mut dump = vec![0; 768];
    line.read_exact(&mut dump)?;
    let colors = dump.as_chunks::<3>().0.iter().map(|&[r, g, b]| Rgb::new(r, g, b)).collect();
    let (width, height) = report_size(&words)?;
    let mut pixels = vec![0; width * height];
    line.read_exact(&mut pixels)?;
    line.write_all(b"Q")?;
    let mut last = String::new();
    // The line breaks off when the machine goes.
    let _ = line.read_to_string(&mut last);
    let status = running.wait()?;
    // The PC ends with 1, which says 0; the SPARCstation always with 0, and says so on the line.
    let well = if board.package == "pc" { status == 1 } else { last.contains("EXIT 0\n") };
    if !well {
        return Err(format!("status {status}: {words}{last}").into());
    }
    Ok(Outcome {
        drawn: Indexed { colors, pixels },
        screendump: Some(screendump),
        stack: report(&words, "stack"),
        before: None,
        // An instruction takes the emulator's clock a nanosecond: `-icount shift=0`.
        instructions: report(&words, "nanoseconds"),
        hash: report(&words, "hash"),
    })
}

/// Runs an image that draws on a panel. What it has drawn is read off the screendump, each pixel where its first one is.
fn paneled(board: &Board, image: &Path, room: &Path, zoom: usize) -> Result<Outcome, Failure> {
    let Waiting { mut running, mut line, words, screendump } = wait_ready(board, Image::Kernel, image, room)?;
    line.write_all(b"Q")?;
    let status = running.wait()?;
    if status != 0 {
        return Err(format!("exit code {status}: {words}").into());
    }
    let (width, height) = report_size(&words)?;
    let at = |x, y| screendump.pixels.get(y * zoom * screendump.size.0 + x * zoom);
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let pixels = places.map(|(x, y)| at(x, y).map_or(u8::MAX, |[level, ..]| level / 17)).collect();
    Ok(Outcome {
        drawn: Indexed { colors: greys(), pixels },
        screendump: Some(screendump),
        stack: report(&words, "stack"),
        before: report(&words, "before"),
        instructions: report(&words, "instructions"),
        hash: None,
    })
}

fn report_size(words: &str) -> Result<(usize, usize), Failure> {
    let side = |name| report(words, name).and_then(|side| usize::try_from(side).ok());
    side("width")
        .zip(side("height"))
        .ok_or_else(|| format!("the board does not tell its raster: {words}").into())
}

/// Connects to a socket, which the emulator may not have made yet.
fn connect(socket: &Path) -> Result<UnixStream, Failure> {
    for _ in 0..1000 {
        if let Ok(stream) = UnixStream::connect(socket) {
            return Ok(stream);
        }
        thread::sleep(Duration::from_millis(10));
    }
    Err("the emulator does not start".into())
}

/// Reads up to `end` and returns all of it, `end` included.
fn until(line: &mut UnixStream, end: &[u8]) -> Result<String, Failure> {
    let mut words = Vec::new();
    while !words.ends_with(end) {
        let mut byte = [0];
        if line.read(&mut byte)? == 0 {
            return Err(format!("the board went away: {}", String::from_utf8_lossy(&words)).into());
        }
        words.extend(byte);
    }
    Ok(String::from_utf8_lossy(&words).into_owned())
}

/// Reads a binary PPM with 8 bits a gun.
fn ppm(file: &[u8]) -> Result<Screendump, Failure> {
    let bad = "the screendump is no PPM";
    let header =
        file.splitn(4, |&byte| byte == b'\n').take(3).map(|line| String::from_utf8_lossy(line).into_owned());
    let [kind, size, most] = header.collect::<Vec<_>>().try_into().map_err(|_| bad)?;
    let (width, height) = size.split_once(' ').ok_or(bad)?;
    let (width, height): (usize, usize) = (width.parse()?, height.parse()?);
    let body = file.len().checked_sub(3 * width * height).and_then(|start| file.get(start..)).ok_or(bad)?;
    if kind != "P6" || most != "255" {
        return Err(bad.into());
    }
    Ok(Screendump { size: (width, height), pixels: body.as_chunks::<3>().0.to_vec() })
}
