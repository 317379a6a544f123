//! What four rays side by side see.

use glam::{BVec4A, Vec3, Vec4};
use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, Secondary};
use rta_core::material::Material;
use rta_core::needs::Needs;
use rta_core::ray::RayKind;
use rta_core::scene::{Floor, Hit, Object, PLAIN, Scene};
use rta_core::surface::Surface;
use rta_core::texture::Mesh;
use rta_core::trace::decision::{Aspects, can_light};
use rta_core::world::{Seen, World};

use super::closest::Hits4;
use super::geometry::{Ray4, SurfacePoint4, leave, on_floor, reflect};
use super::vector::{Vec3x4, lane, mask, one, one_mut, set};
use crate::leaf::{Bits, index};

/// What four rays see.
pub(crate) struct Surfaces4<'a> {
    /// Which see a surface: the others see the sky, or a lamp.
    pub(crate) on: u32,
    pub(crate) lights: [Rgb<f32>; 4],
    /// The normals are turned towards the rays' origins.
    pub(crate) spot: SurfacePoint4,
    pub(crate) inside: BVec4A,
    /// A bit for each whose normal is interpolated, and for these the normals of their flat faces, turned likewise.
    curved: u32,
    faces: Vec3x4,
    /// The sizes of the objects.
    pub(crate) extent: Vec4,
    colors: [Rgb<f32>; 4],
    pub(crate) materials: [&'a Material<f32>; 4],
    /// The materials' numbers.
    numbers: [u16; 4],
    /// A bit for each whose mirror ray sees the sky alone.
    pub(crate) surroundings: u32,
    /// A bit for each that is a triangle not shaded by its mixed normals alone, and these triangles.
    pub(crate) meshed: u32,
    meshes: [Option<Mesh<'a, f32>>; 4],
}

impl<'a> Surfaces4<'a> {
    /// Nothing.
    pub(crate) const NONE: Self = Self {
        on: 0,
        lights: [Rgb::BLACK; 4],
        spot: SurfacePoint4::ZERO,
        inside: BVec4A::FALSE,
        curved: 0,
        faces: Vec3x4::ZERO,
        extent: Vec4::ZERO,
        colors: [Rgb::BLACK; 4],
        materials: [&Material::Opaque; 4],
        numbers: [PLAIN; 4],
        surroundings: 0,
        meshed: 0,
        meshes: [None; 4],
    };

    /// The surface that ray `k` sees.
    #[inline(always)]
    pub(crate) fn surface(&self, rays: &Ray4, k: usize) -> Surface<'a, f32> {
        Surface {
            point: self.spot.point.lane(k),
            normal: self.spot.normal.lane(k),
            face: (self.curved >> k & 1 == 1).then(|| self.faces.lane(k)),
            incoming: rays.direction.lane(k),
            distance: lane(&self.spot.distance, k),
            inside: self.inside.test(k & 3),
            extent: lane(&self.extent, k),
            color: one(&self.colors, k),
            material: one(&self.materials, k),
            number: one(&self.numbers, k),
            // Told apart by its bit.
            surroundings: false,
            // Asked for apart.
            mesh: None,
        }
    }

    /// The surface that ray `k` sees, with all that is told of it.
    #[inline(never)] // most surfaces need no more than [`Surfaces4::surface`]
    pub(crate) fn whole(&self, rays: &Ray4, k: usize) -> Surface<'a, f32> {
        let has = |bits: u32| bits >> k & 1 == 1;
        let mesh = one(&self.meshes, k).filter(|_| has(self.meshed));
        Surface { mesh, surroundings: has(self.surroundings), ..self.surface(rays, k) }
    }

    /// The number of the material that ray `k` sees.
    #[inline(always)]
    pub(crate) fn number(&self, k: usize) -> u16 {
        one(&self.numbers, k)
    }

    /// What stands for the surface that ray `k` sees, a triangle not shaded by its mixed normals alone.
    #[inline(never)] // scenes without meshes do not pay for it
    pub(crate) fn aspects<N: Needs>(&self, rays: &Ray4, k: usize) -> Option<Aspects<'a, f32>> {
        let mesh = one(&self.meshes, k)?;
        Some(Aspects::of::<N>(&self.surface(rays, k), &mesh))
    }

    /// Returns the weights of the secondary rays of such a surface.
    #[inline(never)]
    pub(crate) fn mesh_secondary<M: Illumination<f32>, N: Needs>(
        &self,
        model: &M,
        rays: &Ray4,
        k: usize,
    ) -> Secondary<M::Weight> {
        self.aspects::<N>(rays, k).map_or(Secondary::NONE, |aspects| aspects.secondary::<M, N>(model))
    }

    /// Returns the unit normals of the surfaces themselves: four times [`Surface::side`].
    #[inline(always)]
    pub(crate) fn sides<N: Needs>(&self) -> Vec3x4 {
        if N::NORMALS && self.curved != 0 {
            Vec3x4::select(mask(self.curved), self.faces, self.spot.normal)
        } else {
            self.spot.normal
        }
    }

    /// Returns which of four lamps are behind the surfaces: four times [`Surface::is_behind`].
    #[inline(always)]
    pub(crate) fn are_behind<N: Needs>(&self, direction: Vec3x4, cosine: Vec4) -> BVec4A {
        let mut behind = cosine.cmple(Vec4::ZERO);
        if N::MESHES && self.meshed != 0 {
            behind &= !mask(self.meshed);
        }
        if N::NORMALS && self.curved != 0 {
            behind | mask(self.curved) & self.faces.dot(direction).cmple(Vec4::ZERO)
        } else {
            behind
        }
    }

    /// Returns which of four surfaces a lamp can light, which is behind those in `behind`: four times
    /// [`is_reached`](rta_core::illumination::Illumination::is_reached). Bits from the fifth on mean nothing.
    #[inline(always)]
    pub(crate) fn are_lit<M: Illumination<f32>>(&self, behind: BVec4A) -> u32 {
        let (behind, inside) = (behind.bitmask(), self.inside.bitmask());
        let through = |which, inside| if can_light::<f32, M>(inside, || true) { which } else { 0 };
        !behind | through(inside, true) | through(!inside, false)
    }

    /// Returns the secondary rays of the directions, on the side of the normals where they leave: four times [`Surface::fold`].
    #[inline(always)]
    pub(crate) fn secondary<N: Needs>(&self, direction: Vec3x4, leaves: bool) -> Ray4 {
        let (mut direction, side) = (direction, self.sides::<N>());
        let side = if leaves { side } else { -side };
        if N::NORMALS && self.curved != 0 {
            let is_wrong = mask(self.curved) & side.dot(direction).cmplt(Vec4::ZERO);
            direction = Vec3x4::select(is_wrong, reflect(direction, side), direction);
        }
        Ray4 { origin: leave(self.spot.point, side, direction, self.extent).0, direction }
    }

    /// Ray `k` sees a material.
    #[inline(always)]
    fn set_material(&mut self, scene: &Scene<'a, f32>, k: usize, number: u16) {
        *one_mut(&mut self.materials, k) = scene.material(number);
        *one_mut(&mut self.numbers, k) = number;
    }

    /// Some rays see the floor.
    #[inline(always)]
    fn add_floor(
        &mut self,
        (scene, floor): (&Scene<'a, f32>, &Floor<f32>),
        rays: &Ray4,
        t: Vec4,
        which: u32,
    ) {
        let (point, odd) = on_floor(floor, rays, t);
        self.replace(which, SurfacePoint4 { distance: t, point, normal: Vec3x4::splat(Vec3::Z) }, Vec4::ZERO);
        let [even_color, odd_color] = floor.colors;
        for k in Bits(which) {
            *one_mut(&mut self.colors, k) = if odd >> k & 1 == 1 { odd_color } else { even_color };
            self.set_material(scene, k, floor.material);
        }
    }

    /// Some rays see other surfaces.
    #[inline(always)]
    fn replace(&mut self, which: u32, spot: SurfacePoint4, extent: Vec4) {
        self.on |= which;
        let (which, old) = (mask(which), self.spot);
        self.spot = SurfacePoint4 {
            distance: Vec4::select(which, spot.distance, old.distance),
            point: Vec3x4::select(which, spot.point, old.point),
            normal: Vec3x4::select(which, spot.normal, old.normal),
        };
        self.extent = Vec4::select(which, extent, self.extent);
    }

    /// Ray `k` sees a surface, whose normal is not turned yet.
    #[inline(always)]
    fn add(&mut self, k: usize, surface: &Surface<'a, f32>) {
        self.on |= 1 << k;
        set(&mut self.spot.distance, k, surface.distance);
        self.spot.point.set(k, surface.point);
        self.spot.normal.set(k, if surface.inside { -surface.normal } else { surface.normal });
        if let Some(face) = surface.face {
            self.curved |= 1 << k;
            self.faces.set(k, face);
        }
        set(&mut self.extent, k, surface.extent);
        *one_mut(&mut self.colors, k) = surface.color;
        *one_mut(&mut self.materials, k) = surface.material;
        *one_mut(&mut self.numbers, k) = surface.number;
    }

    /// Finds what four rays see where they meet something, or where not. They come from the eye if `are_eyes`.
    #[inline(always)]
    pub(crate) fn see<N: Needs>(
        &mut self,
        world: &World<'a, f32>,
        rays: &Ray4,
        nearest: &Hits4,
        (there, are_eyes): (u32, bool),
    ) {
        let spots = self;
        let (mut on_spheres, mut on_triangles, mut on_floor) = (0, 0, 0);
        let near = nearest.distance.cmple(Vec4::splat(world.limits.floor_end)).bitmask();
        for k in Bits(there) {
            match one(&nearest.objects, k) {
                Some(Object::Sphere(_)) if N::SPHERES => on_spheres |= 1 << k,
                Some(Object::Triangle(i)) if N::TRIANGLES => {
                    let curved =
                        N::NORMALS && world.scene.triangles.get(index(i)).is_none_or(|t| t.normals.is_some());
                    on_triangles |= u32::from(!curved) << k;
                }
                Some(Object::Floor) if N::FLOOR => on_floor |= near & 1 << k,
                _ => {}
            }
        }
        (spots.on, spots.curved) = (on_spheres, 0);
        if on_spheres != 0
            && let Some(any) = world.scene.spheres.first()
        {
            let spheres = nearest.objects.map(|object| match object {
                Some(Object::Sphere(i)) => world.scene.spheres.get(index(i)).unwrap_or(any),
                _ => any,
            });
            spots.spot = SurfacePoint4::on_spheres(spheres, on_spheres, rays, nearest.distance);
            spots.colors = spheres.map(|sphere| sphere.color);
            spots.numbers = spheres.map(|sphere| sphere.material);
            spots.materials = spots.numbers.map(|number| world.scene.material(number));
            let [a, b, c, d] = spheres.map(|sphere| sphere.radius);
            spots.extent = Vec4::new(a, b, c, d);
        }
        if on_triangles != 0
            && let Some(any) = world.scene.triangles.first()
        {
            let triangles = nearest.objects.map(|object| match object {
                Some(Object::Triangle(i)) => world.scene.triangles.get(index(i)).unwrap_or(any),
                _ => any,
            });
            let [a, b, c, d] = triangles.map(|triangle| triangle.extent);
            spots.replace(on_triangles, SurfacePoint4::on_triangles(triangles, rays), Vec4::new(a, b, c, d));
            for k in Bits(on_triangles) {
                let triangle = one(&triangles, k);
                *one_mut(&mut spots.colors, k) = triangle.color;
                spots.set_material(&world.scene, k, triangle.material);
            }
        }
        if on_floor != 0
            && let Some(floor) = &world.scene.floor
        {
            spots.add_floor((&world.scene, floor), rays, nearest.distance, on_floor);
        }
        for k in Bits(there & !spots.on) {
            let object = one(&nearest.objects, k);
            let hit = object.map(|object| Hit { distance: lane(&nearest.distance, k), object });
            match world.seen::<N>(&world.planned::<N>(rays.lane(k), hit.as_ref()), hit) {
                Seen::Light(light) => *one_mut(&mut spots.lights, k) = light,
                Seen::Surface(surface) => spots.add(k, &surface),
            }
        }
        let normal = spots.spot.normal;
        spots.inside = normal.dot(rays.direction).cmpgt(Vec4::ZERO);
        spots.spot.normal = Vec3x4::select(spots.inside, -normal, normal);
        if N::COATS && !world.scene.coats.is_empty() {
            spots.cover_all::<N>(world, rays, nearest, are_eyes);
        }
    }

    /// Covers the surfaces with their materials' coats.
    #[inline(never)] // scenes without coats do not pay for it
    fn cover_all<N: Needs>(&mut self, world: &World<'a, f32>, rays: &Ray4, nearest: &Hits4, are_eyes: bool) {
        let kind = if are_eyes { RayKind::Primary } else { RayKind::Reflected };
        (self.surroundings, self.meshed) = (0, 0);
        for k in Bits(self.on) {
            let mut surface = self.surface(rays, k);
            if let Some(object) = one(&nearest.objects, k) {
                world.cover::<N>(&mut surface, object, kind);
            }
            self.cover(k, &surface);
        }
    }

    /// Surface `k` has been covered.
    fn cover(&mut self, k: usize, surface: &Surface<'a, f32>) {
        self.meshed |= u32::from(surface.mesh.is_some()) << k;
        *one_mut(&mut self.meshes, k) = surface.mesh;
        *one_mut(&mut self.colors, k) = surface.color;
        self.spot.normal.set(k, surface.normal);
        if let Some(face) = surface.face {
            self.curved |= 1 << k;
            self.faces.set(k, face);
        }
        self.surroundings |= u32::from(surface.surroundings) << k;
    }
}
