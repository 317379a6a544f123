//! The range proof: before a scene is drawn, it is proved that no number of it leaves the number format.
//!
//! The proof bounds every quantity over all rays that the scene can produce, each in one [`Bound`]. It follows from where
//! rays start and end:
//!
//! - Eye, objects and lamps lie in a box and in a ball. A ray starts at the eye or on an object and ends on an object or at
//!   a lamp, so no two places that are ever subtracted are farther apart than the box's diagonal or the ball's diameter:
//!   the bound of [`Quantity::Distance`]. A vertical cylinder is lit up to [`Limits::cylinder_end`].
//! - The floor is infinite. Its places are lit up to the distance [`Limits::floor_end`] from a ray's origin, the room that the
//!   format has left: the bound of [`Quantity::Reach`]. Only shadow rays start there.
//! - Components of unit vectors are at most 1 plus some rounding; a ray's weight is a product of reflectances, one for each level
//!   of its depth: [`Limits::depth`] is the deepest that fits.
//! - Other planes are infinite too. Their places lie within [`Plane::reach`](crate::shape::Plane::reach) of their centres, so
//!   that each counts as a disc of that radius.
//! - Radiances saturate, on purpose: their row names the largest. So does all that a surface sends back of a lamp:
//!   [`Incident::reflected`](crate::light::Incident::reflected) takes a reflectance without a bound.
//! - What models of illumination compute on the way is bounded whatever the scene: shares are from 0 to 1, each term of a sum meets the
//!   light before it is added, and all else is a [`Positive`](crate::scalar::Positive) number, which has an exponent. The bounds are
//!   stated where the numbers are formed: in [`fresnel`](crate::illumination::fresnel),
//!   [`microfacet`](crate::illumination::microfacet) and [`fade`](crate::illumination::fade).
//!
//! All other intermediate results are differences, rounded products or roots of these; 64-bit sums have their own row.

use crate::accelerator::{Accelerator, Lists};
use crate::camera::{Aperture, Camera};
use crate::color::Rgb;
use crate::error::Error;
use crate::material::{Finish, Material};
pub use crate::quantity::{Bound, Cause, Quantity};
use crate::scalar::vector::{UnitVec3, Vec3, Vector};
use crate::scalar::{Light, Magnitude, Number, Scalar, Unit};
use crate::scene::{Limits, Object, PLAIN, Scene};
use crate::texture::Texture;

mod admitted;
mod extent;

pub use admitted::Admitted;
use extent::Extent;

/// The largest of many sizes, and the object that has it.
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

/// Returns a bound of the largest register of a colour.
fn strongest(Rgb { r, g, b }: Rgb<impl Number>) -> Magnitude {
    r.size().max(g.size()).max(b.size())
}

/// Returns the bound of the weight of a ray of this depth, of which each surface sends on no more than that part.
fn weight<U: Unit>(Worst(part, object): Worst, depth: u8) -> Bound {
    let bound = (0..depth).fold(U::ONE.size(), |weight, _| weight.times(part));
    Bound { quantity: Quantity::Weight(depth), bound, limit: U::LARGEST, object, other: None }
}

/// Returns the greatest depth at which the weight of a ray is within its limit.
fn deepest<U: Unit>(part: Magnitude) -> u8 {
    let mut weight = U::ONE.size();
    let fits = |_: &u8| {
        weight = weight.times(part);
        weight <= U::LARGEST
    };
    (1..=u8::MAX).take_while(fits).last().unwrap_or(0)
}

/// The proof: its rows, the limits for which they were computed, and whether they hold.
#[derive(Clone, Copy, Debug)]
pub struct Proof<S> {
    /// One row for each [`Quantity`].
    pub bounds: [Bound; 13],
    /// How far floor and vertical cylinders are seen and lit, and how deep rays may go.
    pub limits: Limits<S>,
    /// Why the scene is refused, if it is.
    pub refused: Option<Error>,
}

impl<'a, S: Scalar> Scene<'a, S> {
    /// Proves that no ray of this scene from this eye leaves the number format, and returns the scene, searched by [`Lists`];
    /// [`Scene::admit_with`] takes another accelerator.
    ///
    /// # Errors
    /// The first object or quantity that does not fit.
    pub fn admit(self, camera: &Camera<S>) -> Result<Admitted<'a, S>, Error> {
        self.admit_with(camera, Lists)
    }

    /// Proves that no ray of this scene from a lens around this eye leaves the number format, as [`Scene::admit_with`] does for a
    /// pinhole.
    ///
    /// # Errors
    /// Those of [`Scene::admit_with`].
    pub fn admit_lens<A: Accelerator<S>>(
        self,
        (camera, aperture): (&Camera<S>, &Aperture<S>),
        accelerator: A,
    ) -> Result<Admitted<'a, S, A>, Error> {
        self.admit_from(camera, Some(aperture), accelerator)
    }

    /// Proves that no ray of this scene from this eye leaves the number format, and returns the scene with its accelerator.
    ///
    /// # Errors
    /// The first object or quantity that does not fit, or the first node of the accelerator that is wrong.
    pub fn admit_with<A: Accelerator<S>>(
        self,
        camera: &Camera<S>,
        accelerator: A,
    ) -> Result<Admitted<'a, S, A>, Error> {
        self.admit_from(camera, None, accelerator)
    }

    fn admit_from<A: Accelerator<S>>(
        self,
        camera: &Camera<S>,
        aperture: Option<&Aperture<S>>,
        accelerator: A,
    ) -> Result<Admitted<'a, S, A>, Error> {
        let proof = self.prove_from(camera, aperture, &accelerator);
        if let Some(error) = proof.refused {
            return Err(error);
        }
        // Only after the proof may the distances between nodes and objects be computed.
        accelerator.check(&self)?;
        Ok(Admitted::baked(self, proof.limits, accelerator))
    }

    /// Calls `see` with every object and lamp: its place, its bounding sphere's radius and its smallest radius.
    fn solids(&self, mut see: impl FnMut(Object, Vec3<S>, S, S)) {
        self.looks(|object, look| see(object, look.center, look.radius, look.least));
        for (i, lamp) in (0..).zip(self.lamps) {
            see(Object::Lamp(i), lamp.position, lamp.radius, lamp.radius);
        }
    }

    /// Calls `see` with every surface, its colour and material: more than once with those that have several colours, as the floor has.
    pub fn surfaces(&self, mut see: impl FnMut(Object, Rgb<S::Unit>, &Material<S>)) {
        let mut covered = |object, color, number| {
            see(object, color, self.material(number));
            let texture = self.coats.get(usize::from(number)).and_then(|coat| coat.texture.as_ref());
            for color in texture.into_iter().flat_map(Texture::extremes) {
                see(object, color, self.material(number));
            }
        };
        self.looks(|object, look| covered(object, look.color, look.material));
        if let Some(floor) = &self.floor {
            floor.colors.iter().for_each(|color| covered(Object::Floor, *color, floor.material));
        }
    }

    /// Checks that the weight of a ray of this depth fits: a ray carries a factor for each surface that it left, and two mirrors
    /// face to face reach it.
    ///
    /// # Errors
    /// [`Error::Exceeds`] if it does not.
    pub fn check_depth(&self, depth: u8) -> Result<(), Error> {
        let weight = weight::<S::Unit>(self.heaviest(), depth);
        if weight.holds() { Ok(()) } else { Err(Error::Exceeds(weight)) }
    }

    /// Returns the largest part of its light that a surface sends on, 1 at least, and the surface.
    fn heaviest(&self) -> Worst {
        let one = S::Unit::ONE.size();
        let mut weight = Worst(one, None);
        self.surfaces(|object, color, material| {
            let strongest = strongest(color);
            let part = match material {
                Material::Mirror => strongest,
                Material::Transparent(glass) => strongest.times(glass.ks.size()).plus(glass.kt.size()),
                Material::Finish(Finish { glass, .. }) => {
                    strongest.max(one).times(glass.ks.size()).plus(glass.kt.size())
                }
                Material::Opaque | Material::Shiny => return,
            };
            weight.see(part, Some(object));
        });
        weight
    }

    fn check_signs(&self) -> Result<(), Error> {
        let mut first = Ok(());
        let numbers = self.floor.iter().map(|floor| (Object::Floor, floor.material));
        let mut check = |object, number: u16| {
            if first.is_ok() && number != PLAIN && usize::from(number) >= self.materials.len() {
                first = Err(Error::Material(object));
            }
        };
        self.looks(|object, look| check(object, look.material));
        numbers.for_each(|(object, number)| check(object, number));
        self.solids(|object, _, radius, least| {
            let is_lamp = matches!(object, Object::Lamp(_));
            if first.is_ok() && !(least > S::ZERO || (is_lamp && radius == S::ZERO)) {
                first = Err(Error::Radius(object));
            }
        });
        self.surfaces(|object, color, _| {
            if first.is_ok() && [color.r, color.g, color.b].iter().any(|&c| c < S::Unit::ZERO) {
                first = Err(Error::Color(object));
            }
        });
        first
    }

    /// Returns the proof, whether its rows hold or not, for a scene that is searched by `accelerator`.
    pub fn prove(&self, camera: &Camera<S>, accelerator: &impl Accelerator<S>) -> Proof<S> {
        self.prove_from(camera, None, accelerator)
    }

    fn prove_from(
        &self,
        camera: &Camera<S>,
        aperture: Option<&Aperture<S>>,
        accelerator: &impl Accelerator<S>,
    ) -> Proof<S> {
        let (reach, shift) = aperture.map_or((S::ZERO, S::Unit::ZERO), |lens| (lens.radius, lens.shift));
        let largest = S::FAR.size();
        let most = largest.minus(largest.shift(-2)); // three quarters, so that the floor has a quarter at least
        let extent = Extent::of(self, (camera.eye, reach), accelerator);
        let cylinder_end = extent.cylinder_end(!self.cylinders.is_empty(), most);
        let (coordinate, distance) = extent.bounds(cylinder_end);
        // A little less than the room that is left, as sums of sizes are rounded up.
        let end = largest.minus(largest.shift(-24));
        let widest = distance.0.max(coordinate.0);
        let floor_end = if widest < end { end.minus(widest) } else { Magnitude::ZERO };
        let farthest = widest.plus(floor_end);

        let one = S::Unit::ONE.size();
        let mut reflectance = Worst::NONE;
        self.surfaces(|object, color, material| {
            let factor = match material {
                Material::Finish(Finish { ka, kd, .. }) => one.max(ka.size()).max(kd.size()),
                _ => one,
            };
            reflectance.see(strongest(color).times(factor), Some(object));
        });
        let heaviest = self.heaviest();
        let depth = deepest::<S::Unit>(heaviest.0);
        let weight = weight::<S::Unit>(heaviest, depth);
        let mut seen_cylinders = Worst::NONE;
        if !self.cylinders.is_empty() {
            seen_cylinders.see(cylinder_end, Some(Object::Cylinder(0)));
        }
        let mut thinness = Worst(one, None);
        let mut smallest = (largest, None);
        self.solids(|object, _, radius, least| {
            if least > S::ZERO {
                if radius > least {
                    thinness.see(radius.size().over(least.size()), Some(object));
                }
                if least.size() < smallest.0 {
                    smallest = (least.size(), Some(object));
                }
            }
        });
        let mut radiance = Worst(one, None);
        for light in [self.sky.horizon, self.sky.zenith, self.ambient] {
            radiance.see(strongest(light), None);
        }
        for (i, lamp) in (0..).zip(self.lamps) {
            let glint = lamp.power.size();
            radiance.see(glint, Some(Object::Lamp(i)));
            if lamp.radius > S::ZERO {
                radiance.see(glint.over(lamp.radius.size()).over(lamp.radius.size()), Some(Object::Lamp(i)));
            }
        }
        let plane = |part: fn(UnitVec3<S>) -> S::Unit| {
            let half = |v| part(v).size().shift(-1);
            part(camera.forward).size().plus(half(camera.right)).plus(half(camera.up)).plus(shift.size())
        };
        let image = plane(Vector::x).max(plane(Vector::y)).max(plane(Vector::z));

        let unit = S::Unit::LARGEST;
        let row =
            |quantity, Worst(bound, object), limit| Bound { quantity, bound, limit, object, other: None };
        let nobody = |bound| Worst(bound, distance.1);
        let bounds = [
            row(Quantity::Coordinate, coordinate, largest),
            Bound { other: extent.opposite(distance.1), ..row(Quantity::Distance, distance, most) },
            row(Quantity::Reach, nobody(farthest), largest),
            row(Quantity::CylinderEnd, seen_cylinders, largest),
            row(Quantity::Square, nobody(farthest.times(farthest)), S::LARGEST_SQUARE),
            row(Quantity::Product, nobody(farthest.plus(farthest)), S::LARGEST_PRODUCT),
            row(Quantity::Component, Worst(one.plus(one.shift(-24)), None), unit),
            row(Quantity::ImagePlane, Worst(image, None), unit),
            row(Quantity::Reflectance, reflectance, unit),
            weight,
            row(Quantity::Thinness, thinness, S::LARGEST_STRETCH),
            row(Quantity::Clearance, Worst(S::CLEARANCE.shift(2), smallest.1), smallest.0),
            row(Quantity::Radiance, radiance, S::Light::LARGEST),
        ];
        let (floor_end, cylinder_end) = (S::at_most(floor_end), S::at_most(cylinder_end));
        let limits = Limits { floor_end, cylinder_end, depth };
        let exceeds = || bounds.iter().find(|row| !row.holds()).map(|row| Error::Exceeds(*row));
        let refused = self.check_signs().err().or_else(exceeds);
        Proof { bounds, limits, refused }
    }
}
