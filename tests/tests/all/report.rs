//! The study of error against run time: its measures, its short cuts, and a study of a small raster.
#![allow(clippy::indexing_slicing, reason = "a test may panic")]

use core::sync::atomic::AtomicBool;

use rta::engine::Cutoff;
use rta::engine::Format;
use rta::raster::Size;
use rta::report::bench::{Lattice, bench};
use rta::report::measure::{Difference, median, pareto_front, shown_error};
use rta::report::setting::{CUTOFFS, LIMITS, Limit, samplings};
use rta::report::study::{Setup, Study};
use rta::report::{Source, diagram, page, studies, table};
use rta::scene::Scene;
use rta_core::color::Rgb;
use rta_core::illumination::Rta;
use rta_core::needs::Everything;
use rta_core::raster::{Pixels, Raster};
use rta_core::sampling::{Places, Sampling};
use rta_core::scalar::Unit;
use rta_core::trace::Tracer;
use rta_core::{Q16, Q20};
use rta_packets::tally::{Rays, Tally};
use rta_scenes::description::Description;
use rta_scenes::narrow::{Narrow, narrow};
use rta_scenes::{dat, shipped};

const ASPECT: f64 = 4.0 / 3.0;

fn scene(text: &str) -> Description {
    dat::read(text.as_bytes(), "a shipped scene").expect("a shipped scene")
}

fn grid(side: u8) -> Sampling {
    Sampling::grid(side).expect("a grid of that size")
}

#[test]
fn differences_are_those_computed_by_hand() {
    let a = [Rgb::new(0.5, 0.5, 0.5), Rgb::new(1.0, 0.0, 0.25)];
    let b = [Rgb::new(0.5, 0.25, 0.5), Rgb::new(0.5, 0.0, 0.25)];
    // Squares: 1/16 and 1/4 over six registers.
    let got = Difference::between(&a, &b, 0.25);
    assert!((got.rmse - (0.3125_f64 / 6.0).sqrt()).abs() < 1e-15);
    assert!((got.worst - 0.5).abs() < 1e-15 && (got.within - 0.5).abs() < 1e-15);
    // 10 log10 (6 / 0.3125)
    assert!((got.psnr() - 12.833_012_287_035_497).abs() < 1e-9, "{}", got.psnr());
    assert!((Difference::between(&a, &b, 0.249).within).abs() < 1e-15);
    let same = Difference::between(&a, &a, 0.0);
    assert!(same.rmse == 0.0 && same.worst == 0.0 && same.within == 1.0 && same.psnr() == f64::INFINITY);
    let levels = [Rgb::new(7.0_f32 / 255.0, 0.0, 0.0)];
    let next = [Rgb::new(8.0_f32 / 255.0, 0.0, 0.0)];
    assert!(Difference::between(&levels, &next, 1.0 / 255.0).within == 1.0);
    // What is brighter than white is shown as white.
    let (bright, brighter) = (
        [Rgb::new(0.5, 0.25, 3.0), Rgb::new(0.0, 0.0, 0.0)],
        [Rgb::new(0.5, 0.75, 2.0), Rgb::new(0.0, 0.0, 0.5)],
    );
    assert!((shown_error(&bright, &brighter) - f64::sqrt(0.5 / 6.0)).abs() < 1e-12);
}

#[test]
fn the_front_is_what_nothing_beats() {
    let points =
        [(3.0, 1.0), (1.0, 3.0), (2.0, 3.0), (2.0, 2.0), (4.0, 1.0), (0.5, 9.0), (3.0, 1.5), (2.0, 2.0)];
    assert_eq!(pareto_front(&points), [5, 1, 3, 0]);
    assert_eq!(pareto_front(&[]), [0; 0]);
    // By its definition, on many points.
    let mut random = fastrand::Rng::with_seed(7);
    let many: Vec<_> = (0..300).map(|_| (f64::from(random.u8(..)), f64::from(random.u8(..)))).collect();
    let front = pareto_front(&many);
    let beats = |a: (f64, f64), b: (f64, f64)| a != b && a.0 <= b.0 && a.1 <= b.1;
    for (i, point) in many.iter().enumerate() {
        let beaten = many.iter().any(|other| beats(*other, *point));
        assert_eq!(beaten, !front.iter().any(|at| many[*at] == *point), "{i}");
    }
    assert!(front.windows(2).all(|pair| many[pair[0]].0 < many[pair[1]].0));
}

#[test]
fn medians() {
    assert_eq!(
        [median(vec![3.0, 1.0, 2.0]), median(vec![4.0, 1.0, 2.0, 3.0]), median(vec![])],
        [2.0, 2.0, 0.0]
    );
}

/// Returns the picture of one setting and the number of rays of each kind, traced with this setting alone.
fn traced<S: Narrow>(
    scene: &Description,
    limit: Limit,
    sampling: Sampling,
    raster: Raster,
) -> (Vec<Rgb<f32>>, Rays) {
    let narrowed = narrow::<S>(scene, ASPECT).expect("it fits");
    let admitted = narrowed.admit().expect("it is admitted");
    let tracer = Tracer::<S, _, Everything, 32>::new(&admitted, Rta, limit.depth).expect("not too deep");
    let tracer = tracer.with_cutoff(S::Unit::ratio(limit.cutoff.numerator(), limit.cutoff.denominator()));
    let mut rays = Tally::default();
    let mut pixels = Pixels::sampled(&tracer, &narrowed.camera, raster, sampling, 0, raster.height());
    #[allow(clippy::cast_possible_truncation, reason = "to the nearest")]
    let single = |light| S::light_to_f64(light) as f32;
    let mut picture = Vec::new();
    while let Some(light) = pixels.next_observed(&mut rays) {
        // What a display cannot show of a single sample is cut off, as of several.
        picture.push(light.map(single).map(|light| light.min(1.0)));
    }
    (picture, rays.0)
}

fn one_walk_is_all<S: Narrow>(text: &str, format: Format) {
    let (scene, raster) = (scene(text), Raster::new(32, 20).expect("small"));
    let bench = bench(&scene, ASPECT, format).expect("it fits");
    let mut deepest = Vec::new();
    for sampling in [grid(1), grid(2).jittered(9)] {
        let pictures = bench.pictures(sampling, Lattice::all(raster), false).expect("it is traced");
        assert_eq!(pictures.limited.len(), LIMITS);
        for (limit, (picture, rays)) in Limit::all().zip(&pictures.limited) {
            let (want, want_rays) = traced::<S>(&scene, limit, sampling, raster);
            assert!(*picture == want, "{format} {limit:?}: another picture");
            assert_eq!(*rays, want_rays, "{format} {limit:?}");
            assert_eq!(rays[0], u64::from(sampling.samples()) * 640);
            if limit.depth == 8 {
                deepest.push(rays.iter().sum::<u64>());
            }
        }
        assert!(
            pictures.whole
                == traced::<S>(&scene, Limit { depth: 8, cutoff: Cutoff::OFF }, sampling, raster).0
        );
    }
    // The higher the cut-off, the fewer the rays. The mirrors of the hall reflect too much for any to be cut off.
    for of in deepest.chunks(CUTOFFS.len()) {
        assert!(of.windows(2).all(|pair| pair[0] >= pair[1]), "{of:?}");
        assert_eq!(of[0] > of[CUTOFFS.len() - 1], text == shipped::GLASS_2, "{of:?}");
    }
}

#[test]
fn one_walk_gives_the_pictures_and_rays_of_all_limits() {
    one_walk_is_all::<f32>(shipped::HALL_22, Format::F32);
    one_walk_is_all::<Q16>(shipped::GLASS_2, Format::Q16);
    one_walk_is_all::<Q20>(shipped::HALL_22, Format::Q20);
    one_walk_is_all::<f64>(shipped::GLASS_2, Format::F64);
}

#[test]
fn a_lattice_selects_what_it_traces() {
    let raster = Raster::new(31, 17).expect("small");
    let bench = bench(&scene(shipped::JUGGLER), ASPECT, Format::F32).expect("it fits");
    let limit = Limit { depth: 2, cutoff: Cutoff::OFF };
    let whole = bench.picture(limit, grid(2), Lattice::all(raster)).expect("it is traced");
    for step in [0, 1, 2, 3, 10, 100] {
        let lattice = Lattice::every(raster, step);
        let part = bench.picture(limit, grid(2), lattice).expect("it is traced");
        assert!(!part.is_empty() && part == lattice.select(&whole), "{step}");
    }
}

fn tiny() -> (Vec<Study>, Vec<u8>) {
    let shipped = Scene::shipped().expect("the shipped scenes");
    let sources: Vec<_> = shipped
        .into_iter()
        .take(2)
        .map(|(scene, text)| Source { title: scene.title.clone(), scene, text })
        .collect();
    let stop = AtomicBool::new(false);
    let size = Size::new(24, 15).expect("small");
    let studies =
        studies(&sources, Setup { size, aspect: ASPECT, program: None, stop: &stop }).expect("a study");
    let csv = table::csv(&studies).expect("a table");
    (studies, csv)
}

/// Returns the lines without their last column, which is CPU seconds and so not repeatable.
fn lasting(csv: &[u8]) -> Vec<String> {
    let text = core::str::from_utf8(csv).expect("text");
    text.lines().map(|line| line.rsplit_once(',').expect("columns").0.to_owned()).collect()
}

#[test]
fn a_study_is_complete_and_repeats() {
    let (studies, csv) = tiny();
    let methods = samplings().len() + 2 * 4;
    assert_eq!(lasting(&csv).len(), 1 + 2 * methods * LIMITS);
    assert_eq!(lasting(&csv), lasting(&tiny().1));
    for study in &studies {
        for row in &study.rows {
            let errors = [row.rounding, row.truncation, row.sampling, row.tracing, row.total];
            for error in errors {
                assert!(error.rmse.is_finite() && error.rmse <= error.worst && error.worst <= 1.0);
                assert!((0.0..=1.0).contains(&error.within));
            }
            assert!(row.rounding.rmse < 0.05, "{:?}", row.rounding);
            // Errors add up at most.
            assert!(row.tracing.rmse <= row.rounding.rmse + row.truncation.rmse + 1e-9);
            assert!(row.display.iter().all(|display| display.rmse > 0.0 && display.worst <= 255.0));
            assert!(row.seconds > 0.0 && row.instructions.is_none() && row.all_rays() >= 24 * 15);
        }
        let (svg, pixels) =
            (diagram::svg(study).expect("a diagram"), diagram::pixels(study).expect("a diagram"));
        assert!(
            svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>") && svg.contains("Pareto front")
        );
        assert_eq!(pixels.len(), diagram::SIZE.0 as usize * diagram::SIZE.1 as usize);
        // The front is black, and so is text: more of it in the key than lines alone would be.
        let dark = |pixel: &&Rgb<u8>| pixel.r < 80 && pixel.g < 80 && pixel.b < 80;
        let key =
            pixels.chunks(diagram::SIZE.0 as usize).flat_map(|row| &row[diagram::SIZE.0 as usize - 180..]);
        assert!(key.filter(dark).count() > 1000, "the key has no text");
    }
    let page = page::markdown(&studies, Size::new(24, 15).expect("small"), ASPECT);
    for words in [
        "## juggler",
        "## hall-22",
        "| 1/255 ",
        "Pareto front",
        "No instructions were counted",
        "juggler.svg",
    ] {
        assert!(page.contains(words), "{words}");
    }
}
