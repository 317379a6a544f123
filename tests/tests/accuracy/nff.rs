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

/// An exponent of highlights that is no whole number, as the Standard Procedural Databases have it, and the whole one that the
/// program makes of it. Scenes with it are compared with the oracle in both ways, until it is no longer rounded.
const SHINE: [&str; 2] = [" 3.0827 ", " 3 "];

/// What fails for a reason that is known: the comparison, and the reason. Whoever mends the reason deletes the line: a
/// comparison that stands here must fail.
const KNOWN: [(&str, &str); 10] = [
    ("balls2, f64", ROUNDED),
    ("balls3, f64", ROUNDED),
    ("balls4, f64", ROUNDED),
    ("rings, f64", ROUNDED),
    ("balls3, q16", SCALE),
    ("tiny, q16", SCALE),
    ("slim-cylinders, f64", "long thin cones and cylinders shadow themselves"),
    ("slim-cylinders, q16", "long thin cones and cylinders shadow themselves; then the scale of --fit"),
    ("crossed-outlines, f64", "an outline's antennas and crossings take other parts of it away"),
    ("mirror-patches, f64", "a reflected ray goes behind the patch whose mixed normal it leaves by"),
];
const ROUNDED: &str = "exponents of highlights are rounded to whole numbers";
const SCALE: &str = "--fit takes the scale nearest to 1, not the one of the most precise picture";

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
    let mut outcomes = vec![
        (format!("{name}, f64"), agreement(scene.oracle(), &double, LIMIT), LEAST),
        (format!("{name}, q16"), agreement(scene.program(Format::Q16), &double, LEVEL), least),
    ];
    let [real, whole] = SHINE;
    if text.contains(real) {
        let scene = Nff::new(path, &text.replace(real, whole), size);
        let agreement = agreement(scene.oracle(), &scene.program(Format::F64), LIMIT);
        outcomes.push((format!("{name}, f64, Shine{whole}"), agreement, LEAST));
    }
    outcomes
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
    let mut known = KNOWN.to_vec();
    let mut wrong = Vec::new();
    for (name, outcome, least) in outcomes() {
        let passes = outcome.as_ref().is_ok_and(|agreement| agreement.percent >= least);
        let figures = outcome.map_or_else(|why| why, |agreement| agreement.to_string());
        println!("{name:24} {figures}");
        let reason = known.iter().position(|(listed, _)| *listed == name).map(|at| known.swap_remove(at).1);
        match (passes, reason) {
            (true, None) | (false, Some(_)) => {}
            (false, None) => wrong.push(format!("{name}: {figures}; at least {least} % must agree")),
            (true, Some(reason)) => wrong.push(format!("{name} passes: delete its line in KNOWN ({reason})")),
        }
    }
    wrong.extend(known.iter().map(|(name, _)| format!("{name} is in KNOWN, but is not compared")));
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
