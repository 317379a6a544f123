//! A scene is borrowed data: one list for each kind of thing, in RAM or in flash, and nothing else.
//!
//! The kinds of objects are enumerated here and nowhere else: [`Scene::each`] is what searches, the range proof and bakers go
//! by. How a scene is searched is no part of it, but an [`Accelerator`](crate::accelerator::Accelerator).

mod limits;

use core::fmt;
use core::ops::ControlFlow;

pub use limits::Limits;

use crate::color::Rgb;
use crate::light::Lamp;
use crate::needs::{Needs, Used};
use crate::ray::Ray;
use crate::scalar::vector::{UnitVec3, Vector};
use crate::scalar::{Light, Scalar, Unit};
pub use crate::shape::Floor;
use crate::shape::{Cone, Cylinder, Ellipsoid, Look, Primitive, Sphere, SurfacePoint, Triangle};

/// Is shown objects, a run of one list at a time.
pub trait Visit<S: Scalar> {
    /// How far along the ray objects are of interest; shrinks as hits are found.
    fn t_max(&self) -> S {
        S::FAR
    }

    /// Is shown the objects `run`, the first of which has the number `first` in the list of its kind; says whether it has
    /// seen enough.
    fn run<P: Primitive<S>>(&mut self, first: Object, run: &[P]) -> ControlFlow<()>;
}

/// Declares the kinds of objects, one line each: its list in [`Scene`], its need, its type, and its name in errors. Of things
/// that are equally near, the first in order of these lines is seen.
macro_rules! lists {
    ($($(#[doc = $doc:literal])+ $list:ident: $Kind:ident if $NEED:ident, $name:literal;)+) => {
        /// What a ray meets: which, in its list.
        ///
        /// Of things that are equally near, the first in this order is seen.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Object {
            /// The floor.
            Floor,
            $($(#[doc = $doc])+ $Kind(u32),)+
            /// A visible lamp.
            Lamp(u32),
        }

        impl Object {
            /// Returns the object that comes `by` places later in the list of its kind.
            pub const fn after(self, by: u32) -> Self {
                match self {
                    Self::Floor => Self::Floor,
                    $(Self::$Kind(i) => Self::$Kind(i.saturating_add(by)),)+
                    Self::Lamp(i) => Self::Lamp(i.saturating_add(by)),
                }
            }
        }

        /// As a scene file counts: from 1.
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

        /// A scene, but for the eye.
        #[derive(Clone, Copy, Debug)]
        pub struct Scene<'a, S: Scalar> {
            $($(#[doc = $doc])+ pub $list: &'a [$Kind<S>],)+
            /// Lamps.
            pub lamps: &'a [Lamp<S>],
            /// The floor, if there is one.
            pub floor: Option<Floor<S>>,
            /// What a ray sees that meets nothing.
            pub sky: Sky<S>,
            /// Ambient light.
            pub ambient: Rgb<S::Light>,
        }

        impl<'a, S: Scalar> Scene<'a, S> {
            /// A scene in which there is nothing but sky and ambient light.
            pub const fn empty(sky: Sky<S>, ambient: Rgb<S::Light>) -> Self {
                Scene { $($list: &[],)+ lamps: &[], floor: None, sky, ambient }
            }

            /// Shows `visit` all lists of objects that `N` has need of, in order of [`Object`], until it has seen enough.
            /// Floor and lamps are no objects of a list of primitives and are not shown.
            pub fn each<N: Needs>(&self, visit: &mut impl Visit<S>) -> ControlFlow<()> {
                $(if N::$NEED {
                    visit.run(Object::$Kind(0), self.$list)?;
                })+
                ControlFlow::Continue(())
            }

            /// Shows `visit` one object, if it is in a list that `N` has need of.
            pub fn one<N: Needs>(&self, object: Object, visit: &mut impl Visit<S>) -> ControlFlow<()> {
                match object {
                    $(Object::$Kind(i) if N::$NEED => {
                        visit.run(object, self.$list.get(index(i)).map_or(&[], core::slice::from_ref))
                    })+
                    _ => ControlFlow::Continue(()),
                }
            }

            /// Returns the surface point where a ray met an object at the distance `t`, and how the object looks; nothing for
            /// floor, lamps and what is not there.
            pub fn point<N: Needs>(
                &self,
                object: Object,
                ray: &Ray<S>,
                t: S,
            ) -> Option<(SurfacePoint<S>, Look<'a, S>)> {
                match object {
                    $(Object::$Kind(i) if N::$NEED => {
                        self.$list.get(index(i)).map(|object| (object.point::<N>(ray, t), object.look()))
                    })+
                    _ => None,
                }
            }

            /// Returns how an object looks; nothing for floor, lamps and what is not there.
            pub fn look<N: Needs>(&self, object: Object) -> Option<Look<'a, S>> {
                match object {
                    $(Object::$Kind(i) if N::$NEED => self.$list.get(index(i)).map(Primitive::look),)+
                    _ => None,
                }
            }

            /// Calls `see` with each object of the lists, in order.
            pub fn looks(&self, mut see: impl FnMut(Object, Look<'a, S>)) {
                $((0..).zip(self.$list).for_each(|(i, object)| see(Object::$Kind(i), object.look()));)+
            }

            /// Whether there is an object in a list.
            pub const fn has_objects(&self) -> bool {
                $(!self.$list.is_empty())||+
            }

            /// Notes which shapes the scene has.
            pub(crate) fn note_shapes(&self, used: &mut Used) {
                $(used.$list = !self.$list.is_empty();
                self.$list.iter().for_each(|object| object.note_needs(used));)+
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
}

/// The nearest hit of a ray.
#[derive(Clone, Copy, Debug)]
pub struct Hit<S> {
    /// Distance as the search found it.
    pub distance: S,
    /// What was hit.
    pub object: Object,
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
    /// Returns the radiance that comes from a direction.
    pub fn radiance<N: Needs>(&self, direction: UnitVec3<S>) -> Rgb<S::Light> {
        // A sum of parts of one colour would be rounded.
        if !N::SKY_GRADIENT || self.horizon == self.zenith {
            return self.horizon;
        }
        let high = direction.z().times(direction.z());
        let low = S::Unit::ONE - high;
        self.horizon.zip(self.zenith, |horizon, zenith| horizon.times(low).plus(zenith.times(high)))
    }
}

impl<S: Scalar> Scene<'_, S> {
    /// An empty plain under a blue sky, by day.
    pub fn day() -> Self {
        let unit = |n| S::Unit::ratio(n, 100);
        let light = |r, g, b| Rgb::new(unit(r), unit(g), unit(b)).map(|part| S::Light::WHITE.times(part));
        let sky = Sky { horizon: light(75, 82, 95), zenith: light(10, 22, 60) };
        let floor = Floor {
            colors: [Rgb::new(unit(85), unit(85), unit(80)), Rgb::new(unit(15), unit(17), unit(25))],
        };
        Scene { floor: Some(floor), ..Scene::empty(sky, light(30, 30, 32)) }
    }
}

/// A number in a list as an index; of one that is too large for the machine, an index beyond all lists.
pub(crate) fn index(number: u32) -> usize {
    usize::try_from(number).unwrap_or(usize::MAX)
}
