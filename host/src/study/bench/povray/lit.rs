//! Rooms in which something emits, for POV-Ray: lamps with a size, and its own radiosity (G. Ward, F. Rubinstein, R. Clear, "A Ray Tracing Solution
//! for Diffuse Interreflection", SIGGRAPH 88).

use core::fmt;

use rta_scenes::description::{Description, Lamp, LampShape, Material, Surface};
use rta_scenes::space::{cross, difference, length, unit};

use super::{File, vector};

/// How well POV-Ray finds light that goes round.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Radiosity {
    /// Places on a lamp along each side.
    pub lamp: u16,
    /// Rays from a place whose light is gathered.
    pub count: u32,
    /// Places that are mixed between.
    pub nearest: u32,
    /// How much mixing may err.
    pub error_bound: f64,
    /// Bounces.
    pub recursion: u32,
    /// The finest step of the pictures that are traced ahead, as a part of the width; also the least distance that places are kept for.
    pub step: f64,
    /// Light between neighbours from which on a pixel is refined, 1 is white, and how often.
    pub smoothing: (f64, u32),
}

impl fmt::Display for Radiosity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { lamp, count, nearest, error_bound, recursion, step, smoothing: (threshold, depth) } = self;
        write!(
            f,
            "area_light {lamp} x {lamp}, count {count}, nearest_count {nearest}, error_bound {error_bound}, recursion_limit {recursion}, \
             pretrace_end {step}, +A{threshold} +R{depth}"
        )
    }
}

impl Radiosity {
    /// Returns the block of the global settings.
    pub(super) fn settings(&self) -> String {
        let Self { count, nearest, error_bound, recursion, step, .. } = self;
        format!(
            " radiosity {{ pretrace_start 0.08 pretrace_end {step:?} count {count} nearest_count {nearest} error_bound {error_bound:?} \
             recursion_limit {recursion} low_error_factor 0.5 gray_threshold 0 minimum_reuse {:?} brightness 1 adc_bailout 0.0001 \
             normal off media off }}",
            1.5 * step
        )
    }
}

/// A room whose quads that emit are lamps too.
pub(super) fn lit(scene: &Description) -> Description {
    let mut lit = scene.with_emitters();
    // What goes round takes its place.
    lit.ambient = [0.0; 3];
    lit
}

impl File<'_> {
    /// Writes a parallelogram that shines, as a grid of so many places along each side.
    pub(super) fn area_lamp(&mut self, lamp: &Lamp, shape: &LampShape, places: u16) {
        let LampShape::Area { edges: [u, v], .. } = shape else { return self.lamp(lamp) };
        let normal = cross(*u, *v);
        // Its law is 2 / (1 + (d / distance)^2): of the inverse square where the distance is small.
        let distance = 1e-3 * length(normal).sqrt();
        let color = lamp.color.map(|register| register / (2.0 * distance * distance));
        let toward = difference(lamp.position, unit(normal).unwrap_or(normal).map(|x| -x));
        let (place, color, toward, u, v) =
            (vector(lamp.position), vector(color), vector(toward), vector(*u), vector(*v));
        // A spotlight as wide as the half-space is a surface's cosine.
        self.line(format_args!(
            "light_source {{ {place} rgb {color} spotlight point_at {toward} radius 90 falloff 90 tightness 1 \
             fade_distance {distance:?} fade_power 2 area_light {u}, {v}, {places}, {places} adaptive 1 area_illumination on }}"
        ));
    }

    /// Returns the radiance that a surface sends out by itself, if it does, in a room that is lit.
    pub(super) fn emission(&self, surface: &Surface) -> Option<[f64; 3]> {
        let is_named = matches!(surface, Surface::Of(_));
        if self.light.round().is_some() && is_named { Material::of(surface, self.named).emits } else { None }
    }
}
