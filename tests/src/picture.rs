//! Pictures in linear light, and how far two of them are apart.

use rta::engine::{Engine, EngineError, Format, Settings};
use rta_core::color::Rgb;
use rta_scenes::description::Description;

/// The raster of a PS/2 on its 4 : 3 screen, depth 5: what the specification's figures are stated for.
pub fn settings(format: Format) -> Settings {
    Settings { format, ..Settings::default() }
}

/// Renders a scene; top row first, not clamped.
///
/// # Errors
/// Whatever keeps the scene out of the format.
pub fn render(scene: &Description, settings: &Settings) -> Result<Vec<[f64; 3]>, EngineError> {
    let engine = Engine::new(scene, settings)?;
    let mut rows = vec![Rgb::default(); settings.width as usize * settings.height as usize];
    engine.linear_rows(0, &mut rows);
    Ok(rows.iter().map(|p| [p.r, p.g, p.b].map(f64::from)).collect())
}

/// How many pixels in a hundred are within `tolerance` of each other in every register, both clamped to [0, 1].
pub fn share_within(a: &[[f64; 3]], b: &[[f64; 3]], tolerance: f64) -> f64 {
    assert_eq!(a.len(), b.len(), "pictures of one size");
    let near = |(p, q): &(&[f64; 3], &[f64; 3])| {
        p.iter().zip(*q).all(|(x, y)| (x.clamp(0.0, 1.0) - y.clamp(0.0, 1.0)).abs() <= tolerance)
    };
    100.0 * a.iter().zip(b).filter(near).count() as f64 / a.len() as f64
}
