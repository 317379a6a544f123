//! `rta report` from outside, instructions included where valgrind is installed.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

/// A mirror and a glass.
const SCENE: &str = "\
0 -10 2   0 1 0   1
0
0
2   0 0 1   1 1 1   1   2
    2 1 1   0 1 1   0.75   3 0.25 0.75 1.5
1   4 -8 6   80 80 80   0.5
1 1 0   0 1 0   0.2 0.2 0.2   0.7 0.7 1   0.2 0.2 1
";

/// Returns the rows of `report.csv` and of `spreading.csv`.
fn report(folder: &Path, output: &str) -> [Vec<Vec<String>>; 2] {
    let mut rta = Command::new(env!("CARGO_BIN_EXE_rta"));
    rta.args(["report", "small.dat", "-o", output, "--size", "40x30"])
        .current_dir(folder)
        .stdin(Stdio::null());
    let ended = rta.output().unwrap();
    assert!(ended.status.success() && ended.stdout.is_empty() && ended.stderr.is_empty(), "{ended:?}");
    let folder = folder.join(output);
    for name in ["report.csv", "report.md", "small.png", "small.svg"] {
        assert!(fs::metadata(folder.join(name)).unwrap().len() > 1000, "{name}");
    }
    ["report.csv", "spreading.csv"].map(|name| {
        let table = fs::read_to_string(folder.join(name)).unwrap();
        table.lines().map(|line| line.split(',').map(String::from).collect()).collect()
    })
}

fn has_valgrind() -> bool {
    let valgrind = Command::new("valgrind").arg("--version").stdout(Stdio::null()).status();
    valgrind.is_ok_and(|status| status.success())
}

#[test]
fn two_reports_differ_in_their_seconds_alone() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("small.dat"), SCENE).unwrap();
    let ([first, spread], [second, spread_again]) =
        (report(folder.path(), "a"), report(folder.path(), "b/c"));
    assert_eq!(first.len(), 1 + 15 * 45);
    // Two grids, sobol with points, four ways to cut and one to refine, one cone over each pixel, lamps asked by cones, at fixed places and at changing ones, as far as 256 shadow rays.
    assert_eq!(
        (spread.len(), spread_again.len()),
        (1 + 15 + 4 + 1 + 5 + 4 + 3 + 5 + 4 + 3 + 1, spread.len())
    );
    let lasting = |row: &Vec<String>| row[..row.len() - 1].to_vec();
    for (first, second) in first.iter().zip(&second).chain(spread.iter().zip(&spread_again)) {
        assert_eq!(lasting(first), lasting(second));
    }
    let counted = first[0].iter().position(|name| name == "instructions").unwrap();
    for row in &first[1..] {
        if has_valgrind() {
            // 1200 pixels, each of them some hundred instructions at least.
            assert!(row[counted].parse::<u64>().unwrap() > 120_000, "{row:?}");
        } else {
            assert_eq!(row[counted], "");
        }
    }
}

#[test]
fn what_cannot_be_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let refused = |args: &[&str], words: &str| {
        let mut rta = Command::new(env!("CARGO_BIN_EXE_rta"));
        let ended = rta.arg("report").args(args).current_dir(folder.path()).output().unwrap();
        let said = String::from_utf8(ended.stderr).unwrap();
        assert!(ended.status.code() == Some(2) && said.contains(words), "{said}");
    };
    refused(&[], "--output");
    refused(&["none.dat", "-o", "out"], "none.dat");
    fs::write(folder.path().join("taken"), "").unwrap();
    refused(&["-o", "taken"], "cannot write taken");
    refused(&["-o", "out", "--size", "321x200"], "does not fit vga");
}
