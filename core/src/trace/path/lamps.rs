//! The light of lamps at a point of a path: by shadow rays, and by paths that meet them.

use super::Paths;
use super::lobes::{DIFFUSE, Left, Lobes, REFLECTED, scaled};
use crate::accelerator::Accelerator;
use crate::color::Rgb;
use crate::illumination::Illumination;
use crate::illumination::microfacet::{Facet, Sight};
use crate::light::area::Glimpse;
use crate::light::{Incident, Lamp};
use crate::needs::{Needs, Opaque};
use crate::sampling::pairs::Purpose;
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3};
use crate::scalar::{Light, Positive, Scalar, Unit};
use crate::scene::index;
use crate::surface::Surface;
use crate::trace::Observer;
use crate::trace::decision::casts_shadow_ray;
use crate::trace::dice::Thrown;
use crate::trace::lamps::shadow_start;

/// How lamps are asked at the points that a path meets.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Asked {
    /// None is: the light of those that have a size is found where a path meets them, that of points is not.
    None,
    /// One of them by chance, each as often as the others.
    #[default]
    One,
    /// Each.
    All,
}

/// A lamp that is a parallelogram and is also two triangles whose material emits its light, so that paths meet it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Emitter<S: Scalar> {
    /// The number of the lamp, from 0.
    pub lamp: u32,
    /// The number of the first of the triangles, from 0; the other follows it.
    pub triangle: u32,
    /// The area of the lamp, above 0.
    pub area: S::Power,
}

/// How a lamp is found.
enum Found<'e, S: Scalar> {
    /// By shadow rays alone, as nothing of it is met.
    Unseen,
    /// As a sphere. Its light may be none that a sphere of its brightness would send.
    Sphere { is_sent: bool },
    /// As a parallelogram.
    Square(&'e Emitter<S>),
}

fn pi<P: Positive>() -> P {
    P::new(0xc90f_daa2_2168_c235, -62)
}

impl<'a, S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize, A: Accelerator<S>>
    Paths<'a, S, M, N, STACK, A>
{
    /// Returns the lamp of which a triangle is a part.
    pub(super) fn emitter_of(&self, triangle: u32) -> Option<&'a Emitter<S>> {
        let after = self.emitters.partition_point(|emitter| emitter.triangle <= triangle);
        let emitter = self.emitters.get(after.checked_sub(1)?)?;
        (triangle - emitter.triangle < 2).then_some(emitter)
    }

    fn found(&self, number: u32, lamp: &Lamp<S>) -> Found<'a, S> {
        let place = self.emitters.binary_search_by_key(&number, |emitter| emitter.lamp);
        match place.ok().and_then(|place| self.emitters.get(place)) {
            Some(emitter) if N::EMISSION => Found::Square(emitter),
            _ if N::VISIBLE_LAMPS && lamp.radius > S::ZERO => {
                let is_sent = N::ATTENUATION && lamp.fall_off.fades(self.spread.tracer.model.fades());
                Found::Sphere { is_sent }
            }
            _ => Found::Unseen,
        }
    }

    /// Returns how many lamps shine.
    pub(super) fn count(&self) -> usize {
        let lamps = self.spread.tracer.scene.scene.lamps;
        if N::LAMPS { lamps.len().min(if N::SEVERAL_LAMPS { usize::MAX } else { 1 }) } else { 0 }
    }

    /// Returns the chance with which a lamp is asked, as the number by which it is divided.
    fn among(&self) -> S::Power {
        let count = if self.rules.lamps == Asked::One { self.count() } else { 1 };
        S::Power::new(u64::try_from(count).unwrap_or(1), 0)
    }

    /// Returns the radiance that a surface sends back of the lamps that are asked, over their chance.
    pub(super) fn lit<O: Observer<S> + ?Sized>(
        &self,
        at: (&Surface<S>, &Lobes<S>),
        (word, dice, node): (u32, &Thrown<S>, u32),
        memory: &mut A::Memory,
        observer: &mut O,
    ) -> Rgb<S::Light> {
        let count = self.count();
        let numbers = match self.rules.lamps {
            Asked::None => 0..0,
            Asked::All => 0..count,
            Asked::One => {
                let chosen = (u64::from(word) * u64::try_from(count).unwrap_or(0)) >> 32;
                let chosen = usize::try_from(chosen).unwrap_or(0);
                chosen..count.min(chosen + 1)
            }
        };
        let (is_diffuse, is_rough) = (at.1.chance(DIFFUSE) > S::Unit::ZERO, at.1.rough().is_some());
        let mut light = Rgb::BLACK;
        if is_diffuse || is_rough {
            for number in numbers {
                let own = self.of_lamp(at, (number, dice, node), memory, observer);
                light = light.plus(own.unwrap_or(Rgb::BLACK));
            }
        }
        light
    }

    /// Returns the radiance that a surface sends back of a place on a lamp.
    // What it prepares would be prepared for no lamp too: 3 % of the instructions of paths in the Cornell box.
    #[cfg_attr(not(target_os = "none"), inline(never))]
    fn of_lamp<O: Observer<S> + ?Sized>(
        &self,
        (surface, lobes): (&Surface<S>, &Lobes<S>),
        (number, dice, node): (usize, &Thrown<S>, u32),
        memory: &mut A::Memory,
        observer: &mut O,
    ) -> Option<Rgb<S::Light>> {
        let tracer = &self.spread.tracer;
        let lamp = tracer.scene.scene.lamps.get(number)?;
        let found = self.found(u32::try_from(number).ok()?, lamp);
        let from = (surface.point, surface.normal);
        let square = self.spread.spread.squares.get(number).and_then(Option::as_ref);
        let pair = || dice.of_lamp(number).words(Purpose::Lamp, node).map(S::Unit::of_word);
        let point = Lamp { radius: S::ZERO, ..*lamp };
        let Glimpse { place, lamp: shown } = match square {
            Some(square) if N::SQUARE_LAMPS => {
                // From behind, nothing of it is seen, and no numbers are drawn for its places.
                let is_before = square.shines_to(surface.point, lamp.position);
                Glimpse::of_square(&point, square, from, is_before.then(pair)?)?
            }
            _ if N::AREA_LAMPS && lamp.radius > S::ZERO => {
                Glimpse::of_sphere(&point, (lamp.radius, lamp.inverse_radius), from, pair())
            }
            _ => {
                let place = Incident::new(&point, surface.point, surface.normal)?;
                Glimpse { place, lamp: place }
            }
        };
        if place.cosine <= S::Unit::ZERO || surface.is_behind::<N>(&place) {
            return None;
        }
        let factor = self.sent_back((surface, lobes), &place, (&found, lamp, &shown));
        let arriving = shown.light::<N>(tracer.model.fades());
        let arriving = lamp.tint.map(|tint| arriving.times(tint.times(shown.cosine)));
        let unhidden = scaled::<S>(arriving, factor);
        let mut part = S::Unit::ONE;
        if casts_shadow_ray::<N, _>(unhidden) {
            let (start, used) = shadow_start::<S, N>(surface, &place);
            observer.shadow(number, &start);
            let (ray, t_max) = (tracer.ray(start), place.distance - used);
            let (scene, search) = (tracer.scene, tracer.scene.accelerator());
            part = match found {
                Found::Unseen => search.transmittance::<N>(scene, &ray, t_max, number, memory),
                // Paths through glass meet it.
                _ => search.transmittance::<Opaque<N>>(scene, &ray, t_max, number, memory),
            };
        }
        observer.lamp(number, &shown, unhidden, part);
        Some(unhidden.map(|light| light.times(part)))
    }

    /// Returns what a surface sends back of the light of a place on a lamp that a white diffuse surface would send back all of, over the
    /// chance that the lamp is asked.
    fn sent_back(
        &self,
        (surface, lobes): (&Surface<S>, &Lobes<S>),
        place: &Incident<S>,
        (found, lamp, shown): (&Found<S>, &Lamp<S>, &Incident<S>),
    ) -> Rgb<S::Power> {
        let (one, none) = (S::Unit::ONE.positive(), S::Unit::ZERO.positive());
        let among = self.among();
        let own = match found {
            Found::Square(emitter) if self.rules.weighs => {
                let sent = shown.cosine.positive().over(place.cosine.positive());
                Some(self.of_square(emitter, place.distance, sent))
            }
            Found::Sphere { is_sent: true } if self.rules.weighs => {
                Some(self.of_sphere(lamp, surface.point, place.direction, place.cosine))
            }
            _ => None,
        };
        // The part of the light that shadow rays are to find, where paths find it with a chance.
        let share = |chance: S::Power| own.map_or(one, |own| own.over(own.plus(chance)));
        let cosine = place.cosine.positive();
        let diffuse = share(lobes.chance(DIFFUSE).positive().times(cosine)).times(among);
        let is_shared = own.is_some() || matches!(found, Found::Unseen);
        let facet = lobes.rough().filter(|_| is_shared).and_then(|facets| {
            let view = -surface.incoming;
            let facet = Facet::between::<S>(surface.normal, place.direction, view)?;
            let Facet { slope, light, view, incidence } = facet;
            let sight = Sight { slope: slope.cosine, view, incidence };
            let density = facets.density(slope, &sight);
            let passed = facets.passed(&sight, light).positive();
            let share = share(lobes.chance(REFLECTED).positive().times(density));
            Some(density.times(passed).over(cosine).times(share).times(among))
        });
        let rough = facet.unwrap_or(none);
        lobes.part(DIFFUSE).zip(lobes.part(REFLECTED), |part, mirrored| {
            part.positive().times(diffuse).plus(mirrored.positive().times(rough))
        })
    }

    /// Returns the part, 0 to 1, that counts of the light of a lamp that a path meets. `square` is the lamp's triangle, where it has one.
    pub(super) fn counted_of(
        &self,
        left: &Left<S>,
        (number, direction): (u32, UnitVec3<S>),
        square: Option<(&Emitter<S>, &Surface<S>)>,
    ) -> S::Unit {
        let lamp = self.spread.tracer.scene.scene.lamps.get(index(number));
        let is_asked = self.rules.lamps != Asked::None && index(number) < self.count();
        let Some(lamp) = lamp.filter(|_| is_asked) else { return S::Unit::ONE };
        let (chance, alone) = match left {
            Left::Sharp => return S::Unit::ONE,
            Left::Diffuse(chance) => (chance, S::Unit::ZERO),
            Left::Rough(chance) => (chance, S::Unit::ONE),
        };
        let own = match (self.found(number, lamp), square) {
            _ if !self.rules.weighs => return alone,
            (Found::Square(_), Some((emitter, surface))) => {
                let sent = -surface.normal.dot(direction);
                self.of_square(emitter, surface.distance, sent.positive())
            }
            (Found::Sphere { is_sent: true }, _) => {
                self.of_sphere(lamp, chance.from, direction, chance.cosine)
            }
            _ => return alone,
        };
        chance.density.over(chance.density.plus(own)).unit()
    }

    /// Returns the density over the solid angle, times pi, with which shadow rays go to a place of a parallelogram that is seen in the
    /// distance `distance` and under the cosine `sent` of its normal.
    fn of_square(&self, emitter: &Emitter<S>, distance: S, sent: S::Power) -> S::Power {
        let distance = distance.positive();
        let seen = emitter.area.times(sent).times(self.among());
        distance.times(distance).times(pi()).over(seen.plus(S::Power::new(1, -60)))
    }

    /// Returns the density over the solid angle, times pi, with which shadow rays go from a point of a surface in a direction that
    /// meets a sphere; `cosine` is that between the direction and the surface's normal.
    fn of_sphere(&self, lamp: &Lamp<S>, from: Vec3<S>, direction: UnitVec3<S>, cosine: S::Unit) -> S::Power {
        let way = (lamp.position - from).normalize().filter(|way| way.1 > lamp.radius);
        let density = way.map_or(cosine.positive(), |(axis, distance, _)| {
            let ratio = distance.positive().over(lamp.radius.positive());
            axis.dot(direction).positive().times(ratio).times(ratio)
        });
        density.over(self.among())
    }
}
