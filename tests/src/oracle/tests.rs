//! The oracle against values worked out by hand.

use super::{radiance, render};
use rta_scenes::description::{
    Camera, Cylinder, Description, Ellipsoid, FallOff, Floor, Lamp, Sky, Sphere, Surface,
};
use rta_scenes::{dat, shipped};

const HORIZON: [f64; 3] = [0.8, 0.4, 0.2];
const ZENITH: [f64; 3] = [0.1, 0.2, 0.6];
const COLOR: [f64; 3] = [0.5, 0.6, 0.9];

/// Sky alone.
fn sky() -> Description {
    Description {
        sky: Sky { horizon: HORIZON, zenith: ZENITH },
        ..Description::empty(Camera::upright([0.0, 0.0, 5.0], [0.0, 1.0, 0.0], 1.0))
    }
}

fn sphere(position: [f64; 3], radius: f64, surface: Surface) -> Sphere {
    Sphere { position, color: COLOR, radius, surface, line: 0 }
}

fn lamp(position: [f64; 3], intensity: f64, radius: f64) -> Lamp {
    Lamp { position, color: [intensity, intensity / 2.0, 0.0], radius, fall_off: FallOff::OfModel, line: 0 }
}

fn glass(ks: f64, ior: f64) -> Surface {
    Surface::Transparent { ks, kt: 1.0 - ks, ior }
}

fn sky_at(sine: f64) -> [f64; 3] {
    let s = sine * sine;
    [0, 1, 2].map(|register: usize| {
        let of = |color: [f64; 3]| color.into_iter().nth(register).expect("there are three registers");
        (1.0 - s) * of(HORIZON) + s * of(ZENITH)
    })
}

#[track_caller]
fn assert_near(got: [f64; 3], want: [f64; 3]) {
    assert!(got.iter().zip(want).all(|(got, want)| (got - want).abs() < 1e-9), "got {got:?}, want {want:?}");
}

fn with_color(share: f64, [r, g, b]: [f64; 3]) -> [f64; 3] {
    [share * r * COLOR[0], share * g * COLOR[1], share * b * COLOR[2]]
}

#[test]
fn sky_goes_with_the_square_of_the_sine() {
    let eye = [0.0, 0.0, 5.0];
    assert_near(radiance(&sky(), eye, [0.0, 0.0, 7.0], 5), ZENITH);
    assert_near(radiance(&sky(), eye, [0.0, 0.0, -1.0], 5), ZENITH);
    assert_near(radiance(&sky(), eye, [3.0, -4.0, 0.0], 5), HORIZON);
    assert_near(radiance(&sky(), eye, [3.0_f64.sqrt(), 0.0, 1.0], 5), sky_at(0.5));
}

#[test]
fn camera_looks_through_the_centres_of_pixels() {
    // Level, focal distance 1, 4:3: pixel (0, 0) of 2 x 2 is at x = -1/4, y = 1/4 * 3/4.
    let sine = |x: f64, y: f64| y / (1.0 + x * x + y * y).sqrt();
    let picture = render(&sky(), 2, 2, 4.0 / 3.0, 0);
    for (pixel, color) in picture.iter().enumerate() {
        let y = if pixel < 2 { 0.1875 } else { -0.1875 };
        assert_near(*color, sky_at(sine(0.25, y)));
    }
    // Left and top: a lamp seen in one pixel alone. Looking along y, right is x.
    let mut scene = sky();
    scene.lamps.push(lamp([-0.25 * 8.0, 8.0, 5.0 + 0.1875 * 8.0], 3.0, 0.5));
    let seen: Vec<bool> = render(&scene, 2, 2, 4.0 / 3.0, 0).iter().map(|color| color[0] > 5.0).collect();
    assert_eq!(seen, [true, false, false, false]);
    // Straight down: right is x and the top of the picture is y.
    scene.camera.view = [0.0, 0.0, -2.0];
    scene.lamps = vec![lamp([0.25 * 4.0, 0.25 * 4.0, 1.0], 3.0, 0.5)];
    let seen: Vec<bool> = render(&scene, 2, 2, 1.0, 0).iter().map(|color| color[0] > 5.0).collect();
    assert_eq!(seen, [false, true, false, false]);
    // Straight up: right is x, so the top is -y.
    scene.camera.view = [0.0, 0.0, 2.0];
    scene.lamps = vec![lamp([0.25 * 4.0, 0.25 * 4.0, 9.0], 3.0, 0.5)];
    let seen: Vec<bool> = render(&scene, 2, 2, 1.0, 0).iter().map(|color| color[0] > 5.0).collect();
    assert_eq!(seen, [false, false, false, true]);
}

#[test]
fn floor_is_chequered_and_lit() {
    let mut scene = sky();
    scene.floor = Some(Floor { colors: [[0.9, 0.8, 0.7], [0.1, 0.2, 0.3]], surface: Surface::Opaque });
    scene.ambient = [0.5, 0.25, 0.125];
    // N.CENIT + k1 = 2.5, times k2 = 1: the ambient light itself.
    let (first, second) = ([0.45, 0.2, 0.0875], [0.05, 0.05, 0.0375]);
    for (x, y, want) in
        [(1.0, 1.0, first), (4.0, 1.0, second), (4.0, 4.0, first), (-1.0, 1.0, second), (-1.0, -1.0, first)]
    {
        assert_near(radiance(&scene, [x, y, 2.0], [0.0, 0.0, -1.0], 5), want);
        // From below the normal is turned: (-1 + 1.5) 0.4 = 0.2.
        assert_near(radiance(&scene, [x, y, -2.0], [0.0, 0.0, 1.0], 5), want.map(|part| 0.2 * part));
    }
    // A lamp 5 above, then the same from 60 degrees: half the cosine, a quarter of the inverse square.
    scene.lamps = vec![lamp([1.0, 1.0, 5.0], 20.0, 0.0)];
    assert_near(radiance(&scene, [1.0, 1.0, 2.0], [0.0, 0.0, -1.0], 5), [0.45 + 0.72, 0.2 + 0.32, 0.0875]);
    scene.lamps = vec![lamp([1.0 + 75.0_f64.sqrt(), 1.0, 5.0], 20.0, 0.0)];
    assert_near(radiance(&scene, [1.0, 1.0, 2.0], [0.0, 0.0, -1.0], 5), [0.45 + 0.09, 0.2 + 0.04, 0.0875]);
    // A lamp below it adds nothing.
    scene.lamps = vec![lamp([1.0, 1.0, -5.0], 20.0, 0.0)];
    assert_near(radiance(&scene, [1.0, 1.0, 2.0], [0.0, 0.0, -1.0], 5), first);
}

#[test]
fn lamp_is_seen_with_its_colour_over_the_square_of_its_radius() {
    let mut scene = sky();
    scene.lamps.push(lamp([0.0, 9.0, 5.0], 3.0, 0.5));
    assert_near(radiance(&scene, [0.0, 0.0, 5.0], [0.0, 1.0, 0.0], 0), [12.0, 6.0, 0.0]);
    scene.lamps = vec![lamp([0.0, 9.0, 5.0], 3.0, 0.0)];
    assert_near(radiance(&scene, [0.0, 0.0, 5.0], [0.0, 1.0, 0.0], 0), HORIZON);
}

#[test]
fn shadows_let_the_light_of_glass_through_once_for_each() {
    let mut scene = sky();
    scene.floor = Some(Floor { colors: [[1.0; 3]; 2], surface: Surface::Opaque });
    scene.lamps = vec![lamp([1.0, 1.0, 10.0], 100.0, 0.5)];
    let at_floor = |scene: &Description| radiance(scene, [1.0, 1.0, 1.0], [0.0, 0.0, -1.0], 5);
    assert_near(at_floor(&scene), [1.0, 0.5, 0.0]);
    scene.spheres = vec![sphere([1.0, 1.0, 3.0], 0.5, glass(0.25, 1.5))];
    assert_near(at_floor(&scene), [0.75, 0.375, 0.0]);
    // A second one, and a third around the lamp itself.
    scene.spheres.push(sphere([1.0, 1.0, 6.0], 0.5, glass(0.5, 1.5)));
    scene.spheres.push(sphere([1.0, 1.0, 10.0], 1.0, glass(0.2, 1.5)));
    assert_near(at_floor(&scene), [0.3, 0.15, 0.0]);
    // One behind the lamp does not count, nor does another lamp on the way.
    scene.spheres.push(sphere([1.0, 1.0, 15.0], 1.0, Surface::Opaque));
    scene.lamps.push(lamp([1.0, 1.0, 4.5], 0.0, 0.5));
    assert_near(at_floor(&scene), [0.3, 0.15, 0.0]);
    for surface in [Surface::Opaque, Surface::Shiny, Surface::Mirror] {
        let mut dark = scene.clone();
        dark.spheres.push(sphere([1.0, 1.0, 8.0], 0.5, surface));
        assert_near(at_floor(&dark), [0.0; 3]);
    }
}

#[test]
fn mirror_takes_its_colour_and_depth_ends_it() {
    let mut scene = sky();
    // Met head on at its top.
    scene.spheres = vec![sphere([0.0, 0.0, 0.0], 1.0, Surface::Mirror)];
    let down = |depth| radiance(&scene, [0.0, 0.0, 5.0], [0.0, 0.0, -1.0], depth);
    assert_near(down(0), [0.0; 3]);
    assert_near(down(1), with_color(1.0, ZENITH));
    // A horizontal ray that meets it at 45 degrees leaves upwards.
    let half = 0.5_f64.sqrt();
    assert_near(radiance(&scene, [-5.0, 0.0, half], [1.0, 0.0, 0.0], 1), with_color(1.0, ZENITH));
}

#[test]
fn glass_head_on_and_bent() {
    let mut scene = sky();
    scene.spheres = vec![sphere([0.0; 3], 1.0, glass(0.25, 1.5))];
    let through = |scene: &Description, depth| radiance(scene, [0.0, 0.0, 5.0], [0.0, 0.0, -1.0], depth);
    let straight = |transmitted: f64| {
        let own = with_color(0.25, ZENITH);
        [own[0] + transmitted * ZENITH[0], own[1] + transmitted * ZENITH[1], own[2] + transmitted * ZENITH[2]]
    };
    assert_near(through(&scene, 0), [0.0; 3]);
    assert_near(through(&scene, 1), straight(0.0));
    // Through both surfaces: kt kt. What is reflected inside is cut off at this depth.
    assert_near(through(&scene, 2), straight(0.75 * 0.75));
    // Snell: at 30 and 60 degrees, the ray is turned by twice the difference of the two angles.
    for (degrees, ior) in [(30.0_f64, 1.5), (60.0, 1.5), (30.0, 1.0), (20.0, 0.5), (60.0, 0.9)] {
        let theta_i = degrees.to_radians();
        let turned = 2.0 * (theta_i - (theta_i.sin() / ior).asin());
        scene.spheres = vec![sphere([0.0; 3], 1.0, glass(0.0, ior))];
        let got = radiance(&scene, [-5.0, 0.0, theta_i.sin()], [1.0, 0.0, 0.0], 2);
        assert_near(got, sky_at(turned.sin()));
    }
}

#[test]
fn total_internal_reflection_brings_what_the_mirrored_ray_brings() {
    // A bubble of half the index turns back all that meets it at more than 30 degrees.
    let mut scene = sky();
    scene.spheres = vec![sphere([0.0; 3], 1.0, glass(0.25, 0.5))];
    let back = radiance(&scene, [-5.0, 0.0, 0.5_f64.sqrt()], [1.0, 0.0, 0.0], 1);
    let own = with_color(0.25, ZENITH);
    assert_near(back, [own[0] + 0.75 * ZENITH[0], own[1] + 0.75 * ZENITH[1], own[2] + 0.75 * ZENITH[2]]);
}

#[test]
fn highlight_takes_the_place_of_diffuse_light_within_13_degrees() {
    let mut scene = sky();
    scene.spheres = vec![sphere([0.0; 3], 1.0, Surface::Shiny)];
    scene.ambient = [0.1; 3];
    let top = |scene: &Description| radiance(scene, [0.0, 0.0, 5.0], [0.0, 0.0, -1.0], 5);
    for (degrees, lit) in [(12.9_f64, true), (13.1, false)] {
        let angle = degrees.to_radians();
        scene.lamps = vec![lamp([10.0 * angle.sin(), 0.0, 1.0 + 10.0 * angle.cos()], 4.0, 0.0)];
        let diffuse = 4.0 * angle.cos() / 100.0;
        let ambient = with_color(1.0, [0.1; 3]);
        let of_lamp = if lit { [4.0, 2.0, 0.0] } else { [diffuse * COLOR[0], diffuse / 2.0 * COLOR[1], 0.0] };
        assert_near(top(&scene), [ambient[0] + of_lamp[0], ambient[1] + of_lamp[1], ambient[2] + of_lamp[2]]);
    }
    scene.spheres = vec![sphere([0.0; 3], 1.0, Surface::Opaque)];
    scene.lamps = vec![lamp([0.0, 0.0, 11.0], 100.0, 0.0)];
    assert_near(top(&scene), [1.1 * COLOR[0], 0.6 * COLOR[1], 0.1 * COLOR[2]]);
}

#[test]
fn quadrics_have_their_shapes() {
    let mut scene = sky();
    scene.ambient = [1.0; 3];
    let white = |normal_z: f64| [(normal_z + 1.5) * 0.4; 3];
    scene.ellipsoids = vec![Ellipsoid {
        position: [1.0, 2.0, 3.0],
        color: [1.0; 3],
        radii: [4.0, 2.0, 1.0],
        inside_only: false,
        surface: Surface::Opaque,
        line: 0,
    }];
    // At x = 1 + 4 cos 30, z = 3 + sin 30 the gradient is (cos 30 / 4, 0, sin 30).
    let (sin, cos) = 30.0_f64.to_radians().sin_cos();
    let want = sin / (sin * sin + cos * cos / 16.0).sqrt();
    assert_near(radiance(&scene, [1.0 + 4.0 * cos, 2.0, 9.0], [0.0, 0.0, -1.0], 0), white(want));
    // From the inside the same point faces down.
    assert_near(radiance(&scene, [1.0 + 4.0 * cos, 2.0, 3.0], [0.0, 0.0, 1.0], 0), white(-want));
    scene.ellipsoids.clear();
    scene.cylinders = vec![Cylinder {
        position: [3.0, 0.0, 77.0],
        color: [1.0; 3],
        radius: 1.0,
        surface: Surface::Opaque,
        line: 0,
    }];
    assert_near(radiance(&scene, [0.0, 0.0, 5.0], [1.0, 0.0, -100.0], 0), white(0.0));
    assert_near(radiance(&scene, [3.0, 0.0, 5.0], [0.0, 0.0, -1.0], 0), ZENITH);
    assert_near(radiance(&scene, [0.0, 1.001, 5.0], [1.0, 0.0, 0.0], 0), HORIZON);
}

#[test]
fn shipped_scenes_show_what_they_should() {
    for (name, text) in shipped::ALL {
        let scene = dat::read(text.as_bytes(), name).expect("it ships");
        let picture = render(&scene, 320, 200, 4.0 / 3.0, 5);
        assert_eq!(picture.len(), 320 * 200);
        assert!(picture.iter().flatten().all(|part| part.is_finite() && *part >= 0.0), "{name}");
        let pixel = |x: usize, y: usize| picture.get(y * 320 + x).copied().expect("it is in the picture");
        // A quarter along the top of each is sky: its elevation follows from the camera alone.
        let forward = scene.camera.direction().expect("it looks somewhere");
        let (x, y) = (80.5 / 320.0 - 0.5, (0.5 - 0.5 / 200.0) * 0.75);
        let up_z = (1.0 - forward[2] * forward[2]).sqrt();
        let length = (scene.camera.focal.powi(2) + x * x + y * y).sqrt();
        let s = ((scene.camera.focal * forward[2] + y * up_z) / length).powi(2);
        let [r, g, b] = [0, 1, 2].map(|part: usize| {
            let of = |color: [f64; 3]| color.into_iter().nth(part).expect("there are three registers");
            (1.0 - s) * of(scene.sky.horizon) + s * of(scene.sky.zenith)
        });
        assert_near(pixel(80, 0), [r, g, b]);
    }
}
