//! Gathering: the light that arrives at a patch is the mean of what its rays meet, which are traced anew in each sweep.

use core::marker::PhantomData;

use super::cast::{Cast, Casts};
use super::factor::point_to_polygon;
use super::mesh::{Mesh, Patch, Site};
use super::sweep::{Gathered, Outcome, Stop, Watch};
use super::{Error, room};
use crate::accelerator::{Accelerator, Lists};
use crate::color::Rgb;
use crate::needs::Needs;
use crate::range::Admitted;
use crate::sampling::pairs::{Purpose, pair};
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3};
use crate::scalar::{Light, Scalar, Unit};

/// Solves for the light of a mesh: `B = E + X`, with `X = rho (H + F X)`, where H is what arrives straight from patches that emit.
///
/// H is computed exactly but for what is in the way, at four places of a patch, and the rest is gathered: so 64 rays are as good as more than
/// 6000 that have to find the lamps too. `C` is the rays of a patch, `N` what is compiled in, `A` how the scene is searched.
#[derive(Clone, Copy, Debug)]
pub struct Solver<'a, S: Scalar, N, C, A = Lists> {
    scene: &'a Admitted<'a, S, A>,
    mesh: Mesh<'a, S>,
    casts: C,
    lamps: Option<u32>,
    places: u16,
    needs: PhantomData<fn() -> N>,
}

impl<'a, S: Scalar, N: Needs, C: Casts<S>, A: Accelerator<S>> Solver<'a, S, N, C, A> {
    /// Returns a solver for the light of a mesh of this scene. `seed` is that of the places on lamps.
    pub const fn new(scene: &'a Admitted<'a, S, A>, mesh: Mesh<'a, S>, casts: C, seed: u32) -> Self {
        Self { scene, mesh, casts, lamps: Some(seed), places: 2, needs: PhantomData }
    }

    /// Returns the solver without H: what emits is found by the rays too.
    pub const fn by_rays_alone(self) -> Self {
        Self { lamps: None, ..self }
    }

    /// Returns the solver with H computed at `side x side` places of a patch instead of 2 x 2. A 0 counts as 1. Of what a lamp sends to patches
    /// beside it, four places of those in room G, 3 x 3 patches a wall, find 1.4 % too much, 16 places 0.3 %.
    pub fn with_places(self, side: u16) -> Self {
        Self { places: side.max(1), ..self }
    }

    /// Returns the mesh.
    pub const fn mesh(&self) -> &Mesh<'a, S> {
        &self.mesh
    }

    /// Solves. `reflected` becomes X of each patch; `arriving`, if there is one, keeps H of each, which is else computed in each sweep.
    ///
    /// # Errors
    /// [`Error::Room`] where a slice is shorter than the mesh.
    pub fn solve(
        &self,
        reflected: &mut [Rgb<S::Light>],
        arriving: Option<&mut [Rgb<S::Light>]>,
        stop: Stop,
    ) -> Result<Outcome<S::Light>, Error> {
        let reflected = room(reflected, self.mesh.len())?;
        reflected.fill(Rgb::BLACK);
        let kept = match arriving {
            Some(arriving) => {
                let arriving = room(arriving, self.mesh.len())?;
                let mut memory = A::Memory::default();
                for (patch, arriving) in self.mesh.patches().zip(&mut *arriving) {
                    *arriving = self.arriving(patch, &mut memory);
                }
                Some(&*arriving)
            }
            None => None,
        };
        stop.repeat(|| self.sweep(reflected, kept, stop.bits))
    }

    /// Gathers the light of each patch once, in the order of their numbers: later patches already see what is new of earlier ones.
    /// `arriving` is H of each patch, which is computed where it is not given.
    ///
    /// # Errors
    /// [`Error::Room`] where a slice is shorter than the mesh.
    pub fn sweep(
        &self,
        reflected: &mut [Rgb<S::Light>],
        arriving: Option<&[Rgb<S::Light>]>,
        bits: u8,
    ) -> Result<Outcome<S::Light>, Error> {
        let needed = self.mesh.len();
        let reflected = room(reflected, needed)?;
        if let Some(found) = arriving.map(<[_]>::len).filter(|&found| found < needed) {
            return Err(Error::Room { needed, found });
        }
        let mut memory = A::Memory::default();
        let mut watch = Watch::NEW;
        for (number, patch) in self.mesh.patches().enumerate() {
            let Some(site) = self.mesh.site(patch) else { continue };
            let direct = match arriving.and_then(|arriving| arriving.get(number)) {
                Some(&direct) => direct,
                None => self.arriving(patch, &mut memory),
            };
            let reflectance = site.quad.reflectance;
            let own = direct.zip(reflectance, S::Light::times);
            let new = own.plus(self.gathered(&site, reflected, reflectance, &mut memory));
            if let Some(old) = reflected.get_mut(number) {
                watch.put(old, new, new);
            }
        }
        Ok(watch.outcome(bits))
    }

    /// Returns what arrives at a patch from other patches, F X, where `reflected` is X of each.
    pub fn indirect(
        &self,
        patch: Patch,
        reflected: &[Rgb<S::Light>],
        memory: &mut A::Memory,
    ) -> Rgb<S::Light> {
        let one = S::Unit::ONE;
        let site = self.mesh.site(patch);
        site.map_or(Rgb::BLACK, |site| self.gathered(&site, reflected, Rgb::new(one, one, one), memory))
    }

    /// Returns `factor` times what arrives at a patch from other patches.
    fn gathered(
        &self,
        site: &Site<S>,
        reflected: &[Rgb<S::Light>],
        factor: Rgb<S::Unit>,
        memory: &mut A::Memory,
    ) -> Rgb<S::Light> {
        let mut gathered = Gathered::NOTHING;
        self.each(site, memory, |met, weight| {
            gathered.weigh(weight);
            let Some((patch, number)) = met else { return };
            let light = reflected.get(number).copied().unwrap_or(Rgb::BLACK);
            let is_found = self.lamps.is_none();
            gathered.add(if is_found { light.plus(self.mesh.emitted(patch)) } else { light }, weight);
        });
        gathered.mean(factor)
    }

    /// Writes the form factors from a patch to all, in the order of their numbers. They come to 1, less the part of what is lost.
    ///
    /// # Errors
    /// [`Error::Room`] where the slice is shorter than the mesh.
    pub fn factors(&self, patch: Patch, row: &mut [S::Unit]) -> Result<(), Error> {
        let row = room(row, self.mesh.len())?;
        row.fill(S::Unit::ZERO);
        let Some(site) = self.mesh.site(patch) else { return Ok(()) };
        let mut whole = S::Unit::ZERO;
        self.each(&site, &mut A::Memory::default(), |met, weight| {
            whole = whole + weight;
            if let Some(factor) = met.and_then(|(_, number)| row.get_mut(number)) {
                *factor = *factor + weight;
            }
        });
        for factor in row {
            *factor = factor.quotient(whole);
        }
        Ok(())
    }

    /// Calls `see` for each ray of a patch with the patch that it meets and that one's number, if any, and with its weight.
    fn each(
        &self,
        site: &Site<S>,
        memory: &mut A::Memory,
        mut see: impl FnMut(Option<(Patch, usize)>, S::Unit),
    ) {
        let (patch, quad) = names(site);
        for k in 0..self.casts.count() {
            let Cast { place, direction, weight } = self.casts.cast(patch, quad, k);
            let at = site.quad.within(site.patch.cell, place);
            let weight = weight.times(site.weight(at));
            let met = self.meets(site, site.quad.place(at), site.frame.vector(direction), memory);
            see(met, weight);
        }
    }

    /// Returns the patch that a ray from a place of a patch meets from the front, and its number.
    fn meets(
        &self,
        site: &Site<S>,
        place: Vec3<S>,
        direction: UnitVec3<S>,
        memory: &mut A::Memory,
    ) -> Option<(Patch, usize)> {
        let (origin, _) = place.leave(site.normal, direction, site.extent);
        let ray = self.scene.ray::<N>(origin, direction);
        let hit = self.scene.accelerator().closest::<N>(self.scene, &ray, memory)?;
        let (quad, at) = self.mesh.locate(hit.object, origin.along(direction, hit.distance))?;
        let other = self.mesh.site(Patch { quad, cell: [0; 2] })?;
        let is_front = other.normal.dot(direction) < S::Unit::ZERO;
        let patch = self.mesh.at(quad, at).filter(|_| is_front)?;
        Some((patch, self.mesh.number(patch)?))
    }

    /// Returns H of a patch: what arrives straight from patches that emit, the mean over the middles of its quarters, or see
    /// [`Solver::with_places`]; nothing where the rays find them too.
    pub fn arriving(&self, patch: Patch, memory: &mut A::Memory) -> Rgb<S::Light> {
        let (Some(seed), Some(site)) = (self.lamps, self.mesh.site(patch)) else { return Rgb::BLACK };
        let (own, name) = names(&site);
        let mut gathered = Gathered::NOTHING;
        let (side, count) = (u32::from(self.places), u32::from(self.places).pow(2));
        for k in 0..count {
            let middle = |cell: u32| S::Unit::fraction((2 * cell + 1).cast_signed(), 2 * side);
            let at = site.quad.within(patch.cell, [middle(k % side), middle(k / side)]);
            let weight = site.weight(at);
            gathered.weigh(weight);
            let place = site.quad.place(at);
            let lamps = self.mesh.patches().filter(|lamp| lamp.quad != patch.quad);
            for (number, lamp) in (0u32..).zip(lamps) {
                let emission = self.mesh.emitted(lamp);
                let Some(lamps) = self.mesh.quads().get(lamp.quad) else { continue };
                if emission == Rgb::BLACK {
                    continue;
                }
                let factor = point_to_polygon::<S>(place, site.normal, &lamps.outline(lamp.cell));
                if factor <= S::Unit::ZERO {
                    continue;
                }
                let words =
                    pair(own, name, Purpose::Lamp.tag(0), seed, count.wrapping_mul(number).wrapping_add(k));
                let there = lamps.place(lamps.within(lamp.cell, words.map(S::Unit::of_word)));
                if self.is_open(&site, place, (lamp.quad, there), memory) {
                    gathered.add(emission, weight.times(factor));
                }
            }
        }
        let one = S::Unit::ONE;
        gathered.mean(Rgb::new(one, one, one))
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
        self.meets(site, place, direction, memory).is_some_and(|(met, _)| met.quad == quad)
    }
}

/// Returns the number of a patch in its quadrilateral, and that of the quadrilateral, by which its random numbers are told apart.
fn names<S: Scalar>(site: &Site<S>) -> (u32, u32) {
    let [i, j] = site.patch.cell.map(u32::from);
    let [nu, _] = site.quad.patches.map(u32::from);
    (i + nu * j, u32::try_from(site.patch.quad).unwrap_or(u32::MAX))
}
