//! The search among flat triangles finds what the search among all objects does.

use core::fmt::Write;

use glam::Vec3;
use rta_core::accelerator::Accelerator;
use rta_core::needs::Everything;
use rta_core::scene::Object;
use rta_core::world::World;
use rta_scenes::narrow::narrow;

use super::{FlatSearch, Nearest, Ready4};
use crate::cache::ShadowCache;
use crate::four::geometry::Ray4;
use crate::four::vector::Vec3x4;
use crate::packets::Packets;

/// A scene of random triangles of which some lie in one plane, and rays from its eye and from elsewhere. Returns how many rays meet
/// something, and how many are unknown.
fn compare(count: usize, random: &mut fastrand::Rng) -> [u32; 2] {
    let mut text = "rta 1\ncamera at 0 -9 0  look 0 1 0\n".to_owned();
    for i in 0..count {
        let (x, y, z) = (random.f32() * 8.0 - 4.0, random.f32() * 8.0 - 4.0, (i % 5) as f32 - 2.5);
        let place = |random: &mut fastrand::Rng| {
            let tilt = if i % 2 == 0 { 0.0 } else { random.f32() * 3.0 };
            format!("{} {} {} ", x + random.f32() * 3.0, y + random.f32() * 3.0, z + tilt)
        };
        let [a, b, c] = [(); 3].map(|()| place(random));
        writeln!(text, "triangle {a} {b} {c} color .5 .5 .5").expect("room");
    }
    let scene = rta_scenes::read(text.as_bytes(), "triangles.rta").expect("a scene");
    let narrowed = narrow::<f32>(&scene, 1.0).expect("it fits");
    let limits = narrowed.admit().expect("it fits").limits;
    let packets = Packets::build::<f32>(&scene);
    let world = World { scene: narrowed.scene(), limits };
    let mut flat = FlatSearch::new(&packets).expect("triangles alone");
    let mut cache = ShadowCache::default();
    let (mut met, mut unknown) = (0, 0);
    for run in 0..400 {
        let is_eye = run % 4 == 0;
        let mut vector = || Vec3::from_array([(); 3].map(|()| random.f32() * 2.0 - 1.0));
        let [origins, directions] =
            [(); 2].map(|()| [(); 4].map(|()| vector().try_normalize().unwrap_or(Vec3::X)));
        // Some lie in the planes of triangles, or far away.
        let far = [5.0, 0.5, 3.0, 1e18][run % 16 / 4];
        let origins = origins.map(|place| if is_eye { narrowed.camera.eye } else { far * place });
        let rays = Ray4 { origin: Vec3x4::new(origins), direction: Vec3x4::new(directions) };
        let ready = Ready4::new(&rays, &packets);
        for k in 0..4 {
            let ray = rays.lane(k);
            let want = (&packets).closest::<Everything>(&world, &ray, &mut cache);
            match flat.nearest(&ready, k, is_eye) {
                Nearest::Triangle(i, _) => {
                    assert_eq!(want.map(|hit| hit.object), Some(Object::Triangle(i)));
                    met += 1;
                }
                Nearest::Nothing => assert!(want.is_none()),
                Nearest::Unknown => unknown += u32::from(far < 1e18 || is_eye),
            }
            for t_max in [0.5, 3.0, want.map_or(8.0, |hit| hit.distance), 1e17] {
                let through = (&packets).transmittance::<Everything>(&world, &ray, t_max, 0, &mut cache);
                if let Some(is_open) = flat.is_open(&ready, k, t_max) {
                    assert_eq!(is_open, through > 0.0, "{ray:?} before {t_max}");
                }
            }
        }
    }
    [met, unknown]
}

#[test]
fn what_rays_meet_is_what_they_meet_among_all_objects() {
    let mut random = fastrand::Rng::with_seed(1);
    let mut sums = [0; 2];
    for count in [1, 3, 8, 9, 40, 200, 1000] {
        let [met, unknown] = compare(count, &mut random);
        sums = [sums[0] + met, sums[1] + unknown];
    }
    let [met, unknown] = sums;
    // Every second triangle lies in one plane with others.
    assert!(met > 1000 && unknown < met / 5, "{met} met, {unknown} unknown");
}
