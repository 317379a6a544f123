//! Pictures that are traced in passes until their error is small, or their time is over.

use std::fs;
use std::process::Output;

use rta::engine::{Engine, Format, Settings, bands, passes::Passes};
use rta_core::sampling::Sobol;
use rta_scenes::sampler::{Integrator, Lamps, Sampler, Spreading};

use super::folder::{Folder, SCENE};

/// A penumbra, a rough mirror, a lens and something that moves.
const ALL: &str = "\
rta 1
camera at 0 -8 2  to 0 0 1  lens 1.2  aperture .4
sky horizon .8 .87 .97  zenith .15 .3 .65
floor .9 .9 .9  .1 .1 .1
lamp at -5 -6 8  radius 1  power 75  square
ambient grey .25
material brushed like mirror  roughness .3
sphere at 0 0 1  radius 1  color .9 .2 .1  of brushed
sphere at 2 3 1  radius 1  color .2 .8 .3  moves .5 0 0
";

/// Renders in passes and returns the words of the last line.
fn passes(folder: &Folder, args: &[&str]) -> String {
    let Output { status, stderr, .. } = folder.rta(&[&["render"], args].concat());
    let told = String::from_utf8(stderr).unwrap();
    assert!(status.success(), "{args:?}: {told}");
    told.lines().last().unwrap().to_owned()
}

/// Returns the number before some words.
fn before(told: &str, words: &str) -> String {
    told.split(words).next().and_then(|text| text.split(' ').next_back()).unwrap().to_owned()
}

fn error(told: &str) -> f64 {
    let error = told.split("; estimated error ").nth(1).and_then(|text| text.split([';', ',']).next());
    error.and_then(|error| error.parse().ok()).unwrap_or_else(|| panic!("no error in {told}"))
}

#[test]
fn a_picture_that_ended_is_the_one_with_as_many_samples() {
    let folder = Folder::new();
    folder.scene("all.rta", ALL);
    let cases = [
        ("f32", "out.png", &["--device", "none", "--lamps", "area"][..]),
        ("f32", "out.pfm", &["--device", "none", "--lamps", "area", "--split", "2"]),
        ("f64", "out.pfm", &["--device", "none", "--lamps", "fixed:4"]),
        ("q16", "out.png", &["--device", "vga", "--lamps", "area"]),
        ("q20", "out.ppm", &["--device", "graphigs", "--aperture", "0"]),
        ("q16", "out.png", &["--device", "pixrect", "--table", "tolerant", "--dither", "fs"]),
    ];
    for (format, file, options) in cases {
        let shared =
            [&["all.rta", "-o", file, "--size", "40x30", "--seed", "3", "--format", format], options]
                .concat();
        let told = passes(&folder, &[&shared[..], &["--until", "0.02", "--threads", "3"]].concat());
        assert!(error(&told) <= 0.02, "{told}");
        let samples = before(&told, " sobol samples a pixel, seed 3");
        let until = fs::read(folder.path(file)).unwrap();
        folder.renders(&[&shared[..], &["--samples", &samples]].concat());
        assert!(until == fs::read(folder.path(file)).unwrap(), "{told}");
        // The pass before was not enough.
        assert!(samples.parse::<u32>().unwrap() > 1, "{told}");
    }
    // A scene in which nothing spreads has edges still.
    let told = passes(&folder, &["scene.dat", "-o", "out.png", "--until", "0.01", "-s", "40x30"]);
    let samples = before(&told, " sobol samples a pixel, seed 0");
    let until = fs::read(folder.path("out.png")).unwrap();
    folder.renders(&[
        "scene.dat",
        "-o",
        "out.png",
        "-s",
        "40x30",
        "--sampler",
        "sobol",
        "--samples",
        &samples,
    ]);
    assert!(until == fs::read(folder.path("out.png")).unwrap(), "{told}");
}

#[test]
fn time_ends_a_picture_with_a_whole_pass() {
    let folder = Folder::new();
    folder.scene("all.rta", ALL);
    for (time, shortest, longest) in [("1ms", 0.0, 20.0), ("700ms", 0.7, 20.0)] {
        let began = std::time::Instant::now();
        let told = passes(&folder, &["all.rta", "-o", "out.png", "--until", time]);
        let took = began.elapsed().as_secs_f64();
        assert!(took >= shortest && took < longest, "{took}: {told}");
        let samples = before(&told, " sobol samples").parse::<u32>().unwrap();
        assert!(samples.is_power_of_two() && told.ends_with(" s"), "{told}");
        assert!(error(&told) > 0.0);
    }
}

/// Returns a picture of the scene in `f32` with its samples as they are asked for.
fn engine(samples: u32, seed: u32) -> Engine {
    let scene = rta_scenes::read(ALL.as_bytes(), "all.rta").expect("a scene");
    let samples = Sobol::new(samples, seed).expect("few");
    let sampling =
        Sampler::Sobol(Spreading { samples, lamps: Lamps::Area, split: 1, integrator: Integrator::Whitted });
    let settings = Settings {
        width: 96,
        height: 72,
        format: Format::F32,
        model: scene.model,
        sampling,
        ..Settings::default()
    };
    Engine::new(&scene, &settings).expect("it fits")
}

const PIXELS: usize = 96 * 72;

fn rms(a: &[rta_core::color::Rgb<f32>], b: &[rta_core::color::Rgb<f32>]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| {
        [(a.r, b.r), (a.g, b.g), (a.b, b.b)].iter().map(|(a, b)| f64::from(a - b).powi(2)).sum::<f64>()
    });
    (squares.sum::<f64>() / (3 * PIXELS) as f64).sqrt()
}

#[test]
fn the_estimated_error_is_the_true_one() {
    let pool = bands::pool(None).expect("threads");
    let stop = core::sync::atomic::AtomicBool::new(false);
    let black = || vec![rta_core::color::Rgb::default(); PIXELS];
    let added =
        |passes: &mut Passes| passes.pass(u32::MAX, &pool, &stop, None, &|_| {}).expect("nothing ends it");
    // Of another seed, with eight times as many samples at least: its own error is a fifth of the others' or less.
    let exact = engine(16, 1234);
    let mut exact = exact.passes().expect("memory");
    let mut truth = black();
    while exact.samples() < 512 {
        added(&mut exact);
    }
    exact.linear_rows(0, &mut truth);
    for seed in [0, 7] {
        let engine = engine(16, seed);
        let mut passes = engine.passes().expect("memory");
        assert!(passes.error().is_infinite() && passes.samples() == 0 && passes.next(1000) == 1);
        let mut light = black();
        while passes.samples() < 64 {
            let expected = passes.next(1000);
            added(&mut passes);
            assert_eq!(passes.samples(), expected);
            passes.linear_rows(0, &mut light);
            let (estimated, error) = (passes.error(), rms(&light, &truth));
            // A quarter of the pixels are asked, and few of them are in shadow's edge: within a fifth.
            let ratio = estimated / error;
            println!(
                "seed {seed}: {expected} samples, estimated {estimated:.6}, true {error:.6}, ratio {ratio:.3}"
            );
            assert!((0.8..1.2).contains(&ratio), "seed {seed}, {expected} samples: {estimated}, {error}");
        }
    }
}

#[cfg(target_os = "linux")]
#[test]
fn interrupts_leave_nothing_or_what_is_to_be_kept() {
    use core::time::Duration;
    use std::process::{Command, Stdio};
    use std::time::Instant;

    let folder = Folder::new();
    folder.scene("all.rta", ALL);
    let shared = ["all.rta", "-o", "out.png", "--size", "40x30"];
    for keeps in [false, true] {
        let args = [&["render"][..], &shared, &["--until", "1h"], if keeps { &["--keep"][..] } else { &[] }]
            .concat();
        let child = folder.command(&args).stderr(Stdio::piped()).spawn().unwrap();
        // Some passes at least.
        std::thread::sleep(Duration::from_millis(1500));
        let sent = Instant::now();
        assert!(Command::new("kill").args(["-TERM", &child.id().to_string()]).status().unwrap().success());
        let Output { status, stderr, .. } = child.wait_with_output().unwrap();
        let told = String::from_utf8(stderr).unwrap();
        assert_eq!(status.code(), Some(130), "{told}");
        assert!(sent.elapsed() < Duration::from_secs(10));
        if keeps {
            assert!(told.contains(", interrupted; "), "{told}");
            let samples = before(&told, " sobol samples");
            let kept = fs::read(folder.path("out.png")).unwrap();
            folder.renders(&[&shared[..], &["--samples", &samples]].concat());
            assert!(kept == fs::read(folder.path("out.png")).unwrap(), "{told}");
        } else {
            assert_eq!(folder.names(), ["all.rta", "scene.dat"], "{told}");
        }
    }
}

#[test]
fn without_a_display_the_picture_in_passes_is_written() {
    let folder = Folder::new();
    folder.scene("all.rta", ALL);
    let Output { status, stderr, .. } = folder.rta(&["show", "all.rta", "--until", "0.03", "-s", "40x30"]);
    assert!(status.success(), "{}", String::from_utf8_lossy(&stderr));
    let told = passes(&folder, &["all.rta", "-o", "out.png", "--until", "0.03", "-s", "40x30"]);
    let shown = folder.names().into_iter().find(|name| name.starts_with("rta-")).unwrap();
    assert!(fs::read(folder.path(&shown)).unwrap() == fs::read(folder.path("out.png")).unwrap(), "{told}");
}

#[test]
fn ends_that_make_no_sense_are_refused() {
    let folder = Folder::new();
    folder.scene("scene.dat", SCENE);
    folder.scene("all.rta", ALL);
    for end in ["0", "-1", "nan", "inf", "1", "30", "0s", "3 weeks", "3d", "1e-40s", ""] {
        let end = format!("--until={end}");
        folder.refuses(&["render", "all.rta", "-o", "out.png", &end], &["--until", "0.004", "30s"]);
        folder.refuses(&["show", "all.rta", &end], &["--until", "0.004", "30s"]);
    }
    for (options, word) in [
        (&["--aa", "whitted"][..], "--aa"),
        (&["--samples", "4"], "--samples"),
        (&["--jitter", "4"], "--jitter"),
        (&["--frames", "4"], "--frames"),
        (&["--rows", "0..4"], "--rows"),
        (&["--only", "0..4", "--frames", "8"], "--"),
        (&["--sampler", "grid"], "--sampler grid"),
    ] {
        folder
            .refuses(&[&["render", "all.rta", "-o", "out.gif", "--until", "1s"], options].concat(), &[word]);
    }
    folder.refuses(&["render", "all.rta", "-o", "out.png", "--keep"], &["--until"]);
    let prism = "spectral 9\nmaterial flint  transmit .9 specular .1 diffuse 0  index 1.62  abbe 33\nsphere at 0 -3 1  radius .5  of flint\n";
    folder.scene("prism.rta", ALL.replace("  moves .5 0 0", "") + prism);
    folder.refuses(&["render", "prism.rta", "-o", "out.png", "--until", "1s"], &["--until", "wavelengths"]);
    // What spreads nothing in any other command has no end.
    folder.refuses(&["hash", "all.rta", "--until", "1s"], &["--until"]);
}

#[test]
fn the_window_shows_passes_and_ends_with_the_picture_of_render() {
    use rta::args::{FilmArgs, ShowArgs};
    use rta::commands::show::{Command, Show};
    use rta::picture::device::{Device, Target};
    use rta::request::Request;
    use rta::request::scene_file::SceneFile;

    let folder = Folder::new();
    folder.scene("all.rta", ALL);
    let size = Some("40x30".parse().expect("a size"));
    let tracing = rta::args::TracingArgs { size, ..ShowArgs::default().tracing };
    for (until, device) in [(None, Device::Vga), (Some("0.02"), Device::Graphigs), (None, Device::Pixrect)] {
        let scene = SceneFile::open(&folder.path("all.rta")).expect("a scene");
        let target = Target::On(device);
        let request = Request::of_scene(&tracing, target, &scene).expect("a request");
        let end = until.map(|until| until.parse().expect("an end"));
        let request = request.until(end, &tracing, &scene).expect("it spreads");
        let mut show = Show::new(scene, None, (request, FilmArgs::default()), Some(2)).expect("it begins");
        let mut titles = Vec::new();
        let mut complete = |show: &mut Show| {
            while !show.is_complete() {
                show.advance(core::time::Duration::ZERO).expect("it goes on");
                titles.push(show.title());
            }
        };
        complete(&mut show);
        // Another depth and back: passes begin anew.
        show.obey(Command::Shallower);
        show.obey(Command::Deeper);
        assert!(!show.is_complete());
        complete(&mut show);
        let mut ppm = Vec::new();
        show.shown().expect("it answers").picture().write_ppm(&mut ppm).expect("memory takes it");
        let device = device.to_string();
        let options = ["all.rta", "-o", "-", "--as", "ppm", "-s", "40x30", "--device", &device];
        let samples = before(&show.title(), " samples, error ");
        assert!(
            ppm == folder.renders(&[&options[..], &["--samples", &samples]].concat()),
            "{}",
            show.title()
        );
        assert!(titles.iter().any(|title| title.contains("| 1 samples, error ")), "{titles:?}");
        assert!(until.is_some() || samples == "16", "{samples}");
    }
}
