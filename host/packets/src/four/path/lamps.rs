//! The light of lamps at points of four paths: four times what [`rta_core::trace::path`] finds by shadow rays, and by paths that meet lamps.

use glam::{Vec3, Vec4};
use rta_core::Scalar;
use rta_core::illumination::Illumination;
use rta_core::light::{Incident, Lamp};
use rta_core::needs::Needs;
use rta_core::sampling::pairs::Purpose;
use rta_core::trace::dice::{Sample, Thrown};
use rta_core::trace::path::Emitter;

use super::{Four, Places, Rgb4, Search, Traced, plus, times};
use crate::flat::Ready4;
use crate::four::geometry::{Ray4, SurfacePoint4, leave, normalize};
use crate::four::pairs::units;
use crate::four::vector::{Vec3x4, lane, mask, one, set};
use crate::leaf::{Bits, index};

/// A density that is added to what may be 0, as in the core.
const LEAST: f32 = 1.0 / (1u64 << 60) as f32;

/// Returns how many lamps shine.
fn count<N: Needs>(tracer: &Traced<'_, N>) -> usize {
    let (world, ..) = tracer.spread.tracer.parts();
    world.scene.lamps.len().min(if N::SEVERAL_LAMPS { usize::MAX } else { 1 })
}

impl Four {
    /// Adds what the surfaces in `on` send back of one lamp, for each by chance.
    #[inline(always)]
    pub(super) fn add_lamp<N: Needs>(
        &mut self,
        tracer: &Traced<'_, N>,
        on: u32,
        places: &Places,
        search: &mut Search,
    ) {
        let (world, ..) = tracer.spread.tracer.parts();
        let count = count(tracer);
        let lamps = world.scene.lamps.get(..count).unwrap_or_default();
        if let [lamp] = lamps {
            return self.add_light(tracer, (0, lamp), on, places, search);
        }
        let [words, _] = self.words(Purpose::Choice, tracer.spread.seed);
        let count = u64::try_from(count).unwrap_or(0);
        let chosen = words.map(|word| usize::try_from((u64::from(word) * count) >> 32).unwrap_or(0));
        let mut left = on;
        while let Some(k) = Bits(left).next() {
            let number = one(&chosen, k);
            let own = Bits(left).filter(|&k| one(&chosen, k) == number).fold(0, |own, k| own | 1 << k);
            left &= !own;
            if let Some(lamp) = lamps.get(number) {
                self.add_light(tracer, (number, lamp), own, places, search);
            }
        }
    }

    /// Adds what the surfaces in `on` send back of a lamp.
    #[inline(never)] // it is asked for in two places
    fn add_light<N: Needs>(
        &mut self,
        tracer: &Traced<'_, N>,
        (number, lamp): (usize, &Lamp<f32>),
        on: u32,
        places: &Places,
        search: &mut Search,
    ) {
        let (world, model, ..) = tracer.spread.tracer.parts();
        let spot = &places.spot;
        let among = count(tracer) as f32;
        let square = tracer.spread.spread.squares.get(number).and_then(Option::as_ref);
        let square = square.filter(|_| N::SQUARE_LAMPS);
        let emitter = square.filter(|_| N::EMISSION).and_then(|_| {
            let place = tracer.emitters.binary_search_by_key(&number, |emitter| index(emitter.lamp));
            place.ok().and_then(|place| tracer.emitters.get(place))
        });
        let zero = Vec4::ZERO;
        let mut aim = Vec3x4::splat(lamp.position);
        if let Some(square) = square {
            let (spread, seed) = (tracer.spread.spread, tracer.spread.seed);
            let seed = Thrown { spread, sample: Sample::default(), seed }.of_lamp(number).seed;
            let [u, v] = self.words(Purpose::Lamp, seed).map(units);
            let corner = square.corner + (lamp.position - square.middle);
            let [along, across] = square.edges.map(Vec3x4::splat);
            aim = Vec3x4::splat(corner).plus(along, u).plus(across, v);
        }
        let (direction, distance, mut inverse, none) = normalize(aim - spot.point);
        let cosine = spot.normal.dot(direction);
        let mut on = on & cosine.cmpgt(zero).bitmask() & !none;
        let (mut length, mut shown, mut own) = (distance, cosine, None);
        if let Some(square) = square {
            let sent = -Vec3x4::splat(square.normal).dot(direction);
            on &= sent.cmpgt(zero).bitmask();
            let (least, inverse_least) = square.least;
            length = distance - Vec4::splat(least * (1.0 / 64.0));
            inverse = Vec4::select(distance.cmplt(Vec4::splat(least)), Vec4::splat(inverse_least), inverse);
            shown = cosine * sent;
            own = emitter.map(|emitter| {
                of_square(emitter, length.max(zero), shown.max(zero) / cosine.max(zero), among)
            });
        }
        if on == 0 {
            return;
        }
        let chance = places.chance * cosine.max(zero);
        let share = own.map_or(Vec4::ONE, |own| own / (own + chance));
        let diffuse = share * Vec4::splat(among);
        let fades = N::ATTENUATION && (!N::SEVERAL_FALL_OFFS || lamp.fall_off.fades(model.fades()));
        let power = if fades {
            (Vec4::splat(lamp.power) * inverse * inverse).min(Vec4::splat(f32::FAR))
        } else {
            // From any place.
            let (direction, distance) = (Vec3::Z, 1.0);
            let seen = Incident { direction, distance, inverse_distance: 1.0, cosine: 1.0, lamp };
            Vec4::splat(seen.light::<N>(model.fades()))
        };
        let tint = [lamp.tint.r, lamp.tint.g, lamp.tint.b].map(|tint| Vec4::splat(tint) * shown);
        let arriving: Rgb4 = tint.map(|tint| power * tint);
        let unhidden = times(arriving, places.part.map(|part| part * diffuse));
        let [r, g, b] = unhidden.map(|register| register.cmpne(zero));
        on &= (r | g | b).bitmask();
        let (origin, used) = leave(spot.point, spot.normal, direction, places.extent);
        let (rays, length) = (Ray4 { origin, direction }, length - used);
        let ready = Ready4::new(&rays, world.accelerator());
        let mut part = Vec4::ZERO;
        for k in Bits(on) {
            let length = lane(&length, k);
            // Points have light buffers.
            let is_open = if square.is_some() { search.flat.is_open(&ready, k, length) } else { None };
            let through = || search.transmittance::<N>(world, (&rays.lane(k), length), number);
            set(&mut part, k, is_open.map_or_else(through, |is_open| if is_open { 1.0 } else { 0.0 }));
        }
        let direct = unhidden.map(|register| Vec4::select(mask(on), register * part, zero));
        self.own = plus(self.own, times(direct, self.weight));
    }

    /// Returns the part, 0 to 1, that counts of the light of what path `k` meets, a triangle by its number: not what shadow rays have told.
    pub(super) fn counted<N: Needs>(
        &self,
        tracer: &Traced<'_, N>,
        number: u32,
        spot: &SurfacePoint4,
        k: usize,
    ) -> f32 {
        let emitters = tracer.emitters;
        let after = emitters.partition_point(|emitter| emitter.triangle <= number);
        let emitter = after.checked_sub(1).and_then(|last| emitters.get(last));
        let emitter =
            emitter.filter(|emitter| number - emitter.triangle < 2 && index(emitter.lamp) < count(tracer));
        let Some(emitter) = emitter.filter(|_| one(&self.bounces, k) > 0) else { return 1.0 };
        let sent = -spot.normal.lane(k).dot(self.rays.direction.lane(k));
        let distance = Vec4::splat(lane(&spot.distance, k).max(0.0));
        let own = lane(&of_square(emitter, distance, Vec4::splat(sent.max(0.0)), count(tracer) as f32), 0);
        let density = lane(&self.density, k);
        density / (density + own)
    }
}

/// Returns the density over the solid angle, times pi, with which shadow rays go to a place of a parallelogram that is seen in the distance
/// `distance` and under the cosine `sent` of its normal, one of `among` lamps.
#[inline(always)]
fn of_square(emitter: &Emitter<f32>, distance: Vec4, sent: Vec4, among: f32) -> Vec4 {
    let seen = Vec4::splat(emitter.area) * sent * Vec4::splat(among);
    distance * distance * Vec4::splat(core::f32::consts::PI) / (seen + Vec4::splat(LEAST))
}
