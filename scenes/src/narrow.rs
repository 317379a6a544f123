//! From a description in `f64` into a scene of one number format, or an error that says what does not fit.

use rta_core::accelerator::Lists;
use rta_core::camera::{Camera, Lens};
use rta_core::color::Rgb;
use rta_core::light::Lamp;
use rta_core::material::Material;
use rta_core::range::Admitted;
use rta_core::scene::{Limits, Scene, Sky};
use rta_core::shape::{Cone, Cylinder, Ellipsoid, Floor, Plane, Sphere, Triangle};
use rta_core::texture::Coat;
use rta_core::vector::Vector;
use rta_core::{Error, Scalar};

use crate::description::{self, Description, Side};
use crate::space::{cross, unit};
use crate::spectrum::wavelength;

pub mod air;
mod check;
mod coats;
mod cone;
mod error;
mod formats;
pub mod lit;
mod lobes;
mod materials;
pub mod moving;
mod plane;
mod properties;
pub mod quads;
pub use properties::conductor;
pub mod spectrum;
pub mod spreads;
#[cfg(test)]
mod tests;
pub mod triangle;
pub mod variant;

use check::Checker;
pub use check::exponent;
pub use error::NarrowError;
use lit::Lit;
use materials::Materials;
pub(crate) use materials::finishes;
use spectrum::{Spectrum, Table, weights};
use spreads::Spreads;
use variant::Options;

/// A number format that descriptions can be narrowed to.
pub trait Narrow: Scalar {
    /// What the format is called on a command line.
    const NAME: &'static str;
    /// The smallest radius: a ray's start must be able to stand off a surface without leaving it far behind.
    const SMALLEST_RADIUS: f64;
    /// The largest reflectance.
    const LARGEST_COLOR: f64;
    /// The largest radiance of sky and ambient light.
    const LARGEST_LIGHT: f64;
    /// The largest intensity of a lamp.
    const LARGEST_POWER: f64;
    /// The largest length.
    fn largest() -> f64;
    /// The nearest length; the value is within the format.
    fn length(value: f64) -> Self;
    /// The nearest component or coefficient; the value is within the format.
    fn unit(value: f64) -> Self::Unit;
    /// The nearest radiance; the value is within the format.
    fn light(value: f64) -> Self::Light;
    /// The nearest intensity; the value is within the format.
    fn power(value: f64) -> Self::Power;
    /// Returns a length as a float, exactly.
    fn to_f64(self) -> f64;
    /// Returns a component or coefficient as a float, exactly.
    fn unit_to_f64(unit: Self::Unit) -> f64;
    /// Returns a radiance as a float, exactly.
    fn light_to_f64(light: Self::Light) -> f64;
    /// Returns an intensity, or another number without a bound, as a float, exactly.
    fn power_to_f64(power: Self::Power) -> f64;
    /// Brings a description into the format: what [`narrow`] calls, compiled once for each format.
    ///
    /// # Errors
    /// Those of [`narrow`].
    fn narrowed(description: &Description, aspect: f64) -> Result<Narrowed<Self>, NarrowError> {
        brought(description, aspect)
    }
    /// Proves that a scene fits the format: what [`Narrowed::admit`] calls, compiled once for each format.
    ///
    /// # Errors
    /// Those of [`Scene::admit`].
    fn limits(scene: &Narrowed<Self>) -> Result<Limits<Self>, Error> {
        moving::proved(scene, Lists)
    }
}

/// A scene and an eye in one number format: the lists that a core [`Scene`] borrows.
#[derive(Clone, Debug)]
pub struct Narrowed<S: Narrow> {
    /// Eye and image plane.
    pub camera: Camera<S>,
    /// Cylinders.
    pub cylinders: Vec<Cylinder<S>>,
    /// Ellipsoids.
    pub ellipsoids: Vec<Ellipsoid<S>>,
    /// Spheres.
    pub spheres: Vec<Sphere<S>>,
    /// Cones and cylinders between two points.
    pub cones: Vec<Cone<S>>,
    /// Triangles.
    pub triangles: Vec<Triangle<S>>,
    /// Infinite planes.
    pub planes: Vec<Plane<S>>,
    /// Lamps.
    pub lamps: Vec<Lamp<S>>,
    /// Materials, in the order of the numbers by which the objects refer to them.
    pub materials: Vec<Material<S>>,
    /// What a picture of several wavelengths has besides; the materials are those of the first.
    pub spectrum: Option<Spectrum<S>>,
    /// What the scene says of each of the materials, for models that have parameters of their own.
    pub said: Vec<description::Material>,
    /// What covers the materials, in the order of their numbers as far as any is covered, and then the sky.
    pub coats: Vec<Coat<S>>,
    /// Words that coats look up.
    pub pool: Vec<u32>,
    /// The options of the illumination model that the scene is made for.
    pub options: Options,
    /// The floor.
    pub floor: Option<Floor<S>>,
    /// The sky.
    pub sky: Sky<S>,
    /// Ambient light.
    pub ambient: Rgb<S::Light>,
    /// What spreads rays.
    pub spreads: Spreads<S>,
    /// Radiosity that was solved ahead.
    pub lit: Option<Lit<S>>,
}

impl<S: Narrow> Narrowed<S> {
    /// The scene, borrowed.
    pub fn scene(&self) -> Scene<'_, S> {
        Scene {
            cylinders: &self.cylinders,
            ellipsoids: &self.ellipsoids,
            spheres: &self.spheres,
            cones: &self.cones,
            triangles: &self.triangles,
            planes: &self.planes,
            lamps: &self.lamps,
            materials: &self.materials,
            coats: &self.coats,
            pool: &self.pool,
            floor: self.floor,
            sky: self.sky,
            ambient: self.ambient,
        }
    }

    /// Proves that the scene fits its format from its eye, as [`Scene::admit`] does.
    ///
    /// # Errors
    /// The first object or quantity that does not fit.
    pub fn admit(&self) -> Result<Admitted<'_, S>, Error> {
        Ok(Admitted::baked(self.scene(), S::limits(self)?, Lists))
    }
}

fn camera<S: Narrow>(camera: &description::Camera, aspect: f64) -> Result<Camera<S>, NarrowError> {
    let eye = Checker::<S>::named("the observer").place(camera.eye, 0.0)?;
    let forward = camera.direction().unwrap_or([0.0, 1.0, 0.0]);
    let (width, height) = match camera.side {
        Side::Width => (1.0, 1.0 / aspect),
        Side::Height => (aspect, 1.0),
    };
    let largest = camera.focal.max(width).max(height);
    let lens = [camera.focal, width, height].map(|side| side / largest);
    let vector = |v: [f64; 3], length: f64| {
        let [x, y, z] = v.map(|c| S::unit(c * length));
        Vector::new(x, y, z)
    };
    let [focal, width, height] = lens;
    if let Some(right) = camera.up.and_then(|up| unit(cross(forward, up))) {
        let up = cross(right, forward);
        let (forward, right, up) = (vector(forward, focal), vector(right, width), vector(up, height));
        return Ok(Camera { eye, forward, right, up });
    }
    let [focal, width, height] = lens.map(S::unit);
    Ok(Camera::new(eye, vector(forward, 1.0), Lens { focal, width, height }))
}

fn lamp<S: Narrow>(index: usize, lamp: &description::Lamp) -> Result<Lamp<S>, NarrowError> {
    let (check, fall_off) = (Checker::<S>::new("lamp", index, lamp.line), lamp.fall_off);
    let position = check.place(lamp.position, lamp.radius)?;
    let radius = if lamp.radius == 0.0 { S::ZERO } else { check.radius(lamp.radius)? };
    let strongest = lamp.color.iter().fold(0.0f64, |most, &register| most.max(register));
    check.at_most("the intensity", strongest, S::LARGEST_POWER)?;
    let [r, g, b] =
        lamp.color.map(|register| S::unit(if strongest > 0.0 { register / strongest } else { 0.0 }));
    let lamp = Lamp::new(position, radius, <S as Narrow>::power(strongest), Rgb::new(r, g, b));
    Ok(Lamp { fall_off, ..lamp })
}

/// Brings a description into the number format `S`, for a screen of the shape `aspect : 1`.
///
/// # Errors
/// The first thing that the format cannot hold, with its size and the limit.
pub fn narrow<S: Narrow>(description: &Description, aspect: f64) -> Result<Narrowed<S>, NarrowError> {
    S::narrowed(description, aspect)
}

fn brought<S: Narrow>(description: &Description, aspect: f64) -> Result<Narrowed<S>, NarrowError> {
    let held = description.has_motion().then(|| description.in_the_middle());
    let description = held.as_ref().unwrap_or(description);
    let (shining, solved) = (description.shining(), Lit::of(description)?);
    let is_lit = description.has_emitters() || description.details.light.is_some();
    let lit = is_lit.then(|| description.with_emitters());
    let description = lit.as_ref().unwrap_or(description);
    air::check_reach::<S>(&description.air)?;
    let is_dispersive = description.materials.iter().any(|material| material.dispersion.is_some());
    let count = description.settings.wavelengths.filter(|_| is_dispersive).unwrap_or(0);
    let wavelengths = (0..count).map(|i| wavelength(i, count)).collect();
    let mut materials = Materials::<S>::new(&description.materials, wavelengths);
    let mut cylinders = Vec::with_capacity(description.cylinders.len());
    for (i, c) in description.cylinders.iter().enumerate() {
        let check = Checker::<S>::new("cylinder", i, c.line);
        let (place, radius) =
            (check.place([c.position[0], c.position[1], 0.0], c.radius)?, check.radius(c.radius)?);
        cylinders.push(Cylinder::new(
            place,
            radius,
            check.color("a colour's register", c.color)?,
            materials.number(&check, &c.surface)?,
        ));
    }
    let mut ellipsoids = Vec::with_capacity(description.ellipsoids.len());
    for (i, e) in description.ellipsoids.iter().enumerate() {
        let check = Checker::<S>::new("ellipsoid", i, e.line);
        let extent = e.radii.iter().fold(0.0f64, |most, &radius| most.max(radius));
        let place = check.place(e.position, extent)?;
        let [x, y, z] = e.radii;
        let radii = Vector::new(check.radius(x)?, check.radius(y)?, check.radius(z)?);
        let color = check.color("a colour's register", e.color)?;
        let material = materials.number(&check, &e.surface)?;
        let mut ellipsoid = Ellipsoid::new(place, radii, color, material);
        // The ratios once more, from the numbers of the file: a thin radius has few digits in the format.
        let thinnest = x.min(y).min(z);
        let [a, b, c] = e.radii.map(|radius| S::unit(thinnest / radius));
        ellipsoid.squash = Vector::new(a, b, c);
        ellipsoid.thickness = S::unit(thinnest / extent);
        ellipsoid.inside_only = e.inside_only;
        ellipsoids.push(ellipsoid);
    }
    let mut spheres = Vec::with_capacity(description.spheres.len());
    for (i, s) in description.spheres.iter().enumerate() {
        let check = Checker::<S>::new("sphere", i, s.line);
        let (place, radius) = (check.place(s.position, s.radius)?, check.radius(s.radius)?);
        spheres.push(Sphere::new(
            place,
            radius,
            check.color("a colour's register", s.color)?,
            materials.number(&check, &s.surface)?,
        ));
    }
    let cones = description.cones.iter().enumerate().map(|(i, c)| {
        let check = Checker::new("cone", i, c.line);
        Ok(Cone { material: materials.number(&check, &c.surface)?, ..cone::narrow(i, c)? })
    });
    let cones = cones.collect::<Result<Vec<_>, _>>()?;
    let triangles = description.triangles.iter().enumerate().map(|(i, t)| {
        let check = Checker::new("triangle", i, t.line);
        let material = materials.shaded(&check, &t.surface, description.shading(i))?;
        Ok(Triangle { material, ..triangle::narrow(i, t)? })
    });
    let triangles = triangles.collect::<Result<Vec<_>, _>>()?;
    let eye = description.camera.eye;
    let planes = description.planes.iter().enumerate().map(|(i, p)| {
        let check = Checker::new("plane", i, p.line);
        Ok(Plane { material: materials.number(&check, &p.surface)?, ..plane::narrow(i, p, eye)? })
    });
    let planes = planes.collect::<Result<Vec<_>, _>>()?;
    let lamps = description.lamps.iter().enumerate().map(|(i, l)| lamp(i, l));
    let lamps = lamps.collect::<Result<Vec<_>, _>>()?;
    let floor = match &description.floor {
        None => None,
        Some(floor) => {
            let check = Checker::<S>::named("the floor");
            let [even, odd] = floor.colors;
            Some(Floor {
                colors: [check.color("a colour's register", even)?, check.color("a colour's register", odd)?],
                tile: description.details.tile.map(|side| check.side(side)).transpose()?,
                material: materials.number(&check, &floor.surface)?,
            })
        }
    };
    let Materials { first: Table { materials, said }, shadings, further, .. } = materials;
    let (coats, pool) = coats::narrow(description, &said, &shadings)?;
    let is_several = !further.is_empty();
    let camera = camera(&description.camera, aspect)?;
    let spreads = Spreads::of(description, &said, &camera, &shining)?;
    let spectrum = is_several.then(|| Spectrum { weights: weights::<S>(count), further });
    Ok(Narrowed {
        camera,
        cylinders,
        ellipsoids,
        spheres,
        cones,
        triangles,
        planes,
        lamps,
        materials,
        spectrum,
        said,
        coats,
        pool,
        options: Options::of(description),
        floor,
        sky: Sky {
            horizon: Checker::<S>::named("the horizon").light(description.sky.horizon)?,
            zenith: Checker::<S>::named("the zenith").light(description.sky.zenith)?,
        },
        ambient: Checker::<S>::named("the ambient light").light(description.ambient)?,
        spreads,
        lit: solved,
    })
}
