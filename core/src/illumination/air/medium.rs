//! A medium that scatters the light of lamps (N. L. Max, "Atmospheric Illumination and Shadows", SIGGRAPH 1986; T. Nishita, Y. Miyamae
//! and E. Nakamae, SIGGRAPH 1987).

use super::{Air, Fog};
use crate::color::Rgb;
use crate::illumination::fade::{Phase, Sight};
use crate::illumination::{Passage, Way};
use crate::light::Lamp;
use crate::needs::Needs;
use crate::ray::RayKind;
use crate::scalar::vector::{LengthVector, UnitVector, Vec3};
use crate::scalar::{Light, Magnitude, Positive, Scalar, Unit};

/// A medium that fills the scene evenly: [`Fog`], and the light of the lamps that it scatters into each ray, once. It takes light on
/// its way from a lamp that fades with the distance too, not from one that is constant.
///
/// Light is taken at places along the ray, for each lamp; with shadows, a shadow ray goes from each of them where the ray comes from the eye.
/// Reflected and transmitted rays, whose light is a part only of what is seen, do without. Where rays are
/// [distributed](crate::trace::Distributed), all of these places are shifted together within their steps, by as much for each sample, so that
/// the edges of beams have no steps in the mean, and the shadow rays go to a place on the lamp.
#[derive(Clone, Copy, Debug)]
pub struct Medium<S: Scalar> {
    /// What it takes from a ray, and the ambient light that it scatters.
    pub fog: Fog<S>,
    /// The part of what it takes that it scatters, 0 to 1.
    pub albedo: S::Unit,
    /// How it scatters light.
    pub phase: Phase<S::Unit>,
    /// The number of places along a ray is `2^halvings`, at least 16.
    pub halvings: u8,
    /// Whether things cast shadows into it that the eye sees.
    pub shadows: bool,
    /// How far the medium reaches from where a ray starts, above 0: what is farther away has no more of it before it, and a ray that meets
    /// nothing passes through so much. Without it, a ray passes through the medium up to what it meets, and through none if it meets nothing.
    pub reach: Option<S>,
    /// Whether lamps that do not say it themselves become less with the distance: the model's
    /// [`ATTENUATION`](crate::illumination::Illumination::ATTENUATION).
    pub fades: bool,
}

/// The least distance between a lamp and the line of a ray, 2^-8: the light of a point on the ray itself would be endless.
const LEAST_HEIGHT: Magnitude = Magnitude::new(1, -8);

/// ln 2 in units of 2^-64.
const LN_2: u64 = 0xb172_17f7_d1cf_79ac;

/// Returns the distance `along` a ray of a length above 0 as a length.
fn at<S: Scalar>(length: S, along: S::Power) -> S {
    length.scale(along.over(length.positive()).unit())
}

impl<S: Scalar> Air<S> for Medium<S> {
    fn passage<N: Needs>(
        &self,
        way: &Way<S>,
        length: Option<S>,
        mut lit: impl FnMut(Vec3<S>, usize) -> S::Unit,
    ) -> Option<Passage<S, Rgb<S::Unit>>> {
        let length = match self.reach {
            Some(reach) if N::AIR_REACH => length.filter(|length| *length < reach).unwrap_or(reach),
            _ => length?,
        };
        let cut;
        let way = if N::AIR_REACH && self.reach.is_some() {
            cut = Way { length: Some(length), ..*way };
            &cut
        } else {
            way
        };
        let passage = self.fog.passage::<N>(way, Some(length), &mut lit)?;
        if self.albedo <= S::Unit::ZERO || length <= S::ZERO {
            return Some(passage);
        }
        let has_shadows = self.shadows && way.kind == RayKind::Primary;
        let shift = way.shift.filter(|_| N::SPREAD_AIR && has_shadows);
        let lamps = way.lamps.iter().enumerate();
        let veil = lamps.fold(passage.veil, |veil, (number, lamp)| {
            // The part of the lamp's light that arrives at a place and is scattered into the ray, by the cosine of the angle between the
            // ray and the direction to the lamp.
            let mut part = |place: Vec3<S>, cosine: S::Unit| {
                let scattered = self.phase.scattered(cosine);
                if has_shadows { scattered.times(lit(place, number).positive()) } else { scattered }
            };
            let beam = if lamp.fall_off.fades(self.fades) {
                self.near(way, (length, shift), lamp, &mut part)
            } else {
                self.constant(way, (length, shift), lamp, &mut part)
            };
            let light = |beam: S::Power, tint: S::Unit| {
                S::intensity(beam.times(tint.positive()).times(self.albedo.positive()))
            };
            veil.zip(beam.zip(lamp.tint, light), Light::plus)
        });
        Some(Passage { veil, ..passage })
    }
}

impl<S: Scalar> Medium<S> {
    /// Returns for each register `function` of its density, computed once if all are equal.
    fn registers<T: Copy>(&self, mut function: impl FnMut(S::Power) -> T) -> Rgb<T> {
        let Rgb { r, g, b } = self.fog.density;
        let red = function(r);
        if r == g && r == b { Rgb::new(red, red, red) } else { Rgb::new(red, function(g), function(b)) }
    }

    /// Returns the light of a lamp that fades with the distance which is scattered into a ray.
    fn near(
        &self,
        way: &Way<S>,
        (length, shift): (S, Option<S::Unit>),
        lamp: &Lamp<S>,
        part: &mut impl FnMut(Vec3<S>, S::Unit) -> S::Power,
    ) -> Rgb<S::Power> {
        let to_lamp = lamp.position - way.start.origin;
        let foot = to_lamp.dot(way.start.direction);
        let height = S::sqrt(to_lamp.reject(way.start.direction, foot).norm_squared());
        let least = S::at_most(LEAST_HEIGHT);
        let least = if lamp.radius > least { lamp.radius } else { least };
        let height = if height < least { least } else { height };
        // From a lamp behind the start to the end of a long ray it may be farther than the format holds.
        let end = if foot < S::ZERO && length > S::FAR + foot { S::FAR } else { length - foot };
        let sight = Sight::<S>::new(height, -foot, end, self.halvings);
        let none = S::ZERO.positive();
        let mut sum = Rgb::new(none, none, none);
        let mut see = |along: S::Power, away: Option<S::Power>| {
            let distance = at(length, along);
            let ahead = foot - distance;
            let is_behind = ahead < S::ZERO;
            let away = away.unwrap_or_else(|| {
                let (across, ahead) = (height.positive(), if is_behind { -ahead } else { ahead }.positive());
                across.times(across).plus(ahead.times(ahead)).root()
            });
            let cosine = if is_behind { -ahead } else { ahead }.positive().over(away).unit();
            let cosine = if cosine > S::Unit::ONE { S::Unit::ONE } else { cosine };
            let place = way.start.origin.along(way.start.direction, distance);
            let part = part(place, if is_behind { -cosine } else { cosine });
            let whole = along.plus(away);
            let here = self.registers(|density| part.times(density.times(whole).exp2_minus().positive()));
            sum = sum.zip(here, Positive::plus);
        };
        match shift {
            Some(shift) => sight.shifted(shift, &mut |along| see(along, None)),
            None => sight.places(&mut |along, away| see(along, Some(away))),
        }
        let power = lamp.power.times(S::Power::new(LN_2, -64));
        let arrived = sum.zip(self.fog.density, |sum, density| sight.integral(sum).times(density));
        arrived.map(|part| part.times(power))
    }

    /// Returns the light of a lamp that does not fade which is scattered into a ray.
    fn constant(
        &self,
        way: &Way<S>,
        (length, shift): (S, Option<S::Unit>),
        lamp: &Lamp<S>,
        part: &mut impl FnMut(Vec3<S>, S::Unit) -> S::Power,
    ) -> Rgb<S::Power> {
        let one = S::Power::new(1, 0);
        let quarter = S::Power::new(1, -2).times(if lamp.is_cut(self.fades) { one } else { lamp.power });
        let none = S::ZERO.positive();
        let mut sum = Rgb::new(none, none, none);
        let (count, whole) = (1u64 << self.halvings.clamp(4, 16), length.positive());
        let width = whole.over(S::Power::new(count, 0));
        let left_at = |number| {
            let along = width.times(S::Power::new(number, 0));
            self.registers(|density| density.times(along).exp2_minus())
        };
        let mut before = left_at(0);
        for number in 0..count {
            let left = left_at(number + 1);
            let along = match shift {
                Some(shift) => width.times(S::Power::new(number, 0).plus(shift.positive())),
                None => width.times(S::Power::new(2 * number + 1, -1)),
            };
            let place = way.start.origin.along(way.start.direction, at(length, along));
            let to_lamp = (lamp.position - place).normalize();
            let cosine = to_lamp.map_or(S::Unit::ONE, |(direction, ..)| direction.dot(way.start.direction));
            let part = part(place, cosine);
            let taken = before.zip(left, |before, left| (before - left).positive().times(part));
            sum = sum.zip(taken, Positive::plus);
            before = left;
        }
        sum.map(|sum| sum.times(quarter))
    }
}

#[cfg(test)]
#[cfg(feature = "f64")]
mod tests;
