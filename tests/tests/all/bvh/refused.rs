//! A hierarchy that is wrong is an error on admission, which names its node.

use rta_core::Error;
use rta_core::Q16;
use rta_core::scene::Object;
use rta_scenes::accelerator::bvh::Built;
use rta_scenes::narrow::narrow;
use rta_tests::exact::shipped_scene;

use super::scenes::medley;
use super::{over_all, over_spheres};

/// Returns whether an edited hierarchy is refused, and asserts that the one that is edited is not.
macro_rules! refused {
    ($scene:expr, $good:expr, $edit:expr) => {{
        let narrowed = narrow::<Q16>($scene, 1.0).expect("it fits");
        let admit = |built: &Built<Q16>| {
            let bvh = rta_core::accelerator::Bvh { nodes: &built.nodes, order: &built.order };
            narrowed.scene().admit_with(&narrowed.camera, bvh).err()
        };
        assert_eq!(admit(&$good), None);
        let mut bad = $good.clone();
        let edit: &dyn Fn(&mut Built<Q16>) = &$edit;
        edit(&mut bad);
        matches!(admit(&bad), Some(Error::Hierarchy(_)))
    }};
}

#[test]
fn nodes_that_are_wrong_are_refused() {
    let scene = shipped_scene("juggler");
    let good = over_spheres::<Q16>(&scene);
    assert!(good.nodes.len() > 8);
    assert!(!refused!(&scene, good, |_| ()));
    assert!(refused!(&scene, good, |b| b.nodes[0].radius = Q16::from_num(1)), "too small a sphere");
    assert!(refused!(&scene, good, |b| b.nodes[0].radius = Q16::from_num(20_000)), "too large a sphere");
    assert!(refused!(&scene, good, |b| b.nodes[0].radius = -b.nodes[0].radius), "a negative sphere");
    assert!(refused!(&scene, good, |b| b.nodes[3].skip = 3), "it leads to itself");
    assert!(refused!(&scene, good, |b| b.nodes[3].skip = 2), "it leads back");
    assert!(refused!(&scene, good, |b| b.nodes[3].skip = 10_000), "it leads nowhere");
    assert!(refused!(&scene, good, |b| b.nodes[0].end = 71), "beyond the list");
    assert!(refused!(&scene, good, |b| b.nodes[0].first = 1), "the first sphere is left out");
    assert!(refused!(&scene, good, |b| b.nodes[2].first = b.nodes[2].end), "nothing in it");
    assert!(refused!(&scene, good, |b| b.nodes.truncate(5)), "not complete");
    assert!(refused!(&scene, good, |b| b.nodes.clear()), "none");
    assert!(refused!(&scene, good, |b| b.nodes.swap(2, 5)), "in another order");
    assert!(refused!(&scene, good, |b| b.nodes[2].center.x = Q16::from_num(90)), "beside its spheres");
    let last = good.nodes.len() - 1;
    assert!(refused!(&scene, good, |b| b.nodes[last].end -= 1), "the last sphere is left out");
}

#[test]
fn an_order_that_is_wrong_is_refused() {
    let scene = medley(40, 9.0, 3);
    assert!(!scene.triangles.is_empty() && !scene.cones.is_empty() && !scene.ellipsoids.is_empty());
    let good = over_all::<Q16>(&scene, 5);
    assert!(!refused!(&scene, good, |_| ()));
    assert!(refused!(&scene, good, |b| b.order[3] = b.order[4]), "one twice, one not at all");
    assert!(refused!(&scene, good, |b| b.order[3] = Object::Sphere(99)), "there is no such sphere");
    assert!(refused!(&scene, good, |b| b.order[3] = Object::Floor), "the floor is in no node");
    assert!(refused!(&scene, good, |b| b.order[3] = Object::Lamp(0)), "nor is a lamp");
    assert!(refused!(&scene, good, |b| b.order[3] = Object::Cylinder(0)), "nor what has no end");
    assert!(refused!(&scene, good, |b| b.order.truncate(9)), "not all objects");
    assert!(refused!(&scene, good, |b| b.order.push(b.order[0])), "one twice at the end");
    assert!(refused!(&scene, good, |b| b.order.clear()), "nodes over more than the spheres");
    assert!(refused!(&scene, good, |b| b.nodes.truncate(7)), "nodes are missing");
    let last = good.nodes.len() - 1;
    assert!(refused!(&scene, good, |b| b.nodes[last].skip = 0), "it does not end");
    assert!(refused!(&scene, good, |b| b.nodes[1].radius = Q16::ZERO), "a sphere of no size");
}
