//! The stability suite with few rays, in a build that checks every operation: no overflow, no panic and no acne, in any
//! format, on any case that the format admits. `rta stability` runs it with many rays and prints the errors.

use std::sync::LazyLock;
use std::thread;

use rta::stability::measure::Outcome;
use rta::stability::{FORMATS, Row, cases, rows, table};
use rta_scenes::model::Model;

/// Rays from the eye of each case, and half as many points that are looked at for acne.
const RAYS: usize = 2000;

/// The rows of the suite, traced once for all tests.
static SUITE: LazyLock<Vec<Row>> = LazyLock::new(|| {
    let cases = cases::all();
    let suite = |cases| rows(cases, RAYS, |_| ()).expect("nothing interrupts it");
    let (some, others) = cases.split_at(cases.len() / 2);
    thread::scope(|threads| {
        let some = threads.spawn(|| suite(some));
        let others = suite(others);
        let some = some.join().expect("no panic");
        [some, others].concat()
    })
});

#[test]
#[cfg_attr(not(debug_assertions), ignore = "only debug assertions find an overflow")]
fn nothing_happens_that_must_not() {
    let rows = &*SUITE;
    let unsound: Vec<Row> = rows
        .iter()
        .filter(|row| matches!(&row.outcome, Outcome::Traced(measured) if !measured.is_sound()))
        .cloned()
        .collect();
    assert!(unsound.is_empty(), "{}", table::text(&unsound));
    // Each case is put to every format, refused only where the format is too short or too coarse for it, and f32 is
    // neither.
    assert_eq!(rows.len(), FORMATS.len() * cases::all().len());
    for Row { case, format, outcome } in rows {
        match outcome {
            Outcome::Traced(measured) => {
                assert!(measured.rays >= measured.samples as u64, "{case}, {format}")
            }
            Outcome::Refused(reason) => assert!(reason.contains("range"), "{case}, {format}: {reason}"),
        }
    }
    let refused = |row: &&Row| matches!(row.outcome, Outcome::Refused(_));
    assert!(rows.iter().filter(refused).all(|row| row.format != FORMATS[0]), "f32 is refused");
    assert!(rows.iter().filter(refused).count() <= 20, "too much is refused to say anything");
}

#[test]
fn errors_are_small_where_the_case_is_no_cliff() {
    // Away from the places where a ray falls on either side of something, every format is within a fraction of a level.
    let smooth = [
        "radius 1 at distance 400",
        "eye inside a mirror ball",
        "no lamp",
        "no object",
        "eye on the floor",
        "along the axis of a mirror tube",
        "normals of a mirror, mixed",
        "normals of a glass, mixed",
        "coincident triangles",
        "coincident triangles, mirrors",
    ];
    let mut seen = 0;
    for Row { case, format, outcome } in SUITE.iter().filter(|row| smooth.contains(&row.case.as_str())) {
        let Outcome::Traced(measured) = outcome else { panic!("{case} is refused in {format}") };
        assert!(measured.p99 < 0.02 && measured.wrong == 0, "{case}, {format}: {measured:?}");
        seen += 1;
    }
    assert_eq!(seen, smooth.len() * FORMATS.len());
}

#[test]
fn spread_rays_agree_with_f64_at_the_ends_of_what_spreads_them() {
    // Both are spread by the same numbers, so that a sample is as near as a ray that is not spread.
    let (mut seen, mut refused) = (0, 0);
    for Row { case, format, outcome } in SUITE.iter().filter(|row| row.case.starts_with("spread, ")) {
        match outcome {
            Outcome::Traced(measured) => {
                assert!(measured.p99 < 0.05 && measured.wrong <= 1, "{case}, {format}: {measured:?}");
                seen += 1;
            }
            Outcome::Refused(_) => {
                assert!(case.contains("beyond"), "{case}, {format}");
                refused += 1;
            }
        }
    }
    assert!(seen > 130 && refused == 12, "{seen} traced, {refused} refused");
}

#[test]
fn models_agree_with_f64_at_the_ends_of_their_parameters() {
    let ends = ["m = .01", "n = 1000", "k = 1", "A = 2^-31", "F0 = .999"];
    for model in Model::ALL {
        let of_model = |row: &&Row| ends.iter().any(|end| row.case == format!("{model}, {end}"));
        let rows: Vec<_> = SUITE.iter().filter(of_model).collect();
        assert_eq!(rows.len(), ends.len() * FORMATS.len(), "{model}");
        for Row { case, format, outcome } in rows {
            let Outcome::Traced(measured) = outcome else { panic!("{case} is refused in {format}") };
            assert!(measured.median < 0.01 && measured.p99 < 0.1, "{case}, {format}: {measured:?}");
            assert!(measured.wrong == 0, "{case}, {format}: {measured:?}");
        }
    }
}
