//! What the rays of a pixel meet, as an observer of the tracer sees it.

use core::fmt::Write;

use rta_core::color::Rgb;
use rta_core::light::Incident;
use rta_core::material::Material;
use rta_core::ray::RayKind;
use rta_core::scene::{Hit, Object};
use rta_core::surface::Surface;
use rta_core::trace::Observer;
use rta_core::trace::decision::Start;
use rta_scenes::description::{Description, Kind};
use rta_scenes::narrow::{Narrow, Narrowed};

use crate::json;

/// Rays of a tree that are told one by one; of larger trees the others are counted.
const TOLD: usize = 256;

/// The rays of a pixel, whatever its number format.
#[derive(Clone, Debug, Default)]
pub(crate) struct Explanation {
    /// Linear light of the pixel.
    light: [f64; 3],
    /// Samples of the pixel.
    samples: u32,
    /// All rays: from the eye, reflected, transmitted, and to lamps.
    rays: [u32; 4],
    /// The rays of the tree in the order in which they are traced.
    steps: Vec<Step>,
}

/// A ray of the tree.
#[derive(Clone, Debug)]
struct Step {
    kind: RayKind,
    depth: u8,
    /// What it meets, none for the sky, and the name of its material.
    hit: Option<(Object, String)>,
    distance: Option<f64>,
    inside: bool,
    total_reflection: bool,
    /// Of each lamp that was asked about, the part of its light that arrives: 0 in shadow, none where it is behind the surface.
    lamps: Vec<Option<f64>>,
    /// Linear light that it brings into the pixel by itself.
    light: [f64; 3],
}

/// The observer that records the rays of a pixel.
pub(crate) struct Recorder<'a, S: Narrow> {
    scene: &'a Narrowed<S>,
    explanation: Explanation,
}

fn registers<S: Narrow>(light: Rgb<S::Light>) -> [f64; 3] {
    [light.r, light.g, light.b].map(S::light_to_f64)
}

impl<'a, S: Narrow> Recorder<'a, S> {
    /// For a pixel of a picture of a scene.
    pub(crate) fn new(scene: &'a Narrowed<S>) -> Self {
        Self { scene, explanation: Explanation::default() }
    }

    /// Returns what was recorded of a pixel with this light.
    pub(crate) fn explanation(self, light: Rgb<S::Light>, samples: u32) -> Explanation {
        Explanation { light: registers::<S>(light), samples, ..self.explanation }
    }

    /// Returns the name that the scene has for the material of a surface, or the word for its kind.
    fn material(&self, surface: &Surface<S>) -> String {
        let said = self.scene.said.get(usize::from(surface.number)).filter(|said| !said.name.is_empty());
        if let Some(said) = said {
            return said.name.clone();
        }
        match surface.material {
            Material::Opaque => kind(Kind::Opaque),
            Material::Shiny => kind(Kind::Shiny),
            Material::Mirror => kind(Kind::Mirror),
            Material::Transparent(_) => kind(Kind::Glass),
            Material::Finish(_) => "coefficients of its own",
        }
        .into()
    }

    fn last(&mut self) -> Option<&mut Step> {
        self.explanation.steps.last_mut()
    }
}

fn kind(kind: Kind) -> &'static str {
    match kind {
        Kind::Opaque => "opaque",
        Kind::Shiny => "shiny",
        Kind::Mirror => "mirror",
        Kind::Glass => "glass",
        Kind::Metal => "metal",
    }
}

impl<S: Narrow> Observer<S> for Recorder<'_, S> {
    fn ray(&mut self, kind: RayKind, depth: u8, _start: &Start<S>) {
        let [primary, reflected, transmitted, _] = &mut self.explanation.rays;
        match kind {
            RayKind::Primary => *primary += 1,
            RayKind::Reflected => *reflected += 1,
            RayKind::Transmitted => *transmitted += 1,
            RayKind::Shadow => {}
        }
        self.explanation.steps.push(Step {
            kind,
            depth,
            hit: None,
            distance: None,
            inside: false,
            total_reflection: false,
            lamps: Vec::new(),
            light: [0.0; 3],
        });
    }

    fn hit(&mut self, hit: Option<&Hit<S>>, surface: Option<&Surface<S>>) {
        let Some(hit) = hit else { return };
        let material = surface.map_or_else(|| "light".into(), |surface| self.material(surface));
        if let Some(step) = self.last() {
            step.hit = Some((hit.object, material));
            step.distance = surface.map(|surface| surface.distance.to_f64());
            step.inside = surface.is_some_and(|surface| surface.inside);
        }
    }

    fn shadow(&mut self, _lamp: usize, _start: &Start<S>) {
        let [.., shadow] = &mut self.explanation.rays;
        *shadow += 1;
    }

    fn lamp(&mut self, lamp: usize, _incident: &Incident<S>, light: Rgb<S::Light>, part: S::Unit) {
        let part = (light != Rgb::BLACK).then(|| S::unit_to_f64(part));
        if let Some(step) = self.last() {
            step.lamps.resize(lamp, None);
            step.lamps.push(part);
        }
    }

    fn light(&mut self, weighted: Rgb<S::Light>) {
        if let Some(step) = self.last() {
            step.light = registers::<S>(weighted);
        }
    }

    fn total_reflection(&mut self) {
        if let Some(step) = self.last() {
            step.total_reflection = true;
        }
    }
}

impl Explanation {
    /// Returns the explanation as JSON: `light`, linear; `color`, as the display shows it, and its `index`, both null before it is
    /// drawn; numbers of `rays`; and the `tree`, a list of rays with `kind`, `depth`, `text` and the `light` that each brings.
    pub(crate) fn json(&self, scene: &Description, shown: Option<(u8, Rgb<u8>)>) -> String {
        let light = |light: [f64; 3]| json::list(light.map(json::number));
        let color = |color: Rgb<u8>| json::list([color.r, color.g, color.b].map(|level| level.to_string()));
        let step = |step: &Step| {
            json::object([
                ("kind", json::text(step.name())),
                ("depth", step.depth.to_string()),
                ("text", json::text(&step.text())),
                ("line", json::or_null(step.line(scene), |line| line.to_string())),
                ("light", light(step.light)),
            ])
        };
        let [primary, reflected, transmitted, shadow] = self.rays.map(|rays| rays.to_string());
        let rays = [
            ("primary", primary),
            ("reflected", reflected),
            ("transmitted", transmitted),
            ("shadow", shadow),
        ];
        json::object([
            ("light", light(self.light)),
            ("samples", self.samples.to_string()),
            ("index", json::or_null(shown, |(index, _)| index.to_string())),
            ("color", json::or_null(shown, |(_, entry)| color(entry))),
            ("rays", json::object(rays)),
            ("tree", json::list(self.steps.iter().take(TOLD).map(step))),
            ("untold", self.steps.len().saturating_sub(TOLD).to_string()),
        ])
    }
}

impl Step {
    const fn name(&self) -> &'static str {
        match self.kind {
            RayKind::Primary => "primary",
            RayKind::Reflected => "reflected",
            RayKind::Transmitted => "transmitted",
            RayKind::Shadow => "shadow",
        }
    }

    /// Returns the line of the scene where the object that it meets begins.
    fn line(&self, scene: &Description) -> Option<u32> {
        self.hit.as_ref().and_then(|(object, _)| scene.line_of(*object))
    }

    /// Returns what the ray meets and how the lamps are seen from there, in words.
    fn text(&self) -> String {
        let Some((object, material)) = &self.hit else { return "the sky".into() };
        let mut text = object.to_string();
        // Writing to a string does not fail.
        let _ = write!(text, ", {material}");
        if let Some(distance) = self.distance {
            let _ = write!(text, ", at {distance:.4}");
        }
        if self.inside {
            text.push_str(", from inside");
        }
        if self.total_reflection {
            text.push_str(", total internal reflection");
        }
        for (number, lamp) in (1..).zip(&self.lamps) {
            let _ = match lamp {
                None => write!(text, "; lamp {number} gives none"),
                Some(0.0) => write!(text, "; lamp {number} in shadow"),
                Some(1.0) => write!(text, "; lamp {number} lit"),
                Some(part) => write!(text, "; lamp {number} lit by {part:.3}"),
            };
        }
        text
    }
}
