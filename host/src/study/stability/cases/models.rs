//! The cases of each illumination model: the ends of what its parameters and its angles may be.

use core::slice;

use rta_scenes::description::{
    Air, Attenuation, Description, Fading, Kind, Material, Medium, Slope, Surface,
};
use rta_scenes::model::Model;

use super::{Add, Aim, Case, Stand, Triple, empty};

/// There are many of these cases, and a place of a surface is all that they are about.
const THINNING: usize = 10;

/// Rough copper that also mirrors.
fn copper(slope: f64) -> Material {
    let slopes = vec![Slope { slope, share: 1.0 }];
    Material {
        kind: Kind::Metal,
        metal: Some([0.932, 0.623, 0.522]),
        mirror: Some(0.5),
        slopes,
        ..Material::default()
    }
}

/// Glass of an index of refraction that absorbs light.
fn glass(index: f64, absorb: Triple) -> Material {
    let [specular, transmit] = [Some(0.25), Some(0.75)];
    let shares = Material { specular, transmit, exponent: Some(20.0), ..Material::default() };
    Material { kind: Kind::Glass, index: Some(index), absorb: Some(absorb), ..shares }
}

/// Returns a ball of radius 1 in a distance of 5 under a sky with one lamp.
fn ball(material: Material, lamp: Triple) -> Description {
    let scene =
        empty([0.0; 3], [0.0, 1.0, 0.0]).lamp(lamp, 40.0, 0.0).ball([0.0, 5.0, 0.0], 1.0, Surface::Of(0));
    Description { materials: vec![material], ..scene }
}

/// Returns the cases of all models of the list.
pub(super) fn all() -> Vec<Case> {
    let (still, stir) = (Stand::Shaken(0.0), Stand::Shaken(0.5));
    let (aside, behind) = ([-3.0, -3.0, 3.0], [0.5, 12.0, 0.5]);
    let clear = [1.0; 3];
    let shiny =
        Material { kind: Kind::Shiny, exponent: Some(1000.0), specular: Some(0.5), ..Material::default() };
    let white = Material { metal: Some([0.999; 3]), ..copper(0.1) };
    // The lamp is in a tangent of the first ball and straight behind the second.
    let opposite =
        Description { materials: vec![copper(0.3), glass(1.5, clear)], ..empty([0.0; 3], [0.0, 1.0, 0.0]) };
    let opposite = opposite.lamp([0.0, 12.0, 0.0], 40.0, 0.0).ball([1.0, 5.0, 0.0], 1.0, Surface::Of(0));
    let opposite = opposite.ball([0.0, 8.0, 0.0], 1.0, Surface::Of(1));
    let hazy = Air {
        attenuation: Some(Attenuation { fading: Fading::Haze([0.0, 10.0]), from: None, color: None }),
        medium: Some(Medium::fog([0.01, 0.1, 1.0])),
    };
    let touched = Description { air: hazy, ..ball(glass(1.5, [0.5, 0.9, 1.0]), aside) };
    let cases = [
        ("m = .01", stir, Aim::Glint, 2, ball(copper(0.01), aside)),
        ("n = 1000", stir, Aim::Glint, 2, ball(shiny, aside)),
        ("N.V = 0", stir, Aim::Silhouette, 2, ball(copper(0.3), aside)),
        ("N.L = 0", stir, Aim::Border, 2, ball(copper(0.3), aside)),
        ("L = -V", still, Aim::Lamp, 4, opposite),
        ("k = 1", stir, Aim::Picture, 4, ball(glass(1.0, clear), behind)),
        ("A = 2^-31", stir, Aim::Picture, 4, ball(glass(1.5, [2f64.powi(-31), 0.5, 1.0]), behind)),
        ("F0 = .999", stir, Aim::Glint, 2, ball(white, aside)),
        ("d = 0", Stand::OnSurface, Aim::Picture, 3, touched),
    ];
    let of = |model: &'static Model| {
        cases.clone().map(|(what, stand, aim, depth, scene)| Case {
            name: format!("{model}, {what}"),
            scene,
            depth,
            stand,
            aim,
            models: slice::from_ref(model),
            acne: false, // balls and lamps of these places are in other cases
            thinning: THINNING,
            spreading: None,
        })
    };
    Model::ALL.iter().flat_map(of).collect()
}
