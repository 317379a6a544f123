//! A scene as the language can say it: everything that an object is made of has a name.

use std::collections::{HashMap, HashSet};

use rta_core::scene::Object;

use super::builtin;
use super::lamp::{place_distant, sphere_of};
use super::line::is_name;
use super::material::MOST_EXPONENT;
use super::view::{SCREEN, SIZE, is_square};
use crate::description::{Description, FallOff, Kind, LampShape, Material, Settings, Surface};
use crate::space::difference;

/// What tells surfaces apart that become materials: a kind, and the bits of its numbers.
type Key = [u64; 6];

fn key(surface: &Surface) -> Option<Key> {
    match *surface {
        Surface::Opaque | Surface::Shiny | Surface::Mirror => None,
        Surface::Of(number) => Some([0, number.into(), 0, 0, 0, 0]),
        Surface::Transparent { ks, kt, ior } => Some([1, ks.to_bits(), kt.to_bits(), ior.to_bits(), 0, 0]),
        Surface::Finish { kd, ks, exponent, kt, ior } => {
            Some([2, kd.to_bits(), ks.to_bits(), exponent.to_bits(), kt.to_bits(), ior.to_bits()])
        }
    }
}

impl Description {
    /// Returns the scene as the scene language says it, which draws the same picture:
    /// surfaces with coefficients of their own are materials with names, in the order in which they are first used; what has no
    /// meaning where it stands is left out, such as an exponent without highlights; and lamps that are no spheres have the spheres
    /// that stand for them.
    ///
    /// What [`to_rta`](Self::to_rta) writes reads back as this, but for the lines.
    #[must_use]
    pub fn named(mut self) -> Self {
        let before = core::mem::take(&mut self.materials);
        let (mut numbers, mut materials) = (HashMap::new(), Vec::new());
        for surface in self.surfaces() {
            let Some(key) = key(surface) else { continue };
            let number = *numbers.entry(key).or_insert_with(|| {
                materials.push(simple(surface, &before));
                materials.len() - 1
            });
            // There are not more of them than there were, but for hand-made scenes with 65536 kinds of glass.
            *surface = u16::try_from(number).map_or(Surface::Opaque, Surface::Of);
        }
        self.materials = materials;
        self.name_materials();
        self.settle_paths();
        self.settle_details();
        self.settle_settings();
        self
    }

    /// All surfaces, in the order in which a scene is written.
    fn surfaces(&mut self) -> impl Iterator<Item = &mut Surface> {
        let floor = self.floor.iter_mut().map(|floor| &mut floor.surface);
        let cylinders = self.cylinders.iter_mut().map(|own| &mut own.surface);
        let ellipsoids = self.ellipsoids.iter_mut().map(|own| &mut own.surface);
        let spheres = self.spheres.iter_mut().map(|own| &mut own.surface);
        let cones = self.cones.iter_mut().map(|own| &mut own.surface);
        let triangles = self.triangles.iter_mut().map(|own| &mut own.surface);
        let planes = self.planes.iter_mut().map(|own| &mut own.surface);
        floor.chain(cylinders).chain(ellipsoids).chain(spheres).chain(cones).chain(triangles).chain(planes)
    }

    /// Gives a name to materials that have none, or one that is taken.
    fn name_materials(&mut self) {
        let mut taken: HashSet<String> = HashSet::new();
        let mut nameless = Vec::new();
        for (number, material) in self.materials.iter_mut().enumerate() {
            let is_own = is_name(&material.name)
                && (builtin::material(&material.name).is_none() || is_builtin(material));
            if !is_own || !taken.insert(material.name.clone()) {
                nameless.push((number, material));
            }
        }
        for (number, material) in nameless {
            let mut name = format!("material-{}", number + 1);
            while taken.contains(&name) || builtin::material(&name).is_some() {
                name.push('x');
            }
            taken.insert(name.clone());
            material.name = name;
        }
    }

    /// Leaves out what goes along paths that there are none of, or does not go at all.
    fn settle_paths(&mut self) {
        let details = &mut self.details;
        let (paths, lamps) = (&details.paths, self.lamps.len());
        let is_path = |name: &String| paths.iter().any(|path| path.name == *name);
        details.objects.values_mut().for_each(|detail| detail.along = detail.along.take().filter(is_path));
        let is_distant = |number: &usize| matches!(details.lamps.get(number), Some(LampShape::Toward(_)));
        details.lamp_paths.retain(|number, path| *number < lamps && is_path(path) && !is_distant(number));
        details.lamp_moves.retain(|number, _| *number < lamps && !is_distant(number));
        details.journey = details.journey.take().filter(|journey| is_path(&journey.path));
        if let Some(journey) = &mut details.journey {
            // The direction of view is that to the aim.
            journey.aim = journey.aim.filter(|aim| difference(*aim, self.camera.eye) == self.camera.view);
        }
    }

    fn settle_details(&mut self) {
        let [ellipsoids, spheres, cones, cylinders, triangles, planes] = [
            self.ellipsoids.len(),
            self.spheres.len(),
            self.cones.len(),
            self.cylinders.len(),
            self.triangles.len(),
            self.planes.len(),
        ];
        self.details.objects.retain(|object, detail| {
            let (number, most) = match *object {
                Object::Ellipsoid(number) => (number, ellipsoids),
                Object::Sphere(number) => (number, spheres),
                Object::Cone(number) => (number, cones),
                Object::Cylinder(number) => (number, cylinders),
                Object::Triangle(number) => (number, triangles),
                Object::Plane(number) => (number, planes),
                _ => return false,
            };
            if !matches!(object, Object::Triangle(_)) {
                (detail.shading, detail.uv) = Default::default();
            }
            usize::try_from(number).is_ok_and(|number| number < most) && *detail != Default::default()
        });
        self.details.tile = self.details.tile.filter(|tile| *tile != 3.0 && self.floor.is_some());
        if self.details.sky_map.is_some() {
            (self.sky.horizon, self.sky.zenith) = ([0.0; 3], [0.0; 3]);
        }
        let lamps = &mut self.lamps;
        self.details.lamps.retain(|number, shape| {
            let Some(lamp) = lamps.get_mut(*number) else { return false };
            match *shape {
                LampShape::Toward(_) => (lamp.radius, lamp.fall_off) = (0.0, FallOff::Constant),
                LampShape::Area { corner, edges } => {
                    let Some(sphere) = sphere_of(corner, edges) else { return false };
                    (lamp.position, lamp.radius) = sphere;
                }
            }
            true
        });
        place_distant(self);
    }

    fn settle_settings(&mut self) {
        let Settings { screen, depth, samples, cutoff, .. } = self.settings;
        let says = screen.is_some() || depth.is_some() || samples.is_some() || cutoff.is_some();
        if self.raster.is_none() && says {
            (self.raster, self.settings.screen) = (Some(SIZE), Some(screen.unwrap_or(SCREEN)));
        }
        if let (Some(size), Some(screen)) = (self.raster, self.settings.screen)
            && is_square(size, screen)
        {
            self.settings.screen = None;
        }
    }
}

/// Returns the material of a surface, without what has no meaning there.
fn simple(surface: &Surface, materials: &[Material]) -> Material {
    let mut made = Material::of(surface, materials);
    if let Surface::Transparent { ks, kt, .. } | Surface::Finish { ks, kt, .. } = *surface {
        made.exponent = made.exponent.filter(|_| ks > 0.0);
        made.index = made.index.filter(|_| kt > 0.0);
    }
    if made.specular == Some(0.0) {
        made.exponent = made.exponent.map(|exponent| exponent.min(MOST_EXPONENT));
    }
    match made.kind {
        Kind::Glass => {
            made.index.get_or_insert(1.0);
            made.absorb.get_or_insert([1.0; 3]);
        }
        Kind::Metal if made.nk.is_none() => {
            made.metal.get_or_insert(made.color.unwrap_or([1.0; 3]));
        }
        _ => {}
    }
    made
}

/// Returns whether a material is one that every scene knows.
pub(super) fn is_builtin(material: &Material) -> bool {
    let own = builtin::material(&material.name).map(|own| Material { line: material.line, ..own });
    let is_type = matches!(material.name.as_str(), "opaque" | "shiny" | "mirror");
    !is_type && own.as_ref() == Some(material)
}
