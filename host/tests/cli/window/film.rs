//! A film in the window.

use std::fs;
use std::time::Instant;

use super::desk::{Desk, PATIENCE, has_tools};
use super::{enlarged, rendered_as};
use crate::film::SCENE;
use crate::folder::Folder;

/// Waits until the title is as `want` says.
fn title(desk: &Desk, want: impl Fn(&str) -> bool) -> String {
    let begun = Instant::now();
    loop {
        let title = desk.title();
        if want(&title) {
            return title;
        }
        assert!(begun.elapsed() < PATIENCE, "{title}");
    }
}

#[test]
fn a_film_goes_round_stands_still_and_its_frame_is_saved() {
    if !has_tools() {
        return;
    }
    let folder = Folder::new();
    folder.scene("film.rta", SCENE);
    let instants = ["0", "0.3333333333333333", "0.6666666666666666"];
    let frame = |instant| enlarged(&rendered_as(&folder, &["film.rta", "--instant", instant]));
    let frames = instants.map(frame);
    // Slow enough for screenshots.
    let mut desk = Desk::new(&folder, "1280x1000", &["film.rta", "--frames", "3", "--rate", "1"]);
    // Any key ends the help.
    desk.press("i");
    title(&desk, |title| title.ends_with(" s"));
    for frame in frames.iter().chain(&frames) {
        desk.awaits("a frame of the film", |shot| shot == frame);
    }
    desk.press("space");
    let paused = title(&desk, |title| title.contains("paused"));
    let seen = (0..3).find(|number| paused.contains(&format!("frame {number}/3"))).unwrap();
    desk.awaits("the frame of the title", |shot| shot == frames[seen]);
    desk.press("period");
    desk.awaits("the next one", |shot| shot == frames[(seen + 1) % 3]);
    for key in ["Left", "comma"] {
        desk.press(key);
    }
    let before = (seen + 2) % 3;
    desk.awaits("the one before", |shot| shot == frames[before]);
    desk.press("s");
    let name = format!("rta-film-vga-frame-{before}.png");
    let told = || fs::read_to_string(folder.path("out.txt")).unwrap();
    desk.awaits("a word about the file", |_| told() == format!("saved {name}\n"));
    rendered_as(&folder, &["film.rta", "--instant", instants[before]]);
    let files = [&name, "want.png"].map(|name| fs::read(folder.path(name)).unwrap());
    assert!(files[0] == files[1], "the frame is not that of rta render");
    desk.press("space");
    title(&desk, |title| !title.contains("paused"));
    desk.press("q");
    assert!(desk.program.wait().unwrap().success());
}
