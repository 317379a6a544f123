//! Measures of the difference between two pictures, and the Pareto front of errors and costs.

use rta_core::color::Rgb;

/// Measures of the difference between two pictures, over all registers of all pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// Root of the mean square of the differences, 0 to 1.
    pub rmse: f64,
    /// The largest difference of a register, 0 to 1.
    pub worst: f64,
    /// Part of the pixels that differ by at most one level in every register, 0 to 1.
    pub within: f64,
}

impl Difference {
    /// Compares two pictures of as many pixels, whose registers are from 0 to 1; `level` is one level of a display's
    /// gun. Pictures without pixels do not differ.
    #[must_use]
    pub fn between(a: &[Rgb<f32>], b: &[Rgb<f32>], level: f64) -> Self {
        // A level that was computed may be a rounding above itself.
        let most = level * (1.0 + 1e-6);
        let (mut squares, mut worst, mut within, mut pixels) = (0.0, 0.0_f64, 0.0, 0.0);
        for (a, b) in a.iter().zip(b) {
            let apart = a.zip(*b, |a, b| (f64::from(a) - f64::from(b)).abs());
            let largest = apart.r.max(apart.g).max(apart.b);
            squares += apart.r * apart.r + apart.g * apart.g + apart.b * apart.b;
            worst = worst.max(largest);
            within += f64::from(u8::from(largest <= most));
            pixels += 1.0;
        }
        if pixels == 0.0 {
            return Self { rmse: 0.0, worst: 0.0, within: 1.0 };
        }
        Self { rmse: (squares / (3.0 * pixels)).sqrt(), worst, within: within / pixels }
    }

    /// Peak signal-to-noise ratio in decibels for a peak of 1: infinite where nothing differs.
    #[must_use]
    pub fn psnr(&self) -> f64 {
        -20.0 * self.rmse.log10()
    }
}

/// Returns the root of the mean square of the differences of two pictures as a display shows them, cut to 0 to 1.
#[must_use]
pub fn shown_error(a: &[Rgb<f32>], b: &[Rgb<f32>]) -> f64 {
    let [a, b] = [a, b].map(|light| -> Vec<_> {
        light.iter().map(|light| light.map(|register| register.clamp(0.0, 1.0))).collect()
    });
    Difference::between(&a, &b, 0.0).rmse
}

/// Returns the median: of an even number of values the lower of the two in the middle, of no values 0.
#[must_use]
pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len().saturating_sub(1) / 2).copied().unwrap_or(0.0)
}

/// Returns the slope of `log y` over `log x` of points `(x, y)`, by least squares; `None` where there are not two different x, or a number
/// is not above 0.
#[must_use]
pub fn slope(points: &[(f64, f64)]) -> Option<f64> {
    let (mut n, mut sums) = (0.0, [0.0; 4]);
    for &(x, y) in points {
        let (x, y) = (x.ln(), y.ln());
        n += 1.0;
        let [sum_x, sum_y, squares, products] = sums;
        sums = [sum_x + x, sum_y + y, squares + x * x, products + x * y];
    }
    let [x, y, squares, products] = sums;
    let slope = (n * products - x * y) / (n * squares - x * x);
    slope.is_finite().then_some(slope)
}

/// Returns the indexes of the points `(cost, error)` on the Pareto front, the cheapest first: those than which no other point is
/// better in one without being worse in the other. Of equal points the first is on the front.
#[must_use]
pub fn pareto_front(points: &[(f64, f64)]) -> Vec<usize> {
    let mut order: Vec<_> = points.iter().enumerate().collect();
    order.sort_by(|(_, a), (_, b)| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut least = f64::INFINITY;
    let better = |(place, (_, error)): (usize, &(f64, f64))| {
        let better = *error < least;
        least = least.min(*error);
        better.then_some(place)
    };
    order.into_iter().filter_map(better).collect()
}
