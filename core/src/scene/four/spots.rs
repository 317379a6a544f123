//! What four rays beside each other see.

use glam::{BVec4A, Vec3, Vec4};

use super::Nearest;
use crate::bvh::Bits;
use crate::color::Rgb;
use crate::illumination::Surface;
use crate::lanes::geometry::{Ray4, Spot4, on_floor};
use crate::lanes::vectors::{Vec3x4, lane, mask, one, one_mut, set};
use crate::material::Material;
use crate::needs::Needs;
use crate::range::Limits;
use crate::scene::{Floor, Hit, Object, Place, Scene};

/// What four rays see.
pub(crate) struct Spots<'a> {
    /// Which see a surface: the others see the sky, or a lamp.
    pub(crate) on: u32,
    pub(crate) lights: [Rgb<f32>; 4],
    /// The normals are turned towards the rays' origins.
    pub(crate) spot: Spot4,
    pub(crate) inside: BVec4A,
    /// The sizes of the objects.
    pub(crate) extent: Vec4,
    colors: [Rgb<f32>; 4],
    materials: [&'a Material<f32>; 4],
}

impl<'a> Spots<'a> {
    /// Nothing.
    pub(crate) const NONE: Self = Self {
        on: 0,
        lights: [Rgb::BLACK; 4],
        spot: Spot4::ZERO,
        inside: BVec4A::FALSE,
        extent: Vec4::ZERO,
        colors: [Rgb::BLACK; 4],
        materials: [&Material::Opaque; 4],
    };

    /// The surface that ray `k` sees.
    #[inline(always)]
    pub(crate) fn surface(&self, rays: &Ray4, k: usize) -> Surface<'a, f32> {
        Surface {
            point: self.spot.point.lane(k),
            normal: self.spot.normal.lane(k),
            incoming: rays.direction.lane(k),
            distance: lane(&self.spot.distance, k),
            inside: self.inside.test(k & 3),
            color: one(&self.colors, k),
            material: one(&self.materials, k),
        }
    }

    /// Some rays see the floor.
    #[inline(always)]
    fn add_floor(&mut self, floor: &Floor<f32>, rays: &Ray4, t: Vec4, which: u32) {
        let (point, odd) = on_floor(rays, t);
        self.replace(which, Spot4 { distance: t, point, normal: Vec3x4::splat(Vec3::Z) }, Vec4::ZERO);
        let [even_color, odd_color] = floor.colors;
        for k in Bits(which) {
            *one_mut(&mut self.colors, k) = if odd >> k & 1 == 1 { odd_color } else { even_color };
            *one_mut(&mut self.materials, k) = &Material::Opaque;
        }
    }

    /// Some rays see other surfaces.
    #[inline(always)]
    fn replace(&mut self, which: u32, spot: Spot4, extent: Vec4) {
        self.on |= which;
        let (which, old) = (mask(which), self.spot);
        self.spot = Spot4 {
            distance: Vec4::select(which, spot.distance, old.distance),
            point: Vec3x4::select(which, spot.point, old.point),
            normal: Vec3x4::select(which, spot.normal, old.normal),
        };
        self.extent = Vec4::select(which, extent, self.extent);
    }

    /// Ray `k` sees a surface.
    #[inline(always)]
    fn add(&mut self, k: usize, (spot, color, material, extent): Place<'a, f32>) {
        self.on |= 1 << k;
        set(&mut self.spot.distance, k, spot.distance);
        self.spot.point.set(k, spot.point);
        self.spot.normal.set(k, spot.normal);
        set(&mut self.extent, k, extent);
        *one_mut(&mut self.colors, k) = color;
        *one_mut(&mut self.materials, k) = material;
    }
}

impl<'a> Scene<'_, f32> {
    /// What four rays see where they meet something, or where not.
    #[inline(always)]
    pub(crate) fn see_four<N: Needs>(
        &'a self,
        rays: &Ray4,
        nearest: &Nearest,
        there: u32,
        limits: &Limits<f32>,
        spots: &mut Spots<'a>,
    ) {
        let (mut on_spheres, mut on_triangles, mut on_floor) = (0, 0, 0);
        let near = nearest.distance.cmple(Vec4::splat(limits.reach)).bitmask();
        for k in Bits(there) {
            match one(&nearest.objects, k) {
                Some(Object::Sphere(_)) if N::SPHERES => on_spheres |= 1 << k,
                Some(Object::Triangle(i)) if N::TRIANGLES => {
                    let curved = N::NORMALS && self.triangles.get(i).is_none_or(|t| t.normals.is_some());
                    on_triangles |= u32::from(!curved) << k;
                }
                Some(Object::Floor) if N::FLOOR => on_floor |= near & 1 << k,
                _ => {}
            }
        }
        spots.on = on_spheres;
        if on_spheres != 0
            && let Some(any) = self.spheres.first()
        {
            let spheres = nearest.objects.map(|object| match object {
                Some(Object::Sphere(i)) => self.spheres.get(i).unwrap_or(any),
                _ => any,
            });
            spots.spot = Spot4::on_spheres(spheres, on_spheres, rays, nearest.distance);
            spots.colors = spheres.map(|sphere| sphere.color);
            spots.materials = spheres.map(|sphere| &sphere.material);
            let [a, b, c, d] = spheres.map(|sphere| sphere.radius);
            spots.extent = Vec4::new(a, b, c, d);
        }
        if on_triangles != 0
            && let Some(any) = self.triangles.first()
        {
            let triangles = nearest.objects.map(|object| match object {
                Some(Object::Triangle(i)) => self.triangles.get(i).unwrap_or(any),
                _ => any,
            });
            let [a, b, c, d] = triangles.map(|triangle| triangle.extent);
            spots.replace(on_triangles, Spot4::on_triangles(triangles, rays), Vec4::new(a, b, c, d));
            for k in Bits(on_triangles) {
                let triangle = one(&triangles, k);
                *one_mut(&mut spots.colors, k) = triangle.color;
                *one_mut(&mut spots.materials, k) = &triangle.material;
            }
        }
        if on_floor != 0
            && let Some(floor) = &self.floor
        {
            spots.add_floor(floor, rays, nearest.distance, on_floor);
        }
        for k in Bits(there & !spots.on) {
            let object = one(&nearest.objects, k);
            let hit = object.map(|object| Hit { distance: lane(&nearest.distance, k), object });
            let ray = rays.lane(k);
            if N::VISIBLE_LAMPS
                && let Some(Object::Lamp(i)) = object
                && let Some(lamp) = self.lamps.get(i)
            {
                *one_mut(&mut spots.lights, k) = lamp.radiance();
            } else if let Some(place) = hit.and_then(|hit| self.place::<N>(&ray, hit, limits.reach)) {
                spots.add(k, place);
            } else {
                *one_mut(&mut spots.lights, k) = self.sky.radiance::<N>(ray.direction);
            }
        }
        let normal = spots.spot.normal;
        spots.inside = normal.dot(rays.direction).cmpgt(Vec4::ZERO);
        spots.spot.normal = Vec3x4::select(spots.inside, -normal, normal);
    }
}
