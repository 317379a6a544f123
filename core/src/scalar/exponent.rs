//! The exponent of a highlight.

/// The most bits of a mantissa.
const BITS: u32 = 27;

/// The exponent of a highlight, a real number from 0 to below 2^27: up to 27 bits, with up to 31 of them behind the point. It is in one
/// word, as each surface has one. A power of it is off by no more than 3e-9 for its rounding, however large it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Exponent(u32);

impl Exponent {
    /// Returns `mantissa / 2^places`, for a mantissa below 2^27 and up to 31 places; a larger one of either is cut to these.
    pub const fn new(mantissa: u32, places: u32) -> Self {
        let most = (1 << BITS) - 1;
        let mut mantissa = if mantissa > most { most } else { mantissa };
        let mut places = if places > 31 { 31 } else { places };
        // One number has one form.
        while places > 0 && mantissa.is_multiple_of(2) {
            mantissa /= 2;
            places -= 1;
        }
        Self(places << BITS | mantissa)
    }

    /// Returns the mantissa and the number of places behind the point, as [`Exponent::new`] takes them.
    pub const fn parts(self) -> (u32, u32) {
        (self.0 & ((1 << BITS) - 1), self.0 >> BITS)
    }

    /// Returns the whole part, and the rest in units of 2^-32.
    pub const fn split(self) -> (u32, u32) {
        let (mantissa, places) = self.parts();
        let rest = if places > 0 { mantissa << (32 - places) } else { 0 };
        (mantissa >> places, rest)
    }
}

impl From<u16> for Exponent {
    fn from(whole: u16) -> Self {
        Self::new(whole.into(), 0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponents_are_split() {
        assert_eq!(Exponent::new(7, 1).split(), (3, 1 << 31));
        assert_eq!(Exponent::new(50, 0).split(), (50, 0));
        assert_eq!(Exponent::new(1, 31).split(), (0, 2));
        assert_eq!(Exponent::new(100, 1), Exponent::from(50));
        assert_eq!(Exponent::new(0, 9), Exponent::from(0));
        assert_eq!(Exponent::new(u32::MAX, 0).split(), ((1 << 27) - 1, 0));
    }
}
