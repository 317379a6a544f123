//! Numbers of a description as those of a format, or an error that names the thing.

use rta_core::color::Rgb;
use rta_core::scalar::Exponent;
use rta_core::vector::{Vec3, Vector};

use super::{Narrow, NarrowError};

/// What an error says of the thing that is being narrowed.
#[derive(Clone, Copy)]
pub(super) struct Checker<S> {
    kind: &'static str,
    /// Its number in its list, from 0, and the line where it begins; 0 if it has none.
    place: Option<(usize, u32)>,
    format: core::marker::PhantomData<S>,
}

impl<S: Narrow> Checker<S> {
    pub(super) const fn new(kind: &'static str, index: usize, line: u32) -> Self {
        Self { kind, place: Some((index, line)), format: core::marker::PhantomData }
    }

    pub(super) const fn named(kind: &'static str) -> Self {
        Self { kind, place: None, format: core::marker::PhantomData }
    }

    pub(super) fn error(&self, quantity: &'static str, value: f64, limit: f64) -> NarrowError {
        // Only now, as there may be a million things without an error.
        let object = match self.place {
            None => self.kind.to_owned(),
            Some((index, 0)) => format!("{} {}", self.kind, index + 1),
            Some((index, line)) => format!("{} {} (line {line})", self.kind, index + 1),
        };
        NarrowError { object, quantity, value, limit, format: S::NAME }
    }

    pub(super) fn at_most(&self, quantity: &'static str, value: f64, limit: f64) -> Result<f64, NarrowError> {
        if value.abs() <= limit { Ok(value) } else { Err(self.error(quantity, value, limit)) }
    }

    /// A place of something that reaches `radius` about it.
    pub(super) fn place(&self, place: [f64; 3], radius: f64) -> Result<Vec3<S>, NarrowError> {
        self.at_most("the radius", radius, S::largest())?;
        let names = ["x (with the radius)", "y (with the radius)", "z (with the radius)"];
        let bare = ["x", "y", "z"];
        for (axis, &c) in place.iter().enumerate() {
            let quantity = if radius > 0.0 { names.get(axis) } else { bare.get(axis) };
            self.at_most(quantity.copied().unwrap_or("position"), c.abs() + radius, S::largest())?;
        }
        let [x, y, z] = place.map(S::length);
        Ok(Vector::new(x, y, z))
    }

    pub(super) fn radius(&self, radius: f64) -> Result<S, NarrowError> {
        if radius < S::SMALLEST_RADIUS {
            return Err(self.error("the radius", radius, S::SMALLEST_RADIUS));
        }
        self.at_most("the radius", radius, S::largest()).map(S::length)
    }

    /// The side of a tile. It is at least as large as a radius: what is smaller is a grey at any distance.
    pub(super) fn side(&self, side: f64) -> Result<S, NarrowError> {
        if side < S::SMALLEST_RADIUS {
            return Err(self.error("the side of a tile", side, S::SMALLEST_RADIUS));
        }
        self.at_most("the side of a tile", side, S::largest()).map(S::length)
    }

    pub(super) fn color(&self, quantity: &'static str, color: [f64; 3]) -> Result<Rgb<S::Unit>, NarrowError> {
        for register in color {
            self.at_most(quantity, register, S::LARGEST_COLOR)?;
        }
        let [r, g, b] = color.map(S::unit);
        Ok(Rgb::new(r, g, b))
    }

    pub(super) fn light(&self, color: [f64; 3]) -> Result<Rgb<S::Light>, NarrowError> {
        for register in color {
            self.at_most("a register", register, S::LARGEST_LIGHT)?;
        }
        let [r, g, b] = color.map(S::light);
        Ok(Rgb::new(r, g, b))
    }
}

/// Returns the nearest exponent of a highlight, with as many places as there is room for. What is sharper than the sharpest is a
/// point in every format.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // below 2^27
pub fn exponent(value: f64) -> Exponent {
    let mantissa = |places: u32| (value * f64::from(1u32 << places)).round();
    let places = (0..32).rev().find(|&places| mantissa(places) < f64::from(1u32 << 27));
    Exponent::new(mantissa(places.unwrap_or(0)) as u32, places.unwrap_or(0))
}
