//! What must not change a picture, and what must.

use core::f64::consts::PI;

use rta::engine::{Engine, EngineError, Format};
use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, Rta, Secondary, Surface};
use rta_core::light::Incident;
use rta_core::material::Material;
use rta_core::needs::{Everything, Needs, missing};
use rta_core::trace::Tracer;
use rta_core::{Error, Q16};
use rta_scenes::description::{self, Description};
use rta_scenes::narrow::narrow;
use rta_tests::exact::{DEPTH, Exact, shipped_scene};
use rta_tests::measure::{direction, place, read_light};
use rta_tests::picture::{render, settings, share_within};
use rta_tests::{assert_close, oracle, random_scenes};

const SHIPPED: [&str; 3] = ["juggler", "hall-22", "glass-2"];

fn q16(scene: &Description, depth: u32) -> Vec<Rgb<i32>> {
    Exact::new(scene, 160, 100).picture::<_, Everything>(Rta, depth).expect("it is drawn")
}

/// The same things in another order.
fn shuffled(scene: &Description, seed: u64) -> Description {
    let (mut scene, mut dice) = (scene.clone(), fastrand::Rng::with_seed(seed));
    dice.shuffle(&mut scene.cylinders);
    dice.shuffle(&mut scene.ellipsoids);
    dice.shuffle(&mut scene.spheres);
    dice.shuffle(&mut scene.lamps);
    scene
}

#[test]
fn the_order_of_things_makes_no_difference() {
    let shipped = SHIPPED.map(|name| (name, shipped_scene(name)));
    for (name, scene) in shipped.into_iter().chain(random_scenes::all()) {
        let picture = q16(&scene, DEPTH);
        for seed in [1, 2] {
            let other = shuffled(&scene, seed);
            let apart = q16(&other, DEPTH).iter().zip(&picture).filter(|(a, b)| a != b).count();
            assert_eq!(apart, 0, "{name}: {apart} pixels differ in order {seed}");
        }
    }
    assert_ne!(shuffled(&shipped_scene("juggler"), 1), shipped_scene("juggler"), "it has been shuffled");
}

#[test]
fn light_only_grows_with_depth() {
    for name in SHIPPED {
        let scene = shipped_scene(name);
        let mut last = q16(&scene, 0);
        let mut differences = 0;
        for depth in [1, 2, 3, 5, 16] {
            let next = q16(&scene, depth);
            for (a, b) in last.iter().zip(&next) {
                assert!(
                    a.r <= b.r && a.g <= b.g && a.b <= b.b,
                    "{name}: {b:?} at depth {depth}, {a:?} before"
                );
                differences += usize::from(a != b);
            }
            last = next;
        }
        assert!(differences > 0, "{name}: depth makes a difference");
    }
}

#[test]
fn at_depth_0_mirrors_and_glass_are_black() {
    for name in SHIPPED {
        let scene = shipped_scene(name);
        let mut absent = scene.clone();
        // Where a mirror or a glass is seen, black mirrors change nothing at depth 0.
        for sphere in &mut absent.spheres {
            if !matches!(sphere.surface, description::Surface::Opaque | description::Surface::Shiny) {
                sphere.color = [0.0; 3];
            }
        }
        let flat = q16(&scene, 0);
        assert_eq!(flat, q16(&absent, 0), "{name}");
        let deep = q16(&scene, 1);
        let black = Rgb::new(0, 0, 0);
        let spawned = flat.iter().zip(&deep).filter(|(a, b)| a != b);
        assert!(spawned.clone().count() > 50, "{name}: secondary rays bring light");
        assert!(
            spawned.clone().all(|(a, _)| *a == black),
            "{name}: a mirror is black before its ray is traced"
        );
    }
}

#[test]
fn every_depth_is_that_of_the_model() {
    for name in SHIPPED {
        let scene = shipped_scene(name);
        for depth in [0, 1, 5, 16] {
            let at = rta::engine::Settings { width: 96, height: 60, depth, ..settings(Format::F64) };
            let want = oracle::render(&scene, 96, 60, at.aspect, depth);
            let share = share_within(&render(&scene, &at).expect("it is drawn"), &want, 1e-3);
            assert!(share >= 99.9, "{name} at depth {depth}: {share} % within 1e-3 of the oracle");
        }
    }
}

#[test]
fn a_depth_beyond_the_stack_is_an_error() {
    let scene = narrow::<Q16>(&shipped_scene("glass-2"), 1.0).expect("it fits");
    let tracer = |depth| {
        let admitted = scene.scene().admit(&scene.camera).expect("it fits");
        Tracer::<_, _, Everything, 5>::new(admitted, Rta, depth).map(|_| ())
    };
    assert_eq!(tracer(5), Ok(()));
    for depth in [6, 255, 256, 261, u32::MAX] {
        assert_eq!(tracer(depth), Err(Error::Depth { depth, capacity: 5 }));
    }
    let at = |depth| {
        let settings = rta::engine::Settings { depth, ..settings(Format::Q16) };
        Engine::new(&shipped_scene("glass-2"), &settings).map(|_| ())
    };
    assert_eq!(at(32), Ok(()));
    assert_eq!(at(33), Err(EngineError::Core(Error::Depth { depth: 33, capacity: 32 })));
}

#[test]
fn a_cutoff_leaves_out_the_faint_rays() {
    let glass = ball(description::Surface::Transparent { ks: 0.3, kt: 0.7, ior: 1.5 });
    let narrowed = narrow::<f64>(&glass, 1.0).expect("it fits");
    let admitted = narrowed.scene().admit(&narrowed.camera).expect("it fits");
    let tracer: Tracer<_, _, Everything, 16> = Tracer::new(admitted, Rta, 16).expect("no deeper");
    let [eye, towards] = [place::<f64>([0.0, -9.0, 0.5]), direction::<f64>([0.0, 1.0, 0.0])];
    // What leaves the sphere: 0.3, then 0.7 0.7 0.3^n; what stays in it: 0.7 0.3^n.
    for (cutoff, want) in [(0.8, 0.0), (0.5, 0.0), (0.25, 0.79), (0.1, 0.937), (0.05, 0.937), (0.04, 0.9811)]
    {
        let [r, g, b] = read_light::<f64>(tracer.with_cutoff(cutoff).radiance(eye, towards));
        for register in [r, g, b] {
            assert_close!(register, want, 1e-12, "of the sky", "cut off at {cutoff}");
        }
    }
}

/// Diffuse spheres on a floor, as a small program would have them.
struct Plain;

impl Needs for Plain {
    const ELLIPSOIDS: bool = false;
    const CYLINDERS: bool = false;
    const SKY_GRADIENT: bool = false;
    const VISIBLE_LAMPS: bool = false;
    const GLINT: bool = false;
    const MIRROR: bool = false;
    const GLASS: bool = false;
    const TRANSPARENT_SHADOWS: bool = false;
}

fn plain() -> Description {
    let mut scene = shipped_scene("juggler");
    scene.spheres.iter_mut().for_each(|sphere| sphere.surface = description::Surface::Opaque);
    scene.lamps.iter_mut().for_each(|lamp| lamp.radius = 0.0);
    scene.sky.zenith = scene.sky.horizon;
    scene
}

#[test]
fn a_small_set_of_needs_draws_the_same_bytes() {
    let exact = Exact::new(&plain(), 160, 100);
    assert_eq!(missing::<Plain, _>(&exact.scene().scene()), None);
    let small = exact.picture::<_, Plain>(Rta, DEPTH);
    assert_eq!(small, exact.picture::<_, Everything>(Rta, DEPTH));
    // Where more is needed it is missing from the picture, too.
    let juggler = Exact::new(&shipped_scene("juggler"), 160, 100);
    assert!(missing::<Plain, _>(&juggler.scene().scene()).is_some());
    assert_ne!(juggler.picture::<_, Plain>(Rta, DEPTH), juggler.picture::<_, Everything>(Rta, DEPTH));
}

/// Makes for each constant of `Needs` the set that lacks only that, and what `missing` says of it.
macro_rules! without {
    ($scene:expr, $($need:ident)*) => {
        [$({
            struct Without;
            impl Needs for Without {
                const $need: bool = false;
            }
            (stringify!($need), missing::<Without, _>($scene))
        }),*]
    };
}

#[test]
fn missing_names_what_is_lacking() {
    let all = random_scenes::all();
    let (_, every_type) =
        all.iter().find(|(name, _)| *name == "every-type").expect("a scene with everything");
    let mut scene = every_type.clone();
    scene.lamps.iter_mut().for_each(|lamp| lamp.radius = 0.5);
    let narrowed = narrow::<Q16>(&scene, 1.0).expect("it fits");
    assert_eq!(missing::<Everything, _>(&narrowed.scene()), None);
    for (need, said) in without!(
        &narrowed.scene(),
        SPHERES ELLIPSOIDS CYLINDERS FLOOR SKY_GRADIENT VISIBLE_LAMPS GLINT MIRROR GLASS TRANSPARENT_SHADOWS
    ) {
        assert_eq!(said, Some(need));
    }
    let simple = narrow::<Q16>(&plain(), 1.0).expect("it fits");
    for (need, said) in without!(
        &simple.scene(),
        ELLIPSOIDS CYLINDERS SKY_GRADIENT VISIBLE_LAMPS GLINT MIRROR GLASS TRANSPARENT_SHADOWS
    ) {
        assert_eq!(said, None, "{need}");
    }
}

#[test]
fn everything_a_set_leaves_out_it_does_not_draw() {
    let all = random_scenes::all();
    let (_, scene) = all.iter().find(|(name, _)| *name == "every-type").expect("a scene with everything");
    let exact = Exact::new(scene, 160, 100);
    let whole = exact.picture::<_, Everything>(Rta, DEPTH).expect("it is drawn");
    macro_rules! differs_without {
        ($($need:ident)+) => {{
            struct Without;
            impl Needs for Without {
                $(const $need: bool = false;)+
            }
            let part = exact.picture::<_, Without>(Rta, DEPTH).expect("it is drawn");
            assert!(part != whole, "{} makes no difference", stringify!($($need)+));
            part
        }};
    }
    differs_without!(SPHERES);
    differs_without!(ELLIPSOIDS);
    differs_without!(CYLINDERS);
    differs_without!(FLOOR);
    differs_without!(SKY_GRADIENT);
    differs_without!(GLINT);
    differs_without!(SHADOWS);
    differs_without!(TRANSPARENT_SHADOWS);
    // Glass takes mirrors, so that these can only be left out together.
    let reflections = differs_without!(GLASS);
    let none = differs_without!(GLASS MIRROR);
    assert!(none != reflections, "MIRROR makes no difference");
}

/// Coloured glass by the law of Beer and Lambert: what has gone the way `d` through it is left with `exp(-a d)`.
struct Absorbing {
    /// Absorption of each register on one unit of the way.
    absorption: [f64; 3],
}

impl Illumination<f64> for Absorbing {
    type Weight = Rgb<f64>;

    fn ambient<N: Needs>(&self, _: &Surface<f64>, _: Rgb<f64>) -> Rgb<f64> {
        Rgb::BLACK
    }

    fn is_lit<N: Needs>(&self, _: &Surface<f64>) -> bool {
        false
    }

    fn direct<N: Needs>(&self, _: &Surface<f64>, _: &Incident<f64>) -> Rgb<f64> {
        Rgb::BLACK
    }

    fn secondary<N: Needs>(&self, surface: &Surface<f64>) -> Secondary<Rgb<f64>> {
        let Material::Transparent(glass) = surface.material else { return Secondary::NONE };
        let left = |a: f64| if surface.inside { (-a * surface.distance).exp() } else { 1.0 };
        let [r, g, b] = self.absorption.map(left);
        let part = |k: f64| (k > 0.0).then_some(Rgb::new(k * r, k * g, k * b));
        Secondary { reflected: part(glass.ks), transmitted: part(glass.kt) }
    }
}

/// One sphere of radius 2 about the origin, under a sky of radiance 1.
fn ball(surface: description::Surface) -> Description {
    let mut scene = shipped_scene("glass-2");
    let sphere = scene.spheres.first().expect("it has two").clone();
    let (position, color) = ([0.0; 3], [1.0; 3]);
    scene.spheres = vec![description::Sphere { position, color, radius: 2.0, surface, ..sphere }];
    scene.lamps.clear();
    scene.floor = None;
    scene.sky = description::Sky { horizon: [1.0; 3], zenith: [1.0; 3] };
    scene
}

fn look(
    scene: &Description,
    model: impl Illumination<f64>,
    depth: u32,
    eye: [f64; 3],
    towards: [f64; 3],
) -> [f64; 3] {
    let narrowed = narrow::<f64>(scene, 1.0).expect("it fits");
    let admitted = narrowed.scene().admit(&narrowed.camera).expect("it fits");
    let tracer: Tracer<_, _, Everything, 16> = Tracer::new(admitted, model, depth).expect("no deeper");
    read_light::<f64>(tracer.radiance(place::<f64>(eye), direction::<f64>(towards)))
}

#[test]
fn a_model_can_absorb_light_on_its_way() {
    let absorption = [0.0, 0.3, 1.7];
    for (ior, height) in [(1.0, 0.0), (1.0, 1.2), (1.5, 0.0), (1.5, 1.0), (1.5, 1.9)] {
        let chord = 4.0 * (1.0 - (height / 2.0_f64 / ior).powi(2)).sqrt();
        let [eye, towards] = [[0.0, -9.0, height], [0.0, 1.0, 0.0]];
        let clear = ball(description::Surface::Transparent { ks: 0.0, kt: 1.0, ior });
        let got = look(&clear, Absorbing { absorption }, 2, eye, towards);
        for (got, a) in got.into_iter().zip(absorption) {
            assert_close!(
                got,
                (-a * chord).exp(),
                1e-12,
                "of the sky",
                "index {ior}, height {height}, a {a}"
            );
        }
        // With reflections: the light of each way through adds up to a geometric series.
        let ks = 0.25;
        let glass = ball(description::Surface::Transparent { ks, kt: 1.0 - ks, ior });
        for depth in [2, 6, 16] {
            let got = look(&glass, Absorbing { absorption }, depth, eye, towards);
            for (got, a) in got.into_iter().zip(absorption) {
                let left = (-a * chord).exp();
                let ways = i32::try_from(depth - 1).expect("small");
                let series = (1.0 - (ks * left).powi(ways)) / (1.0 - ks * left);
                let want = ks + (1.0 - ks).powi(2) * left * series;
                assert_close!(
                    got,
                    want,
                    1e-12,
                    "of the sky",
                    "index {ior}, height {height}, a {a}, depth {depth}"
                );
            }
        }
    }
}

/// Thin stuff that glows with the lamps behind it as well, each as bright as its solid angle.
struct Translucent;

impl Illumination<f64> for Translucent {
    type Weight = f64;
    const BOTH_SIDES: bool = true;

    fn ambient<N: Needs>(&self, _: &Surface<f64>, _: Rgb<f64>) -> Rgb<f64> {
        Rgb::BLACK
    }

    fn is_lit<N: Needs>(&self, _: &Surface<f64>) -> bool {
        true
    }

    fn direct<N: Needs>(&self, surface: &Surface<f64>, incident: &Incident<f64>) -> Rgb<f64> {
        // Steradians; red from the side of the eye, blue from the other.
        let light = 4.0 * PI * incident.solid_angle() * incident.cosine.abs();
        let side = if incident.cosine > 0.0 { Rgb::new(1.0, 0.0, 0.0) } else { Rgb::new(0.0, 0.0, 1.0) };
        side.zip(surface.color, |part, color| part * color * light)
    }

    fn secondary<N: Needs>(&self, _: &Surface<f64>) -> Secondary<f64> {
        Secondary::NONE
    }
}

/// The same without light from behind.
struct OneSided;

impl Illumination<f64> for OneSided {
    type Weight = f64;

    fn ambient<N: Needs>(&self, s: &Surface<f64>, a: Rgb<f64>) -> Rgb<f64> {
        Translucent.ambient::<N>(s, a)
    }

    fn is_lit<N: Needs>(&self, surface: &Surface<f64>) -> bool {
        Translucent.is_lit::<N>(surface)
    }

    fn direct<N: Needs>(&self, surface: &Surface<f64>, incident: &Incident<f64>) -> Rgb<f64> {
        Translucent.direct::<N>(surface, incident)
    }

    fn secondary<N: Needs>(&self, surface: &Surface<f64>) -> Secondary<f64> {
        Translucent.secondary::<N>(surface)
    }
}

#[test]
fn a_model_can_take_light_from_both_sides_by_solid_angle() {
    let mut scene = ball(description::Surface::Opaque);
    scene.spheres.clear();
    scene.floor = Some(description::Floor { colors: [[0.5; 3]; 2] });
    let lamp = shipped_scene("glass-2").lamps.first().expect("it has two").clone();
    let at = |position, radius| description::Lamp { position, radius, ..lamp.clone() };
    scene.lamps = vec![at([1.0, 1.0, 4.0], 0.8), at([4.0, 1.0, -4.0], 2.0)];
    let [eye, towards] = [[1.0, -5.0, 6.0], [0.0, 6.0, -6.0]];
    let cap = |radius: f64, d: f64| 2.0 * PI * (1.0 - (1.0 - (radius / d).powi(2)).sqrt());
    let (above, below) = (0.5 * cap(0.8, 4.0), 0.5 * cap(2.0, 5.0) * 0.8);
    let [r, g, b] = look(&scene, Translucent, 0, eye, towards);
    assert_close!(r, above, 1e-12, "of white");
    assert_close!(b, below, 1e-12, "of white");
    assert_close!(g, 0.0, 0.0, "of white");
    assert_close!(look(&scene, OneSided, 0, eye, towards)[2], 0.0, 0.0, "of white");
    // Something below the floor casts its shadow from there; the floor itself does not.
    let hidden = description::Sphere {
        position: [2.5, 1.0, -2.0],
        color: [1.0; 3],
        radius: 0.5,
        surface: description::Surface::Opaque,
        line: 0,
    };
    scene.spheres.push(hidden);
    let [r, _, b] = look(&scene, Translucent, 0, eye, towards);
    assert_close!(r, above, 1e-12, "of white");
    assert_close!(b, 0.0, 0.0, "of white");
}
