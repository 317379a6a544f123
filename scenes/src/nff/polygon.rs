//! A polygon cut into triangles.

use crate::space::{Triple, cross, difference, length, unit};

/// Twice the area of a triangle that is nothing but rounding, where the polygon is about 1 long.
const NOTHING: f64 = 1e-14;

/// What a polygon is cut into.
#[derive(Debug)]
pub(super) struct Cut {
    /// The polygon's own normal (Newell's), of length 1: its corners run counterclockwise about it.
    pub(super) normal: Triple,
    /// Three corners each, by their numbers from 0, in the order of the polygon.
    pub(super) triangles: Vec<[usize; 3]>,
}

/// Cuts a polygon; `None` if it has no area. Triangles without area are left out.
///
/// The fan about the first corner is right for every convex polygon, and wherever none of its triangles is turned
/// over. Otherwise ears are cut off. A polygon that crosses itself is cut somehow.
pub(super) fn cut(corners: &[Triple]) -> Option<Cut> {
    let &first = corners.first()?;
    // About the first corner, so that a small polygon far away keeps its digits; halved, so that no difference
    // overflows; about 1 long, so that no product does.
    let mut places: Vec<Triple> = corners.iter().map(|&c| difference(half(c), half(first))).collect();
    let longest = places.iter().flatten().fold(0.0_f64, |most, c| most.max(c.abs()));
    places.iter_mut().flatten().for_each(|c| *c /= longest);
    let mut sum = [0.0; 3];
    for (&a, &b) in places.iter().zip(places.iter().skip(1)) {
        for (sum, c) in sum.iter_mut().zip(cross(a, b)) {
            *sum += c;
        }
    }
    if length(sum) <= NOTHING {
        return None;
    }
    let normal = unit(sum)?;
    let flat: Vec<Point> = places.into_iter().map(|place| flatten(place, normal)).collect();
    Some(Cut { normal, triangles: fan(&flat).unwrap_or_else(|| Ears::new(&flat).cut()) })
}

fn half(v: Triple) -> Triple {
    v.map(|c| c / 2.0)
}

/// A place in the plane, where the polygon runs counterclockwise.
type Point = [f64; 2];

/// Leaves out the axis along which the polygon looks largest.
fn flatten([x, y, z]: Triple, normal: Triple) -> Point {
    let [nx, ny, nz] = normal;
    let most = nx.abs().max(ny.abs()).max(nz.abs());
    let (seen, [a, b]) = if nz.abs() >= most {
        (nz, [x, y])
    } else if ny.abs() >= most {
        (ny, [z, x])
    } else {
        (nx, [y, z])
    };
    if seen > 0.0 { [a, b] } else { [b, a] }
}

/// Twice the area of a triangle, above 0 if it runs counterclockwise.
fn area([ax, ay]: Point, [bx, by]: Point, [cx, cy]: Point) -> f64 {
    (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
}

/// The triangles between the first corner and each side, unless one of them is turned over.
fn fan(corners: &[Point]) -> Option<Vec<[usize; 3]>> {
    let &first = corners.first()?;
    let sides = corners.iter().zip(corners.iter().skip(1)).enumerate().skip(1);
    let mut triangles = Vec::with_capacity(corners.len().saturating_sub(2));
    for (index, (&a, &b)) in sides {
        match area(first, a, b) {
            size if size < -NOTHING => return None,
            size if size <= NOTHING => {}
            _ => triangles.push([0, index, index + 1]),
        }
    }
    Some(triangles)
}

/// A corner that has not been cut off.
#[derive(Clone, Copy)]
struct Corner {
    place: Point,
    before: usize,
    after: usize,
    gone: bool,
    /// Whether it is an ear, once that has been looked at: cutting an ear off changes it for its neighbours only.
    ear: Option<bool>,
}

/// Meisters' way: as long as there is more than a triangle, some corner's triangle lies inside and can go.
struct Ears(Vec<Corner>);

impl Ears {
    fn new(places: &[Point]) -> Self {
        let count = places.len();
        let corner = |(i, &place)| {
            let (before, after) = ((i + count - 1) % count, (i + 1) % count);
            Corner { place, before, after, gone: false, ear: None }
        };
        Self(places.iter().enumerate().map(corner).collect())
    }

    /// The corner of that number; all numbers here are of corners.
    fn corner(&self, index: usize) -> Corner {
        let nowhere = Corner { place: [0.0; 2], before: 0, after: 0, gone: true, ear: None };
        self.0.get(index).copied().unwrap_or(nowhere)
    }

    fn change(&mut self, index: usize, how: impl FnOnce(&mut Corner)) {
        if let Some(corner) = self.0.get_mut(index) {
            how(corner);
        }
    }

    fn cut(mut self) -> Vec<[usize; 3]> {
        let mut triangles = Vec::with_capacity(self.0.len());
        let (mut at, mut left, mut passed) = (0, self.0.len(), 0);
        while left > 2 {
            let Corner { place, before, after, ear, .. } = self.corner(at);
            let size = area(self.corner(before).place, place, self.corner(after).place);
            let flat = size.abs() <= NOTHING;
            let ear = flat || ear.unwrap_or_else(|| size > 0.0 && self.is_empty(at));
            // Where there is no ear, the polygon crosses itself: any corner goes, and it ends all the same.
            if ear || passed >= left {
                if !flat {
                    triangles.push([before, at, after]);
                }
                self.change(at, |corner| corner.gone = true);
                self.change(before, |corner| (corner.after, corner.ear) = (after, None));
                self.change(after, |corner| (corner.before, corner.ear) = (before, None));
                (left, passed) = (left - 1, 0);
            } else {
                self.change(at, |corner| corner.ear = Some(false));
                passed += 1;
            }
            at = after;
        }
        triangles
    }

    /// Whether no other corner lies in the triangle of corner `at`. Corners in the very places of its own do not: a
    /// polygon with a hole comes back along the cut that leads there.
    fn is_empty(&self, at: usize) -> bool {
        let Corner { place: b, before, after, .. } = self.corner(at);
        let (a, c) = (self.corner(before).place, self.corner(after).place);
        let inside = |p| area(a, b, p) >= 0.0 && area(b, c, p) >= 0.0 && area(c, a, p) >= 0.0;
        !self.0.iter().any(|corner| {
            let p = corner.place;
            !corner.gone && p != a && p != b && p != c && inside(p)
        })
    }
}

#[cfg(test)]
mod tests;
