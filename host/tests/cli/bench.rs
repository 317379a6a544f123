//! `rta bench` from outside, instructions included where valgrind is installed.

use std::fs;
use std::process::{Command, Stdio};

use super::folder::Folder;

/// The cells of a table's rows below its head, by the names in the head.
fn rows(text: &str) -> Vec<Vec<(String, String)>> {
    let cells = |line: &str| -> Vec<String> {
        line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect()
    };
    let mut lines = text.lines().take_while(|line| line.starts_with('|'));
    let head = cells(lines.next().expect("a head"));
    assert!(lines.next().expect("a rule").starts_with("| --"));
    let named = |line| head.iter().cloned().zip(cells(line)).collect();
    lines.map(named).collect()
}

fn cell<'a>(row: &'a [(String, String)], name: &str) -> &'a str {
    let cell = row.iter().find(|(head, _)| head == name);
    &cell.unwrap_or_else(|| panic!("no {name} in {row:?}")).1
}

fn is_installed(program: &str) -> bool {
    let asked = Command::new(program).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    asked.is_ok_and(|status| status.success())
}

#[test]
fn a_tiny_picture_is_a_row_with_its_rays() {
    let folder = Folder::new();
    let tiny = ["bench", "scene.dat", "--size", "8x5", "--runs", "2", "--scaling", "--no-instructions"];
    let text = folder.prints(&tiny);
    let rows = rows(&text);
    let [row] = rows.as_slice() else { panic!("{text}") };
    for (name, value) in [
        ("scene", "scene"),
        ("format", "f32"),
        ("raster", "8x5"),
        ("objects", "4"),
        ("primary", "40"),
        ("instructions a ray", "-"),
    ] {
        assert_eq!(cell(row, name), value, "{name} in {text}");
    }
    for name in ["reflected", "shadow", "ns a ray"] {
        assert!(cell(row, name).parse::<u64>().unwrap() > 0, "{name} in {text}");
    }
    assert!(text.contains("| ms with 2 threads |") && !text.contains("Random spheres"), "{text}");
    // Fewer rays at less depth; the instructions of another run are the same.
    let flat = folder.prints(&["bench", "scene.dat", "--size", "8x5", "--depth", "0", "--format", "q16"]);
    let again = folder.prints(&["bench", "scene.dat", "--size", "8x5", "--depth", "0", "--format", "q16"]);
    let [flat, again] = [&flat, &again].map(|text| self::rows(text));
    assert_eq!((cell(&flat[0], "format"), cell(&flat[0], "reflected")), ("q16", "0"));
    let counted = cell(&flat[0], "instructions a ray");
    assert_eq!(counted, cell(&again[0], "instructions a ray"));
    if is_installed("valgrind") {
        assert!(counted.parse::<u64>().unwrap() > 100, "{counted}");
    }
}

#[test]
fn what_cannot_be_measured_is_said() {
    let folder = Folder::new();
    folder.refuses(&["bench", "none.dat"], &["none.dat", "No such file"]);
    folder.scene("bad.dat", "0 -10");
    folder.refuses(&["bench", "scene.dat", "bad.dat", "--size", "2x2", "--runs", "1"], &["bad.dat"]);
    folder.refuses(&["bench", "--check", "none.csv"], &["cannot read none.csv"]);
    folder.scene("bad.csv", "scene,format\n");
    folder.refuses(&["bench", "--check", "bad.csv"], &["bad.csv", "names no compiler"]);
    for usage in [
        ["bench", "scene.dat", "--record", "x.csv"],
        ["bench", "--record", "x.csv", "--check"],
        ["bench", "scene.dat", "--runs", "0"],
        ["bench", "scene.dat", "--peer", "nobody"],
        ["bench", "--scaling", "--check", "x.csv"],
    ] {
        let ended = folder.rta(&usage);
        assert!(ended.status.code() == Some(2) && ended.stdout.is_empty(), "{usage:?}");
    }
    assert!(!folder.names().contains(&"x.csv".to_owned()));
}

#[test]
fn a_peer_that_is_not_there_is_an_error() {
    let folder = Folder::new();
    let asked =
        ["bench", "scene.dat", "--size", "8x5", "--runs", "1", "--no-instructions", "--peer", "povray"];
    let ended = folder.command(&asked).env("PATH", "/nowhere").output().unwrap();
    let said = String::from_utf8(ended.stderr).unwrap();
    assert!(ended.status.code() == Some(2) && said.contains("povray cannot be started"), "{said}");
    if is_installed("povray") {
        let text = folder.prints(&asked);
        let rows = rows(&text);
        // As many of the eye's rays at least.
        assert!(cell(&rows[0], "its rays").parse::<u64>().unwrap() >= 40, "{text}");
    }
}

/// A floor below a lamp.
const ROOM: &str = "\
rta 1
picture 8 8  screen 1 1
camera at 1 -3 1  look 0 1 0  lens 1
model lambert
material light  emits 6 6 6
quad 0 0 0  2 0 0  2 2 0  0 2 0  patches 2 2  color .7 .7 .7
quad .5 .5 2  .5 1.5 2  1.5 1.5 2  1.5 .5 2  color .5 .5 .5  of light
quad 0 2 0  2 2 0  2 2 2  0 2 2  patches 2 2  color .7 .7 .7
";

#[test]
fn a_room_is_lit_beside_the_peers_radiosity() {
    let folder = Folder::new();
    folder.scene("room.rta", ROOM);
    let asked = ["bench", "room.rta", "--light", "--peer", "povray", "--runs", "1", "--no-instructions"];
    let ended = folder.command(&asked).env("PATH", "/nowhere").output().unwrap();
    let said = String::from_utf8(ended.stderr).unwrap();
    assert!(ended.status.code() == Some(2) && said.contains("povray cannot be started"), "{said}");
    assert_eq!(folder.rta(&["bench", "room.rta", "--light"]).status.code(), Some(2), "beside whom?");
    if is_installed("povray") {
        let text = folder.prints(&asked);
        let rows = rows(text.strip_prefix("room, 8x8:\n\n").expect("a title"));
        let [ours, theirs] = ["rta", "povray"]
            .map(|program| rows.iter().filter(|row| cell(row, "program") == program).count());
        assert_eq!((ours, theirs), (13, 6), "{text}");
        // Both draw the room as bright as the paths do.
        let good = |program: &str| {
            rows.iter().filter(|row| cell(row, "program") == program).any(|row| {
                let number = |name: &str| cell(row, name).parse::<f64>().unwrap();
                (number("factor") - 1.0).abs() < 0.1 && number("RMSE") < 0.025
            })
        };
        assert!(good("rta") && good("povray"), "{text}");
    }
}

/// A ball under a lamp that is one.
const SOFT: &str = "\
rta 1
model lambert
camera at 0 -7 3  to 0 0 .5  lens 1.3
sky grey .1
ambient black
floor grey .9 grey .9
lamp at -2 -2 6  radius 1  power 20  square
sphere at 0 0 .8  radius .8  color .9 .35 .2
";

#[test]
fn soft_shadows_are_set_beside_the_peers() {
    let folder = Folder::new();
    folder.scene("soft.rta", SOFT);
    folder.scene("still.rta", SOFT.replace("radius 1", "radius 0"));
    let asked = |scene| {
        ["bench", scene, "--spread", "--peer", "povray", "--size", "12x9", "--runs", "1", "--no-instructions"]
    };
    folder.refuses(&asked("still.rta"), &["still", "nothing is spread"]);
    let ended = folder.command(&asked("soft.rta")).env("PATH", "/nowhere").output().unwrap();
    let said = String::from_utf8(ended.stderr).unwrap();
    assert!(ended.status.code() == Some(2) && said.contains("povray cannot be started"), "{said}");
    if is_installed("povray") {
        let text = folder.prints(&asked("soft.rta"));
        let rows = rows(text.strip_prefix("soft, 12x9:\n\n").expect("a title"));
        let errors = |program: &str| -> Vec<f64> {
            let own = rows.iter().filter(|row| cell(row, "program") == program);
            own.map(|row| cell(row, "RMSE").parse().unwrap()).collect()
        };
        let (ours, theirs) = (errors("rta"), errors("povray"));
        assert_eq!((ours.len(), theirs.len()), (10, 5), "{text}");
        // From few samples to many, towards pictures that are nearly one.
        assert!(ours[9] < ours[0] / 2.0 && theirs[4] < 0.02, "{text}");
        let apart = text.lines().last().and_then(|line| line.strip_suffix(" apart.")?.split(' ').next_back());
        assert!(apart.expect("a number").parse::<f64>().unwrap() < 0.03, "{text}");
    }
}

#[test]
fn paths_are_followed_beside_mitsubas() {
    let folder = Folder::new();
    folder.scene("room.rta", ROOM);
    let asked = ["bench", "room.rta", "--light", "--peer", "mitsuba", "--runs", "1"];
    let ended = folder.command(&asked).env("PATH", "/nowhere").output().unwrap();
    let said = String::from_utf8(ended.stderr).unwrap();
    assert!(ended.status.code() == Some(2) && said.contains("python3 cannot be started"), "{said}");
    let python = Command::new("python3").args(["-c", "import mitsuba"]).stderr(Stdio::null()).status();
    if python.is_ok_and(|status| status.success()) {
        let text = folder.prints(&asked);
        let rows = rows(text.strip_prefix("room, 8x8, paths:\n\n").expect("a title"));
        assert_eq!(rows.len(), 6, "{text}");
        for row in rows.iter().filter(|row| cell(row, "samples") == "64") {
            // Both have one unit of light.
            let number = |name: &str| cell(row, name).parse::<f64>().unwrap();
            assert!((number("factor") - 1.0).abs() < 0.05 && number("RMSE") < 0.025, "{text}");
        }
    } else if is_installed("python3") {
        let ended = folder.rta(&asked);
        let said = String::from_utf8(ended.stderr).unwrap();
        assert!(ended.status.code() == Some(2) && said.contains("mitsuba is not installed"), "{said}");
    }
}

#[test]
fn instructions_are_recorded_and_checked() {
    let folder = Folder::new();
    let check = ["bench", "--check", "now.csv", "--size", "8x5"];
    if !is_installed("valgrind") {
        folder.refuses(&["bench", "--record", "now.csv", "--size", "8x5"], &["valgrind cannot be started"]);
        return;
    }
    folder.prints(&["bench", "--record", "now.csv", "--size", "8x5"]);
    let recorded = fs::read_to_string(folder.path("now.csv")).unwrap();
    assert_eq!(recorded.lines().count(), 2 + 4 * 2, "{recorded}");
    assert!(folder.prints(&check).starts_with("no picture takes over 5 % more"));
    // A tenth less was recorded in one row: now it is dearer. A tenth more: now it is cheaper.
    let scaled = |part: u64| {
        let line = recorded.lines().find(|line| line.starts_with("hall-22,q16,")).unwrap();
        let mut cells: Vec<_> = line.split(',').map(str::to_owned).collect();
        cells[3] = (cells[3].parse::<u64>().unwrap() * part / 10).to_string();
        folder.scene("now.csv", recorded.replace(line, &cells.join(",")));
    };
    scaled(9);
    folder.refuses(&check, &["by over 5 %", "  hall-22 q16: "]);
    scaled(11);
    let cheaper = folder.prints(&check);
    assert!(cheaper.contains("fewer instructions") && cheaper.contains("  hall-22 q16: "), "{cheaper}");
    // Another compiler's counts say nothing.
    scaled(1);
    let other = fs::read_to_string(folder.path("now.csv")).unwrap().replace("rustc 1.", "rustc 0.");
    folder.scene("now.csv", other);
    assert!(folder.prints(&check).starts_with("not compared: now.csv is of rustc 0."));
    // Without valgrind it is skipped, except where that would go unnoticed.
    folder.scene("now.csv", &recorded);
    let alone = || {
        let mut command = folder.command(&check);
        command.env("PATH", "/nowhere").env_remove("CI");
        command
    };
    let skipped = alone().output().unwrap();
    assert!(skipped.status.success() && skipped.stdout.starts_with(b"skipped"), "{skipped:?}");
    assert_eq!(alone().env("CI", "true").output().unwrap().status.code(), Some(2));
}
