//! The picture of `rta show` and what its keys do to it, without a window.

use core::time::Duration;
use std::time::Instant;

use rta::args::{FilmArgs, ShowArgs};
use rta::device::{Device, Target};
use rta::engine::{Engine, Format, Model, Settings};
use rta::picture::Pixels;
use rta::request::Request;
use rta::scene::Scene;
use rta::show::reload::Watch;
use rta::show::{Command, Show};
use rta_core::color::Rgb;
use rta_scenes::Reading;

use super::folder::Folder;

mod film;

fn show(scene: Scene) -> Show {
    let request = Request::of(&ShowArgs::default().tracing, Target::On(Device::Vga));
    let request = Request { size: Some("80x50".parse().expect("a size")), ..request };
    Show::new(scene, None, (request, FilmArgs::default()), Some(2)).expect("it begins")
}

fn complete(show: &mut Show) {
    let begun = Instant::now();
    while !show.is_complete() {
        show.advance(Duration::from_millis(5)).expect("the device takes it");
        assert!(begun.elapsed() < Duration::from_secs(120), "{}", show.title());
        std::thread::sleep(Duration::from_millis(1));
    }
}

fn pixels(show: &mut Show) -> Pixels {
    show.shown().expect("the device answers").picture().pixels.clone()
}

#[test]
fn keys_change_the_picture_and_back() {
    let mut show = show(Scene::juggler().expect("it is well formed"));
    complete(&mut show);
    assert!(
        show.title().contains("juggler | vga | f32 | rta | depth 5 | sampled, dither none | "),
        "{}",
        show.title()
    );
    let first = pixels(&mut show);
    // The key goes round in a circle.
    let others = Model::ALL.len() - 1;
    for (there, back, word) in [
        (vec![Command::Model], vec![Command::Model; others], "| whitted |"),
        (vec![Command::Table; 5], vec![Command::Table], "| uniform, "),
        (vec![Command::Dither], vec![Command::Dither; 3], ", dither fs |"),
        (vec![Command::Shallower; 5], vec![Command::Deeper; 5], "| depth 0 |"),
        (
            vec![Command::Format, Command::Model],
            [vec![Command::Format; 3], vec![Command::Model; others]].concat(),
            "| f64 |",
        ),
    ] {
        for (keys, away) in [(there, true), (back, false)] {
            for key in keys {
                show.obey(key);
            }
            complete(&mut show);
            assert_eq!(show.title().contains(word), away, "{}", show.title());
            assert_eq!(pixels(&mut show) != first, away, "{}", show.title());
        }
    }
}

#[test]
fn the_picture_of_the_window_is_that_of_render_with_and_without_a_device() {
    let folder = Folder::new();
    let scene = || Scene::open(&folder.path("scene.dat")).expect("it is well formed");
    let request = Request::of(&ShowArgs::default().tracing, Target::On(Device::Vga));
    let mut show = Show::new(scene(), None, (request, FilmArgs::default()), Some(2)).expect("it begins");
    for device in ["vga", "graphigs", "pixrect", "none"] {
        complete(&mut show);
        assert_eq!(show.request().target.to_string(), device);
        let mut ppm = Vec::new();
        let shown = show.shown().expect("the device answers");
        shown.picture().write_ppm(&mut ppm).expect("memory takes it");
        let size = shown.picture().size;
        let last = shown.color(size.columns() - 1, size.height() as usize - 1);
        assert!(ppm.ends_with(&[last.r, last.g, last.b]), "{device}");
        let options = ["scene.dat", "-o", "-", "--as", "ppm", "--device", device];
        assert!(ppm == folder.renders(&options), "{device}");
        show.obey(Command::Device);
    }
    assert_eq!(show.request().target, Target::On(Device::Vga));
}

#[test]
fn a_preview_is_the_picture_with_fewer_pixels() {
    let scene = Scene::juggler().expect("it is well formed").description;
    for format in Format::ALL.iter().copied() {
        let large = Settings { format, ..Settings::default() };
        let small = Settings { width: 40, height: 25, ..large.clone() };
        let [large, small] = [large, small].map(|settings| Engine::new(&scene, &settings).expect("it fits"));
        let (mut preview, mut picture) = (vec![Rgb::default(); 40 * 9], vec![Rgb::default(); 40 * 9]);
        let size = "40x25".parse().expect("a size");
        large.preview_rows(size, 16, 63, &mut preview).expect("a raster");
        small.level_rows(16, 63, &mut picture);
        assert_eq!(preview, picture, "{format}");
        assert!(preview.iter().any(|levels| *levels != preview[0]));
    }
}

#[test]
fn a_scene_read_again_states_its_size_anew() {
    let folder = Folder::new();
    let path = folder.path("scene.nff");
    let nff = |resolution: &str| {
        format!(
            "v\nfrom 0 -5 0\nat 0 0 0\nup 0 0 1\nangle 40\nhither 1\nresolution {resolution}\nl 5 -5 5\n\
             f 1 0 0 1 0 0 0 1\ns 0 0 0 1\n"
        )
    };
    folder.scene("scene.nff", nff("64 48"));
    let watch = Watch::new(&path, Reading::default());
    let scene = Scene::open(&path).expect("it is well formed");
    let request = Request::of_scene(&ShowArgs::default().tracing, Target::None, &scene).expect("a size");
    let mut show = Show::new(scene, Some(watch), (request, FilmArgs::default()), Some(2)).expect("it begins");
    folder.scene("scene.nff", nff("32 48"));
    show.obey(Command::Reload);
    assert_eq!(show.visible_note(), None);
    complete(&mut show);
    assert_eq!(show.request().raster().expect("a size").0.to_string(), "32x48");
    // What cannot be read leaves everything as it was.
    folder.scene("scene.nff", "v\nfrom 0 -5");
    show.obey(Command::Reload);
    assert!(show.visible_note().is_some_and(|note| note.contains("scene.nff")), "{}", show.title());
    assert!(show.is_complete());
    assert_eq!(show.request().raster().expect("a size").0.to_string(), "32x48");
}

#[test]
fn a_scene_is_read_again_as_it_was_read() {
    let folder = Folder::new();
    let path = folder.path("scene.nff");
    let nff =
        "v\nfrom 0 -5 0\nat 0 0 0\nup 0 0 1\nangle 40\nhither 1\nresolution 16 16\nunheard of\ns 0 0 0 1\n";
    folder.scene("scene.nff", nff);
    let reading = Reading { lenient: true, ..Reading::default() };
    let scene = Scene::open_as(&path, reading).expect("an unknown line is passed over");
    let request = Request::of_scene(&ShowArgs::default().tracing, Target::None, &scene).expect("a size");
    let mut show =
        Show::new(scene, Some(Watch::new(&path, reading)), (request, FilmArgs::default()), Some(1))
            .expect("it begins");
    show.obey(Command::Reload);
    assert_eq!(show.visible_note(), None);
}

#[test]
fn a_key_does_not_wait_for_the_picture() {
    let mut show = show(Scene::juggler().expect("it is well formed"));
    show.obey(Command::Device);
    assert_eq!((show.request().target, show.request().size), (Target::On(Device::Graphigs), None));
    for _ in 0..50 {
        show.obey(Command::Reload);
    }
    show.obey(Command::Device);
    show.obey(Command::Device);
    assert_eq!(show.request().target, Target::None);
    show.obey(Command::Device);
    assert_eq!(show.request().target, Target::On(Device::Vga));
    complete(&mut show);
}

#[test]
fn depth_stays_within_its_limits() {
    let mut show = show(Scene::juggler().expect("it is well formed"));
    for _ in 0..40 {
        show.obey(Command::Deeper);
    }
    assert_eq!(show.request().depth, rta::engine::MAX_DEPTH);
    for _ in 0..40 {
        show.obey(Command::Shallower);
    }
    assert_eq!(show.request().depth, 0);
}

#[test]
fn what_does_not_fit_is_told_and_everything_stays() {
    let mut scene = Scene::juggler().expect("it is well formed");
    for sphere in scene.description.spheres.iter_mut().take(1) {
        sphere.position = [1e6, 0.0, 0.0];
    }
    let mut show = show(scene);
    show.obey(Command::Format);
    complete(&mut show);
    let before = pixels(&mut show);
    show.obey(Command::Format);
    assert_eq!(show.request().format, Format::F64);
    assert!(show.title().contains("sphere 1"), "{}", show.title());
    assert_eq!(pixels(&mut show), before);
    show.obey(Command::Model);
    assert_eq!(show.request().model, Model::Whitted);
    assert!(!show.title().contains("sphere 1"));
}
