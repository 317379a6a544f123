//! Rays that are spread, from a scene's text to its light, against exact values: 32 seeds, whose mean may be five standard errors away.

use rta_core::raster::Raster;
use rta_core::sampling::Sobol;
use rta_core::trace::dice::Sample;
use rta_core::{Q16, Q20};
use rta_packets::ShadowCache;
use rta_packets::picture::{Format, Picture, Setup};
use rta_scenes::sampler::{Integrator, Lamps, Sampler, Spreading};

const SEEDS: u32 = 32;
const SAMPLES: u32 = 64;

/// The part of a disc beyond a straight edge, `s` radii from its middle.
fn seg(s: f64) -> f64 {
    let s = s.clamp(-1.0, 1.0);
    (s.acos() - s * (1.0 - s * s).sqrt()) / core::f64::consts::PI
}

fn pictures<S: Format>(text: &str, lamps: Lamps) -> Vec<Box<dyn Picture<S>>> {
    let scene = rta_scenes::read(text.as_bytes(), "a scene.rta").expect("it is one");
    let picture = |seed| {
        let samples = Sobol::new(SAMPLES, seed).expect("few");
        let sampling =
            Sampler::Sobol(Spreading { samples, lamps, split: 1, integrator: Integrator::Whitted });
        let raster = Raster::new(64, 64).expect("small");
        let setup = Setup { raster, aspect: 1.0, depth: 4, cutoff: None, sampling };
        S::picture(&scene, scene.model, &setup).expect("it fits")
    };
    (0..SEEDS).map(picture).collect()
}

/// Returns mean and standard error over the seeds of the light at a place of the image plane, in the pixel in column `x`.
fn light<S: Format>(pictures: &[Box<dyn Picture<S>>], right: f64, x: u32) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for picture in pictures {
        let mut cache = ShadowCache::default();
        let samples = (0..SAMPLES).map(|number| {
            let place = (S::unit(right), S::unit(0.0));
            let sample = Sample { x, y: 7, number };
            S::light_to_f64(picture.sample(place, sample, &mut cache, &mut ()).r)
        });
        let mean = samples.sum::<f64>() / f64::from(SAMPLES);
        sums = [sums[0] + mean, sums[1] + mean * mean];
    }
    let n = f64::from(SEEDS);
    let mean = sums[0] / n;
    [mean, ((sums[1] / n - mean * mean).max(0.0) / (n - 1.0)).sqrt()]
}

const UNDER_A_LAMP: &str = "rta 1
model lambert
camera at 0 0 3.5  look 0 0 -1
sky black
ambient black
floor white white
lamp at 0 0 10  radius .5  power 100  square
";

/// Covers x < 0 at the height 4.
const HALF: &str = "triangle 0 -90 4  0 90 4  -90 0 4  color white\n";

fn penumbra<S: Format>(rounding: f64) {
    let hidden = pictures::<S>(&format!("{UNDER_A_LAMP}{HALF}"), Lamps::Area);
    let open = pictures::<S>(UNDER_A_LAMP, Lamps::Area);
    for k in 0..40u32 {
        let x = -0.39 + 0.02 * f64::from(k);
        let right = x / 3.5;
        let ([part, error], [whole, _]) = (light(&hidden, right, k), light(&open, right, k));
        let (part, error) = (part / whole, error / whole);
        // The edge hides x < 0, so that the lamp's part to the right of it is seen: for x < 0 less than half.
        let exact = seg(-x * 6.0 / (4.0 * 0.5));
        assert!(
            (part - exact).abs() < 5.0 * error + rounding,
            "{} at {x}: {part}, {exact} +- {error}",
            S::NAME
        );
    }
}

#[test]
fn a_penumbra_is_as_wide_as_it_should_be() {
    // The lamp is a sphere: its outline, seen aslant, is no circle by some thousandths.
    penumbra::<f64>(2e-3);
    penumbra::<f32>(2e-3);
    penumbra::<Q16>(2e-3);
    penumbra::<Q20>(2e-3);
}

#[test]
fn fixed_places_show_bands_and_others_none() {
    let text = format!("{UNDER_A_LAMP}{HALF}");
    let levels = |lamps| {
        let pictures = pictures::<f64>(&text, lamps);
        let lights = (0..100u32).map(|k| light(&pictures, (-0.3333 + 0.006_666 * f64::from(k)) / 3.5, k)[0]);
        // The light of the lamp falls by less than this over the penumbra.
        let mut distinct: Vec<f64> = Vec::new();
        for light in lights {
            if distinct.iter().all(|other| (other - light).abs() > 0.02) {
                distinct.push(light);
            }
        }
        distinct.len()
    };
    assert!(levels(Lamps::Fixed(2)) <= 5, "four places make at most four steps");
    assert!(levels(Lamps::Area) > 20);
}

fn blurred<S: Format>(rounding: f64) {
    // A black half in front of a white sky, twice as far as what is sharp: it blurs over 1/100 of the image plane.
    let text = "rta 1
model flat
camera at 0 0 0  look 0 1 0  lens 1  aperture .2  focus 5
sky white
ambient white
triangle 0 10 -90  0 10 90  -90 10 0  color black
";
    let pictures = pictures::<S>(text, Lamps::Point);
    for k in 0..40u32 {
        let s = -1.17 + 0.06 * f64::from(k);
        let [white, error] = light(&pictures, s * 0.01, k);
        let exact = 1.0 - seg(s);
        assert!(
            (white - exact).abs() < 5.0 * error + rounding,
            "{} at {s}: {white}, {exact} +- {error}",
            S::NAME
        );
    }
}

#[test]
fn an_edge_out_of_focus_is_blurred_as_it_should_be() {
    blurred::<f64>(1e-9);
    blurred::<f32>(1e-5);
    blurred::<Q16>(1e-3);
    blurred::<Q20>(1e-4);
}

#[test]
fn what_is_hardly_rough_is_smooth() {
    let text = |roughness: &str| {
        format!(
            "rta 1
camera at 0 -8 3  to 0 0 1  lens 1
sky horizon .8 .9 1  zenith .2 .3 .7
ambient grey .3
floor grey .6 grey .6
lamp at 5 -9 12  power 1
material pane  specular .3 transmit .7 diffuse 0 index 1.5  roughness {roughness}
material plate like mirror  roughness {roughness}
sphere at -1.2 0 1.1  radius 1  color white  of pane
sphere at 1.2 0 1.1  radius 1  color .9 .9 .9  of plate
"
        )
    };
    let [smooth, hardly, rough] =
        ["0", "1e-6", ".3"].map(|roughness| pictures::<f64>(&text(roughness), Lamps::Point));
    let (mut worst, mut changed) = (0.0f64, 0.0f64);
    for k in 0..40u32 {
        let right = -0.37 + 0.0187 * f64::from(k);
        let [still, near, far] = [&smooth, &hardly, &rough].map(|pictures| light(pictures, right, k)[0]);
        worst = worst.max((still - near).abs());
        changed = changed.max((still - far).abs());
    }
    assert!(worst < 1e-3 && changed > 0.05, "{worst}, {changed}");
}

#[test]
fn own_lobes_are_rough_materials() {
    let text = |model: &str, roughness: &str| {
        format!(
            "rta 1
model {model}
camera at 0 -8 3  to 0 0 1  lens 1
sky horizon .8 .9 1  zenith .2 .3 .7
ambient grey .3
floor grey .6 grey .2
lamp at 5 -9 12  power 90
material plate like mirror  {roughness}
sphere at -1.2 0 1.1  radius 1  of plate
sphere at 1.2 0 1.1  radius 1  color .9 .9 .9  of plate
"
        )
    };
    let [own, said, smooth] = [
        text("blinn-full trowbridge .3 lobes", ""),
        text("blinn-full trowbridge .3", "roughness .3"),
        text("blinn-full trowbridge .3", ""),
    ]
    .map(|text| pictures::<Q16>(&text, Lamps::Point));
    let mut changed = 0.0f64;
    for k in 0..40u32 {
        let right = -0.37 + 0.0187 * f64::from(k);
        let [own, said, smooth] = [&own, &said, &smooth].map(|pictures| light(pictures, right, k)[0]);
        assert!(own == said, "{own}, {said}");
        changed = changed.max((own - smooth).abs());
    }
    assert!(changed > 0.05, "{changed}");
}

/// Checks the part of the time that something bright is seen along y; `what` is the camera's own and the thing.
fn moving<S: Format>([optics, what]: [&str; 2], exact: f64) {
    // More balls, so that there is a hierarchy to search.
    let others: String =
        (0..30).map(|i| format!("sphere at {} 40 30  radius 1  color black\n", i * 3)).collect();
    let text = format!(
        "rta 1\npath p linear at 0 1 1 1  at .5 9 1 1  at 1 9 1 1\nmodel flat\ncamera at 0 0 0  look 0 1 0  lens 1{optics}\n\
         sky black\nambient black\n{what}  color white\n{others}"
    );
    let [part, error] = light(&pictures::<S>(&text, Lamps::Point), 0.0, 1);
    assert!((part - exact).abs() <= 5.0 * error + 1e-3, "{} {optics} {what}: {part}, {exact}", S::NAME);
}

#[test]
fn what_moves_is_seen_as_long_as_it_should_be() {
    for (optics, what, exact) in [
        ("", "sphere at -2 8 0  radius 1  moves 4 0 0", 0.5),
        ("", "sphere at -2 8 .5  radius 1  moves 4 0 0", 0.433_012_702),
        ("", "sphere at -.5 8 0  radius 1  moves 2 3 0", 0.75),
        ("", "sphere at 0 8 0  radius 1  moves 0 5 0", 1.0),
        // Only while it is on its way out of sight.
        ("  shutter .5 1", "sphere at -2 8 0  radius 1  moves 4 0 0", 0.5),
        ("  shutter .75 1", "sphere at -2 8 0  radius 1  moves 4 0 0", 0.0),
        // A lamp that is seen, and an eye.
        ("", "lamp at -2 8 .5  radius 1  moves 4 0 0", 0.433_012_702),
        ("  shutter .5 1", "lamp at -2 8 0  radius 1  moves 4 0 0", 0.5),
        ("  moves -4 0 0", "sphere at -2 8 .5  radius 1", 0.433_012_702),
        ("  moves 2 0 0  shutter .5 1", "sphere at -6 8 .5  radius 1  moves 10 0 0", 0.433_012_702),
        // Along a path, 8 to the right in half of the film, which goes on as long.
        ("  shutter 0 .25", "sphere at -2 8 .5  radius 1  along p", 0.433_012_702),
        ("  shutter 0 .25", "lamp at -2 8 .5  radius 1  along p", 0.433_012_702),
        ("  shutter 0 .25  along p", "sphere at 2 8 .5  radius 1", 0.433_012_702),
        ("  shutter .5 1", "sphere at -8 8 0  radius 1  along p", 1.0),
        ("", "sphere at 0 8 0  radius 1  along p", 1.0),
    ] {
        moving::<f64>([optics, what], exact);
        moving::<f32>([optics, what], exact);
        moving::<Q16>([optics, what], exact);
        moving::<Q20>([optics, what], exact);
    }
}
