//! Boxes with sides along the axes.

use crate::description::Sphere;

/// A box.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    pub(super) low: [f64; 3],
    pub(super) high: [f64; 3],
}

impl Bounds {
    /// The box of nothing.
    pub(super) const NONE: Self = Self { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3] };

    /// What lies up to `reach` about a place.
    pub(super) fn about(place: [f64; 3], reach: [f64; 3]) -> Self {
        let mut bounds = Self { low: place, high: place };
        for ((low, high), reach) in bounds.low.iter_mut().zip(&mut bounds.high).zip(reach) {
            *low -= reach;
            *high += reach;
        }
        bounds
    }

    /// The box of both.
    pub(super) fn with(mut self, other: &Self) -> Self {
        // Comparisons that are one instruction, as no coordinate is anything but a number.
        for (low, other) in self.low.iter_mut().zip(other.low) {
            *low = if other < *low { other } else { *low };
        }
        for (high, other) in self.high.iter_mut().zip(other.high) {
            *high = if other > *high { other } else { *high };
        }
        self
    }

    pub(super) fn with_sphere(self, sphere: &Sphere) -> Self {
        self.with(&Self::about(sphere.position, [sphere.radius; 3]))
    }

    pub(super) fn center(&self) -> [f64; 3] {
        let mut center = self.low;
        for (c, high) in center.iter_mut().zip(self.high) {
            *c = f64::midpoint(*c, high);
        }
        center
    }

    fn sides(&self) -> [f64; 3] {
        let mut sides = self.high;
        for (side, low) in sides.iter_mut().zip(self.low) {
            *side = (*side - low).max(0.0);
        }
        sides
    }

    /// The square of half the diagonal, which the surface of a sphere about the box goes with.
    pub(super) fn diagonal(&self) -> f64 {
        self.sides().iter().map(|side| side * side).sum::<f64>() / 4.0
    }

    /// Half the surface: how likely a ray is to meet it.
    pub(super) fn surface(&self) -> f64 {
        let [x, y, z] = self.sides();
        x * y + y * z + z * x
    }

    /// The longest side: 0 is x.
    pub(super) fn longest(&self) -> usize {
        let [x, y, z] = self.sides();
        if x >= y && x >= z {
            0
        } else if y >= z {
            1
        } else {
            2
        }
    }

    /// The largest size of a coordinate.
    pub(super) fn largest(&self) -> f64 {
        self.low.iter().chain(&self.high).fold(0.0, |most, c| most.max(c.abs()))
    }
}
