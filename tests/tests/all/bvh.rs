//! Both forms of the core's hierarchy leave nothing out: what a ray meets, what comes through to a lamp and whole pictures are
//! those of one object after the other, to the last bit; and a hierarchy that is wrong is refused.

#![allow(clippy::indexing_slicing, reason = "a test may panic")]

use fastrand::Rng;
use rta_core::accelerator::{Accelerator, Lists, Node};
use rta_core::color::Rgb;
use rta_core::illumination::Rta;
use rta_core::needs::Everything;
use rta_core::raster::{Pixels, Raster};
use rta_core::scene::Object;
use rta_core::trace::Tracer;
use rta_core::vector::Vector;
use rta_core::{Q16, Q20};
use rta_scenes::accelerator::bvh::{Built, build};
use rta_scenes::accelerator::solid::{reach, solids};
use rta_scenes::description::Description;
use rta_scenes::narrow::{Narrow, Narrowed, narrow};
use rta_tests::exact::{DEPTH, Exact, shipped_scene};
use rta_tests::random_scenes;

mod refused;
mod ties;

/// What the packets are compared by.
#[path = "../../../host/packets/tests/search/compare.rs"]
mod compare;
/// What the packets are compared with.
#[path = "../../../host/packets/tests/search/scenes.rs"]
mod scenes;

/// Appends the nodes over the objects from `first` to before `end`: halves of halves, however far apart their objects are.
fn halve<S: Narrow>(
    scene: &Description,
    objects: &[Object],
    first: usize,
    end: usize,
    nodes: &mut Vec<Node<S>>,
) {
    let run = &objects[first..end];
    // About the first object of the run: not the best centre, but one is as right as another.
    let center = solids(scene).iter().find(|solid| solid.object == run[0]).expect("it is there").center();
    let radius = run.iter().map(|object| reach(scene, *object, center)).fold(0.0, f64::max);
    let radius = S::length(1.00001 * radius + 2.0 * S::SMALLEST_RADIUS);
    let [x, y, z] = center.map(S::length);
    let [from, to] = [first, end].map(|place| u32::try_from(place).expect("few"));
    let number = nodes.len();
    nodes.push(Node { center: Vector::new(x, y, z), radius, first: from, end: to, skip: 0 });
    if run.len() > 2 {
        let middle = first + run.len() / 2;
        halve(scene, objects, first, middle, nodes);
        halve(scene, objects, middle, end, nodes);
    }
    nodes[number].skip = u32::try_from(nodes.len()).expect("few");
}

/// Returns a hierarchy over the list of spheres in its own order; without nodes where there are none.
fn over_spheres<S: Narrow>(scene: &Description) -> Built<S> {
    let spheres: Vec<_> = (0..).zip(&scene.spheres).map(|(i, _)| Object::Sphere(i)).collect();
    let mut nodes = Vec::new();
    if !spheres.is_empty() {
        halve::<S>(scene, &spheres, 0, spheres.len(), &mut nodes);
    }
    Built { nodes, order: Vec::new() }
}

/// Returns a hierarchy over all finite objects in a random order; without nodes where there are none.
fn over_all<S: Narrow>(scene: &Description, seed: u64) -> Built<S> {
    let mut order: Vec<_> = solids(scene).iter().map(|solid| solid.object).collect();
    Rng::with_seed(seed).shuffle(&mut order);
    let mut nodes = Vec::new();
    if !order.is_empty() {
        halve::<S>(scene, &order, 0, order.len(), &mut nodes);
    }
    Built { nodes, order }
}

/// Returns all hierarchies over a scene that there are to compare: those of this test, and the builder's own.
fn hierarchies<S: Narrow>(scene: &Description, seed: u64) -> Vec<Built<S>> {
    let mut all = vec![over_spheres::<S>(scene), over_all::<S>(scene, seed), build::<S>(scene)];
    all.retain(|built| !built.nodes.is_empty());
    all
}

/// Compares the searches of single rays in all formats.
fn rays(scene: &Description, rays: usize) {
    fn in_format<S: Narrow>(scene: &Description, rays: usize, seed: u64) {
        let narrowed = narrow::<S>(scene, 1.0).expect("it fits");
        let all = hierarchies::<S>(scene, seed);
        assert_eq!(all.len(), 3, "there are objects enough");
        let all: Vec<_> = all.iter().filter_map(Built::bvh).collect();
        let met = compare::compare(scene, &narrowed, &all, rays, seed);
        assert!(met > rays / 4, "only {met} of {rays} rays met anything");
    }
    in_format::<Q16>(scene, rays, 1);
    in_format::<Q20>(scene, rays, 2);
    in_format::<f32>(scene, rays, 3);
    in_format::<f64>(scene, rays, 4);
}

#[test]
fn single_rays_meet_the_same() {
    // One object after the other is slow: the more there are, the fewer rays.
    for (count, spread, number) in [(25, 5.0, 10_000), (70, 20.0, 10_000), (500, 60.0, 3000)] {
        rays(&scenes::cloud(count, spread, 7), number);
    }
}

#[test]
fn single_rays_meet_the_same_of_every_kind() {
    for (count, spread, number) in [(20, 5.0, 10_000), (300, 20.0, 3000)] {
        rays(&scenes::medley(count, spread, 11), number);
    }
}

/// Returns the light of a small picture.
fn picture<S: Narrow>(scene: &Narrowed<S>, accelerator: impl Accelerator<S>) -> Option<Vec<Rgb<S::Light>>> {
    let admitted = scene.scene().admit_with(&scene.camera, accelerator).ok()?;
    let tracer: Tracer<S, _, Everything, 32, _> = Tracer::new(&admitted, Rta, 3).expect("a depth");
    Some(Pixels::new(&tracer, &scene.camera, Raster::new(46, 46).expect("a raster")).collect())
}

/// Compares pictures of random scenes of all kinds of objects, and counts them by how their spheres are searched.
fn pictures<S: Narrow>() {
    let (mut own, mut ordered) = (0, 0);
    for seed in 0..40 {
        let scene = scenes::clusters(seed);
        let Ok(narrowed) = narrow::<S>(&scene, 1.0) else { continue };
        let Some(right) = picture(&narrowed, Lists) else { continue };
        for built in hierarchies::<S>(&scene, seed) {
            let found = built.bvh().and_then(|bvh| picture(&narrowed, bvh));
            // A hierarchy's centres are places that rays are measured from: in a short format there may be no room for them.
            let Some(found) = found else { continue };
            assert!(found == right, "scene {seed} in {}, {} in order", S::NAME, built.order.len());
            own += usize::from(built.order.is_empty());
            ordered += usize::from(!built.order.is_empty());
        }
    }
    assert!(own > 15 && ordered > 30, "only {own} and {ordered} pictures in {}", S::NAME);
}

#[test]
fn pictures_are_the_same_in_floating_point() {
    pictures::<f32>();
    pictures::<f64>();
}

#[test]
fn pictures_are_the_same_in_fixed_point() {
    pictures::<Q16>();
    pictures::<Q20>();
}

#[test]
fn scenes_are_drawn_the_same_by_program_and_firmware() {
    let mut scenes = random_scenes::all();
    scenes.push(("juggler", shipped_scene("juggler")));
    scenes.push(("hall-22", shipped_scene("hall-22")));
    let mut with_one = 0;
    for (name, scene) in scenes {
        let exact = Exact::new(&scene, 120, 75);
        let same = exact.picture::<_, Everything>(Rta, DEPTH);
        assert!(exact.searched::<_, Everything>(exact.packets(), Rta, DEPTH) == same, "{name} by packets");
        if let Some(bvh) = exact.bvh() {
            with_one += 1;
            assert!(exact.searched::<_, Everything>(bvh, Rta, DEPTH) == same, "{name} by its hierarchy");
        }
    }
    assert!(with_one >= 3, "only {with_one} of the scenes have a hierarchy");
}
