//! Whether a picture has changed: hashes of every shipped scene, and of small versions of the Standard Procedural
//! Databases, in all number formats and illumination models.
//!
//! `RTA_BLESS=1 cargo test -p rta-tests --test baseline` records in `tests/baseline.csv` what is drawn now.

use core::fmt::Write;
use core::sync::atomic::{AtomicUsize, Ordering};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::{fs, thread};

use rta::engine::{Format, Model};
use rta_scenes::description::Description;

use draw::{FORMATS, MODELS, SETTINGS, SIZE, hashes};

mod draw;

/// Folders of this repository whose scene files are drawn.
const FOLDERS: [&str; 3] = ["scenes", "tests/scenes", "tests/scenes/spd"];

/// Threads that draw.
const THREADS: usize = 2;

/// A file's name, number format and model, and what was drawn with each of [`SETTINGS`].
type Row = (String, Format, Model, [Option<u64>; SETTINGS.len()]);

/// The root of the repository.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// All scene files of [`FOLDERS`], by name.
fn scenes() -> Vec<(String, Description)> {
    let mut names = Vec::new();
    for folder in FOLDERS {
        for entry in fs::read_dir(root().join(folder)).expect(folder) {
            let file = entry.expect(folder).file_name().into_string().expect("a plain name");
            if file.ends_with(".dat") || file.ends_with(".nff") {
                names.push(format!("{folder}/{file}"));
            }
        }
    }
    names.sort();
    let read = |name: String| {
        let text = fs::read(root().join(&name)).expect(&name);
        let scene = rta_scenes::read(&text, &name).expect(&name);
        (name, scene)
    };
    names.into_iter().map(read).collect()
}

/// Draws everything, in several threads; the rows come in the order of scenes, formats and models.
fn draw() -> Vec<Row> {
    let scenes = scenes();
    let jobs: Vec<_> = scenes
        .iter()
        .flat_map(|scene| FORMATS.map(|format| (scene, format)))
        .flat_map(|(scene, format)| MODELS.map(|model| (scene, format, model)))
        .collect();
    let next = AtomicUsize::new(0);
    let work = || {
        let mut done = Vec::new();
        loop {
            let number = next.fetch_add(1, Ordering::Relaxed);
            let Some(&((name, scene), format, model)) = jobs.get(number) else { return done };
            done.push((number, (name.clone(), format, model, hashes(scene, format, model))));
        }
    };
    let mut rows = thread::scope(|scope| {
        let threads = [(); THREADS].map(|()| scope.spawn(work));
        threads.into_iter().flat_map(|thread| thread.join().expect("it draws")).collect::<Vec<_>>()
    });
    rows.sort_by_key(|(number, _)| *number);
    rows.into_iter().map(|(_, row)| row).collect()
}

fn text(hash: Option<u64>) -> String {
    hash.map_or_else(|| "refused".to_owned(), |hash| format!("{hash:016x}"))
}

/// What one picture is called in a message.
fn picture(name: &str, format: &str, model: &str, (depth, samples): (u32, u8)) -> String {
    format!("{name}, {format}, {model}, depth {depth}, {samples} samples a pixel")
}

/// The file with these rows.
fn csv(rows: &[Row]) -> String {
    let (width, height) = SIZE;
    let mut csv = format!(
        "# Hashes of the linear light of pictures of {width} x {height} pixels, bit for bit in their number format.\n\
         # A later change may change a hash only with its reason in the changelog. To record all anew:\n\
         # RTA_BLESS=1 cargo test -p rta-tests --test baseline\n\
         scene,format,model"
    );
    for (depth, samples) in SETTINGS {
        write!(csv, ",depth {depth} samples {samples}").expect("memory takes it");
    }
    csv += "\n";
    for (name, format, model, hashes) in rows {
        let hashes = hashes.map(text).join(",");
        writeln!(csv, "{name},{format},{model},{hashes}").expect("memory takes it");
    }
    csv
}

/// The recorded hashes of the pictures by what they are called.
fn recorded(csv: &str) -> BTreeMap<String, String> {
    let mut pictures = BTreeMap::new();
    for line in csv.lines().filter(|line| !line.starts_with('#')).skip(1) {
        let mut fields = line.split(',');
        let mut field = || fields.next().unwrap_or_default();
        let (name, format, model) = (field(), field(), field());
        for setting in SETTINGS {
            pictures.insert(picture(name, format, model, setting), field().to_owned());
        }
    }
    pictures
}

/// Draws all pictures, and returns what is told of each that differs from its hash in `tests/baseline.csv`.
///
/// # Panics
/// A scene file or the file of hashes cannot be read.
pub fn differences() -> Vec<String> {
    let path = recorded_at();
    let file = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut recorded = recorded(&file);
    let mut wrong = Vec::new();
    for (name, format, model, hashes) in draw() {
        for (setting, got) in SETTINGS.into_iter().zip(hashes.map(text)) {
            let picture = picture(&name, &format.to_string(), &model.to_string(), setting);
            match recorded.remove(&picture) {
                Some(want) if want == got => {}
                Some(want) => wrong.push(format!("{picture}: got {got}, recorded {want}")),
                None => wrong.push(format!("{picture}: got {got}, not recorded")),
            }
        }
    }
    wrong.extend(recorded.into_keys().map(|picture| format!("{picture}: recorded, not drawn")));
    wrong
}

/// Draws all pictures, and records their hashes in `tests/baseline.csv`.
///
/// # Panics
/// A scene file cannot be read, or the file of hashes cannot be written.
pub fn record() {
    let path = recorded_at();
    fs::write(&path, csv(&draw())).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
}

fn recorded_at() -> PathBuf {
    root().join("tests/baseline.csv")
}
