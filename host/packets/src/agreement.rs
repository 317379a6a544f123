//! When a pixel has samples enough: the statistics of M. Lee, R. Redner and S. Uselton ("Statistically Optimized Sampling for
//! Distributed Ray Tracing", SIGGRAPH 85).

use rta_core::color::Rgb;
use rta_core::scalar::Light;

/// How far the samples of a pixel differ: sums over the levels 0 to 255 of each register, so that a pixel ends after the same sample on
/// every machine.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Agreement {
    samples: u32,
    sums: [u32; 3],
    squares: [u32; 3],
}

impl Agreement {
    /// Parts that a level is divided into by a tolerance.
    pub const PARTS: u16 = 16;

    /// Returns a part of white, 0 to 1, as a tolerance.
    #[must_use]
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // it is between 0 and 4080
    pub fn tolerance(part: f64) -> u16 {
        (part.clamp(0.0, 1.0) * 255.0 * f64::from(Self::PARTS)).round() as u16
    }

    /// Returns the number of samples so far.
    #[must_use]
    pub const fn samples(&self) -> u32 {
        self.samples
    }

    /// Takes one more sample, of [`Sobol::MAX_SAMPLES`](rta_core::sampling::Sobol::MAX_SAMPLES) at most.
    pub fn add<L: Light>(&mut self, light: Rgb<L>) {
        self.samples += 1;
        let levels = [light.r, light.g, light.b].map(|register| u32::from(register.level(255)));
        for ((sum, square), level) in self.sums.iter_mut().zip(&mut self.squares).zip(levels) {
            // At most 2^14 of below 2^16.
            *sum += level;
            *square += level * level;
        }
    }

    /// Returns whether there are two samples and the standard error of their mean is within `tolerance`, in [`Agreement::PARTS`] of a level, in
    /// each register.
    ///
    /// The error is that of samples by chance, the root of their variance over their number; samples of a sequence have less.
    #[must_use]
    pub fn is_within(&self, tolerance: u16) -> bool {
        let samples = u64::from(self.samples);
        let [tolerance, parts] = [tolerance, Self::PARTS].map(u64::from);
        self.samples >= 2
            && self.sums.iter().zip(self.squares).all(|(&sum, square)| {
                // The variance times the square of their number: below 2^44.
                let spread = samples * u64::from(square) - u64::from(sum) * u64::from(sum);
                let allowed = (tolerance * tolerance).saturating_mul(samples * samples * samples);
                spread * (parts * parts) <= allowed
            })
    }

    /// Returns whether the difference of the means of two pixels with as many samples, over the root of 2, is within `tolerance`, in
    /// [`Agreement::PARTS`] of a level, in each register.
    ///
    /// If both are means of the same light with one error, that is the error by this one difference.
    #[must_use]
    pub fn is_near(&self, other: &Self, tolerance: u16) -> bool {
        let [samples, tolerance] = [self.samples, u32::from(tolerance)].map(u64::from);
        let parts = u64::from(Self::PARTS);
        self.sums.iter().zip(other.sums).all(|(&own, other)| {
            // Sums of at most 2^14 samples: the squares are below 2^54.
            let apart = u64::from(own.abs_diff(other)) * parts;
            apart * apart <= 2 * (tolerance * samples).pow(2)
        })
    }
}

#[cfg(test)]
mod tests {
    use rta_core::color::Rgb;

    use super::Agreement;

    fn of(samples: &[f32]) -> Agreement {
        let mut agreement = Agreement::default();
        samples.iter().for_each(|&light| agreement.add(Rgb::new(0.5, light, 0.0)));
        agreement
    }

    #[test]
    fn the_standard_error_is_that_of_the_mean() {
        // Half black, half white: a variance of 1/4, and after n samples the error 1/(2 root n).
        for n in [4, 16, 64, 1024, 16384] {
            let half: Vec<_> = (0..n).map(|i| f32::from(u8::from(i % 2 == 0))).collect();
            let error = 255.0 * 16.0 / (2.0 * f64::from(n).sqrt());
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it is below 4080")]
            let [below, above] = [error - 1.0, error + 1.0].map(|tolerance| tolerance as u16);
            assert!(!of(&half).is_within(below) && of(&half).is_within(above), "{n}");
        }
    }

    #[test]
    fn few_samples_say_nothing_and_equal_ones_agree() {
        assert!(!of(&[0.3]).is_within(4080) && of(&[0.3; 2]).is_within(0));
        assert!(of(&[9.0, 1.0, 20.0, 4.0]).is_within(0), "white is white");
        assert!(!of(&[0.0, 0.0, 0.0, 1.0]).is_within(16));
        assert_eq!(of(&[0.1; 7]).samples(), 7);
    }

    #[test]
    fn pixels_are_near_whose_means_are() {
        // 20 levels apart, over the root of 2: 14.1 levels.
        for (one, other) in
            [(&[0.4][..], &[0.4 + 20.0 / 255.0][..]), (&[0.2, 0.6], &[0.4, 0.4 + 40.0 / 255.0])]
        {
            let (one, other) = (of(one), of(other));
            assert!(!one.is_near(&other, 14 * 16) && one.is_near(&other, 15 * 16));
            assert!(!other.is_near(&one, 14 * 16) && other.is_near(&one, 15 * 16));
        }
        assert!(of(&[0.7]).is_near(&of(&[0.7]), 0));
    }
}
