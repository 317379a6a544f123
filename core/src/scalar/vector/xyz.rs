//! The vectors of scalars that have no vectors of their own: three components side by side.

use core::ops::{Add, Neg, Sub};

use super::Vector;
use crate::scalar::Number;

/// The vector of scalars that are not floats.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Xyz<T> {
    /// East.
    pub x: T,
    /// North.
    pub y: T,
    /// Up.
    pub z: T,
}

impl<T> Xyz<T> {
    /// Returns a vector from its components.
    pub const fn new(x: T, y: T, z: T) -> Self {
        Self { x, y, z }
    }

    /// Applies `f` to each component.
    pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> Xyz<U> {
        Xyz { x: f(self.x), y: f(self.y), z: f(self.z) }
    }

    /// Applies `f` to each pair of components.
    pub fn zip<U, V>(self, other: Xyz<U>, mut f: impl FnMut(T, U) -> V) -> Xyz<V> {
        Xyz { x: f(self.x, other.x), y: f(self.y, other.y), z: f(self.z, other.z) }
    }
}

impl<T: Add<Output = T>> Add for Xyz<T> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
}

impl<T: Sub<Output = T>> Sub for Xyz<T> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
}

impl<T: Neg<Output = T>> Neg for Xyz<T> {
    type Output = Self;
    fn neg(self) -> Self {
        self.map(|a| -a)
    }
}

impl<T: Number + Add<Output = T> + Sub<Output = T> + Neg<Output = T>> Vector for Xyz<T> {
    type Component = T;
    fn new(x: T, y: T, z: T) -> Self {
        Self { x, y, z }
    }
    fn x(self) -> T {
        self.x
    }
    fn y(self) -> T {
        self.y
    }
    fn z(self) -> T {
        self.z
    }
}
