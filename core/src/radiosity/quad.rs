//! Quadrilaterals: places on them, and back.

use core::marker::PhantomData;

use crate::color::Rgb;
use crate::scalar::vector::{UnitVec3, Vec3, Vector};
use crate::scalar::{Scalar, Unit};

/// A flat convex quadrilateral, divided into patches. One side reflects: that from which its corners run counterclockwise.
#[derive(Clone, Copy, Debug)]
pub struct Quad<S: Scalar> {
    /// The corners. Places between them are bilinear: u goes from the first to the second, v from the first to the fourth.
    pub corners: [Vec3<S>; 4],
    /// Patches along u and along v, 1 or more. Patch `i + j * patches[0]` is number i along u and j along v.
    pub patches: [u16; 2],
    /// Number of its first patch: as many as the quadrilaterals before it have.
    pub first: u32,
    /// Reflectance, 0 to [`greatest_reflectance`].
    pub reflectance: Rgb<S::Unit>,
    /// Emitted radiosity of the patches that emit: pi times the emitted radiance.
    pub emission: Rgb<S::Light>,
    /// Which patches emit, as numbers along u and v: from the first pair up to, but not including, the second. All is `[[0; 2], patches]`.
    pub emitting: [[u16; 2]; 2],
    /// Number of the first of its triangles in the scene's list, all of which lie in it and fill it.
    pub triangle: u32,
    /// How many triangles there are, 1 or more.
    pub triangles: u32,
}

/// Returns the greatest reflectance of a patch, 0.98: with more, light goes round too often to be followed to its end.
pub fn greatest_reflectance<U: Unit>() -> U {
    U::ratio(98, 100)
}

/// Returns the place `part` (0 to 1) of the way from `a` to `b`.
#[inline]
fn between<S: Scalar>(a: Vec3<S>, b: Vec3<S>, part: S::Unit) -> Vec3<S> {
    let way = b - a;
    a + Vec3::<S>::new(way.x().scale(part), way.y().scale(part), way.z().scale(part))
}

impl<S: Scalar> Quad<S> {
    /// Returns the place at (u, v), 0 to 1 each.
    #[inline]
    pub fn place(&self, [u, v]: [S::Unit; 2]) -> Vec3<S> {
        let [a, b, c, d] = self.corners;
        between::<S>(between::<S>(a, b, u), between::<S>(d, c, u), v)
    }

    /// Returns (u, v) of a place of a patch that is given by the parts of the patch along u and v, 0 to 1 each.
    #[inline]
    pub fn within(&self, cell: [u16; 2], part: [S::Unit; 2]) -> [S::Unit; 2] {
        let along = |cell: u16, part: S::Unit, count: u16| {
            let share = |cells: u16| S::Unit::fraction(cells.into(), count.into());
            share(cell) + share(1).times(part)
        };
        let ([i, j], [u, v], [nu, nv]) = (cell, part, self.patches);
        [along(i, u, nu), along(j, v, nv)]
    }

    /// Returns the corners of a patch, in the order of those of the quadrilateral.
    pub fn outline(&self, [i, j]: [u16; 2]) -> [Vec3<S>; 4] {
        let ([nu, nv], part) =
            (self.patches, |cell: u16, count: u16| S::Unit::fraction(cell.into(), count.into()));
        [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| self.place([part(i, nu), part(j, nv)]))
    }

    /// Returns the emitted radiosity of a patch.
    pub fn emitted(&self, cell: [u16; 2]) -> Rgb<S::Light> {
        let [from, to] = self.emitting;
        let is_within = (0..2).all(|k| from.get(k) <= cell.get(k) && cell.get(k) < to.get(k));
        if is_within { self.emission } else { Rgb::BLACK }
    }

    /// Returns the number of its patches.
    pub fn len(&self) -> usize {
        let [nu, nv] = self.patches.map(usize::from);
        nu * nv
    }

    /// Returns whether it has no patches.
    pub fn is_empty(&self) -> bool {
        self.patches.contains(&0)
    }

    /// Returns the directions P_u and P_v at (u, v): how a place moves with u and with v.
    pub(super) fn slopes(&self, [u, v]: [S::Unit; 2]) -> [Vec3<S>; 2] {
        let [a, b, c, d] = self.corners;
        [between::<S>(b - a, c - d, v), between::<S>(d - a, c - b, u)]
    }

    /// Returns `|P_u x P_v|` at the corners (0, 0), (1, 0), (1, 1) and (0, 1) as parts of the largest of them, which is the first number:
    /// how densely places that are spread evenly in (u, v) do *not* lie there. `None` for a quadrilateral that is not convex.
    pub(super) fn spread(&self, normal: UnitVec3<S>) -> Option<(usize, [S::Unit; 4])> {
        let flat = Flat::<S>::along(normal);
        let zero = S::ZERO.square();
        let [a, b, c, d] = self.corners;
        let (ab, bc, dc, ad) = (b - a, c - b, c - d, d - a);
        let areas = [(ab, ad), (ab, bc), (dc, bc), (dc, ad)].map(|(u, v)| area(flat.plan(u), flat.plan(v)));
        let is_negative = areas.first().is_some_and(|&area| area < zero);
        let areas = areas.map(|area| if is_negative { zero - area } else { area });
        let mut most = (0, zero);
        for (corner, &area) in areas.iter().enumerate() {
            if area > most.1 {
                most = (corner, area);
            }
        }
        let is_convex = areas.iter().all(|&area| area > zero);
        is_convex.then(|| (most.0, areas.map(|area| S::part(area, most.1))))
    }

    /// Returns (u, v) of a place of the quadrilateral, by Newton's iteration from the middle, in its ground plan.
    pub(super) fn solved(&self, normal: UnitVec3<S>, place: Vec3<S>) -> [S::Unit; 2] {
        let flat = Flat::<S>::along(normal);
        let [a, b, c, d] = self.corners;
        // One step is exact in a parallelogram; elsewhere each doubles the digits.
        let steps = if b - a == c - d { 1 } else { 6 };
        let (a, b, c, d, place) = (flat.plan(a), flat.plan(b), flat.plan(c), flat.plan(d), flat.plan(place));
        let zero = S::ZERO.square();
        let mut at = [S::Unit::ratio(1, 2); 2];
        for _ in 0..steps {
            let [u, v] = at;
            let along = flat_between(minus(b, a), minus(c, d), v);
            let across = flat_between(minus(d, a), minus(c, b), u);
            let rest = minus(place, flat_between(flat_between(a, b, u), flat_between(d, c, u), v));
            let whole = area(along, across);
            let part = |part: S::Wide| {
                let is_forwards = (part > zero) == (whole > zero);
                if is_forwards { S::part(part, whole) } else { -S::part(zero - part, whole) }
            };
            let step = [part(area(rest, across)), part(area(along, rest))];
            let mut is_found = true;
            for (at, step) in at.iter_mut().zip(step) {
                *at = clamped(*at + step);
                // The next step is about the square of this one.
                is_found &= *at + step.times(step) == *at;
            }
            if is_found {
                break;
            }
        }
        at
    }
}

/// Returns the number, or 0 or 1 where it is beyond.
#[inline]
pub(super) fn clamped<U: Unit>(number: U) -> U {
    if number < U::ZERO {
        U::ZERO
    } else if number > U::ONE {
        U::ONE
    } else {
        number
    }
}

/// A place or a way in a ground plan.
type Plan<S> = [S; 2];

/// Returns the way from `b` to `a`.
#[inline]
fn minus<S: Scalar>([ax, ay]: Plan<S>, [bx, by]: Plan<S>) -> Plan<S> {
    [ax - bx, ay - by]
}

/// Returns the place `part` (0 to 1) of the way from `a` to `b`.
#[inline]
fn flat_between<S: Scalar>([ax, ay]: Plan<S>, [bx, by]: Plan<S>, part: S::Unit) -> Plan<S> {
    [ax + (bx - ax).scale(part), ay + (by - ay).scale(part)]
}

/// The ground plan along the axis that is nearest to a normal.
struct Flat<S: Scalar> {
    is_x: bool,
    is_z: bool,
    scalar: PhantomData<S>,
}

impl<S: Scalar> Flat<S> {
    #[inline]
    fn along(normal: UnitVec3<S>) -> Self {
        let size = |c: S::Unit| if c < S::Unit::ZERO { -c } else { c };
        let (x, y, z) = (size(normal.x()), size(normal.y()), size(normal.z()));
        let is_x = x >= y && x >= z;
        Self { is_x, is_z: !is_x && z >= y, scalar: PhantomData }
    }

    #[inline]
    fn plan(&self, v: Vec3<S>) -> Plan<S> {
        [if self.is_x { v.y() } else { v.x() }, if self.is_z { v.y() } else { v.z() }]
    }
}

/// Returns the signed area of the parallelogram of two vectors.
#[inline]
fn area<S: Scalar>([ax, ay]: Plan<S>, [bx, by]: Plan<S>) -> S::Wide {
    ax.product(by) - ay.product(bx)
}

/// Returns in which of `count` equal parts of the range from 0 to 1 a number lies. What is on the border belongs to the higher part.
#[inline]
#[allow(clippy::cast_possible_truncation, reason = "below the count")]
pub(super) fn cell<U: Unit>(number: U, count: u16) -> u16 {
    let (mantissa, exponent) = clamped(number).size().parts();
    let product = u64::from(mantissa) * u64::from(count);
    let whole = product.checked_shr(exponent.min(0).unsigned_abs()).unwrap_or(0);
    (whole.min(u64::from(count.saturating_sub(1)))) as u16
}
