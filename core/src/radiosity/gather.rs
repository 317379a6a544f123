//! Gathering: the light that arrives at a patch is the mean of what its rays meet, which are traced anew in each sweep.

use core::marker::PhantomData;

use super::cast::Casts;
use super::ends::View;
use super::factor::point_to_polygon;
use super::mesh::{Mesh, Patch, Site};
use super::sweep::{Gathered, Outcome, Stop, Watch};
use super::{Error, room};
use crate::accelerator::{Accelerator, Lists};
use crate::color::Rgb;
use crate::needs::Needs;
use crate::range::Admitted;
use crate::sampling::pairs::{Purpose, pair};
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

    /// Returns the rays of a patch.
    pub(super) const fn casts(&self) -> &C {
        &self.casts
    }

    /// Returns the scene.
    pub(super) const fn scene(&self) -> &'a Admitted<'a, S, A> {
        self.scene
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
        self.sweep_kept(reflected, arriving, bits, |_| None)
    }

    /// As [`Solver::sweep`], with the same result to the last bit, where `view` may return what the patch of a number sees
    /// ([`Solver::view`]): its rays are not traced again.
    ///
    /// # Errors
    /// [`Error::Room`] where a slice is shorter than the mesh.
    pub fn sweep_kept<'v>(
        &self,
        reflected: &mut [Rgb<S::Light>],
        arriving: Option<&[Rgb<S::Light>]>,
        bits: u8,
        view: impl Fn(usize) -> Option<View<'v, S>>,
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
            let gathered = match view(number) {
                Some(view) => self.viewed(&view, reflected, reflectance),
                None => self.gathered(&site, reflected, reflectance, &mut memory),
            };
            let new = own.plus(gathered);
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
        let weigh = |gathered: &mut Gathered<S::Light>, weight| gathered.weigh(weight);
        self.each(site, memory, &mut gathered, weigh, |gathered, (patch, number), weights, is_straight| {
            gathered.add_each(self.sent((number, || Some(patch)), is_straight, reflected), weights);
        });
        gathered.mean(factor)
    }

    /// Returns the light that the patch of a number sends along a ray that ends there.
    pub(super) fn sent(
        &self,
        (number, patch): (usize, impl FnOnce() -> Option<Patch>),
        is_straight: bool,
        reflected: &[Rgb<S::Light>],
    ) -> Rgb<S::Light> {
        let light = reflected.get(number).copied().unwrap_or(Rgb::BLACK);
        // H is what comes straight from lamps.
        let is_in_h = is_straight && self.lamps.is_some();
        let emitted = |patch| self.mesh.emitted(patch);
        if is_in_h { light } else { light.plus(patch().map_or(Rgb::BLACK, emitted)) }
    }

    /// Writes the form factors from a patch to all, in the order of their numbers. They come to 1, less the part of what is
    /// lost. Through coloured mirrors they are those of the green register.
    ///
    /// # Errors
    /// [`Error::Room`] where the slice is shorter than the mesh.
    pub fn factors(&self, patch: Patch, row: &mut [S::Unit]) -> Result<(), Error> {
        let row = room(row, self.mesh.len())?;
        row.fill(S::Unit::ZERO);
        let Some(site) = self.mesh.site(patch) else { return Ok(()) };
        let mut found = (row, S::Unit::ZERO);
        let weigh = |(_, whole): &mut (&mut [S::Unit], S::Unit), weight| *whole = *whole + weight;
        self.each(
            &site,
            &mut A::Memory::default(),
            &mut found,
            weigh,
            |(row, _), (_, number), weights, _| {
                if let Some(factor) = row.get_mut(number) {
                    *factor = *factor + weights.g;
                }
            },
        );
        let (row, whole) = found;
        for factor in row {
            *factor = factor.quotient(whole);
        }
        Ok(())
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
            for (lamp, number) in self.mesh.lamps(patch.quad) {
                let Some(lamps) = self.mesh.quads().get(lamp.quad) else { continue };
                let factor = point_to_polygon::<S>(place, site.normal, &lamps.outline(lamp.cell));
                if factor <= S::Unit::ZERO {
                    continue;
                }
                let words =
                    pair(own, name, Purpose::Lamp.tag(0), seed, count.wrapping_mul(number).wrapping_add(k));
                let there = lamps.place(lamps.within(lamp.cell, words.map(S::Unit::of_word)));
                if self.is_open(&site, place, (lamp.quad, there), memory) {
                    gathered.add(lamps.emission, weight.times(factor));
                }
            }
        }
        let one = S::Unit::ONE;
        gathered.mean(Rgb::new(one, one, one))
    }
}

/// Returns the number of a patch in its quadrilateral, and that of the quadrilateral, by which its random numbers are told apart.
pub(super) fn names<S: Scalar>(site: &Site<S>) -> (u32, u32) {
    let [i, j] = site.patch.cell.map(u32::from);
    let [nu, _] = site.quad.patches.map(u32::from);
    (i + nu * j, u32::try_from(site.patch.quad).unwrap_or(u32::MAX))
}
