//! What a scene file says, owned and in `f64`, before it enters any number format.
//!
//! Every reader ends here and everything else starts here. A description made by a reader holds only finite
//! numbers that make sense (positive radii, ks + kt = 1 and so on); whether they fit a number format is asked
//! later, when the description becomes a scene of that format.

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
    /// Lamps.
    pub lamps: Vec<Lamp>,
    /// The chequered floor z = 0; the thesis's files always have one.
    pub floor: Option<Floor>,
    /// Ambient light, linear RGB, each at least 0.
    pub ambient: [f64; 3],
    /// What a ray sees that meets nothing.
    pub sky: Sky,
}

/// The pinhole camera. Its image plane is 1 unit wide.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// The observer's position.
    pub eye: [f64; 3],
    /// The direction of view: of any length but zero.
    pub view: [f64; 3],
    /// Distance from the eye to the image plane, above 0.
    pub focal: f64,
}

impl Camera {
    /// The direction of view with length 1.
    ///
    /// It is scaled by its greatest component first, so that neither 1e300 nor 1e-300 leaves the range of `f64`.
    /// `None` if the direction is zero or not finite.
    #[must_use]
    pub fn direction(&self) -> Option<[f64; 3]> {
        let greatest = self.view.iter().fold(0.0_f64, |most, part| most.max(part.abs()));
        if greatest <= 0.0 || !self.view.iter().all(|part| part.is_finite()) {
            return None;
        }
        let scaled = self.view.map(|part| part / greatest);
        let length = scaled.iter().map(|part| part * part).sum::<f64>().sqrt();
        Some(scaled.map(|part| part / length))
    }
}

/// What a surface is made of: the thesis's types 0 to 3.
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

/// A spherical lamp.
#[derive(Clone, Debug, PartialEq)]
pub struct Lamp {
    /// Centre, from where it shines.
    pub position: [f64; 3],
    /// Intensity, linear RGB, each at least 0. It falls with the square of the distance, so 40000 is usual.
    pub color: [f64; 3],
    /// Radius of the sphere that is seen; 0 is a lamp that shines unseen.
    pub radius: f64,
    /// Line of the source where it begins, from 1; 0 if it has none.
    pub line: u32,
}

/// The floor z = 0 with tiles of 3 x 3 units.
#[derive(Clone, Debug, PartialEq)]
pub struct Floor {
    /// Colours, linear RGB, each at least 0: of the tile that begins at the origin, and of its neighbours.
    pub colors: [[f64; 3]; 2],
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
    /// The same scene with every `line` set to 0: two files say the same if these are equal.
    #[must_use]
    pub fn without_lines(mut self) -> Self {
        self.cylinders.iter_mut().for_each(|cylinder| cylinder.line = 0);
        self.ellipsoids.iter_mut().for_each(|ellipsoid| ellipsoid.line = 0);
        self.spheres.iter_mut().for_each(|sphere| sphere.line = 0);
        self.lamps.iter_mut().for_each(|lamp| lamp.line = 0);
        self
    }
}

#[cfg(test)]
mod tests {
    use super::Camera;

    fn direction(view: [f64; 3]) -> Option<[f64; 3]> {
        Camera { eye: [0.0; 3], view, focal: 1.0 }.direction()
    }

    #[test]
    fn direction_neither_overflows_nor_vanishes() {
        for scale in [1e300, 1e-300, 1e-320, 1.0] {
            let [x, y, z] = direction([3.0 * scale, 0.0, -4.0 * scale]).expect("it is not zero");
            // Subnormals have few digits left: 1e-320 holds about three.
            let tolerance = if scale < 1e-307 { 1e-3 } else { 1e-15 };
            assert!((x - 0.6).abs() < tolerance && y == 0.0 && (z + 0.8).abs() < tolerance, "{x} {y} {z}");
        }
        assert_eq!(direction([0.0, 5e-324, 0.0]), Some([0.0, 1.0, 0.0]));
    }

    #[test]
    fn no_direction_of_nothing() {
        assert_eq!(direction([0.0, -0.0, 0.0]), None);
        assert_eq!(direction([f64::NAN, 1.0, 0.0]), None);
        assert_eq!(direction([f64::INFINITY, 1.0, 0.0]), None);
    }
}
