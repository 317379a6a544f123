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

#[test]
fn slopes_are_those_of_the_law() {
    let text = shipped::SPREADING.iter().find(|(name, _)| *name == "penumbra").expect("it is there").1;
    let spread = studied(text, "160x120", 4.0 / 3.0);
    // The reference's own error is small beside the least of the others.
    let (slope, first, last) = curve(&spread, ["sobol", "area", "-", "1"]);
    assert!((-0.9..=-0.65).contains(&slope), "edges, with sobol: {slope}, from {first} to {last}");
    assert!(spread.reference_error < 0.5 * last, "{} {last}", spread.reference_error);
    // What draws another picture stays away from this one: lamps that are points, by far; four places, a little.
    let hard = curve(&spread, ["grid", "point", "-", "-"]).2;
    let fixed = curve(&spread, ["sobol", "fixed:4", "-", "-"]).2;
    assert!(hard > fixed && fixed > 2.0 * last, "{hard} {fixed} {last}");
    // Splitting a sample helps, and less than a sample more does.
    let split = curve(&spread, ["sobol", "area", "-", "4"]).1;
    let samples = spread.curves.iter().find(|curve| curve.way == ["sobol", "area", "-", "1"]).expect("there");
    assert!(split < first && samples.rows[1].error.rmse < split, "{split} {first}");
    // Pixels that are cut take more rays the deeper they are cut.
    let cut = spread.curves.iter().find(|curve| curve.way[2] == "whitted:0 to 3").expect("there");
    assert!(
        cut.slope.is_none()
            && cut
                .rows
                .windows(2)
                .all(|rows| { rows[0].rays.iter().sum::<u64>() < rows[1].rays.iter().sum::<u64>() }),
        "{cut:?}"
    );

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
        "whitted:0 to 3",
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
    let floor = |colors: &str, cover: &str| {
        format!(
            "rta 1\nmodel lambert\ncamera at 0 0 3.5  look 0 0 -1  lens 500\nsky black\nambient black\nfloor {colors}  tile .00002\n\
             lamp at 0 0 10  radius .5  power 50  square\n{cover}"
        )
    };
    let open = SceneFile::of_text("open", &floor("white white", ""), Reading::default()).expect("a scene");
    let settings = Settings { model: open.description.model, aspect: 1.0, ..Settings::default() };
    let mut light = [Rgb::default()];
    Engine::new(&open.description, &settings).expect("it fits").linear_rows(0, &mut light);
    let whole = f64::from(light[0].r);
    assert!(whole > 0.1 && whole < 1.0, "{whole}");
    let text = floor("white black", "triangle 0 -90 4  0 90 4  -90 0 4  color white\n");
    let variances = studied(&text, "96x96", 1.0).variances.expect("a lamp with a size");
    let (lamp, pixel) = (variances.lamp / whole.powi(2), variances.pixel / whole.powi(2));
    println!("variances {lamp} and {pixel} of E^2, 1/8 and 1/16 exactly; {variances:?}");
    assert!((lamp * 8.0 - 1.0).abs() < 0.06, "{lamp}, 1/8 exactly");
    assert!((pixel * 16.0 - 1.0).abs() < 0.06, "{pixel}, 1/16 exactly");
    // One ray from the eye, and one to the lamp: the square root of 2.
    assert_eq!(variances.rays, Costs { eye: 1.0, shadow: 1.0 });
    let split = variances.best_split(variances.rays);
    assert!((split / 2f64.sqrt() - 1.0).abs() < 0.06, "{split}");
}
