//! The window of `rta show` on a screen of its own: screenshots, keys, the mouse, and a scene file that changes.
//!
//! It needs Xvfb, xdotool and ImageMagick. Where they are not installed these tests are left out, but not in CI.

use std::fs;
use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use rta::args::ShowArgs;
use rta::scene::Scene;
use rta::show::Show;
use rta::show::overlay::{Overlay, draw};

use super::folder::{Folder, decoder, spoilt};

const PATIENCE: Duration = Duration::from_secs(60);

/// Whether the tools are there.
fn has_tools() -> bool {
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
struct Desk {
    program: Child,
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
    fn new(folder: &Folder, size: &str, args: &[&str]) -> Self {
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

    fn xdotool(&self, args: &[&str]) -> String {
        let output =
            Command::new("xdotool").args(args).env("DISPLAY", &self.server.display).output().unwrap();
        assert!(output.status.success(), "{args:?}: {output:?}");
        String::from_utf8(output.stdout).unwrap().trim().to_owned()
    }

    fn press(&self, key: &str) {
        self.xdotool(&["key", key]);
    }

    /// Moves the mouse to a place of the window.
    fn point(&self, x: usize, y: usize) {
        let (x, y) = (x.to_string(), y.to_string());
        self.xdotool(&["mousemove", "--window", &self.window, &x, &y]);
    }

    fn title(&self) -> String {
        self.xdotool(&["getwindowname", &self.window])
    }

    /// The window's pixels as 0RGB, row by row.
    fn shot(&self) -> Vec<u32> {
        let mut import = Command::new("import");
        import.args(["-window", &self.window, "-depth", "8", "rgb:-"]).env("DISPLAY", &self.server.display);
        let bytes = import.output().unwrap().stdout;
        let packed = |rgb: &[u8]| u32::from_be_bytes([0, rgb[0], rgb[1], rgb[2]]);
        bytes.chunks_exact(3).map(packed).collect()
    }

    /// Takes screenshots until one is as `want` says.
    fn awaits(&self, what: &str, want: impl Fn(&[u32]) -> bool) -> Vec<u32> {
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

    /// Waits until the picture is complete: then the title ends with seconds, or has a note after them.
    fn completes(&self) {
        let begun = Instant::now();
        while !self.title().contains(" s") {
            assert!(begun.elapsed() < PATIENCE, "{}", self.title());
            std::thread::sleep(Duration::from_millis(50));
        }
    }

    fn geometry(&self) -> [usize; 4] {
        let text = self.xdotool(&["getwindowgeometry", "--shell", &self.window]);
        ["X", "Y", "WIDTH", "HEIGHT"].map(|name| {
            let line = text.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix('='));
            line.unwrap().parse().unwrap()
        })
    }

    fn resizes_to(&self, want: [usize; 4]) {
        let begun = Instant::now();
        while self.geometry() != want {
            assert!(begun.elapsed() < PATIENCE, "{:?}, not {want:?}", self.geometry());
            std::thread::sleep(Duration::from_millis(20));
        }
    }
}

/// What `rta render` makes of a scene on mode 13h: its palette, and the index of each pixel.
fn rendered(folder: &Folder) -> (Vec<u32>, Vec<u8>) {
    folder.renders(&["scene.dat", "-o", "want.png"]);
    let mut reader = decoder(&folder.path("want.png"));
    let mut indices = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut indices).unwrap();
    let palette = reader.info().palette.as_deref().unwrap();
    (palette.chunks(3).map(|rgb| u32::from_be_bytes([0, rgb[0], rgb[1], rgb[2]])).collect(), indices)
}

/// The picture of mode 13h in a window of 960 x 720: three columns a pixel, and 18 rows for five of them.
fn enlarged((palette, indices): &(Vec<u32>, Vec<u8>)) -> Vec<u32> {
    let places = (0..720).flat_map(|y| (0..960).map(move |x| (x, y)));
    places.map(|(x, y)| palette[usize::from(indices[y * 200 / 720 * 320 + x / 3])]).collect()
}

/// The pixels in which two windows differ: their columns and rows from the first to the last, and their number.
fn differing(a: &[u32], b: &[u32]) -> Option<([usize; 2], [usize; 2], usize)> {
    assert_eq!((a.len(), b.len()), (960 * 720, 960 * 720));
    let places: Vec<_> = (0..a.len()).filter(|at| a[*at] != b[*at]).collect();
    let range = |of: fn(usize) -> usize| {
        let all = places.iter().map(|at| of(*at));
        Some([all.clone().min()?, all.max()?])
    };
    Some((range(|at| at % 960)?, range(|at| at / 960)?, places.len()))
}

/// The same picture without a window, for what the library draws over it.
fn show(folder: &Folder) -> Show {
    let scene = Scene::open(&folder.path("scene.dat")).unwrap();
    let args = ShowArgs::default();
    let request = args.tracing.request_for(args.device, &scene).unwrap();
    let mut show = Show::new(scene, None, request, Some(1)).unwrap();
    let begun = Instant::now();
    while !show.is_complete() {
        show.advance(PATIENCE).unwrap();
        assert!(begun.elapsed() < PATIENCE);
    }
    show
}

#[test]
fn help_palette_and_pixel_lie_over_the_picture_that_render_writes() {
    if !has_tools() {
        return;
    }
    let folder = Folder::new();
    let (palette, indices) = rendered(&folder);
    let picture = enlarged(&(palette.clone(), indices.clone()));
    let mut show = show(&folder);
    let mut drawn = |overlay: &Overlay| draw(&mut show, overlay, 960, 720).unwrap().pixels;
    assert_eq!(differing(&drawn(&Overlay::default()), &picture), None);
    let desk = Desk::new(&folder, "1280x1000", &["scene.dat"]);
    desk.completes();
    assert_eq!(desk.geometry(), [160, 140, 960, 720]);

    // The help is there at first, in the middle, dark with light letters; a key ends it.
    let help = drawn(&Overlay { help: true, ..Overlay::default() });
    let shot = desk.awaits("help at first", |shot| shot == help);
    let ([left, right], [top, bottom], _) = differing(&shot, &picture).unwrap();
    assert!(
        left.abs_diff(959 - right) <= 2 && top.abs_diff(719 - bottom) <= 2,
        "{left} {right} {top} {bottom}"
    );
    assert!(right - left < 800 && bottom - top < 500);
    let inside = |at: &usize| (left..=right).contains(&(at % 960)) && (top..=bottom).contains(&(at / 960));
    let green: Vec<_> = (0..shot.len()).filter(inside).map(|at| shot[at] >> 8 & 255).collect();
    let dark = green.iter().filter(|level| **level < 60).count();
    let light = green.iter().filter(|level| **level > 200).count();
    assert!(dark > green.len() * 3 / 4 && light > 2000, "{dark} dark, {light} light of {}", green.len());
    for key in ["h", "F1", "question", "H", "question", "F1"].iter().zip([false, true].iter().cycle()) {
        desk.press(key.0);
        desk.awaits(key.0, |shot| shot == if *key.1 { &help } else { &picture });
    }
    desk.press("h");

    // Every entry of the table is seen in the palette, the pixel's with a mark.
    desk.press("p");
    let shot = desk.awaits("palette", |shot| shot != picture);
    assert_eq!(differing(&shot, &drawn(&Overlay { palette: true, ..Overlay::default() })), None);
    let ([left, _], [_, bottom], _) = differing(&shot, &picture).unwrap();
    let corner = |at: &usize| at % 960 >= left && at / 960 <= bottom;
    for color in &palette {
        let seen = (0..shot.len()).filter(corner).filter(|at| shot[*at] == *color).count();
        assert!(seen >= 20 * 20 - 20, "{color:06x}: {seen}");
    }
    desk.press("p");
    desk.awaits("no palette", |shot| shot == picture);

    // The mouse tells a pixel: what the picture has there, and what `rta explain` says of it.
    for (x, y) in [(160, 100), (0, 0), (97, 60), (200, 190), (319, 199)] {
        desk.point(3 * x + 1, (y * 720 + 719) / 200);
        let overlay = Overlay { pixel: Some((x as u32, y as u32)), ..Overlay::default() };
        let want = drawn(&overlay);
        desk.awaits("the pixel under the mouse", |shot| shot == want);
    }
    desk.press("i");
    desk.awaits("no pixel", |shot| shot == picture);
    for (x, y) in [(160, 100), (0, 0), (97, 60), (200, 190), (319, 199)] {
        let index = indices[y * 320 + x];
        let [_, r, g, b] = palette[usize::from(index)].to_be_bytes();
        let lines = show.describe(x as u32, y as u32);
        assert_eq!(lines[0], format!("{x},{y}  colour {r} {g} {b}  entry {index}"));
        let pixel = format!("{x},{y}");
        let told = folder.prints(&[
            "explain",
            "scene.dat",
            "--pixel",
            &pixel,
            "--format",
            "f32",
            "--size",
            "320x200",
        ]);
        let primary = told.lines().find(|line| line.contains(" 0 primary")).unwrap();
        let object = lines[1].split("  rays: ").next().unwrap();
        let object = if object == "floor" { "tile" } else { object };
        assert!(primary.contains(object), "{primary} {lines:?}");
        let rays = told.lines().filter(|line| {
            ["primary", "reflected", "transmitted"].iter().any(|kind| line.contains(&format!(" {kind} ")))
        });
        let counted = lines[1].split("  rays: ").nth(1).unwrap().split(", ");
        let counted = counted.filter(|part| !part.ends_with("shadow"));
        let counted: usize =
            counted.map(|part| part.split(' ').next().unwrap().parse::<usize>().unwrap()).sum();
        assert_eq!(counted, rays.count(), "{told} {lines:?}");
    }
}

#[test]
fn a_file_that_changes_is_shown_and_a_broken_one_is_told() {
    if !has_tools() {
        return;
    }
    let folder = Folder::new();
    let before = enlarged(&rendered(&folder));
    let red = spoilt("-2 0 1   1 0 0", "-2 0 1   0 1 1");
    let desk = Desk::new(&folder, "1280x1000", &["scene.dat"]);
    desk.completes();
    desk.press("h");
    desk.awaits("the picture", |shot| shot == before);
    folder.scene("scene.dat", &red);
    let after = enlarged(&rendered(&folder));
    assert_ne!(before, after);
    desk.awaits("the changed scene", |shot| shot == after);

    folder.scene("scene.dat", "0 -10 2   0 1 0   1\n1   5 5");
    let shot = desk.awaits("an error", |shot| shot != after);
    let (_, [top, bottom], _) = differing(&shot, &after).unwrap();
    assert!(top == 0 && bottom < 120, "the picture stays below the message");
    assert!(desk.title().contains("scene.dat"), "{}", desk.title());
    let told = fs::read_to_string(folder.path("err.txt")).unwrap();
    assert!(told.starts_with("rta: error: scene.dat") && told.lines().count() == 1, "{told}");
    desk.press("r");
    let errors = || fs::read_to_string(folder.path("err.txt")).unwrap().lines().count();
    desk.awaits("the error again", |_| errors() == 2);
    folder.scene("scene.dat", super::folder::SCENE);
    desk.press("r");
    desk.awaits("the scene read on a key", |shot| shot == before);
    assert!(desk.title().ends_with(" s"), "{}", desk.title());
}

#[test]
fn windows_keep_to_the_screen_fill_it_on_a_key_and_save_the_whole_picture() {
    if !has_tools() {
        return;
    }
    let folder = Folder::new();
    let options = ["scene.dat", "--device", "pixrect", "--format", "q16"];
    let mut desk = Desk::new(&folder, "800x600", &options);
    let [_, _, width, height] = desk.geometry();
    assert_eq!((width, height), (691, 540), "1152 : 900 on nine tenths of the screen");
    // It is asked for long before the picture is complete.
    desk.press("s");
    desk.press("F11");
    desk.resizes_to([0, 0, 800, 600]);
    desk.press("F11");
    desk.resizes_to([54, 30, width, height]);
    desk.press("q");
    assert!(desk.program.wait().unwrap().success());
    let told = fs::read_to_string(folder.path("out.txt")).unwrap();
    assert!(told.ends_with("saved rta-scene-pixrect.png\n"), "{told}");
    folder.renders(&[&options[..], &["-o", "want.png"]].concat());
    let files = ["rta-scene-pixrect.png", "want.png"].map(|name| fs::read(folder.path(name)).unwrap());
    assert!(files[0] == files[1], "the window's picture is not that of rta render");
}
