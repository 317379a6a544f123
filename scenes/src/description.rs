//! What a scene file says, owned and in `f64`, before it enters any number format.
//!
//! Every reader ends here and everything else starts here. A description made by a reader holds only finite
//! numbers that make sense (positive radii, ks + kt = 1 and so on); whether they fit a number format is asked
//! later, when the description becomes a scene of that format.

use rta_core::scene::Object;

use crate::warning::Warning;

mod air;
mod camera;
mod details;
mod dispersion;
mod light;
mod material;
mod motion;
mod path;
mod quad;
mod settings;
mod texture;

pub use rta_core::light::FallOff;
pub use rta_core::texture::Shading;

pub use crate::model::Model;
pub use air::{Air, Attenuation, Fading, Medium};
pub use camera::{Camera, Optics, Side};
pub use details::{Detail, Details, LampShape};

pub use dispersion::Dispersion;
pub use light::{Arriving, Caching, Shown, Solution, Solved};
pub use material::{Coefficients, Edge, Kind, Material, Slope};
pub use path::{Journey, Keyframe, Path};
pub use quad::{Quad, Shining, bilinear, cut};
pub use settings::{ModelOption, Settings};
pub use texture::{Axis, Pattern, Pixels, Texture};

/// A whole scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Description {
    /// Where the observer stands and looks.
    pub camera: Camera,
    /// Infinite vertical cylinders.
    pub cylinders: Vec<Cylinder>,
    /// Ellipsoids with axes parallel to those of the world.
    pub ellipsoids: Vec<Ellipsoid>,
    /// Spheres.
    pub spheres: Vec<Sphere>,
    /// Cones and cylinders between two points.
    pub cones: Vec<Cone>,
    /// Triangles.
    pub triangles: Vec<Triangle>,
    /// Quads, in the order of their triangles.
    pub quads: Vec<Quad>,
    /// Infinite planes.
    pub planes: Vec<Plane>,
    /// Lamps.
    pub lamps: Vec<Lamp>,
    /// Materials with names, to which objects refer by number.
    pub materials: Vec<Material>,
    /// The chequered floor z = 0; the thesis's files always have one.
    pub floor: Option<Floor>,
    /// Ambient light, linear RGB, each at least 0.
    pub ambient: [f64; 3],
    /// What a ray sees that meets nothing.
    pub sky: Sky,
    /// The illumination model that the scene was made for.
    pub model: Model,
    /// Width and height in pixels that the scene was made for, if its file says so; the pixels are square.
    pub raster: Option<[u32; 2]>,
    /// What a camera with a lens has that a pinhole has not.
    pub optics: Optics,
    /// How the scene is to be drawn, as far as its file says so.
    pub settings: Settings,
    /// What light meets between the surfaces.
    pub air: Air,
    /// Textures, to which materials refer by name.
    pub textures: Vec<Texture>,
    /// What few objects and lamps have.
    pub details: Details,
    /// What the reader has to say about the file.
    pub warnings: Vec<Warning>,
}

/// What a surface is made of: one of the thesis's types 0 to 3, coefficients of its own, or a material with a name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Surface {
    /// Type 0: diffuse.
    Opaque,
    /// Type 1: diffuse with highlights.
    Shiny,
    /// Type 2: a perfect mirror, tinted with its colour.
    Mirror,
    /// Type 3: glass.
    Transparent {
        /// Share of the light that is reflected, 0 to 1.
        ks: f64,
        /// Share of the light that is transmitted, 0 to 1; ks + kt = 1 within 1e-6.
        kt: f64,
        /// Index of refraction of the inside with respect to the outside, above 0.
        ior: f64,
    },
    /// With coefficients of its own.
    Finish {
        /// Diffuse coefficient, at least 0.
        kd: f64,
        /// Specular coefficient, at least 0: of highlights, and share of the light that is reflected.
        ks: f64,
        /// Exponent of highlights, at least 0.
        exponent: f64,
        /// Share of the light that is transmitted, at least 0.
        kt: f64,
        /// Index of refraction of the inside with respect to the outside, above 0.
        ior: f64,
    },
    /// Of a material in [`Description::materials`], by its number there, from 0.
    Of(u16),
}

/// An infinite cylinder parallel to z.
#[derive(Clone, Debug, PartialEq)]
pub struct Cylinder {
    /// A point of the axis; its z plays no part.
    pub position: [f64; 3],
    /// Linear RGB, each at least 0.
    pub color: [f64; 3],
    /// Radius, above 0.
    pub radius: f64,
    /// Its material.
    pub surface: Surface,
    /// Line of the source where it begins, from 1; 0 if it has none.
    pub line: u32,
}

/// An ellipsoid whose axes are parallel to those of the world.
#[derive(Clone, Debug, PartialEq)]
pub struct Ellipsoid {
    /// Centre.
    pub position: [f64; 3],
    /// Linear RGB, each at least 0.
    pub color: [f64; 3],
    /// Half axes along x, y and z, above 0.
    pub radii: [f64; 3],
    /// Whether only its inside is seen.
    pub inside_only: bool,
    /// Its material.
    pub surface: Surface,
    /// Line of the source where it begins, from 1; 0 if it has none.
    pub line: u32,
}

/// A sphere.
#[derive(Clone, Debug, PartialEq)]
pub struct Sphere {
    /// Centre.
    pub position: [f64; 3],
    /// Linear RGB, each at least 0.
    pub color: [f64; 3],
    /// Radius, above 0.
    pub radius: f64,
    /// Its material.
    pub surface: Surface,
    /// Line of the source where it begins, from 1; 0 if it has none.
    pub line: u32,
}

/// The side of a cone that is cut off between two points; a cylinder if its radii are equal.
#[derive(Clone, Debug, PartialEq)]
pub struct Cone {
    /// Centre of one end.
    pub base: [f64; 3],
    /// Radius there, at least 0.
    pub base_radius: f64,
    /// Centre of the other end.
    pub apex: [f64; 3],
    /// Radius there, at least 0, and not 0 where the other is.
    pub apex_radius: f64,
    /// Whether discs close its ends.
    pub capped: bool,
    /// Whether only its inside is seen.
    pub inside_only: bool,
    /// Linear RGB, each at least 0.
    pub color: [f64; 3],
    /// Its material.
    pub surface: Surface,
    /// Line of the source where it begins, from 1; 0 if it has none.
    pub line: u32,
}

/// A triangle. Its outside is where its vertices run counterclockwise.
#[derive(Clone, Debug, PartialEq)]
pub struct Triangle {
    /// Vertices, not on one line.
    pub vertices: [[f64; 3]; 3],
    /// Normals at the vertices, of any length but zero: the surface is shaded as if it were curved.
    pub normals: Option<[[f64; 3]; 3]>,
    /// Whether only its outside is seen.
    pub one_sided: bool,
    /// Linear RGB, each at least 0.
    pub color: [f64; 3],
    /// Its material.
    pub surface: Surface,
    /// Line of the source where it begins, from 1; 0 if it has none.
    pub line: u32,
}

/// An infinite plane, seen from both sides.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane {
    /// A point of it.
    pub point: [f64; 3],
    /// Its normal, of any length but zero.
    pub normal: [f64; 3],
    /// Linear RGB, each at least 0.
    pub color: [f64; 3],
    /// Its material.
    pub surface: Surface,
    /// Line of the source where it begins, from 1; 0 if it has none.
    pub line: u32,
}

/// A spherical lamp.
#[derive(Clone, Debug, PartialEq)]
pub struct Lamp {
    /// Centre, from where it shines.
    pub position: [f64; 3],
    /// Intensity, linear RGB, each at least 0. Where it falls with the square of the distance, 40000 is usual.
    pub color: [f64; 3],
    /// Radius of the sphere that is seen; 0 is a lamp that shines unseen.
    pub radius: f64,
    /// Whether the light becomes less with the distance.
    pub fall_off: FallOff,
    /// Line of the source where it begins, from 1; 0 if it has none.
    pub line: u32,
}

/// The floor z = 0 with square tiles, of the side [`Details::tile`].
#[derive(Clone, Debug, PartialEq)]
pub struct Floor {
    /// Colours, linear RGB, each at least 0: of the tile that begins at the origin, and of its neighbours.
    pub colors: [[f64; 3]; 2],
    /// Its material.
    pub surface: Surface,
}

/// The sky, which goes from one colour to the other with the square of the sine of the elevation.
#[derive(Clone, Debug, PartialEq)]
pub struct Sky {
    /// Colour of the horizon, linear RGB, each at least 0.
    pub horizon: [f64; 3],
    /// Colour straight up (and straight down), linear RGB, each at least 0.
    pub zenith: [f64; 3],
}

impl Description {
    /// Returns how a triangle is shaded, by its number from 0: one without normals has nothing to mix.
    pub(crate) fn shading(&self, number: usize) -> Shading {
        let has_normals = self.triangles.get(number).is_some_and(|triangle| triangle.normals.is_some());
        let object = u32::try_from(number).ok().filter(|_| has_normals).map(Object::Triangle);
        let detail = object.and_then(|object| self.details.objects.get(&object));
        detail.map_or(Shading::Normals, |detail| detail.shading)
    }

    /// Shades all triangles with normals in one way.
    pub fn shade_all(&mut self, shading: Shading) {
        for (number, triangle) in (0..).zip(&self.triangles) {
            if triangle.normals.is_some() {
                self.details.objects.entry(Object::Triangle(number)).or_default().shading = shading;
            }
        }
    }

    /// Nothing, in the dark.
    #[must_use]
    pub fn empty(camera: Camera) -> Self {
        Self {
            camera,
            cylinders: Vec::new(),
            ellipsoids: Vec::new(),
            spheres: Vec::new(),
            cones: Vec::new(),
            triangles: Vec::new(),
            quads: Vec::new(),
            planes: Vec::new(),
            lamps: Vec::new(),
            materials: Vec::new(),
            floor: None,
            ambient: [0.0; 3],
            sky: Sky { horizon: [0.0; 3], zenith: [0.0; 3] },
            model: Model::Rta,
            raster: None,
            optics: Optics::default(),
            settings: Settings::default(),
            air: Air::default(),
            textures: Vec::new(),
            details: Details::default(),
            warnings: Vec::new(),
        }
    }
}
