//! Lights: points, and areas that are taken for points.

use super::Reader;
use crate::error::SceneError;
use crate::numbers::{AXES, Range};
use crate::polygon;
use crate::space::{Triple, difference, length};

/// A point that shines.
pub(super) struct Light {
    pub(super) position: Triple,
    shine: Shine,
    pub(super) line: u32,
}

/// How bright a light is.
enum Shine {
    /// The entity says it.
    Told(Triple),
    /// The entity `l` leaves it to the number of lights.
    Shared,
    /// It is a part of an area light, by their numbers: as much as the area of its polygon.
    Part(usize, f64),
}

/// The entity `L`.
pub(super) struct Area {
    color: Triple,
    /// Constant, linear and square coefficient of the attenuation.
    attenuation: Triple,
    /// The sum of its polygons' areas.
    area: f64,
}

impl Light {
    /// Returns the colour of the light, where all share `share`, for a scene that is looked `at` there.
    pub(super) fn color(&self, share: f64, areas: &[Area], at: Triple) -> Triple {
        match self.shine {
            Shine::Told(color) => color,
            Shine::Shared => [share; 3],
            Shine::Part(number, area) => areas.get(number).map_or([0.0; 3], |of| {
                let away = length(difference(self.position, at));
                let [constant, linear, square] = of.attenuation;
                let weaker = constant + linear * away + square * away * away;
                let part = area / of.area / if weaker > 0.0 { weaker } else { 1.0 };
                of.color.map(|register| register * part)
            }),
        }
    }
}

impl Reader<'_> {
    pub(super) fn light(&mut self, line: u32) -> Result<(), SceneError> {
        self.begin("light", line, 3);
        let which = self.lights.len() + 1;
        let position = self.tokens.vector(AXES, format_args!("light {which}"), Range::Any)?;
        let shine = if self.tokens.numbers_ahead(1) == 0 {
            Shine::Shared
        } else {
            self.entry.numbers = 6;
            Shine::Told(self.tokens.color(format_args!("the colour of light {which}"))?)
        };
        self.lights.push(Light { position, shine, line });
        Ok(())
    }

    /// The entity `L`: from here on polygons shine, or no longer.
    pub(super) fn area(&mut self, line: u32) -> Result<(), SceneError> {
        self.begin("area light", line, 4);
        let color = self.tokens.color("the area light")?;
        let power = self.tokens.number("the power of the area light", Range::NotNegative)?;
        let mut attenuation = [1.0, 0.0, 0.0];
        if self.tokens.peek().is_some_and(|next| next.text.eq_ignore_ascii_case("atten")) {
            self.tokens.next();
            self.begin("attenuation", line, 3);
            let names = ["constant part", "linear part", "square part"];
            attenuation = self.tokens.vector(names, "the attenuation", Range::NotNegative)?;
        }
        self.shines = power > 0.0 && color != [0.0; 3];
        if self.shines {
            self.warn(line, "the polygons of this area light shine from their middles and are not seen");
            self.areas.push(Area { color: color.map(|register| register * power), attenuation, area: 0.0 });
        }
        Ok(())
    }

    /// A polygon of an area light.
    pub(super) fn shine(&mut self, line: u32, corners: &[Triple]) {
        let (number, area) = (self.areas.len().saturating_sub(1), polygon::area(corners));
        let Some(of) = self.areas.last_mut() else { return };
        let mut position = [0.0; 3];
        for (register, corner) in position.iter_mut().zip([0, 1, 2]) {
            #[expect(clippy::cast_precision_loss, reason = "no polygon has 2^53 corners")]
            let part = 1.0 / corners.len() as f64;
            *register = corners.iter().filter_map(|place| place.get(corner)).map(|c| c * part).sum();
        }
        of.area += area;
        self.lights.push(Light { position, shine: Shine::Part(number, area), line });
    }
}
