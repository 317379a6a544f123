//! Mistakes that people make on the command line, and what they are told: `mistakes.txt` holds both, to be read by eye.
//!
//! The names of all models are `MODELS` there. With `RTA_BLESS=1` in the environment the test writes the file anew.

use core::fmt::Write;
use std::fs;
use std::path::Path;

use rta::engine::Model;

use super::folder::{Folder, spoilt};

#[test]
fn every_mistake_is_told_as_it_is_written_down() {
    let folder = Folder::new();
    folder.scene("far.dat", spoilt("0 0 1   1 1 1   1   2", "0 90000 1   1 1 1   1   2"));
    folder.scene("huge.dat", spoilt("0 0 1   1 1 1   1   2", "0 1e300 1   1 1 1   1   2"));
    fs::create_dir(folder.path("folder")).unwrap();
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cli/mistakes.txt");
    let known = fs::read_to_string(&file).unwrap();
    let mut told = String::new();
    // There may be more than when the file was written.
    let models = Model::ALL.iter().map(|model| model.name()).collect::<Vec<_>>().join(", ");
    for line in known.lines().filter_map(|line| line.strip_prefix("$ rta")) {
        let words: Vec<_> = line.split_whitespace().collect();
        let before = folder.names();
        let output = folder.rta(&words);
        assert_eq!(output.status.code(), Some(2), "rta{line}");
        assert_eq!(folder.names(), before, "rta{line}");
        let message = String::from_utf8(output.stderr).unwrap().replace(&models, "MODELS");
        write!(told, "$ rta{line}\n{message}\n").unwrap();
        let longest = message.split([' ', '\n', ';', ',']).map(str::len).max();
        assert!(longest < Some(33), "a number or a word is long: {message}");
    }
    if std::env::var_os("RTA_BLESS").is_some_and(|value| !value.is_empty() && value != "0") {
        return fs::write(&file, &told).unwrap();
    }
    for (told, known) in told.split("$ ").zip(known.split("$ ")) {
        assert_eq!(told, known);
    }
    assert_eq!(told, known);
}
