//! What the rays of a sample are spread by.
//!
//! The tracer asks its [`Dice`] wherever one ray of the ray tree stands for many. [`Still`] dice spread nothing, and the tracer is then
//! Whitted's, to the last bit and to the last instruction; [`Thrown`] dice make it that of R. Cook, T. Porter and L. Carpenter
//! ("Distributed Ray Tracing", SIGGRAPH 84).

use core::fmt::Debug;

use crate::camera::Aperture;
use crate::color::Rgb;
use crate::illumination::microfacet::{Roughness, Visible};
use crate::illumination::table::MOST_SLOPES;
use crate::light::area::Square;
use crate::needs::Needs;
use crate::radiosity::Indirect;
use crate::ray::RayKind;
use crate::sampling::mapping::Facets;
use crate::sampling::pairs::{Pairs, Purpose, pair};
use crate::scalar::vector::Vec3;
use crate::scalar::{Scalar, Unit};
use crate::scene::Object;
use crate::surface::Surface;

/// What the rays of a sample are spread by. It is handed on by value, so that [`Still`] dice take no memory.
pub trait Dice<S: Scalar>: Copy {
    /// Whether nothing is spread, so that the compiler leaves out all that spreads.
    const STILL: bool;
    /// The place of a ray in the ray tree.
    type Node: Copy + Debug;
    /// The place of the ray from the eye.
    const EYE: Self::Node;

    /// Returns the place of a secondary ray of that kind, from that of its parent.
    fn child(node: Self::Node, kind: RayKind) -> Self::Node;

    /// Returns the roughness of a material by its number, 0 (a mirror) to 1; and what chooses the facet that reflects or refracts the ray at
    /// `node`: two numbers of 32 bits behind the point.
    fn facet(self, _material: u16, _node: Self::Node) -> Option<(S::Unit, [u32; 2])> {
        None
    }

    /// Returns the slopes of a material by its number that is rough by [grooves](Visible::Grooved); none of other materials.
    fn slopes<'d>(self, _material: u16) -> &'d [Roughness<S::Unit>]
    where
        Self: 'd,
    {
        &[]
    }

    /// Returns the facets of a rough material by its number and its roughness.
    fn facets<'d, N: Needs>(self, material: u16, roughness: S::Unit) -> Visible<'d, S::Unit>
    where
        Self: 'd,
        S: 'd,
    {
        let slopes = if N::GROOVES { self.slopes(material) } else { &[] };
        if slopes.is_empty() { Visible::Round(Facets { roughness }) } else { Visible::Grooved(slopes) }
    }

    /// Returns the places on lamp number `lamp` that light the point where the ray at `node` ends, or the air on its way, as `purpose` says;
    /// `None` if the lamp is a point. `is_first` says whether that is a point that the eye sees.
    fn places(self, _lamp: usize, _for: (Purpose, Self::Node), _is_first: bool) -> Option<LampPlaces> {
        None
    }

    /// Returns where in the steps through the air that the ray at `node` goes through their light is taken, 0 to 1; `None` for the middles.
    fn step(self, _node: Self::Node) -> Option<S::Unit> {
        None
    }

    /// Returns the bodies of [`Spread::bodies`] where lamps are asked by cones; `None` where they are not.
    fn bodies<'d>(self) -> Option<&'d [u32]>
    where
        Self: 'd,
    {
        None
    }

    /// Returns the light that a surface, a point of `object`, receives in the place of the scene's ambient light; `None` where it has that.
    fn arriving(self, _object: Object, _surface: &Surface<S>) -> Option<Rgb<S::Light>> {
        None
    }

    /// Returns the parallelogram that lamp number `lamp` is; `None` where it is a sphere.
    fn square<'d>(self, _lamp: usize) -> Option<&'d Square<S>>
    where
        Self: 'd,
    {
        None
    }
}

/// Dice that spread nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Still;

impl<S: Scalar> Dice<S> for Still {
    const STILL: bool = true;
    type Node = ();
    const EYE: () = ();

    fn child((): (), _kind: RayKind) {}
}

/// How lamps with a size are asked for their light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Lamps {
    /// As points in their middles: shadows have sharp edges.
    #[default]
    Point,
    /// At the middles of a grid of `n x n` cells, for a side n of 1 or more: the same places for every point (Verbeck and Greenberg
    /// 1984), so that the edge of a shadow is a staircase of as many steps.
    Fixed(u8),
    /// At places that differ from point to point.
    Area,
    /// By one cone from each point to the sphere of a lamp, which things cover in part: soft shadows without noise, but where several things
    /// cover the same or different parts of a lamp, it is not known which ([`light::cone`](crate::light::cone)). Lamps that are
    /// parallelograms count as the spheres that they are seen as.
    Cone,
}

/// What spreads in a scene. It is borrowed data beside the scene, so that a scene in which nothing spreads is as it was.
#[derive(Clone, Copy, Debug)]
pub struct Spread<'a, S: Scalar> {
    /// How lamps are asked.
    pub lamps: Lamps,
    /// Places on each lamp that are asked for a point that the eye sees, 1 or more; all other points ask for one.
    pub split: u16,
    /// Lamps that are parallelograms, in the order of the scene's lamps as far as any is one.
    pub squares: &'a [Option<Square<S>>],
    /// The lens, if there is one: without it the camera is a pinhole.
    pub aperture: Option<Aperture<S>>,
    /// Roughness of the materials, 0 to 1, in the order of the scene's materials as far as any is rough.
    pub roughness: &'a [S::Unit],
    /// Slopes of the materials that are rough by [grooves](Visible::Grooved) with Beckmann's slopes, with shares that add up to 1, in the
    /// order of the scene's materials as far as any is; those of a share of 0 are left out, and of other materials, whose roughness alone counts,
    /// all are.
    pub slopes: &'a [[Roughness<S::Unit>; MOST_SLOPES]],
    /// Which triangles are faces of one body, for [`Lamps::Cone`]: a number for each, equal for those of one body, which follow one another, in
    /// the order of the scene's triangles; those beyond are bodies by themselves.
    pub bodies: &'a [u32],
    /// Light that was solved ahead and takes the place of the scene's ambient light.
    pub indirect: Option<Indirect<'a, S>>,
    /// How far the eye moves while the shutter is open, for a tracer of what [moves](super::moving::Moving): half of it before it is where the
    /// camera is, and half of it after that. It keeps its direction.
    pub eye: Option<Vec3<S>>,
}

impl<S: Scalar> Spread<'_, S> {
    /// Nothing spreads.
    pub const NONE: Self = Self {
        lamps: Lamps::Point,
        split: 1,
        squares: &[],
        aperture: None,
        roughness: &[],
        slopes: &[],
        bodies: &[],
        indirect: None,
        eye: None,
    };
}

/// Which sample of a picture is traced.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sample {
    /// Column of the pixel, from 0.
    pub x: u32,
    /// Row of the pixel, from 0 at the top.
    pub y: u32,
    /// Number of the sample in its pixel, from 0.
    pub number: u32,
}

/// The dice of one sample.
#[derive(Clone, Copy, Debug)]
pub struct Thrown<'a, S: Scalar> {
    /// What spreads.
    pub spread: &'a Spread<'a, S>,
    /// The sample.
    pub sample: Sample,
    /// The seed, by which pictures of the same scene differ.
    pub seed: u32,
}

impl<S: Scalar> Thrown<'_, S> {
    /// Returns the sequence of pairs of the sample's pixel for a purpose, at a ray of the tree.
    pub fn pairs(&self, purpose: Purpose, node: u32) -> Pairs {
        Pairs::new(self.sample.x, self.sample.y, purpose.tag(node), self.seed)
    }

    /// Returns the sample's own pair of numbers for a purpose, at a ray of the tree: two numbers of 32 bits behind the point.
    pub fn words(&self, purpose: Purpose, node: u32) -> [u32; 2] {
        let Sample { x, y, number } = self.sample;
        pair(x, y, purpose.tag(node), self.seed, number)
    }

    /// Returns the dice for a lamp, by its number: each lamp has a seed of its own.
    #[inline]
    pub fn of_lamp(&self, lamp: usize) -> Self {
        let lamp = u32::try_from(lamp).unwrap_or(u32::MAX);
        Self { seed: self.seed.wrapping_add(lamp.wrapping_mul(0x9e37_79b9)), ..*self }
    }
}

impl<S: Scalar> Dice<S> for &Thrown<'_, S> {
    const STILL: bool = false;
    /// The numbers of [`Purpose::tag`].
    type Node = u32;
    const EYE: u32 = 1;

    fn child(node: u32, kind: RayKind) -> u32 {
        node.wrapping_mul(2).wrapping_add(u32::from(kind == RayKind::Transmitted))
    }

    fn facet(self, material: u16, node: u32) -> Option<(S::Unit, [u32; 2])> {
        let roughness = *self.spread.roughness.get(usize::from(material))?;
        (roughness > S::Unit::ZERO).then(|| (roughness, self.words(Purpose::Lobe, node)))
    }

    fn slopes<'d>(self, material: u16) -> &'d [Roughness<S::Unit>]
    where
        Self: 'd,
    {
        self.spread.slopes.get(usize::from(material)).map_or(&[], |slopes| Roughness::used(slopes))
    }

    fn step(self, node: u32) -> Option<S::Unit> {
        let [shift, _] = self.words(Purpose::Air, node);
        Some(S::Unit::of_word(shift))
    }

    fn places(self, lamp: usize, (purpose, node): (Purpose, u32), is_first: bool) -> Option<LampPlaces> {
        match self.spread.lamps {
            Lamps::Point | Lamps::Cone => None,
            Lamps::Fixed(side) => Some(LampPlaces::grid(side)),
            Lamps::Area => {
                let split = if is_first { u32::from(self.spread.split.max(1)) } else { 1 };
                let own = self.of_lamp(lamp);
                let first = self.sample.number.wrapping_mul(split);
                Some(LampPlaces::some(own.pairs(purpose, node), first, split))
            }
        }
    }

    fn bodies<'d>(self) -> Option<&'d [u32]>
    where
        Self: 'd,
    {
        (self.spread.lamps == Lamps::Cone).then_some(self.spread.bodies)
    }

    fn arriving(self, object: Object, surface: &Surface<S>) -> Option<Rgb<S::Light>> {
        self.spread.indirect.as_ref().map(|indirect| indirect.at(object, surface))
    }

    fn square<'d>(self, lamp: usize) -> Option<&'d Square<S>>
    where
        Self: 'd,
    {
        self.spread.squares.get(lamp)?.as_ref()
    }
}

/// Places on a lamp, as pairs of numbers from 0 to 1.
#[derive(Clone, Copy, Debug)]
pub struct LampPlaces {
    count: u32,
    from: From,
}

#[derive(Clone, Copy, Debug)]
enum From {
    /// The middles of a grid of this side.
    Grid(u32),
    /// A sequence, from this pair on.
    Sequence(Pairs, u32),
}

impl LampPlaces {
    /// Returns the middles of a grid of `side x side` cells; a side of 0 counts as 1.
    pub fn grid(side: u8) -> Self {
        let side = u32::from(side.max(1));
        Self { count: side * side, from: From::Grid(side) }
    }

    /// Returns `count` pairs of a sequence, from pair number `first` on.
    pub const fn some(pairs: Pairs, first: u32, count: u32) -> Self {
        Self { count, from: From::Sequence(pairs, first) }
    }

    /// Returns how many places there are, at least 1.
    pub const fn count(&self) -> u32 {
        self.count
    }

    /// Returns place number `k`, from 0.
    pub fn get<U: Unit>(&self, k: u32) -> [U; 2] {
        match self.from {
            From::Grid(side) => [k % side, k / side].map(|cell| {
                // At most 509 of 510.
                U::fraction((2 * cell + 1).cast_signed(), 2 * side)
            }),
            From::Sequence(pairs, first) => pairs.units(first.wrapping_add(k)),
        }
    }
}
