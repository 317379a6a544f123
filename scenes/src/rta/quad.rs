//! Quads, and boxes of them.

use rta_core::scene::Object;

use super::Reader;
use super::said::Said;
use crate::description::{Quad, Surface, Triangle, cut};
use crate::error::{Found, SceneError};
use crate::polygon::is_flat;
use crate::space::{Triple, cross, difference, dot};

/// The corners of the sides of a box, by which of its two ends each has along x, y and z: the floor, the ceiling, the sides at the least and
/// the largest x, and those at the least and the largest y. Their outsides are those of the box.
const SIDES: [[[bool; 3]; 4]; 6] = [
    [[false, false, false], [false, true, false], [true, true, false], [true, false, false]],
    [[false, false, true], [true, false, true], [true, true, true], [false, true, true]],
    [[false, false, false], [false, false, true], [false, true, true], [false, true, false]],
    [[true, false, false], [true, true, false], [true, true, true], [true, false, true]],
    [[false, false, false], [true, false, false], [true, false, true], [false, false, true]],
    [[false, true, false], [false, true, true], [true, true, true], [true, true, false]],
];

impl<'a> Reader<'a> {
    /// A quad.
    pub(super) fn quad(
        &mut self,
        said: &Said<'a>,
        surface: Surface,
        color: Triple,
    ) -> Result<(), SceneError> {
        let Some(part) = said.part("") else { return Ok(()) };
        let corners = [0, 3, 6, 9].map(|at| part.numbers(at));
        let [a, b, c, d] = corners;
        if is_flat([a, b, c]) || is_flat([a, c, d]) {
            self.warn("flat", said.place.0, || "half of this quad has no area: it is left out".into());
            return Ok(());
        }
        let normal = |[a, b, c]: [Triple; 3]| cross(difference(b, a), difference(c, a));
        let is_convex = |[a, b, c, d]: [Triple; 4]| dot(normal([a, b, c]), normal([a, c, d])) > 0.0;
        if !is_convex([a, b, c, d]) || !is_convex([b, c, d, a]) {
            let found = Found::Told("others".into());
            return Err(said.error(part.word(0).1, "corners of a convex quad, in order", found));
        }
        let emitting = said.part("emitting").map(|part| part.numbers(0));
        if let (Some([u0, v0, u1, v1]), Some(part)) = (emitting, said.part("emitting"))
            && (u0 <= 0.0 || v0 <= 0.0 || u0 >= u1 || v0 >= v1 || u1 >= 1.0 || v1 >= 1.0)
        {
            let found = Found::Told("another".into());
            let expected = "a part inside the quad: least u and v, then largest u and v, between 0 and 1";
            return Err(said.error(part.word(0).1, expected, found));
        }
        self.push_quad(said, (surface, color), corners, emitting)
    }

    /// A box: six quads.
    pub(super) fn cuboid(
        &mut self,
        said: &Said<'a>,
        surface: Surface,
        color: Triple,
    ) -> Result<(), SceneError> {
        let ends = ["from", "to"].map(|end| said.triple(end).unwrap_or_default());
        let [from, to] = ends;
        if from.iter().zip(to).any(|(from, to)| *from == to) {
            let place = said.part("to").map_or(said.place, |to| to.word(0).1);
            let found = Found::Told("one without a volume".into());
            return Err(said.error(place, "the opposite corner of the box", found));
        }
        for side in SIDES {
            let mut corners = side.map(|ends| -> Triple {
                core::array::from_fn(|axis| {
                    let end = |of: Triple| of.get(axis).copied().unwrap_or_default();
                    let is_far = ends.get(axis).copied().unwrap_or_default();
                    if is_far { end(from).max(end(to)) } else { end(from).min(end(to)) }
                })
            });
            if said.has("inside") {
                // The first corner stays: u and v change places.
                corners.swap(1, 3);
            }
            self.push_quad(said, (surface, color), corners, None)?;
        }
        Ok(())
    }

    fn push_quad(
        &mut self,
        said: &Said<'a>,
        (surface, color): (Surface, Triple),
        corners: [Triple; 4],
        emitting: Option<[f64; 4]>,
    ) -> Result<(), SceneError> {
        let triangle = u32::try_from(self.scene.triangles.len()).unwrap_or(u32::MAX);
        let side = |at| {
            let side = said.part("patches").map_or(1, |part| part.whole(at));
            u16::try_from(side).unwrap_or(u16::MAX)
        };
        self.scene.quads.push(Quad { triangle, patches: [side(0), side(1)], emitting });
        let line = said.place.0;
        for (number, vertices) in (triangle..).zip(cut(corners, emitting)) {
            self.detail(said, Object::Triangle(number), None)?;
            let one_sided = said.has("one-sided");
            let normals = None;
            self.scene.triangles.push(Triangle { vertices, normals, one_sided, color, surface, line });
        }
        Ok(())
    }
}
