//! What makes the picture of a sound scene black.

use crate::description::{Description, Material, Surface, Triangle};
use crate::space::{Triple, cross, difference, dot, length};
use crate::warning::Warning;

impl Description {
    /// Adds warnings about what makes a picture black for no reason that can be seen in it: no light, and an observer inside
    /// of an object.
    pub(crate) fn look_over(&mut self) {
        let warnings = &mut self.warnings;
        let mut add = |text| warnings.push(Warning { line: 0, text });
        let emits =
            |own: &Material| own.emits.is_some_and(|light| light.iter().any(|register| *register > 0.0));
        let emits = self.materials.iter().any(emits);
        let is_dark = |color: &Triple| color.iter().all(|register| *register == 0.0);
        if self.lamps.iter().all(|lamp| is_dark(&lamp.color)) && is_dark(&self.ambient) && !emits {
            add("the scene has no light: what does not mirror its background is black".into());
            return;
        }
        let eye = self.camera.eye;
        let is_turned_away = |triangle: &Triangle| {
            let [a, b, c] = triangle.vertices;
            triangle.one_sided && dot(cross(difference(b, a), difference(c, a)), difference(eye, a)) <= 0.0
        };
        if !self.triangles.is_empty() && self.triangles.iter().all(is_turned_away) {
            let text = "all polygons turn their invisible side to the observer".into();
            self.warnings.push(Warning { line: 0, text });
        }
        let materials = &self.materials;
        let is_clear =
            |surface: &Surface| Material::of(surface, materials).transmit.is_some_and(|kt| kt > 0.0);
        let spheres = self.spheres.iter().filter(|sphere| !is_clear(&sphere.surface));
        let spheres = spheres.map(|s| ("sphere", s.position, [s.radius; 3], s.line));
        let ellipsoids = self
            .ellipsoids
            .iter()
            .filter(|ellipsoid| !ellipsoid.inside_only && !is_clear(&ellipsoid.surface));
        let ellipsoids = ellipsoids.map(|e| ("ellipsoid", e.position, e.radii, e.line));
        let cylinders = self.cylinders.iter().filter(|cylinder| !is_clear(&cylinder.surface));
        let endless = |radius| [radius, radius, f64::INFINITY];
        let cylinders = cylinders.map(|c| ("cylinder", c.position, endless(c.radius), c.line));
        for (kind, center, radii, line) in spheres.chain(ellipsoids).chain(cylinders) {
            let holds = |place: Triple| {
                let [x, y, z] = difference(place, center);
                let [a, b, c] = radii;
                length([x / a, y / b, z / c]) < 1.0
            };
            if holds(eye) && !self.lamps.iter().any(|lamp| holds(lamp.position)) {
                let text = format!("the observer is inside of this {kind}, and no light is there");
                self.warnings.push(Warning { line, text });
                return;
            }
        }
    }
}
