//! CIEDE2000, the CIE's distance of two colours: G. Sharma, W. Wu and E. N. Dalal, "The CIEDE2000 Color-Difference Formula:
//! Implementation Notes, Supplementary Test Data, and Mathematical Observations", Color Research and Application 30(1), 2005.
//! Equations below are the paper's. The parametric factors k_L, k_C and k_H are 1.

use super::colorimetry::Lab;

/// Returns the distance of two colours: about 1 is just noticeable, and black is 100 from white.
#[must_use]
pub fn ciede2000(color: Lab, other: Lab) -> f64 {
    let mean_chroma = 0.5 * (color.a.hypot(color.b) + other.a.hypot(other.b));
    // Equations 4 to 6: a is stretched where colours are nearly gray.
    let stretch = 1.5 - 0.5 * of_25(mean_chroma);
    let (a1, a2) = (stretch * color.a, stretch * other.a);
    let (chroma1, chroma2) = (a1.hypot(color.b), a2.hypot(other.b));
    let hue1 = hue(a1, color.b);
    let hue2 = hue(a2, other.b);

    let gray = chroma1 == 0.0 || chroma2 == 0.0;
    let hue_step = if gray { 0.0 } else { shorter_way(hue2 - hue1) };
    // Equations 8, 9 and 11.
    let lightness = other.l - color.l;
    let chroma = chroma2 - chroma1;
    let hue = 2.0 * (chroma1 * chroma2).sqrt() * (0.5 * hue_step).to_radians().sin();

    // Equations 12 to 14.
    let l = 0.5 * (color.l + other.l);
    let c = 0.5 * (chroma1 + chroma2);
    let h = if gray { hue1 + hue2 } else { mean_hue(hue1, hue2) };

    // Equation 15.
    let cosine = |factor: f64, offset: f64| (factor * h + offset).to_radians().cos();
    let t = 1.0 - 0.17 * cosine(1.0, -30.0) + 0.24 * cosine(2.0, 0.0) + 0.32 * cosine(3.0, 6.0)
        - 0.20 * cosine(4.0, -63.0);
    // Equations 16 to 21.
    let rotation_angle = 30.0 * (-((h - 275.0) / 25.0).powi(2)).exp();
    let off_middle = (l - 50.0).powi(2);
    let lightness = lightness / (1.0 + 0.015 * off_middle / (20.0 + off_middle).sqrt());
    let chroma = chroma / (1.0 + 0.045 * c);
    let hue = hue / (1.0 + 0.015 * c * t);
    let rotation = -(2.0 * rotation_angle).to_radians().sin() * 2.0 * of_25(c);

    // Equation 22. Rounding alone can make the sum negative.
    let square = lightness * lightness + chroma * chroma + hue * hue + rotation * chroma * hue;
    square.max(0.0).sqrt()
}

/// Returns sqrt(C^7 / (C^7 + 25^7)), which is 0 for gray and nearly 1 for strong chroma.
fn of_25(chroma: f64) -> f64 {
    let power = chroma.powi(7);
    (power / (power + 25.0_f64.powi(7))).sqrt()
}

/// Returns the angle of a hue, 0 to 360 degrees; 0 for gray (equation 7).
fn hue(a: f64, b: f64) -> f64 {
    b.atan2(a).to_degrees().rem_euclid(360.0)
}

/// Returns a difference of hues as the shorter way around the circle, -180 to 180 degrees (equation 10).
fn shorter_way(difference: f64) -> f64 {
    if difference > 180.0 {
        difference - 360.0
    } else if difference < -180.0 {
        difference + 360.0
    } else {
        difference
    }
}

/// Returns the hue in the middle of the shorter way between two (equation 14).
fn mean_hue(hue1: f64, hue2: f64) -> f64 {
    let sum = hue1 + hue2;
    if (hue1 - hue2).abs() <= 180.0 {
        0.5 * sum
    } else if sum < 360.0 {
        0.5 * (sum + 360.0)
    } else {
        0.5 * (sum - 360.0)
    }
}
