//! The fixed-point operations against `f64`, on operands that both formats hold exactly, over their whole ranges.
#![allow(clippy::float_arithmetic)]

use fastrand::Rng;
use rta_core::scalar::{Exponent, Light, Radiance, Unit};
use rta_core::vector::{LengthVector, UnitVector, Xyz};
use rta_core::{Q16, Q20, Scalar};
use rta_scenes::narrow::Narrow;

type Component = <Q16 as Scalar>::Unit;

const UNIT_LSB: f64 = 1.0 / (1u64 << 30) as f64;

/// Returns a random number whose logarithm is uniform between those of `low` and `high`.
fn spread(dice: &mut Rng, low: f64, high: f64) -> f64 {
    low * (high / low).powf(dice.f64())
}

fn direction(dice: &mut Rng) -> Xyz<Component> {
    loop {
        let v = [0, 1, 2].map(|_| dice.f64() * 2.0 - 1.0);
        let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
        if (0.01..1.0).contains(&length) {
            let [x, y, z] = v.map(|c| Q16::unit(c / length));
            return Xyz::new(x, y, z);
        }
    }
}

fn floats<T: Into<f64>>(v: Xyz<T>) -> [f64; 3] {
    [v.x.into(), v.y.into(), v.z.into()]
}

#[test]
fn attenuation_spans_ten_decades() {
    let mut dice = Rng::with_seed(1);
    for _ in 0..200_000 {
        let (power, distance) = (spread(&mut dice, 1e-4, 1e6), spread(&mut dice, 0.01, 1000.0));
        let length = Q16::length(distance);
        let exact = power / length.to_num::<f64>().powi(2);
        let light: Radiance = Q16::fall_off(<Q16 as Narrow>::power(power), length.inverse());
        let got: f64 = light.0.to_num();
        if exact >= 32768.0 {
            assert_eq!(light.0, Q16::MAX, "{power} at {distance} saturates");
        } else {
            assert!(
                (got - exact).abs() <= 1.0 / 65536.0 + exact * 1e-8,
                "{power} at {distance}: {got}, not {exact}"
            );
        }
    }
}

#[test]
fn normalised_vectors_have_length_one_whatever_their_size() {
    let mut dice = Rng::with_seed(2);
    for _ in 0..200_000 {
        let size = spread(&mut dice, 1e-3, 16000.0);
        let v = direction(&mut dice).map(|c| Q16::length(c.to_num::<f64>() * size));
        let Some((unit, length, _)) = v.normalize() else { continue };
        let exact = floats(v).iter().map(|c| c * c).sum::<f64>().sqrt();
        assert!(
            (length.to_num::<f64>() - exact).abs()
                <= (0.5 + 3.0 * exact * UNIT_LSB * 65536.0) / 65536.0 + 1e-12,
            "{exact}"
        );
        for (got, want) in floats(unit).iter().zip(floats(v)) {
            assert!((got - want / exact).abs() <= 2.5 * UNIT_LSB, "{got}, not {}", want / exact);
        }
    }
}

#[test]
fn short_unit_vectors_are_normalised_to_full_precision() {
    let mut dice = Rng::with_seed(3);
    for _ in 0..100_000 {
        let size = spread(&mut dice, 1e-8, 1.7);
        let v = direction(&mut dice).map(|c| Q16::unit(c.to_num::<f64>() * size));
        let Some((unit, inverse)) = UnitVector::normalize(v) else { continue };
        let exact = floats(v).iter().map(|c| c * c).sum::<f64>().sqrt();
        for (got, want) in floats(unit).iter().zip(floats(v)) {
            assert!((got - want / exact).abs() <= 2.5 * UNIT_LSB, "{got}, not {}", want / exact);
        }
        // The reciprocal, by dividing the length by itself.
        let one: f64 = Q16::unit(exact).over(inverse).to_num();
        assert!((one - 1.0).abs() <= 4.0 * UNIT_LSB + 0.6 * UNIT_LSB / exact, "{exact} over itself is {one}");
    }
}

#[test]
fn real_powers_are_as_exact_as_whole_ones() {
    let mut dice = Rng::with_seed(14);
    let mut worst = [0.0_f64; 3];
    for _ in 0..100_000 {
        // Down to 2^-30, where a root is much larger than what it is the root of.
        let base = Q16::unit(spread(&mut dice, 1e-9, 1.0));
        let (mantissa, places) = (dice.u32(0..1 << 27), dice.u32(16..32));
        let exponent = f64::from(mantissa) / f64::from(1u32 << places);
        let (got, in_f32, in_f64) = (
            Unit::power(base, Exponent::new(mantissa, places)).to_num::<f64>(),
            Unit::power(base.to_num::<f32>(), Exponent::new(mantissa, places)),
            Unit::power(base.to_num::<f64>(), Exponent::new(mantissa, places)),
        );
        let exact = base.to_num::<f64>().powf(exponent);
        let off = (got - exact).abs() / (1.5 * exponent + 16.0) / UNIT_LSB;
        let single = f64::from(base.to_num::<f32>()).powf(exponent);
        let off_single = (f64::from(in_f32) - single).abs() / (exponent + 4.0) / f64::from(f32::EPSILON);
        let off_double = (in_f64 - exact).abs() / (exponent + 4.0) / f64::EPSILON;
        worst = [worst[0].max(off), worst[1].max(off_single), worst[2].max(off_double)];
        assert!(worst.iter().all(|&off| off <= 1.0), "{base}^{exponent}: {worst:?}");
    }
    for exponent in [Exponent::new(7, 1), Exponent::new(1, 31), Exponent::new(50, 0)] {
        let powers = [1.0, 0.0].map(|base| Unit::power(Q16::unit(base), exponent).to_num::<f64>());
        assert_eq!(powers, [1.0, 0.0], "{exponent:?}");
    }
}

#[test]
fn powers_by_squaring_stay_within_an_lsb_for_each_product() {
    let mut dice = Rng::with_seed(4);
    for _ in 0..100_000 {
        let (base, exponent) = (Q16::unit(dice.f64()), dice.u32(0..400));
        let exact = base.to_num::<f64>().powi(exponent.cast_signed());
        let error = (Unit::power(base, Exponent::new(exponent, 0)).to_num::<f64>() - exact).abs() / UNIT_LSB;
        // Each squaring doubles the relative error and adds half an LSB: 1.5 for each unit of the exponent at worst.
        assert!(error <= 1.5 * f64::from(exponent.max(1)), "{base}^{exponent} is {error} LSB off");
    }
}

#[test]
fn glints_and_weights_saturate_and_never_wrap() {
    assert_eq!(Q16::intensity(<Q16 as Scalar>::power(u32::MAX, 40)).0, Q16::MAX);
    assert_eq!(Q16::fall_off(<Q16 as Scalar>::power(u32::MAX, 400), Q16::length(0.01).inverse()).0, Q16::MAX);
    assert_eq!(Q16::fall_off(<Q16 as Scalar>::power(1, -400), Q16::length(1000.0).inverse()).0, Q16::ZERO);
    assert_eq!(Radiance(Q16::MAX).plus(Radiance(Q16::MAX)).0, Q16::MAX);
    assert_eq!(Light::times(Radiance(Q16::MAX), Component::MAX).0, Q16::MAX);
    assert_eq!(Light::times(Radiance(Q16::ONE), -Component::DELTA).0, Q16::ZERO);
    assert_eq!(Radiance(Q16::MAX).level(255), 255);
}

#[test]
fn tiles_far_beyond_the_format_are_those_of_exact_arithmetic() {
    fn check<S: Narrow>(dice: &mut Rng) {
        let origin = S::length(dice.f64() * 40.0 - 20.0);
        let height = S::length(spread(dice, 0.1, 50.0));
        let (fall, slope) = (S::unit(spread(dice, 1e-6, 0.1)), S::unit(dice.f64() * 2.0 - 1.0));
        let tile = Some(S::length(spread(dice, 0.01, 100.0))).filter(|_| dice.bool());
        let side = tile.map_or(3.0, S::to_f64);
        let exact = |origin: f64, slope: f64, height: f64, fall: f64| (origin + slope * height / fall) / side;
        let place = exact(origin.to_f64(), S::unit_to_f64(slope), height.to_f64(), S::unit_to_f64(fall));
        // Rounding is relative to the way: 2^-29 of it and half an LSB.
        let margin = place.abs() * 4e-9 + 3e-4 / side;
        if (place - place.round()).abs() > margin {
            let odd = place.floor().rem_euclid(2.0) == 1.0;
            assert_eq!(origin.odd_far_tile(slope, height, fall, tile), odd, "{place} tiles away");
        }
    }
    let mut dice = Rng::with_seed(5);
    for _ in 0..100_000 {
        check::<Q16>(&mut dice);
        check::<Q20>(&mut dice);
    }
}
