//! What `rta report --light` tells of light that goes round.

use core::sync::atomic::AtomicBool;

use rta::engine::bands;
use rta::request::scene_file::SceneFile;
use rta::study::report::Source;
use rta::study::report::light::diagram::{Axis, front};
use rta::study::report::light::method::Method;
use rta::study::report::light::{Study, page, study};
use rta::study::report::study::Setup;
use rta_scenes::Reading;

use super::folder::Folder;

/// A white room whose red wall colours the others, with a lamp in the ceiling and a table that throws a shadow.
const ROOM: &str = "\
rta 1
picture 24 24  screen 1 1
camera at 1 -2.4 1  look 0 1 0  lens 1.2
model lambert
material light  emits 6 6 6
quad 0 0 0  2 0 0  2 2 0  0 2 0  patches 6 6  color .7 .7 .7
quad .7 .7 1.99  .7 1.3 1.99  1.3 1.3 1.99  1.3 .7 1.99  color .5 .5 .5  of light
quad 0 0 2  0 2 2  2 2 2  2 0 2  patches 6 6  color .7 .7 .7
quad 0 2 0  2 2 0  2 2 2  0 2 2  patches 6 6  color .7 .7 .7
quad 0 0 0  0 2 0  0 2 2  0 0 2  patches 6 6  color .7 .1 .1
quad 2 2 0  2 0 0  2 0 2  2 2 2  patches 6 6  color .7 .7 .7
quad .4 .7 .8  1.1 .7 .8  1.1 1.3 .8  .4 1.3 .8  patches 2 2  color .7 .7 .7
";

fn studied(text: &str) -> Study {
    let scene = SceneFile::of_text("scene", text, Reading::default()).expect("a scene");
    let source = Source { scene, text: text.as_bytes().to_vec(), title: "scene".to_owned() };
    let (size, stop) = ("24x24".parse().expect("a size"), AtomicBool::new(false));
    let setup = Setup { size, aspect: 1.0, program: None, stop: &stop };
    study(&source, setup, 256, &bands::pool(Some(2)).expect("threads")).expect("a study")
}

/// Returns the least error of a method.
fn least(study: &Study, method: Method) -> f64 {
    let of = study.rows.iter().filter(|row| row.method == method);
    of.map(|row| row.error).min_by(f64::total_cmp).expect("a picture")
}

#[test]
fn each_method_errs_by_what_it_leaves_out() {
    let study = studied(ROOM);
    let [ambient, distributed, radiosity, two, cache, paths] =
        Method::ALL.map(|method| least(&study, method));
    println!(
        "{ambient} {distributed} {radiosity} {two} {cache} {paths}, reference {}",
        study.reference.error
    );
    // Soft shadows are better than sharp ones; light that goes round, than a constant; and lamps that are traced, than patches of their shadows.
    assert!(ambient > distributed && distributed > 2.0 * two && radiosity > 1.2 * two);
    // Where light is gathered for the picture, patches err less.
    assert!(cache < two, "{cache} {two}");
    // The constant is not dark, and paths, which have no bias, are as good as their noise.
    assert!(study.ambient.iter().all(|register| *register > 0.01), "{:?}", study.ambient);
    assert!(study.ambient[0] > study.ambient[1], "a red wall: {:?}", study.ambient);
    assert!(paths < 3.0 * study.reference.error, "{paths} {}", study.reference.error);
    let of = |method| study.rows.iter().filter(move |row| row.method == method);
    let noise: Vec<_> = of(Method::Paths).map(|row| row.error).collect();
    assert!(noise.windows(2).all(|pair| pair[1] < pair[0]), "{noise:?}");
    // Four times the patches and the rays take more of both, and bring the picture nearer.
    let by_patches: Vec<_> = of(Method::Radiosity)
        .filter(|row| row.samples == 16 && row.solving.is_some_and(|s| s.patches.is_some()))
        .collect();
    assert_eq!(by_patches.len(), 4);
    assert!(by_patches.windows(2).all(|pair| pair[0].rays[0] < pair[1].rays[0]));
    assert!(by_patches[3].error < by_patches[0].error);
    // Where a lamp is seen nothing is compared, and elsewhere everything is.
    let left_out = study.reference.compared.iter().filter(|is_compared| !**is_compared).count();
    assert!((4..100).contains(&left_out), "{left_out}");
    assert!(study.left_out.is_empty());
    let (factor, error) = study.reference.scaled_error(&study.best[3].1);
    assert!((factor - 1.0).abs() < 0.1 && error <= two, "{factor} {error} {two}");

    let best = front(&study.rows, Some(Method::TwoPasses), Axis::Work);
    assert!(
        best.windows(2).all(|pair| pair[0].error > pair[1].error && pair[0].all_rays() < pair[1].all_rays())
    );
    let text = page::markdown(&[study]);
    for words in ["## scene", "SIGGRAPH 86", "Radiosity alone", "| two passes ", "scene-light-pictures.png"] {
        assert!(text.contains(words), "no {words:?} in {text}");
    }
}

#[test]
fn rooms_without_light_that_goes_round_are_refused() {
    let folder = Folder::new();
    folder.scene("dark.rta", ROOM.replace("  of light", ""));
    let dark = folder.rta(&["report", "--light", "dark.rta", "-o", "out"]);
    let said = String::from_utf8(dark.stderr).expect("words");
    assert!(dark.status.code() == Some(2) && said.contains("dark.rta: nothing in it emits"), "{said}");
    folder.scene("moving.rta", format!("{ROOM}sphere at 1.5 1 .3  radius .3  moves .1 0 0\n"));
    folder.refuses(&["report", "--light", "moving.rta", "-o", "out"], &["nothing moves"]);
}

#[test]
fn the_report_has_its_files_and_its_costs() {
    let folder = Folder::new();
    // A floor below a lamp.
    let few: Vec<_> = ROOM.lines().take(8).collect();
    folder.scene("room.rta", few.join("\n"));
    let ended = folder.rta(&["report", "--light", "room.rta", "-o", "out", "--size", "6x6"]);
    assert!(ended.status.success() && ended.stderr.is_empty(), "{ended:?}");
    for name in
        ["light.md", "room-light.svg", "room-light.png", "room-light-seconds.svg", "room-light-pictures.png"]
    {
        assert!(std::fs::metadata(folder.path("out").join(name)).expect(name).len() > 1000, "{name}");
    }
    let table = std::fs::read_to_string(folder.path("out/light.csv")).expect("a table");
    let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    // Three of ambient light, four of distributed rays, five of paths; nine solutions three times alone, four times in two passes and with a cache.
    assert_eq!(rows.len(), 1 + 3 + 4 + 5 + 9 * (3 + 4 + 4));
    let has_valgrind = std::process::Command::new("valgrind").arg("--version").output().is_ok();
    for row in &rows[1..] {
        let [solving, drawing] = [row[5], row[6]].map(|cell| cell.parse::<u64>().expect("rays"));
        assert!(drawing >= 36 && (solving > 0) != row[2].is_empty(), "{row:?}");
        assert_eq!(row[7].parse::<f64>().is_ok_and(|count| count > 1000.0), has_valgrind, "{row:?}");
    }
}
