//! The tree of a pixel's cones: what each meets is shaded where the middle of its part is, and reflects and refracts cones of its own.

use rta_core::accelerator::Lists;
use rta_core::color::Rgb;
use rta_core::illumination::{Bend as Refraction, Illumination, Passage, Way, Weight};
use rta_core::light::Incident;
use rta_core::needs::Everything;
use rta_core::ray::RayKind;
use rta_core::scene::{Hit, Object};
use rta_core::surface::Surface;
use rta_core::trace::decision::{Branch, Start, ambient, branch, direct, refract, secondary};
use rta_core::trace::{Observer, Tracer};
use rta_core::vector::{LengthVector, UnitVec3};
use rta_core::world::Seen;
use rta_packets::picture::MAX_DEPTH;
use rta_scenes::shading::AnyModel;

use super::beam::{Beam, Bend};
use super::curvature::curvature;
use super::gloss::{self, Lobe};
use super::hits::{Left, Search};
use super::order::Met;
use super::tiles::odd_part;

/// The tracer that shades what cones meet.
pub type Shader<'s> = Tracer<'s, f64, AnyModel<f64>, Everything, { MAX_DEPTH as usize }, Lists>;

/// The side of the floor's tiles where the scene says no other.
const TILE: f64 = 3.0;

/// The least part of a pixel for which a cone is followed: a tenth of a level of 8 bits.
const LEAST: f64 = 1.0 / 2550.0;

/// A picture's cones.
pub struct Cones<'s> {
    /// The scene.
    pub search: Search<'s>,
    /// What shades its surfaces.
    pub shader: &'s Shader<'s>,
    /// Roughness of the materials, in their order as far as any is rough.
    pub roughness: &'s [f64],
}

/// A cone that is still to be followed.
struct Pending {
    beam: Beam,
    branch: Branch<Rgb<f64>>,
    /// The part of the pixel that it is for.
    part: f64,
    /// What it has just left.
    left: Option<Left>,
}

impl Cones<'_> {
    /// Returns the light of a cone with all that it is reflected and refracted to.
    pub fn light<O: Observer<f64> + ?Sized>(&self, beam: Beam, observer: &mut O) -> Rgb<f64> {
        let mut light = Rgb::BLACK;
        let mut pending = vec![Pending { beam, branch: Branch::eye::<f64>(), part: 1.0, left: None }];
        while let Some(next) = pending.pop() {
            let own = self.follow(&next, &mut pending, observer);
            let own = own.map(|light| light * next.part);
            observer.light(own);
            light = light.plus(own);
        }
        light
    }

    /// Returns the light of a cone without those that it spawns, which are added to those that are still to be followed.
    fn follow<O: Observer<f64> + ?Sized>(
        &self,
        cone: &Pending,
        pending: &mut Vec<Pending>,
        observer: &mut O,
    ) -> Rgb<f64> {
        let hits = self.search.hits(&cone.beam, cone.left);
        let mut light = Rgb::BLACK;
        for met in &hits.met {
            light = light.plus(self.met(cone, met, pending, observer).map(|light| light * met.seen));
        }
        if hits.left > 0.0 {
            let start = Start { origin: cone.beam.origin, direction: cone.beam.axis };
            observer.ray(cone.branch.kind, cone.branch.depth, &start);
            observer.hit(None, None);
            let sky = self.search.world.scene.radiance::<Everything>(start.direction);
            let (sky, _) = self.along(&cone.branch, start, (None, None), sky);
            light = light.plus(sky.map(|light| light * hits.left));
        }
        light
    }

    /// Returns the light of a thing that a cone meets, as if it covered all of it.
    fn met<O: Observer<f64> + ?Sized>(
        &self,
        cone: &Pending,
        met: &Met,
        pending: &mut Vec<Pending>,
        observer: &mut O,
    ) -> Rgb<f64> {
        let world = self.search.world;
        let start = Start { origin: met.ray.origin, direction: met.ray.direction };
        observer.ray(cone.branch.kind, cone.branch.depth, &start);
        let hit = Hit { distance: met.distance, object: met.object };
        let mut surface = match world.seen::<Everything>(&met.ray, Some(hit)) {
            Seen::Light(own) => {
                observer.hit(Some(&hit), None);
                return self.along(&cone.branch, start, (Some(met.distance), None), own).0;
            }
            Seen::Surface(surface) => surface,
        };
        if let (Object::Floor, Some(floor)) = (met.object, &world.scene.floor) {
            let [even, odd] = floor.colors;
            let part = odd_part(&cone.beam, floor.tile.unwrap_or(TILE));
            surface.color = even.zip(odd, |even, odd| even + (odd - even) * part);
        }
        world.cover::<Everything>(&mut surface, met.object, cone.branch.kind);
        observer.hit(Some(&hit), Some(&surface));
        let own = world.shining::<Everything>(self.shaded(&surface, met.object, observer), Some(&surface));
        let (light, branch) = self.along(&cone.branch, start, (Some(met.distance), Some(&surface)), own);
        let (_, _, depth, _) = self.shader.parts();
        let part = cone.part * met.seen;
        if branch.depth < depth && part >= LEAST {
            let parent = Pending { beam: cone.beam, branch, part, left: None };
            return light.plus(self.spawn(&parent, met, &surface, pending, observer));
        }
        light
    }

    /// Returns the part of the light of a ray that arrives in the pixel, with what it gains and loses on its way, and the branch with what it
    /// loses.
    fn along(
        &self,
        branch: &Branch<Rgb<f64>>,
        start: Start<f64>,
        (length, surface): (Option<f64>, Option<&Surface<f64>>),
        own: Rgb<f64>,
    ) -> (Rgb<f64>, Branch<Rgb<f64>>) {
        let (_, model, ..) = self.shader.parts();
        let lamps = self.search.world.scene.lamps;
        let way = Way { kind: branch.kind, start, length, surface, shift: None, lamps };
        let lit = |place, lamp| self.shader.reached(place, lamp, &mut ());
        match model.along::<Everything>(&way, lit) {
            Some(Passage { weight, veil }) => {
                let left = Branch { weight: times(branch.weight, weight), ..*branch };
                (times(left.weight, own).plus(times(branch.weight, veil)), left)
            }
            None => (times(branch.weight, own), *branch),
        }
    }

    /// Returns the light that a surface sends back of lamps and ambient light. Lamps with a radius are asked by cones.
    fn shaded<O: Observer<f64> + ?Sized>(
        &self,
        surface: &Surface<f64>,
        object: Object,
        observer: &mut O,
    ) -> Rgb<f64> {
        let (scene, model, ..) = self.shader.parts();
        let mut light = ambient::<f64, _, Everything>(model, surface, scene.scene.ambient);
        if !model.is_lit::<Everything>(surface) {
            return light;
        }
        for (number, lamp) in scene.scene.lamps.iter().enumerate() {
            if lamp.radius > 0.0 {
                let from = (surface, Some(object));
                let own = self.shader.cone_light(from, (number, lamp), self.search.bodies, observer);
                light = light.plus(own);
            } else if let Some(incident) = Incident::new(lamp, surface.point, surface.normal) {
                let unhidden = direct::<f64, _, Everything>(model, surface, &incident);
                let part = self.shader.unshadowed(surface, &incident, unhidden, number, &mut (), observer);
                observer.lamp(number, &incident, unhidden, part);
                light = light.plus(unhidden.map(|light| light * part));
            }
        }
        light
    }

    /// Adds the cones that a surface reflects and refracts to those that are to be followed. Returns the light of those that see the sky alone.
    fn spawn<O: Observer<f64> + ?Sized>(
        &self,
        parent: &Pending,
        met: &Met,
        surface: &Surface<f64>,
        pending: &mut Vec<Pending>,
        observer: &mut O,
    ) -> Rgb<f64> {
        let (_, model, _, cutoff) = self.shader.parts();
        let side = surface.side::<Everything>();
        let start = |direction: UnitVec3<f64>, leaves: bool| {
            let direction = surface.fold::<Everything>(direction, leaves);
            let (origin, _) =
                surface.point.leave(if leaves { side } else { -side }, direction, surface.extent);
            Start { origin, direction }
        };
        let roughness = self.roughness.get(usize::from(surface.number)).copied().filter(|own| *own > 0.0);
        let mirrored = roughness.map(|roughness| gloss::reflected(surface, roughness));
        let through = roughness.map(|roughness| gloss::refracted(surface, roughness));
        let reflected = || {
            let lobe = mirrored.flatten().map(|lobe| lobe.axis);
            start(lobe.unwrap_or_else(|| surface.incoming.reflect(surface.normal)), true)
        };
        let mut is_total = false;
        let refracted = |glass: &_| {
            let direction = match through {
                Some(lobe) => lobe.map(|lobe| lobe.axis),
                None => refract(surface, glass),
            };
            is_total = direction.is_none();
            direction.map(|direction| start(direction, false))
        };
        let straight = || start(surface.incoming, false);
        let mut weights = secondary::<f64, _, Everything>(model, surface);
        let dimmed = |weight: Rgb<f64>, lobe: Option<Option<Lobe>>| match lobe {
            Some(lobe) => weight.map(|weight| weight * lobe.map_or(0.0, |lobe| lobe.part)),
            None => weight,
        };
        weights.reflected = weights.reflected.map(|weight| dimmed(weight, mirrored));
        if weights.bend == Refraction::Refracted && through.flatten().is_some() {
            weights.transmitted = weights.transmitted.map(|weight| dimmed(weight, through));
        }
        let place = (&parent.branch, cutoff);
        let spawned = branch::<f64, _, Everything>(weights, surface, place, reflected, refracted, straight);
        if is_total {
            observer.total_reflection();
        }
        let mut sky = Rgb::BLACK;
        for (branch, start) in spawned.into_iter().flatten() {
            if branch.kind == RayKind::Reflected && surface.surroundings {
                let own = self.search.world.scene.radiance::<Everything>(start.direction);
                sky = sky.plus(times(branch.weight, own));
                continue;
            }
            observer.spawned(&|cutoff| !<_ as Weight<f64>>::is_below(branch.weight, cutoff));
            let eta = (branch.kind == RayKind::Transmitted).then(|| match weights.bend {
                Refraction::Refracted => relative_index(surface),
                Refraction::Straight => 1.0,
            });
            let lobe = if eta.is_some() { through } else { mirrored };
            let gloss = lobe.flatten().filter(|_| eta != Some(1.0)).map_or(0.0, |lobe| lobe.width);
            let bend = self.bend(met.object, surface, (eta, start.direction, gloss));
            let beam = parent.beam.after(met.along, bend, start.origin, start.direction);
            // What is convex is not met again from outside, and what is flat from neither side.
            let is_outside = (branch.kind == RayKind::Reflected) != surface.inside;
            let is_flat = matches!(met.object, Object::Floor | Object::Plane(_) | Object::Triangle(_));
            let left = (is_outside || is_flat).then_some(Left { object: met.object, is_outside });
            pending.push(Pending { beam, branch, part: parent.part, left });
        }
        sky
    }

    /// Returns what a surface does with the cone that it sends into a direction, widened by `gloss` radians; a refracted one with the index of
    /// refraction where it comes from over that where it goes.
    fn bend(
        &self,
        object: Object,
        surface: &Surface<f64>,
        (eta, direction, gloss): (Option<f64>, UnitVec3<f64>, f64),
    ) -> Bend {
        let curvature = curvature(&self.search.world.scene, object, surface.point);
        let curvature = if surface.inside { -curvature } else { curvature };
        let cosine = -surface.normal.dot(surface.incoming);
        let refracted = eta.map(|eta| (eta, -surface.normal.dot(direction)));
        Bend { curvature, cosine, refracted, gloss }
    }
}

/// Returns the product, register by register.
fn times(weight: Rgb<f64>, other: Rgb<f64>) -> Rgb<f64> {
    weight.zip(other, |weight, other| weight * other)
}

/// Returns the index of refraction where a ray comes from that meets a surface, over that behind it.
fn relative_index(surface: &Surface<f64>) -> f64 {
    surface.material.glass::<Everything>().map_or(1.0, |glass| {
        let is_from_denser = surface.inside == glass.denser;
        if is_from_denser { 1.0 / glass.eta } else { glass.eta }
    })
}
