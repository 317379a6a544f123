//! Pictures whose samples are added pass by pass.

use rta_core::color::Rgb;
use rta_core::raster::{Places, Raster};
use rta_core::sampling::Sobol;
use rta_core::scalar::Scalar;
use rta_core::trace::dice::Sample;

use crate::agreement::Agreement;

/// Samples that are added to those that pixels have.
#[derive(Clone, Copy, Debug)]
pub struct Pass {
    /// The samples that pixels have then, and the seed by which rays are spread.
    pub samples: Sobol,
    /// How many of them the pixels have already.
    pub first: u32,
}

/// A pixel to which samples are added.
pub struct Added<'s, S: Scalar> {
    /// Its column and row.
    pub place: [u32; 2],
    /// The sum of the light of its samples so far.
    pub sum: &'s mut Rgb<S::Light>,
    /// What is told of each sample, where somebody asks whether they agree.
    pub agreement: Option<&'s mut Agreement>,
}

/// Pixels to which samples are added.
pub type Sums<'p, 's, S> = &'p mut dyn Iterator<Item = Added<'s, S>>;

impl Pass {
    /// Adds the samples of the pixels of a picture on `raster`, which `trace` returns the light of, at `places` as many: in the order of their numbers, as a
    /// picture of as many samples adds them, so that the sums are the same to the last bit.
    pub(super) fn add<S: Scalar>(
        self,
        (raster, places): (Raster, impl Places),
        sums: Sums<S>,
        mut trace: impl FnMut((S::Unit, S::Unit), Sample) -> Rgb<S::Light>,
    ) {
        for mut pixel in sums {
            let [x, y] = pixel.place;
            let row = places.row::<S::Unit>(raster, y);
            for number in self.first..places.samples() {
                let place = places.place(raster, row, x, number);
                pixel.take(places, trace(place, Sample { x, y, number }));
            }
        }
    }
}

impl<S: Scalar> Added<'_, S> {
    /// Takes the light of one more sample.
    pub(super) fn take(&mut self, places: impl Places, light: Rgb<S::Light>) {
        *self.sum = places.add(*self.sum, light);
        if let Some(agreement) = &mut self.agreement {
            agreement.add(light);
        }
    }
}
