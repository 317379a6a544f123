//! The observer that records the ray tree of a pixel.

use rta_core::color::Rgb;
use rta_core::light::Incident;
use rta_core::material::Material;
use rta_core::ray::RayKind;
use rta_core::scalar::Light;
use rta_core::scene::{Hit, Object, Scene};
use rta_core::surface::Surface;
use rta_core::trace::Observer;
use rta_core::trace::decision::Start;
use rta_scenes::shading::Shade;

use crate::ray_tree::{HitKind, RayTree, Step, Visibility};
use crate::{Value, log};

/// A number format whose quantities can be read; paired ones too.
pub trait Readable: Value + Shade<Unit: Value, Light: Value> {}
impl<S: Value + Shade<Unit: Value, Light: Value>> Readable for S {}

/// Records the ray tree of one pixel after the other.
#[derive(Debug, Default)]
pub(super) struct Recorder {
    pub(super) tree: RayTree,
    /// The floor's first colour.
    even: Option<Rgb<f64>>,
    /// Whether highlights are cut out of the surface that was met last.
    is_shiny: bool,
}

impl Recorder {
    /// For pictures of a scene.
    pub(super) fn new<S: Readable>(scene: &Scene<S>) -> Self {
        let even = scene.floor.as_ref().map(|floor| floor.colors[0].map(Value::value));
        Self { even, ..Self::default() }
    }
}

impl<S: Readable> Observer<S> for Recorder {
    fn ray(&mut self, kind: RayKind, depth: u8, _start: &Start<S>) {
        log::enter(self.tree.steps.len());
        self.tree.steps.push(Step {
            kind,
            depth,
            hit: HitKind::Sky,
            distance: None,
            inside: false,
            total_reflection: false,
            lamps: Vec::new(),
        });
    }

    fn hit(&mut self, hit: Option<&Hit<S>>, surface: Option<&Surface<S>>) {
        let (Some(hit), Some(step)) = (hit, self.tree.steps.last_mut()) else { return };
        step.hit = HitKind::Object(hit.object);
        let Some(surface) = surface else { return };
        if hit.object == Object::Floor {
            step.hit = HitKind::Floor { odd: self.even != Some(surface.color.map(Value::value)) };
        }
        step.distance = Some(surface.distance.value());
        step.inside = surface.inside;
        self.is_shiny = matches!(surface.material, Material::Shiny);
    }

    fn lamp(&mut self, lamp: usize, incident: &Incident<S>, light: Rgb<S::Light>, part: S::Unit) {
        let values = light.map(Value::value);
        let is_dark = values == Rgb::new(0.0, 0.0, 0.0);
        let visibility = if is_dark && incident.cosine.value() <= 0.0 {
            Visibility::Behind
        } else if is_dark {
            Visibility::Faint
        } else {
            // A cut-out highlight is the lamp's own intensity.
            let intensity = || incident.lamp.tint.map(|part| incident.intensity().times(part));
            let glint = self.is_shiny && values == log::pause(intensity).map(Value::value);
            Visibility::Front { part: part.value(), glint }
        };
        if let Some(step) = self.tree.steps.last_mut() {
            step.lamps.resize(lamp, Visibility::Behind);
            step.lamps.push(visibility);
        }
    }

    fn total_reflection(&mut self) {
        if let Some(step) = self.tree.steps.last_mut() {
            step.total_reflection = true;
        }
    }
}
