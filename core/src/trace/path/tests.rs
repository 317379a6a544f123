//! Paths in rooms whose light is known.

mod furnace;
mod lamps;

use super::{Asked, Emitter, Paths, Rules};
use crate::accelerator::Lists;
use crate::camera::{Camera, Lens};
use crate::color::Rgb;
use crate::illumination::Illumination;
use crate::needs::Everything;
use crate::range::Admitted;
use crate::scalar::read::{Read, direction, place};
use crate::scalar::{Scalar, Unit};
use crate::scene::{Scene, Sky};
use crate::shape::Triangle;
use crate::texture::Coat;
use crate::trace::dice::{Sample, Spread};
use crate::trace::{Distributed, Observer, Trace, Tracer};

/// Rules without chance but for directions: no roulette, and no lamp is asked.
const PLAIN: Rules = Rules { bounces: 64, roulette: None, lamps: Asked::None, weighs: false };

fn grey<S: Read>(part: f64) -> Rgb<S::Unit> {
    let part = S::unit(part);
    Rgb::new(part, part, part)
}

fn light<S: Scalar>(radiance: f64) -> Rgb<S::Light> {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "of a test")]
    let radiance = S::intensity(S::power((radiance * f64::from(1 << 30)) as u32, -30));
    Rgb::new(radiance, radiance, radiance)
}

fn black_sky<S: Scalar>() -> Scene<'static, S> {
    let black = Rgb::BLACK;
    Scene::empty(Sky { horizon: black, zenith: black }, black)
}

fn coat<S: Scalar>(radiance: f64) -> Coat<S> {
    Coat { emission: light::<S>(radiance), ..Coat::PLAIN }
}

/// Returns the two triangles of a parallelogram that are seen from the side of `normal`.
fn halves<S: Read>(
    [corner, first, second]: [[f64; 3]; 3],
    normal: [f64; 3],
    (color, material): (f64, u16),
) -> [Triangle<S>; 2] {
    let end = [0, 1, 2].map(|i| first[i] + second[i] - corner[i]);
    [[corner, first, end], [corner, end, second]].map(|corners| Triangle {
        vertices: corners.map(place::<S>),
        extent: S::length(3.0),
        normal: direction::<S>(normal),
        normals: None,
        one_sided: false,
        color: grey::<S>(color),
        material,
    })
}

/// The sides of the cube from -1 to 1: a corner, the two next to it, and the normal inwards.
fn sides() -> [([[f64; 3]; 3], [f64; 3]); 6] {
    [0, 1, 2, 3, 4, 5].map(|side: usize| {
        let (axis, at) = (side / 2, if side.is_multiple_of(2) { -1.0 } else { 1.0 });
        let corner = |u: f64, v: f64| {
            let mut place = [0.0; 3];
            place[axis] = at;
            place[(axis + 1) % 3] = u;
            place[(axis + 2) % 3] = v;
            place
        };
        let mut normal = [0.0; 3];
        normal[axis] = -at;
        // The product of the edges is along the normal.
        let [first, second] = [corner(1.0, -1.0), corner(-1.0, 1.0)];
        let edges = if at < 0.0 { [first, second] } else { [second, first] };
        ([corner(-1.0, -1.0), edges[0], edges[1]], normal)
    })
}

/// Returns the triangles of the cube from -1 to 1 seen from inside.
fn cube<S: Read>(color: f64, material: u16) -> [Triangle<S>; 12] {
    let all = sides().map(|(corners, normal)| halves::<S>(corners, normal, (color, material)));
    core::array::from_fn(|i| all[i / 2][i % 2])
}

/// What is traced, and how.
struct Traced<'a, S: Scalar> {
    scene: Scene<'a, S>,
    spread: Spread<'a, S>,
    emitters: &'a [Emitter<S>],
    eye: [f64; 3],
    towards: [f64; 3],
}

impl<S: Read> Traced<'_, S> {
    /// Calls `see` with the light of each of so many paths through the middle of a pixel.
    fn paths<M: Illumination<S>, O: Observer<S>>(
        &self,
        model: M,
        (rules, seed, count): (Rules, u32, u32),
        observer: &mut O,
        mut see: impl FnMut(f64),
    ) {
        let camera = Camera::new(place::<S>(self.eye), direction::<S>(self.towards), Lens::new(1, 1, (1, 1)));
        let admitted: Admitted<'_, S> = self.scene.admit_with(&camera, Lists).expect("it is small");
        let tracer: Tracer<'_, S, M, Everything, 1> = Tracer::new(&admitted, model, 0).expect("not deep");
        let spread = Distributed { tracer, spread: &self.spread, seed };
        let paths = Paths { spread, emitters: self.emitters, rules };
        for number in 0..count {
            let sample = Sample { x: 3, y: 5, number };
            let middle = (S::Unit::ZERO, S::Unit::ZERO);
            see(S::shine(paths.sample(&camera, middle, sample, &mut (), observer).g));
        }
    }

    /// Returns the mean of 32 seeds of `count` paths each, and its standard error.
    fn mean<M: Illumination<S> + Clone>(&self, model: &M, rules: Rules, count: u32) -> [f64; 2] {
        let mut sums = [0.0; 2];
        for seed in 0..32 {
            let mut sum = 0.0;
            self.paths(model.clone(), (rules, seed, count), &mut (), |light| sum += light);
            let mean = sum / f64::from(count);
            sums = [sums[0] + mean, sums[1] + mean * mean];
        }
        let mean = sums[0] / 32.0;
        [mean, libm::sqrt((sums[1] / 32.0 - mean * mean).max(0.0) / 31.0)]
    }
}

/// Checks that means with standard errors are one number, within 5 of their standard errors.
fn assert_one_mean(means: &[[f64; 2]], exact: f64) {
    for [mean, error] in means {
        assert!((mean - exact).abs() <= 5.0 * error + 1e-9, "{mean} +- {error}, not {exact}: of {means:?}");
    }
}
