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

/// An option of an illumination model.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelOption {
    /// Its name.
    pub name: String,
    /// Its numbers; many have none.
    pub numbers: Vec<f64>,
}
