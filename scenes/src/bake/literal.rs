//! Numbers as Rust expressions that are constant and exact to the bit.

use rta_core::color::Rgb;
use rta_core::scalar::{Magnitude, Scalar};
use rta_core::vector::{UnitVec3, Vec3, Vector};
use rta_core::{Q16, Q20};

use crate::shading::Shade;

/// A number format whose numbers can be written as expressions. They use the names that
/// a baked module defines: `length`, `unit`, `light`.
pub(super) trait Literal: Shade {
    /// The path of the type.
    const PATH: &'static str;
    /// Definitions of the constant functions `length`, `unit` and `light`, from bits.
    const CONSTRUCTORS: &'static str;
    /// The bits of a length.
    fn length_bits(self) -> String;
    /// The bits of a component or coefficient.
    fn unit_bits(unit: Self::Unit) -> String;
    /// The bits of a radiance.
    fn light_bits(light: Self::Light) -> String;
    /// An intensity.
    fn power_literal(power: Self::Power) -> String;
    /// A reciprocal.
    fn inverse_literal(inverse: Self::Inverse) -> String;
}

macro_rules! fixed_point {
    ($f:ty, $path:literal) => {
        impl Literal for $f {
            const PATH: &'static str = $path;
            const CONSTRUCTORS: &'static str = "    const fn length(bits: i32) -> Number {
        Number::from_bits(bits)
    }
    const fn unit(bits: i32) -> Unit {
        Unit::from_bits(bits)
    }
    const fn light(bits: i32) -> Light {
        ::rta_core::scalar::Radiance(::rta_core::Q16::from_bits(bits))
    }
";
            fn length_bits(self) -> String {
                self.to_bits().to_string()
            }
            fn unit_bits(unit: Self::Unit) -> String {
                unit.to_bits().to_string()
            }
            fn light_bits(light: Self::Light) -> String {
                light.0.to_bits().to_string()
            }
            fn power_literal(power: Magnitude) -> String {
                let (mantissa, exponent) = power.parts();
                format!("::rta_core::scalar::Magnitude::new({mantissa}, {exponent})")
            }
            fn inverse_literal(inverse: <Self as Scalar>::Inverse) -> String {
                let (mantissa, exponent) = inverse.parts();
                format!("::rta_core::scalar::integer::Reciprocal::from_parts({mantissa}, {exponent})")
            }
        }
    };
}

fixed_point!(Q16, "::rta_core::Q16");
fixed_point!(Q20, "::rta_core::Q20");

macro_rules! float {
    ($f:ty, $path:literal, $bits:literal) => {
        impl Literal for $f {
            const PATH: &'static str = $path;
            const CONSTRUCTORS: &'static str = concat!(
                "    const fn length(bits: ",
                $bits,
                ") -> Number {\n        Number::from_bits(bits)\n    }\n",
                "    use {length as unit, length as light};\n"
            );
            fn length_bits(self) -> String {
                format!("{:#x}", self.to_bits())
            }
            fn unit_bits(unit: $f) -> String {
                unit.length_bits()
            }
            fn light_bits(light: $f) -> String {
                light.length_bits()
            }
            fn power_literal(power: $f) -> String {
                format!("length({})", power.length_bits())
            }
            fn inverse_literal(inverse: $f) -> String {
                format!("length({})", inverse.length_bits())
            }
        }
    };
}

float!(f32, "f32", "u32");
float!(f64, "f64", "u64");

pub(super) fn length<S: Literal>(length: S) -> String {
    format!("length({})", length.length_bits())
}

pub(super) fn unit<S: Literal>(unit: S::Unit) -> String {
    format!("unit({})", S::unit_bits(unit))
}

pub(super) fn place<S: Literal>(v: Vec3<S>) -> String {
    format!("Place::new({}, {}, {})", length(v.x()), length(v.y()), length(v.z()))
}

pub(super) fn direction<S: Literal>(v: UnitVec3<S>) -> String {
    format!("Direction::new({}, {}, {})", unit::<S>(v.x()), unit::<S>(v.y()), unit::<S>(v.z()))
}

pub(super) fn color<S: Literal>(c: Rgb<S::Unit>) -> String {
    format!("Rgb::new({}, {}, {})", unit::<S>(c.r), unit::<S>(c.g), unit::<S>(c.b))
}

pub(super) fn light<S: Literal>(c: Rgb<S::Light>) -> String {
    let bits = |light| format!("light({})", S::light_bits(light));
    format!("Rgb::new({}, {}, {})", bits(c.r), bits(c.g), bits(c.b))
}
