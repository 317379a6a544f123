//! How much of a disc an edge or another disc covers: of a lamp, of a lens, or of the cross-section of a cone (J. Amanatides, "Ray Tracing
//! with Cones", SIGGRAPH 84).

use crate::scalar::{Positive, Unit};

/// Returns the part of a disc that lies beyond a straight line, `s` radii from its middle: `(arccos s - s sqrt(1 - s^2)) / pi`; 1 for an
/// `s` of -1 or less, 0 for 1 or more.
pub fn beyond<U: Unit>(s: U) -> U {
    if s >= U::ONE {
        return U::ZERO;
    }
    if s <= -U::ONE {
        return U::ONE;
    }
    let root = U::radical(U::ONE, U::ZERO, s).unwrap_or(U::ZERO);
    let turn = U::turn(s, root);
    turn + turn - over_pi(s.times(root))
}

/// Returns the number over pi, which is taken within 1e-16.
pub(super) fn over_pi<U: Unit>(number: U) -> U {
    number.times(U::ratio(78_256_779, 245_850_922))
}

/// Returns the part of a disc of the radius `own` that another of the radius `other` covers, whose middle is `apart` away; all three of one
/// unit, radii above 0.
///
/// Where the other is so much larger that its edge is straight as far as the format can tell, it is taken as straight.
pub fn covered<U: Unit>(own: U, other: U, apart: U) -> U {
    let (zero, one, half) = (U::ZERO, U::ONE, U::ratio(1, 2));
    let larger = if own < other { other } else { own };
    let largest = if apart < larger { larger } else { apart };
    // As parts of twice the largest, so that all sums and squares have room.
    let [own, other, apart] = [own, other, apart].map(|length| length.quotient(largest).times(half));
    let ratio = other.positive().over(own.positive());
    let ratio = ratio.times(ratio);
    if apart >= own + other {
        return zero;
    }
    if apart + own <= other {
        return one;
    }
    if apart + other <= own {
        return ratio.unit();
    }
    // How far the chord that both have in common is from a middle, as a part of that disc's radius.
    let chord = |own: U, other: U| {
        let reach = (apart.times(apart) + own.times(own) - other.times(other)).times(half);
        let size = if reach < zero { -reach } else { reach };
        let part = size.positive().over(apart.times(own).positive()).unit();
        if reach < zero { -part } else { part }
    };
    if ratio.times(U::ROUNDING.positive()).unit() > U::ratio(1, 1 << 13) {
        let part = (apart - other).quotient(own);
        return beyond(part);
    }
    let of_other = beyond(chord(other, own)).positive().times(ratio);
    let part = beyond(chord(own, other)).positive().plus(of_other).unit();
    if part > one { one } else { part }
}

#[cfg(test)]
#[cfg(feature = "f64")]
mod tests {
    use super::{beyond, covered};
    use crate::{Q16, Scalar};

    type Fixed = <Q16 as Scalar>::Unit;

    #[test]
    fn parts_of_discs() {
        for (s, part) in
            [(-1.5f64, 1.0f64), (0.0, 0.5), (0.5, 0.195_501_109), (0.6, 0.142_378_490), (1.0, 0.0)]
        {
            assert!((beyond(s) - part).abs() < 1e-8, "{s}");
            let fixed: f64 = beyond(Fixed::from_num(s)).to_num();
            assert!((fixed - part).abs() < 2e-7, "{s}: {fixed}");
        }
    }

    #[test]
    fn discs_on_discs() {
        let lens = 2.0 / 3.0 - 3f64.sqrt() / core::f64::consts::TAU;
        let cases = [
            (0.1, 0.2, 0.15, 0.761_572_276),
            (0.05, 0.05, 0.05, lens),
            (0.5, 0.5, 1.0, 0.0),
            (1.0, 1.0, 1.0, lens),
            (1.9, 1.9, 1.9, lens),
            (0.1, 0.9, 0.2, 1.0),
            (0.5, 0.25, 0.1, 0.25),
            (0.5, 0.25, 0.0, 0.25),
        ];
        for (own, other, apart, part) in cases {
            let exact = covered(own, other, apart);
            assert!((exact - part).abs() < 1e-8, "{own} {other} {apart}: {exact}");
            let [a, b, c] = [own, other, apart].map(Fixed::from_num);
            let fixed: f64 = covered(a, b, c).to_num();
            assert!((fixed - part).abs() < 2e-6, "{own} {other} {apart}: {fixed}");
        }
        // A straight edge to the eye of fixed point.
        let [a, b, c] = [0.001, 1.0, 1.0005].map(Fixed::from_num);
        let straight: f64 = covered(a, b, c).to_num();
        assert!((straight - covered(0.001, 1.0, 1.0005)).abs() < 1e-3, "{straight}");
    }
}
