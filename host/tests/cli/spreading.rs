//! Rays that are spread, and pixels that are cut, from the command line.

use std::fs;

use super::folder::{Folder, SCENE};

const LENS: &str = "\
rta 1
camera at 0 -8 2  to 0 0 1  lens 1.2  aperture .6
sky horizon .8 .87 .97  zenith .15 .3 .65
floor .9 .9 .9  .1 .1 .1
lamp at -5 -6 8  radius 1  power 75  square
ambient grey .25
material brushed like mirror  roughness .3
sphere at 0 0 1  radius 1  color .9 .2 .1  of brushed
sphere at 2 3 1  radius 1  of crown
";

fn hash(folder: &Folder, args: &[&str]) -> String {
    folder.prints(&[&["hash", "lens.rta", "--size", "24x18"], args].concat())
}

#[test]
fn what_spreads_is_drawn_with_samples_that_spread_it() {
    let folder = Folder::new();
    folder.scene("lens.rta", LENS);
    let natural = hash(&folder, &[]);
    assert!(natural.contains("16 sobol samples a pixel, seed 0"), "{natural}");
    assert_eq!(natural, hash(&folder, &["--sampler", "sobol", "--samples", "16", "--lamps", "point"]));
    let digits = |text: &str| text[..16].to_owned();
    let pinhole = hash(&folder, &["--sampler", "grid"]);
    assert!(!pinhole.contains("samples"), "{pinhole}");
    let all = [
        natural,
        pinhole,
        hash(&folder, &["--aperture", "0"]),
        hash(&folder, &["--focus", "3"]),
        hash(&folder, &["--seed", "1"]),
        hash(&folder, &["--lamps", "area"]),
        hash(&folder, &["--lamps", "area", "--split", "4"]),
        hash(&folder, &["--lamps", "fixed:4"]),
        hash(&folder, &["--lamps", "cone"]),
        hash(&folder, &["--samples", "5"]),
        hash(&folder, &["--aa", "whitted"]),
        hash(&folder, &["--aa", "whitted:1"]),
        hash(&folder, &["--aa", "mitchell"]),
    ];
    for (i, one) in all.iter().enumerate() {
        assert!(all[..i].iter().all(|other| digits(other) != digits(one)), "{one}");
    }
    assert!(all[7].contains("lamps fixed:4, split 1"), "{}", all[7]);
}

#[test]
fn pictures_do_not_depend_on_the_threads() {
    let folder = Folder::new();
    folder.scene("lens.rta", LENS);
    for options in [&["--lamps", "area", "--samples", "4"][..], &["--aa", "whitted"], &["--aa", "mitchell"]] {
        let picture = |threads, format| {
            let options = [options, &["--threads", threads, "--format", format]].concat();
            folder.renders(&[&["lens.rta", "-o", "out.png", "--size", "40x30"], &options[..]].concat());
            fs::read(folder.path("out.png")).expect("it is written")
        };
        for format in ["f32", "q20"] {
            assert_eq!(picture("1", format), picture("3", format), "{options:?} {format}");
        }
    }
}

#[test]
fn pictures_of_several_wavelengths_are_not_spread() {
    let folder = Folder::new();
    let prism = "picture 20 20  samples 4\nspectral 9\nmaterial flint  transmit .9 specular .1 diffuse 0  index 1.62  abbe 33\nsphere at 0 -3 1  radius .5  of flint\n";
    folder.scene("lens.rta", LENS.to_owned() + prism);
    assert!(hash(&folder, &[]).contains("4 regular samples"), "{}", hash(&folder, &[]));
    folder.refuses(&["hash", "lens.rta", "--lamps", "area"], &["--lamps", "wavelengths", "--spectral 0"]);
    assert!(hash(&folder, &["--spectral", "0", "--lamps", "area"]).contains("4 sobol samples"));
}

#[test]
fn options_that_contradict_each_other_are_refused() {
    let folder = Folder::new();
    folder.scene("scene.dat", SCENE);
    for (options, words) in [
        (&["--sampler", "grid", "--lamps", "area"][..], &["--lamps", "spread", "--sampler grid"][..]),
        (&["--sampler", "grid", "--seed", "3"], &["--seed", "--sampler grid"]),
        (&["--sampler", "grid", "--aperture", "1"], &["--aperture", "--sampler grid"]),
        (&["--sampler", "sobol", "--jitter", "3"], &["--jitter", "--seed"]),
        (&["--samples", "3"], &["--samples 3", "square number", "--sampler sobol"]),
        (&["--samples", "16385"], &["--samples", "16384"]),
        (&["--lamps", "fixed:3"], &["--lamps", "square number"]),
        (&["--split", "0"], &["--split", "1 to 1024"]),
        (&["--aperture", "wide"], &["--aperture", "0 or more"]),
        (&["--focus", "0"], &["--focus", "above 0"]),
        (&["--aa", "whitted:5"], &["--aa", "whitted:K"]),
        (&["--aa", "whitted", "--samples", "4"], &["--aa", "--samples"]),
        (&["--aa", "mitchell:2"], &["--aa", "mitchell"]),
        (&["--aa", "mitchell", "--jitter", "4"], &["--aa", "--jitter"]),
        (&["--aa", "mitchell", "--seed", "4"], &["--aa", "--seed"]),
    ] {
        folder.refuses(&[&["render", "scene.dat", "-o", "out.png"], options].concat(), words);
    }
}

/// A small room whose ceiling shines.
const ROOM: &str = "\
rta 1
camera at 0 -1.9 1  look 0 1 0  lens .8
model lambert
material bright  emits 2 2 2
box from -1 -2 0  to 1 1 2  inside  color .7 .6 .5
quad -.5 -.5 1.9  -.5 .5 1.9  .5 .5 1.9  .5 -.5 1.9  color .5 .5 .5  of bright
";

const PATHS: [&str; 2] = ["--integrator", "paths"];

#[test]
fn paths_are_followed_where_they_are_asked_for() {
    let folder = Folder::new();
    folder.scene("lens.rta", ROOM);
    let natural = hash(&folder, &PATHS);
    assert!(natural.contains("16 sobol samples a pixel, seed 0, paths of at most 64 bounces"), "{natural}");
    let whitted = hash(&folder, &[]);
    assert_eq!(whitted, hash(&folder, &["--integrator", "whitted"]));
    let digits = |text: &str| text[..16].to_owned();
    let all = [
        natural.clone(),
        whitted,
        hash(&folder, &[&PATHS[..], &["--depth", "1"]].concat()),
        hash(&folder, &[&PATHS[..], &["--seed", "1"]].concat()),
        hash(&folder, &[&PATHS[..], &["--samples", "32"]].concat()),
    ];
    for (i, one) in all.iter().enumerate() {
        assert!(all[..i].iter().all(|other| digits(other) != digits(one)), "{one}");
    }
    assert_eq!(digits(&natural), digits(&hash(&folder, &[&PATHS[..], &["--threads", "3"]].concat())));
}

#[test]
fn linear_light_of_paths_is_not_cut() {
    let folder = Folder::new();
    folder.scene("lens.rta", ROOM);
    let options = ["--device", "none", "--size", "16x16", "-q"];
    folder.prints(&[&["render", "lens.rta", "-o", "light.pfm"], &options[..], &PATHS[..]].concat());
    let file = fs::read(folder.path("light.pfm")).unwrap();
    let light = |bytes: &[u8]| f32::from_le_bytes(bytes.try_into().unwrap());
    let brightest = file[file.len() - 16 * 16 * 12..].chunks(4).map(light).fold(0.0f32, f32::max);
    // The lamp is seen with its own light, of the radiance 2 and what it sends back.
    assert!(brightest > 1.5, "{brightest}");
}

#[test]
fn passes_of_paths_draw_the_picture_of_as_many_samples() {
    let folder = Folder::new();
    folder.scene("lens.rta", ROOM);
    let render = |output: &str, options: &[&str]| {
        let size = ["--size", "24x18", "--device", "none", "-q"];
        folder.prints(&[&["render", "lens.rta", "-o", output], &size[..], &PATHS[..], options].concat());
        fs::read(folder.path(output)).unwrap()
    };
    for (end, file_type) in [("png", "png"), ("pfm", "pfm")] {
        let until = render(&format!("until.{end}"), &["--until", "0.05", "--as", file_type]);
        let is_there = [1, 2, 4, 8, 16, 32, 64, 128, 256].map(|samples: u32| {
            let samples = samples.to_string();
            render(&format!("whole.{end}"), &["--samples", &samples, "--as", file_type]) == until
        });
        assert_eq!(is_there.iter().filter(|is_it| **is_it).count(), 1, "{end}");
    }
    render("settled.png", &["--tolerance", ".1"]);
}

#[test]
fn paths_are_refused_where_there_are_none() {
    let folder = Folder::new();
    let prism = "spectral 9\nmaterial flint  transmit .9 specular .1 diffuse 0  index 1.62  abbe 33\nsphere at 0 -1 1  radius .5  of flint\n";
    folder.scene("lens.rta", ROOM);
    folder.scene("prism.rta", ROOM.to_owned() + prism);
    folder.scene("moves.rta", ROOM.to_owned() + "sphere at 0 -1 1  radius .2  moves 1 0 0  color 1 1 1\n");
    let refuses = |scene, options: &[&str], words: &[&str]| {
        folder.refuses(&[&["hash", scene], &PATHS[..], options].concat(), words);
    };
    refuses("prism.rta", &[], &["--integrator paths", "wavelengths", "--spectral 0"]);
    refuses("moves.rta", &[], &["--integrator paths", "moves"]);
    refuses("moves.rta", &["--aa", "whitted"], &["--aa", "--integrator"]);
    refuses("lens.rta", &["--sampler", "grid"], &["--integrator paths", "grid"]);
}
