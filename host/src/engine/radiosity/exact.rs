//! Exact form factors, where they are known: between the patches of a room whose sides are rectangles along the axes.

use rta_core::radiosity::exact::{offset_parallel, offset_perpendicular};
use rta_scenes::description::{Description, Quad};
use rta_scenes::narrow::Narrow;
use rta_scenes::space::{Triple, cross, difference, dot};

/// How far a corner may be off, as a part of the room's size.
const SLACK: f64 = 1e-9;

/// A rectangle along the axes.
#[derive(Clone, Copy, Debug)]
struct Rectangle {
    /// The axis that is its normal's, 0 to 2, and where it lies along that.
    axis: usize,
    at: f64,
    /// The least and the largest coordinate along each axis; both are `at` along its own.
    spans: [[f64; 2]; 3],
}

impl Rectangle {
    fn area(&self) -> f64 {
        let sides = self.spans.iter().enumerate().filter(|(axis, _)| *axis != self.axis);
        sides.map(|(_, [least, largest])| largest - least).product()
    }

    fn span(&self, axis: usize) -> [f64; 2] {
        self.spans.get(axis).copied().unwrap_or_default()
    }

    /// Returns area times form factor to another rectangle; both see each other whole.
    fn exchanged(&self, other: &Self) -> f64 {
        let others = |axis: usize| [(axis + 1) % 3, (axis + 2) % 3];
        if self.axis == other.axis {
            let [u, v] = others(self.axis);
            return offset_parallel(
                self.span(u),
                self.span(v),
                other.span(u),
                other.span(v),
                (other.at - self.at).abs(),
            );
        }
        let common = 3 - self.axis - other.axis;
        let away = |of: &Self, from: &Self| {
            let [a, b] = of.span(from.axis).map(|c| (c - from.at).abs());
            [a.min(b), a.max(b)]
        };
        offset_perpendicular(away(self, other), self.span(common), away(other, self), other.span(common))
    }
}

/// Returns the rectangle with these corners, if it lies along the axes.
fn rectangle(corners: &[Triple; 4], size: f64) -> Option<Rectangle> {
    let spans: [[f64; 2]; 3] = core::array::from_fn(|axis| {
        let along = corners.iter().filter_map(|corner| corner.get(axis).copied());
        along.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, largest], c| [least.min(c), largest.max(c)])
    });
    let is_flat = |[least, largest]: &[f64; 2]| largest - least <= SLACK * size;
    let axis = spans.iter().position(is_flat)?;
    let is_at_corner = |corner: &Triple| {
        corner.iter().zip(spans).all(|(c, [least, largest])| {
            (c - least).abs() <= SLACK * size || (c - largest).abs() <= SLACK * size
        })
    };
    let is_rectangle = spans.iter().filter(|span| is_flat(span)).count() == 1
        && corners.iter().all(is_at_corner)
        // Neighbours differ along one axis.
        && corners.iter().zip(corners.iter().cycle().skip(1)).all(|(a, b)| {
            a.iter().zip(b).filter(|(a, b)| (*a - *b).abs() > SLACK * size).count() == 1
        });
    let at = spans.get(axis).map(|[least, largest]| f64::midpoint(*least, *largest))?;
    is_rectangle.then_some(Rectangle { axis, at, spans })
}

fn corners(scene: &Description) -> Option<Vec<[Triple; 4]>> {
    scene.quads.iter().map(|quad| quad.corners(&scene.triangles)).collect()
}

/// Returns whether the factors between all patches of a scene are known exactly: its quads are rectangles along the axes, none of which has
/// another behind it, and nothing else is there.
#[must_use]
pub fn is_plain_room(scene: &Description) -> bool {
    let covered: u32 = scene.quads.iter().map(Quad::triangles).sum();
    let others = [
        scene.spheres.len(),
        scene.ellipsoids.len(),
        scene.cylinders.len(),
        scene.cones.len(),
        scene.planes.len(),
        scene.triangles.len().abs_diff(usize::try_from(covered).unwrap_or(usize::MAX)),
        usize::from(scene.floor.is_some()),
    ];
    let Some(all) = corners(scene).filter(|_| others == [0; 7]) else { return false };
    let size = all.as_flattened().as_flattened().iter().fold(0.0, |most: f64, c| most.max(c.abs()));
    all.iter().all(|own| {
        let [a, b, _, d] = *own;
        let normal = cross(difference(b, a), difference(d, a));
        let slack = -SLACK * size * normal.iter().fold(0.0, |most: f64, c| most.max(c.abs()));
        let is_before = |corner: &Triple| dot(normal, difference(*corner, a)) >= slack;
        rectangle(own, size).is_some() && all.as_flattened().iter().all(is_before)
    })
}

/// The patches of such a room.
pub(super) struct Rectangles(Vec<Rectangle>);

impl Rectangles {
    /// Returns the patches of a room for which [`is_plain_room`] holds.
    pub(super) fn of(scene: &Description) -> Self {
        let all = corners(scene).unwrap_or_default();
        let size = all.as_flattened().as_flattened().iter().fold(0.0, |most: f64, c| most.max(c.abs()));
        let mut made = Vec::new();
        for (quad, corners) in scene.quads.iter().zip(&all) {
            let Some(whole) = rectangle(corners, size) else { continue };
            let [nu, nv] = quad.patches;
            let [a, b, _, d] = *corners;
            for (i, j) in (0..nv).flat_map(|j| (0..nu).map(move |i| (i, j))) {
                let place = |part: f64, from: f64, to: f64| from + (to - from) * part;
                let spans = core::array::from_fn(|axis| {
                    let c = |of: Triple| of.get(axis).copied().unwrap_or_default();
                    let along = |side: Triple, cell: u16, count: u16| {
                        let ends = [cell, cell + 1].map(|cell| f64::from(cell) / f64::from(count));
                        ends.map(|part| place(part, c(a), c(side)))
                    };
                    // One of both sides goes along the axis, or none does.
                    let (u, v) = (along(b, i, nu), along(d, j, nv));
                    let ends = if c(b) == c(a) { v } else { u };
                    let [first, second] = ends;
                    [first.min(second), first.max(second)]
                });
                made.push(Rectangle { spans, ..whole });
            }
        }
        Self(made)
    }

    /// Writes the form factors from patch number `number` to all.
    pub(super) fn row<S: Narrow>(&self, number: usize, row: &mut [S::Unit]) {
        let Some(own) = self.0.get(number) else { return };
        for (factor, other) in row.iter_mut().zip(&self.0) {
            let is_level = own.axis == other.axis && (own.at - other.at).abs() <= f64::EPSILON;
            *factor = S::unit(if is_level { 0.0 } else { (own.exchanged(other) / own.area()).max(0.0) });
        }
    }
}
