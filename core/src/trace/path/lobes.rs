//! The directions in which a path may leave a surface, and which of them it takes.

use crate::color::Rgb;
use crate::illumination::microfacet::{Sight, Slope, Visible};
use crate::illumination::{Bend, Illumination, Secondary, Weight};
use crate::needs::Needs;
use crate::sampling::mapping::hemisphere;
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3};
use crate::scalar::{Light, Positive, Scalar, Unit};
use crate::surface::Surface;
use crate::trace::decision::{Start, refract, secondary};
use crate::trace::dice::{Dice, Thrown};

/// The number of the lobe of diffuse light.
pub(super) const DIFFUSE: usize = 0;
/// The number of the lobe of reflected light.
pub(super) const REFLECTED: usize = 1;
/// The number of the lobe of transmitted light.
pub(super) const TRANSMITTED: usize = 2;

/// What a surface does with the light that a path brings, by lobes: diffuse, reflected, transmitted.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lobes<'a, S: Scalar> {
    /// What of the light each sends back, 0 to 1.
    parts: [Rgb<S::Unit>; 3],
    /// The chance with which the path takes each; what is left of 1 is that of its end.
    chances: [S::Unit; 3],
    may_end: bool,
    /// The facets of a rough surface.
    facets: Option<Visible<'a, S::Unit>>,
    /// The normal about which light is reflected and refracted: that of a facet, or of the surface.
    normal: UnitVec3<S>,
    /// Where transmitted light goes.
    through: Option<UnitVec3<S>>,
}

/// How a path left a surface.
pub(super) enum Left<S: Scalar> {
    /// In the one direction of a mirror or of glass, or from the eye: no shadow ray goes there.
    Sharp,
    /// In any direction.
    Diffuse(Chance<S>),
    /// In a direction of rough facets.
    Rough(Chance<S>),
}

/// The chance of a direction of a path.
pub(super) struct Chance<S: Scalar> {
    /// Its density over the solid angle, times pi.
    pub(super) density: S::Power,
    /// The cosine between the direction and the normal.
    pub(super) cosine: S::Unit,
    /// Where the path left.
    pub(super) from: Vec3<S>,
}

/// How a path goes on.
pub(super) struct Next<S: Scalar> {
    pub(super) start: Start<S>,
    /// What of the light from there is sent back, over the chance that the path goes there.
    pub(super) part: Rgb<S::Power>,
    pub(super) left: Left<S>,
}

impl<'a, S: Scalar> Lobes<'a, S> {
    /// Returns the lobes of a surface at a node of a path of this weight. `most` is the largest chance with which the path goes on where it
    /// may end there by chance.
    pub(super) fn of<M: Illumination<S>, N: Needs>(
        model: &M,
        surface: &Surface<S>,
        (dice, node): (&'a Thrown<'_, S>, u32),
        (weight, most): (Rgb<S::Power>, Option<S::Unit>),
    ) -> Self {
        let black = surface.color.map(|_| S::Unit::ZERO);
        let diffuse = model.diffuse::<N>(surface);
        let rays = if N::MIRROR { secondary::<S, M, N>(model, surface) } else { Secondary::NONE };
        let Secondary { reflected, transmitted, bend } = rays.registers();
        let mut reflected = reflected.unwrap_or(black);
        let is_shiny = reflected != black || transmitted.is_some();
        let facet = if N::GLOSS && is_shiny { dice.facet(surface.number, node) } else { None };
        let facets = facet.map(|(roughness, _)| dice.facets::<N>(surface.number, roughness));
        let normal = facets.zip(facet).map_or(surface.normal, |(facets, (_, words))| {
            facets.seen::<S>(surface.normal, -surface.incoming, words)
        });
        let mut through = None;
        let mut transmitted = transmitted.filter(|_| N::GLASS).unwrap_or(black);
        if N::GLASS && transmitted != black {
            let glass = surface.material.glass::<N>();
            match (bend, glass) {
                (Bend::Straight, _) => through = Some(surface.incoming),
                (Bend::Refracted, Some(glass)) => {
                    through = refract(&Surface { normal, ..*surface }, glass);
                    if through.is_none() {
                        // Total reflection.
                        reflected = Weight::<S>::join(reflected, transmitted);
                    }
                }
                (Bend::Refracted, None) => {}
            }
            if through.is_none() {
                transmitted = black;
            }
        }
        let parts = [diffuse, reflected, transmitted];
        let (chances, may_end) = chances::<S>(parts, weight, most);
        Self { parts, chances, may_end, facets, normal, through }
    }

    /// Returns whether no light is sent back.
    pub(super) fn is_black(&self) -> bool {
        self.chances.iter().all(|chance| *chance <= S::Unit::ZERO)
    }

    /// Returns the chance with which the path takes a lobe.
    pub(super) fn chance(&self, lobe: usize) -> S::Unit {
        self.chances.get(lobe).copied().unwrap_or(S::Unit::ZERO)
    }

    /// Returns the part of the light, 0 to 1, that a lobe sends back.
    pub(super) fn part(&self, lobe: usize) -> Rgb<S::Unit> {
        let [first, ..] = self.parts;
        self.parts.get(lobe).copied().unwrap_or(first)
    }

    /// Returns the facets whose image of a lamp is found by shadow rays too: those of a rough surface that transmits nothing.
    pub(super) fn rough(&self) -> Option<Visible<'a, S::Unit>> {
        self.facets.filter(|_| self.through.is_none())
    }

    /// Returns whether the surface has facets.
    pub(super) fn is_rough(&self) -> bool {
        self.facets.is_some()
    }

    /// Returns the lobe that the path takes, and a pair of numbers from 0 to 1 for its direction; `None` where the path ends. `words` are
    /// numbers of 32 bits behind the point. The first of them decides, and what it is within the part of the lobe is a number again: so
    /// the samples of a pixel end as evenly as they go on. Where they have chosen a facet already, `other` decides.
    pub(super) fn choose(&self, words: [u32; 2], other: u32) -> Option<(usize, [S::Unit; 2])> {
        let [first, second] = words.map(S::Unit::of_word);
        let number = if self.is_rough() { S::Unit::of_word(other) } else { first };
        let (mut below, mut chosen) = (S::Unit::ZERO, None);
        for (lobe, &chance) in self.chances.iter().enumerate() {
            if chance > S::Unit::ZERO {
                chosen = Some((lobe, number - below, chance));
                below = below + chance;
                if number < below {
                    break;
                }
            }
        }
        // Chances that are to add up to 1 may round to less.
        let (lobe, within, chance) = chosen.filter(|_| number < below || !self.may_end)?;
        let part = if self.is_rough() { first } else { within.quotient(chance) };
        Some((lobe, [if part < S::Unit::ONE { part } else { S::Unit::ONE }, second]))
    }

    /// Returns how the path goes on by a lobe; `None` where its light is lost behind the surface. `pair` chooses a diffuse direction.
    pub(super) fn follow<N: Needs>(
        &self,
        lobe: usize,
        surface: &Surface<S>,
        pair: [S::Unit; 2],
    ) -> Option<Next<S>> {
        let chance = self.chance(lobe).positive();
        let part = self.part(lobe).map(|part| part.positive().over(chance));
        let from = surface.point;
        if lobe == DIFFUSE {
            let direction = hemisphere::<S>(surface.normal, pair);
            let cosine = surface.normal.dot(direction);
            let left = Left::Diffuse(Chance { density: cosine.positive().times(chance), cosine, from });
            return Some(Next { start: leaving::<S, N>(surface, direction, true), part, left });
        }
        let leaves = lobe == REFLECTED;
        let direction = if leaves { surface.incoming.reflect(self.normal) } else { self.through? };
        let start = leaving::<S, N>(surface, direction, leaves);
        let Some(facets) = self.facets else { return Some(Next { start, part, left: Left::Sharp }) };
        let cosine = surface.normal.dot(direction);
        let out = if leaves { cosine } else { -cosine };
        let view = -surface.normal.dot(surface.incoming);
        if out <= S::Unit::ZERO {
            return None;
        }
        let incidence = -self.normal.dot(surface.incoming);
        let sight = Sight { slope: surface.normal.dot(self.normal), view, incidence };
        let passed = facets.passed(&sight, out).positive();
        let left = match self.rough() {
            Some(facets) => {
                let density = facets.density(Slope::between(surface.normal, self.normal), &sight);
                Left::Rough(Chance { density: density.times(chance), cosine, from })
            }
            None => Left::Sharp,
        };
        Some(Next { start, part: part.map(|part| part.times(passed)), left })
    }
}

/// Returns the chance of each lobe, and whether the path may end: the lobes share that by their largest registers in the pixel, which are
/// then of one size. `most` is the largest chance to go on, where it may end.
///
/// It goes on with the chance of 4/3 of its registers, so that those of a path that has gone on for long are about 3/4. In the Cornell box
/// with 16 samples, four fifths of the rays are traced that are where all paths go on up to the fourth bounce, with 1.1 times the rms.
fn chances<S: Scalar>(
    parts: [Rgb<S::Unit>; 3],
    weight: Rgb<S::Power>,
    most: Option<S::Unit>,
) -> ([S::Unit; 3], bool) {
    let (zero, one) = (S::Unit::ZERO, S::Unit::ONE);
    let sizes =
        parts.map(|part| largest::<S>(weight.zip(part, |weight, part| weight.times(part.positive()))));
    let [diffuse, reflected, transmitted] = sizes;
    let whole = diffuse.plus(reflected).plus(transmitted);
    if whole == zero.positive() {
        return ([zero; 3], false);
    }
    let goes_on = most.map_or(one, |most| {
        let rest = whole.unit();
        let chance = if rest < S::Unit::ratio(3, 4) { rest.times(S::Unit::ratio(4, 3)) } else { one };
        if chance < most { chance } else { most }
    });
    (sizes.map(|size| size.over(whole).unit().times(goes_on)), goes_on < one)
}

fn largest<S: Scalar>(of: Rgb<S::Power>) -> S::Power {
    let more = |a: S::Power, b: S::Power| if b.unit() > a.unit() { b } else { a };
    more(more(of.r, of.g), of.b)
}

/// Returns the ray that leaves a surface in a direction, on the side of its normal or on the other.
fn leaving<S: Scalar, N: Needs>(surface: &Surface<S>, direction: UnitVec3<S>, leaves: bool) -> Start<S> {
    let (side, direction) = (surface.side::<N>(), surface.fold::<N>(direction, leaves));
    let (origin, _) = surface.point.leave(if leaves { side } else { -side }, direction, surface.extent);
    Start { origin, direction }
}

/// Returns light times factors of any size.
pub(super) fn scaled<S: Scalar>(light: Rgb<S::Light>, by: Rgb<S::Power>) -> Rgb<S::Light> {
    light.zip(by, Light::scaled)
}
