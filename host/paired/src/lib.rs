//! Numbers that carry their own precise twin: the format under test beside `f64`, in lock step.
//!
//! [`Paired<S>`] is a [`Scalar`](rta_core::Scalar) like any other, so the tracer runs in it unchanged. Every operation
//! is done twice, by the format's own arithmetic and by that of `f64`; every decision is taken by the format. What the
//! operations lost, and which decisions `f64` would have taken differently, goes into a [`log`].
//!
//! That tells *where* a picture goes wrong. *Whether* a pixel took the same branches as in `f64` is told by its
//! [`ray_tree`] in each of the two number formats on its own.
//!
//! [`trail::lock_step`] traces a pixel so. It is the one thing that is compiled here for all formats, without optimisation: its code is
//! large, and one pixel is quickly traced.
//!
//! ```
//! use rta_paired::{Paired, log};
//! use rta_core::Q16;
//! use rta_core::vector::LengthVector;
//! use rta_core::scalar::Scalar;
//! use rta_scenes::narrow::Narrow;
//!
//! let (root, log) = log::record(|| Paired::<Q16>::sqrt(Paired::<Q16>::length(2.0).square()));
//! assert!((root.twin - 2.0).abs() < 1e-15);
//! assert_eq!(log.operations.len(), 2);
//! assert!(log.flips.is_empty());
//! ```
#![forbid(unsafe_code)]

use core::cmp::Ordering;
use core::ops::{Add, Neg, Sub};

pub mod format;
pub mod log;
pub mod ray_tree;
mod recorder;
mod scalar;
mod sight;
mod sum;
pub mod trail;
mod vector;

pub use format::{Format, UnitFormat, Value};
pub use recorder::Readable;
pub use vector::PairedVector;

/// The code of the README, compiled and run with the other examples.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

/// A number of the format under test and its twin in `f64`: a length, a unit, a square or a radiance.
#[derive(Clone, Copy, Debug)]
pub struct Paired<T> {
    /// Its value in the format under test.
    pub format: T,
    /// Its value in `f64`.
    pub twin: f64,
}

/// A number that is passed on but neither compared nor measured: a reciprocal or an intensity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bare<T> {
    /// Its value in the format under test.
    pub format: T,
    /// Its value in `f64`.
    pub twin: f64,
}

impl<T: Value> Paired<T> {
    /// Returns the two values: the format's and the twin's.
    pub fn values(self) -> [f64; 2] {
        [self.format.value(), self.twin]
    }

    /// Returns the difference of the two values, in units of the format's last place.
    pub fn error(self) -> f64 {
        (self.format.value() - self.twin).abs() / T::last_place(self.twin)
    }

    /// Writes an operation with this result into the log; `operands` are the errors of its operands.
    #[track_caller]
    fn noted(self, name: &'static str, operands: impl IntoIterator<Item = f64>) -> Self {
        log::operation(name, (T::KIND, self.format.value().abs()), self.values(), self.error(), operands);
        self
    }
}

impl<T: Value> Value for Paired<T> {
    const KIND: log::Kind = T::KIND;
    fn value(self) -> f64 {
        self.format.value()
    }
    fn last_place(at: f64) -> f64 {
        T::last_place(at)
    }
}

impl<T: Value + Add<Output = T>> Add for Paired<T> {
    type Output = Self;
    #[track_caller]
    fn add(self, other: Self) -> Self {
        Self { format: self.format + other.format, twin: self.twin + other.twin }
            .noted("+", [self.error(), other.error()])
    }
}

impl<T: Value + Sub<Output = T>> Sub for Paired<T> {
    type Output = Self;
    #[track_caller]
    fn sub(self, other: Self) -> Self {
        Self { format: self.format - other.format, twin: self.twin - other.twin }
            .noted("-", [self.error(), other.error()])
    }
}

impl<T: Neg<Output = T>> Neg for Paired<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { format: -self.format, twin: -self.twin }
    }
}

impl<T: Value + PartialEq> PartialEq for Paired<T> {
    #[track_caller]
    fn eq(&self, other: &Self) -> bool {
        let (format, twin) = (self.format == other.format, self.twin == other.twin);
        log::decision("==", self.values(), other.values(), format, twin);
        format
    }
}

/// One comparison: each answers its own question, and so does its twin.
macro_rules! compare {
    ($name:ident, $sign:literal) => {
        #[track_caller]
        fn $name(&self, other: &Self) -> bool {
            let (format, twin) = (self.format.$name(&other.format), self.twin.$name(&other.twin));
            log::decision($sign, self.values(), other.values(), format, twin);
            format
        }
    };
}

impl<T: Value + PartialOrd> PartialOrd for Paired<T> {
    #[track_caller]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let (format, twin) = (self.format.partial_cmp(&other.format), self.twin.partial_cmp(&other.twin));
        log::decision("<=>", self.values(), other.values(), format, twin);
        format
    }
    compare!(lt, "<");
    compare!(le, "<=");
    compare!(gt, ">");
    compare!(ge, ">=");
}
