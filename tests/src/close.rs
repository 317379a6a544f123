//! The assertion that a number is near another.

/// Asserts that `got` is within `tolerance` of `want` on either side, all three in the unit that `unit` names. A number
/// that is not finite is near no other. Further arguments are a format string and its arguments, which name the case.
///
/// ```
/// rta_tests::assert_close!(2.0_f64.sqrt(), 1.4142, 1e-4, "of a length");
/// ```
#[macro_export]
macro_rules! assert_close {
    ($got:expr, $want:expr, $tolerance:expr, $unit:expr) => {
        $crate::assert_close!($got, $want, $tolerance, $unit, "{}", stringify!($got))
    };
    ($got:expr, $want:expr, $tolerance:expr, $unit:expr, $($case:tt)+) => {{
        let (got, want, tolerance): (f64, f64, f64) = ($got, $want, $tolerance);
        assert!(
            got.is_finite() && (got - want).abs() <= tolerance,
            "{}: got {got}, want {want} within {tolerance:e} {}",
            format_args!($($case)+),
            $unit,
        );
    }};
}
