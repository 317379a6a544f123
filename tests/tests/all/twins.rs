//! Numbers beside their twins in `f64`, and the branches of pixels: the tests of `rta-paired`. They stand here because its tracers, of all
//! models in all formats, are compiled with the program anyway.

use core::fmt::Write;

use rta_core::Q16;
use rta_core::raster::Raster;
use rta_core::ray::RayKind;
use rta_core::scalar::{Scalar, Unit};
use rta_core::scene::Object;
use rta_core::vector::{LengthVector, UnitVec3, UnitVector, Vec3, Vector};
use rta_scenes::narrow::Narrow;
use rta_scenes::{dat, shipped};

use rta_packets::picture::Setup;
use rta_paired::ray_tree::{HitKind, Visibility};
use rta_paired::trail::{self, Pixel, Window, lock_step};
use rta_paired::{Paired, log};
use rta_scenes::description::Description;
use rta_scenes::sampler::Sampler;
use rta_scenes::{Format, Model, in_format};

type P = Paired<Q16>;

fn setup() -> Setup {
    let raster = Raster::new(64, 40).expect("a raster");
    Setup { raster, aspect: 4.0 / 3.0, depth: 5, cutoff: None, sampling: Sampler::CENTER }
}

fn pixels(scene: &Description, format: Format, model: Model, window: &Window) -> Vec<Pixel> {
    let pixels = in_format!(format, S => trail::pixels::<S>(scene, model, &setup(), window));
    pixels.expect("it fits")
}

#[test]
fn both_twins_go_their_own_way() {
    let third = P::length(1.0 / 3.0);
    assert_eq!(third.format, Q16::from_num(1.0 / 3.0));
    assert!((third.twin - 1.0 / 3.0).abs() < 1e-16);
    assert!((third.error() - 1.0 / 3.0).abs() < 1e-3, "a third of an LSB: {}", third.error());
    let (nine, log) = log::record(|| third + third - P::length(10.0));
    assert!((nine.error() - 2.0 / 3.0).abs() < 1e-3);
    let names: Vec<_> = log.operations.iter().map(|o| o.name).collect();
    assert_eq!(names, ["+", "-"]);
    assert!(log.operations.iter().all(|o| o.place.file().ends_with("twins.rs")));
    assert!(log.operations.iter().all(|o| o.growth() == 0.0), "less than one LSB is no loss");
}

#[test]
fn what_a_small_denominator_does_is_seen() {
    // An LSB of a length becomes 2^14 x 100 LSBs of a unit when the radius is 1/100.
    let v = Vec3::<P>::new(P::length(0.003), P::length(0.0), P::length(0.0));
    let radius = P::length(0.01).inverse();
    let (_, log) = log::record(|| v.local(UnitVec3::<P>::Y, P::ZERO, radius));
    let [local] = log.operations.as_slice() else { panic!("one operation") };
    assert_eq!(local.name, "local");
    assert!((15.0..22.0).contains(&local.growth()), "{} bits", local.growth());
}

#[test]
fn only_a_flipped_decision_is_noted_and_the_format_takes_it() {
    let (a, b) = (P::length(1.0), P::length(1.0 + 1e-6));
    let (less, log) = log::record(|| a < b);
    assert!(!less, "the format cannot tell them apart");
    let [flip] = log.flips.as_slice() else { panic!("one flip") };
    assert_eq!((flip.question, flip.left, flip.right), ("<", [1.0, 1.0], [1.0, 1.0 + 1e-6]));
    let (_, log) = log::record(|| (a <= b, a == P::length(2.0), b > P::ZERO));
    assert!(log.flips.is_empty(), "the twins agree");
    let unit = <P as Scalar>::Unit::ratio;
    let (root, log) = log::record(|| Unit::radical(unit(1, 1), unit(0, 1), P::unit(1.0 + 1e-12)));
    assert!(root.is_some(), "1 - 1 is not negative");
    assert_eq!(log.flips.len(), 1, "but 1 - (1 + 1e-12)^2 is");
}

#[test]
fn nothing_is_recorded_outside() {
    let (inner, outer) = log::record(|| {
        log::pause(|| P::ZERO + P::ZERO);
        log::record(|| P::ZERO + P::ZERO).1
    });
    assert_eq!((inner.operations.len(), outer.operations.len()), (1, 0));
}

#[test]
fn unit_vectors_of_both_twins_are_unit() {
    let (direction, _) =
        UnitVec3::<P>::new(P::unit(0.3), P::unit(-0.5), P::unit(1.1)).normalize().expect("not 0");
    let [format, twin] = direction.dot(direction).values();
    assert!((format - 1.0).abs() < 4e-9 && (twin - 1.0).abs() < 1e-15);
}

/// The lock step changes nothing: colour and branches are those of the format on its own.
#[test]
fn the_format_runs_as_if_it_were_alone() {
    for (name, text) in shipped::ALL {
        let scene = dat::read(text.as_bytes(), name).expect(name);
        for format in [Format::F32, Format::Q16, Format::Q20] {
            let row = Window { rows: 20..21, columns: 0..64 };
            let alone = pixels(&scene, format, Model::Rta, &row);
            assert_eq!(alone.len(), 64);
            for (x, alone) in (0..).zip(&alone).step_by(5) {
                let pair = lock_step(&scene, (format, Model::Rta), &setup(), (x, 20));
                let pair = pair.expect(name).expect("in the raster");
                assert_eq!(pair.light, alone.light, "{name} {format} {x}");
                assert_eq!(pair.tree.parting(&alone.tree), None, "{name} {format} {x}");
                assert!(!pair.log.operations.is_empty() && alone.log.operations.is_empty());
            }
        }
        for outside in [(64, 0), (0, 40)] {
            let pair = lock_step(&scene, (Format::Q16, Model::Rta), &setup(), outside);
            assert!(pair.expect(name).is_none());
        }
    }
}

/// A scene that shows everything a trail can hold.
const SCENE: &str = "\
0 -10 2   0 1 0   1
0
0
2   0 0 2   1 1 1   1   3 0.25 0.75 0.75
    0 40 2   1 0 0   8   1
2   20 -10 9   90 90 90   0
    14 30 12   90 90 90   2
1 1 0   0 1 0   0.2 0.2 0.2   0.7 0.7 1   0.2 0.2 1
";

#[test]
fn a_trail_holds_the_ray_tree() {
    let scene = dat::read(SCENE.as_bytes(), "scene").expect("well formed");
    let raster = setup().raster;
    let window = Window { rows: 0..raster.height(), columns: 0..raster.width() };
    let all = pixels(&scene, Format::F64, Model::Rta, &window);
    assert_eq!(all.len(), (raster.width() * raster.height()) as usize);
    let [first, .., last] = all.as_slice() else { panic!("pixels") };
    let tree = |pixel: &Pixel| -> Vec<_> {
        pixel.tree.steps.iter().map(|s| (s.kind, s.depth, s.hit, s.inside)).collect()
    };
    assert_eq!(tree(first), [(RayKind::Primary, 0, HitKind::Sky, false)]);
    assert!(matches!(tree(last).as_slice(), [(RayKind::Primary, 0, HitKind::Floor { .. }, false)]));
    let center = all.get(20 * 64 + 32).expect("the middle");
    let glass = HitKind::Object(Object::Sphere(0));
    let [primary, reflected, inner, ..] = tree(center)[..] else { panic!("a tree: {center:?}") };
    assert_eq!(primary, (RayKind::Primary, 0, glass, false));
    assert_eq!((reflected.0, reflected.1), (RayKind::Reflected, 1));
    assert!(center.tree.steps.iter().any(|s| s.hit == glass && s.inside && s.kind == RayKind::Transmitted));
    let ball = HitKind::Object(Object::Sphere(1));
    assert!(all.iter().any(|p| p.tree.steps.iter().any(|s| s.hit == ball && s.depth == 0)));
    assert!(inner.1 <= 2);
    let shines = || all.iter().flat_map(|p| &p.tree.steps).flat_map(|s| &s.lamps);
    let front = |wanted: f64| {
        shines().any(|s| matches!(s, Visibility::Front { part, .. } if (part - wanted).abs() < 1e-12))
    };
    for (part, name) in [(1.0, "lit"), (0.0, "in shadow"), (0.75, "behind the glass")] {
        assert!(front(part), "{name}");
    }
    assert!(shines().any(|s| matches!(s, Visibility::Front { glint: true, .. })), "a highlight");
    assert!(shines().any(|s| matches!(s, Visibility::Behind)));
    assert!(all.iter().flat_map(|p| &p.tree.steps).any(|s| s.total_reflection));
    assert!(all.iter().any(|p| p.tree.steps.iter().any(|s| s.hit == HitKind::Object(Object::Lamp(1)))));
    // Everything is like itself and unlike its neighbour across an edge.
    assert_eq!(center.tree.parting(&center.tree), None);
    assert_eq!(center.tree.parting(&first.tree), Some(0));
}

/// What is recorded of a pixel goes with its rays, not with the number of objects.
#[test]
fn a_mesh_is_searched_as_a_picture_searches_it() {
    let mut text = String::from(
        "b 1 1 1 v from 0 0 9 at 0 0 0 up 0 1 0 angle 40 hither 1 resolution 64 40 l 3 3 9 f .9 .9 1 .1 .3 9 .6 1.1\n",
    );
    for i in 0..4000 {
        let (x, y, z) =
            (f64::from(i % 40) / 5.0 - 4.0, f64::from(i / 40 % 40) / 5.0 - 4.0, f64::from(i / 1600));
        let (right, up) = (x + 0.19, y + 0.19);
        writeln!(text, "p 4 {x} {y} {z} {right} {y} {z} {right} {up} {z} {x} {up} {z}")
            .expect("memory takes it");
    }
    let scene = rta_scenes::nff::read(text.as_bytes(), "mesh").expect("well formed");
    for format in [Format::F32, Format::Q16, Format::Q20] {
        let pair = lock_step(&scene, (format, Model::Phong), &setup(), (32, 20));
        let pair = pair.expect("it fits").expect("in the raster");
        let alone = pixels(&scene, format, Model::Phong, &Window::at(32, 20)).pop().expect("in the raster");
        assert_eq!((pair.light, pair.tree.parting(&alone.tree)), (alone.light, None));
        let (rays, operations) = (pair.tree.steps.len(), pair.log.operations.len());
        assert!(rays > 10 && operations < 2000 * rays, "{format}: {operations} operations of {rays} rays");
    }
}
