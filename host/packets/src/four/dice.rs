//! What the rays of four samples are spread by.

use core::fmt::Debug;

use glam::Vec4;
use rta_core::camera::Camera;
use rta_core::raster::Raster;
use rta_core::sampling::pairs::Purpose;
use rta_core::trace::dice::{Dice, LampPlaces, Lamps, Sample, Spread, Still, Thrown};

use super::geometry::{Ray4, normalize, through_plane};
use super::mapping::disc;
use super::pairs::{Pairs4, Words};
use super::vector::{Vec3x4, one_ref, set};

/// The dice of four samples.
pub(crate) trait Dice4 {
    /// Whether nothing is spread.
    const STILL: bool;
    /// The place of a ray in the ray tree.
    type Node: Copy + Debug;
    /// The dice of one sample.
    type One<'d>: Dice<f32, Node = Self::Node>
    where
        Self: 'd;
    /// The place of the ray from the eye.
    const EYE: Self::Node;

    /// Returns the dice of one of them.
    fn one(&self, k: usize) -> Self::One<'_>;

    /// Returns whether some light was solved ahead.
    fn has_solved(&self) -> bool;

    /// Returns the places on a lamp that are asked for the points where the rays at `nodes` end; `None` if it is a point. All are points that the eye
    /// sees if `are_first`, or none is.
    fn places(&self, _lamp: usize, _nodes: [Self::Node; 4], _are_first: bool) -> Option<Places4> {
        None
    }
}

/// Dice that spread nothing.
pub(crate) struct Still4;

impl Dice4 for Still4 {
    const STILL: bool = true;
    type Node = ();
    type One<'d> = Still;
    const EYE: () = ();

    #[inline(always)]
    fn one(&self, _k: usize) -> Still {
        Still
    }

    #[inline(always)]
    fn has_solved(&self) -> bool {
        false
    }
}

/// The dice of four samples of a picture: four times [`Thrown`].
pub(crate) struct Thrown4<'t> {
    spread: &'t Spread<'t, f32>,
    samples: [Sample; 4],
    seed: u32,
    dice: [Thrown<'t, f32>; 4],
}

impl<'t> Thrown4<'t> {
    /// Returns the dice of four samples.
    #[inline(always)]
    pub(crate) fn new(spread: &'t Spread<'t, f32>, samples: [Sample; 4], seed: u32) -> Self {
        let dice = samples.map(|sample| Thrown { spread, sample, seed });
        Self { spread, samples, seed, dice }
    }

    /// Returns the pairs of numbers of the four samples for a purpose, at the eye's rays.
    #[inline(always)]
    fn pairs(&self, purpose: Purpose) -> Pairs4 {
        Pairs4::new(&self.samples, [purpose.tag(1); 4], self.seed)
    }

    /// Returns the rays of the samples from the eye, or from spots of a lens, through their places in their pixels: four times what
    /// [`Distributed`](rta_core::trace::Distributed) begins with at the places of a [`Sobol`](rta_core::sampling::Sobol).
    #[inline(always)]
    pub(crate) fn start(&self, camera: &Camera<f32>, raster: Raster) -> Ray4 {
        let numbers = self.samples.map(|sample| sample.number);
        let [right, down] = self.pairs(Purpose::Pixel).words(numbers);
        let right = along(self.samples.map(|sample| sample.x), right, raster.width());
        let up = -along(self.samples.map(|sample| sample.y), down, raster.height());
        let Some(aperture) = &self.spread.aperture else {
            let direction = through_plane(camera.forward, camera.right, camera.up, right, up);
            return Ray4 { origin: Vec3x4::splat(camera.eye), direction };
        };
        let spot = disc(self.pairs(Purpose::Lens).units(numbers));
        let [eastward, upward] = aperture.axes.map(Vec3x4::splat);
        let [shift_right, shift_up] = spot.map(|c| -(c * Vec4::splat(aperture.shift)));
        let [radius_right, radius_up] = spot.map(|c| Vec4::splat(aperture.radius) * c);
        let [forward, camera_right, camera_up] = [camera.forward, camera.right, camera.up].map(Vec3x4::splat);
        let place = forward.plus(camera_right, right).plus(camera_up, up);
        let (direction, .., none) = normalize(place.plus(eastward, shift_right).plus(upward, shift_up));
        let direction = Vec3x4::select(super::vector::mask(none), forward, direction);
        let eye = Vec3x4::splat(camera.eye);
        Ray4 { origin: eye.plus(eastward, radius_right).plus(upward, radius_up), direction }
    }
}

/// Returns how far along their image plane samples of four pixels lie, from -1/2 to 1/2, for a word of each: four times what
/// [`Sobol`](rta_core::sampling::Sobol) does for one of its axes.
#[inline(always)]
#[allow(clippy::cast_precision_loss)] // to the nearest
fn along(pixels: Words, words: Words, count: u32) -> Vec4 {
    let (middle, whole) = (i64::from(count) << 16, (i64::from(count) << 17) as f32);
    let mut places = Vec4::ZERO;
    for (k, (pixel, word)) in pixels.into_iter().zip(words).enumerate() {
        let part = i64::from(pixel << 16 | word >> 16);
        set(&mut places, k, (2 * part - middle) as f32);
    }
    places / Vec4::splat(whole)
}

impl Dice4 for Thrown4<'_> {
    const STILL: bool = false;
    type Node = u32;
    type One<'d>
        = &'d Thrown<'d, f32>
    where
        Self: 'd;
    const EYE: u32 = 1;

    #[inline(always)]
    fn one(&self, k: usize) -> &Thrown<'_, f32> {
        one_ref(&self.dice, k)
    }

    #[inline(always)]
    fn has_solved(&self) -> bool {
        self.spread.indirect.is_some()
    }

    #[inline(always)]
    fn places(&self, lamp: usize, nodes: [u32; 4], are_first: bool) -> Option<Places4> {
        match self.spread.lamps {
            Lamps::Point | Lamps::Cone => None,
            Lamps::Fixed(side) => Some(Places4::Grid(LampPlaces::grid(side))),
            Lamps::Area => {
                let count = if are_first { u32::from(self.spread.split.max(1)) } else { 1 };
                let seed = self.one(0).of_lamp(lamp).seed;
                let tags = nodes.map(|node| Purpose::Lamp.tag(node));
                let pairs = Pairs4::new(&self.samples, tags, seed);
                let first = self.samples.map(|sample| sample.number.wrapping_mul(count));
                Some(Places4::Sequence { pairs, first, count })
            }
        }
    }
}

/// Places on a lamp for four points: four times [`LampPlaces`].
pub(crate) enum Places4 {
    /// A grid, whose places all points share.
    Grid(LampPlaces),
    /// Of sequences, from these pairs on.
    Sequence { pairs: Pairs4, first: Words, count: u32 },
}

impl Places4 {
    /// Returns how many places each point has, at least 1.
    pub(crate) const fn count(&self) -> u32 {
        match self {
            Self::Grid(places) => places.count(),
            Self::Sequence { count, .. } => *count,
        }
    }

    /// Returns place number `k` of each, from 0, as pairs of numbers from 0 to 1.
    #[inline(always)]
    pub(crate) fn get(&self, k: u32) -> [Vec4; 2] {
        match self {
            Self::Grid(places) => places.get::<f32>(k).map(Vec4::splat),
            Self::Sequence { pairs, first, .. } => pairs.units(first.map(|first| first.wrapping_add(k))),
        }
    }
}
