//! Finds which constants of [`Needs`] a scene uses; a program that draws only this scene can set the others to false.

use rta_core::color::Rgb;
use rta_core::material::{Finish, Material};
use rta_core::needs::{Everything, Needs, Used};
use rta_core::scalar::{Scalar, Unit};
use rta_core::scene::Scene;
use rta_core::texture::{Pattern, Shading};

/// Returns what a scene uses. `specular` is the illumination model's
/// [`SPECULAR`](rta_core::illumination::Illumination::SPECULAR).
pub fn by<S: Scalar>(scene: &Scene<S>, specular: bool) -> Used {
    let mut used = scene.kinds();
    let has_objects = used != Used::default();
    used.normals = scene.triangles.iter().any(|triangle| triangle.normals.is_some());
    let (mut shiny, mut mirror, mut diffuse) = (false, false, false);
    scene.surfaces(|_, _, material| match material {
        Material::Opaque => diffuse = true,
        Material::Shiny => (shiny, diffuse) = (true, true),
        Material::Mirror => mirror = true,
        Material::Transparent(_) => used.glass = true,
        Material::Finish(Finish { kd, glass, .. }) => {
            used.finish = true;
            used.glass |= material.glass::<Everything>().is_some();
            mirror |= glass.ks > S::Unit::ZERO;
            shiny |= specular && glass.ks > S::Unit::ZERO;
            diffuse |= *kd > S::Unit::ZERO;
        }
    });
    used.floor = scene.floor.is_some();
    used.tiles = scene.floor.is_some_and(|floor| floor.tile.is_some());
    used.sky_gradient = scene.sky.horizon != scene.sky.zenith;
    used.visible_lamps = scene.lamps.iter().any(|lamp| lamp.radius > S::ZERO);
    used.mirror = used.glass || mirror || (specular && shiny);
    used.lamps = !scene.lamps.is_empty() && (diffuse || (specular && has_objects));
    used.glint = used.lamps && (shiny || (specular && used.mirror));
    used.several_lamps = used.lamps && scene.lamps.len() > 1;
    used.attenuation = used.lamps && !specular;
    used.shadows = used.lamps;
    for coat in scene.coats.iter().take(scene.materials.len()) {
        used.coats = true;
        let is_bumped = coat.bump.is_some();
        (used.bumps, used.normals) = (used.bumps | is_bumped, used.normals | is_bumped);
        used.meshes |= used.normals && (coat.shading != Shading::Normals || coat.view.is_some());
        used.surroundings |= coat.surroundings && used.mirror;
        used.emission |= coat.emission != Rgb::BLACK;
        let patterns = coat.texture.iter().chain(coat.bump.iter().map(|bump| &bump.texture));
        for texture in patterns {
            match texture.pattern {
                Pattern::Checker => used.checker = true,
                Pattern::Marble { .. } => used.marble = true,
                Pattern::Wood { .. } => used.wood = true,
                Pattern::Image(_) => used.images = true,
            }
        }
    }
    used.sky_map = scene.coats.len() > scene.materials.len();
    used.transparent_shadows = used.lamps && used.glass;
    used
}

/// Returns the name of the first constant that is false in `N` although the scene uses it with a model that is not specular,
/// such as [`Rta`](rta_core::illumination::Rta); `None` if there is none. Shadows may be left out on purpose.
pub fn missing<N: Needs, S: Scalar>(scene: &Scene<S>) -> Option<&'static str> {
    let waived = |name| !N::SHADOWS && matches!(name, "SHADOWS" | "TRANSPARENT_SHADOWS");
    let (uses, there) = (by(scene, false).named(), Used::of::<N>().named());
    uses.into_iter()
        .zip(there)
        .find(|&((name, used), (_, there))| used && !there && !waived(name))
        .map(|((name, _), _)| name)
}
