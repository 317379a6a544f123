//! Pictures whose pixels end early where their samples agree.

use super::folder::Folder;

/// A penumbra on a floor, beside a ball.
const PENUMBRA: &str = "\
rta 1
model lambert
camera at 0 -8 3  look 0 1 -.3  lens 1.3
sky black
floor grey .6  grey .6
lamp at -3 -3 8  radius 1  power 60  square
sphere at 0 0 1  radius 1  color .8 .4 .3
";

const SHARED: [&str; 8] = ["a.rta", "-o", "out.pfm", "--device", "none", "--size", "48x36", "--lamps"];

/// Renders and returns the light, and the last line.
fn rendered(folder: &Folder, args: &[&str]) -> (Vec<f32>, String) {
    let ended = folder.rta(&[&["render"], &SHARED[..], args].concat());
    let told = String::from_utf8(ended.stderr).expect("text");
    assert!(ended.status.success(), "{args:?}: {told}");
    let bytes = std::fs::read(folder.path("out.pfm")).expect("a picture");
    let floats = bytes["PF\n48 36\n-1.0\n".len()..].chunks_exact(4);
    let light = floats.map(|float| f32::from_le_bytes(float.try_into().expect("four bytes"))).collect();
    (light, told.lines().last().expect("a line").to_owned())
}

fn rms(a: &[f32], b: &[f32]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| f64::from(a.min(1.0) - b.min(1.0)).powi(2));
    (squares.sum::<f64>() / a.len() as f64).sqrt()
}

fn mean(told: &str) -> f64 {
    let mean = told.split(" samples in the mean").next().and_then(|text| text.split(' ').next_back());
    mean.and_then(|mean| mean.parse().ok()).unwrap_or_else(|| panic!("no mean in {told}"))
}

#[test]
fn samples_are_taken_where_they_are_needed() {
    let folder = Folder::new();
    folder.scene("a.rta", PENUMBRA);
    let (truth, _) = rendered(&folder, &["area", "--samples", "1024", "--seed", "9"]);
    let of = |args: &[&str]| rendered(&folder, &[&["area"], args].concat());
    let error = |args: &[&str]| rms(&of(args).0, &truth);
    let (picture, told) = of(&["--tolerance", ".02"]);
    assert!(told.contains("at most") && told.contains("tolerance 0.02"), "{told}");
    // As good as three times as many everywhere.
    assert!(mean(&told) < 16.0 && mean(&told) >= 4.0, "{told}");
    assert!(rms(&picture, &truth) < error(&["--samples", "32"]), "{told}");
    // The most samples are the most, and of a pixel that goes on all are taken.
    let (most, told) = of(&["--tolerance", "0.00025", "--samples", "8"]);
    assert!(mean(&told) <= 8.0 && rms(&most, &of(&["--samples", "8"]).0) < 1e-3, "{told}");
    // With a wide tolerance a pixel has the fewest samples.
    let (few, told) = of(&["--tolerance", "1"]);
    assert!(mean(&told) == 4.0 && few == of(&["--samples", "4"]).0, "{told}");
    let (fewer, told) = of(&["--tolerance", "1:2"]);
    assert!(mean(&told) == 2.0 && fewer == of(&["--samples", "2"]).0, "{told}");
    // From one sample on, with four places on the lamp: as good as twice the rays.
    let (cheap, told) = of(&["--tolerance", ".02:1", "--split", "4"]);
    assert!(mean(&told) < 8.0, "{told}");
    assert!(rms(&cheap, &truth) < error(&["--samples", "8", "--split", "4"]), "{told}");
}

#[test]
fn threads_and_formats_agree() {
    let folder = Folder::new();
    folder.scene("a.rta", PENUMBRA);
    for format in ["f32", "f64", "q16", "q20"] {
        let of = |threads| {
            rendered(&folder, &["area", "--tolerance", ".03", "--format", format, "--threads", threads])
        };
        let (one, two) = (of("1"), of("3"));
        assert!(one.0 == two.0 && mean(&one.1) == mean(&two.1), "{format}");
    }
}

#[test]
fn what_makes_no_sense_is_refused() {
    let folder = Folder::new();
    folder.scene("a.rta", PENUMBRA);
    for (args, words) in [
        (&["--tolerance", "0"][..], "part of white"),
        (&["--tolerance", "nan"], "part of white"),
        (&["--tolerance", ".02:0"], "part of white"),
        (&["--tolerance", ".01", "--until", "1s"], "cannot be used with"),
        (&["--tolerance", ".01", "--aa", "whitted"], "cannot be used with"),
        (&["--tolerance", ".01", "--rows", "0..2"], "cannot be used with"),
        (&["--tolerance", ".01", "--sampler", "grid"], "--tolerance"),
    ] {
        folder.refuses(&[&["render", "a.rta", "-o", "out.png"], args].concat(), &[words]);
    }
}
