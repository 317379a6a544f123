//! The study of error against run time: its measures, its samples, its short cuts, and the study of a small raster.
#![allow(clippy::indexing_slicing, reason = "a test may panic")]

use core::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use rta::engine::{Engine, Format, Settings};
use rta::raster::Size;
use rta::report::bench::{Lattice, bench};
use rta::report::measure::{Difference, median, pareto_front};
use rta::report::setting::{CUTOFFS, LIMITS, Limit, samplings};
use rta::report::study::{Setup, Study};
use rta::report::{Source, diagram, page, studies, table};
use rta::sampling::Cutoff;
use rta::scene::Scene;
use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, RayKind, Rta, Secondary, Surface};
use rta_core::light::Incident;
use rta_core::needs::{Everything, Needs};
use rta_core::raster::Raster;
use rta_core::sampling::Sampling;
use rta_core::scalar::{Light, Scalar, Unit};
use rta_core::trace::Tracer;
use rta_core::{Q16, Q20};
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

/// Places as floats, one LSB of a unit being 2^-30 in fixed point.
fn places<S: Narrow>(
    sampling: Sampling,
    raster: Raster,
    x: u32,
    y: u32,
    read: fn(S::Unit) -> f64,
) -> Vec<(f64, f64)> {
    sampling.places::<S::Unit>(raster, x, y).map(|(right, up)| (read(right), read(up))).collect()
}

#[test]
fn the_mean_of_regular_samples_of_a_ramp_is_its_value_in_the_middle() {
    let raster = Raster::new(320, 200).expect("small");
    for side in [1, 2, 3, 4, 32] {
        for (x, y) in [(0, 0), (319, 199), (17, 101)] {
            let middle = (f64::from(2 * x + 1) / 640.0 - 0.5, 0.5 - f64::from(2 * y + 1) / 400.0);
            let all = [
                (places::<f64>(grid(side), raster, x, y, |u| u), 1e-15),
                (places::<Q16>(grid(side), raster, x, y, |u| u.to_num()), 1e-9),
            ];
            for (places, tolerance) in all {
                let n = places.len() as f64;
                let mean = places.iter().fold((0.0, 0.0), |sum, p| (sum.0 + p.0 / n, sum.1 + p.1 / n));
                assert!(
                    (mean.0 - middle.0).abs() < tolerance && (mean.1 - middle.1).abs() < tolerance,
                    "{side}"
                );
            }
        }
    }
}

fn mean<S: Narrow>(sampling: Sampling, lights: &[f64]) -> f64 {
    let lights = lights.iter().map(|light| Rgb::new(S::light(*light), S::Light::ZERO, S::Light::WHITE));
    let mean = sampling.mean(lights);
    assert!(mean.g == S::Light::ZERO && mean.b == S::Light::WHITE, "black and white stay what they are");
    f64::from(S::widen(mean.r))
}

#[test]
fn means_are_of_what_a_display_shows() {
    for side in 1..=8 {
        let n = usize::from(side) * usize::from(side);
        let ramp: Vec<_> = (0..n).map(|k| (2 * k + 1) as f64 / (2 * n) as f64).collect();
        // The ramp's own rounding and one more.
        for (mean, lsb) in [
            (mean::<f32>(grid(side), &ramp), 1e-7),
            (mean::<Q16>(grid(side), &ramp), 1.0 / 65_536.0),
            (mean::<Q20>(grid(side), &ramp), 1.0 / 65_536.0),
        ] {
            assert!((mean - 0.5).abs() <= 2.0 * lsb, "{side}: {mean}");
        }
    }
    // A glint counts as white.
    assert_eq!(mean::<Q16>(grid(2), &[25_000.0, 0.0, 0.0, 0.0]), 0.25);
    assert_eq!(mean::<f32>(grid(2), &[25_000.0, 0.0, 0.0, 0.0]), 0.25);
}

#[test]
fn jittered_samples_stay_in_their_cells_and_repeat() {
    let raster = Raster::new(50, 40).expect("small");
    let mut all = Vec::new();
    for side in [1_u8, 2, 3, 4] {
        for (x, y) in [(0, 0), (49, 39), (12, 7), (7, 12)] {
            let jittered = places::<f64>(grid(side).jittered(3), raster, x, y, |u| u);
            assert_eq!(jittered, places::<f64>(grid(side).jittered(3), raster, x, y, |u| u));
            assert_ne!(jittered, places::<f64>(grid(side).jittered(4), raster, x, y, |u| u));
            let fixed = places::<Q16>(grid(side).jittered(3), raster, x, y, |u| u.to_num());
            let regular = places::<f64>(grid(side), raster, x, y, |u| u);
            let side = f64::from(side);
            for ((place, middle), fixed) in jittered.iter().zip(regular).zip(fixed) {
                let (across, down) = ((place.0 - middle.0) * 50.0 * side, (place.1 - middle.1) * 40.0 * side);
                assert!(across.abs() <= 0.5 && down.abs() <= 0.5, "{place:?} {middle:?}");
                assert!(
                    (fixed.0 - place.0).abs() < 2e-9 && (fixed.1 - place.1).abs() < 2e-9,
                    "the same in each format"
                );
                all.extend([across, down]);
            }
        }
    }
    // Neither stuck nor biased: 240 numbers that are even from -1/2 to 1/2 have a mean within 4 x 0.29 / sqrt(240).
    let mean = all.iter().sum::<f64>() / all.len() as f64;
    let spread = (all.iter().map(|part| part * part).sum::<f64>() / all.len() as f64).sqrt();
    assert!(mean.abs() < 0.075 && (0.24..0.34).contains(&spread), "{mean} {spread}");
}

#[test]
fn grids_have_limits() {
    assert!(Sampling::grid(0).is_none() && Sampling::grid(129).is_none());
    assert_eq!(grid(128).samples(), 16_384);
    assert_eq!(grid(1), Sampling::CENTER);
}

fn levels(scene: &Description, settings: &Settings) -> Vec<Rgb<u8>> {
    let mut picture = vec![Rgb::default(); settings.width as usize * settings.height as usize];
    Engine::new(scene, settings).expect("it fits").level_rows(0, 255, &mut picture);
    picture
}

fn small(format: Format) -> Settings {
    Settings { width: 48, height: 30, format, depth: 8, ..Settings::default() }
}

#[test]
fn no_cutoff_changes_nothing_and_some_cutoff_does() {
    for format in [Format::F32, Format::Q16, Format::Q20] {
        let scene = scene(shipped::GLASS_2);
        // Four bounces of a quarter are far from one in 65535.
        let small = |format| Settings { depth: 4, ..small(format) };
        let plain = levels(&scene, &small(format));
        let least = Cutoff::one_in(u16::MAX);
        assert!(plain == levels(&scene, &Settings { cutoff: Cutoff::OFF, ..small(format) }));
        assert!(
            plain == levels(&scene, &Settings { cutoff: least, ..small(format) }),
            "nothing is that faint"
        );
        assert!(plain != levels(&scene, &Settings { cutoff: Cutoff::one_in(2), ..small(format) }));
    }
}

#[test]
fn samples_change_edges_and_do_not_depend_on_how_a_picture_is_cut() {
    let scene = scene(shipped::JUGGLER);
    for sampling in [grid(2), grid(3).jittered(1)] {
        let settings = Settings { sampling, ..small(Format::Q16) };
        let whole = levels(&scene, &settings);
        assert!(whole != levels(&scene, &small(Format::Q16)));
        let engine = Engine::new(&scene, &settings).expect("it fits");
        let mut rows = vec![Rgb::default(); 48 * 10];
        engine.level_rows(20, 255, &mut rows);
        assert!(whole[48 * 20..] == rows);
    }
}

/// A model that counts the rays it is told of.
#[derive(Clone, Copy)]
struct Counting<'a>(&'a [AtomicU64; 4]);

impl<S: Scalar> Illumination<S> for Counting<'_> {
    type Weight = <Rta as Illumination<S>>::Weight;
    fn ambient<N: Needs>(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        Rta.ambient::<N>(surface, ambient)
    }
    fn is_lit<N: Needs>(&self, surface: &Surface<S>) -> bool {
        Illumination::<S>::is_lit::<N>(&Rta, surface)
    }
    fn direct<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light> {
        Rta.direct::<N>(surface, incident)
    }
    fn secondary<N: Needs>(&self, surface: &Surface<S>) -> Secondary<Self::Weight> {
        Rta.secondary::<N>(surface)
    }
    fn note(&self, kind: RayKind) {
        let kinds = [RayKind::Primary, RayKind::Reflected, RayKind::Transmitted, RayKind::Shadow];
        let at = kinds.iter().position(|other| *other == kind).expect("one of four");
        self.0[at].fetch_add(1, Ordering::Relaxed);
    }
}

/// Picture and rays of one setting, traced with that setting.
fn traced<S: Narrow>(
    scene: &Description,
    limit: Limit,
    sampling: Sampling,
    raster: Raster,
) -> (Vec<Rgb<f32>>, [u64; 4]) {
    let narrowed = narrow::<S>(scene, ASPECT).expect("it fits");
    let rays = [const { AtomicU64::new(0) }; 4];
    let admitted = narrowed.scene().admit(&narrowed.camera).expect("it is admitted");
    let tracer =
        Tracer::<S, _, Everything, 32>::new(admitted, Counting(&rays), limit.depth).expect("not too deep");
    let tracer = tracer.with_cutoff(S::Unit::ratio(limit.cutoff.numerator(), limit.cutoff.denominator()));
    let pixel = |at| sampling.pixel(&tracer, &narrowed.camera, raster, at).map(S::widen);
    let picture =
        (0..raster.height()).flat_map(|y| (0..raster.width()).map(move |x| (x, y))).map(pixel).collect();
    (picture, rays.each_ref().map(|count| count.load(Ordering::Relaxed)))
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

/// All columns but the last, the CPU seconds.
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
