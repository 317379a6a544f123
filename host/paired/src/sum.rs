//! Sums of light of both twins.

use rta_core::scalar::{Light, Summed};

use crate::{Paired, UnitFormat, Value};

impl<L: Light<Unit: UnitFormat> + Value> Summed for Paired<L> {
    type Weight = Paired<L::Unit>;
    type Sum = (L::Sum, f64);
    const EMPTY: Self::Sum = (L::EMPTY, 0.0);
    fn added(self, (format, twin): Self::Sum, weight: Self::Weight) -> Self::Sum {
        (self.format.added(format, weight.format), self.twin.added(twin, weight.twin))
    }
    fn mean(sum: Self::Sum, whole: Self::Sum, factor: Self::Weight) -> Self {
        let twin = <f64 as Summed>::mean(sum.1, whole.1, factor.twin);
        Paired { format: L::mean(sum.0, whole.0, factor.format), twin }
    }
}
