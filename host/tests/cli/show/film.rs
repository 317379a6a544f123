//! Films of `rta show`: the frames that are seen, and what the keys do to them.

use core::time::Duration;
use std::fs;
use std::time::Instant;

use rta::args::{FilmArgs, ShowArgs};
use rta::device::{Device, Target};
use rta::engine::Model;
use rta::request::Request;
use rta::scene::Scene;
use rta::show::reload::Watch;
use rta::show::{Command, Show};
use rta_scenes::Reading;

use super::super::film::SCENE;
use super::super::folder::{Folder, decoder};
use super::complete;

/// Frames of the films here.
const FRAMES: u32 = 3;

/// Their instants, as the command line has them.
const INSTANTS: [&str; 3] = ["0", "0.3333333333333333", "0.6666666666666666"];

/// The picture on each device, and without one.
const ON: [[&str; 4]; 3] = [
    ["--size", "40x25", "--device", "vga"],
    ["--size", "48x48", "--device", "graphigs"],
    ["--size", "40x25", "--device", "none"],
];

/// What those devices are.
const ALL: [Target; 3] = [Target::On(Device::Vga), Target::On(Device::Graphigs), Target::None];

/// Fifty frames in a second, so that no test waits for long.
const FILM: FilmArgs = FilmArgs { frames: Some(FRAMES), rate: 50, one_table: false };

fn film() -> Folder {
    let folder = Folder::new();
    folder.scene("film.rta", SCENE);
    folder
}

fn show_on(folder: &Folder, on: &[&str; 4], film: FilmArgs) -> Show {
    let path = folder.path("film.rta");
    let watch = Watch::new(&path, Reading::default());
    let scene = Scene::open(&path).expect("it is well formed");
    let target = ALL.into_iter().find(|target| target.to_string() == on[3]).expect("a device");
    let request = Request::of_scene(&ShowArgs::default().tracing, target, &scene).expect("it is sound");
    let request = Request { size: Some(on[1].parse().expect("a size")), ..request };
    Show::new(scene, Some(watch), (request, film), Some(2)).expect("it begins")
}

fn show(folder: &Folder) -> Show {
    show_on(folder, &ON[0], FILM)
}

fn number(show: &Show) -> u32 {
    show.film().number().expect("it is a film")
}

fn ppm(show: &mut Show) -> Vec<u8> {
    let mut ppm = Vec::new();
    show.shown().expect("the device answers").picture().write_ppm(&mut ppm).expect("memory takes it");
    ppm
}

/// All frames, one after the other, and the film pauses.
fn frames(show: &mut Show) -> Vec<Vec<u8>> {
    complete(show);
    let mut frames = vec![Vec::new(); FRAMES as usize];
    for _ in 0..FRAMES {
        show.obey(Command::Next);
        frames[number(show) as usize] = ppm(show);
    }
    frames
}

/// The picture that `rta render` makes of each instant.
fn rendered(folder: &Folder, options: &[&str]) -> Vec<Vec<u8>> {
    let render = |instant| {
        folder.renders(&[&["film.rta", "-o", "-", "--as", "ppm", "--instant", instant], options].concat())
    };
    INSTANTS.iter().map(|instant| render(*instant)).collect()
}

#[test]
fn frames_that_are_seen_are_pictures_of_their_instants() {
    let folder = film();
    for on in &ON {
        let frames = frames(&mut show_on(&folder, on, FILM));
        assert!(frames[0] != frames[1] && frames[1] != frames[2], "{on:?}");
        assert!(frames == rendered(&folder, on), "{on:?}");
    }
}

#[test]
fn a_table_of_all_frames_is_that_of_render() {
    let folder = film();
    for table in [Command::Table, Command::Device] {
        let mut show = show_on(&folder, &ON[0], FilmArgs { one_table: true, ..FILM });
        if table == Command::Table {
            // From the table of the picture to the one that grows as it is drawn.
            (0..4).for_each(|_| show.obey(Command::Table));
        }
        let name = show.request().coloring.table.to_string();
        let options = ["--frames", "3", "--one-table", "--table", &name];
        let film =
            folder.renders(&[&["film.rta", "-o", "-", "--as", "ppm"], &options[..], &ON[0][..]].concat());
        assert!(frames(&mut show).concat() == film, "{name}");
    }
}

#[test]
fn what_is_seen_while_frames_are_traced_is_a_complete_one() {
    let folder = film();
    let mut show = show(&folder);
    let want = rendered(&folder, &ON[0]);
    let (begun, mut last) = (Instant::now(), 0);
    while !show.is_complete() {
        // A part at a time.
        show.advance(Duration::ZERO).expect("the device takes it");
        assert!(begun.elapsed() < Duration::from_secs(120), "{}", show.title());
        assert_eq!(show.title().contains("tracing"), show.film().has_picture() && !show.is_complete());
        if show.film().has_picture() {
            let seen = number(&show);
            assert!(seen == last || seen == last + 1, "{last} {seen}");
            assert!(ppm(&mut show) == want[seen as usize], "{}", show.title());
            last = seen;
        }
    }
    assert_eq!(last, FRAMES - 1);
}

#[test]
fn once_traced_the_film_is_shown_from_memory_again_and_again() {
    let mut show = show(&film());
    complete(&mut show);
    let mut places = [None; FRAMES as usize];
    let (begun, mut changes, mut last) = (Instant::now(), 0, number(&show));
    let time = |show: &Show| show.title().rsplit(" | ").next().map(String::from);
    let took = time(&show);
    while changes < 4 * FRAMES {
        assert!(begun.elapsed() < Duration::from_secs(120), "{}", show.title());
        let is_new = show.advance(Duration::ZERO).expect("nothing is drawn on a device");
        assert!(!show.film().is_tracing() && show.film().is_playing());
        let seen = number(&show);
        assert_eq!(is_new, seen != last);
        assert!(show.title().contains(&format!("frame {seen}/{FRAMES} | ")), "{}", show.title());
        changes += u32::from(seen != last);
        last = seen;
        // The very picture that was kept.
        let place = core::ptr::from_ref(show.shown().expect("nothing is read back")) as usize;
        assert_eq!(*places[seen as usize].get_or_insert(place), place);
    }
    assert!(places.iter().all(Option::is_some));
    // Not sooner than at the rate that was asked for.
    assert!(begun.elapsed() >= Duration::from_millis(20) * (4 * FRAMES - 2));
    assert_eq!(time(&show), took);
}

#[test]
fn a_film_pauses_and_goes_step_by_step_round() {
    let mut show = show(&film());
    complete(&mut show);
    for (command, want) in
        [(Command::Next, 1), (Command::Next, 2), (Command::Next, 0), (Command::Previous, 2)]
    {
        if want == 1 {
            // From the first frame on, wherever it was.
            while number(&show) != 0 {
                show.obey(Command::Previous);
            }
        }
        show.obey(command);
        assert_eq!(number(&show), want);
        assert!(show.title().contains(&format!("frame {want}/{FRAMES}, paused | ")), "{}", show.title());
        std::thread::sleep(Duration::from_millis(45));
        assert!(!show.advance(Duration::ZERO).expect("nothing to do") && number(&show) == want);
    }
    show.obey(Command::Pause);
    assert!(!show.title().contains("paused"));
    let begun = Instant::now();
    while number(&show) == 2 {
        show.advance(Duration::ZERO).expect("nothing to do");
        assert!(begun.elapsed() < Duration::from_secs(120));
    }
    show.obey(Command::Pause);
    assert!(show.title().contains("paused"));
}

#[test]
fn keys_begin_the_film_anew() {
    let folder = film();
    let mut show = show(&folder);
    complete(&mut show);
    show.obey(Command::Next);
    for (commands, options) in [
        (vec![Command::Model], vec!["--model", "whitted"]),
        (vec![Command::Model; Model::ALL.len() - 1], vec![]),
        (vec![Command::Shallower; 5], vec!["--depth", "0"]),
        (vec![Command::Format], vec!["--depth", "0", "--format", "f64"]),
        (vec![Command::Dither], vec!["--depth", "0", "--format", "f64", "--dither", "fs"]),
    ] {
        for command in commands {
            show.obey(command);
        }
        assert!(number(&show) == 0 && !show.title().contains("paused"), "{}", show.title());
        assert!(frames(&mut show) == rendered(&folder, &[&ON[0][..], &options].concat()), "{options:?}");
    }
}

#[test]
fn a_scene_that_is_read_again_begins_anew_and_a_broken_one_does_not() {
    let folder = film();
    let mut show = show(&folder);
    complete(&mut show);
    folder.scene("film.rta", SCENE.replace("color .9 .2 .1", "color .1 .2 .9"));
    show.obey(Command::Reload);
    assert!(!show.film().has_picture() && number(&show) == 0);
    let want = rendered(&folder, &ON[0]);
    assert!(frames(&mut show) == want);
    folder.scene("film.rta", "rta 1\nsphere");
    show.obey(Command::Reload);
    assert!(show.visible_note().is_some_and(|note| note.contains("film.rta")), "{}", show.title());
    assert!(show.is_complete() && frames(&mut show) == want);
}

#[test]
fn a_frame_that_cannot_be_traced_is_told_and_those_before_it_stay() {
    let folder = film();
    folder.scene("film.rta", SCENE.replace("at .5 0 0 2", "at .5 0 0 99999"));
    let mut show = show_on(&folder, &ON[0], FilmArgs { frames: Some(4), ..FILM });
    show.obey(Command::Format);
    show.obey(Command::Format);
    let begun = Instant::now();
    while show.film().is_tracing() {
        show.advance(Duration::from_millis(5)).expect("the device takes it");
        assert!(begun.elapsed() < Duration::from_secs(120), "{}", show.title());
    }
    let note = show.visible_note().expect("an error").to_owned();
    assert!(note.contains("the instant 0.") && note.contains("q16"), "{note}");
    assert!(show.film().has_picture() && !show.is_complete());
    assert!(show.title().contains("there is no frame "), "{}", show.title());
}

#[test]
fn a_pixel_is_told_as_it_is_in_the_frame_that_is_seen() {
    let folder = film();
    let mut show = show(&folder);
    complete(&mut show);
    for _ in 0..2 * FRAMES {
        show.obey(Command::Next);
        let instant = f64::from(number(&show)) / f64::from(FRAMES);
        let scene = Scene::open(&folder.path("film.rta")).expect("it is well formed").at(instant);
        let request = (show.request().clone(), FilmArgs::default());
        let mut still = Show::new(scene, None, request, Some(1)).expect("it begins");
        complete(&mut still);
        for (x, y) in [(20, 12), (14, 9), (3, 24), (30, 2)] {
            still.shown().expect("the device answers");
            assert_eq!(show.describe(x, y), still.describe(x, y), "{instant}");
        }
    }
}

#[test]
fn a_film_that_memory_does_not_hold_is_refused() {
    let folder = film();
    let scene = Scene::open(&folder.path("film.rta")).expect("it is well formed");
    let long = FilmArgs { frames: Some(65_535), ..FILM };
    let request = Request::of(&ShowArgs::default().tracing, Target::None);
    let error = Show::new(scene, None, (request, long), Some(1)).err().expect("too much").to_string();
    assert!(error.contains("65535 frames of 320x200 take 12000 MiB"), "{error}");
    // A key that would make it too large leaves everything as it was.
    let mut show = show_on(&folder, &ON[0], FilmArgs { frames: Some(4000), ..FILM });
    show.obey(Command::Device);
    assert!(show.visible_note().is_some_and(|note| note.contains("4000 frames of 1024x1024")));
    assert_eq!(show.request().target.to_string(), "vga");
}

#[test]
fn one_picture_has_no_frames() {
    let folder = film();
    let mut show = show_on(&folder, &ON[0], FilmArgs::default());
    complete(&mut show);
    for command in [Command::Pause, Command::Next, Command::Previous] {
        show.obey(command);
        assert!(show.visible_note().is_some_and(|note| note.contains("--frames")));
    }
    assert!(!show.title().contains("frame 0") && show.film().number().is_none());
    // A film in which nothing moves has the same picture again and again.
    folder.scene("film.rta", SCENE.replace("  along across", "").replace("  along round", ""));
    let mut show = self::show(&folder);
    let frames = frames(&mut show);
    assert!(frames[0] == frames[1] && frames[1] == frames[2]);
}

#[test]
fn without_a_display_the_film_is_written_as_render_writes_it() {
    let folder = film();
    let options = ["film.rta", "--frames", "3", "--rate", "25", "--size", "40x25"];
    let told = folder.prints(&[&["show"], &options[..]].concat());
    assert!(told.ends_with("so the film is in ./rta-film-vga.png\n"), "{told}");
    folder.renders(&[&options[..], &["-o", "want.png"]].concat());
    let read = |name| fs::read(folder.path(name)).expect("it is there");
    assert!(read("rta-film-vga.png") == read("want.png"));
    let told = folder.prints(&["show", "film.rta", "--instant", ".5", "--size", "40x25"]);
    assert!(told.ends_with("so the picture is in ./rta-film-vga-2.png\n"), "{told}");
    folder.renders(&["film.rta", "--instant", ".5", "--size", "40x25", "-o", "want.png"]);
    assert!(read("rta-film-vga-2.png") == read("want.png"));
    // Without a scene, the Juggler juggles.
    folder.prints(&["show", "--frames", "2", "--size", "16x10"]);
    assert_eq!(
        decoder(&folder.path("rta-juggler-vga.png")).info().animation_control.expect("a film").num_frames,
        2
    );
}
