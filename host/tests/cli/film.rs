//! Films: each frame is the picture of its instant.

use std::fs;

use super::folder::{Folder, decoder};

/// A scene in which a lamp, a ball and the eye move.
pub(super) const SCENE: &str = "\
rta 1
path across linear  at 0 -2 0 0  at 1 2 0 0
path round  at 0 0 0 0  at .25 1 0 1  at .5 0 0 2  at .75 -1 0 1  at 1 0 0 0
camera at 0 -8 2  to 0 0 1  along across
sky horizon .8 .87 .97  zenith .15 .3 .65
floor .9 .9 .9  .1 .1 .1
lamp at -5 -6 8  power 75  along across
ambient grey .25
sphere at 0 0 1  radius 1  color .9 .2 .1  of shiny  along round
sphere at 2 1 1  radius 1  of mirror
";

/// Sizes and devices of the films, and how they are dithered.
const ON: [[&str; 4]; 2] =
    [["--size", "40x25", "--device", "vga"], ["--size", "48x48", "--device", "graphigs"]];

/// The colour table and the indices of the picture of an instant.
fn still(folder: &Folder, instant: &str, on: &[&str]) -> (Vec<u8>, Vec<u8>) {
    folder.renders(&[&["film.rta", "-o", "still.png", "--instant", instant], on].concat());
    let mut reader = decoder(&folder.path("still.png"));
    let mut indices = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut indices).unwrap();
    (reader.info().palette.as_ref().expect("a colour table").to_vec(), indices)
}

/// Returns the registers of pixels by their indices.
fn registers((palette, indices): &(Vec<u8>, Vec<u8>)) -> Vec<u8> {
    let colors = palette.as_chunks::<3>().0;
    indices.iter().flat_map(|index| colors[usize::from(*index)]).collect()
}

fn film() -> Folder {
    let folder = Folder::new();
    folder.scene("film.rta", SCENE);
    folder
}

#[cfg(feature = "image")]
fn gif(folder: &Folder, name: &str) -> gif::Decoder<std::io::Cursor<Vec<u8>>> {
    gif::DecodeOptions::new().read_info(std::io::Cursor::new(fs::read(folder.path(name)).unwrap())).unwrap()
}

#[test]
#[cfg(feature = "image")]
fn a_frame_of_a_gif_is_the_picture_of_its_instant_with_its_table() {
    let folder = film();
    for on in &ON {
        folder.renders(&[&["film.rta", "-o", "film.gif", "--frames", "4", "--rate", "10"], &on[..]].concat());
        let mut film = gif(&folder, "film.gif");
        assert_eq!(film.repeat(), gif::Repeat::Infinite);
        for instant in ["0", ".25", ".5", ".75"] {
            let (palette, indices) = still(&folder, instant, on);
            let frame = film.read_next_frame().unwrap().expect("a frame");
            assert_eq!((frame.delay, &frame.buffer[..]), (10, &indices[..]), "{on:?} {instant}");
            // A GIF has as many entries as a power of two.
            let table = frame.palette.as_ref().expect("its own table");
            assert_eq!(&table[..palette.len()], &palette[..], "{on:?} {instant}");
        }
        assert!(film.read_next_frame().unwrap().is_none());
    }
}

#[test]
fn frames_of_other_films_are_pictures_of_their_instants() {
    let folder = film();
    let on = &ON[0];
    folder.renders(&[&["film.rta", "-o", "film.png", "--frames", "3", "--rate", "25"], &on[..]].concat());
    folder.renders(&[&["film.rta", "-o", "film.ppm", "--frames", "3"], &on[..]].concat());
    let mut film = decoder(&folder.path("film.png"));
    let control = film.info().animation_control.expect("it is animated");
    assert_eq!((control.num_frames, control.num_plays), (3, 0));
    let mut all = Vec::new();
    for instant in ["0", "0.3333333333333333", "0.6666666666666666"] {
        let want = registers(&still(&folder, instant, on));
        let mut got = vec![0; film.output_buffer_size().unwrap()];
        film.next_frame(&mut got).unwrap();
        let shown = film.info().frame_control.expect("the time of a frame");
        assert_eq!((shown.delay_num, shown.delay_den), (1, 25));
        assert_eq!(got, want, "{instant}");
        all.extend([&b"P6\n40 25\n255\n"[..], &want].concat());
    }
    assert!(fs::read(folder.path("film.ppm")).unwrap() == all);
}

#[test]
#[cfg(feature = "image")]
fn one_table_is_that_of_all_frames() {
    let folder = film();
    for table in ["sampled", "adaptive", "uniform"] {
        let options = ["--frames", "3", "--one-table", "--table", table];
        for name in ["film.gif", "film.png"] {
            folder.renders(&[&["film.rta", "-o", name], &options[..], &ON[0][..]].concat());
        }
        let mut film = gif(&folder, "film.gif");
        let global = film.global_palette().expect("a table of the file").to_vec();
        let mut reader = decoder(&folder.path("film.png"));
        let palette = reader.info().palette.as_ref().expect("a table").to_vec();
        assert_eq!(&global[..palette.len()], &palette[..], "{table}");
        let mut frames = Vec::new();
        while let Some(frame) = film.read_next_frame().unwrap() {
            assert!(frame.palette.is_none(), "{table}");
            let mut indices = vec![0; reader.output_buffer_size().unwrap()];
            reader.next_frame(&mut indices).unwrap();
            assert!(frame.buffer[..] == indices[..], "{table}");
            frames.push(indices);
        }
        assert!(frames.len() == 3 && frames[0] != frames[1] && frames[1] != frames[2], "{table}");
        if table == "uniform" {
            assert_eq!(
                (palette, frames.remove(0)),
                still(&folder, "0", &[&ON[0][..], &["--table", table]].concat())
            );
        }
    }
}

#[test]
fn what_is_no_film_is_refused() {
    let folder = film();
    let render = |rest: &[&'static str]| [&["render", "film.rta"], rest].concat();
    folder.refuses(&render(&["-o", "a.pfm", "--device", "none", "--frames", "2"]), &["PFM", "one picture"]);
    folder.refuses(&render(&["-o", "a.png", "--frames", "0"]), &["--frames", "1 to 65535"]);
    folder.refuses(&render(&["-o", "a.png", "--frames", "2", "--rate", "51"]), &["--rate", "1 to 50"]);
    folder.refuses(&render(&["-o", "a.png", "--frames", "2", "--instant", "0"]), &["--instant"]);
    folder.refuses(&render(&["-o", "a.png", "--instant", "1.5"]), &["--instant", "from 0 to 1"]);
    folder.refuses(&render(&["-o", "a.png", "--instant", "nan"]), &["--instant", "from 0 to 1"]);
    folder.refuses(&render(&["-o", "a.png", "--one-table"]), &["--frames"]);
    #[cfg(feature = "image")]
    folder.refuses(&render(&["-o", "a.gif", "--device", "none"]), &["GIF", "colour table"]);
    // In the middle of its film the ball is beyond what the format holds.
    let far = "at .5 0 0 2";
    assert!(SCENE.contains(far));
    folder.scene("film.rta", SCENE.replace(far, "at .5 0 0 99999"));
    folder.refuses(
        &render(&["-o", "a.png", "--frames", "2", "--format", "q16", "--size", "9x9"]),
        &["frame 1", "the instant 0.5", "q16"],
    );
}

#[test]
fn the_jugglers_film_begins_with_the_juggler() {
    let folder = Folder::new();
    folder.scene("juggler.rta", rta_scenes::shipped::JUGGLING);
    folder.scene("juggler.dat", rta_scenes::shipped::JUGGLER);
    let hash = |name| folder.prints(&["hash", name, "--size", "64x40"]).split(' ').next().map(str::to_owned);
    assert_eq!(hash("juggler.rta"), hash("juggler.dat"));
    folder.prints(&["juggle", "--quiet", "-o", "j.png", "--size", "32x20"]);
    assert_eq!(decoder(&folder.path("j.png")).info().animation_control.expect("a film").num_frames, 24);
}
