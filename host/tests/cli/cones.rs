//! Pictures by cones from the command line.

use std::fs;

use super::folder::{Folder, SCENE};

const BALLS: &str = "\
rta 1
camera at 0 -8 2  to 0 0 1  lens 1.2
sky horizon .8 .87 .97  zenith .15 .3 .65
floor .9 .9 .9  .1 .1 .1
lamp at -5 -6 8  radius 1  power 75  square
ambient grey .25
material brushed like mirror  roughness .3
sphere at 0 0 1  radius 1  color .9 .2 .1  of brushed
sphere at 2 3 1  radius 1  of crown
ellipsoid at -2 1 1  radii .5 .8 1  color .2 .5 .3  of shiny
";

const CONES: [&str; 4] = ["--integrator", "cones", "--size", "24x18"];

fn hash(folder: &Folder, args: &[&str]) -> String {
    folder.prints(&[&["hash", "balls.rta"], &CONES[..], args].concat())
}

#[test]
fn one_cone_a_pixel_is_traced_in_f64() {
    let folder = Folder::new();
    folder.scene("balls.rta", BALLS);
    let natural = hash(&folder, &["--format", "f64"]);
    assert!(natural.contains("format f64") && natural.contains(", cones"), "{natural}");
    assert_eq!(natural, hash(&folder, &["--format", "f32"]));
    assert_eq!(natural, hash(&folder, &["--format", "f64", "--threads", "3"]));
    let rays = folder.prints(&["hash", "balls.rta", "--size", "24x18", "--format", "f64"]);
    assert_ne!(natural[..16], rays[..16]);
    folder.renders(&["balls.rta", "-o", "out.png", "--integrator", "cones", "--size", "40x30"]);
    assert!(!fs::read(folder.path("out.png")).unwrap().is_empty());
    // The thesis's own scenes have ellipsoids and cylinders.
    folder.scene("scene.dat", SCENE);
    let told = folder.prints(&[&["hash", "scene.dat", "--format", "f64"], &CONES[..]].concat());
    assert!(told.contains(", cones"), "{told}");
}

#[test]
fn what_cones_do_not_know_is_refused() {
    let folder = Folder::new();
    folder.scene("balls.rta", BALLS);
    for (name, more) in [
        ("moves", "sphere at 0 -1 1  radius .2  moves 1 0 0  color 1 1 1\n"),
        ("square", "lamp corner 0 0 9  edges 1 0 0  0 1 0  power 3\n"),
        ("bright", "material bright  emits 2 2 2\nquad 0 0 9  1 0 9  1 1 9  0 1 9  of bright\n"),
    ] {
        folder.scene(&format!("{name}.rta"), BALLS.to_owned() + more);
    }
    let prism = "spectral 9\nmaterial flint  transmit .9 specular .1 diffuse 0  index 1.62  abbe 33\nsphere at 0 -1 1  radius .5  of flint\n";
    folder.scene("prism.rta", BALLS.to_owned() + prism);
    folder.scene("lens.rta", BALLS.replace("lens 1.2", "lens 1.2  aperture .3"));
    let refuses = |command: &[&str], options: &[&str], words: &[&str]| {
        folder.refuses(&[command, &["--integrator", "cones"], options].concat(), words);
    };
    let hash = |scene, options: &[&str], words: &[&str]| {
        refuses(&["hash", scene, "--format", "f64"], options, words);
    };
    hash("moves.rta", &[], &["cones", "move"]);
    hash("square.rta", &[], &["cones", "parallelograms"]);
    hash("bright.rta", &[], &["cones", "quads that emit"]);
    hash("prism.rta", &[], &["cones", "wavelengths", "--spectral 0"]);
    hash("lens.rta", &[], &["cones", "lens", "--aperture 0"]);
    let pinhole = ["hash", "lens.rta", "--integrator", "cones", "--aperture", "0", "--format", "f32"];
    assert!(folder.prints(&pinhole).contains(", cones"));
    refuses(&["hash", "balls.rta", "--format", "q16"], &[], &["cones", "f64", "q16"]);
    for option in [
        &["--samples", "4"][..],
        &["--jitter", "4"],
        &["--sampler", "sobol"],
        &["--seed", "1"],
        &["--lamps", "area"],
        &["--split", "2"],
    ] {
        hash("balls.rta", option, &["cones", option[0], "samples"]);
    }
    hash("balls.rta", &["--aa", "whitted"], &["--aa", "--integrator"]);
    refuses(&["render", "balls.rta", "-o", "out.png"], &["--until", "1s"], &["--until", "cones"]);
    refuses(&["render", "balls.rta", "-o", "out.png"], &["--tolerance", ".1"], &["--tolerance", "cones"]);
}
