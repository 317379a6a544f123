//! A new illumination model, outside the core: it implements one trait, and a tracer takes it as it takes any other.
//!
//! A model of the core is such a file in `core/src/illumination/` and one line in the list of `core/src/illumination.rs`, from which
//! command line, help, window, baking and studies follow.

use rta_core::illumination::Secondary;
use rta_core::light::Incident;
use rta_core::prelude::*;
use rta_core::surface::Surface;

/// Diffuse surfaces that also send back light of lamps behind them, as paper does: `I = Ia C + sum |N.L| E C`.
#[derive(Clone, Copy, Debug, Default)]
struct Paper;

impl<S: Scalar> Illumination<S> for Paper {
    /// No ray is spawned, so that any weight will do.
    type Weight = S::Unit;
    const BOTH_SIDES: bool = true;

    fn ambient<N: Needs>(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        ambient.zip(surface.color, Light::times)
    }

    fn is_lit<N: Needs>(&self, _surface: &Surface<S>) -> bool {
        true
    }

    fn direct<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light> {
        let cosine = if incident.cosine < S::Unit::ZERO { -incident.cosine } else { incident.cosine };
        let light = incident.irradiance().times(cosine);
        surface.color.zip(incident.lamp.tint, |color, part| light.times(color.times(part)))
    }

    fn secondary<N: Needs>(&self, _surface: &Surface<S>) -> Secondary<S::Unit> {
        Secondary::NONE
    }
}

/// Looks at a sheet, the floor of a scene, from below: it glows in the light of the lamp above.
pub(crate) fn main() {
    let lamp = Lamp::white(Xyz::new(length(0), length(0), length(2)), length(0), 4);
    let scene = Scene { lamps: &[lamp], ..Scene::day() };
    let up = UnitVec3::<rta_core::Q16>::Z;
    let eye = Camera::new(Xyz::new(length(1), length(1), length(-3)), up, Lens::new(1, 1, (1, 1)));
    let radiance = |is_paper: bool| {
        let admitted = scene.admit(&eye).expect("a small scene fits");
        let light = if is_paper {
            Tracer::<_, _, Everything, 1>::new(&admitted, Paper, 1).map(|t| t.radiance(eye.eye, up))
        } else {
            Tracer::<_, _, Everything, 1>::new(&admitted, Rta, 1).map(|t| t.radiance(eye.eye, up))
        };
        light.expect("a stack as deep as the rays").g.0
    };
    let (paper, opaque) = (radiance(true), radiance(false));
    println!("the sheet sends back {paper}, an opaque one {opaque}");
    assert!(paper > opaque, "light comes through");
}

fn length(n: i32) -> rta_core::Q16 {
    rta_core::Q16::from_num(n)
}
