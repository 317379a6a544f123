//! What a builder promises: every object is in a leaf once, and in each box above it; and most random scenes are such that
//! light buffers serve.

#![allow(clippy::indexing_slicing, reason = "a test may panic")]

use std::collections::BTreeMap;

use rta_core::scene::Object;
use rta_scenes::accelerator::solid::{Solid, solids};
use rta_scenes::description::Description;

use super::Packets;

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

#[test]
fn every_object_is_in_one_leaf_and_in_all_boxes_above_it() {
    let mut with_nodes = 0;
    for seed in 0..30 {
        for scene in [scenes::clusters(seed), scenes::cloud(100, 20.0, seed), scenes::medley(40, 9.0, seed)] {
            let packets = Packets::build::<f32>(&scene);
            let mut left = bounds(&scene);
            if packets.nodes.is_empty() {
                for item in packets.leaves.iter().flat_map(|leaf| leaf.items) {
                    assert!(item == Object::Floor || left.remove(&item).is_some(), "{item} twice");
                }
            } else {
                with_nodes += 1;
                walk(&packets, 0, &mut Vec::new(), &mut |item, above| {
                    let solid = left.remove(&item).unwrap_or_else(|| panic!("{item} twice"));
                    for (node, slot) in above {
                        for (axis, [low, high]) in packets.nodes[*node].planes.iter().enumerate() {
                            // Half a unit in the last place, for which the search has a margin.
                            let slack = 1e-7 * f64::from(packets.size);
                            assert!(f64::from(low[*slot]) <= solid.bounds.low[axis] + slack, "{item}");
                            assert!(f64::from(high[*slot]) >= solid.bounds.high[axis] - slack, "{item}");
                        }
                    }
                });
            }
            assert!(left.is_empty(), "not in a leaf: {:?}", left.keys());
        }
    }
    assert!(with_nodes > 75, "only {with_nodes} scenes have nodes");
}

#[test]
fn light_buffers_serve_most_random_scenes() {
    let serves = |seed: &u64| {
        let packets = Packets::build::<f32>(&scenes::clusters(*seed));
        packets.light_buffers.buffers.iter().any(|buffer| buffer.slack > 0.0)
    };
    assert!((0..60).filter(serves).count() > 30);
}
