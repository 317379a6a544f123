//! What a scene does not need is not in the program.
//!
//! Each constant gates one branch of the tracer. A program that draws one scene names only what that scene uses, and
//! the compiler leaves the rest out.
//!
//! ```
//! use rta_core::prelude::*;
//! /// Spheres on a floor, one of them a mirror.
//! struct MirrorBall;
//! impl Needs for MirrorBall {
//!     const ELLIPSOIDS: bool = false;
//!     const CYLINDERS: bool = false;
//!     const GLINT: bool = false;
//!     const GLASS: bool = false;
//! }
//! ```

use crate::material::{Finish, Material};
use crate::scalar::{Scalar, Unit};
use crate::scene::Scene;

/// What a program must be able to draw. All of it is true unless said otherwise.
pub trait Needs: Send + Sync + 'static {
    /// Spheres.
    const SPHERES: bool = true;
    /// A [hierarchy](crate::hierarchy) over the spheres.
    const HIERARCHY: bool = true;
    /// Ellipsoids.
    const ELLIPSOIDS: bool = true;
    /// Cones and cylinders between two points.
    const CONES: bool = true;
    /// Triangles.
    const TRIANGLES: bool = true;
    /// Triangles with normals at their vertices.
    const NORMALS: bool = true;
    /// A [hierarchy of boxes](crate::bvh) over all finite objects, or [lanes](crate::lanes).
    const BOXES: bool = true;
    /// Vertical cylinders.
    const CYLINDERS: bool = true;
    /// The chequered floor.
    const FLOOR: bool = true;
    /// A sky whose zenith differs from its horizon.
    const SKY_GRADIENT: bool = true;
    /// Lamps with a radius, which a ray can see.
    const VISIBLE_LAMPS: bool = true;
    /// Highlights on shiny surfaces.
    const GLINT: bool = true;
    /// Reflected rays. Without them, and so without transmitted ones, there is no ray tree and no stack for it.
    const MIRROR: bool = true;
    /// Transmitted rays; they take [`Needs::MIRROR`] for total internal reflection.
    const GLASS: bool = true;
    /// Surfaces with coefficients of their own.
    const FINISH: bool = true;
    /// Lamps.
    const LAMPS: bool = true;
    /// More than one lamp; without it only the first one shines.
    const SEVERAL_LAMPS: bool = true;
    /// Surfaces whose light falls off with the distance to the lamp.
    const ATTENUATION: bool = true;
    /// Shadows.
    const SHADOWS: bool = true;
    /// Transparent objects let part of the light through into their shadow.
    const TRANSPARENT_SHADOWS: bool = true;
}

/// Everything there is: what a program needs that reads its scene when it runs.
#[derive(Clone, Copy, Debug)]
pub struct Everything;

impl Needs for Everything {}

/// The needs of one scene with the illumination model [`Rta`](crate::illumination::Rta): the same constants as values.
///
/// [`Whitted`](crate::illumination::Whitted) reflects and shows highlights on more materials, which `specular` tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(clippy::struct_excessive_bools, missing_docs)] // each is the constant of the same name
pub struct Used {
    pub spheres: bool,
    pub hierarchy: bool,
    pub ellipsoids: bool,
    pub cones: bool,
    pub triangles: bool,
    pub normals: bool,
    pub boxes: bool,
    pub cylinders: bool,
    pub floor: bool,
    pub sky_gradient: bool,
    pub visible_lamps: bool,
    pub glint: bool,
    pub mirror: bool,
    pub glass: bool,
    pub finish: bool,
    pub lamps: bool,
    pub several_lamps: bool,
    pub attenuation: bool,
    pub shadows: bool,
    pub transparent_shadows: bool,
}

impl Used {
    /// What a scene uses. `specular` is whether shiny surfaces reflect, and mirrors and glass show highlights: not in
    /// the model `Rta`, but in `Whitted`.
    pub fn by<S: Scalar>(scene: &Scene<S>, specular: bool) -> Self {
        let materials = || {
            let spheres = scene.spheres.iter().map(|s| &s.material);
            let ellipsoids = scene.ellipsoids.iter().map(|e| &e.material);
            let cones = scene.cones.iter().map(|c| &c.material);
            let triangles = scene.triangles.iter().map(|t| &t.material);
            let cylinders = scene.cylinders.iter().map(|c| &c.material);
            spheres.chain(ellipsoids).chain(cones).chain(triangles).chain(cylinders)
        };
        let glass = materials().any(|m| m.glass::<Everything>().is_some());
        let finish = |test: fn(&Finish<S>) -> bool| {
            materials().any(|m| matches!(m, Material::Finish(finish) if test(finish)))
        };
        let specular_finish = finish(|finish| finish.glass.ks > S::Unit::ZERO);
        let shiny = materials().any(|m| matches!(m, Material::Shiny)) || (specular && specular_finish);
        let mirror = glass
            || specular_finish
            || materials().any(|m| matches!(m, Material::Mirror))
            || (specular && shiny);
        let floor = scene.floor.is_some();
        let lit = floor
            || finish(|finish| finish.kd > S::Unit::ZERO)
            || materials().any(|m| specular || matches!(m, Material::Opaque | Material::Shiny));
        let lamps = lit && !scene.lamps.is_empty();
        Self {
            spheres: !scene.spheres.is_empty(),
            hierarchy: !scene.hierarchy.is_empty(),
            ellipsoids: !scene.ellipsoids.is_empty(),
            cones: !scene.cones.is_empty(),
            triangles: !scene.triangles.is_empty(),
            normals: scene.triangles.iter().any(|triangle| triangle.normals.is_some()),
            boxes: !scene.boxes.nodes.is_empty(),
            cylinders: !scene.cylinders.is_empty(),
            floor,
            sky_gradient: scene.sky.horizon != scene.sky.zenith,
            visible_lamps: scene.lamps.iter().any(|lamp| lamp.radius > S::ZERO),
            glint: lamps && (shiny || (specular && mirror)),
            mirror,
            glass,
            finish: finish(|_| true),
            lamps,
            several_lamps: lamps && scene.lamps.len() > 1,
            attenuation: lamps && !specular,
            shadows: lamps,
            transparent_shadows: lamps && glass,
        }
    }

    /// The constants of `N` as values, and their names.
    pub const fn of<N: Needs>() -> Self {
        Self {
            spheres: N::SPHERES,
            hierarchy: N::HIERARCHY,
            ellipsoids: N::ELLIPSOIDS,
            cones: N::CONES,
            triangles: N::TRIANGLES,
            normals: N::NORMALS,
            boxes: N::BOXES,
            cylinders: N::CYLINDERS,
            floor: N::FLOOR,
            sky_gradient: N::SKY_GRADIENT,
            visible_lamps: N::VISIBLE_LAMPS,
            glint: N::GLINT,
            mirror: N::MIRROR,
            glass: N::GLASS,
            finish: N::FINISH,
            lamps: N::LAMPS,
            several_lamps: N::SEVERAL_LAMPS,
            attenuation: N::ATTENUATION,
            shadows: N::SHADOWS,
            transparent_shadows: N::TRANSPARENT_SHADOWS,
        }
    }

    /// Each constant's name and value.
    pub const fn named(self) -> [(&'static str, bool); 20] {
        [
            ("SPHERES", self.spheres),
            ("HIERARCHY", self.hierarchy),
            ("ELLIPSOIDS", self.ellipsoids),
            ("CONES", self.cones),
            ("TRIANGLES", self.triangles),
            ("NORMALS", self.normals),
            ("BOXES", self.boxes),
            ("CYLINDERS", self.cylinders),
            ("FLOOR", self.floor),
            ("SKY_GRADIENT", self.sky_gradient),
            ("VISIBLE_LAMPS", self.visible_lamps),
            ("GLINT", self.glint),
            ("MIRROR", self.mirror),
            ("GLASS", self.glass),
            ("FINISH", self.finish),
            ("LAMPS", self.lamps),
            ("SEVERAL_LAMPS", self.several_lamps),
            ("ATTENUATION", self.attenuation),
            ("SHADOWS", self.shadows),
            ("TRANSPARENT_SHADOWS", self.transparent_shadows),
        ]
    }
}

/// The name of the first constant that is false in `N` although the scene uses what it stands for, with the illumination
/// model `Rta`. Shadows may be left out on purpose, and a hierarchy only saves time.
pub fn missing<N: Needs, S: Scalar>(scene: &Scene<S>) -> Option<&'static str> {
    let waived = |name| {
        matches!(name, "HIERARCHY" | "BOXES")
            || (!N::SHADOWS && matches!(name, "SHADOWS" | "TRANSPARENT_SHADOWS"))
    };
    let (used, there) = (Used::by(scene, false).named(), Used::of::<N>().named());
    used.into_iter()
        .zip(there)
        .find(|&((name, used), (_, there))| used && !there && !waived(name))
        .map(|((name, _), _)| name)
}
