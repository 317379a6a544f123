//! Boxes with sides along the axes.

use crate::space::{difference, length};

/// A box.
#[derive(Clone, Copy, Debug)]
pub struct Bounds {
    /// Least coordinates.
    pub low: [f64; 3],
    /// Greatest coordinates.
    pub high: [f64; 3],
}

impl Bounds {
    /// The box of nothing.
    pub const NONE: Self = Self { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3] };

    /// Returns the box of what lies up to `reach` about a place.
    #[must_use]
    #[inline] // 1 % of the instructions of a scene of thousands of objects, as each is looked at in each level of a tree
    pub fn about(place: [f64; 3], reach: [f64; 3]) -> Self {
        let mut bounds = Self { low: place, high: place };
        for ((low, high), reach) in bounds.low.iter_mut().zip(&mut bounds.high).zip(reach) {
            *low -= reach;
            *high += reach;
        }
        bounds
    }

    /// Returns the box, moved by a vector.
    #[must_use]
    pub fn moved(self, by: [f64; 3]) -> Self {
        let moved = |mut place: [f64; 3]| {
            place.iter_mut().zip(by).for_each(|(c, by)| *c += by);
            place
        };
        Self { low: moved(self.low), high: moved(self.high) }
    }

    /// Returns the box of both.
    #[must_use]
    pub fn with(mut self, other: &Self) -> Self {
        // Comparisons that are one instruction, as no coordinate is anything but a number.
        for (low, other) in self.low.iter_mut().zip(other.low) {
            *low = if other < *low { other } else { *low };
        }
        for (high, other) in self.high.iter_mut().zip(other.high) {
            *high = if other > *high { other } else { *high };
        }
        self
    }

    /// Returns the middle.
    #[must_use]
    pub fn center(&self) -> [f64; 3] {
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

    /// Returns the square of half the diagonal, which the surface of a sphere about the box goes with.
    #[must_use]
    pub fn diagonal(&self) -> f64 {
        self.sides().iter().map(|side| side * side).sum::<f64>() / 4.0
    }

    /// Returns how far the middle is from a place.
    #[must_use]
    pub fn distance(&self, from: [f64; 3]) -> f64 {
        length(difference(self.center(), from))
    }

    /// Returns half the surface: how likely a ray is to meet it.
    #[must_use]
    pub fn surface(&self) -> f64 {
        let [x, y, z] = self.sides();
        x * y + y * z + z * x
    }

    /// Returns the longest side: 0 is x.
    #[must_use]
    pub fn longest(&self) -> usize {
        let [x, y, z] = self.sides();
        if x >= y && x >= z {
            0
        } else if y >= z {
            1
        } else {
            2
        }
    }

    /// Returns the largest size of a coordinate.
    #[must_use]
    pub fn largest(&self) -> f64 {
        self.low.iter().chain(&self.high).fold(0.0, |most, c| most.max(c.abs()))
    }
}
