//! Range is proved, not hoped for: a scene is admitted to a number format before it may be drawn.
//!
//! The proof bounds every quantity over all rays that the scene can produce, each as one named [`Bound`]. It rests on
//! where rays start and end:
//!
//! - Eye, objects and lamps lie in a box and in a ball. A ray starts at the eye or on an object and what it meets lies on
//!   an object too, so no two places that are ever subtracted are farther apart than the box's diagonal or the ball's
//!   diameter: the bound of [`Quantity::Distance`]. A cylinder is seen up to the lid of the box, [`Limits::lid`].
//! - The floor goes on for ever. Its places are lit up to [`Limits::reach`] from where they are seen, which is what the
//!   format has left: the bound of [`Quantity::Reach`]. Only shadow rays start there.
//! - Components of unit vectors are at most 1 but for a few roundings; a ray's weight is a product of reflectances.
//! - Radiances saturate, on purpose: their row says at what.
//!
//! All other intermediates are differences, rounded products or roots of these; 64-bit sums have their own row.

use core::fmt;
use core::ops::Deref;

use crate::camera::Camera;
use crate::hierarchy;
use crate::material::{Finish, Material};
use crate::scalar::{Light, Scalar, Unit};
use crate::scene::{Object, Scene};
use crate::vector::{UnitVec3, Vec3, Vector};

mod extent;
mod magnitude;

use extent::Extent;
pub use magnitude::Magnitude;

/// A scene that fits its number format together with an eye.
#[derive(Clone, Copy, Debug)]
pub struct Admitted<'a, S: Scalar> {
    scene: Scene<'a, S>,
    limits: Limits<S>,
}

impl<'a, S: Scalar> Admitted<'a, S> {
    /// A scene that was admitted before, when it was baked into a program: the proof is not made again. Nothing
    /// checks that it ever was made, so this is for generated code alone; everybody else asks [`Scene::admit`].
    pub const fn baked(scene: Scene<'a, S>, limits: Limits<S>) -> Self {
        Self { scene, limits }
    }

    /// How far the scene is seen and lit.
    pub fn limits(&self) -> Limits<S> {
        self.limits
    }
}

impl<'a, S: Scalar> Deref for Admitted<'a, S> {
    type Target = Scene<'a, S>;
    fn deref(&self) -> &Self::Target {
        &self.scene
    }
}

/// Where what has no end, floor and cylinders, ends in a number format.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits<S> {
    /// A place of the floor that is seen from farther away is lit as if it were this far.
    pub reach: S,
    /// Cylinders are seen between this height and its negative.
    pub lid: S,
}

/// What is bounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Quantity {
    /// A coordinate of the eye or of the outside of an object.
    Coordinate,
    /// The distance between any two places of the scene, and along a ray.
    Distance,
    /// The same, and a coordinate, where one place is on the floor.
    Reach,
    /// The square of a distance.
    Square,
    /// The sum of three products of a length with a unit, before it is rounded.
    Product,
    /// A component of a unit vector, a cosine, a coefficient.
    Component,
    /// A component of the way from the eye to the image plane.
    ImagePlane,
    /// The reflectance of a surface.
    Reflectance,
    /// The weight of a ray: a product of reflectances.
    Weight,
    /// The largest radius of an ellipsoid over its smallest.
    Thinness,
    /// Four times the distance that a ray's start stands off a surface, against the smallest radius.
    Clearance,
    /// Radiance, which saturates by design.
    Radiance,
}

impl Quantity {
    /// What the quantity is called.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Coordinate => "coordinate",
            Self::Distance => "distance between two places",
            Self::Reach => "distance to the floor's end",
            Self::Square => "squared distance",
            Self::Product => "sum of three products",
            Self::Component => "component of a unit vector",
            Self::ImagePlane => "component of the image plane",
            Self::Reflectance => "reflectance",
            Self::Weight => "weight of a ray",
            Self::Thinness => "largest over smallest radius",
            Self::Clearance => "four times a ray's clearance",
            Self::Radiance => "radiance (saturates)",
        }
    }
}

/// A row of the proof: a quantity never exceeds its bound, and the bound not the limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bound {
    /// What is bounded.
    pub quantity: Quantity,
    /// The largest size it can have.
    pub bound: Magnitude,
    /// The largest size it may have.
    pub limit: Magnitude,
    /// Who is to blame for the bound; nothing for the eye, or where nobody is.
    pub object: Option<Object>,
}

impl Bound {
    /// Whether the bound keeps the limit, or need not.
    pub fn holds(&self) -> bool {
        self.bound <= self.limit || self.quantity == Quantity::Radiance
    }
}

/// Why a scene is refused: a row of the proof that does not hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum RangeError {
    /// A quantity exceeds its limit.
    Exceeds(Bound),
    /// A radius is not above 0 (a lamp's: below 0).
    Radius(Object),
    /// A reflectance is below 0.
    Color(Object),
    /// A node of a hierarchy leads nowhere, or, of spheres, does not contain its run of them.
    Hierarchy(usize),
}

/// Writes an object the way a scene file counts: from 1.
struct Named(Option<Object>);

impl fmt::Display for Named {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            None => write!(f, "the observer"),
            Some(Object::Floor) => write!(f, "the floor"),
            Some(object) => object.fmt(f),
        }
    }
}

impl fmt::Display for RangeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Exceeds(Bound { quantity, bound, limit, object }) => {
                let (object, quantity) = (Named(*object), quantity.name());
                write!(
                    f,
                    "{object} is out of the number format's range: {quantity} {bound}, beyond the largest {limit}"
                )
            }
            Self::Radius(object) => {
                write!(f, "{} has a radius that is not above 0 in the number format", Named(Some(*object)))
            }
            Self::Hierarchy(node) => {
                write!(f, "node {node} of the hierarchy does not contain its objects, or leads nowhere")
            }
            Self::Color(object) => {
                write!(f, "{} has a colour with a negative register", Named(Some(*object)))
            }
        }
    }
}

impl core::error::Error for RangeError {}

/// The largest of many sizes, and whose it is.
#[derive(Clone, Copy)]
struct Worst(Magnitude, Option<Object>);

impl Worst {
    const NONE: Self = Self(Magnitude::ZERO, None);

    fn see(&mut self, size: Magnitude, object: Option<Object>) {
        if size > self.0 {
            *self = Self(size, object);
        }
    }
}

/// The proof: its rows, and the limits they were found for.
#[derive(Clone, Copy, Debug)]
pub struct Proof<S> {
    /// The rows.
    pub bounds: [Bound; 12],
    /// How far the scene is seen and lit.
    pub limits: Limits<S>,
}

impl<'a, S: Scalar> Scene<'a, S> {
    /// Proves that no ray of this scene, seen from this eye, leaves the number format.
    ///
    /// # Errors
    /// The first object that does not fit, and what of it.
    pub fn admit(self, camera: &Camera<S>) -> Result<Admitted<'a, S>, RangeError> {
        self.check_signs()?;
        let proof = self.prove(camera);
        if let Some(row) = proof.bounds.iter().find(|row| !row.holds()) {
            return Err(RangeError::Exceeds(*row));
        }
        // Only now is it known that no distance between a node and its spheres leaves the format.
        let counts = [self.spheres.len(), self.ellipsoids.len(), self.cones.len(), self.triangles.len()];
        let wrong = hierarchy::first_wrong(self.hierarchy, self.spheres, hierarchy::largest_radius());
        let visible = self.lamps.iter().filter(|lamp| lamp.radius > S::ZERO).count();
        let [spheres, ellipsoids, cones, triangles] = counts;
        let laned = [spheres, ellipsoids, cones, triangles, visible];
        let wrong = wrong.or_else(|| self.boxes.first_wrong(counts));
        match wrong.or_else(|| self.lanes.first_wrong(laned, self.cylinders.len(), self.lamps.len())) {
            Some(node) => Err(RangeError::Hierarchy(node)),
            None => Ok(Admitted { scene: self, limits: proof.limits }),
        }
    }

    /// Every object with its place, extent and smallest radius.
    fn solids(&self) -> impl Iterator<Item = (Object, Vec3<S>, S, S)> {
        let ellipsoid = |(i, e): (usize, &crate::shape::Ellipsoid<S>)| {
            let (x, y, z) = (e.radii.x(), e.radii.y(), e.radii.z());
            let least = if x < y { x } else { y };
            (Object::Ellipsoid(i), e.center, e.extent, if least < z { least } else { z })
        };
        let cylinders = self.cylinders.iter().enumerate().map(|(i, c)| {
            let foot = Vec3::<S>::new(c.center.x(), c.center.y(), S::ZERO);
            (Object::Cylinder(i), foot, c.radius, c.radius)
        });
        let spheres =
            self.spheres.iter().enumerate().map(|(i, s)| (Object::Sphere(i), s.center, s.radius, s.radius));
        let lamps =
            self.lamps.iter().enumerate().map(|(i, l)| (Object::Lamp(i), l.position, l.radius, l.radius));
        let half = S::Unit::ratio(1, 2);
        let cones = self.cones.iter().enumerate().map(move |(i, c)| {
            let radius = c.span.scale(half);
            (Object::Cone(i), c.center, radius, radius)
        });
        let triangles = self
            .triangles
            .iter()
            .enumerate()
            .map(|(i, t)| (Object::Triangle(i), t.corner, t.extent, t.extent));
        let ellipsoids = self.ellipsoids.iter().enumerate().map(ellipsoid);
        cylinders.chain(ellipsoids).chain(spheres).chain(cones).chain(triangles).chain(lamps)
    }

    /// Every surface with its colour and material; the floor's second colour, too.
    fn surfaces(&self) -> impl Iterator<Item = (Object, crate::color::Rgb<S::Unit>, &Material<S>)> {
        let cylinders =
            self.cylinders.iter().enumerate().map(|(i, c)| (Object::Cylinder(i), c.color, &c.material));
        let ellipsoids =
            self.ellipsoids.iter().enumerate().map(|(i, e)| (Object::Ellipsoid(i), e.color, &e.material));
        let spheres = self.spheres.iter().enumerate().map(|(i, s)| (Object::Sphere(i), s.color, &s.material));
        let floor =
            self.floor.iter().flat_map(|f| f.colors.map(|color| (Object::Floor, color, &Material::Opaque)));
        let cones = self.cones.iter().enumerate().map(|(i, c)| (Object::Cone(i), c.color, &c.material));
        let triangles =
            self.triangles.iter().enumerate().map(|(i, t)| (Object::Triangle(i), t.color, &t.material));
        cylinders.chain(ellipsoids).chain(spheres).chain(cones).chain(triangles).chain(floor)
    }

    fn check_signs(&self) -> Result<(), RangeError> {
        for (object, _, extent, least) in self.solids() {
            let is_lamp = matches!(object, Object::Lamp(_));
            if !(least > S::ZERO || (is_lamp && extent == S::ZERO)) {
                return Err(RangeError::Radius(object));
            }
        }
        for (object, color, _) in self.surfaces() {
            if [color.r, color.g, color.b].iter().any(|&c| c < S::Unit::ZERO) {
                return Err(RangeError::Color(object));
            }
        }
        Ok(())
    }

    /// The rows of the proof, whether they hold or not.
    pub fn prove(&self, camera: &Camera<S>) -> Proof<S> {
        let largest = S::FAR.size();
        let most = largest.minus(largest.shift(-2)); // three quarters, so that the floor has a quarter at least
        let extent = Extent::of(self, camera);
        let lid = extent.lid(!self.cylinders.is_empty(), most);
        let (coordinate, distance) = extent.bounds(lid);
        // A little less than what is left, for what sums of sizes are rounded up by.
        let end = largest.minus(largest.shift(-24));
        let widest = distance.0.max(coordinate.0);
        let reach = if widest < end { end.minus(widest) } else { Magnitude::ZERO };
        let farthest = widest.plus(reach);

        let mut reflectance = Worst::NONE;
        let mut weight = Worst::NONE;
        for (object, color, material) in self.surfaces() {
            let strongest =
                [color.r, color.g, color.b].iter().map(|c| c.size()).fold(Magnitude::ZERO, Magnitude::max);
            reflectance.see(strongest, Some(object));
            match material {
                Material::Mirror => weight.see(strongest, Some(object)),
                Material::Transparent(glass) => {
                    weight.see(strongest.times(glass.ks.size()).plus(glass.kt.size()), Some(object));
                }
                Material::Finish(Finish { glass, .. }) => {
                    weight.see(
                        strongest.max(S::Unit::ONE.size()).times(glass.ks.size()).plus(glass.kt.size()),
                        Some(object),
                    );
                }
                Material::Opaque | Material::Shiny => (),
            }
        }
        // Parts of ks + kt = 1 within 1e-6, and roundings, do not make a weight grow: 255 of them are below 1.001.
        let one = S::Unit::ONE.size();
        let harmless = one.plus(one.shift(-18));
        if weight.0 > harmless {
            weight.0 = (0..8).fold(weight.0, |power, _| power.times(power));
        }
        let mut thinness = Worst(one, None);
        let mut smallest: Option<(Magnitude, Object)> = None;
        for (object, _, extent, least) in self.solids() {
            if least > S::ZERO {
                thinness.see(extent.size().over(least.size()), Some(object));
                if smallest.is_none_or(|(size, _)| least.size() < size) {
                    smallest = Some((least.size(), object));
                }
            }
        }
        let mut radiance = Worst(one, None);
        for light in [self.sky.horizon, self.sky.zenith, self.ambient] {
            for register in [light.r, light.g, light.b] {
                radiance.see(register.size(), None);
            }
        }
        for (i, lamp) in self.lamps.iter().enumerate() {
            let glint = S::power_size(lamp.power);
            radiance.see(glint, Some(Object::Lamp(i)));
            if lamp.radius > S::ZERO {
                radiance.see(glint.over(lamp.radius.size().times(lamp.radius.size())), Some(Object::Lamp(i)));
            }
        }
        let plane = |part: fn(UnitVec3<S>) -> S::Unit| {
            let half = |v| part(v).size().shift(-1);
            part(camera.forward).size().plus(half(camera.right)).plus(half(camera.up))
        };
        let image = plane(Vector::x).max(plane(Vector::y)).max(plane(Vector::z));

        let unit = S::Unit::LARGEST;
        let row = |quantity, Worst(bound, object), limit| Bound { quantity, bound, limit, object };
        let nobody = |bound| Worst(bound, distance.1);
        let bounds = [
            row(Quantity::Coordinate, coordinate, largest),
            row(Quantity::Distance, distance, most),
            row(Quantity::Reach, nobody(farthest), largest),
            row(Quantity::Square, nobody(farthest.times(farthest)), S::LARGEST_SQUARE),
            row(Quantity::Product, nobody(farthest.plus(farthest)), S::LARGEST_PRODUCT),
            row(Quantity::Component, Worst(one.plus(one.shift(-24)), None), unit),
            row(Quantity::ImagePlane, Worst(image, None), unit),
            row(Quantity::Reflectance, reflectance, unit),
            row(Quantity::Weight, weight, unit),
            row(Quantity::Thinness, thinness, S::LARGEST_STRETCH),
            match smallest {
                Some((radius, object)) => {
                    row(Quantity::Clearance, Worst(S::CLEARANCE.shift(2), Some(object)), radius)
                }
                None => row(Quantity::Clearance, Worst(S::CLEARANCE.shift(2), None), largest),
            },
            row(Quantity::Radiance, radiance, S::Light::LARGEST),
        ];
        Proof { bounds, limits: Limits { reach: S::at_most(reach), lid: S::at_most(lid) } }
    }
}
