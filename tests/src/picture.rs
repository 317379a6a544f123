//! Pictures in linear light, and the share of pixels in which two of them agree.

use rta::engine::{Engine, EngineError, Format, Model, Settings};
use rta_core::color::Rgb;
use rta_scenes::description::Description;
use rta_scenes::sampler::Sampler;

/// Returns the settings that the specification states its figures for: 320 x 200 pixels, as a PS/2 has them, on a
/// screen of 4 : 3, with the thesis's model and depth 5.
pub fn settings(format: Format) -> Settings {
    Settings { format, ..Settings::default() }
}

/// Returns a scene's picture in linear light that is not clamped, row by row from the top.
///
/// # Errors
/// The scene does not fit the format, or the settings are out of range.
pub fn render(scene: &Description, settings: &Settings) -> Result<Vec<[f64; 3]>, EngineError> {
    let engine = Engine::new(scene, settings)?;
    let mut rows = vec![Rgb::default(); settings.width as usize * settings.height as usize];
    engine.linear_rows(0, &mut rows);
    Ok(rows.iter().map(|p| [p.r, p.g, p.b].map(f64::from)).collect())
}

/// Returns the share of pixels, in a hundred, that are within `tolerance` of each other in every register, both
/// pictures clamped to [0, 1].
///
/// # Panics
/// The pictures have different numbers of pixels.
pub fn share_within(a: &[[f64; 3]], b: &[[f64; 3]], tolerance: f64) -> f64 {
    assert_eq!(a.len(), b.len(), "pictures of one size");
    let near = |(p, q): &(&[f64; 3], &[f64; 3])| {
        p.iter().zip(*q).all(|(x, y)| (x.clamp(0.0, 1.0) - y.clamp(0.0, 1.0)).abs() <= tolerance)
    };
    100.0 * a.iter().zip(b).filter(near).count() as f64 / a.len() as f64
}

/// A small raster on the screen of 4 : 3 that scenes are baked for.
pub const SMALL: Settings = Settings {
    width: 64,
    height: 40,
    aspect: 4.0 / 3.0,
    format: Format::Q16,
    model: Model::Rta,
    depth: 5,
    cutoff: None,
    sampling: Sampler::CENTER,
};

/// A picture as the bits of its light, row by row from the top, and as levels of a VGA.
pub type Bits = (Vec<[u32; 3]>, Vec<Rgb<u8>>);

/// Returns the bits of a pixel's light.
pub fn bits(light: Rgb<f32>) -> [u32; 3] {
    [light.r, light.g, light.b].map(f32::to_bits)
}

/// Returns a scene's picture by the engine.
///
/// # Panics
/// The scene does not fit the format, or the settings are out of range.
pub fn by_engine(scene: &Description, settings: &Settings) -> Bits {
    let engine = Engine::new(scene, settings).expect("the engine takes it");
    let pixels = settings.width as usize * settings.height as usize;
    let (mut linear, mut levels) = (vec![Rgb::new(0.0, 0.0, 0.0); pixels], vec![Rgb::new(0, 0, 0); pixels]);
    engine.linear_rows(0, &mut linear);
    engine.level_rows(0, 63, &mut levels);
    (linear.into_iter().map(bits).collect(), levels)
}
