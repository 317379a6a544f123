//! What the mouse tells about the pixel under it.

use core::time::Duration;
use std::sync::Arc;
use std::time::Instant;

use super::shown::Shown;
use super::source::Source;
use crate::engine::Engine;
use crate::engine::probe::Probe;

/// The pixel that was pointed at last, with its rays: they are traced once, however often the window is drawn.
#[derive(Default)]
pub struct Pointer {
    /// The frame that can be asked, and its tracer.
    frame: Option<(u32, Arc<Engine>)>,
    /// The pixel, and what is known of it in that frame.
    known: Option<((u32, u32), Probe)>,
    /// How long it took to make the frame ready.
    cost: Duration,
}

impl Pointer {
    /// Takes the tracer of a frame that is seen.
    pub fn take(&mut self, number: u32, engine: Arc<Engine>) {
        (self.frame, self.known) = (Some((number, engine)), None);
    }

    /// Returns two lines about a pixel of a frame: its place, colour and entry of the colour table, and the object and rays behind it.
    /// Where the frame is seen for a moment only, the second line is left to a pause if it takes longer than that.
    #[must_use]
    pub fn describe(
        &mut self,
        (source, number): (&Source, u32),
        shown: &Shown,
        (x, y): (u32, u32),
        moment: Option<Duration>,
    ) -> Vec<String> {
        let color = shown.color(x as usize, y as usize);
        let entry = match shown.index(x, y) {
            Some(index) => format!("  entry {index}"),
            None if y < shown.rows() => String::new(),
            None => "  (preview)".into(),
        };
        let place = format!("{x},{y}  colour {} {} {}{entry}", color.r, color.g, color.b);
        let is_there = self.frame.as_ref().is_some_and(|(frame, _)| *frame == number);
        let behind = match moment {
            // Half of the time is for drawing the frame.
            Some(moment) if !is_there && self.cost > moment / 2 => {
                "space pauses the film to tell more".into()
            }
            _ => self.behind(source, number, (x, y)),
        };
        vec![place, behind]
    }

    /// Returns the object and the rays behind a pixel of a frame.
    fn behind(&mut self, source: &Source, number: u32, pixel: (u32, u32)) -> String {
        let engine = match &self.frame {
            Some((frame, engine)) if *frame == number => Arc::clone(engine),
            _ => {
                let begin = Instant::now();
                let engine = match source.engine(number) {
                    Ok(engine) => Arc::new(engine),
                    Err(error) => return error.to_string(),
                };
                self.cost = begin.elapsed();
                self.take(number, Arc::clone(&engine));
                engine
            }
        };
        let known = self.known.take().filter(|(known, _)| *known == pixel);
        let (_, probe) = self.known.insert(known.unwrap_or_else(|| (pixel, engine.probe(pixel.0, pixel.1))));
        let object = probe.object().map_or_else(|| "sky".into(), |object| object.to_string());
        let kinds = ["primary", "reflected", "transmitted", "shadow"];
        let rays = probe.rays();
        let traced = rays.iter().zip(kinds).filter(|(count, _)| **count > 0);
        let parts: Vec<_> = traced.map(|(count, kind)| format!("{count} {kind}")).collect();
        format!("{object}  rays: {}", parts.join(", "))
    }
}
