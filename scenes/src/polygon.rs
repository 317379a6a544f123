//! A polygon cut into triangles: what its outline winds around.

use i_triangle::float::triangulation::Triangulation;
use i_triangle::float::triangulator::Triangulator;

use crate::space::{Triple, cross, difference, dot, length, unit};

/// Twice the area of a triangle that is nothing but rounding, where the polygon is about 1 long.
const NOTHING: f64 = 1e-14;

/// Most corners that a polygon may have: the time to look at a concave one grows with their square.
pub const MOST_CORNERS: u32 = 10_000;

/// How near a place has to be to a corner to be that corner, where the polygon is about 1 long.
const NEAR: f64 = 1e-9;

/// The most places where an outline may cross itself: time and memory grow faster than their number.
pub(crate) const MOST_CROSSINGS: usize = 10_000;

/// What a polygon is cut into.
#[derive(Debug)]
struct Cut {
    /// The polygon's own normal (Newell's), of length 1: its corners run counterclockwise about it.
    normal: Triple,
    /// Three corners each, by their numbers from 0, counterclockwise; numbers beyond the corners are those of crossings.
    triangles: Vec<[usize; 3]>,
    /// Where the outline crosses itself, in the order of their numbers.
    crossings: Vec<Crossing>,
}

/// A place on a side, between two corners.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Crossing {
    ends: [usize; 2],
    /// How far it is from the first end, 0 to 1 of the side.
    part: f64,
}

impl Crossing {
    /// Returns what is there of what the corners have: places, or normals.
    fn mix(&self, of_corners: &[Triple]) -> Triple {
        let [a, b] = self.ends.map(|end| of_corners.get(end).copied().unwrap_or_default());
        let [x, y, z] = [0, 1, 2].map(|axis: usize| {
            let (a, b) = (a.get(axis).copied().unwrap_or(0.0), b.get(axis).copied().unwrap_or(0.0));
            a * (1.0 - self.part) + b * self.part
        });
        [x, y, z]
    }
}

/// Why a polygon is not cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NotCut {
    /// It has no area.
    Flat,
    /// It crosses itself more often than [`MOST_CROSSINGS`].
    Tangled,
}

/// Cuts a polygon. Triangles without area are left out.
///
/// A convex polygon is a fan about its first corner. Of any other it is shown what the outline winds around, however often
/// and in either direction (the non-zero rule); where the outline begins plays no part.
fn cut(corners: &[Triple]) -> Result<Cut, NotCut> {
    let places = scaled(corners);
    let normal = normal(&places).ok_or(NotCut::Flat)?;
    let plane = Plane::of(normal);
    let flat: Vec<Point> = places.into_iter().map(|place| plane.flatten(place)).collect();
    if plane.is_convex(&flat) {
        return Ok(Cut { normal, triangles: plane.fan(&flat), crossings: Vec::new() });
    }
    if is_tangled(&flat) {
        return Err(NotCut::Tangled);
    }
    let (triangles, crossings) = plane.wound(&flat);
    if triangles.is_empty() { Err(NotCut::Flat) } else { Ok(Cut { normal, triangles, crossings }) }
}

/// The triangles of a polygon, with its corners and normals.
pub(crate) struct Sheet {
    /// Vertices, and normals at them where the polygon has some.
    pub(crate) triangles: Vec<([Triple; 3], Option<[Triple; 3]>)>,
    /// Whether the outline crosses itself.
    pub(crate) is_crossed: bool,
}

/// Cuts a polygon with normals at its corners, or with none at all; a normal of length 0 is the polygon's own.
pub(crate) fn sheet(mut corners: Vec<Triple>, mut normals: Vec<Triple>) -> Result<Sheet, NotCut> {
    let Cut { normal, triangles, crossings } = cut(&corners)?;
    let is_crossed = !crossings.is_empty();
    normals.iter_mut().filter(|own| **own == [0.0; 3]).for_each(|own| *own = normal);
    for crossing in crossings {
        corners.push(crossing.mix(&corners));
        if !normals.is_empty() {
            // Along a side on which they cancel out, the polygon's own.
            let mixed = crossing.mix(&normals);
            normals.push(if mixed == [0.0; 3] { normal } else { mixed });
        }
    }
    let of = |list: &[Triple], vertex: usize| list.get(vertex).copied().unwrap_or(normal);
    let triangle = |triangle: [usize; 3]| {
        let normals = (!normals.is_empty()).then(|| triangle.map(|vertex| of(&normals, vertex)));
        (triangle.map(|vertex| of(&corners, vertex)), normals)
    };
    // Where it is cut, two places may have become one corner.
    let triangles = triangles.into_iter().map(triangle).filter(|(vertices, _)| !is_flat(*vertices));
    let triangles: Vec<_> = triangles.collect();
    if triangles.is_empty() { Err(NotCut::Flat) } else { Ok(Sheet { triangles, is_crossed }) }
}

/// Returns whether three places are on one line.
pub(crate) fn is_flat([a, b, c]: [Triple; 3]) -> bool {
    let sides = unit(difference(b, a)).zip(unit(difference(c, a)));
    sides.is_none_or(|(first, second)| cross(first, second) == [0.0; 3])
}

/// Returns the area of a polygon as Newell's normal has it, or a number above 0 where that is 0.
pub(crate) fn area(corners: &[Triple]) -> f64 {
    let sides = corners.iter().zip(corners.iter().cycle().skip(1));
    let first = corners.first().copied().unwrap_or_default();
    let parts = sides.map(|(&a, &b)| cross(difference(a, first), difference(b, first)));
    (length(sum(parts)) / 2.0).clamp(f64::MIN_POSITIVE, f64::MAX)
}

fn sum(vectors: impl Iterator<Item = Triple>) -> Triple {
    vectors.fold([0.0; 3], |[x, y, z], [a, b, c]| [x + a, y + b, z + c])
}

/// Returns the corners from the least of their coordinates on, about 1 long: a small polygon far away keeps its digits, no
/// difference and no product overflows, and it does not matter which corner comes first.
fn scaled(corners: &[Triple]) -> Vec<Triple> {
    let half = |v: Triple| v.map(|c| c / 2.0);
    let least =
        corners.iter().fold([f64::INFINITY; 3], |[x, y, z], [a, b, c]| [x.min(*a), y.min(*b), z.min(*c)]);
    let mut places: Vec<Triple> = corners.iter().map(|&c| difference(half(c), half(least))).collect();
    let longest = places.iter().flatten().fold(0.0_f64, |most, c| most.max(c.abs()));
    places.iter_mut().flatten().for_each(|c| *c /= longest);
    places
}

/// Returns Newell's normal; where the parts of the polygon all but cancel out, as the two wings of a bow tie do, the direction
/// of the largest cross product of two sides that follow each other; `None` where there is no area.
fn normal(places: &[Triple]) -> Option<Triple> {
    let after = |by| places.iter().cycle().skip(by);
    let first = *places.first()?;
    let parts = places.iter().zip(after(1)).map(|(&a, &b)| cross(difference(a, first), difference(b, first)));
    let newell = sum(parts);
    let corners = places.iter().zip(after(1)).zip(after(2));
    let turns = corners.map(|((&a, &b), &c)| cross(difference(b, a), difference(c, b)));
    let size = |v: &Triple| dot(*v, *v);
    let largest = turns.max_by(|a, b| size(a).total_cmp(&size(b)))?;
    if length(newell) > 1e-6 * length(largest) && length(newell) > NOTHING {
        return unit(newell);
    }
    let largest = if dot(newell, largest) < 0.0 { largest.map(|c| -c) } else { largest };
    if length(largest) > NOTHING { unit(largest) } else { None }
}

/// A place in the plane.
type Point = [f64; 2];

/// The plane in which a polygon is looked at: that of two axes. It is one plane for both directions of the outline.
struct Plane {
    axes: [usize; 2],
    /// 1 where the polygon runs counterclockwise in it, else -1.
    sense: f64,
}

impl Plane {
    /// Leaves out the axis along which the polygon looks largest.
    fn of([nx, ny, nz]: Triple) -> Self {
        let most = nx.abs().max(ny.abs()).max(nz.abs());
        let (seen, axes) = if nz.abs() >= most {
            (nz, [0, 1])
        } else if ny.abs() >= most {
            (ny, [2, 0])
        } else {
            (nx, [1, 2])
        };
        Self { axes, sense: seen.signum() }
    }

    fn flatten(&self, place: Triple) -> Point {
        self.axes.map(|axis| place.get(axis).copied().unwrap_or(0.0))
    }

    /// Twice the area of a triangle, above 0 if it runs the way of the polygon.
    fn twice_area(&self, a: Point, b: Point, c: Point) -> f64 {
        self.sense * twice_area(a, b, c)
    }

    /// Whether the outline turns one way at every corner, and in all once around. Corners in one place count as one.
    fn is_convex(&self, corners: &[Point]) -> bool {
        let mut places = corners.to_vec();
        places.dedup();
        if places.len() > 1 && places.first() == places.last() {
            places.pop();
        }
        let after = |by| places.iter().cycle().skip(by);
        let mut rises = 0;
        for ((&a, &b), &c) in places.iter().zip(after(1)).zip(after(2)) {
            let ([abx, aby], [bcx, bcy]) = ([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
            let turn = self.twice_area(a, b, c);
            let is_back = turn.abs() <= NOTHING && abx * bcx + aby * bcy < 0.0;
            if turn < -NOTHING || is_back {
                return false;
            }
            // A direction that goes once around begins to rise once.
            let rising = |x: f64, y: f64| y > 0.0 || (y == 0.0 && x > 0.0);
            rises += u32::from(!rising(abx, aby) && rising(bcx, bcy));
        }
        rises == 1
    }

    /// The triangles between the first corner and each side.
    fn fan(&self, corners: &[Point]) -> Vec<[usize; 3]> {
        let first = corners.first().copied().unwrap_or_default();
        let sides = corners.iter().zip(corners.iter().skip(1)).enumerate().skip(1);
        let sides = sides.filter(|(_, (a, b))| self.twice_area(first, **a, **b) > NOTHING);
        sides.map(|(index, _)| [0, index, index + 1]).collect()
    }

    /// Cuts what an outline winds around: the triangles, and where it crosses itself.
    fn wound(&self, corners: &[Point]) -> (Vec<[usize; 3]>, Vec<Crossing>) {
        let Triangulation { points, indices } = Triangulator::<u32, i64>::default().triangulate(corners);
        let mut sorted: Vec<usize> = (0..corners.len()).collect();
        let at = |index: usize| corners.get(index).copied().unwrap_or_default();
        // The first of those in one place comes first.
        sorted.sort_by(|&a, &b| at(a)[0].total_cmp(&at(b)[0]));
        let mut crossings = Vec::new();
        let mut number = |&point: &Point| {
            let near = sorted.partition_point(|&index| at(index)[0] < point[0] - NEAR);
            let candidates = sorted.iter().skip(near).take_while(|&&index| at(index)[0] <= point[0] + NEAR);
            let away = |index: usize| (at(index)[0] - point[0]).hypot(at(index)[1] - point[1]);
            let nearest = candidates.copied().min_by(|&a, &b| away(a).total_cmp(&away(b)).then(a.cmp(&b)));
            nearest.filter(|&index| away(index) <= NEAR).unwrap_or_else(|| {
                crossings.push(crossing(corners, point));
                corners.len() + crossings.len() - 1
            })
        };
        let numbers: Vec<usize> = points.iter().map(&mut number).collect();
        let vertex = |index: u32| usize::try_from(index).ok().and_then(|index| numbers.get(index)).copied();
        let triangles = indices.chunks_exact(3).filter_map(|triangle| {
            let &[a, b, c] = triangle else { return None };
            let place = |index: u32| usize::try_from(index).ok().and_then(|index| points.get(index)).copied();
            let size = self.twice_area(place(a)?, place(b)?, place(c)?);
            let [a, b, c] = [vertex(a)?, vertex(b)?, vertex(c)?];
            (size.abs() > NOTHING).then_some(if size > 0.0 { [a, b, c] } else { [a, c, b] })
        });
        (triangles.collect(), crossings)
    }
}

/// Twice the area of a triangle, above 0 if it runs counterclockwise.
fn twice_area([ax, ay]: Point, [bx, by]: Point, [cx, cy]: Point) -> f64 {
    (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
}

/// Whether the outline crosses itself too often to be cut up. The few sides of a small one cannot.
fn is_tangled(corners: &[Point]) -> bool {
    if corners.len() * corners.len() / 2 <= MOST_CROSSINGS {
        return false;
    }
    let side = |index: usize| corners.get(index).zip(corners.get((index + 1) % corners.len()));
    let sides: Vec<_> = (0..corners.len()).filter_map(side).collect();
    let mut crossings = 0;
    for (index, &(&a, &b)) in sides.iter().enumerate() {
        let crosses = |&&(&c, &d): &&(&Point, &Point)| {
            let (c_side, d_side) = (twice_area(a, b, c), twice_area(a, b, d));
            c_side * d_side < 0.0 && twice_area(c, d, a) * twice_area(c, d, b) < 0.0
        };
        crossings += sides.iter().skip(index + 1).filter(crosses).count();
        if crossings > MOST_CROSSINGS {
            return true;
        }
    }
    false
}

/// Returns the place on the side that is nearest to a point.
fn crossing(corners: &[Point], [x, y]: Point) -> Crossing {
    let mut nearest = (f64::INFINITY, Crossing { ends: [0; 2], part: 0.0 });
    let sides = corners.iter().zip(corners.iter().cycle().skip(1)).enumerate();
    for (index, (&[ax, ay], &[bx, by])) in sides {
        let ([dx, dy], [px, py]) = ([bx - ax, by - ay], [x - ax, y - ay]);
        let square = dx * dx + dy * dy;
        let part = if square > 0.0 { ((px * dx + py * dy) / square).clamp(0.0, 1.0) } else { 0.0 };
        let away = (px - part * dx).hypot(py - part * dy);
        if away < nearest.0 {
            nearest = (away, Crossing { ends: [index, (index + 1) % corners.len()], part });
        }
    }
    nearest.1
}

#[cfg(test)]
mod tests;
