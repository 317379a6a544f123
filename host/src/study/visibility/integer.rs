//! Triangles, rays and depths of integers: every comparison is exact.
//!
//! The eye is the origin, x leads to the right, y up and z ahead. Bounds: |v| < 2^16 of a vertex and |r| < 2^31 of a ray make |v x w| < 2^33 of
//! an edge, |n| < 2^35 of a normal, n.v < 2^51, n.r < 2^68, and products of two depths < 2^120.

use core::cmp::Ordering;
use core::ops::Range;

use crate::picture::raster::Size;
use crate::study::error::StudyError;

/// Three integers.
pub type Vector = [i64; 3];

/// The largest size of a vertex's component.
pub const LARGEST: i64 = (1 << 16) - 1;

/// The largest size of a ray's component.
const LARGEST_RAY: i64 = (1 << 31) - 1;

/// Returns the cross product.
pub(super) const fn cross([ax, ay, az]: Vector, [bx, by, bz]: Vector) -> Vector {
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}

/// Returns the dot product.
pub(super) fn dot(a: Vector, b: Vector) -> i128 {
    let [x, y, z] = [(a[0], b[0]), (a[1], b[1]), (a[2], b[2])].map(|(a, b)| i128::from(a) * i128::from(b));
    x + y + z
}

const fn difference([ax, ay, az]: Vector, [bx, by, bz]: Vector) -> Vector {
    [ax - bx, ay - by, az - bz]
}

/// Returns `a / b` rounded up, for a `b` above 0.
pub(super) const fn ceiling(a: i64, b: i64) -> i64 {
    -(-a).div_euclid(b)
}

/// The pixels of a picture and their rays: integers with one common denominator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Raster {
    /// The pixels.
    pub size: Size,
    /// Half a column's width, half a row's height and the distance of the image plane, all above 0.
    steps: Vector,
}

impl Raster {
    /// Returns the raster whose image plane has the width `shape.0`, the height `shape.1` and the distance `focal` times its width from the eye.
    /// The distance is rounded to the nearest fraction that leaves the rays below 2^31.
    ///
    /// # Errors
    /// [`StudyError::Raster`] if there is no such fraction above 0.
    pub fn new(size: Size, shape: (u32, u32), focal: f64) -> Result<Self, StudyError> {
        let [nx, ny, w, h] = [size.width(), size.height(), shape.0, shape.1].map(i128::from);
        let fits = |(n, d): (i64, i64)| {
            // In units of 1 / (2 nx ny d) of the width of the image plane, times w.
            let (n, d) = (i128::from(n), i128::from(d));
            let steps = [w * ny * d, h * nx * d, 2 * nx * ny * w * n];
            let divisor = steps.into_iter().fold(0, divisor);
            let [x, y, z] = steps.map(|step| step / divisor.max(1));
            let largest = (nx * x).max(ny * y).max(z);
            let [x, y, z] = [x, y, z].map(|step| i64::try_from(step).unwrap_or(0));
            (largest <= i128::from(LARGEST_RAY) && z > 0).then_some([x, y, z])
        };
        let steps = convergents(focal).filter_map(fits).last();
        steps.map(|steps| Self { size, steps }).ok_or(StudyError::Raster(size))
    }

    /// Returns the ray through the middle of a pixel, of any length.
    #[must_use]
    pub fn ray(&self, x: u32, y: u32) -> Vector {
        let [nx, ny] = [self.size.width(), self.size.height()].map(i64::from);
        let [width, height, focal] = self.steps;
        [(2 * i64::from(x) + 1 - nx) * width, (ny - 1 - 2 * i64::from(y)) * height, focal]
    }

    /// Returns how much the x of a ray grows from column to column.
    pub(super) const fn step(&self) -> i64 {
        2 * self.steps[0]
    }

    /// Returns x, y and z of the ray through the upper right corner of the picture.
    #[must_use]
    pub fn corner(&self) -> Vector {
        let [nx, ny] = [self.size.width(), self.size.height()].map(i64::from);
        [nx * self.steps[0], ny * self.steps[1], self.steps[2]]
    }

    /// Returns the columns and rows whose rays pass within the bounds of points, all of them before the eye.
    fn bounds(&self, vertices: [Vector; 3]) -> [Range<u32>; 2] {
        let [width, height, focal] = self.steps;
        let sides = [self.size.width(), self.size.height()].map(i64::from);
        let range = |side: i64, step: i64, coordinates: [(i64, i64); 3]| {
            let bounds = coordinates.map(|(c, z)| {
                let (c, z) = (c * focal, z * step);
                (ceiling(c, z), c.div_euclid(z))
            });
            let least = bounds.iter().fold(i64::MAX, |least, bound| least.min(bound.0));
            let most = bounds.iter().fold(i64::MIN, |most, bound| most.max(bound.1));
            // The middle of pixel p is at 2 p + 1 - side.
            let (first, end) = (ceiling(least + side - 1, 2), (most + side - 1).div_euclid(2) + 1);
            let within = |place: i64| u32::try_from(place.clamp(0, side)).unwrap_or(0);
            within(first)..within(end)
        };
        [
            range(sides[0], width, vertices.map(|[x, _, z]| (x, z))),
            range(sides[1], height, vertices.map(|[_, y, z]| (-y, z))),
        ]
    }
}

fn divisor(a: i128, b: i128) -> i128 {
    if b == 0 { a } else { divisor(b, a % b) }
}

/// Returns fractions that come nearer and nearer to a number above 0, and end where they differ by less than its 10^-12th part.
#[expect(clippy::cast_possible_truncation, reason = "each part is below 2^31 where it is cast")]
fn convergents(number: f64) -> impl Iterator<Item = (i64, i64)> {
    let (mut last, mut best, mut rest) = ((0_i64, 1_i64), (1_i64, 0_i64), number);
    core::iter::from_fn(move || {
        let part = rest.floor();
        let is_close = best.1 > 0 && (best.0 as f64 / best.1 as f64 - number).abs() < 1e-12 * number;
        if is_close || !(0.0..2f64.powi(31)).contains(&part) || best.0.max(best.1) >= 1 << 31 {
            return None;
        }
        let whole = part as i64;
        let next = (whole * best.0 + last.0, whole * best.1 + last.1);
        (last, best) = (best, next);
        rest = 1.0 / (rest - part);
        Some(next)
    })
}

/// Where a ray passes a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cover {
    /// Outside.
    Outside,
    /// On an edge that belongs to it: of two triangles at both sides of an edge that is the right one, or the one below a horizontal edge.
    Edge,
    /// Inside.
    Inside,
}

/// A side of a triangle as seen from the eye: the plane through it and the eye.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Side {
    /// Its normal, to the inside of the triangle.
    pub normal: Vector,
    /// Whether rays in the plane are of the triangle: those of left sides, and of horizontal ones at the top.
    pub is_owned: bool,
}

/// A triangle before the eye.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Triangle {
    /// The vertices, in the order in which `normal` . vertex is above 0.
    pub vertices: [Vector; 3],
    /// The sides from the first vertex to the second, and so on.
    pub sides: [Side; 3],
    /// Its normal, away from the eye.
    pub normal: Vector,
    /// `normal` . vertex, above 0.
    pub distance: i64,
    /// The columns that its middles of pixels may lie in.
    pub columns: Range<u32>,
    /// The rows likewise.
    pub rows: Range<u32>,
}

impl Triangle {
    /// Returns the triangle, and whether its vertices ran counterclockwise as the eye sees them; nothing for one that has no area, is seen on edge, or
    /// has a vertex that is not before the eye or not below 2^16.
    #[must_use]
    pub fn new(vertices: [Vector; 3], raster: &Raster) -> Option<(Self, bool)> {
        let [a, b, c] = vertices;
        let is_sound =
            vertices.iter().all(|[x, y, z]| x.abs().max(y.abs()) <= LARGEST && (1..=LARGEST).contains(z));
        let volume = i64::try_from(dot(a, cross(b, c))).unwrap_or(0);
        if volume == 0 || !is_sound {
            return None;
        }
        let vertices = if volume > 0 { vertices } else { [a, c, b] };
        let [a, b, c] = vertices;
        let side = |from, to| {
            let normal @ [x, y, _] = cross(from, to);
            Side { normal, is_owned: x > 0 || x == 0 && y < 0 }
        };
        let [columns, rows] = raster.bounds(vertices);
        let triangle = Self {
            vertices,
            sides: [side(a, b), side(b, c), side(c, a)],
            normal: cross(difference(b, a), difference(c, a)),
            distance: volume.abs(),
            columns,
            rows,
        };
        Some((triangle, volume > 0))
    }

    /// Returns where a ray passes.
    #[must_use]
    pub fn cover(&self, ray: Vector) -> Cover {
        let mut cover = Cover::Inside;
        for side in &self.sides {
            match dot(side.normal, ray).cmp(&0) {
                Ordering::Less => return Cover::Outside,
                Ordering::Equal if !side.is_owned => return Cover::Outside,
                Ordering::Equal => cover = Cover::Edge,
                Ordering::Greater => {}
            }
        }
        cover
    }

    /// Returns how the plane's place along a ray lies to that of another plane: `Less` is nearer. A plane that is not met is farther than all.
    /// Its place is `distance / (normal . ray)`, of which the inverse is compared, which is linear over the picture.
    #[must_use]
    pub fn depth(&self, other: &Self, ray: Vector) -> Ordering {
        let [own, others] = [self, other].map(|triangle| dot(triangle.normal, ray));
        (others * i128::from(self.distance)).cmp(&(own * i128::from(other.distance)))
    }

    /// Returns the plane through the eye and the line in which its plane meets another: `h . r` is above 0 where the ray r meets its plane behind
    /// the other. The components of h are below 2^88 in size.
    pub(super) fn meeting(&self, other: &Self) -> [i128; 3] {
        let [own, others] = [self.distance, other.distance].map(i128::from);
        let component = |(n, m): (i64, i64)| own * i128::from(m) - others * i128::from(n);
        let [n, m] = [self.normal, other.normal];
        [(n[0], m[0]), (n[1], m[1]), (n[2], m[2])].map(component)
    }

    /// Returns on which side of the plane a point lies: `Less` is the side of the eye.
    #[must_use]
    pub fn side(&self, point: Vector) -> Ordering {
        dot(self.normal, point).cmp(&self.distance.into())
    }
}

/// The scene as the eye sees it.
#[derive(Clone, Debug)]
pub struct View {
    /// The pixels.
    pub raster: Raster,
    /// The triangles. The id of a pixel is 0, or one more than the number of the triangle that is seen.
    pub triangles: Vec<Triangle>,
}

impl View {
    /// Returns the triangle of an id.
    #[must_use]
    pub fn triangle(&self, id: u32) -> Option<&Triangle> {
        self.triangles.get(usize::try_from(id).ok()?.checked_sub(1)?)
    }

    /// Returns all triangles with their ids.
    pub fn each(&self) -> impl DoubleEndedIterator<Item = (u32, &Triangle)> {
        self.triangles.iter().enumerate().map(|(place, triangle)| (number(place + 1), triangle))
    }

    /// Returns whether the triangle of the first id is seen before that of the second: it is nearer, or as near and of the lower number. Id 0 is
    /// behind all.
    #[must_use]
    pub fn is_before(&self, id: u32, other: u32, ray: Vector) -> bool {
        match (self.triangle(id), self.triangle(other)) {
            (Some(own), Some(others)) => own.depth(others, ray).then(id.cmp(&other)).is_lt(),
            (own, _) => own.is_some(),
        }
    }

    /// Returns a picture without any triangle.
    #[must_use]
    pub fn blank(&self) -> Vec<u32> {
        vec![0; self.raster.size.pixels()]
    }
}

/// Returns a count of things in memory as a 32-bit number: there are fewer than 2^32 of them.
pub(super) fn number(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(u32::MAX)
}

/// Returns the pixels of a row that lie in these columns.
pub(super) fn pixels(ids: &mut [u32], width: u32, y: u32, columns: Range<u32>) -> &mut [u32] {
    let place = |x: u32| y as usize * width as usize + x as usize;
    ids.get_mut(place(columns.start)..place(columns.end)).unwrap_or_default()
}
