//! Illumination models that a program may bring itself, and the light that a cut-off leaves out, against formulas.

use core::f64::consts::PI;

use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, Newell, NewellRow, Rta, Secondary};
use rta_core::light::Incident;
use rta_core::material::Material;
use rta_core::needs::{Everything, Needs};
use rta_core::scalar::Exponent;
use rta_core::surface::Surface;
use rta_core::trace::Tracer;
use rta_scenes::description::{self, Description};
use rta_scenes::narrow::narrow;
use rta_tests::assert_close;
use rta_tests::exact::shipped_scene;
use rta_tests::measure::{direction, place, read_light};

/// Returns one sphere of radius 2 about the origin, under a sky of radiance 1.
fn ball(surface: description::Surface) -> Description {
    let mut scene = shipped_scene("glass-2");
    let sphere = scene.spheres.first().expect("it has two").clone();
    let (position, color) = ([0.0; 3], [1.0; 3]);
    scene.spheres = vec![description::Sphere { position, color, radius: 2.0, surface, ..sphere }];
    scene.lamps.clear();
    scene.floor = None;
    scene.sky = description::Sky { horizon: [1.0; 3], zenith: [1.0; 3] };
    scene
}

fn look(
    scene: &Description,
    model: impl Illumination<f64>,
    depth: u32,
    eye: [f64; 3],
    towards: [f64; 3],
) -> [f64; 3] {
    let narrowed = narrow::<f64>(scene, 1.0).expect("it fits");
    let admitted = narrowed.admit().expect("it fits");
    let tracer: Tracer<_, _, Everything, 16> = Tracer::new(&admitted, model, depth).expect("no deeper");
    read_light::<f64>(tracer.radiance(place::<f64>(eye), direction::<f64>(towards)))
}

#[test]
fn a_cutoff_leaves_out_the_faint_rays() {
    let glass = ball(description::Surface::Transparent { ks: 0.3, kt: 0.7, ior: 1.5 });
    let narrowed = narrow::<f64>(&glass, 1.0).expect("it fits");
    let admitted = narrowed.admit().expect("it fits");
    let tracer: Tracer<_, _, Everything, 16> = Tracer::new(&admitted, Rta, 16).expect("no deeper");
    let [eye, towards] = [place::<f64>([0.0, -9.0, 0.5]), direction::<f64>([0.0, 1.0, 0.0])];
    // What leaves the sphere: 0.3, then 0.7 0.7 0.3^n; what stays in it: 0.7 0.3^n.
    for (cutoff, want) in [(0.8, 0.0), (0.5, 0.0), (0.25, 0.79), (0.1, 0.937), (0.05, 0.937), (0.04, 0.9811)]
    {
        let [r, g, b] = read_light::<f64>(tracer.with_cutoff(cutoff).radiance(eye, towards));
        for register in [r, g, b] {
            assert_close!(register, want, 1e-12, "of the sky", "cut off at {cutoff}");
        }
    }
}

#[test]
fn light_goes_straight_through_both_walls_of_what_is_closed() {
    let glass = description::Surface::Finish { kd: 0.0, ks: 0.0, exponent: 1.0, kt: 0.6, ior: 1.5 };
    let walls = ball(glass);
    let row = NewellRow { has_edge: true, exponent: Exponent::new(2, 0), least: 0.1, most: 0.8 };
    for height in [0.0, 1.2, 1.9] {
        let look = |model: Newell<f64>| look(&walls, model, 2, [0.0, -9.0, height], [0.0, 1.0, 0.0]);
        // N.V of a sphere of radius 2.
        let cosine = (1.0 - (height / 2.0_f64).powi(2)).sqrt();
        let edge = 0.1 + 0.7 * (1.0 - (1.0 - cosine).powi(2));
        let edged = look(Newell { rows: &[row], ..Newell::default() });
        for (light, part) in look(Newell::default())
            .into_iter()
            .map(|light| (light, 0.6))
            .chain(edged.map(|light| (light, edge)))
        {
            assert_close!(light, part * part, 1e-12, "of the sky", "height {height}");
        }
    }
}

/// Coloured glass by the law of Beer and Lambert: of light on a way `d` through it, `exp(-a d)` is left.
struct Absorbing {
    /// Absorption coefficient `a` of each register, for a unit of length.
    absorption: [f64; 3],
}

impl Illumination<f64> for Absorbing {
    type Weight = Rgb<f64>;

    fn ambient<N: Needs>(&self, _: &Surface<f64>, _: Rgb<f64>) -> Rgb<f64> {
        Rgb::BLACK
    }

    fn is_lit<N: Needs>(&self, _: &Surface<f64>) -> bool {
        false
    }

    fn direct<N: Needs>(&self, _: &Surface<f64>, _: &Incident<f64>) -> Rgb<f64> {
        Rgb::BLACK
    }

    fn secondary<N: Needs>(&self, surface: &Surface<f64>) -> Secondary<Rgb<f64>> {
        let Material::Transparent(glass) = surface.material else { return Secondary::NONE };
        let left = |a: f64| if surface.inside { (-a * surface.distance).exp() } else { 1.0 };
        let [r, g, b] = self.absorption.map(left);
        let part = |k: f64| (k > 0.0).then_some(Rgb::new(k * r, k * g, k * b));
        Secondary { reflected: part(glass.ks), transmitted: part(glass.kt), ..Secondary::NONE }
    }
}

#[test]
fn a_model_can_absorb_light_on_its_way() {
    let absorption = [0.0, 0.3, 1.7];
    for (ior, height) in [(1.0, 0.0), (1.0, 1.2), (1.5, 0.0), (1.5, 1.0), (1.5, 1.9)] {
        let chord = 4.0 * (1.0 - (height / 2.0_f64 / ior).powi(2)).sqrt();
        let [eye, towards] = [[0.0, -9.0, height], [0.0, 1.0, 0.0]];
        let clear = ball(description::Surface::Transparent { ks: 0.0, kt: 1.0, ior });
        let got = look(&clear, Absorbing { absorption }, 2, eye, towards);
        for (got, a) in got.into_iter().zip(absorption) {
            assert_close!(
                got,
                (-a * chord).exp(),
                1e-12,
                "of the sky",
                "index {ior}, height {height}, a {a}"
            );
        }
        // With reflections: the light of each way through adds up to a geometric series.
        let ks = 0.25;
        let glass = ball(description::Surface::Transparent { ks, kt: 1.0 - ks, ior });
        for depth in [2, 6, 16] {
            let got = look(&glass, Absorbing { absorption }, depth, eye, towards);
            for (got, a) in got.into_iter().zip(absorption) {
                let left = (-a * chord).exp();
                let ways = i32::try_from(depth - 1).expect("small");
                let series = (1.0 - (ks * left).powi(ways)) / (1.0 - ks * left);
                let want = ks + (1.0 - ks).powi(2) * left * series;
                assert_close!(
                    got,
                    want,
                    1e-12,
                    "of the sky",
                    "index {ior}, height {height}, a {a}, depth {depth}"
                );
            }
        }
    }
}

/// A thin material that is lit by lamps on both of its sides, each in proportion to its solid angle.
struct Translucent;

impl Illumination<f64> for Translucent {
    type Weight = f64;
    const BOTH_SIDES: bool = true;

    fn ambient<N: Needs>(&self, _: &Surface<f64>, _: Rgb<f64>) -> Rgb<f64> {
        Rgb::BLACK
    }

    fn is_lit<N: Needs>(&self, _: &Surface<f64>) -> bool {
        true
    }

    fn direct<N: Needs>(&self, surface: &Surface<f64>, incident: &Incident<f64>) -> Rgb<f64> {
        // Steradians; red from the side of the eye, blue from the other.
        let light = 4.0 * PI * incident.solid_angle() * incident.cosine.abs();
        let side = if incident.cosine > 0.0 { Rgb::new(1.0, 0.0, 0.0) } else { Rgb::new(0.0, 0.0, 1.0) };
        side.zip(surface.color, |part, color| part * color * light)
    }

    fn secondary<N: Needs>(&self, _: &Surface<f64>) -> Secondary<f64> {
        Secondary::NONE
    }
}

/// [`Translucent`] without light from behind.
struct OneSided;

impl Illumination<f64> for OneSided {
    type Weight = f64;

    fn ambient<N: Needs>(&self, s: &Surface<f64>, a: Rgb<f64>) -> Rgb<f64> {
        Translucent.ambient::<N>(s, a)
    }

    fn is_lit<N: Needs>(&self, surface: &Surface<f64>) -> bool {
        Translucent.is_lit::<N>(surface)
    }

    fn direct<N: Needs>(&self, surface: &Surface<f64>, incident: &Incident<f64>) -> Rgb<f64> {
        Translucent.direct::<N>(surface, incident)
    }

    fn secondary<N: Needs>(&self, surface: &Surface<f64>) -> Secondary<f64> {
        Translucent.secondary::<N>(surface)
    }
}

#[test]
fn a_model_can_take_light_from_both_sides_by_solid_angle() {
    let mut scene = ball(description::Surface::Opaque);
    scene.spheres.clear();
    scene.floor = Some(description::Floor { colors: [[0.5; 3]; 2], surface: description::Surface::Opaque });
    let lamp = shipped_scene("glass-2").lamps.first().expect("it has two").clone();
    let at = |position, radius| description::Lamp { position, radius, ..lamp.clone() };
    scene.lamps = vec![at([1.0, 1.0, 4.0], 0.8), at([4.0, 1.0, -4.0], 2.0)];
    let [eye, towards] = [[1.0, -5.0, 6.0], [0.0, 6.0, -6.0]];
    let cap = |radius: f64, d: f64| 2.0 * PI * (1.0 - (1.0 - (radius / d).powi(2)).sqrt());
    let (above, below) = (0.5 * cap(0.8, 4.0), 0.5 * cap(2.0, 5.0) * 0.8);
    let [r, g, b] = look(&scene, Translucent, 0, eye, towards);
    assert_close!(r, above, 1e-12, "of white");
    assert_close!(b, below, 1e-12, "of white");
    assert_close!(g, 0.0, 0.0, "of white");
    assert_close!(look(&scene, OneSided, 0, eye, towards)[2], 0.0, 0.0, "of white");
    // Something below the floor casts its shadow from there; the floor itself does not.
    let hidden = description::Sphere {
        position: [2.5, 1.0, -2.0],
        color: [1.0; 3],
        radius: 0.5,
        surface: description::Surface::Opaque,
        line: 0,
    };
    scene.spheres.push(hidden);
    let [r, _, b] = look(&scene, Translucent, 0, eye, towards);
    assert_close!(r, above, 1e-12, "of white");
    assert_close!(b, 0.0, 0.0, "of white");
}
