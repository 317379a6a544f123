//! Order of objects and recursion depth: which changes of them leave a picture as it is, and which change it how.

use rta::engine::{Engine, EngineError, Format};
use rta_core::color::Rgb;
use rta_core::illumination::Rta;
use rta_core::needs::Everything;
use rta_core::trace::Tracer;
use rta_core::{Error, Q16};
use rta_scenes::description::{self, Description};
use rta_scenes::narrow::narrow;
use rta_tests::exact::{DEPTH, Exact, shipped_scene};
use rta_tests::picture::{render, settings, share_within};
use rta_tests::{oracle, random_scenes};

const SHIPPED: [&str; 3] = ["juggler", "hall-22", "glass-2"];

fn q16(scene: &Description, depth: u32) -> Vec<Rgb<i32>> {
    let exact = Exact::new(scene, 160, 100);
    exact.searched::<_, Everything>(exact.packets(), Rta, depth).expect("it is drawn")
}

/// Returns the scene with its objects and lamps in another order.
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
        let admitted = scene.admit().expect("it fits");
        Tracer::<_, _, Everything, 5>::new(&admitted, Rta, depth).map(|_| ())
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
