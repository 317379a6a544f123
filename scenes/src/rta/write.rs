//! A description as a scene of the language.

use rta_core::scene::Object;

use super::HEADER;
use super::names::is_builtin;
use super::view::SCREEN;
use crate::description::{
    Description, Detail, Fading, FallOff, Keyframe, LampShape, ModelOption, Path, Quad, Shading, Side, Sky,
    Surface,
};

mod material;
mod words;

use words::Words;

impl Description {
    /// Returns the scene in the scene language, as [`read`](super::read) reads it: all that the description says, with the changes of
    /// [`named`](Self::named).
    #[must_use]
    pub fn to_rta(&self) -> String {
        let scene = self.clone().named();
        let mut text = HEADER.join(" ") + "\n";
        scene.write_view(&mut text);
        scene.write_air(&mut text);
        scene.textures.iter().for_each(|texture| material::texture(texture, &mut text));
        let own = scene.materials.iter().filter(|material| !is_builtin(material));
        own.for_each(|own| material::material(own, &mut text));
        scene.write_surroundings(&mut text);
        scene.write_objects(&mut text);
        text
    }

    fn write_view(&self, text: &mut String) {
        for Path { name, linear, keyframes } in &self.details.paths {
            let mut words = Words::new("path");
            words.name("", name).flag("linear", *linear);
            for Keyframe { time, place: [x, y, z] } in keyframes {
                words.numbers("at", &[*time, *x, *y, *z]);
            }
            words.end(text);
        }
        let (camera, optics, journey) = (&self.camera, &self.optics, &self.details.journey);
        let mut words = Words::new("camera");
        words.vector("at", camera.eye);
        match journey.as_ref().and_then(|journey| journey.aim) {
            Some(aim) => words.vector("to", aim),
            None => words.vector("look", camera.view),
        };
        words.maybe(journey.as_ref(), |words, journey| words.name("along", &journey.path));
        words.maybe(camera.up, |words, up| words.vector("up", up));
        words.number("lens", camera.focal);
        if camera.side == Side::Height {
            words.word("high");
        }
        words.maybe(optics.focus, |words, focus| words.number("focus", focus));
        words.maybe(optics.aperture, |words, aperture| words.number("aperture", aperture));
        words.maybe(optics.shutter, |words, times| words.numbers("shutter", &times));
        words.maybe(optics.moves, |words, moves| words.vector("moves", moves));
        words.maybe(optics.hither, |words, hither| words.number("hither", hither));
        words.end(text);
        let settings = &self.settings;
        if let Some(size) = self.raster {
            let mut words = Words::new("picture");
            words.numbers("", &size.map(f64::from));
            let screen = settings.screen.unwrap_or(size.map(f64::from));
            if screen != SCREEN {
                words.numbers("screen", &screen);
            }
            words.maybe(settings.depth, |words, depth| words.number("depth", depth.into()));
            words.maybe(settings.samples, |words, samples| words.number("samples", samples.into()));
            words.maybe(settings.cutoff, |words, cutoff| words.number("cutoff", cutoff));
            words.end(text);
        }
        let mut words = Words::new("model");
        words.name("", self.model.name());
        for ModelOption { name, numbers } in &settings.model_options {
            words.name("", name).numbers("", numbers);
        }
        words.end(text);
        if let Some(number) = settings.wavelengths {
            Words::new("spectral").number("", number.into()).end(text);
        }
    }

    fn write_air(&self, text: &mut String) {
        if let Some(attenuation) = &self.air.attenuation {
            let mut words = Words::new("attenuation");
            match attenuation.fading {
                Fading::Warnock => words.name("", "warnock"),
                Fading::Romney(power) => words.name("", "romney").number("", power),
                Fading::Haze(distances) => words.name("", "haze").numbers("", &distances),
            };
            words.maybe(attenuation.from, |words, from| words.number("from", from));
            words.maybe(attenuation.color, |words, color| words.color("color", color));
            words.end(text);
        }
        if let Some(medium) = &self.air.medium {
            let mut words = Words::new("medium");
            words.vector("extinction", medium.extinction).number("albedo", medium.albedo);
            words.number("anisotropy", medium.anisotropy).number("shadows", medium.shadows.into());
            words.maybe(medium.reach, |words, reach| words.number("reach", reach));
            words.end(text);
        }
    }

    fn write_surroundings(&self, text: &mut String) {
        let Sky { horizon, zenith } = self.sky;
        let mut words = Words::new("sky");
        match &self.details.sky_map {
            Some(file) => words.file("map", file),
            None if horizon == zenith => words.color("", horizon),
            None => words.color("horizon", horizon).color("zenith", zenith),
        };
        words.end(text);
        Words::new("ambient").color("", self.ambient).end(text);
        if let Some(floor) = &self.floor {
            let mut words = Words::new("floor");
            let [first, second] = floor.colors;
            words.color("", first).color("", second);
            words.maybe(self.details.tile, |words, tile| words.number("tile", tile));
            self.write_material(&floor.surface, &mut words);
            words.end(text);
        }
        for (number, lamp) in self.lamps.iter().enumerate() {
            let mut words = Words::new("lamp");
            let shape = self.details.lamps.get(&number);
            match shape {
                Some(LampShape::Toward(direction)) => words.vector("toward", *direction),
                Some(LampShape::Area { corner, edges: [first, second] }) => {
                    words.vector("corner", *corner).vector("edges", *first).vector("", *second)
                }
                None => words.vector("at", lamp.position),
            };
            if shape.is_none() && lamp.radius != 0.0 {
                words.number("radius", lamp.radius);
            }
            match lamp.color {
                [1.0, 1.0, 1.0] => {}
                [red, green, blue] if red == green && green == blue && red > 0.0 => {
                    words.number("power", red);
                }
                color => {
                    words.color("color", color);
                }
            }
            match lamp.fall_off {
                FallOff::OfModel => {}
                FallOff::Square => {
                    words.word("square");
                }
                FallOff::Constant => {
                    words.word("constant");
                }
            }
            words.maybe(self.details.lamp_paths.get(&number), |words, path| words.name("along", path));
            words.maybe(self.details.lamp_moves.get(&number), |words, moves| words.vector("moves", *moves));
            words.end(text);
        }
    }

    fn write_objects(&self, text: &mut String) {
        for (object, own) in (0..).zip(&self.cylinders) {
            let mut words = Words::new("cylinder");
            words.vector("at", own.position).number("radius", own.radius);
            self.write_rest(words, own.color, &own.surface, Object::Cylinder(object), text);
        }
        for (object, own) in (0..).zip(&self.ellipsoids) {
            let [radius, y, z] = own.radii;
            let words = if own.inside_only && radius == y && radius == z {
                Words::new("sphere").vector("at", own.position).number("radius", -radius).take()
            } else {
                let mut words = Words::new("ellipsoid");
                words.vector("at", own.position).vector("radii", own.radii);
                words.flag("inside", own.inside_only).take()
            };
            self.write_rest(words, own.color, &own.surface, Object::Ellipsoid(object), text);
        }
        for (object, own) in (0..).zip(&self.spheres) {
            let mut words = Words::new("sphere");
            words.vector("at", own.position).number("radius", own.radius);
            self.write_rest(words, own.color, &own.surface, Object::Sphere(object), text);
        }
        for (object, own) in (0..).zip(&self.cones) {
            let mut words = Words::new("cone");
            words.vector("from", own.base).number("radius", own.base_radius);
            words.vector("to", own.apex).number("radius", own.apex_radius);
            words.flag("inside", own.inside_only).flag("capped", own.capped);
            self.write_rest(words, own.color, &own.surface, Object::Cone(object), text);
        }
        for (object, own) in (0..).zip(&self.triangles) {
            if let Some((quad, is_further)) = self.quad(Object::Triangle(object)) {
                if let Some(corners) = quad.corners(&self.triangles).filter(|_| !is_further) {
                    let words = quad_words(quad, corners, own.one_sided);
                    self.write_rest(words, own.color, &own.surface, Object::Triangle(object), text);
                }
                continue;
            }
            let mut words = Words::new("triangle");
            own.vertices.iter().for_each(|vertex| _ = words.vector("", *vertex));
            words.maybe(own.normals, |words, normals| words.numbers("normals", normals.as_flattened()));
            words.flag("one-sided", own.one_sided);
            self.write_rest(words, own.color, &own.surface, Object::Triangle(object), text);
        }
        for (object, own) in (0..).zip(&self.planes) {
            let mut words = Words::new("plane");
            words.vector("at", own.point).vector("normal", own.normal);
            self.write_rest(words, own.color, &own.surface, Object::Plane(object), text);
        }
    }

    /// What objects of every kind may have.
    fn write_rest(
        &self,
        mut words: Words,
        color: [f64; 3],
        surface: &Surface,
        object: Object,
        text: &mut String,
    ) {
        let of_material = match surface {
            Surface::Of(number) => self.materials.get(usize::from(*number)).and_then(|own| own.color),
            _ => None,
        };
        if color != of_material.unwrap_or([1.0; 3]) {
            words.color("color", color);
        }
        self.write_material(surface, &mut words);
        if let Some(Detail { shading, moves, along, uv }) = self.details.objects.get(&object) {
            words.maybe(*uv, |words, uv| words.numbers("uv", uv.as_flattened()));
            words.flag("gouraud", *shading == Shading::Gouraud);
            words.flag("bishop-weimer", *shading == Shading::BishopWeimer);
            words.maybe(*moves, |words, moves| words.vector("moves", moves));
            words.maybe(along.as_ref(), |words, path| words.name("along", path));
        }
        words.end(text);
    }

    fn write_material(&self, surface: &Surface, words: &mut Words) {
        match surface {
            Surface::Shiny => words.name("of", "shiny"),
            Surface::Mirror => words.name("of", "mirror"),
            Surface::Of(number) => {
                let own = self.materials.get(usize::from(*number));
                words.name("of", own.map_or("opaque", |own| own.name.as_str()))
            }
            // All others are materials by now.
            _ => words,
        };
    }
}

fn quad_words(quad: &Quad, corners: [[f64; 3]; 4], one_sided: bool) -> Words {
    let mut words = Words::new("quad");
    words.numbers("", corners.as_flattened());
    if quad.patches != [1, 1] {
        words.numbers("patches", &quad.patches.map(f64::from));
    }
    words.maybe(quad.emitting, |words, part| words.numbers("emitting", &part));
    words.flag("one-sided", one_sided).take()
}
