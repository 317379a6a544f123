//! The Z-buffer for the rays from the eye (E. Catmull, "A Subdivision Algorithm for Computer Display of Curved Surfaces", University of
//! Utah, 1974), one row of the picture at a time; all other rays are traced (H. Weghorst, G. Hooper and D. Greenberg, "Improved
//! Computational Methods for Ray Tracing", ACM TOG 3, 1984, which keeps numbers of objects for it in the same way).
//!
//! Where a ray tracer goes through all objects at each pixel, this goes through the pixels of each object: those columns of the row that the
//! object's bounding sphere reaches. Each pixel keeps how far the nearest object so far is, and its number: [`ZBuffer`] takes
//! 8 bytes a column in fixed point and `f32`, and nothing for the whole picture.
//!
//! Depth is the distance along the pixel's ray as the object's own [`Primitive::intersect`](crate::shape::Primitive::intersect) finds it, so the picture is that of the
//! [`Tracer`] to the last bit. Where flat objects lie at one place, so that roundings would decide, the ray is traced.

mod columns;
mod row;
mod told;

pub use row::Row;
pub use told::Told;

use crate::accelerator::{Accelerator, Lists};
use crate::camera::Camera;
use crate::color::Rgb;
use crate::error::Error;
use crate::illumination::Illumination;
use crate::needs::Needs;
use crate::range::Admitted;
use crate::raster::{Center, Places, Raster};
use crate::scalar::Scalar;
use crate::scalar::vector::{UnitVec3, Vec3};
use crate::scene::index;
use crate::trace::dice::Sample;
use crate::trace::{Observer, Trace, Tracer};

/// A tracer whose rays from the eye are found by a Z-buffer of one row of at most `WIDTH` pixels, for pictures of one sample in the middle of
/// each pixel. Rays of other samples are traced.
///
/// ```
/// use rta_core::prelude::*;
/// use rta_core::zbuffer::{Told, ZBuffer};
///
/// let camera = Camera::<f32>::new(Vec3::<f32>::new(0.0, -6.0, 2.0),
///     UnitVec3::<f32>::new(0.0, 0.9, -0.2), Lens::new(1, 1, (4, 3)));
/// let balls = [Sphere::new(Vec3::<f32>::new(0.0, 0.0, 1.0), 1.0, Rgb::new(0.9, 0.5, 0.2), 0)];
/// let scene = Scene { spheres: &balls, materials: &[Material::Opaque], ..Scene::day() }.admit(&camera)?;
/// let raster = Raster::new(64, 48)?;
///
/// let told = Told::of(&scene);
/// let buffer = ZBuffer::<f32, _, Everything, 5, 64>::new(&told, Rta, 5, raster)?;
/// let traced = Tracer::<f32, _, Everything, 5>::new(&scene, Rta, 5)?;
/// assert!(Pixels::new(&buffer, &camera, raster).eq(Pixels::new(&traced, &camera, raster)));
/// # Ok::<(), rta_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ZBuffer<'a, S: Scalar, M, N, const STACK: usize, const WIDTH: usize, A = Lists> {
    tracer: Tracer<'a, S, M, N, STACK, Told<A>>,
    raster: Raster,
}

impl<'a, S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize, const WIDTH: usize, A: Accelerator<S>>
    ZBuffer<'a, S, M, N, STACK, WIDTH, A>
{
    /// Returns a Z-buffer for the pictures of a raster, whose rays are followed through `depth` reflections and refractions.
    ///
    /// # Errors
    /// Those of [`Tracer::new`], and [`Error::Raster`] for a row of more than `WIDTH` pixels.
    pub fn new(
        scene: &'a Admitted<'a, S, Told<A>>,
        model: M,
        depth: u32,
        raster: Raster,
    ) -> Result<Self, Error> {
        if index(raster.width()) > WIDTH {
            return Err(Error::Raster { width: raster.width(), height: raster.height() });
        }
        Ok(Self { tracer: Tracer::new(scene, model, depth)?, raster })
    }
}

impl<S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize, const WIDTH: usize, A: Accelerator<S>>
    Trace<S> for ZBuffer<'_, S, M, N, STACK, WIDTH, A>
{
    type Memory = Row<S, A::Memory, WIDTH>;
    const SPREADS: bool = true;

    fn trace<O: Observer<S> + ?Sized>(
        &self,
        origin: Vec3<S>,
        direction: UnitVec3<S>,
        memory: &mut Self::Memory,
        observer: &mut O,
    ) -> Rgb<S::Light> {
        self.tracer.trace(origin, direction, &mut memory.traced, observer)
    }

    fn sample<O: Observer<S> + ?Sized>(
        &self,
        camera: &Camera<S>,
        (right, up): (S::Unit, S::Unit),
        Sample { x, y, .. }: Sample,
        memory: &mut Self::Memory,
        observer: &mut O,
    ) -> Rgb<S::Light> {
        let row = Center.row(self.raster, y);
        if Center.place(self.raster, row, x, 0) == (right, up) {
            let (scene, ..) = self.tracer.parts();
            memory.fill::<N>(scene, camera, self.raster, y);
            memory.traced.next = memory.number(x);
        }
        self.trace(camera.eye, camera.direction(right, up), memory, observer)
    }
}
