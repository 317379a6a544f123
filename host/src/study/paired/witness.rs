//! The model of illumination that looks on: it passes everything to another one and notes the branches.

use core::ptr;
use std::sync::{Mutex, MutexGuard, PoisonError};

use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, RayKind, Secondary, Surface};
use rta_core::light::Incident;
use rta_core::material::Material;
use rta_core::needs::Needs;
use rta_core::scalar::{Light, Scalar};
use rta_core::scene::{Object, Scene};
use rta_core::trace::refract;
use rta_scenes::narrow::Narrow;

use super::ray_tree::{HitKind, RayTree, Step, Visibility};
use super::{Value, log};

/// A scalar whose quantities can be read; paired ones too.
pub(super) trait Readable: Value + Narrow<Unit: Value, Light: Value> {}
impl<S: Value + Narrow<Unit: Value, Light: Value>> Readable for S {}

/// What has been seen of a pixel so far.
#[derive(Debug, Default)]
pub(super) struct Notes {
    pub(super) trail: RayTree,
    /// Depths of the rays that are to come, the next one last.
    expected: Vec<u8>,
    /// The lamp that the model was asked about last.
    lamp: usize,
}

impl Notes {
    /// How the lamp shines that the model was asked about last.
    fn shine(&mut self) -> Option<&mut Visibility> {
        self.trail.steps.last_mut()?.lamps.get_mut(self.lamp)
    }
}

/// A lock that is never left behind in the middle of a change.
pub(super) fn lock(notes: &Mutex<Notes>) -> MutexGuard<'_, Notes> {
    notes.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A model that passes everything on and takes notes. Without a contribution cut-off, that is all of the ray tree.
pub(super) struct Witness<'a, S: Scalar, M> {
    pub(super) model: M,
    pub(super) scene: Scene<'a, S>,
    pub(super) notes: &'a Mutex<Notes>,
}

impl<S: Readable, M> Witness<'_, S, M> {
    /// The object to which a surface belongs, told by where its material is.
    fn object(&self, surface: &Surface<S>) -> HitKind {
        let is = |material| ptr::eq(material, surface.material);
        let scene = &self.scene;
        if let Some(i) = scene.spheres.iter().position(|s| is(&s.material)) {
            HitKind::Object(Object::Sphere(i))
        } else if let Some(i) = scene.ellipsoids.iter().position(|e| is(&e.material)) {
            HitKind::Object(Object::Ellipsoid(i))
        } else if let Some(i) = scene.cylinders.iter().position(|c| is(&c.material)) {
            HitKind::Object(Object::Cylinder(i))
        } else if let Some(i) = scene.cones.iter().position(|c| is(&c.material)) {
            HitKind::Object(Object::Cone(i))
        } else if let Some(i) = scene.triangles.iter().position(|t| is(&t.material)) {
            HitKind::Object(Object::Triangle(i))
        } else {
            let even = scene.floor.as_ref().map(|floor| values::<S>(floor.colors[0]));
            HitKind::Floor { odd: even != Some(values::<S>(surface.color)) }
        }
    }
}

/// A colour as numbers that can be compared without being recorded.
fn values<S: Readable>(color: Rgb<S::Unit>) -> Rgb<f64> {
    color.map(Value::value)
}

impl<S: Readable, M: Illumination<S>> Illumination<S> for Witness<'_, S, M> {
    type Weight = M::Weight;
    const BOTH_SIDES: bool = M::BOTH_SIDES;

    fn note(&self, kind: RayKind) {
        self.model.note(kind);
        if kind == RayKind::Shadow {
            return;
        }
        let mut notes = lock(self.notes);
        let depth = notes.expected.pop().unwrap_or(0);
        log::enter(notes.trail.steps.len());
        notes.trail.steps.push(Step {
            kind,
            depth,
            hit: HitKind::Sky,
            distance: None,
            inside: false,
            total_reflection: false,
            lamps: Vec::new(),
        });
    }

    fn note_light(&self, light: Rgb<S::Light>) {
        self.model.note_light(light);
        let same = |radiance: Rgb<S::Light>| radiance.map(Value::value) == light.map(Value::value);
        let mut lamps = self.scene.lamps.iter();
        let lamp = log::pause(|| lamps.position(|l| l.radius.value() > 0.0 && same(l.radiance())));
        if let (Some(i), Some(step)) = (lamp, lock(self.notes).trail.steps.last_mut()) {
            step.hit = HitKind::Object(Object::Lamp(i));
        }
    }

    fn ambient<N: Needs>(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        let lamps = if self.model.is_lit::<N>(surface) { self.scene.lamps.len() } else { 0 };
        if let Some(step) = lock(self.notes).trail.steps.last_mut() {
            step.hit = self.object(surface);
            step.distance = Some(surface.distance.value());
            step.inside = surface.inside;
            step.lamps = vec![Visibility::Behind; lamps];
        }
        self.model.ambient::<N>(surface, ambient)
    }

    fn is_lit<N: Needs>(&self, surface: &Surface<S>) -> bool {
        self.model.is_lit::<N>(surface)
    }

    fn direct<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light> {
        let light = self.model.direct::<N>(surface, incident);
        let values = light.map(Value::value);
        // A cut-out highlight is the lamp's own intensity.
        let glint = matches!(surface.material, Material::Shiny)
            && values
                == log::pause(|| incident.lamp.tint.map(|part| incident.intensity().times(part)))
                    .map(Value::value);
        let mut notes = lock(self.notes);
        notes.lamp = self.scene.lamps.iter().position(|l| ptr::eq(l, incident.lamp)).unwrap_or(usize::MAX);
        if let Some(shine) = notes.shine() {
            let is_dark = values == Rgb::new(0.0, 0.0, 0.0);
            *shine = if is_dark { Visibility::Faint } else { Visibility::Front { part: 1.0, glint } };
        }
        light
    }

    fn note_shadow(&self, through: S::Unit) {
        self.model.note_shadow(through);
        if let Some(Visibility::Front { part, .. }) = lock(self.notes).shine() {
            *part = through.value();
        }
    }

    fn secondary<N: Needs>(&self, surface: &Surface<S>) -> Secondary<M::Weight> {
        let secondary = self.model.secondary::<N>(surface);
        let through = match (surface.material, secondary.transmitted) {
            (Material::Transparent(glass), Some(_)) => Some(log::pause(|| refract(surface, glass)).is_some()),
            _ => None,
        };
        let children = match through {
            Some(true) => 1 + usize::from(secondary.reflected.is_some()),
            Some(false) => 1,
            None => usize::from(secondary.reflected.is_some()),
        };
        let mut notes = lock(self.notes);
        if let Some(step) = notes.trail.steps.last_mut() {
            step.total_reflection = through == Some(false);
            let depth = step.depth + 1;
            notes.expected.extend(core::iter::repeat_n(depth, children));
        }
        secondary
    }
}
