//! How a scene is to be drawn, as far as its file says so.

/// How a scene is to be drawn, where the command line does not say otherwise.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Settings {
    /// Width and height of the screen, of which the ratio counts, each above 0; without it pixels are square.
    pub screen: Option<[f64; 2]>,
    /// Reflections and refractions that a ray is followed through.
    pub depth: Option<u32>,
    /// Samples of a pixel: a square number from 1 to 1024.
    pub samples: Option<u32>,
    /// Part of its light that a ray must bring into the pixel to be traced, 0 to 1.
    pub cutoff: Option<f64>,
    /// Number of wavelengths, odd, 1 to 31; without it, red, green and blue.
    pub wavelengths: Option<u32>,
    /// Options of the illumination model.
    pub model_options: Vec<ModelOption>,
}

impl Settings {
    /// Returns the cut-off as a ratio of whole numbers, so that every number format rounds it for itself: the nearest, one in a whole
    /// number where that is as near as 2^-20 of it.
    #[must_use]
    pub fn cutoff_ratio(&self) -> Option<(u16, u16)> {
        self.cutoff.map(ratio)
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 16 bits")]
fn ratio(part: f64) -> (u16, u16) {
    let most = f64::from(u16::MAX);
    let one_in = (1.0 / part).round().clamp(1.0, most);
    if (one_in * part - 1.0).abs() < 2f64.powi(-20) {
        return (1, one_in as u16);
    }
    match (part * most).round().clamp(0.0, most) as u16 {
        0 => (0, 1),
        numerator => (numerator, u16::MAX),
    }
}

/// An option of an illumination model.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelOption {
    /// Its name.
    pub name: String,
    /// Its numbers; many have none.
    pub numbers: Vec<f64>,
}

#[cfg(test)]
mod tests {
    use super::Settings;

    #[test]
    fn cutoffs_are_ratios() {
        let ratio = |part| Settings { cutoff: Some(part), ..Settings::default() }.cutoff_ratio();
        assert_eq!(Settings::default().cutoff_ratio(), None);
        assert_eq!(ratio(0.0), Some((0, 1)));
        assert_eq!(ratio(1e-9), Some((0, 1)));
        assert_eq!(ratio(1.0), Some((1, 1)));
        assert_eq!(ratio(0.015_625), Some((1, 64)));
        assert_eq!(ratio(0.75), Some((49_151, 65_535)));
    }
}
