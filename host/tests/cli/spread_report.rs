//! What `rta report` tells of rays that are spread, against what is known.

use core::sync::atomic::AtomicBool;

use rta::engine::{Engine, Settings};
use rta::request::scene_file::SceneFile;
use rta::study::report::Source;
use rta::study::report::spreading::page;
use rta::study::report::spreading::variance::{Costs, Variances};
use rta::study::report::spreading::{Spread, study};
use rta::study::report::study::Setup;
use rta_core::color::Rgb;
use rta_scenes::{Reading, shipped};

fn studied(text: &str, size: &str, aspect: f64) -> Spread {
    let scene = SceneFile::of_text("scene", text, Reading::default()).expect("a scene");
    let source = Source { scene, text: text.as_bytes().to_vec(), title: "scene".to_owned() };
    let (size, stop) = (size.parse().expect("a size"), AtomicBool::new(false));
    study(&source, Setup { size, aspect, program: None, stop: &stop }).expect("it fits")
}

/// Returns the slope, the first error and the last one of a way.
fn curve(spread: &Spread, way: [&str; 4]) -> (f64, f64, f64) {
    let curve = spread.curves.iter().find(|curve| curve.way == way).expect("the way is there");
    let error = |at: usize| curve.rows[at].error.rmse;
    (curve.slope.expect("a slope"), error(0), error(curve.rows.len() - 1))
}

/// A white floor from near by, straight down, so that what is over it decides.
fn floor(colors: &str, cover: &str) -> String {
    format!(
        "rta 1\nmodel lambert\ncamera at 0 0 3.5  look 0 0 -1  lens 500\nsky black\nambient black\n\
         floor {colors}  tile .00002\nlamp at 0 0 10  radius .5  power 50  square\n{cover}"
    )
}

/// Covers half of the lamp of [`floor`].
const HALF: &str = "triangle 0 -90 4  0 90 4  -90 0 4  color white\n";

#[test]
fn slopes_are_those_of_the_law() {
    // Edges on the lamp alone, and in the pixel alone: pairs of numbers each.
    let lamp = curve(&studied(&floor("white white", HALF), "96x96", 1.0), ["sobol", "area", "-", "1"]);
    println!("an edge before a lamp: slope {:.3}, errors {:.6} to {:.6}", lamp.0, lamp.1, lamp.2);
    assert!((-0.9..=-0.65).contains(&lamp.0), "{lamp:?}");
    let balls = "\
rta 1
camera at 0 -7 2  to 0 0 .8  lens 1.4
sky grey .6
ambient grey .9
floor .2 .2 .2  .2 .2 .2
lamp at -5 -6 8  radius 0  power 5  square
sphere at 0 0 .8  radius .8  color .9 .9 .9
sphere at 1.6 3.5 .8  radius .8  color .1 .1 .1
";
    let pixel = curve(&studied(balls, "160x120", 4.0 / 3.0), ["sobol", "point", "-", "-"]);
    println!("edges in pixels: slope {:.3}, errors {:.6} to {:.6}", pixel.0, pixel.1, pixel.2);
    assert!((-0.9..=-0.65).contains(&pixel.0), "{pixel:?}");

    let text = shipped::SPREADING.iter().find(|(name, _)| *name == "penumbra").expect("it is there").1;
    let spread = studied(text, "160x120", 4.0 / 3.0);
    // Here pixel and lamp cross edges together: four numbers, whose errors fall more slowly, and still faster than random ones.
    let (slope, first, last) = curve(&spread, ["sobol", "area", "-", "1"]);
    println!(
        "penumbra: slope {slope:.3}, errors {first:.6} to {last:.6}, of the reference {:.6}",
        spread.reference_error
    );
    assert!((-0.8..=-0.52).contains(&slope), "{slope}, from {first} to {last}");
    // The reference's own error is small beside the least of the others.
    assert!(spread.reference_error < 0.6 * last, "{} {last}", spread.reference_error);
    // What draws another picture stays away from this one.
    let (stays, _, hard) = curve(&spread, ["grid", "point", "-", "-"]);
    assert!(hard > 2.0 * last && stays > slope, "{hard} {last}, slopes {stays} {slope}");
    // Splitting a sample helps, and less than a sample more does.
    let split = curve(&spread, ["sobol", "area", "-", "4"]).1;
    let samples = spread.curves.iter().find(|curve| curve.way == ["sobol", "area", "-", "1"]).expect("there");
    assert!(split < first && samples.rows[1].error.rmse < split, "{split} {first}");
    // Pixels that are cut take more rays the deeper they are cut.
    let cut: Vec<_> = spread.curves.iter().filter(|curve| curve.way[2].starts_with("whitted:")).collect();
    let rays = |at: usize| cut[at].rows[0].rays.iter().sum::<u64>();
    assert!(cut.len() == 4 && (1..4).all(|at| rays(at - 1) < rays(at)), "{cut:?}");
    assert!(cut.iter().all(|curve| curve.slope.is_none()));

    let smooth = "\
rta 1
model lambert
camera at 0 0 3  look 0 0 -1  lens .5
sky black
ambient black
floor white white
lamp at 3 1 4  radius 0  power 8  square
";
    let smooth = studied(smooth, "96x96", 1.0);
    let (slope, first, last) = curve(&smooth, ["sobol", "point", "-", "-"]);
    assert!(slope < -1.3, "smooth light, with sobol: {slope}, from {first} to {last}");
    assert!(smooth.variances.is_none(), "its lamp is a point");
    let mut page = String::new();
    page::markdown(&mut page, &[spread, smooth]);
    for words in [
        "Variance of the lamps alone",
        "best split",
        "| sobol ",
        "whitted:2",
        "Pareto front of error against CPU time",
    ] {
        assert!(page.contains(words), "no {words:?} in {page}");
    }
}

#[test]
fn the_best_split_is_the_laws() {
    let costs = Costs { eye: 9.0, shadow: 1.0 };
    let variances =
        Variances { lamp: 4.0, pixel: 1.0, rays: costs, seconds: Costs { eye: 1.0, shadow: 4.0 } };
    assert!((variances.best_split(variances.rays) - 6.0).abs() < 1e-12);
    assert!((variances.best_split(variances.seconds) - 1.0).abs() < 1e-12);

    // In the middle of a penumbra half of the places on the lamp are seen, and half of a pixel's tiles are white: of the light E of a white
    // floor without a cover the lamp makes a variance of E^2/4 on half of the samples, and the pixel one of (E/2)^2/4.
    let open = SceneFile::of_text("open", &floor("white white", ""), Reading::default()).expect("a scene");
    let settings = Settings { model: open.description.model, aspect: 1.0, ..Settings::default() };
    let mut light = [Rgb::default()];
    Engine::new(&open.description, &settings).expect("it fits").linear_rows(0, &mut light);
    let whole = f64::from(light[0].r);
    assert!(whole > 0.1 && whole < 1.0, "{whole}");
    let variances = studied(&floor("white black", HALF), "96x96", 1.0).variances.expect("a lamp with a size");
    let (lamp, pixel) = (variances.lamp / whole.powi(2), variances.pixel / whole.powi(2));
    println!("variances {lamp} and {pixel} of E^2, 1/8 and 1/16 exactly; {variances:?}");
    assert!((lamp * 8.0 - 1.0).abs() < 0.06, "{lamp}, 1/8 exactly");
    assert!((pixel * 16.0 - 1.0).abs() < 0.06, "{pixel}, 1/16 exactly");
    // One ray from the eye, and one to the lamp from the half that is white: S is the root of 2 / (1/2).
    assert_eq!(variances.rays.eye, 1.0);
    assert!((variances.rays.shadow * 2.0 - 1.0).abs() < 0.06, "{:?}", variances.rays);
    let split = variances.best_split(variances.rays);
    println!("best split {split}, 2 exactly");
    assert!((split / 2.0 - 1.0).abs() < 0.06, "{split}");
}
