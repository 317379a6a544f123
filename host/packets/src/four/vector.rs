//! Four vectors or numbers side by side, with the arithmetic of `f32` and its vectors, in their order: each of the four comes
//! out the same, to the last bit.

use core::ops::{Add, Neg, Sub};

use glam::{BVec4A, Vec3, Vec4};

/// Four vectors: x, y and z.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Vec3x4(pub(crate) [Vec4; 3]);

impl Vec3x4 {
    /// Nothing.
    pub(crate) const ZERO: Self = Self([Vec4::ZERO; 3]);

    #[inline(always)]
    pub(crate) fn new([a, b, c, d]: [Vec3; 4]) -> Self {
        Self([Vec4::new(a.x, b.x, c.x, d.x), Vec4::new(a.y, b.y, c.y, d.y), Vec4::new(a.z, b.z, c.z, d.z)])
    }

    /// One four times.
    #[inline(always)]
    pub(crate) fn splat(v: Vec3) -> Self {
        Self([Vec4::splat(v.x), Vec4::splat(v.y), Vec4::splat(v.z)])
    }

    /// One of them.
    #[inline(always)]
    pub(crate) fn lane(&self, k: usize) -> Vec3 {
        let [x, y, z] = &self.0;
        Vec3::new(lane(x, k), lane(y, k), lane(z, k))
    }

    /// Changes one of them.
    #[inline(always)]
    pub(crate) fn set(&mut self, k: usize, v: Vec3) {
        for (four, number) in self.0.iter_mut().zip(v.to_array()) {
            set(four, k, number);
        }
    }

    #[inline(always)]
    pub(crate) fn select(mask: BVec4A, yes: Self, no: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (yes.0, no.0);
        Self([Vec4::select(mask, a, x), Vec4::select(mask, b, y), Vec4::select(mask, c, z)])
    }

    #[inline(always)]
    pub(crate) fn dot(self, other: Self) -> Vec4 {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        a * x + b * y + c * z
    }

    #[inline(always)]
    pub(crate) fn cross(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([b * z - y * c, c * x - z * a, a * y - x * b])
    }

    #[inline(always)]
    pub(crate) fn scale(self, factor: Vec4) -> Self {
        Self(self.0.map(|four| four * factor))
    }

    /// `self + factor * other`.
    #[inline(always)]
    pub(crate) fn plus(self, other: Self, factor: Vec4) -> Self {
        self + other.scale(factor)
    }

    /// The largest size of a component of each.
    #[inline(always)]
    pub(crate) fn largest(self) -> Vec4 {
        let [x, y, z] = self.0.map(Vec4::abs);
        x.max(y.max(z))
    }
}

impl Add for Vec3x4 {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([a + x, b + y, c + z])
    }
}

impl Sub for Vec3x4 {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([a - x, b - y, c - z])
    }
}

impl Neg for Vec3x4 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(self.0.map(|four| -four))
    }
}

/// One of four numbers; of `k`, the last two bits count.
#[inline(always)]
pub(crate) fn lane(four: &Vec4, k: usize) -> f32 {
    one(four.as_ref(), k)
}

/// One of four numbers, four times.
#[inline(always)]
pub(crate) fn pick(four: Vec4, k: usize) -> Vec4 {
    Vec4::splat(lane(&four, k))
}

/// Changes one of four numbers.
#[inline(always)]
pub(crate) fn set(four: &mut Vec4, k: usize, number: f32) {
    *one_mut(four.as_mut(), k) = number;
}

/// Returns a reference to element `k` of four; only the last two bits of `k` count.
#[inline(always)]
#[allow(clippy::indexing_slicing, reason = "the index is below 4")]
pub(crate) fn one_ref<T>(four: &[T; 4], k: usize) -> &T {
    &four[k & 3]
}

/// Returns a copy of element `k` of four; only the last two bits of `k` count.
#[inline(always)]
pub(crate) fn one<T: Copy>(four: &[T; 4], k: usize) -> T {
    *one_ref(four, k)
}

/// Returns a mutable reference to element `k` of four; only the last two bits of `k` count.
#[inline(always)]
#[allow(clippy::indexing_slicing, reason = "the index is below 4")]
pub(crate) fn one_mut<T>(four: &mut [T; 4], k: usize) -> &mut T {
    &mut four[k & 3]
}

/// Four answers by their bits, the lowest of the first.
#[inline(always)]
pub(crate) fn mask(bits: u32) -> BVec4A {
    #[allow(clippy::indexing_slicing, reason = "the index is below the length")]
    const ALL: [BVec4A; 16] = {
        let mut all = [BVec4A::FALSE; 16];
        let mut bits = 0;
        while bits < 16 {
            all[bits] = BVec4A::new(bits & 1 != 0, bits & 2 != 0, bits & 4 != 0, bits & 8 != 0);
            bits += 1;
        }
        all
    };
    ALL.get(bits as usize & 15).copied().unwrap_or(BVec4A::FALSE)
}
