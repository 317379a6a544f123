//! Indirect light that is gathered anew for a picture: the irradiance cache of G. Ward, F. Rubinstein and R. Clear, "A Ray Tracing Solution for
//! Diffuse Interreflection", SIGGRAPH 88.
//!
//! At a few of the places that the eye sees, rays find what arrives from the patches of a solution. How far such a place speaks for its
//! neighbours is told by Ward's split sphere: by a part of the harmonic mean distance of what its rays meet, so that places crowd in
//! corners and beside things. Places are looked for at pixels that lie farther apart first, and then closer, in an order that does not depend
//! on threads.
//!
//! Between the places of a quadrilateral the light is mixed, with weights that fall to 0 where a place speaks no more (the linear ones of E.
//! Tabellion and A. Lamorlette, "An Approximate Global Illumination System for Computer Generated Films", SIGGRAPH 2004), by the plane of
//! least squares through them, so that a slope comes back as it is, also at an edge. That is done once, for the vertices of patches as small
//! as the places are close, and the picture is drawn with these ([`Mixed`]). As everywhere in radiosity, light of different
//! quadrilaterals is not mixed: of the two terms of Ward's error, distance and turn of the normal, the first is left.

use rta_core::accelerator::Accelerator;
use rta_core::color::Rgb;
use rta_core::needs::Everything;
use rta_core::radiosity::{Indirect, Mesh, Quad, Rays, Solver};
use rta_core::range::Admitted;
use rta_core::raster::{Center, Places};
use rta_core::scalar::{Light, Unit};
use rta_core::vector::{LengthVector, UnitVector, Vector};
use rta_scenes::narrow::Narrow;
use rta_scenes::narrow::lit::{Gathering, Lit};
use rta_scenes::space::{Triple, difference, length};

use super::{Format, Ready};
use crate::cache::ShadowCache;
use crate::packets::Packets;
use mixed::Mixed;

mod mixed;

/// The most pixels along the longer side of a picture at which places are looked for.
const FINEST: u32 = 128;

/// How much farther apart the pixels are that are looked at first: a power of two.
const FIRST: u32 = 4;

/// The least distance that a place speaks for, in steps between the pixels that are looked at.
const LEAST: f64 = 1.5;

/// How far from the edges of its quadrilateral a place is at least, as a part of the least distance that it speaks for: from an edge where
/// another stands rays may pass behind that one.
const INWARD: f64 = 0.25;

/// The greatest distance that a place speaks for, as a part of the size of its quadrilateral.
const GREATEST: f64 = 0.25;

/// A place where light was gathered.
#[derive(Clone, Copy, Debug)]
struct Record {
    place: Triple,
    /// How far it speaks for its neighbours.
    reach: f64,
    /// What arrives, over pi.
    light: Triple,
}

impl Record {
    /// Returns whether it is near enough to speak for a place.
    fn speaks_for(&self, [x, y, z]: Triple) -> bool {
        let [a, b, c] = self.place;
        let (x, y, z) = (x - a, y - b, z - c);
        x * x + y * y + z * z < self.reach * self.reach
    }
}

/// Light that was gathered for a picture.
pub(super) struct Gathered<S: Narrow> {
    pub(super) lit: Lit<S>,
    /// The rays that it took, those that looked for the places among them, but not those that mirrors sent on.
    pub(super) rays: u64,
}

/// Returns the indirect light of a picture, gathered as its scene asks for it; `None` where it does not.
pub(super) fn gathered<S: Format>(ready: &Ready<S>) -> Option<Gathered<S>> {
    let (lit, admitted) = (ready.scene.lit.as_ref()?, ready.admitted());
    let gathering = lit.gathering.as_ref()?;
    let indirect = lit.indirect(&admitted.scene)?;
    let seed = ready.setup.sampling.spreading().map_or(0, |spreading| spreading.samples.seed());
    let rays = Rays { count: gathering.caching.rays.max(1), seed };
    let mesh = *indirect.arriving.mesh();
    let solver = Solver::new(&admitted, mesh, rays, 0);
    let cache = Cache { ready, admitted: &admitted, solver, gathering, indirect };
    let (records, rays) = cache.filled();
    Some(Gathered { lit: cache.mixed(lit, &records), rays })
}

/// A cache that is being filled.
struct Cache<'a, S: Format> {
    ready: &'a Ready<S>,
    admitted: &'a Admitted<'a, S, &'a Packets>,
    solver: Solver<'a, S, Everything, Rays, &'a Packets>,
    gathering: &'a Gathering<S>,
    indirect: Indirect<'a, S>,
}

/// A place that the eye sees: on which quadrilateral, where on it, and how far away.
struct Seen<S: Narrow> {
    quad: usize,
    at: [S::Unit; 2],
    distance: f64,
}

impl<S: Format> Cache<'_, S> {
    fn mesh(&self) -> &Mesh<'_, S> {
        self.indirect.arriving.mesh()
    }

    /// Returns the places of each quadrilateral where light was gathered, and how many rays that took.
    fn filled(&self) -> (Vec<Vec<Record>>, u64) {
        let raster = self.ready.setup.raster;
        let unit = raster.width().max(raster.height()).div_ceil(FINEST);
        let camera = &self.ready.scene.camera;
        let size = |vector: [S::Unit; 3]| length(vector.map(S::unit_to_f64));
        let [forward, right] = [camera.forward, camera.right].map(|v| size([v.x(), v.y(), v.z()]));
        // How far apart the places are that are looked at, at the distance 1.
        let apart = f64::from(unit) * right / (forward * f64::from(raster.width()));
        let quads = self.mesh().quads().len();
        let (mut records, mut latest) = (vec![Vec::<Record>::new(); quads], vec![0; quads]);
        let (mut rays, mut count, mut memory) = (0, 0, ShadowCache::default());
        let mut step = FIRST * unit;
        while step >= unit {
            let is_new = |x: u32, y: u32| {
                let is_old = x.is_multiple_of(2 * step) && y.is_multiple_of(2 * step);
                step == FIRST * unit || !is_old
            };
            for y in (0..raster.height()).step_by(step as usize) {
                for x in (0..raster.width()).step_by(step as usize).filter(|&x| is_new(x, y)) {
                    rays += 1;
                    let Some(seen) = self.seen((x, y), &mut memory) else { continue };
                    let Some(own) = records.get_mut(seen.quad) else { continue };
                    let least = LEAST * apart * seen.distance;
                    let Some((at, place)) = self.within(&seen, INWARD * least) else { continue };
                    // The one that spoke for the pixel before mostly does so again.
                    let Some(last) = latest.get_mut(seen.quad) else { continue };
                    if own.get(*last).is_some_and(|record| record.speaks_for(place)) {
                        continue;
                    }
                    if let Some(found) = own.iter().position(|record| record.speaks_for(place)) {
                        *last = found;
                    } else {
                        let light = self.light((seen.quad, at), (count, least), &mut memory);
                        own.extend(light.map(|(light, reach)| Record { place, reach, light }));
                        count += 1;
                        rays += u64::from(self.gathering.caching.rays);
                    }
                }
            }
            step /= 2;
        }
        (records, rays)
    }

    /// Returns what is seen in the middle of a pixel, if it is the front of a quadrilateral.
    fn seen(&self, (x, y): (u32, u32), memory: &mut ShadowCache) -> Option<Seen<S>> {
        let (raster, camera) = (self.ready.setup.raster, &self.ready.scene.camera);
        let (right, up) = Center.place(raster, Center.row::<S::Unit>(raster, y), x, 0);
        let direction = camera.direction(right, up);
        let ray = self.admitted.ray::<Everything>(camera.eye, direction);
        let hit = self.admitted.accelerator().closest::<Everything>(self.admitted, &ray, memory)?;
        let place = camera.eye.along(direction, hit.distance);
        let (quad, at) = self.mesh().locate(hit.object, place)?;
        let is_front = self.mesh().normal(quad)?.dot(direction) < S::Unit::ZERO;
        is_front.then(|| Seen { quad, at, distance: hit.distance.to_f64() })
    }

    /// Returns the place (u, v) nearest to one that is seen that is so far from all edges of its quadrilateral, and where that is.
    fn within(&self, seen: &Seen<S>, margin: f64) -> Option<([S::Unit; 2], Triple)> {
        let quad = self.mesh().quads().get(seen.quad)?;
        let [a, b, c, d] = corners(quad);
        let lengths = [[(a, b), (d, c)], [(a, d), (b, c)]];
        let mut at = seen.at;
        for (at, edges) in at.iter_mut().zip(lengths) {
            let shortest =
                edges.map(|(from, to)| length(difference(to, from))).into_iter().fold(f64::MAX, f64::min);
            let part = (margin / shortest).min(0.5);
            *at = S::unit(S::unit_to_f64(*at).clamp(part, 1.0 - part));
        }
        let place = quad.place(at);
        Some((at, [place.x(), place.y(), place.z()].map(S::to_f64)))
    }

    /// Gathers the light at a place, over pi, and returns how far it speaks for others, `least` at least; its rays are told apart by `name`. Nothing
    /// where the place lies within something.
    fn light(
        &self,
        (quad, at): (usize, [S::Unit; 2]),
        (name, least): (u32, f64),
        memory: &mut ShadowCache,
    ) -> Option<(Triple, f64)> {
        let Gathering { caching, reflected } = self.gathering;
        // What is nearer than places are close is as far away as that, so that no ray decides alone.
        let mut nearness = 0.0;
        let see = |distance: S| nearness += distance.to_f64().max(least).recip();
        let Rgb { r, g, b } = self.solver.arriving_at((quad, at), name, reflected, memory, see)?;
        let light = [r, g, b].map(|light| S::light_to_f64(light) / core::f64::consts::PI);
        let [a, b, c, d] = corners(self.mesh().quads().get(quad)?);
        let size = length(difference(c, a)).max(length(difference(d, b)));
        let mean = f64::from(caching.rays) / nearness;
        Some((light, (caching.error * mean).min(GREATEST * size).max(least)))
    }

    /// Returns the light with the quadrilaterals on which there are places divided into patches as small as these are close, and with what the places
    /// tell at the vertices.
    fn mixed(&self, lit: &Lit<S>, records: &[Vec<Record>]) -> Lit<S> {
        let mut new = Lit {
            quads: Vec::with_capacity(lit.quads.len()),
            arriving: Vec::new(),
            elsewhere: lit.elsewhere,
            corners: Vec::new(),
            gathering: None,
        };
        for (number, (quad, records)) in lit.quads.iter().zip(records).enumerate() {
            let first = u32::try_from(new.arriving.len()).unwrap_or(u32::MAX);
            let mixed = Mixed::new(quad, records);
            let patches = mixed.patches();
            let [nu, nv] = patches;
            let vertex = |i: u16, j: u16| {
                let part = |k: u16, count: u16| S::Unit::fraction(k.into(), count.into());
                let solved = || self.indirect.arriving.at(number, [part(i, nu), part(j, nv)]);
                mixed.light([i, j]).map_or_else(solved, |light| {
                    let [r, g, b] = light.map(|light| S::light(light.min(S::LARGEST_LIGHT)));
                    Rgb::new(r, g, b)
                })
            };
            let rows = (0..=nv).map(|j| (0..=nu).map(|i| vertex(i, j)).collect());
            let rows: Vec<Vec<_>> = rows.collect();
            for (below, above) in rows.iter().zip(rows.iter().skip(1)) {
                for pairs in below.windows(2).zip(above.windows(2)) {
                    let (&[a, b], &[c, d]) = pairs else { continue };
                    let quarter = S::Unit::ratio(1, 4);
                    new.arriving.push(a.plus(b).plus(c.plus(d)).map(|light| light.times(quarter)));
                    new.corners.push([a, b, c, d]);
                }
            }
            new.quads.push(Quad { patches, first, emitting: [[0; 2]; 2], ..*quad });
        }
        new
    }
}

/// Returns the corners of a quadrilateral.
fn corners<S: Narrow>(quad: &Quad<S>) -> [Triple; 4] {
    quad.corners.map(|corner| [corner.x(), corner.y(), corner.z()].map(S::to_f64))
}
