//! A scene is borrowed data: one list for each kind of thing, in RAM or in flash.

use core::fmt;

use crate::bvh::{Bvh, Item};
use crate::color::Rgb;
use crate::hierarchy::{Node, Walk};
use crate::illumination::Surface;
use crate::lanes::{LANES, Lanes, Met, Pack, Probe, Search, Waiting};
use crate::light::Lamp;
use crate::material::Material;
use crate::needs::Needs;
use crate::range::Limits;
use crate::ray::Ray;
use crate::scalar::{Light, Scalar, Unit};
pub use crate::shape::Floor;
use crate::shape::{Cone, Cylinder, Ellipsoid, Sphere, Triangle, sphere};
use crate::vector::{UnitVec3, UnitVector, Vec3, Vector};

/// A scene (rta-model section 1), but for the eye.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a, S: Scalar> {
    /// Vertical cylinders.
    pub cylinders: &'a [Cylinder<S>],
    /// Ellipsoids.
    pub ellipsoids: &'a [Ellipsoid<S>],
    /// Spheres.
    pub spheres: &'a [Sphere<S>],
    /// A hierarchy over the spheres, or nothing.
    pub hierarchy: &'a [Node<S>],
    /// Cones and cylinders between two points.
    pub cones: &'a [Cone<S>],
    /// Triangles.
    pub triangles: &'a [Triangle<S>],
    /// A hierarchy of boxes over ellipsoids, spheres, cones and triangles, or [`Bvh::NONE`].
    pub boxes: Bvh<'a, S>,
    /// What a machine with lanes goes by instead of the two hierarchies, or [`Lanes::NONE`].
    pub lanes: Lanes<'a>,
    /// Lamps.
    pub lamps: &'a [Lamp<S>],
    /// The floor, if there is one.
    pub floor: Option<Floor<S>>,
    /// What a ray sees that meets nothing.
    pub sky: Sky<S>,
    /// Ambient light.
    pub ambient: Rgb<S::Light>,
}

/// The sky: one colour at the horizon, one at the zenith and at the nadir, mixed by the square of the sine of the
/// elevation (Graham 1987).
#[derive(Clone, Copy, Debug)]
pub struct Sky<S: Scalar> {
    /// Radiance at the horizon.
    pub horizon: Rgb<S::Light>,
    /// Radiance at the zenith.
    pub zenith: Rgb<S::Light>,
}

impl<S: Scalar> Sky<S> {
    /// Radiance in a direction.
    fn radiance<N: Needs>(&self, direction: UnitVec3<S>) -> Rgb<S::Light> {
        // A sum of parts of one colour would be rounded.
        if !N::SKY_GRADIENT || self.horizon == self.zenith {
            return self.horizon;
        }
        let high = direction.z().times(direction.z());
        let low = S::Unit::ONE - high;
        self.horizon.zip(self.zenith, |horizon, zenith| horizon.times(low).plus(zenith.times(high)))
    }
}

/// What a ray meets: which, in its list.
///
/// Of things that are equally near, the first in this order is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Object {
    /// The floor.
    Floor,
    /// A cylinder.
    Cylinder(usize),
    /// An ellipsoid.
    Ellipsoid(usize),
    /// A sphere.
    Sphere(usize),
    /// A cone, or a cylinder between two points.
    Cone(usize),
    /// A triangle.
    Triangle(usize),
    /// A visible lamp.
    Lamp(usize),
}

/// As a scene file counts: from 1.
impl fmt::Display for Object {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (name, index) = match *self {
            Self::Floor => return f.write_str("floor"),
            Self::Cylinder(i) => ("cylinder", i),
            Self::Ellipsoid(i) => ("ellipsoid", i),
            Self::Sphere(i) => ("sphere", i),
            Self::Cone(i) => ("cone", i),
            Self::Triangle(i) => ("triangle", i),
            Self::Lamp(i) => ("lamp", i),
        };
        write!(f, "{name} {}", index + 1)
    }
}

/// The nearest hit of a ray.
#[derive(Clone, Copy, Debug)]
pub struct Hit<S> {
    /// Distance as the search found it.
    pub distance: S,
    /// What was hit.
    pub object: Object,
}

/// The nearest hit so far, of objects that come in any order.
struct Best<S> {
    hit: Option<Hit<S>>,
    /// What is as near as that hit is looked at too.
    limit: S,
}

impl<S: Scalar> Best<S> {
    /// Takes a hit below the limit that is nearer, or comes before it in order: its distance.
    #[inline(always)]
    fn offer(&mut self, found: Hit<S>) -> Option<S> {
        if self.hit.is_some_and(|hit| found.distance >= hit.distance && found.object >= hit.object) {
            return None;
        }
        *self = Self { hit: Some(found), limit: found.distance.next_up() };
        Some(found.distance)
    }
}

impl<S: Scalar> Scene<'_, S> {
    /// An empty plain under a blue sky, by day.
    pub fn day() -> Self {
        let unit = |n| S::Unit::ratio(n, 100);
        let light = |r, g, b| Rgb::new(unit(r), unit(g), unit(b)).map(|part| S::Light::WHITE.times(part));
        Scene {
            cylinders: &[],
            ellipsoids: &[],
            spheres: &[],
            hierarchy: &[],
            cones: &[],
            triangles: &[],
            boxes: Bvh::NONE,
            lanes: Lanes::NONE,
            lamps: &[],
            floor: Some(Floor {
                colors: [Rgb::new(unit(85), unit(85), unit(80)), Rgb::new(unit(15), unit(17), unit(25))],
            }),
            sky: Sky { horizon: light(75, 82, 95), zenith: light(10, 22, 60) },
            ambient: light(30, 30, 32),
        }
    }

    /// A ray through this scene.
    #[inline]
    pub fn ray<N: Needs>(&self, origin: Vec3<S>, direction: UnitVec3<S>) -> Ray<S> {
        let plan = if N::CYLINDERS && !self.cylinders.is_empty() { direction.plan() } else { None };
        Ray { origin, direction, plan }
    }

    /// Whether the search goes by lanes.
    fn is_laned<N: Needs>(&self) -> bool {
        N::BOXES && LANES && !self.lanes.packs.is_empty()
    }

    /// Whether it goes by boxes: where there are some; but a hierarchy of spheres is quicker.
    fn is_boxed<N: Needs>(&self) -> bool {
        N::BOXES && !self.boxes.nodes.is_empty() && (!N::HIERARCHY || self.hierarchy.is_empty())
    }

    /// Where a ray meets an item nearer than `t_max`.
    #[inline(always)]
    fn meet<N: Needs>(&self, item: Item, ray: &Ray<S>, t_max: S) -> Option<Hit<S>> {
        match item {
            Item::Sphere(i) if N::SPHERES => {
                let i = usize::try_from(i).unwrap_or(usize::MAX);
                let distance = self.spheres.get(i)?.intersect(ray, t_max)?;
                Some(Hit { distance, object: Object::Sphere(i) })
            }
            _ => self.meet_other::<N>(item, ray, t_max),
        }
    }

    /// The same for what is not a sphere.
    #[inline(never)] // so that spheres are tried at once
    fn meet_other<N: Needs>(&self, item: Item, ray: &Ray<S>, t_max: S) -> Option<Hit<S>> {
        let index = |number: u32| usize::try_from(number).unwrap_or(usize::MAX);
        let (distance, object) = match item {
            Item::Ellipsoid(i) if N::ELLIPSOIDS => {
                (self.ellipsoids.get(index(i))?.intersect(ray, t_max)?, Object::Ellipsoid(index(i)))
            }
            Item::Cone(i) if N::CONES => {
                (self.cones.get(index(i))?.intersect(ray, t_max)?, Object::Cone(index(i)))
            }
            Item::Triangle(i) if N::TRIANGLES => {
                (self.triangles.get(index(i))?.intersect(ray, t_max)?, Object::Triangle(index(i)))
            }
            Item::Lamp(i) if N::VISIBLE_LAMPS && LANES => {
                let lamp = self.lamps.get(index(i))?;
                (sphere::intersect(lamp.position, lamp.radius, ray, t_max)?, Object::Lamp(index(i)))
            }
            _ => return None,
        };
        Some(Hit { distance, object })
    }

    /// Where a ray meets item `k` of a pack nearer than `t_max`.
    #[inline(always)]
    fn meet_lane<N: Needs>(
        &self,
        pack: &Pack,
        met: &Met,
        k: usize,
        ray: &Ray<S>,
        t_max: S,
    ) -> Option<Hit<S>> {
        let &item = pack.items.get(k)?;
        let object = match item {
            Item::Sphere(i) if N::SPHERES => Object::Sphere(usize::try_from(i).unwrap_or(usize::MAX)),
            Item::Lamp(i) if N::VISIBLE_LAMPS => Object::Lamp(usize::try_from(i).unwrap_or(usize::MAX)),
            _ => return self.meet_other::<N>(item, ray, t_max),
        };
        match met.sphere(pack, k, t_max) {
            Some(distance) => Some(Hit { distance: distance?, object }),
            None => self.meet::<N>(item, ray, t_max),
        }
    }

    /// The material of an item; a lamp has none.
    #[inline(never)] // so that a ray which meets nothing does not prepare for it
    fn item_material(&self, item: Item) -> Option<&Material<S>> {
        let index = |number: u32| usize::try_from(number).unwrap_or(usize::MAX);
        self.material(match item {
            Item::Sphere(i) => Object::Sphere(index(i)),
            Item::Ellipsoid(i) => Object::Ellipsoid(index(i)),
            Item::Cone(i) => Object::Cone(index(i)),
            Item::Triangle(i) => Object::Triangle(index(i)),
            Item::Lamp(i) => Object::Lamp(index(i)),
        })
    }

    /// The material of what was hit; a lamp has none, and the floor is opaque.
    fn material(&self, object: Object) -> Option<&Material<S>> {
        match object {
            Object::Floor => Some(&Material::Opaque),
            Object::Cylinder(i) => self.cylinders.get(i).map(|c| &c.material),
            Object::Ellipsoid(i) => self.ellipsoids.get(i).map(|e| &e.material),
            Object::Sphere(i) => self.spheres.get(i).map(|s| &s.material),
            Object::Cone(i) => self.cones.get(i).map(|c| &c.material),
            Object::Triangle(i) => self.triangles.get(i).map(|t| &t.material),
            Object::Lamp(_) => None,
        }
    }

    /// The nearest hit of a ray, if it meets anything; cylinders end at the height `lid`.
    pub fn nearest<N: Needs>(&self, ray: &Ray<S>, lid: S) -> Option<Hit<S>> {
        let mut hit = None;
        let mut t_max = S::FAR;
        let mut found = |distance: Option<S>, object: Object, t_max: &mut S| {
            if let Some(distance) = distance {
                *t_max = distance;
                hit = Some(Hit { distance, object });
            }
        };
        if N::FLOOR
            && let Some(floor) = &self.floor
        {
            found(floor.intersect(ray), Object::Floor, &mut t_max);
        }
        if N::CYLINDERS {
            for (i, cylinder) in self.cylinders.iter().enumerate() {
                found(cylinder.intersect(ray, t_max, lid), Object::Cylinder(i), &mut t_max);
            }
        }
        if self.is_laned::<N>() {
            return self.nearest_laned::<N>(ray, hit, t_max);
        }
        if self.is_boxed::<N>() {
            let mut best = Best { hit, limit: t_max.next_up() };
            self.boxes.nearest(ray, &mut t_max, |item| best.offer(self.meet::<N>(item, ray, best.limit)?));
            return self.nearest_lamp::<N>(ray, t_max).or(best.hit);
        }
        if N::ELLIPSOIDS {
            for (i, ellipsoid) in self.ellipsoids.iter().enumerate() {
                found(ellipsoid.intersect(ray, t_max), Object::Ellipsoid(i), &mut t_max);
            }
        }
        if N::SPHERES {
            let mut walk = Walk::<S, N>::new(self.hierarchy, self.spheres);
            while let Some((i, sphere)) = walk.next(ray, t_max) {
                found(sphere.intersect(ray, t_max), Object::Sphere(i), &mut t_max);
            }
        }
        if N::CONES {
            for (i, cone) in self.cones.iter().enumerate() {
                found(cone.intersect(ray, t_max), Object::Cone(i), &mut t_max);
            }
        }
        if N::TRIANGLES {
            for (i, triangle) in self.triangles.iter().enumerate() {
                found(triangle.intersect(ray, t_max), Object::Triangle(i), &mut t_max);
            }
        }
        self.nearest_lamp::<N>(ray, t_max).or(hit)
    }

    /// The nearest hit with what lanes hold, where a ray meets nothing else but `hit` before `t_max`.
    #[inline(always)]
    fn nearest_laned<N: Needs>(&self, ray: &Ray<S>, hit: Option<Hit<S>>, t_max: S) -> Option<Hit<S>> {
        let mut best = Best { hit, limit: t_max.next_up() };
        let mut probe = Probe::new(&self.lanes, ray, t_max);
        if self.lanes.nodes.is_empty() {
            self.nearest_of::<N>(self.lanes.packs, ray, &mut probe, &mut best);
        } else {
            let mut waiting = Waiting::new();
            let mut search = Search::new(probe, self.lanes.nodes, &mut waiting);
            while let Some(packs) = search.near_leaf() {
                self.nearest_of::<N>(packs, ray, &mut search.probe, &mut best);
            }
        }
        best.hit
    }

    /// The nearest hit with some packs.
    #[inline(always)]
    fn nearest_of<N: Needs>(&self, packs: &[Pack], ray: &Ray<S>, probe: &mut Probe, best: &mut Best<S>) {
        for pack in packs {
            let met = probe.meet(pack);
            for k in met.items() {
                let found = self.meet_lane::<N>(pack, &met, k, ray, best.limit);
                if let Some(distance) = found.and_then(|found| best.offer(found)) {
                    probe.shorten(distance);
                }
            }
        }
    }

    /// The nearest lamp that a ray meets before `t_max`.
    fn nearest_lamp<N: Needs>(&self, ray: &Ray<S>, mut t_max: S) -> Option<Hit<S>> {
        let mut hit = None;
        if N::VISIBLE_LAMPS {
            for (i, lamp) in self.lamps.iter().enumerate() {
                if lamp.radius > S::ZERO
                    && let Some(distance) = sphere::intersect(lamp.position, lamp.radius, ray, t_max)
                {
                    t_max = distance;
                    hit = Some(Hit { distance, object: Object::Lamp(i) });
                }
            }
        }
        hit
    }

    /// Whether `shade` lets light through what a ray meets of some packs.
    #[inline(always)]
    fn is_open<N: Needs>(
        &self,
        packs: &[Pack],
        ray: &Ray<S>,
        t_max: S,
        probe: &Probe,
        shade: &mut impl FnMut(&Material<S>) -> bool,
    ) -> bool {
        for pack in packs {
            let met = probe.meet(pack);
            for k in met.items() {
                if let Some(&item) = pack.items.get(k)
                    && !matches!(item, Item::Lamp(_))
                    && self.meet_lane::<N>(pack, &met, k, ray, t_max).is_some()
                    && !self.item_material(item).is_none_or(&mut *shade)
                {
                    return false;
                }
            }
        }
        true
    }

    /// What part of a lamp's light comes through from `t_max` along a shadow ray: 0 behind anything that is not
    /// transparent, else the product of kt over the transparent objects on the way, once for each. Cylinders end at the
    /// height `lid`.
    pub fn transmittance<N: Needs>(&self, ray: &Ray<S>, t_max: S, lid: S) -> S::Unit {
        let mut light = S::Unit::ONE;
        // The part that is left, or 0 and no need to look further.
        let mut shade = |material: &Material<S>| match material.glass::<N>() {
            Some(glass) if N::TRANSPARENT_SHADOWS => {
                light = light.times(glass.kt);
                light > S::Unit::ZERO
            }
            _ => {
                light = S::Unit::ZERO;
                false
            }
        };
        if self.is_laned::<N>() {
            let probe = Probe::new(&self.lanes, ray, t_max);
            if self.lanes.nodes.is_empty() {
                if !self.is_open::<N>(self.lanes.packs, ray, t_max, &probe, &mut shade) {
                    return S::Unit::ZERO;
                }
            } else {
                let mut waiting = Waiting::new();
                let mut search = Search::new(probe, self.lanes.nodes, &mut waiting);
                while let Some(packs) = search.leaf() {
                    if !self.is_open::<N>(packs, ray, t_max, &search.probe, &mut shade) {
                        return S::Unit::ZERO;
                    }
                }
            }
        } else if self.is_boxed::<N>() {
            let is_open = self.boxes.all(ray, t_max, |item| {
                let hit = self.meet::<N>(item, ray, t_max);
                hit.and_then(|hit| self.material(hit.object)).is_none_or(&mut shade)
            });
            if !is_open {
                return S::Unit::ZERO;
            }
        } else {
            if N::SPHERES {
                let mut walk = Walk::<S, N>::new(self.hierarchy, self.spheres);
                while let Some((_, sphere)) = walk.next(ray, t_max) {
                    if sphere.intersect(ray, t_max).is_some() && !shade(&sphere.material) {
                        return S::Unit::ZERO;
                    }
                }
            }
            if N::ELLIPSOIDS {
                for ellipsoid in self.ellipsoids {
                    if ellipsoid.intersect(ray, t_max).is_some() && !shade(&ellipsoid.material) {
                        return S::Unit::ZERO;
                    }
                }
            }
            if N::CONES {
                for cone in self.cones {
                    if cone.intersect(ray, t_max).is_some() && !shade(&cone.material) {
                        return S::Unit::ZERO;
                    }
                }
            }
            if N::TRIANGLES {
                for triangle in self.triangles {
                    if triangle.intersect(ray, t_max).is_some() && !shade(&triangle.material) {
                        return S::Unit::ZERO;
                    }
                }
            }
        }
        if N::CYLINDERS {
            for cylinder in self.cylinders {
                if cylinder.intersect(ray, t_max, lid).is_some() && !shade(&cylinder.material) {
                    return S::Unit::ZERO;
                }
            }
        }
        if N::FLOOR
            && let Some(floor) = &self.floor
            && floor.intersect(ray).is_some_and(|t| t < t_max)
        {
            return S::Unit::ZERO;
        }
        light
    }

    /// What is seen along a ray: the surface of what it hits, or the radiance of a lamp or of the sky.
    pub(crate) fn look<N: Needs>(&self, ray: &Ray<S>, limits: &Limits<S>) -> Seen<'_, S> {
        let hit = self.nearest::<N>(ray, limits.lid);
        if N::VISIBLE_LAMPS
            && let Some(Hit { object: Object::Lamp(i), .. }) = hit
            && let Some(lamp) = self.lamps.get(i)
        {
            return Seen::Light(lamp.radiance());
        }
        // One arm for each kind; an index is always that of a thing in its list.
        let found = hit.and_then(|Hit { distance, object }| match object {
            Object::Floor if N::FLOOR => self.floor.as_ref().map(|floor| {
                let (spot, color) = floor.spot(ray, distance, limits.reach);
                (spot, color, &Material::Opaque, S::ZERO)
            }),
            Object::Cylinder(i) if N::CYLINDERS => {
                self.cylinders.get(i).map(|c| (c.spot(ray, distance), c.color, &c.material, c.radius))
            }
            Object::Ellipsoid(i) if N::ELLIPSOIDS => self
                .ellipsoids
                .get(i)
                .map(|e| (e.spot(ray, distance), e.color, &e.material, e.extent.squashed(e.thickness))),
            Object::Cone(i) if N::CONES => {
                self.cones.get(i).map(|c| (c.spot(ray, distance), c.color, &c.material, c.extent()))
            }
            Object::Triangle(i) if N::TRIANGLES => {
                self.triangles.get(i).map(|t| (t.spot::<N>(ray, distance), t.color, &t.material, t.extent))
            }
            Object::Sphere(i) if N::SPHERES => {
                self.spheres.get(i).map(|s| (s.spot(ray, distance), s.color, &s.material, s.radius))
            }
            _ => None,
        });
        let Some((spot, color, material, extent)) = found else {
            return Seen::Light(self.sky.radiance::<N>(ray.direction));
        };
        let inside = spot.normal.dot(ray.direction) > S::Unit::ZERO;
        let surface = Surface {
            point: spot.point,
            normal: if inside { -spot.normal } else { spot.normal },
            incoming: ray.direction,
            distance: spot.distance,
            inside,
            color,
            material,
        };
        Seen::Surface(surface, extent)
    }
}

/// What a ray sees.
pub(crate) enum Seen<'a, S: Scalar> {
    /// The sky or a lamp.
    Light(Rgb<S::Light>),
    /// A surface, and the size of the object it belongs to.
    Surface(Surface<'a, S>, S),
}
