//! What the mouse tells about the pixel under it.

use super::shown::Shown;
use crate::engine::Engine;
use crate::engine::probe::Probe;

/// The pixel that was pointed at last, with its rays: they are traced once, however often the window is drawn.
#[derive(Debug, Default)]
pub struct Pointer(Option<((u32, u32), Probe)>);

impl Pointer {
    /// Returns two lines about a pixel: its place, colour and entry of the colour table, and the object and rays behind it.
    #[must_use]
    pub fn describe(&mut self, engine: &Engine, shown: &Shown, (x, y): (u32, u32)) -> Vec<String> {
        let color = shown.color(x as usize, y as usize);
        let entry = match shown.index(x, y) {
            Some(index) => format!("  entry {index}"),
            None if y < shown.rows() => String::new(),
            None => "  (preview)".into(),
        };
        let known = self.0.take().filter(|(pixel, _)| *pixel == (x, y));
        let (_, probe) = self.0.insert(known.unwrap_or_else(|| ((x, y), engine.probe(x, y))));
        let object = probe.object().map_or_else(|| "sky".into(), |object| object.to_string());
        let kinds = ["primary", "reflected", "transmitted", "shadow"];
        let rays = probe.rays();
        let traced = rays.iter().zip(kinds).filter(|(count, _)| **count > 0);
        let parts: Vec<_> = traced.map(|(count, kind)| format!("{count} {kind}")).collect();
        vec![
            format!("{x},{y}  colour {} {} {}{entry}", color.r, color.g, color.b),
            format!("{object}  rays: {}", parts.join(", ")),
        ]
    }
}
