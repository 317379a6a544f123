//! Quads, boxes, and what emits light.

use super::{accepted, refused, scene};
use crate::description::{Description, LampShape, Surface};

const ROOM: &str = "\
material lit  emits 1 .5 .25
quad 0 0 1  1 0 1  1 1 1  0 1 1  patches 3 2  emitting .25 .25 .5 .75  color .7 .7 .7  of lit
box from 2 0 0  to 0 1 3  patches 4 5  color .1 .2 .3
quad 0 0 0  0 2 0  3 2 0  1 0 0  of lit
";

/// Returns the corners of all quads.
fn corners(scene: &Description) -> Vec<[[f64; 3]; 4]> {
    let corners = scene.quads.iter().map(|quad| quad.corners(&scene.triangles).expect("corners"));
    corners.collect()
}

#[test]
fn a_quad_has_its_corners_and_a_box_has_six_sides() {
    let scene = scene(ROOM);
    assert_eq!(scene.quads.len(), 8);
    let all = corners(&scene);
    assert_eq!(all[0], [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 1.0, 1.0], [0.0, 1.0, 1.0]]);
    assert_eq!(all[7][3], [1.0, 0.0, 0.0]);
    assert_eq!(
        (scene.quads[0].triangles(), scene.quads[0].patches, scene.quads[1].patches),
        (10, [3, 2], [4, 5])
    );
    // The sides of the box look away from its middle.
    for corners in &all[1..7] {
        let normal = crate::space::cross(
            crate::space::difference(corners[1], corners[0]),
            crate::space::difference(corners[3], corners[0]),
        );
        let middle = crate::description::bilinear(*corners, [0.5, 0.5]);
        let away = crate::space::difference(middle, [1.0, 0.5, 1.5]);
        assert!(crate::space::dot(normal, away) > 0.0, "{corners:?}");
    }
    // From inside they look towards it.
    let inside = super::scene("box from 0 0 0  to 2 1 3  inside");
    let [a, b, _, d] = corners(&inside)[0];
    let up = crate::space::cross(crate::space::difference(b, a), crate::space::difference(d, a));
    assert!(up[2] > 0.0);
    // Patches emit where their middles lie in the part.
    let emits = |u, v| scene.quads[0].emits_at([u, v]);
    assert_eq!([emits(0.25, 0.75), emits(0.2, 0.5), emits(0.4, 0.5)], [true, false, true]);
}

#[test]
fn what_is_written_reads_back() {
    let scene = scene(ROOM).named();
    let back = accepted(&scene.to_rta());
    assert_eq!(corners(&back), corners(&scene));
    assert_eq!((back.quads, back.materials.len()), (scene.quads, scene.materials.len()));
    assert_eq!(back.triangles.len(), scene.triangles.len());
    assert_eq!(back.materials[0].emits, Some([1.0, 0.5, 0.25]));
}

#[test]
fn a_quad_that_emits_is_a_lamp_of_the_same_light() {
    let scene = scene(ROOM);
    assert!(scene.has_emitters());
    let lit = scene.with_emitters();
    let [part, whole] = lit.lamps.as_slice() else { panic!("two lamps") };
    // Radiance times area over pi.
    let expected = [0.125, 0.0625, 0.03125].map(|power| power / core::f64::consts::PI);
    for (power, expected) in part.color.into_iter().zip(expected) {
        assert!((power - expected).abs() < 1e-15, "{power} is not {expected}");
    }
    // The trapezium's area is 4.
    assert!((whole.color[0] - 4.0 / core::f64::consts::PI).abs() < 1e-12);
    let Some(LampShape::Area { corner, edges }) = lit.details.lamps.get(&0) else {
        panic!("a parallelogram")
    };
    assert_eq!((*corner, *edges), ([0.25, 0.25, 1.0], [[0.25, 0.0, 0.0], [0.0, 0.5, 0.0]]));
    // What is around the part has a material that does not emit.
    let emits = |number: usize| match lit.triangles[number].surface {
        Surface::Of(number) => lit.materials[usize::from(number)].emits,
        _ => None,
    };
    assert_eq!([emits(0), emits(7)], [None; 2]);
    assert_eq!([emits(8), emits(9)], [Some([1.0, 0.5, 0.25]); 2]);
    assert!(!super::scene("quad 0 0 0  1 0 0  1 1 0  0 1 0").has_emitters());
}

#[test]
fn wrong_quads_are_refused() {
    let with = |line: &str| refused(&format!("rta 1\ncamera at 0 -8 2  look 0 1 0\n{line}"));
    for (line, expected) in [
        ("quad 0 0 0  1 0 0  0 1 0  1 1 0", "corners of a convex quad, in order"),
        ("quad 0 0 0  1 0 0  .2 .2 0  0 1 0", "corners of a convex quad, in order"),
        ("quad 0 0 0  1 0 0  1 1 0  0 1 0  patches 0 1", "patches along u"),
        ("quad 0 0 0  1 0 0  1 1 0  0 1 0  emitting 0 .1 .5 .5", "a part inside the quad"),
        ("quad 0 0 0  1 0 0  1 1 0", "fourth corner"),
        ("box from 0 0 0  to 1 0 1", "the opposite corner of the box"),
        ("material a  emits 1 -1 1", "light"),
    ] {
        assert!(with(line).contains(expected), "{line}: {}", with(line));
    }
    let flat = scene("quad 0 0 0  1 0 0  2 0 0  0 1 0");
    assert_eq!((flat.quads.len(), flat.triangles.len()), (0, 0));
    assert!(flat.warnings.iter().any(|warning| warning.text.contains("half of this quad has no area")));
}
