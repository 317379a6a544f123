//! Scenes for POV-Ray 3.7: the same things before the same eye, which take it the same rays. Shading is as near as its
//! own models come.
//!
//! [`lit`] are rooms in which something emits, [`mod@spread`] is what spreads rays.
//!
//! Coordinates need no change: POV-Ray's left hand shows in its usual camera alone, and this one is given by its vectors.

use core::fmt::Write;
use std::collections::HashMap;

use rta_core::vector::Vector;
use rta_scenes::description::{self, Cone, Description, Kind, Lamp, Material, Surface, Triangle};
use rta_scenes::narrow::narrow;

use crate::engine::{EngineError, Model};

mod light;
pub mod lit;
pub mod spread;

use light::Light;
use lit::Radiosity;
use spread::{Ball, Spread};

/// Half of a vertical cylinder, which has no end in rta.
const REACH: f64 = 1000.0;

/// The scene, for a screen of the shape `aspect : 1`.
///
/// # Errors
/// None that a scene which can be traced has.
pub fn scene(scene: &Description, model: Model, depth: u32, aspect: f64) -> Result<String, EngineError> {
    written(scene, model, (depth, aspect), Light::Still)
}

/// Like [`scene`], with lamps that have a size and a lens.
///
/// # Errors
/// Those of [`scene`].
pub fn spread_scene(
    scene: &Description,
    model: Model,
    screen: (u32, f64),
    spread: &Spread,
) -> Result<String, EngineError> {
    written(scene, model, screen, Light::Spread(spread))
}

/// Like [`scene`], with lamps that have the size of what emits, and POV-Ray's own light that goes round.
///
/// # Errors
/// Those of [`scene`].
pub fn lit_scene(
    scene: &Description,
    model: Model,
    screen: (u32, f64),
    radiosity: &Radiosity,
) -> Result<String, EngineError> {
    written(&lit::lit(scene), model, screen, Light::Round(radiosity))
}

fn written(
    scene: &Description,
    model: Model,
    (depth, aspect): (u32, f64),
    light: Light,
) -> Result<String, EngineError> {
    let mut file = File {
        text: String::new(),
        materials: HashMap::new(),
        model,
        ambient: scene.ambient,
        named: &scene.materials,
        light,
    };
    // Depth 0 is the eye's own ray. Nothing is left out for bringing little light.
    let level = depth + 1;
    let round = light.round().map(Radiosity::settings).unwrap_or_default();
    file.line(format_args!(
        "#version 3.7;\nglobal_settings {{ assumed_gamma 1 max_trace_level {level} adc_bailout 0 ambient_light rgb 1{round} }}"
    ));
    file.camera(scene, aspect)?;
    file.sky(scene);
    for (number, lamp) in scene.lamps.iter().enumerate() {
        match light.places().zip(scene.details.lamps.get(&number)) {
            Some((places, shape)) => file.area_lamp(lamp, shape, places),
            None => file.lamp(lamp),
        }
    }
    if let Some(floor) = &scene.floor {
        let [even, odd] = floor.colors.map(vector);
        let ambient = vector(file.ambient);
        // The pattern is of cubes: the plane cuts through their middles.
        let tile = scene.details.tile.unwrap_or(3.0);
        let half = tile / 2.0;
        file.line(format_args!(
            "plane {{ z, 0 pigment {{ checker rgb {even} rgb {odd} scale {tile} translate <0, 0, -{half}> }} \
             finish {{ ambient rgb {ambient} diffuse 1 }} }}"
        ));
    }
    file.objects(scene);
    Ok(file.text)
}

/// A scene file that grows.
struct File<'a> {
    text: String,
    /// The numbers of those that are declared.
    materials: HashMap<String, usize>,
    model: Model,
    ambient: [f64; 3],
    named: &'a [Material],
    light: Light<'a>,
}

impl File<'_> {
    fn line(&mut self, line: core::fmt::Arguments) {
        // A String takes all that is written to it.
        let _ = writeln!(self.text, "{line}");
    }

    fn camera(&mut self, scene: &Description, aspect: f64) -> Result<(), EngineError> {
        let seen = Description { optics: scene.optics.clone(), ..Description::empty(scene.camera.clone()) };
        let narrowed = narrow::<f64>(&seen, aspect)?;
        let lens = self.lens(&narrowed, self.light.spread());
        let camera = narrowed.camera;
        let eye = vector([camera.eye.x(), camera.eye.y(), camera.eye.z()]);
        let [forward, right, up] =
            [camera.forward, camera.right, camera.up].map(|v| vector([v.x(), v.y(), v.z()]));
        self.line(format_args!(
            "camera {{ perspective location {eye} direction {forward} right {right} up {up}{lens} }}"
        ));
        Ok(())
    }

    fn sky(&mut self, scene: &Description) {
        let [horizon, zenith] = [scene.sky.horizon, scene.sky.zenith].map(vector);
        if horizon == zenith {
            self.line(format_args!("background {{ rgb {horizon} }}"));
        } else {
            self.line(format_args!(
                "sky_sphere {{ pigment {{ gradient z poly_wave 2 color_map {{ [0 rgb {horizon}] [1 rgb {zenith}] }} }} }}"
            ));
        }
    }

    fn lamp(&mut self, lamp: &Lamp) {
        let place = vector(lamp.position);
        let size = self.light.spread().map(|spread| Ball(lamp, spread).to_string()).unwrap_or_default();
        if self.model.is_attenuated() {
            // Its law is 2 / (1 + d^2).
            let half = vector(lamp.color.map(|register| register / 2.0));
            self.line(format_args!(
                "light_source {{ {place} rgb {half} fade_distance 1 fade_power 2{size} }}"
            ));
        } else {
            let color = vector(lamp.color.map(|register| register.min(1.0)));
            self.line(format_args!("light_source {{ {place} rgb {color}{size} }}"));
        }
        if lamp.radius > 0.0 {
            let seen = vector(lamp.color.map(|register| register / (lamp.radius * lamp.radius)));
            let radius = lamp.radius;
            self.line(format_args!(
                "sphere {{ {place}, {radius} no_shadow pigment {{ rgb {seen} }} \
                 finish {{ ambient 0 diffuse 0 emission 1 }} }}"
            ));
        }
    }

    fn objects(&mut self, scene: &Description) {
        for c in &scene.cylinders {
            let ([x, y, _], radius) = (c.position, c.radius);
            let material = self.material(c.color, &c.surface);
            self.line(format_args!(
                "cylinder {{ <{x:?}, {y:?}, {:?}>, <{x:?}, {y:?}, {REACH:?}>, {radius:?} open {material} }}",
                -REACH
            ));
        }
        for e in &scene.ellipsoids {
            let (place, radii) = (vector(e.position), vector(e.radii));
            let material = self.material(e.color, &e.surface);
            self.line(format_args!("sphere {{ 0, 1 scale {radii} translate {place} {material} }}"));
        }
        for s in &scene.spheres {
            let (place, radius) = (vector(s.position), s.radius);
            let material = self.material(s.color, &s.surface);
            self.line(format_args!("sphere {{ {place}, {radius:?} {material} }}"));
        }
        for cone in &scene.cones {
            self.cone(cone);
        }
        // What looks alike is one mesh, which POV-Ray walks soonest.
        for alike in scene.triangles.chunk_by(|a, b| (a.color, a.surface) == (b.color, b.surface)) {
            self.mesh(alike);
        }
    }

    fn cone(&mut self, cone: &Cone) {
        let Cone { base_radius, apex_radius, capped, .. } = *cone;
        let (base, apex, open) = (vector(cone.base), vector(cone.apex), if capped { "" } else { "open " });
        let material = self.material(cone.color, &cone.surface);
        #[expect(clippy::float_cmp, reason = "a cylinder is a cone whose radii are equal")]
        if base_radius == apex_radius {
            self.line(format_args!("cylinder {{ {base}, {apex}, {base_radius:?} {open}{material} }}"));
        } else {
            self.line(format_args!(
                "cone {{ {base}, {base_radius:?}, {apex}, {apex_radius:?} {open}{material} }}"
            ));
        }
    }

    fn mesh(&mut self, alike: &[Triangle]) {
        let Some(first) = alike.first() else { return };
        let mut material = self.material(first.color, &first.surface);
        if let Some(light) = self.emission(&first.surface) {
            // Its light comes by its lamp.
            let light = vector(light);
            material = format!(
                "no_shadow no_radiosity pigment {{ rgb 1 }} finish {{ ambient 0 diffuse 0 emission rgb {light} }}"
            );
        }
        self.line(format_args!("mesh {{"));
        for triangle in alike {
            let [a, b, c] = triangle.vertices.map(vector);
            match triangle.normals.map(|normals| normals.map(vector)) {
                None => self.line(format_args!("triangle {{ {a}, {b}, {c} }}")),
                Some([u, v, w]) => {
                    self.line(format_args!("smooth_triangle {{ {a}, {u}, {b}, {v}, {c}, {w} }}"));
                }
            }
        }
        self.line(format_args!("{material} }}"));
    }

    /// The name of a material, which is declared when it is first used.
    fn material(&mut self, color: [f64; 3], surface: &Surface) -> String {
        let words = self.words(color, surface);
        let next = self.materials.len();
        let number = *self.materials.entry(words.clone()).or_insert(next);
        if number == next {
            self.line(format_args!("#declare M{number} = material {{ {words} }}"));
        }
        format!("material {{ M{number} }}")
    }

    /// Returns a surface that does not refer to a material with a name.
    fn stated(&self, surface: &Surface) -> Surface {
        if !matches!(surface, Surface::Of(_)) {
            return *surface;
        }
        let material = Material::of(surface, self.named);
        match (material.coefficients(), material.kind) {
            (Some(description::Coefficients { kd, ks, kt, exponent, index: ior, .. }), _) => {
                Surface::Finish { kd, ks, exponent, kt, ior }
            }
            (None, Kind::Shiny) => Surface::Shiny,
            (None, Kind::Mirror) => Surface::Mirror,
            (None, _) => Surface::Opaque,
        }
    }

    fn words(&self, color: [f64; 3], surface: &Surface) -> String {
        let surface = &self.stated(surface);
        let Coefficients { diffuse, highlight, exponent, reflection, kt, ior } =
            Coefficients::of(color, surface, self.model);
        // The thesis's ambient term on a surface that stands upright.
        let part = if self.model == Model::Rta { 0.6 } else { 1.0 };
        let ambient = vector(self.ambient.map(|register| part * diffuse * register));
        let (color, reflection) = (vector(color), vector(reflection));
        // An exponent of NFF may be beyond what a highlight can be seen with.
        let exponent = exponent.clamp(1.0, 1e5);
        let interior = if kt > 0.0 { format!(" interior {{ ior {ior:?} }}") } else { String::new() };
        format!(
            "texture {{ pigment {{ rgb {color} transmit {kt:?} }} finish {{ ambient rgb {ambient} diffuse {diffuse:?} \
             phong {highlight:?} phong_size {exponent:?} reflection {{ rgb {reflection} }} }} }}{interior}"
        )
    }
}

/// The coefficients of a surface in POV-Ray's terms.
struct Coefficients {
    diffuse: f64,
    highlight: f64,
    exponent: f64,
    reflection: [f64; 3],
    kt: f64,
    ior: f64,
}

impl Coefficients {
    fn of(color: [f64; 3], surface: &Surface, model: Model) -> Self {
        let dark =
            Self { diffuse: 0.0, highlight: 0.0, exponent: 50.0, reflection: [0.0; 3], kt: 0.0, ior: 1.0 };
        // Only the thesis's mirrors have a colour.
        let mirror =
            |ks: f64| if model == Model::Rta { color.map(|register| ks * register) } else { [ks; 3] };
        match *surface {
            Surface::Opaque | Surface::Of(_) => Self { diffuse: 1.0, ..dark },
            Surface::Shiny => Self { diffuse: 1.0, highlight: 1.0, ..dark },
            Surface::Mirror => Self { reflection: mirror(1.0), ..dark },
            Surface::Transparent { ks, kt, ior } => Self { reflection: mirror(ks), kt, ior, ..dark },
            Surface::Finish { kd, ks, exponent, kt, ior } => {
                // What lets light through shades that much less in POV-Ray.
                let diffuse = if kt < 1.0 { kd / (1.0 - kt) } else { 0.0 };
                Self { diffuse, highlight: ks, exponent, reflection: mirror(ks), kt, ior }
            }
        }
    }
}

fn vector(v: [f64; 3]) -> String {
    let [x, y, z] = v;
    format!("<{x:?}, {y:?}, {z:?}>")
}

#[cfg(test)]
mod tests;
