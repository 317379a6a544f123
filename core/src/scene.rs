//! A scene is borrowed data: one list for each kind of thing, in RAM or in flash, and nothing else.
//!
//! The kinds of objects are enumerated here and nowhere else: searches and code generators go through [`Scene::each`], the range
//! proof through [`Scene::looks`]. How a scene is searched is up to an [`Accelerator`](crate::accelerator::Accelerator).

use core::fmt;
use core::ops::ControlFlow;

use crate::color::Rgb;
use crate::light::Lamp;
use crate::material::Material;
use crate::needs::{Needs, Used};
use crate::ray::Ray;
use crate::scalar::vector::{UnitVec3, Vec3, Vector};
use crate::scalar::{Light, Scalar, Unit};
pub use crate::shape::Floor;
use crate::shape::{Cone, Cylinder, Ellipsoid, Look, Move, Plane, Primitive, Sphere, SurfacePoint, Triangle};
use crate::texture::{Coat, Pattern};

/// A visitor of a scene's objects. It is given a run of consecutive objects of one list at a time.
pub trait Visit<S: Scalar> {
    /// Returns the distance along the ray up to which objects are of interest; it shrinks as hits are found.
    fn t_max(&self) -> S {
        S::FAR
    }

    /// Visits the objects `run`, of which `first` names the first; the others follow it in its list. Returns `Break` to end the
    /// search.
    fn run<P: Primitive<S>>(&mut self, first: Object, run: &[P]) -> ControlFlow<()>;
}

/// Declares the kinds of objects, one line each: its list in [`Scene`], its type, its need, and its name in errors.
macro_rules! lists {
    ($($(#[doc = $doc:literal])+ $list:ident: $Kind:ident if $NEED:ident, $name:literal;)+) => {
        /// Names what a ray meets: its kind, and its number in the list of that kind, from 0.
        ///
        /// Of equally near objects, the first in this order is seen.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Object {
            /// The floor.
            Floor,
            $($(#[doc = $doc])+ $Kind(u32),)+
            /// A lamp with a radius above 0.
            Lamp(u32),
        }

        impl Object {
            /// Returns the object `by` places later in the list of its kind.
            pub const fn after(self, by: u32) -> Self {
                match self {
                    Self::Floor => Self::Floor,
                    $(Self::$Kind(i) => Self::$Kind(i.saturating_add(by)),)+
                    Self::Lamp(i) => Self::Lamp(i.saturating_add(by)),
                }
            }
        }

        /// Writes kind and number as a scene file counts: from 1.
        impl fmt::Display for Object {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                let (name, index) = match *self {
                    Self::Floor => return f.write_str("floor"),
                    $(Self::$Kind(i) => ($name, i),)+
                    Self::Lamp(i) => ("lamp", i),
                };
                write!(f, "{name} {}", u64::from(index) + 1)
            }
        }

        /// A scene: objects, lamps, floor, sky and ambient light. The eye is a [`Camera`](crate::camera::Camera).
        #[derive(Clone, Copy, Debug)]
        pub struct Scene<'a, S: Scalar> {
            $($(#[doc = $doc])+ pub $list: &'a [$Kind<S>],)+
            /// Lamps.
            pub lamps: &'a [Lamp<S>],
            /// Materials, to which the objects refer by number.
            pub materials: &'a [Material<S>],
            /// What covers the materials, in their order, as far as any is covered. Behind the last material's comes that of the sky, where
            /// it has a picture.
            pub coats: &'a [Coat<S>],
            /// Words that coats look up: pixels and texture coordinates, as [`Image`](crate::texture::Image) says.
            pub pool: &'a [u32],
            /// The floor, if there is one.
            pub floor: Option<Floor<S>>,
            /// The light of rays that meet nothing.
            pub sky: Sky<S>,
            /// Ambient light, a radiance.
            pub ambient: Rgb<S::Light>,
        }

        /// Lists of a scene in memory that can be changed: copies of those in which something moves, and nothing in place of the others.
        #[derive(Debug)]
        pub struct Copies<'c, S: Scalar> {
            $($(#[doc = $doc])+ pub $list: &'c mut [$Kind<S>],)+
            /// Lamps.
            pub lamps: &'c mut [Lamp<S>],
        }

        impl<S: Scalar> Copies<'_, S> {
            /// Returns no copies.
            pub fn none() -> Self {
                Self { $($list: &mut [],)+ lamps: &mut [] }
            }

            /// Puts an object or a lamp where it is in `scene`, moved by a vector. What is in none of the copied lists stays where it is.
            pub fn put(&mut self, object: Object, scene: &Scene<S>, by: Vec3<S>) {
                match object {
                    $(Object::$Kind(i) => {
                        if let (Some(own), Some(copy)) = (scene.$list.get(index(i)), self.$list.get_mut(index(i))) {
                            *copy = own.moved(by);
                        }
                    })+
                    Object::Lamp(i) => {
                        if let (Some(own), Some(copy)) = (scene.lamps.get(index(i)), self.lamps.get_mut(index(i))) {
                            *copy = Lamp { position: own.position + by, ..*own };
                        }
                    }
                    Object::Floor => {}
                }
            }
        }

        impl<'a, S: Scalar> Scene<'a, S> {
            /// Returns a scene of sky and ambient light, without objects, floor and lamps.
            pub const fn empty(sky: Sky<S>, ambient: Rgb<S::Light>) -> Self {
                Scene { $($list: &[],)+ lamps: &[], materials: &[], coats: &[], pool: &[], floor: None, sky, ambient }
            }

            /// Passes all lists of primitives that `N` compiles in to `visit`, in order of [`Object`]; floor and lamps are not
            /// among them. Returns `Break` as soon as `visit` does.
            pub fn each<N: Needs>(&self, visit: &mut impl Visit<S>) -> ControlFlow<()> {
                $(if N::$NEED {
                    visit.run(Object::$Kind(0), self.$list)?;
                })+
                ControlFlow::Continue(())
            }

            /// Passes one object to `visit`, if it is in a list that `N` compiles in.
            pub fn one<N: Needs>(&self, object: Object, visit: &mut impl Visit<S>) -> ControlFlow<()> {
                match object {
                    $(Object::$Kind(i) if N::$NEED => {
                        visit.run(object, self.$list.get(index(i)).map_or(&[], core::slice::from_ref))
                    })+
                    _ => ControlFlow::Continue(()),
                }
            }

            /// Returns the surface point where a ray meets an object at the distance `t`, and the object's look; `None` for
            /// floor, lamps and numbers beyond the list.
            pub fn point<N: Needs>(
                &self,
                object: Object,
                ray: &Ray<S>,
                t: S,
            ) -> Option<(SurfacePoint<S>, Look<S>)> {
                match object {
                    $(Object::$Kind(i) if N::$NEED => {
                        self.$list.get(index(i)).map(|object| (object.point::<N>(ray, t), object.look()))
                    })+
                    _ => None,
                }
            }

            /// Returns an object's look; `None` for floor, lamps and numbers beyond the list.
            pub fn look<N: Needs>(&self, object: Object) -> Option<Look<S>> {
                match object {
                    $(Object::$Kind(i) if N::$NEED => self.$list.get(index(i)).map(Primitive::look),)+
                    _ => None,
                }
            }

            /// Returns the unit normal of a flat object whose normals are interpolated; `None` for others.
            pub fn face<N: Needs>(&self, object: Object) -> Option<UnitVec3<S>> {
                match object {
                    $(Object::$Kind(i) if N::$NEED => self.$list.get(index(i)).and_then(Primitive::face),)+
                    _ => None,
                }
            }

            /// Calls `see` with each object of the lists and its look, in order of [`Object`]; floor and lamps are left out.
            pub fn looks(&self, mut see: impl FnMut(Object, Look<S>)) {
                $((0..).zip(self.$list).for_each(|(i, object)| see(Object::$Kind(i), object.look()));)+
            }

            /// Returns the scene with the lists of what moves as `copies` has them.
            pub fn with<'c>(&self, copies: &'c Copies<'_, S>) -> Scene<'c, S>
            where
                'a: 'c,
            {
                Scene {
                    $($list: if copies.$list.is_empty() { self.$list } else { copies.$list },)+
                    lamps: if copies.lamps.is_empty() { self.lamps } else { copies.lamps },
                    ..*self
                }
            }

            /// Returns which kinds of objects the scene has; nothing else is set.
            pub fn kinds(&self) -> Used {
                Used { $($list: !self.$list.is_empty(),)+ ..Used::default() }
            }
        }
    };
}

lists! {
    /// Vertical cylinders without ends.
    cylinders: Cylinder if CYLINDERS, "cylinder";
    /// Ellipsoids.
    ellipsoids: Ellipsoid if ELLIPSOIDS, "ellipsoid";
    /// Spheres.
    spheres: Sphere if SPHERES, "sphere";
    /// Cones and cylinders between two points.
    cones: Cone if CONES, "cone";
    /// Triangles.
    triangles: Triangle if TRIANGLES, "triangle";
    /// Infinite planes.
    planes: Plane if PLANES, "plane";
}

/// The number of a diffuse material that every scene has without a list.
pub const PLAIN: u16 = u16::MAX;

/// The nearest hit of a ray.
#[derive(Clone, Copy, Debug)]
pub struct Hit<S> {
    /// Distance along the ray, as the search found it.
    pub distance: S,
    /// What was hit.
    pub object: Object,
}

/// How far the infinite objects of a scene are seen and lit, and how deep its rays may go, as [`Scene::admit`] finds it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits<S> {
    /// Distance from a ray's origin beyond which a place of the floor is lit as if it were at this distance.
    pub floor_end: S,
    /// A place of a vertical cylinder above this height, or below its negative, is lit as if it were there.
    pub cylinder_end: S,
    /// The greatest depth of a ray at which its weight fits the number format. It is 255 where no surface sends back more light
    /// than it receives.
    pub depth: u8,
}

impl<S: Scalar> Limits<S> {
    /// Returns the limits within which two scenes of the same things both fit.
    #[must_use]
    pub fn with(self, other: &Self) -> Self {
        let least = |one: S, other: S| if one < other { one } else { other };
        Self {
            floor_end: least(self.floor_end, other.floor_end),
            cylinder_end: least(self.cylinder_end, other.cylinder_end),
            depth: self.depth.min(other.depth),
        }
    }
}

/// The sky: one colour at the horizon, one at the zenith and at the nadir, mixed by the square of the sine of the
/// elevation (Graham 1987).
#[derive(Clone, Copy, Debug)]
pub struct Sky<S: Scalar> {
    /// Radiance at the horizon.
    pub horizon: Rgb<S::Light>,
    /// Radiance at the zenith.
    pub zenith: Rgb<S::Light>,
}

impl<S: Scalar> Sky<S> {
    /// Returns the radiance that comes from a direction, a unit vector.
    pub fn radiance<N: Needs>(&self, direction: UnitVec3<S>) -> Rgb<S::Light> {
        // Mixing a colour with itself would round it.
        if !N::SKY_GRADIENT || self.horizon == self.zenith {
            return self.horizon;
        }
        let high = direction.z().times(direction.z());
        let low = S::Unit::ONE - high;
        self.horizon.zip(self.zenith, |horizon, zenith| horizon.times(low).plus(zenith.times(high)))
    }
}

impl<'a, S: Scalar> Scene<'a, S> {
    /// Returns a material by its number; a diffuse one for [`PLAIN`] and for a number beyond the list, with which no scene is
    /// admitted.
    pub fn material(&self, number: u16) -> &'a Material<S> {
        self.materials.get(usize::from(number)).unwrap_or(&Material::Opaque)
    }

    /// Returns the radiance that comes from a direction, a unit vector, in which there is nothing.
    pub fn radiance<N: Needs>(&self, direction: UnitVec3<S>) -> Rgb<S::Light> {
        if N::SKY_MAP && self.coats.len() > self.materials.len() {
            return self.mapped_sky(direction);
        }
        self.sky.radiance::<N>(direction)
    }

    /// Returns the radiance that the picture of the sky has in a direction; none without a picture.
    #[inline(never)] // inlined, it keeps other code from being so
    fn mapped_sky(&self, direction: UnitVec3<S>) -> Rgb<S::Light> {
        let texture = self.coats.get(self.materials.len()).and_then(|coat| coat.texture.as_ref());
        match texture.map(|texture| &texture.pattern) {
            Some(Pattern::Image(image)) => image.sky::<S>(self.pool, direction),
            _ => Rgb::BLACK,
        }
    }

    /// Returns an empty chequered floor under a blue sky by day, with ambient light and no lamp.
    pub fn day() -> Self {
        let unit = |n| S::Unit::ratio(n, 100);
        let light = |r, g, b| Rgb::new(unit(r), unit(g), unit(b)).map(|part| S::Light::WHITE.times(part));
        let sky = Sky { horizon: light(75, 82, 95), zenith: light(10, 22, 60) };
        let floor = Floor {
            colors: [Rgb::new(unit(85), unit(85), unit(80)), Rgb::new(unit(15), unit(17), unit(25))],
            tile: None,
            material: PLAIN,
        };
        Scene { floor: Some(floor), ..Scene::empty(sky, light(30, 30, 32)) }
    }
}

/// Returns a number as an index; for one that is too large for the machine, an index beyond all lists.
pub(crate) fn index(number: u32) -> usize {
    usize::try_from(number).unwrap_or(usize::MAX)
}
