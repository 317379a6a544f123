//! The command line from outside: what is refused and how, and what comes out.
#![allow(clippy::indexing_slicing, reason = "a test may panic")]

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

#[path = "cli/bench.rs"]
mod bench;
#[path = "cli/firmware.rs"]
mod firmware;
#[path = "cli/nff.rs"]
mod nff;

/// A small scene with one of everything, each number of which some test spoils.
const SCENE: &str = "\
0 -10 2   0 1 0   1
1   5 5 0   0.5 0.5 0.5   0.4   0
1   -2 0 1   1 0 0   1 0.5 0.25   1
2   0 0 1   1 1 1   1   2
    2 1 1   0 1 1   0.75   3 0.25 0.75 1.5
1   4 -8 6   80 80 80   0.5
1 1 0   0 1 0   0.2 0.2 0.2   0.7 0.7 1   0.2 0.2 1
";

struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        let folder = Self(tempfile::tempdir().unwrap());
        fs::write(folder.path("scene.dat"), SCENE).unwrap();
        folder
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn scene(&self, name: &str, text: impl AsRef<[u8]>) {
        fs::write(self.path(name), text).unwrap();
    }

    /// Runs rta in the folder, without a display.
    fn rta(&self, args: &[&str]) -> Output {
        self.command(args).output().unwrap()
    }

    fn command(&self, args: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_rta"));
        command.args(args).current_dir(self.0.path()).stdin(Stdio::null());
        command.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY");
        command
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<_> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    /// Runs rta and sees that it complains as it should: on standard error, with status 2, without a panic, with
    /// all of `words`, and without a new file.
    fn refuses(&self, args: &[&str], words: &[&str]) {
        let before = self.names();
        let Output { status, stdout, stderr } = self.rta(args);
        let message = String::from_utf8(stderr).unwrap();
        assert_eq!(status.code(), Some(2), "{args:?}: {message}");
        assert!(stdout.is_empty(), "{args:?}");
        assert!(message.starts_with("rta: error: "), "{args:?}: {message}");
        for word in words {
            assert!(message.contains(word), "{args:?}: no {word:?} in {message}");
        }
        assert!(!message.contains("panicked"), "{args:?}: {message}");
        assert_eq!(self.names(), before, "{args:?}");
    }

    /// The same for a scene file of this text, by every command that reads one.
    fn refuses_scene(&self, text: impl AsRef<[u8]>, words: &[&str]) {
        self.scene("bad.dat", text);
        let words = [&["bad.dat"], words].concat();
        self.refuses(&["render", "bad.dat", "-o", "out.png"], &words);
        self.refuses(&["render", "bad.dat", "-o", "out.pfm", "--device", "none"], &words);
        self.refuses(&["show", "bad.dat"], &words);
    }

    fn renders(&self, args: &[&str]) -> Vec<u8> {
        let args = [&["render"], args].concat();
        let Output { status, stdout, stderr } = self.rta(&args);
        assert!(status.success() && stderr.is_empty(), "{args:?}: {}", String::from_utf8_lossy(&stderr));
        stdout
    }

    /// Runs rta without a complaint and returns the text that it prints.
    fn prints(&self, args: &[&str]) -> String {
        let Output { status, stdout, stderr } = self.rta(args);
        assert!(status.success() && stderr.is_empty(), "{args:?}: {}", String::from_utf8_lossy(&stderr));
        String::from_utf8(stdout).unwrap()
    }
}

/// The scene with its one `old` replaced.
fn spoilt(old: &str, new: &str) -> String {
    assert_eq!(SCENE.matches(old).count(), 1, "{old}");
    SCENE.replace(old, new)
}

fn decoder(path: &Path) -> png::Reader<std::io::BufReader<fs::File>> {
    png::Decoder::new(std::io::BufReader::new(fs::File::open(path).unwrap())).read_info().unwrap()
}

#[test]
fn scenes_that_cannot_be_read() {
    let folder = Folder::new();
    fs::create_dir(folder.path("folder.dat")).unwrap();
    for (name, word) in [("missing.dat", "No such file"), ("folder.dat", "directory")] {
        folder.refuses(&["render", name, "-o", "out.png"], &[name, word]);
        folder.refuses(&["show", name], &[name, word]);
    }
}

#[test]
fn scenes_that_are_none() {
    let folder = Folder::new();
    folder.refuses_scene("", &["empty file"]);
    folder.refuses_scene(" \n# nothing\n", &["empty file"]);
    folder.refuses_scene(b"\x7fELF\x02\x01\x01\0\0\0", &["binary file"]);
    folder.refuses_scene(b"0 -10 2 \xff\xfe", &["binary file"]);
    folder.refuses_scene(SCENE.trim_end().trim_end_matches('1').trim_end(), &["end of file"]);
    folder.refuses_scene("0 -10", &["end of file"]);
    folder.refuses_scene(format!("{SCENE} 7"), &["bad.dat:8:2", "found 7"]);
}

#[test]
fn scenes_with_wrong_numbers() {
    let folder = Folder::new();
    for number in ["NaN", "nan", "inf", "-inf", "1e400"] {
        folder.refuses_scene(
            spoilt("5 5 0", &format!("5 {number} 0")),
            &["bad.dat:2:7", number, "not a finite"],
        );
    }
    for radius in ["-1", "0", "-0.0", "0e5"] {
        folder.refuses_scene(spoilt("0.4   0", &format!("{radius} 0")), &["radius of cylinder 1", radius]);
        folder.refuses_scene(spoilt("1 0.5 0.25", &format!("1 {radius} 0.25")), &["ellipsoid 1", radius]);
        folder.refuses_scene(spoilt("1   2\n", &format!("{radius} 2\n")), &["radius of sphere 1", radius]);
    }
    folder.refuses_scene(spoilt("80   0.5", "80   -0.5"), &["radius of lamp 1", "-0.5"]);
    folder.refuses_scene(spoilt("0 1 0   1\n", "0 0 0   1\n"), &["direction of view"]);
    folder.refuses_scene(spoilt("0 1 0   1\n", "0 1 0   0\n"), &["focal distance"]);
    for count in ["-1", "1000000000", "1e9", "2.5"] {
        folder.refuses_scene(spoilt("2   0 0 1", &format!("{count}   0 0 1")), &["number of spheres", count]);
    }
    folder.refuses_scene(spoilt("0.25 0.75", "0.25 0.7"), &["sphere 2", "0.7"]);
    folder.refuses_scene(spoilt("0.25 0.75", "-0.25 1.25"), &["sphere 2", "-0.25"]);
    folder.refuses_scene(spoilt("1   2\n", "1   4\n"), &["type of sphere 1", "4"]);
}

#[test]
fn scenes_beyond_fixed_point() {
    let folder = Folder::new();
    folder.scene("far.dat", spoilt("0 0 1   1 1 1   1   2", "0 90000 1   1 1 1   1   2"));
    let args = ["render", "far.dat", "-o", "out.png", "--format"];
    folder.refuses(&[&args[..], &["q16"]].concat(), &["far.dat", "sphere 1", "90001", "32767"]);
    folder.refuses(&["show", "far.dat", "--format", "q16"], &["far.dat", "sphere 1", "90001"]);
    folder.renders(&["far.dat", "-o", "out.png", "--format", "f32"]);
}

#[test]
fn pictures_that_cannot_be() {
    let folder = Folder::new();
    for device in ["vga", "graphigs", "pixrect", "none"] {
        for size in ["0x0", "0x200", "100000x100000", "-1x-1", "big"] {
            let size = format!("--size={size}");
            folder.refuses(&["render", "scene.dat", "-o", "out.png", "--device", device, &size], &["--size"]);
        }
    }
    let render = ["render", "scene.dat", "-o", "out.png"];
    for (options, words) in [
        (["--size", "321x200"], ["321x200", "vga"]),
        (["--aspect", "0"], ["--aspect", "4:3"]),
        (["--depth", "33"], ["--depth", "32"]),
        (["--depth", "4294967296"], ["--depth", "32"]),
        (["--depth", "-1"], ["-1", ""]),
        (["--threads", "0"], ["--threads", "1024"]),
        (["--device", "cga"], ["--device", "graphigs"]),
        (["--format", "f16"], ["--format", "q16"]),
        (["--model", "gouraud"], ["--model", "phong"]),
    ] {
        folder.refuses(&[&render[..], &options].concat(), &words);
        folder.refuses(&[&["show", "scene.dat"][..], &options].concat(), &words[..1]);
    }
}

#[test]
fn outputs_that_cannot_be_written() {
    let folder = Folder::new();
    fs::create_dir(folder.path("folder.png")).unwrap();
    for (output, words) in [
        ("out.jpg", ["out.jpg", ".png"]),
        ("out", ["out", ".pfm"]),
        ("folder.png", ["folder.png", "is a directory"]),
        ("missing/out.png", ["missing/out.png", "No such file"]),
        ("scene.dat/out.png", ["scene.dat/out.png", "cannot write"]),
        ("out.pfm", ["PFM", "--device none"]),
        #[cfg(target_os = "linux")]
        ("/proc/out.png", ["/proc/out.png", "cannot write"]),
        #[cfg(target_os = "linux")]
        ("/dev/full", ["/dev/full", "No space left"]),
    ] {
        folder.refuses(&["render", "scene.dat", "-o", output], &words);
    }
    folder.refuses(&["render", "scene.dat"], &["--output"]);
    // The output is looked at before the scene is read, and before hours of work.
    folder.refuses(&["render", "-", "-o", "missing/out.png"], &["missing/out.png"]);
}

#[test]
fn what_was_there_stays_after_an_error() {
    let folder = Folder::new();
    folder.scene("out.png", "precious");
    folder.scene("bad.dat", "0 0");
    folder.refuses(&["render", "bad.dat", "-o", "out.png"], &["bad.dat"]);
    assert_eq!(fs::read(folder.path("out.png")).unwrap(), b"precious");
    folder.renders(&["scene.dat", "-o", "out.png"]);
    assert!(fs::read(folder.path("out.png")).unwrap().starts_with(b"\x89PNG"));
    assert_eq!(folder.names(), ["bad.dat", "out.png", "scene.dat"]);
}

#[test]
fn a_device_gives_an_indexed_png_with_its_own_colours() {
    let folder = Folder::new();
    for (device, width, height, colors, guns, shape) in [
        ("vga", 320, 200, 256, 63, Some((6, 5))),
        ("graphigs", 1024, 1024, 128, 15, None),
        ("pixrect", 1152, 900, 256, 255, None),
    ] {
        for table in ["adaptive", "tolerant", "uniform"] {
            let path = folder.path("out.png");
            folder.renders(&["scene.dat", "-o", "out.png", "--device", device, "--table", table]);
            let mut reader = decoder(&path);
            let mut indices = vec![0; reader.output_buffer_size().unwrap()];
            reader.next_frame(&mut indices).unwrap();
            let info = reader.info();
            assert_eq!((info.width, info.height, info.color_type), (width, height, png::ColorType::Indexed));
            let palette = info.palette.as_deref().unwrap();
            assert!(palette.len() <= colors * 3 && palette.len() > 30, "{device} {table}: {}", palette.len());
            let entries = palette.len() / 3;
            assert!(indices.iter().all(|index| usize::from(*index) < entries));
            // Only what the guns can do: multiples of 255 / guns, rounded.
            let levels: Vec<u32> = (0..=guns).map(|level| (level * 255 + guns / 2) / guns).collect();
            assert!(palette.iter().all(|part| levels.contains(&u32::from(*part))), "{device} {table}");
            assert_eq!(info.pixel_dims.map(|dims| (dims.xppu, dims.yppu)), shape);
        }
    }
}

#[test]
fn every_kind_of_picture_says_the_same() {
    let folder = Folder::new();
    for options in [&["--device", "vga"][..], &["--device", "none"]] {
        folder.renders(&[&["scene.dat", "-o", "out.png"], options].concat());
        let ppm = folder.renders(&[&["scene.dat", "-o", "-", "--as", "ppm"], options].concat());
        let header = b"P6\n320 200\n255\n";
        assert!(ppm.starts_with(header));
        let mut reader = decoder(&folder.path("out.png"));
        let mut data = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut data).unwrap();
        if let Some(palette) = reader.info().palette.as_deref() {
            data = data.iter().flat_map(|index| palette[usize::from(*index) * 3..][..3].to_vec()).collect();
        }
        assert!(ppm[header.len()..] == data, "{options:?}");
    }
    let pfm = folder.renders(&["scene.dat", "-o", "-", "--as", "pfm", "--device", "none", "--format", "f64"]);
    let ppm = folder.renders(&["scene.dat", "-o", "-", "--as", "ppm", "--device", "none", "--format", "f64"]);
    let numbers = pfm.strip_prefix(b"PF\n320 200\n-1.0\n").unwrap();
    assert_eq!(numbers.len(), 320 * 200 * 12);
    let levels = &ppm[15..];
    for (place, bytes) in numbers.chunks_exact(4).enumerate() {
        let light = f32::from_le_bytes(bytes.try_into().unwrap());
        let (row, rest) = (place / 960, place % 960);
        let level = f32::from(levels[(199 - row) * 960 + rest]);
        assert!((light.clamp(0.0, 1.0) * 255.0 - level).abs() < 0.501, "{place}: {light} {level}");
    }
}

#[test]
fn bytes_do_not_depend_on_threads() {
    let folder = Folder::new();
    for options in [
        &["--format", "q16", "--as", "png", "--device", "graphigs", "--size", "300x200"][..],
        &["--format", "f32", "--as", "pfm", "--device", "none", "--size", "333x77"],
    ] {
        let with =
            |threads| folder.renders(&[&["scene.dat", "-o", "-", "--threads", threads], options].concat());
        let one = with("1");
        assert!(one == with("2") && one == with("13"), "{options:?}");
    }
}

#[test]
fn a_scene_comes_through_a_pipe_and_a_picture_goes_out() {
    let folder = Folder::new();
    let mut child = folder
        .command(&["render", "-", "-o", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(SCENE.as_bytes()).unwrap();
    let piped = child.wait_with_output().unwrap().stdout;
    let mut reader = png::Decoder::new(std::io::Cursor::new(piped)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut pixels).unwrap();
    assert_eq!(pixels.len(), 64_000);
    folder.refuses(&["render", "-", "-o", "out.png"], &["standard input", "empty file"]);
}

#[cfg(unix)]
#[test]
fn a_pipe_that_nobody_reads_is_no_error() {
    let folder = Folder::new();
    let mut child = folder
        .command(&["render", "scene.dat", "-o", "-", "--as", "ppm"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let Output { status, stderr, .. } = child.wait_with_output().unwrap();
    assert!(status.success() && stderr.is_empty(), "{status}: {}", String::from_utf8_lossy(&stderr));
}

#[cfg(unix)]
#[test]
fn an_interrupt_leaves_nothing_behind() {
    let folder = Folder::new();
    let huge = [
        "render",
        "scene.dat",
        "-o",
        "out.png",
        "--device",
        "none",
        "--size",
        "8000x8000",
        "--format",
        "f64",
    ];
    let child = folder.command(&huge).stderr(Stdio::piped()).spawn().unwrap();
    std::thread::sleep(core::time::Duration::from_millis(500));
    let kill = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(kill.unwrap().success());
    let Output { status, stderr, .. } = child.wait_with_output().unwrap();
    assert!(!status.success() && stderr.is_empty(), "{status}: {}", String::from_utf8_lossy(&stderr));
    assert_eq!(folder.names(), ["scene.dat"]);
}

#[cfg(unix)]
#[test]
fn a_named_pipe_is_written_and_not_replaced() {
    use std::os::unix::fs::FileTypeExt;
    let folder = Folder::new();
    let pipe = folder.path("pipe.ppm");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let child = folder.command(&["render", "scene.dat", "-o", "pipe.ppm"]).spawn().unwrap();
    assert!(fs::read(&pipe).unwrap().starts_with(b"P6\n320 200\n255\n"));
    assert!(child.wait_with_output().unwrap().status.success());
    assert!(fs::metadata(&pipe).unwrap().file_type().is_fifo());
}

#[test]
fn without_a_display_the_picture_is_a_file_in_the_folder() {
    let folder = Folder::new();
    let juggler = String::from_utf8(folder.rta(&[]).stdout).unwrap();
    assert!(juggler.contains("./rta-juggler-vga.png") && juggler.lines().count() == 1, "{juggler}");
    let again = folder.rta(&["show", "--device", "vga"]);
    assert_eq!(again.status.code(), Some(0));
    let shown = folder.rta(&["show", "scene.dat", "--device", "graphigs", "--size", "64x64"]);
    assert!(String::from_utf8(shown.stdout).unwrap().contains("./rta-scene-graphigs.png"));
    assert_eq!(
        folder.names(),
        ["rta-juggler-vga-2.png", "rta-juggler-vga.png", "rta-scene-graphigs.png", "scene.dat"]
    );
    let read = |name| fs::read(folder.path(name)).unwrap();
    assert!(read("rta-juggler-vga.png") == read("rta-juggler-vga-2.png"));
    let no_such_display = folder.command(&["show"]).env("DISPLAY", ":9999").output().unwrap();
    assert!(no_such_display.status.success());
    assert!(folder.path("rta-juggler-vga-3.png").exists());
}

#[test]
fn help_and_version_go_to_standard_output() {
    let folder = Folder::new();
    for (args, word) in
        [(&["--help"][..], "Examples"), (&["render", "--help"], "--aspect"), (&["--version"], "rta 0")]
    {
        let Output { status, stdout, stderr } = folder.rta(args);
        assert!(status.success() && stderr.is_empty());
        assert!(String::from_utf8(stdout).unwrap().contains(word), "{args:?}");
    }
    folder.refuses(&["paint"], &["paint"]);
    folder.refuses(&["render"], &["SCENE"]);
}
