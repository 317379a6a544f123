//! Where the rays of a patch end: on a patch, perhaps after mirrors and glass (J. Wallace, M. Cohen and D. Greenberg, "A Two-Pass Solution to
//! the Rendering Equation", SIGGRAPH 87; F. Sillion and C. Puech, "A General Two-Pass Method Integrating Specular and Diffuse Reflection",
//! SIGGRAPH 89).

use heapless::Vec;

use super::cast::{Cast, Casts};
use super::gather::{Solver, names};
use super::mesh::{Patch, Site};
use crate::accelerator::Accelerator;
use crate::color::Rgb;
use crate::illumination::{Illumination, Rta};
use crate::material::Glass;
use crate::needs::Needs;
use crate::ray::Start;
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3};
use crate::scalar::{Scalar, Unit};
use crate::scene::Hit;
use crate::surface::Surface;
use crate::trace::decision::{Branch, branch, refract};
use crate::world::Seen;

/// How often a ray is reflected or refracted at most until it is lost.
const DEPTH: u8 = 4;

/// A patch that a ray meets, and its number.
pub(super) type Met = (Patch, usize);

/// What ends a ray.
pub(super) enum Ended {
    /// The front of a patch.
    On(Met),
    /// The back of one: the ray is lost.
    Behind,
    /// What has no patches, and sends it on no more: it is lost too.
    Elsewhere,
}

/// The weights of a ray's registers and its place in the ray tree.
type Place<S> = Branch<Rgb<<S as Scalar>::Unit>>;

impl<S: Scalar, N: Needs, C: Casts<S>, A: Accelerator<S>> Solver<'_, S, N, C, A> {
    /// Calls `see` once for each ray of a patch with its weight, then `meet` for each patch where it ends with the part of that patch's light
    /// that arrives, register by register, and with whether it came there straight.
    pub(super) fn each<T>(
        &self,
        site: &Site<S>,
        memory: &mut A::Memory,
        target: &mut T,
        mut see: impl FnMut(&mut T, S::Unit),
        mut meet: impl FnMut(&mut T, Met, Rgb<S::Unit>, bool),
    ) {
        let (patch, quad) = names(site);
        for k in 0..self.casts().count() {
            let Cast { place, direction, weight } = self.casts().cast(patch, quad, k);
            let at = site.quad.within(site.patch.cell, place);
            let weight = weight.times(site.weight(at));
            see(target, weight);
            let start = left(site, site.quad.place(at), site.frame.vector(direction));
            self.follow(start, weight, memory, |end, weights, is_straight, _| {
                if let Ended::On(met) = end {
                    meet(target, met, weights, is_straight);
                }
            });
        }
    }

    /// Follows a ray through mirrors and glass to where it ends. `meet` is told of each end the part of the light from there that arrives, whether
    /// the ray came there straight, and how far away it is from the last place where the ray was sent on.
    pub(super) fn follow(
        &self,
        start: Start<S>,
        weight: S::Unit,
        memory: &mut A::Memory,
        mut meet: impl FnMut(Ended, Rgb<S::Unit>, bool, S),
    ) {
        let mut pending = Vec::<(Place<S>, Start<S>), { DEPTH as usize }>::new();
        let mut current = (Branch { weight: Rgb::new(weight, weight, weight), ..Branch::eye::<S>() }, start);
        loop {
            let (place, start) = current;
            let mut next = None;
            if let Some(hit) = self.hit(start, memory) {
                let mut end = |end| meet(end, place.weight, place.depth == 0, hit.distance);
                match self.patch_of(start, hit) {
                    Some(Some(met)) => end(Ended::On(met)),
                    Some(None) => end(Ended::Behind),
                    None if N::MIRROR && place.depth < DEPTH => {
                        let [transmitted, reflected] = self.secondary(start, hit, &place);
                        if transmitted.is_none() && reflected.is_none() {
                            end(Ended::Elsewhere);
                        }
                        // There is room: one ray waits for each level.
                        let waits = transmitted.is_none_or(|transmitted| pending.push(transmitted).is_ok());
                        debug_assert!(waits, "the ray stack is one entry for each level of depth");
                        next = reflected;
                    }
                    None => end(Ended::Elsewhere),
                }
            }
            match next.or_else(|| pending.pop()) {
                Some(next) => current = next,
                None => return,
            }
        }
    }

    /// Returns the rays that a mirror or glass sends on, weighted as the thesis's model does; none of other surfaces.
    fn secondary(&self, start: Start<S>, hit: Hit<S>, place: &Place<S>) -> [Option<(Place<S>, Start<S>)>; 2] {
        let scene = self.scene();
        let ray = scene.ray::<N>(start.origin, start.direction);
        let Seen::Surface(mut surface) = scene.seen::<N>(&ray, Some(hit)) else { return [None; 2] };
        scene.cover::<N>(&mut surface, hit.object, place.kind);
        let weights = Illumination::<S>::secondary::<N>(&Rta, &surface);
        let start = |direction, leaves| sent_on::<S, N>(&surface, direction, leaves);
        let reflected = || start(surface.incoming.reflect(surface.normal), true);
        let refracted = |glass: &Glass<S>| refract(&surface, glass).map(|direction| start(direction, false));
        let straight = || start(surface.incoming, false);
        branch::<S, _, N>(weights, &surface, (place, S::Unit::ROUNDING), reflected, refracted, straight)
    }

    #[inline]
    fn hit(&self, Start { origin, direction }: Start<S>, memory: &mut A::Memory) -> Option<Hit<S>> {
        let ray = self.scene().ray::<N>(origin, direction);
        self.scene().accelerator().closest::<N>(self.scene(), &ray, memory)
    }

    /// Returns the patch that a ray meets, `Some(None)` for one that is met from behind, and `None` for what is none.
    #[inline]
    fn patch_of(&self, Start { origin, direction }: Start<S>, hit: Hit<S>) -> Option<Option<Met>> {
        let mesh = self.mesh();
        let place = origin.along(direction, hit.distance);
        let found = mesh.locate(hit.object, place)?;
        let (quad, at) = if C::TIES { mesh.last_beside(found, place, direction) } else { found };
        let is_front = mesh.normal(quad)?.dot(direction) < S::Unit::ZERO;
        let patch = mesh.at(quad, at).filter(|_| is_front);
        Some(patch.and_then(|patch| Some((patch, mesh.number(patch)?))))
    }

    /// Returns whether a place of a patch sees a place of a quadrilateral.
    pub(super) fn is_open(
        &self,
        site: &Site<S>,
        place: Vec3<S>,
        (quad, there): (usize, Vec3<S>),
        memory: &mut A::Memory,
    ) -> bool {
        let Some((direction, ..)) = (there - place).normalize() else { return false };
        let start = left(site, place, direction);
        let met = self.hit(start, memory).and_then(|hit| self.patch_of(start, hit)?);
        met.is_some_and(|(met, _)| met.quad == quad)
    }
}

/// Returns the start of a ray that leaves a place of a patch.
#[inline]
pub(super) fn left<S: Scalar>(site: &Site<S>, place: Vec3<S>, direction: UnitVec3<S>) -> Start<S> {
    let (origin, _) = place.leave(site.normal, direction, site.extent);
    Start { origin, direction }
}

/// Returns the start of a ray that a surface sends on in a direction, on the side of its normal or through it.
fn sent_on<S: Scalar, N: Needs>(surface: &Surface<S>, direction: UnitVec3<S>, leaves: bool) -> Start<S> {
    let (side, direction) = (surface.side::<N>(), surface.fold::<N>(direction, leaves));
    let (origin, _) = surface.point.leave(if leaves { side } else { -side }, direction, surface.extent);
    Start { origin, direction }
}
