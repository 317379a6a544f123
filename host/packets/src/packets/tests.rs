//! What a builder promises: every object is in a leaf once, and in each box above it; and most random scenes are such that
//! light buffers serve.

#![allow(clippy::indexing_slicing, reason = "a test may panic")]

use std::collections::BTreeMap;

use rta_core::scene::Object;
use rta_scenes::accelerator::solid::{Solid, solids};
use rta_scenes::description::{Description, Lamp, Sphere, Surface};

use super::Packets;
use crate::light_buffer::Candidate;

/// The generator of the integration tests.
#[path = "../../tests/search/scenes.rs"]
mod scenes;

/// Returns a box about each object that leaves hold.
fn bounds(scene: &Description) -> BTreeMap<Object, Solid> {
    let mut solids = solids(scene);
    let lamps = scene.lamps.iter().zip(0..).filter(|(lamp, _)| lamp.radius > 0.0);
    solids.extend(lamps.map(|(lamp, i)| Solid::sphere(lamp.position, lamp.radius, Object::Lamp(i))));
    solids.into_iter().map(|solid| (solid.object, solid)).collect()
}

/// Calls `see` with each object of the leaves below a node, and the slots of the nodes above it.
fn walk(
    packets: &Packets,
    node: usize,
    above: &mut Vec<(usize, usize)>,
    see: &mut impl FnMut(Object, &[(usize, usize)]),
) {
    for (slot, child) in packets.nodes[node].children.iter().enumerate() {
        above.push((node, slot));
        if let Some(next) = child.number() {
            assert!(next > node, "it leads on");
            walk(packets, next, above, see);
        } else {
            let (first, count) = child.run();
            for leaf in packets.leaves.iter().skip(first).take(count) {
                leaf.items.iter().filter(|item| **item != Object::Floor).for_each(|item| see(*item, above));
            }
        }
        above.pop();
    }
}

/// Returns the scene with as many visible lamps, in two rows of which one is all in one place.
fn with_lamps(mut scene: Description, count: u32) -> Description {
    let lamp = scene.lamps[0].clone();
    scene.lamps = (0..count)
        .map(|i| {
            let x = 0.01 * f64::from(i / 2 * (i % 2));
            Lamp { position: [x, 5.0, 12.0 + f64::from(i % 2)], radius: 0.1, ..lamp.clone() }
        })
        .collect();
    scene
}

#[test]
fn memory_for_lamps_is_bounded_and_none_is_taken_for_a_few_objects() {
    let bytes = |objects, lamps| {
        let packets = Packets::build::<f32>(&with_lamps(scenes::medley(objects, 9.0, 1), lamps));
        assert_eq!(packets.lamps.is_some(), lamps > 8, "{lamps} lamps");
        packets.light_buffers.bytes()
    };
    // Of 40 objects, the buffers of 60 lamps are as large as those of 6000.
    let (few, some, many) = (bytes(40, 4), bytes(40, 60), bytes(40, 6000));
    assert!(few < some && many < some + (1 << 20) + 6000 * 256, "{few}, {some} and {many} bytes");
    // The eye's only.
    let mut ball = with_lamps(scenes::medley(1, 9.0, 1), 6000);
    (ball.cones, ball.triangles, ball.ellipsoids) = Default::default();
    assert_eq!(Packets::build::<f32>(&ball).light_buffers.buffers.len(), 1);
}

#[test]
fn everything_in_one_place_is_not_looked_at_for_each_direction() {
    // A leaf for each four, and each is seen through all cells: their number must not grow with that of the objects.
    let mut scene = scenes::cloud(20_000, 9.0, 1);
    let center = scene.spheres[0].position;
    for (number, sphere) in (0..).zip(&mut scene.spheres) {
        // What is of one size would be left out.
        (sphere.position, sphere.radius) = (center, 1.0 + 1e-7 * f64::from(number));
    }
    let packets = Packets::build::<f32>(&scene);
    let candidates = packets.light_buffers.candidates.len();
    assert!(candidates <= 25 * packets.light_buffers.cells.len(), "{candidates} candidates");
    assert!(packets.light_buffers.candidates.iter().any(|entry| entry.leaf() == Candidate::REST));
}

#[test]
fn what_others_in_its_place_hide_is_left_out() {
    let scene = scenes::cloud(100, 9.0, 1);
    let glass = Surface::Transparent { ks: 0.5, kt: 0.5, ior: 1.5 };
    let of = |surface| Sphere { surface, ..scene.spheres[0].clone() };
    let (glass, opaque, mirror) = (of(glass), of(Surface::Opaque), of(Surface::Mirror));
    let kept = |first: Vec<Sphere>| {
        let (mut scene, count) = (scene.clone(), u32::try_from(first.len()).expect("few"));
        scene.spheres.splice(0..1, first);
        let packets = Packets::build::<f32>(&scene);
        let mut found: Vec<Object> = packets.leaves.iter().flat_map(|leaf| leaf.items).collect();
        found.sort_unstable();
        found.retain(|item| matches!(item, Object::Sphere(i) if *i < count));
        found
    };
    // Glass in the place of glass dims the light twice; an opaque one behind it stops it; the rest is neither seen nor felt.
    let some = vec![glass.clone(), glass.clone(), opaque.clone(), glass.clone(), mirror];
    assert_eq!(kept(some), [0, 1, 2].map(Object::Sphere));
    let mut many = vec![glass; 70];
    many[50] = opaque;
    assert_eq!(kept(many), (0..32).chain([50]).map(Object::Sphere).collect::<Vec<_>>());
}

#[test]
fn every_object_is_in_one_leaf_and_in_all_boxes_above_it() {
    let mut with_nodes = 0;
    for seed in 0..30 {
        let medley = scenes::medley(40, 9.0, seed);
        for scene in
            [scenes::clusters(seed), scenes::cloud(100, 20.0, seed), with_lamps(medley.clone(), 60), medley]
        {
            let packets = Packets::build::<f32>(&scene);
            let mut left = bounds(&scene);
            if packets.nodes.is_empty() {
                for item in packets.leaves.iter().flat_map(|leaf| leaf.items) {
                    assert!(item == Object::Floor || left.remove(&item).is_some(), "{item} twice");
                }
            } else {
                with_nodes += 1;
                let mut see = |item, above: &[(usize, usize)]| {
                    let solid = left.remove(&item).unwrap_or_else(|| panic!("{item} twice"));
                    for (node, slot) in above {
                        for (axis, [low, high]) in packets.nodes[*node].planes.iter().enumerate() {
                            // Half a unit in the last place, for which the search has a margin.
                            let slack = 1e-7 * f64::from(packets.size);
                            assert!(f64::from(low[*slot]) <= solid.bounds.low[axis] + slack, "{item}");
                            assert!(f64::from(high[*slot]) >= solid.bounds.high[axis] - slack, "{item}");
                        }
                    }
                };
                walk(&packets, 0, &mut Vec::new(), &mut see);
                if let Some(root) = packets.lamps {
                    walk(&packets, root as usize, &mut Vec::new(), &mut see);
                }
            }
            // But for what is in the place of another.
            left.retain(|object, _| {
                let (Object::Sphere(i), spheres) = (*object, &scene.spheres) else { return true };
                let place = |sphere: &Sphere| (sphere.position, sphere.radius);
                !spheres[..i as usize].iter().any(|other| place(other) == place(&spheres[i as usize]))
            });
            assert!(left.is_empty(), "not in a leaf: {:?}", left.keys());
        }
    }
    assert!(with_nodes > 105, "only {with_nodes} scenes have nodes");
}

#[test]
fn light_buffers_serve_most_random_scenes() {
    let serves = |seed: &u64| {
        let packets = Packets::build::<f32>(&scenes::clusters(*seed));
        packets.light_buffers.buffers.iter().any(|buffer| buffer.slack > 0.0)
    };
    assert!((0..60).filter(serves).count() > 30);
}
