//! The cases of rays that are spread: lamps, rough surfaces, lenses, motion and air at the ends of what they may be.

use rta_core::sampling::Sobol;
use rta_scenes::description::Description;
use rta_scenes::sampler::{Integrator, Lamps, Spreading};

use super::{Aim, BOTH, Case, Stand};

/// Samples of a pixel.
const SAMPLES: u32 = 16;

/// What all cases have: a sky and an ambient light.
const ROOM: &str = "rta 1\nambient .2 .2 .25\nsky horizon .8 .85 .95  zenith .15 .3 .65\n";
/// A chequered floor and a ball.
const FLOOR_AND_BALL: &str = "floor grey .9  grey .1\nsphere at 0 5 1  radius 1  of thing\n";
/// An eye that sees all of it.
const EYE: &str = "camera at 0 0 2  look 0 1 -.1\n";
/// A lamp with a size.
const LAMP: &str = "lamp at -4 -2 7  radius .5  power 60  square\n";
/// The ball's material where it does not matter.
const DULL: &str = "material thing diffuse .7\n";

/// Returns the cases.
pub(super) fn all() -> Vec<Case> {
    let mut cases = Vec::new();
    // A material comes before the ball that is made of it.
    let mut add = |name: &str, material: &str, parts: &[&str]| {
        cases.push(case(name, &[ROOM, material, FLOOR_AND_BALL, &parts.concat()].concat()));
    };
    for (name, lamp) in [
        ("lamp of radius 0", "lamp at -4 -2 7  power 60  square\n"),
        ("lamp of radius 1e-3", "lamp at -4 -2 7  radius 1e-3  power 60  square\n"),
        ("lamp that touches a ball", "lamp at 0 5 2.5  radius .5  power 4  square\n"),
        ("lamp that touches the floor", "lamp at 2 4 .5  radius .5  power 4  square\n"),
        ("lamp half in the floor", "lamp at 2 4 0  radius 1  power 4  square\n"),
        ("lamp that holds a ball", "lamp at 0 5 1  radius 2  power 4  square\n"),
        ("lamp that holds everything", "lamp at 0 5 1  radius 90  power 4000  square\n"),
        ("parallelogram of a lamp on the floor", "lamp corner 1 3 0  edges 2 0 0  0 2 0  color .2 .2 .15\n"),
        ("parallelogram of a lamp in a ball", "lamp corner -2 5 1  edges 4 0 0  0 0 2  color .2 .2 .15\n"),
    ] {
        add(name, DULL, &[EYE, lamp]);
    }
    add("eye inside a lamp", DULL, &[EYE, "lamp at .1 -.1 2  radius .5  power 9  square\n"]);
    add("eye in the middle of a lamp", DULL, &[EYE, "lamp at 0 0 2  radius .5  power 9  square\n"]);
    for (kind, of) in [("mirror", "mirror"), ("glass", "crown")] {
        for roughness in ["0", "1e-4", "1"] {
            let material = format!("material thing like {of}  roughness {roughness}\n");
            add(&format!("{kind} of roughness {roughness}"), &material, &[EYE, LAMP]);
        }
    }
    for (name, optics) in [
        ("aperture 1e-9", "aperture 1e-9  focus 5"),
        ("aperture 1e-3", "aperture 1e-3  focus 5"),
        ("aperture as wide as the scene", "aperture 3  focus 5"),
        ("focus far behind everything", "aperture .2  focus 900"),
        ("focus before everything", "aperture .2  focus .5"),
    ] {
        let eye = format!("camera at 0 0 2  look 0 1 -.1  {optics}\n");
        add(name, DULL, &[&eye, LAMP]);
    }
    for (name, moves) in [
        ("velocity 0", "0 0 0"),
        ("velocity 1e-4", "1e-4 0 0"),
        ("velocity across the eye", "0 -9 1"),
        ("velocity beyond a format", "9000 0 0"),
        ("velocity beyond both formats", "90000 0 0"),
    ] {
        let ball = format!("sphere at .5 4 1.5  radius .5  color .7 .6 .5  moves {moves}\n");
        add(name, DULL, &[EYE, LAMP, &ball]);
    }
    for (name, moves) in [
        ("0", "0 0 0"),
        ("1e-4", "1e-4 0 0"),
        ("through a ball", "8 14 -12"),
        ("through the floor", "0 0 -40"),
        ("beyond a format", "9000 0 0"),
        ("beyond both formats", "90000 0 0"),
    ] {
        let lamp = format!("lamp at -4 -2 7  radius .5  power 60  square  moves {moves}\n");
        add(&format!("velocity of a lamp {name}"), DULL, &[EYE, &lamp]);
    }
    let square = "lamp corner -5 -3 7  edges 2 0 0  0 2 0  color .8 .8 .6  moves 8 14 -12\n";
    add("velocity of a parallelogram of a lamp through a ball", DULL, &[EYE, square]);
    for (name, moves) in [
        ("0", "0 0 0"),
        ("1e-4", "1e-4 0 0"),
        ("through a ball", "0 12 -2"),
        ("through the floor", "0 0 -9"),
        ("beyond a format", "9000 0 0"),
        ("beyond both formats", "90000 0 0"),
    ] {
        let eye = format!("camera at 0 0 2  look 0 1 -.1  moves {moves}\n");
        add(&format!("velocity of the eye {name}"), DULL, &[&eye, LAMP]);
    }
    for (name, extinction, reach) in [
        ("1e-3", ".1", "1e-3"),
        ("before everything", ".1", "2"),
        ("behind everything", ".1", "90"),
        ("1, of extinction 0", "0", "1"),
        ("1, of extinction 1e3", "1e3", "1"),
        ("beyond a format", ".01", "9000"),
        ("beyond both formats", ".01", "90000"),
    ] {
        let medium = format!("medium extinction {extinction}  albedo .9  shadows 8  reach {reach}\n");
        add(&format!("medium with a reach {name}"), DULL, &[EYE, LAMP, &medium]);
    }
    for extinction in ["0", "1e-4", "1e3"] {
        let medium =
            format!("medium extinction {extinction} {extinction} {extinction}  albedo .9  shadows 8\n");
        add(&format!("medium of extinction {extinction}"), DULL, &[EYE, LAMP, &medium]);
    }
    cases
}

fn case(name: &str, text: &str) -> Case {
    // The texts are constants of this file; one that could not be read would be an empty scene, which a test finds.
    let scene = rta_scenes::read(text.as_bytes(), "case.rta");
    let camera = rta_scenes::description::Camera::upright([0.0; 3], [0.0, 1.0, 0.0], 1.0);
    Case {
        name: format!("spread, {name}"),
        scene: scene.unwrap_or_else(|_| Description::empty(camera)),
        depth: 4,
        stand: Stand::Shaken(0.0),
        aim: Aim::Picture,
        models: BOTH,
        acne: false,
        thinning: 10,
        spreading: Sobol::new(SAMPLES, 7).map(|samples| Spreading {
            samples,
            lamps: Lamps::Area,
            split: 1,
            integrator: Integrator::Whitted,
        }),
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_case_is_a_scene() {
        for case in super::all() {
            assert!(!case.scene.spheres.is_empty() && !case.scene.lamps.is_empty(), "{}", case.name);
        }
    }
}
