#![doc = include_str!("../README.md")]
//!
//! # Numbers as a type
//!
//! Everything is generic over a [`Scalar`]: the number type of a length. `f32` and (with the feature `f64`) `f64` are
//! scalars; so are [`Q16`] and [`Q20`], fixed point that draws the same bytes on every processor.
//!
//! # The way of one pixel
//!
//! | step | where |
//! | --- | --- |
//! | [`raster::Pixels`] picks the pixel and the places of its samples | `raster.rs`, `raster/places.rs` |
//! | [`camera::Camera`] makes the primary ray | `camera.rs` |
//! | [`trace::Tracer`] takes the next pending ray, decides whether a lamp needs a shadow ray, pushes the secondary rays | `trace.rs`, `trace/decision.rs` |
//! | the [`accelerator::Accelerator`] finds the nearest hit (for rays from the eye a [`zbuffer::ZBuffer`] can do so), and for a shadow ray the part of the lamp's light that arrives | `accelerator.rs`, `accelerator/*.rs` |
//! | [`scene::Scene`] enumerates its lists; each [`shape::Primitive`] computes where a ray meets it | `scene.rs`, `shape/*.rs` |
//! | [`world::World`] turns the hit into what is seen: a [`surface::Surface`], the sky, a lamp | `world.rs`, `surface.rs` |
//! | the [`illumination::Illumination`] model computes the light that the point sends back, and the weights of the secondary rays | `illumination/*.rs` |
//! | [`light::Incident`] is one lamp as seen from that point: direction, distance, irradiance | `light.rs` |
//! | [`color`] rounds the pixel's light to the levels of a display | `color.rs` |
//!
//! # Extend it
//!
//! Primitives, illumination models and accelerators are traits. Three programs in `tests/examples/` add one of each from outside,
//! and say which one line puts it into the core: `new_primitive.rs`, `new_model.rs`, `new_accelerator.rs`.
//!
//! `examples/ball.rs` sends a picture through a port, as text.
#![no_std]
#![forbid(unsafe_code)]

pub mod accelerator;
pub mod camera;
pub mod color;
mod error;
pub mod illumination;
pub mod light;
pub mod material;
pub mod needs;
mod quantity;
pub mod radiosity;
pub mod range;
pub mod raster;
pub mod ray;
pub mod sampling;
pub mod scalar;
pub mod scene;
pub mod shape;
pub mod surface;
pub mod texture;
pub mod trace;
pub mod world;
pub mod zbuffer;

pub use error::Error;
pub use scalar::{Q16, Q20, Scalar, vector};

/// The types that a program needs to draw a picture, for one `use`.
pub mod prelude {
    pub use crate::accelerator::{Accelerator, Bvh, Lists};
    pub use crate::camera::{Camera, Lens};
    pub use crate::color::Rgb;
    pub use crate::illumination::{Illumination, Phong, Rta, Whitted};
    pub use crate::light::Lamp;
    pub use crate::material::Material;
    pub use crate::needs::{Everything, Needs};
    pub use crate::raster::{Pixels, Places, Raster};
    pub use crate::sampling::Sampling;
    pub use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3, Vector, Xyz};
    pub use crate::scalar::{Light, Scalar, Unit};
    pub use crate::scene::{Scene, Sky};
    pub use crate::shape::*;
    pub use crate::trace::Tracer;
}
