//! Scenes in NFF: the program's f64 against the oracle of NFF, and its q16 with `--fit` against its f64, for six scenes of the
//! Standard Procedural Databases and for scenes that are hard on numbers and shapes.
//!
//! ```text
//! cargo test -p rta-tests --test accuracy nff -- --nocapture      # shows the figures
//! ```

use core::sync::atomic::{AtomicUsize, Ordering};
use std::path::Path;
use std::{fs, thread};

use rta::engine::Format;
use rta_tests::agreement::{Agreement, Nff, Picture};

/// A file from the root of the repository, the size of the picture if it is not the file's own, and the share of pixels in a
/// hundred that q16 and f64 must agree on.
type Scene = (&'static str, Option<(usize, usize)>, f64);

const SCENES: [Scene; 16] = [
    ("scenes/balls2.nff", SPD_SIZE, 99.5),
    ("tests/scenes/spd/balls3.nff", SPD_SIZE, 99.5),
    ("tests/scenes/spd/balls4.nff", SPD_SIZE, 99.0),
    ("tests/scenes/spd/rings.nff", SPD_SIZE, 99.0),
    ("tests/scenes/spd/tetra.nff", SPD_SIZE, 99.5),
    ("tests/scenes/spd/tree.nff", SPD_SIZE, 99.5),
    ("tests/scenes/nff/concave-outlines.nff", None, 99.5),
    ("tests/scenes/nff/crossed-outlines.nff", None, 99.5),
    ("tests/scenes/nff/glass.nff", None, 99.5),
    ("tests/scenes/nff/huge.nff", None, 99.5),
    ("tests/scenes/nff/inside.nff", None, 99.5),
    ("tests/scenes/nff/lamps.nff", None, 99.5),
    ("tests/scenes/nff/mirror-patches.nff", None, 99.5),
    ("tests/scenes/nff/patches.nff", None, 99.5),
    ("tests/scenes/nff/slim-cylinders.nff", None, 99.5),
    ("tests/scenes/nff/tiny.nff", None, 99.5),
];

/// Size of the pictures of the Standard Procedural Databases, whose files ask for more.
const SPD_SIZE: Option<(usize, usize)> = Some((96, 96));

/// The share of pixels in a hundred that f64 and the oracle must agree on.
const LEAST: f64 = 99.9;
/// Largest difference of a register between f64 and the oracle.
const LIMIT: f64 = 1e-3;
/// Largest difference of a register between q16 and f64: one level of a VGA's gun.
const LEVEL: f64 = 1.0 / 63.0;

/// A comparison: its name, its outcome or why there is none, and the share of pixels that must agree.
type Outcome = (String, Result<Agreement, String>, f64);

/// Compares two pictures, if there are two.
fn agreement(
    one: Result<Picture, String>,
    other: &Result<Picture, String>,
    limit: f64,
) -> Result<Agreement, String> {
    Ok(Agreement::new(&one?, other.as_ref().map_err(Clone::clone)?, limit))
}

/// Makes the comparisons of one scene.
fn compare((path, size, least): Scene) -> Vec<Outcome> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path);
    let text = fs::read_to_string(&file).unwrap_or_else(|error| panic!("{path}: {error}"));
    let name = file.file_stem().unwrap_or_default().to_string_lossy();
    let scene = Nff::new(path, &text, size);
    let double = scene.program(Format::F64);
    vec![
        (format!("{name}, f64"), agreement(scene.oracle(), &double, LIMIT), LEAST),
        (format!("{name}, q16"), agreement(scene.program(Format::Q16), &double, LEVEL), least),
    ]
}

/// Makes all comparisons, in two threads.
fn outcomes() -> Vec<Outcome> {
    let next = AtomicUsize::new(0);
    let work = || {
        let scenes = core::iter::from_fn(|| SCENES.get(next.fetch_add(1, Ordering::Relaxed)));
        scenes.flat_map(|scene| compare(*scene)).collect::<Vec<_>>()
    };
    thread::scope(|scope| {
        let threads = [(); 2].map(|()| scope.spawn(work));
        threads.into_iter().flat_map(|thread| thread.join().expect("it compares")).collect()
    })
}

#[test]
fn scenes_in_nff_agree() {
    let mut wrong = Vec::new();
    for (name, outcome, least) in outcomes() {
        let passes = outcome.as_ref().is_ok_and(|agreement| agreement.percent >= least);
        let figures = outcome.map_or_else(|why| why, |agreement| agreement.to_string());
        println!("{name:24} {figures}");
        if !passes {
            wrong.push(format!("{name}: {figures}; at least {least} % must agree"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
