//! Random spheres: how the time of a ray grows with the number of objects.

use rta_scenes::description::{Camera, Description, Sky, Sphere, Surface};

use crate::picture::output::Inputs;
use crate::request::scene_file::SceneFile;

/// Numbers of spheres in the scenes.
pub const COUNTS: [u32; 4] = [22, 1000, 10_000, 100_000];

/// Width and height of their pictures in pixels.
pub const SIDE: u32 = 512;

/// The beginning of such a scene's name; the number of spheres follows.
const NAME: &str = "spheres-";

/// Seed of the random numbers, so that the spheres are the same in every run.
const SEED: u64 = 1990;

/// Returns the name of the scene with `count` spheres.
#[must_use]
pub fn name(count: u32) -> String {
    format!("{NAME}{count}")
}

/// Returns the number of spheres in the scene called `name`, if it is one of these scenes.
#[must_use]
pub fn count(name: &str) -> Option<u32> {
    name.strip_prefix(NAME)?.parse().ok()
}

/// Returns a scene of `count` spheres in a cube of side 2 about the origin, with the eye south of it. Whatever their number, they
/// fill the same part of the cube. There are no lamps and no mirrors: only primary rays are traced.
#[must_use]
pub fn scene(count: u32) -> SceneFile {
    let mut random = fastrand::Rng::with_seed(SEED);
    let size = 0.5 / f64::from(count).cbrt();
    let mut sphere = |_| Sphere {
        position: [(); 3].map(|()| 2.0 * random.f64() - 1.0),
        radius: size * (0.5 + random.f64()),
        color: [(); 3].map(|()| 0.2 + 0.7 * random.f64()),
        surface: Surface::Opaque,
        line: 0,
    };
    let description = Description {
        spheres: (0..count).map(&mut sphere).collect(),
        ambient: [1.0; 3],
        sky: Sky { horizon: [0.1, 0.2, 0.4], zenith: [0.1, 0.2, 0.4] },
        raster: Some([SIDE; 2]),
        ..Description::empty(Camera::upright([0.0, -2.2, 0.0], [0.0, 1.0, 0.0], 1.0))
    };
    SceneFile { source: name(count), title: name(count), description, inputs: Inputs::default() }
}

/// Returns how the time of a ray grows from 1000 objects on: the exponent, which is the slope of the line through the points in
/// logarithmic scale, and the ratio of the last time to the first. None if there are fewer than two points.
#[must_use]
pub fn growth(points: &[(u32, f64)]) -> Option<(f64, f64)> {
    let points: Vec<_> = points.iter().filter(|(count, _)| *count >= 1000).collect();
    let [(_, first), .., (_, last)] = points.as_slice() else { return None };
    let logs = || points.iter().map(|(count, time)| (f64::from(*count).ln(), time.ln()));
    let number = logs().map(|_| 1.0).sum::<f64>();
    let (x, y) = logs().fold((0.0, 0.0), |(x, y), (a, b)| (x + a / number, y + b / number));
    let (slope, spread) = logs()
        .fold((0.0, 0.0), |(slope, spread), (a, b)| (slope + (a - x) * (b - y), spread + (a - x) * (a - x)));
    (spread > 0.0).then_some((slope / spread, last / first))
}

#[cfg(test)]
mod tests {
    use super::{count, growth, name, scene};

    #[test]
    fn spheres_are_where_they_should_be_and_the_same_each_time() {
        let spheres = scene(1000).description.spheres;
        assert_eq!((spheres.len(), &spheres), (1000, &scene(1000).description.spheres));
        let size = 0.05;
        for sphere in &spheres {
            assert!(sphere.position.iter().all(|c| c.abs() <= 1.0), "{sphere:?}");
            assert!((0.5 * size..=1.5 * size).contains(&sphere.radius), "{sphere:?}");
        }
        let mean = spheres.iter().map(|sphere| sphere.radius).sum::<f64>() / 1000.0;
        assert!((mean - size).abs() < 0.1 * size, "{mean}");
    }

    #[test]
    fn names_are_read_back() {
        assert_eq!(count(&name(22)), Some(22));
        assert_eq!(count("spheres-"), None);
        assert_eq!(count("juggler"), None);
    }

    #[test]
    fn growth_is_the_exponent_of_a_power() {
        let points = [1000, 10_000, 100_000].map(|count| (count, 7.0 * f64::from(count).powf(0.25)));
        // What is below 1000 plays no part.
        let points = [[(22, 1e6)].as_slice(), &points].concat();
        let (exponent, ratio) = growth(&points).expect("points");
        assert!((exponent - 0.25).abs() < 1e-9 && (ratio - 100f64.powf(0.25)).abs() < 1e-9);
        assert_eq!(growth(&[(22, 1.0), (1000, 2.0)]), None);
        assert_eq!(growth(&[]), None);
    }
}
