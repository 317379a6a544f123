//! Lamps.

use super::Reader;
use super::said::Said;
use crate::accelerator::bounds::Bounds;
use crate::accelerator::solid::solids;
use crate::description::{Description, FallOff, Lamp, LampShape};
use crate::error::{Found, SceneError};
use crate::space::{Triple, cross, length, unit};

/// How many times as far away as the farthest thing of a scene a lamp is placed whose light is to be parallel: over the scene its
/// direction changes by at most a degree.
const AWAY: f64 = 64.0;

impl<'a> Reader<'a> {
    pub(super) fn lamp(&mut self, said: &Said<'a>) -> Result<(), SceneError> {
        let line = said.place.0;
        let power = said.number("power").unwrap_or(1.0);
        let color = said.triple("color").unwrap_or([1.0; 3]).map(|register| register * power);
        if let Some(overflow) = color.iter().find(|register| !register.is_finite()) {
            let found = Found::NotFinite(overflow.to_string());
            return Err(said.error(said.place, "the colour of the lamp times its power", found));
        }
        let fall_off = match (said.has("square"), said.has("constant")) {
            (true, _) => FallOff::Square,
            (_, true) => FallOff::Constant,
            _ => FallOff::OfModel,
        };
        let lamp =
            Lamp { position: [0.0; 3], color, radius: said.number("radius").unwrap_or(0.0), fall_off, line };
        let number = self.scene.lamps.len();
        let lamp = if let Some(toward) = said.part("toward") {
            self.refuse_beside(said, "toward", &["radius", "square", "along", "moves"])?;
            let direction = toward.numbers(0);
            if unit(direction).is_none() {
                let expected = "the lamp's direction (not zero)";
                return Err(said.error(toward.word(0).1, expected, Found::Number("0 0 0".into())));
            }
            self.undrawn("parallel light, which comes from far away for now", line);
            self.scene.details.lamps.insert(number, LampShape::Toward(direction));
            Lamp { fall_off: FallOff::Constant, ..lamp }
        } else if let Some((corner, part)) = said.triple("corner").zip(said.after("corner", "edges")) {
            self.refuse_beside(said, "corner", &["radius"])?;
            let edges = [part.numbers(0), part.numbers(3)];
            let Some((position, radius)) = sphere_of(corner, edges) else {
                let found = Found::Told("edges without an area between them".into());
                return Err(said.error(part.word(0).1, "the edges of the lamp (not parallel)", found));
            };
            self.scene.details.lamps.insert(number, LampShape::Area { corner, edges });
            Lamp { position, radius, ..lamp }
        } else {
            Lamp { position: said.triple("at").unwrap_or_default(), ..lamp }
        };
        if let Some(path) = self.along(said)? {
            self.scene.details.lamp_paths.insert(number, path);
        }
        if let Some(moves) = said.triple("moves") {
            self.scene.details.lamp_moves.insert(number, moves);
        }
        self.scene.lamps.push(lamp);
        Ok(())
    }

    /// Refuses parts that have no meaning beside another.
    fn refuse_beside(&self, said: &Said<'a>, other: &str, parts: &[&str]) -> Result<(), SceneError> {
        match parts.iter().find_map(|part| said.part(part)) {
            None => Ok(()),
            Some(part) => {
                let found = Found::Told(format!("\"{}\" beside \"{other}\"", part.keyword));
                Err(said.error(part.place, "nothing more of the lamp", found))
            }
        }
    }
}

/// Returns middle and radius of the sphere that looks as large from in front as a parallelogram; `None` for one without area.
pub(super) fn sphere_of([x, y, z]: Triple, edges: [Triple; 2]) -> Option<(Triple, f64)> {
    let [[ax, ay, az], [bx, by, bz]] = edges;
    let middle = [x + (ax + bx) / 2.0, y + (ay + by) / 2.0, z + (az + bz) / 2.0];
    let radius = (length(cross(edges[0], edges[1])) / core::f64::consts::PI).sqrt();
    (radius > 0.0 && radius.is_finite() && middle.iter().all(|c| c.is_finite())).then_some((middle, radius))
}

/// Places the lamps of parallel light far away from all that the scene has.
pub(super) fn place_distant(scene: &mut Description) {
    let is_distant = |number: &usize| matches!(scene.details.lamps.get(number), Some(LampShape::Toward(_)));
    if !(0..scene.lamps.len()).any(|number| is_distant(&number)) {
        return;
    }
    let eye = Bounds::about(scene.camera.eye, [0.0; 3]);
    let near = scene.lamps.iter().enumerate().filter(|(number, _)| !is_distant(number));
    let near = near.map(|(_, lamp)| Bounds::about(lamp.position, [lamp.radius; 3]));
    let solids = solids(scene).into_iter().map(|solid| solid.bounds);
    let far = AWAY * solids.chain(near).fold(eye, |all, bounds| all.with(&bounds)).largest().max(1.0);
    for (number, shape) in &scene.details.lamps {
        if let LampShape::Toward(direction) = shape
            && let Some((lamp, direction)) = scene.lamps.get_mut(*number).zip(unit(*direction))
        {
            lamp.position = direction.map(|part| part * far);
        }
    }
}
