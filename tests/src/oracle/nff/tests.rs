//! The oracle of NFF against values worked out by hand and against those of the literature's formulas.

use super::super::vector::{Vector, cross, scale, sum, unit};
use super::crossing::{Departure, Ray};
use super::tube::Tube;
use super::{read, render};
use crate::assert_close;

/// A view along y from the origin, nine pixels of which the middle one looks straight on.
const VIEW: &str = "v from 0 0 0 at 0 1 0 up 0 0 1 angle 60 hither 0 resolution 3 3\n";

/// Returns what the middle pixel shows.
fn middle(scene: &str, depth: u32) -> [f64; 3] {
    let scene = read(&format!("{VIEW}{scene}")).expect("a scene");
    *render(&scene, depth).get(4).expect("nine pixels")
}

#[track_caller]
fn assert_near(got: [f64; 3], want: [f64; 3]) {
    for (got, want) in got.into_iter().zip(want) {
        assert_close!(got, want, 1e-9, "of a radiance");
    }
}

/// Returns a wall at y = 2 that is lit and seen under these angles from its normal, in the plane of its normal or turned by `phi`.
fn wall(fill: &str, lamp: f64, eye: f64, phi: f64) -> [f64; 3] {
    let [lamp, eye, phi] = [lamp, eye, phi].map(f64::to_radians);
    // The eye is the origin; the wall faces (n, towards the eye) such that V has the angle `eye`.
    let (to_eye, aside) = ([0.0, -1.0, 0.0], [1.0, 0.0, 0.0]);
    let normal = sum([scale(eye.cos(), to_eye), scale(eye.sin(), aside)]);
    let across = sum([scale(eye.cos(), aside), scale(-eye.sin(), to_eye)]);
    // V = (sin eye) (-across) + cos eye normal; the lamp is turned against it about the normal.
    let beside = cross(normal, across);
    let around = sum([scale(-phi.cos(), across), scale(phi.sin(), beside)]);
    let light = sum([scale(lamp.cos(), normal), scale(lamp.sin(), around)]);
    let [x, y, z] = sum([[0.0, 2.0, 0.0], scale(1.5, light)]);
    let corner = |u: f64, v: f64| {
        let [x, y, z] = sum([[0.0, 2.0, 0.0], scale(u, across), scale(v, beside)]);
        format!("{x} {y} {z} ")
    };
    let corners = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)].concat();
    middle(&format!("l {x} {y} {z}\nf {fill} 0 1\np 4 {corners}"), 0)
}

#[test]
fn highlights_are_powers_of_the_cosine_to_the_mirrored_light() {
    for ([lamp, eye, phi, n], want) in [
        ([30.0, 30.0, 180.0, 50.0], 1.0),
        ([30.0, 40.0, 180.0, 50.0], 0.465_128_497),
        ([60.0, 50.0, 170.0, 20.0], 0.599_346_242),
        ([10.0, 30.0, 90.0, 5.5], 0.416_726_865),
        ([95.0, 85.0, 180.0, 5.0], 0.0),
    ] {
        for got in wall(&format!(".2 .4 .6 0 1 {n}"), lamp, eye, phi) {
            assert_close!(got, want, 1e-9, "of a highlight", "{lamp} {eye} {phi} {n}");
        }
    }
    // Kd C (N.L), and the highlight in the lamp's colour.
    assert_near(
        wall(".2 .4 .8 .5 .25 7", 60.0, 0.0, 0.0),
        [0.05, 0.1, 0.2].map(|c| c + 0.25 * 0.5_f64.powi(7)),
    );
}

#[test]
fn pixels_lie_between_the_centres_of_the_first_and_the_last() {
    // 60 degrees between the outer rows: tan 30 up and down, in the columns as well.
    let ball = |x: f64, z: f64| {
        let scene = format!("{VIEW}b 0 0 1 f 0 0 0 0 0 1 0 1 s {x} 1 {z} .01");
        let picture = render(&read(&scene).expect("a scene"), 0);
        picture.iter().position(|color| color[2] == 0.0)
    };
    let tan = 30.0_f64.to_radians().tan();
    assert_eq!(ball(-tan, tan), Some(0));
    assert_eq!(ball(tan, 0.0), Some(5));
    assert_eq!(ball(0.0, -tan), Some(7));
    assert_eq!(ball(0.0, 0.5 * tan), None);
}

#[test]
fn lamps_without_a_colour_share_their_light() {
    let wall = "f 1 1 1 1 0 1 0 1 p 4 -9 2 -9 9 2 -9 9 2 9 -9 2 9";
    assert_near(middle(&format!("l 0 1 0 {wall}"), 0), [1.0; 3]);
    assert_near(middle(&format!("l 0 1 0 l 0 3 0 l 0 4 0 l 0 5 0 {wall}"), 0), [0.5; 3]);
    assert_near(
        middle(&format!("l 0 1 0 l 0 -7 0 .3 2 0 {wall}"), 0),
        [0.5_f64.sqrt() + 0.3, 0.5_f64.sqrt() + 2.0, 0.5_f64.sqrt()],
    );
}

#[test]
fn shadows_take_the_transmission_of_each_object_once() {
    let lit = |things: &str| {
        middle(&format!("l 4 -2 0\nf 1 1 1 1 0 1 0 1\np 4 -9 2 -9 9 2 -9 9 2 9 -9 2 9\n{things}"), 0)
    };
    let cosine = 0.5_f64.sqrt();
    assert_near(lit(""), [cosine; 3]);
    assert_near(lit("f 1 1 1 0 0 1 .6 1.5\ns 2 0 0 .5"), [0.6 * cosine; 3]);
    assert_near(lit("f 1 1 1 0 0 1 .6 1.5\ns 2 0 0 .5\nc 3 -1 -1 .2 3 -1 1 .1"), [0.36 * cosine; 3]);
    assert_near(
        lit("f 1 1 1 0 0 1 .6 1.5\ns 2 0 0 .5\nf 1 1 1 0 1 1 0 1\np 3 1 1 -1 1 1 1 2 2 0\n"),
        [0.0; 3],
    );
    // Behind the lamp is no shadow.
    assert_near(lit("f 1 1 1 1 0 1 0 1\ns 5.5 -3.5 0 1"), [cosine; 3]);
}

#[test]
fn glass_bends_and_reflects_by_its_weights() {
    // Straight through both sides of a ball.
    let ball = |depth| middle("b .5 1 .25\nf 1 1 1 0 .25 1 .5 1.5\ns 0 4 0 1", depth);
    assert_near(ball(0), [0.0; 3]);
    assert_near(ball(1), [0.125, 0.25, 0.0625]);
    assert_near(ball(2), [0.125 + 0.125, 0.25 + 0.25, 0.0625 + 0.0625]);
    // At 30 degrees into glass of 1.5: sin 30/1.5 = 1/3. A small ball stands where the bent ray arrives and the straight one not.
    let (sin, cos) = 30.0_f64.to_radians().sin_cos();
    let pane = [(-cos, -sin), (cos, sin)].map(|(x, y)| (x, 2.0 + y));
    let [(x0, y0), (x1, y1)] = pane;
    let pane = format!("p 4 {x0} {y0} -1 {x1} {y1} -1 {x1} {y1} 1 {x0} {y0} 1");
    let normal = [sin, -cos, 0.0];
    let aside = [cos, sin, 0.0];
    let bent = sum([scale(-(8.0_f64.sqrt() / 3.0), normal), scale(1.0 / 3.0, aside)]);
    let [x, y, z] = sum([[0.0, 2.0, 0.0], scale(3.0, bent)]);
    let scene = format!("b 1 1 1\nf 0 0 0 0 0 1 .5 1.5\n{pane}\nf 0 0 0 0 0 1 0 1\ns {x} {y} {z} .01");
    assert_near(middle(&scene, 1), [0.0; 3]);
    let scene = format!("b 1 1 1\nf 0 0 0 0 0 1 .5 1.5\n{pane}\nf 0 0 0 0 0 1 0 1\ns 0 5 0 .1");
    assert_near(middle(&scene, 1), [0.5; 3]);
    // From within an index of 2.5, at 30 degrees: total reflection, with both weights.
    let turned = pane.replace("p 4", "f 0 0 0 0 .25 1 .5 .4\np 4");
    assert_near(middle(&format!("b 1 1 1\n{turned}"), 1), [0.75; 3]);
}

#[test]
fn outlines_show_what_they_wind_around() {
    let seen = |outline: &str| middle(&format!("b 1 1 1 f 0 0 0 0 0 1 0 1 p {outline}"), 0)[0] == 0.0;
    assert!(seen("4 -1 2 -1 1 2 -1 1 2 1 -1 2 1"));
    assert!(!seen("6 -1 2 -1 1 2 -1 1 2 1 .5 2 1 .5 2 -.5 -1 2 -.5"));
    // Wound around twice; in both directions about no area.
    assert!(seen("8 -1 2 -1 1 2 -1 1 2 1 -1 2 1 -1 2 -1 1 2 -1 1 2 1 -1 2 1"));
    assert!(!seen("8 -1 2 -1 1 2 -1 1 2 1 -1 2 1 -1 2 -1 -1 2 1 1 2 1 1 2 -1"));
    // An even bow tie has two triangles.
    assert!(seen("4 -.5 2 -1 1.5 2 1 1.5 2 -1 -.5 2 1"));
    assert!(!seen("4 -1 2 -.5 1 2 1.5 1 2 -.5 -1 2 1.5"));
}

#[test]
fn patches_mix_normals() {
    // N = (0,0,1), (.6,0,.8), (0,.6,.8) and L = (.48,.6,.64), seen from z.
    for ([u, v], want) in
        [([0.3, 0.3], 0.827_003_273), ([0.6, 0.1], 0.812_641_188), ([0.0, 0.5], 0.796_893_97)]
    {
        let view = format!("v from {u} {v} 4 at {u} {v} 0 up 0 1 0 angle 60 hither 0 resolution 3 3\n");
        let [x, y, z] = [u + 48.0, v + 60.0, 64.0];
        let patch = "f 1 1 1 1 0 1 0 1 pp 3 0 0 0 0 0 1 1 0 0 .6 0 .8 0 1 0 0 .6 .8";
        let scene = read(&format!("{view}l {x} {y} {z} {patch}")).expect("a scene");
        assert_near(*render(&scene, 0).get(4).expect("nine pixels"), [want; 3]);
    }
}

#[test]
fn tubes_are_met_where_they_are_however_slim() {
    let mut rng = fastrand::Rng::with_seed(14);
    let mut number = |most: f64| most * (2.0 * rng.f64() - 1.0);
    for ratio in [1.0, 16.0, 3000.0, 1e6] {
        for taper in [1.0, 0.5, 0.0] {
            let radii = [8.0 / ratio, 8.0 / ratio * taper];
            let mut any = || -> Vector { [number(1.0), number(1.0), number(1.0)] };
            for _ in 0..1000 {
                let (center, axis) = (any(), unit(any()));
                let ends = [-8.0, 8.0].map(|along| sum([center, scale(along, axis)]));
                let tube = Tube::new(ends, radii).expect("it has a height");
                // A place on the wall, and a ray to it from outside.
                let share = 0.5 + 0.49 * any()[0];
                let radius = radii[0] + share * (radii[1] - radii[0]);
                let radial = unit(cross(axis, any()));
                let place = sum([ends[0], scale(16.0 * share, axis), scale(radius, radial)]);
                let slope = (radii[1] - radii[0]) / 16.0;
                let outward = unit(sum([radial, scale(-slope, axis)]));
                let [aside, distance] = [any(), any()].map(|random| random[0]);
                let toward = unit(sum([outward, scale(aside, cross(axis, radial)), scale(aside, axis)]));
                let distance = 2.0 + distance;
                let ray =
                    Ray { origin: sum([place, scale(distance, toward)]), direction: scale(-1.0, toward) };
                let crossings = tube.crossings(ray, None);
                let first =
                    crossings.into_iter().flatten().min_by(|a, b| a.t.total_cmp(&b.t)).expect("a hit");
                assert_close!(first.t, distance, 1e-12, "of a length", "{ratio} {taper}");
                for (got, want) in first.outward.into_iter().zip(outward) {
                    assert_close!(got, want, 1e-12 + 1e-13 / radius, "of a normal", "{ratio} {taper}");
                }
                // From the wall outwards nothing, inwards the far side or an open end.
                let from = Ray { origin: place, direction: toward };
                assert!(tube.crossings(from, Some(Departure::Out)).iter().all(Option::is_none));
                let into = Ray { origin: place, direction: scale(-1.0, toward) };
                assert!(
                    tube.crossings(into, Some(Departure::In))
                        .iter()
                        .flatten()
                        .all(|far| far.t > 0.1 * radius)
                );
            }
        }
    }
}

#[test]
fn negative_radii_are_seen_from_inside_alone() {
    let scene = |shape: &str| format!("b 1 1 1 f 0 0 0 0 0 1 0 1 {shape}");
    for (shape, seen) in [
        ("s 0 4 0 1", true),
        ("s 0 4 0 -1", true),
        ("s 0 0 0 -1", true),
        ("c 0 0 -1 -1 0 0 1 -1", true),
        ("c 0 0 -1 -1 0 0 1 0", true),
        ("s 0 -4 0 -1", false),
    ] {
        assert_eq!(middle(&scene(shape), 0)[0] == 0.0, seen, "{shape}");
    }
    // Lit from the middle: the inner side of the far wall.
    assert_near(middle("l 0 4 0 f 1 1 1 1 0 1 0 1 s 0 4 0 -1", 0), [1.0; 3]);
    assert_near(middle("l 0 4 0 f 1 1 1 1 0 1 0 1 s 0 4 0 1", 0), [0.0; 3]);
    assert_near(middle("l 0 4 0 f 1 1 1 1 0 1 0 1 c 0 4 -1 -1 0 4 1 -1", 0), [1.0; 3]);
}

#[test]
fn what_is_no_nff_is_refused() {
    for (text, why) in
        [("f 1 1 1 1 0 1 0", "end"), ("q 1", "\"q\""), ("p 3 1 2 x", "\"x\""), ("v from 1 1 1 to", "\"to\"")]
    {
        let error = read(text).err().expect(text);
        assert!(error.contains(why), "{text}: {error}");
    }
}
