//! The window of `rta show` on a screen of its own: screenshots, keys, the mouse, and a scene file that changes.
//!
//! It needs Xvfb, xdotool and ImageMagick. Where they are not installed these tests are left out, but not in CI.

use std::fs;
use std::time::Instant;

use rta::args::ShowArgs;
use rta::request::Request;
use rta::scene::Scene;
use rta::show::Show;
use rta::show::overlay::{Overlay, draw};

use super::folder::{Folder, decoder, spoilt};
use desk::{Desk, PATIENCE, has_tools};

mod desk;
mod film;

/// Pixels of mode 13h that the mouse is moved to: in the middle, at the edges, and where the text has to make room.
const PIXELS: [(u32, u32); 5] = [(160, 100), (0, 0), (97, 60), (200, 190), (319, 199)];

/// What `rta render` makes of a scene on mode 13h: its palette, and the index of each pixel.
fn rendered(folder: &Folder) -> (Vec<u32>, Vec<u8>) {
    rendered_as(folder, &["scene.dat"])
}

fn rendered_as(folder: &Folder, args: &[&str]) -> (Vec<u32>, Vec<u8>) {
    folder.renders(&[args, &["-o", "want.png"]].concat());
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

/// A picture that is drawn without a window, for what the library draws over it.
fn show(folder: &Folder) -> Show {
    let scene = Scene::open(&folder.path("scene.dat")).unwrap();
    let args = ShowArgs::default();
    let request = Request::of_scene(&args.tracing, args.device, &scene).unwrap();
    let mut show = Show::new(scene, None, (request, args.film), Some(1)).unwrap();
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
    assert_eq!(desk.geometry(), [160, 140, 960, 720]);

    // The help is in the middle, dark with light letters. It is there at first, until some key is pressed.
    let help = drawn(&Overlay { help: true, ..Overlay::default() });
    let ([left, right], [top, bottom], _) = differing(&help, &picture).unwrap();
    assert!(
        left.abs_diff(959 - right) <= 2 && top.abs_diff(719 - bottom) <= 2,
        "{left} {right} {top} {bottom}"
    );
    assert!(right - left < 800 && bottom - top < 500);
    let inside = |at: &usize| (left..=right).contains(&(at % 960)) && (top..=bottom).contains(&(at / 960));
    let is_text = |shot: &[u32]| {
        let green: Vec<_> = (0..shot.len()).filter(inside).map(|at| shot[at] >> 8 & 255).collect();
        let dark = green.iter().filter(|level| **level < 60).count();
        let light = green.iter().filter(|level| **level > 200).count();
        dark > green.len() * 3 / 4 && light > 2000
    };
    assert!(is_text(&help) && !is_text(&picture));
    desk.awaits("help at first", is_text);
    desk.press("t");
    desk.awaits("no help", |shot| !is_text(shot));
    for _ in 0..5 {
        desk.press("t");
    }
    desk.awaits("the picture", |shot| shot == picture);
    for keys in ["h", "F1", "question", "H", "question", "F1"].chunks(2) {
        desk.press(keys[0]);
        desk.awaits(keys[0], |shot| shot == help);
        desk.press(keys[1]);
        desk.awaits(keys[1], |shot| shot == picture);
    }

    // Every entry of the table is seen in the palette, the pixel's with a mark.
    desk.press("p");
    let want = drawn(&Overlay { palette: true, ..Overlay::default() });
    let shot = desk.awaits("palette", |shot| shot == want);
    let ([left, _], [_, bottom], _) = differing(&shot, &picture).unwrap();
    let corner = |at: &usize| at % 960 >= left && at / 960 <= bottom;
    for color in &palette {
        let seen = (0..shot.len()).filter(corner).filter(|at| shot[*at] == *color).count();
        assert!(seen >= 20 * 20 - 20, "{color:06x}: {seen}");
    }
    desk.press("p");
    desk.awaits("no palette", |shot| shot == picture);

    // The mouse tells a pixel: what the picture has there, and what `rta explain` says of it.
    for (x, y) in PIXELS {
        desk.point(3 * x as usize + 1, (y as usize * 720 + 719) / 200);
        let overlay = Overlay { pixel: Some((x, y)), ..Overlay::default() };
        let want = drawn(&overlay);
        desk.awaits("the pixel under the mouse", |shot| shot == want);
    }
    desk.press("i");
    desk.awaits("no pixel", |shot| shot == picture);
    for (x, y) in PIXELS {
        let index = indices[(y * 320 + x) as usize];
        let [_, r, g, b] = palette[usize::from(index)].to_be_bytes();
        let lines = show.describe(x, y);
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
    // Any key ends the help.
    desk.press("i");
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

#[test]
fn each_of_many_keys_at_once_is_told() {
    if !has_tools() {
        return;
    }
    let folder = Folder::new();
    let mut desk = Desk::new(&folder, "800x600", &["scene.dat", "--size", "16x10"]);
    let complete = Instant::now();
    while !desk.title().ends_with(" s") {
        assert!(complete.elapsed() < PATIENCE, "{}", desk.title());
    }
    desk.xdotool(&["key", "--delay", "0", "s", "F11", "s", "s", "t", "q"]);
    assert!(desk.program.wait().unwrap().success());
    let told = fs::read_to_string(folder.path("out.txt")).unwrap();
    let saved = told.lines().filter(|line| line.starts_with("saved rta-scene-")).count();
    assert_eq!(saved, 3, "{told}");
}
