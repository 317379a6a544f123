//! Light in the order of the samples, of which some end before others that began earlier.

use std::collections::VecDeque;

use rta_core::color::Rgb;

use crate::four::vector::{one, one_mut};

/// The light of samples that have begun and are not told yet.
pub(super) struct Queue {
    /// In the order in which they began; of those that have not ended there is none.
    lights: VecDeque<Option<Rgb<f32>>>,
    /// How many have been told.
    told: usize,
    /// The numbers of the samples that are followed side by side, in the order in which they began.
    numbers: [usize; 4],
}

impl Queue {
    /// Nothing has begun.
    pub(super) fn new() -> Self {
        Self { lights: VecDeque::new(), told: 0, numbers: [0; 4] }
    }

    /// The next sample begins in place `k`.
    #[inline(always)]
    pub(super) fn begin(&mut self, k: usize) {
        *one_mut(&mut self.numbers, k) = self.told + self.lights.len();
        self.lights.push_back(None);
    }

    /// The sample in place `k` ends with some light. Calls `put` with what can be told then.
    #[inline(always)]
    pub(super) fn end(&mut self, k: usize, light: Rgb<f32>, put: &mut dyn FnMut(Rgb<f32>)) {
        let number = one(&self.numbers, k) - self.told;
        if let Some(place) = self.lights.get_mut(number) {
            *place = Some(light);
        }
        while let Some(&Some(light)) = self.lights.front() {
            put(light);
            self.lights.pop_front();
            self.told += 1;
        }
    }
}
