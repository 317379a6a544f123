//! Where a pair of numbers lies on a disc, among directions, and among the facets of a rough surface: without tables, and without
//! trigonometry but for two polynomials.

use crate::scalar::vector::{UnitVec3, UnitVector, Vector};
use crate::scalar::{Positive, Scalar, Unit};

/// Returns the sine and the cosine of `part` eighths of a turn, for a part from -1 to 1: within 2 units of 2^-30.
fn sine_cosine<U: Unit>(part: U) -> (U, U) {
    // pi/4 and reciprocals as words, each the nearest number of Q2.30: to divide takes a Cortex-M0 a thousand instructions.
    let x = part.times(U::of_word(0xc90f_daa4));
    let (one, square) = (U::ONE, x.times(x));
    let step = |rest: U, factor: u32| one - square.times(U::of_word(factor)).times(rest);
    // One over 72, 42, 20, 6; and over 90, 56, 30, 12, 2.
    let sine = [0x038e_38e4, 0x0618_6188, 0x0ccc_cccd, 0x2aaa_aaac].into_iter().fold(one, step);
    let cosine =
        [0x02d8_2d84, 0x0492_4925, 0x0888_8889, 0x1555_5555, 0x8000_0000].into_iter().fold(one, step);
    (x.times(sine), cosine)
}

/// Returns where a pair of numbers from 0 to 1 lies on the unit disc, evenly spread: P. Shirley's and K. Chiu's concentric map ("A Low
/// Distortion Map Between Disk and Square", JGT 2(3), 1997).
pub fn disc<U: Unit>([u, v]: [U; 2]) -> [U; 2] {
    let size = |c: U| if c < U::ZERO { -c } else { c };
    let [a, b] = [u + u - U::ONE, v + v - U::ONE];
    if a == U::ZERO && b == U::ZERO {
        return [a, b];
    }
    if size(a) > size(b) {
        let (sine, cosine) = sine_cosine(b.quotient(a));
        [a.times(cosine), a.times(sine)]
    } else {
        let (sine, cosine) = sine_cosine(a.quotient(b));
        [b.times(sine), b.times(cosine)]
    }
}

/// Returns cosine and sine of `word / 2^32` turns.
pub fn turn<U: Unit>(word: u32) -> [U; 2] {
    let part = U::of_word(word << 3);
    let octant = word >> 29;
    // Odd octants are counted back from their end, which is an axis or a diagonal.
    let (sine, cosine) = sine_cosine(if octant & 1 == 0 { part } else { U::ONE - part });
    match octant {
        0 => [cosine, sine],
        1 => [sine, cosine],
        2 => [-sine, cosine],
        3 => [-cosine, sine],
        4 => [-cosine, -sine],
        5 => [-sine, -cosine],
        6 => [sine, -cosine],
        _ => [cosine, -sine],
    }
}

/// Two unit vectors that stand at right angles on a unit vector and on each other.
#[derive(Clone, Copy, Debug)]
pub struct Frame<V> {
    axis: V,
    sides: [V; 2],
}

impl<V: UnitVector> Frame<V> {
    /// Returns the frame of a unit vector, from the axis along which it is shortest.
    pub fn about(axis: V) -> Self {
        let size = |c: V::Component| if c < Unit::ZERO { -c } else { c };
        let [x, y, z] = [axis.x(), axis.y(), axis.z()].map(size);
        let shortest = if x <= y && x <= z {
            V::X
        } else if y <= z {
            V::Y
        } else {
            V::Z
        };
        let first = axis.cross(shortest).normalize().map_or(shortest, |(first, _)| first);
        Self::beside(axis, first)
    }

    /// Returns the frame of a unit vector whose first side is a unit vector at right angles to it.
    pub fn beside(axis: V, first: V) -> Self {
        Self { axis, sides: [first, axis.cross(first)] }
    }

    /// Returns the vector with these components along the two sides and the axis.
    pub fn vector(&self, [x, y, z]: [V::Component; 3]) -> V {
        let [first, second] = self.sides;
        self.axis.scale(z).plus(first, x).plus(second, y)
    }

    /// Returns the components of a vector along the two sides and the axis.
    pub fn components(&self, vector: V) -> [V::Component; 3] {
        let [first, second] = self.sides;
        [vector.dot(first), vector.dot(second), vector.dot(self.axis)]
    }
}

/// Returns `sqrt(1 - x^2 - y^2)`; 0 where that is no number.
pub fn lifted<S: Scalar>([x, y]: [S::Unit; 2]) -> S::Unit {
    UnitVec3::<S>::new(x, y, Unit::ZERO).half_chord(Unit::ONE).unwrap_or(Unit::ZERO)
}

/// Returns a unit direction about a unit normal, for a pair of numbers from 0 to 1, as often as its cosine says.
pub fn hemisphere<S: Scalar>(normal: UnitVec3<S>, pair: [S::Unit; 2]) -> UnitVec3<S> {
    let [x, y] = disc(pair);
    Frame::about(normal).vector([x, y, lifted::<S>([x, y])])
}

/// The facets of a rough surface, as T. Trowbridge and K. Reitz spread their normals ("Average Irregularity Representation of a Rough
/// Surface for Ray Reflection", JOSA 65, 1975).
#[derive(Clone, Copy, Debug)]
pub struct Facets<U> {
    /// Roughness alpha: 0 is smooth, 1 the roughest.
    pub roughness: U,
}

impl<U: Unit> Facets<U> {
    /// Returns the unit normal of a facet that is seen from `view`, the unit vector towards the eye, on a surface with the unit normal
    /// `normal`: E. Heitz, "Sampling the GGX Distribution of Visible Normals", JCGT 7(4), 2018, by the spherical caps of J. Dupuy and A.
    /// Benyoub ("Sampling Visible GGX Normals with Spherical Caps", 2023). `pair` is two numbers of 32 bits behind the point.
    pub fn seen<S: Scalar<Unit = U>>(
        self,
        normal: UnitVec3<S>,
        view: UnitVec3<S>,
        [u, v]: [u32; 2],
    ) -> UnitVec3<S> {
        let (alpha, half) = (self.roughness, U::of_word(1 << 31));
        let frame = Frame::about(normal);
        let [x, y, z] = frame.components(view);
        let stretched = UnitVec3::<S>::new(alpha.times(x), alpha.times(y), z);
        let stretched = stretched.normalize().map_or(UnitVec3::<S>::Z, |(direction, _)| direction);
        // A point of the spherical cap that lies above -s_z, and s itself: both halved, so that the sum has room.
        let [cosine, sine] = turn(u);
        let v = U::of_word(v);
        let height = U::ONE - v - v.times(stretched.z());
        let across = U::radical(U::ONE, U::ZERO, height).unwrap_or(U::ZERO);
        let cap = UnitVec3::<S>::new(across.times(cosine), across.times(sine), height);
        let middle = cap.scale(half).plus(stretched, half);
        let facet = [alpha.times(middle.x()), alpha.times(middle.y()), middle.z()];
        frame.vector(facet).normalize().map_or(normal, |(facet, _)| facet)
    }

    /// Returns the part, 0 to 1, of the light of the facets seen at the cosine `view` that is not hidden on its way out at the cosine
    /// `out`, both with the surface's normal: B. Smith's G2 over G1, heights of facets correlated.
    pub fn passed(self, view: U, out: U) -> U {
        let least = U::of_word(1 << 18);
        let clamped = |cosine: U| if cosine < least { least } else { cosine };
        let (view, out) = (clamped(view), clamped(out));
        // (1 + L(view)) / (1 + L(view) + L(out)), with 2 L(w) + 1 = sqrt(c^2 + (alpha s)^2) / c.
        let root = |cosine: U| {
            U::radical(cosine, self.roughness, self.roughness.times(cosine)).unwrap_or(cosine).positive()
        };
        let (seen, left) = (root(view), root(out));
        let (view, out) = (view.positive(), out.positive());
        let part = view.plus(seen).times(out).over(seen.times(out).plus(left.times(view))).unit();
        if part > U::ONE { U::ONE } else { part }
    }
}

#[cfg(test)]
#[cfg(feature = "f64")]
mod tests {
    use super::*;
    use crate::sampling::pairs::Pairs;
    use crate::{Q16, Scalar};

    type Fixed = <Q16 as Scalar>::Unit;

    #[test]
    fn circle_in_f64_and_fixed_point() {
        for k in 0..4096u32 {
            let word = k << 20 | 0x000a_5a5a;
            let angle = f64::from(word) / 4_294_967_296.0 * core::f64::consts::TAU;
            let [cosine, sine] = turn::<f64>(word);
            assert!((cosine - libm::cos(angle)).abs() < 2e-9 && (sine - libm::sin(angle)).abs() < 2e-9);
            let [fixed_cosine, fixed_sine] = turn::<Fixed>(word);
            let unit = 1.0 / f64::from(1 << 30);
            let error =
                (fixed_cosine.to_num::<f64>() - cosine).abs().max((fixed_sine.to_num::<f64>() - sine).abs());
            assert!(error < 4.0 * unit, "{word:x}: {} units", error / unit);
        }
    }

    #[test]
    fn discs_are_filled_evenly() {
        let pairs = Pairs::new(1, 2, 1, 0);
        let (mut inner, mut moments) = (0, [0.0f64; 2]);
        for i in 0..4096 {
            let [x, y] = disc(pairs.units::<f64>(i));
            assert!(x * x + y * y <= 1.0 + 1e-9);
            inner += u32::from(x * x + y * y < 0.25);
            moments = [moments[0] + x, moments[1] + x * x];
            let fixed = disc(pairs.units::<Fixed>(i)).map(|c| c.to_num::<f64>());
            // What the pair loses of its last two bits is magnified where both numbers are near 1/2.
            assert!((fixed[0] - x).abs() < 2e-8 && (fixed[1] - y).abs() < 2e-8, "{i}: {fixed:?}, {x}, {y}");
        }
        assert!(inner.abs_diff(1024) < 12, "a quarter of the samples within half of the radius: {inner}");
        assert!(moments[0].abs() < 4.0 && (moments[1] / 4096.0 - 0.25).abs() < 1e-3);
    }

    #[test]
    fn smooth_facets_face_the_normal_and_hide_nothing() {
        let normal = UnitVec3::<f64>::new(0.6, 0.0, 0.8);
        let view = UnitVec3::<f64>::new(0.0, 0.6, 0.8);
        let facet = Facets { roughness: 0.0 }.seen::<f64>(normal, view, [0x1234_5678, 0x9abc_def0]);
        assert!((facet.dot(normal) - 1.0).abs() < 1e-12);
        assert!((Facets { roughness: 0.0f64 }.passed(0.3, 0.2) - 1.0).abs() < 1e-12);
    }
}
