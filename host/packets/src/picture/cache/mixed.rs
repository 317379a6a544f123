//! The light of a quadrilateral between the places where it was gathered.

use rta_core::radiosity::Quad;
use rta_scenes::narrow::Narrow;
use rta_scenes::space::{Triple, cross, difference, dot, length, unit};

use super::Record;

/// How many times as far as a place speaks for others it is mixed with them, so that at least a few are mixed anywhere.
const WIDTH: f64 = 2.5;

/// The side of a patch, as a part of the least distance that a place on its quadrilateral speaks for.
const SIDE: f64 = 1.5;

/// What rounding may take a place off a row of vertices, as a part of how far it is mixed.
const NEAR: f64 = 1e-6;

/// The most patches along a side.
const MOST: u16 = 256;

/// What is known of a slope without any place, against what the places tell: so little that it counts only where they lie in a row.
const FLAT: f64 = 0.02;

/// The sums of least squares at a vertex: of weights, of weights times what a place is away along both sides of the plane, x and y, and of
/// weights times light.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    whole: f64,
    reach: f64,
    x: f64,
    y: f64,
    xx: f64,
    xy: f64,
    yy: f64,
    light: [Triple; 3],
}

/// The light at the vertices of a quadrilateral's patches.
pub(super) struct Mixed {
    patches: [u16; 2],
    sums: Vec<Sums>,
}

impl Mixed {
    /// Divides a quadrilateral into patches as small as the places on it are close, and mixes their light at its vertices. Without any place its
    /// patches are its own.
    pub(super) fn new<S: Narrow>(quad: &Quad<S>, records: &[Record]) -> Self {
        let corners = super::corners(quad);
        let [a, b, c, d] = corners;
        let normal = unit(cross(difference(c, a), difference(d, b))).unwrap_or_default();
        let first = unit(difference(b, a)).unwrap_or_default();
        let sides = [first, cross(normal, first)];
        let flat = |place: Triple| sides.map(|side| dot(difference(place, a), side));
        let mut mixed = Self { patches: quad.patches, sums: Vec::new() };
        let Some(least) = records.iter().map(|record| record.reach).min_by(f64::total_cmp) else {
            return mixed;
        };
        let along = |edges: [Triple; 2]| edges.map(length).into_iter().fold(0.0, f64::max);
        let lengths =
            [along([difference(b, a), difference(c, d)]), along([difference(d, a), difference(c, b)])];
        for (patches, length) in mixed.patches.iter_mut().zip(lengths) {
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // cut to the range
            let needed = (length / (SIDE * least)).ceil().clamp(1.0, f64::from(MOST)) as u16;
            *patches = needed;
        }
        let [nu, nv] = mixed.patches;
        let outline = corners.map(flat);
        let records: Vec<_> = records.iter().map(|record| (flat(record.place), record)).collect();
        for j in 0..=nv {
            let vertex =
                |i: u16| bilinear(outline, [f64::from(i) / f64::from(nu), f64::from(j) / f64::from(nv)]);
            let ([ax, ay], [bx, by]) = (vertex(0), vertex(nu));
            let (wx, wy) = (bx - ax, by - ay);
            let length = wx.hypot(wy);
            // Those that lie near the line of the row, in their order.
            let is_near = |([x, y], record): &&([f64; 2], &Record)| {
                ((x - ax) * wy - (y - ay) * wx).abs() < length * WIDTH * record.reach * (1.0 + NEAR)
            };
            let beside: Vec<_> = records.iter().filter(is_near).copied().collect();
            mixed.sums.extend((0..=nu).map(|i| Sums::of(vertex(i), &beside)));
        }
        mixed
    }

    /// Returns the patches along u and along v.
    pub(super) const fn patches(&self) -> [u16; 2] {
        self.patches
    }

    /// Returns the light at a vertex, 0 or more, by its number along u and along v; `None` where no place tells it.
    pub(super) fn light(&self, [i, j]: [u16; 2]) -> Option<Triple> {
        let [nu, _] = self.patches.map(usize::from);
        self.sums.get(usize::from(i) + usize::from(j) * (nu + 1))?.solved()
    }
}

/// Returns the place at (u, v) of a quadrilateral in the plane.
fn bilinear([a, b, c, d]: [[f64; 2]; 4], [u, v]: [f64; 2]) -> [f64; 2] {
    let mix =
        |[ax, ay]: [f64; 2], [bx, by]: [f64; 2], part: f64| [ax + (bx - ax) * part, ay + (by - ay) * part];
    mix(mix(a, b, u), mix(d, c, u), v)
}

impl Sums {
    /// Returns the sums at a place of the plane.
    fn of([px, py]: [f64; 2], records: &[([f64; 2], &Record)]) -> Self {
        let mut sums = Self::default();
        for ([x, y], record) in records {
            let (x, y, end) = (x - px, y - py, WIDTH * record.reach);
            let square = x * x + y * y;
            if square >= end * end {
                continue;
            }
            let weight = 1.0 - square.sqrt() / end;
            let (wx, wy) = (weight * x, weight * y);
            sums.whole += weight;
            sums.reach += weight * record.reach * record.reach;
            sums.x += wx;
            sums.y += wy;
            sums.xx += wx * x;
            sums.xy += wx * y;
            sums.yy += wy * y;
            for (sums, light) in sums.light.iter_mut().zip(record.light) {
                let [own, along, across] = sums;
                *own += weight * light;
                *along += wx * light;
                *across += wy * light;
            }
        }
        sums
    }

    /// Returns the light at the place itself of the plane of least squares; `None` where nothing was added.
    fn solved(&self) -> Option<Triple> {
        if self.whole <= 0.0 {
            return None;
        }
        let flat = FLAT * self.reach;
        let (xx, yy) = (self.xx + flat, self.yy + flat);
        // Cramer's rule: the weight of each sum of light in the result.
        let own = xx * yy - self.xy * self.xy;
        let along = self.xy * self.y - self.x * yy;
        let across = self.x * self.xy - xx * self.y;
        let determinant = self.whole * own + self.x * along + self.y * across;
        Some(self.light.map(|[light, x, y]| ((own * light + along * x + across * y) / determinant).max(0.0)))
    }
}

#[cfg(test)]
mod tests {
    use super::{Record, Sums};

    fn record(place: [f64; 2], light: f64) -> ([f64; 2], Record) {
        (place, Record { place: [0.0; 3], reach: 1.0, light: [light, 2.0 * light, 0.0] })
    }

    #[test]
    fn a_slope_comes_back_at_an_edge() {
        let field = |[x, y]: [f64; 2]| 5.0 + 2.0 * x - 3.0 * y;
        // All of them on one side of the place that is asked for.
        let places = [[0.3, 0.1], [0.5, -0.9], [0.9, 0.8], [1.1, 0.2], [0.2, 0.6], [1.4, -0.5]];
        let records = places.map(|place| record(place, field(place)));
        let all: Vec<_> = records.iter().map(|(place, record)| (*place, record)).collect();
        let [r, g, b] = Sums::of([0.0, 0.0], &all).solved().expect("they are near");
        // Less by what a slope without places would count.
        assert!((r - 5.0).abs() < 0.15 && (g - 2.0 * r).abs() < 1e-12 && b == 0.0, "{r} {g} {b}");
    }

    #[test]
    fn few_places_are_a_mean_and_none_are_nothing() {
        let one = record([0.5, 0.0], 3.0);
        let [r, ..] = Sums::of([0.0, 0.0], &[(one.0, &one.1)]).solved().expect("it is near");
        assert!((r - 3.0).abs() < 1e-12);
        let beside = [record([0.5, 0.0], 3.0), record([-0.5, 0.0], 4.0)];
        let all: Vec<_> = beside.iter().map(|(place, record)| (*place, record)).collect();
        let [r, ..] = Sums::of([0.0, 0.0], &all).solved().expect("they are near");
        assert!((r - 3.5).abs() < 1e-12);
        assert!(Sums::of([9.0, 0.0], &all).solved().is_none());
        assert!(Sums::of([0.0, 0.0], &[]).solved().is_none());
    }
}
