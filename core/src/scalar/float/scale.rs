//! Powers of two.

macro_rules! scale {
    ($name:ident, $f:ty, $int:ident, $ldexp:path) => {
        /// Returns `value * 2^exponent`, for a value of 0, or of 1 or more, as `ldexp` does. Of constants it is one, but on small machines,
        /// where a call is shorter.
        #[cfg_attr(not(target_os = "none"), inline)]
        pub(super) fn $name(value: $f, exponent: i32) -> $f {
            if cfg!(target_os = "none") || !(<$f>::MIN_EXP..<$f>::MAX_EXP).contains(&exponent) {
                return $ldexp(value, exponent);
            }
            let bits = $int::from(exponent) << (<$f>::MANTISSA_DIGITS - 1);
            value * <$f>::from_bits(<$f>::to_bits(1.0).wrapping_add_signed(bits))
        }
    };
}

scale!(single, f32, i32, libm::ldexpf);
#[cfg(feature = "f64")]
scale!(double, f64, i64, libm::ldexp);

#[cfg(test)]
mod tests {
    #[test]
    fn numbers_are_scaled_as_by_libm() {
        for value in [0u64, 1, 3, 0xc90f_daa2, u64::MAX] {
            for exponent in [-200, -149, -126, -125, -62, -1, 0, 1, 30, 126, 127, 128, 300] {
                let value = value as f32;
                assert_eq!(super::single(value, exponent).to_bits(), libm::ldexpf(value, exponent).to_bits());
                #[cfg(feature = "f64")]
                for exponent in [exponent, -1100, -1022, -1021, 1023, 1024] {
                    let value = f64::from(value);
                    let scaled = super::double(value, exponent);
                    assert_eq!(scaled.to_bits(), libm::ldexp(value, exponent).to_bits());
                }
            }
        }
    }
}
