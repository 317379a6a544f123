//! One row of the buffer, and how it is filled.

use core::marker::PhantomData;
use core::ops::ControlFlow;

use super::columns::Columns;
use super::told::Memory;
#[cfg(doc)]
use crate::accelerator::Closest;
use crate::accelerator::STEEPEST;
use crate::camera::Camera;
use crate::needs::Needs;
use crate::raster::Raster;
use crate::scalar::{Scalar, Unit};
use crate::scene::{Object, Visit, index};
use crate::shape::Primitive;
use crate::world::World;

/// A row of a picture: how far the nearest objects are, and which they are.
#[derive(Clone, Copy, Debug)]
pub struct Row<S, M, const WIDTH: usize> {
    /// What is kept for the rays that are traced.
    pub(super) traced: Memory<M>,
    /// Which row it is.
    y: Option<u32>,
    /// The distance of the nearest object in each column.
    nearest: [S; WIDTH],
    /// Its number, counted from 1 in the order of [`Scene::each`](crate::scene::Scene::each); 0 where there is none, or [`UNDECIDED`].
    numbers: [u32; WIDTH],
}

impl<S: Scalar, M: Default, const WIDTH: usize> Default for Row<S, M, WIDTH> {
    fn default() -> Self {
        Self { traced: Memory::default(), y: None, nearest: [S::FAR; WIDTH], numbers: [0; WIDTH] }
    }
}

impl<S: Scalar, M, const WIDTH: usize> Row<S, M, WIDTH> {
    /// Returns the number of the nearest object in a column, 0 for none; nothing where that is undecided.
    pub(super) fn number(&self, x: u32) -> Option<u32> {
        self.numbers.get(index(x)).copied().filter(|number| *number != UNDECIDED)
    }

    /// Makes this row `y` of a picture, if it is not yet.
    pub(super) fn fill<N: Needs>(&mut self, world: &World<S>, camera: &Camera<S>, raster: Raster, y: u32) {
        if self.y == Some(y) {
            return;
        }
        self.y = Some(y);
        self.nearest.fill(S::FAR);
        self.numbers.fill(0);
        let columns = Columns::new(camera, raster, y);
        let _ = world.scene.each::<N>(&mut Fill {
            row: self,
            needs: PhantomData::<fn() -> N>,
            world,
            columns,
            objects: 0,
        });
    }
}

/// The number of a pixel where several objects are as near as can be told; which of them is seen is for [`Closest`] to say.
pub(super) const UNDECIDED: u32 = u32::MAX;

/// Returns the distance from which on an object is surely behind one at the distance `near`: as [`Closest`] has it.
fn same_place<S: Scalar>(near: S) -> S {
    near.at_one_place(S::ZERO, S::Unit::ratio(1, STEEPEST))
}

/// Puts one object after the other into a row.
struct Fill<'r, S: Scalar, M, N, const WIDTH: usize> {
    row: &'r mut Row<S, M, WIDTH>,
    needs: PhantomData<fn() -> N>,
    world: &'r World<'r, S>,
    columns: Columns<'r, S>,
    /// How many have been put.
    objects: u32,
}

impl<S: Scalar, M, N: Needs, const WIDTH: usize> Visit<S> for Fill<'_, S, M, N, WIDTH> {
    fn run<P: Primitive<S>>(&mut self, _first: Object, run: &[P]) -> ControlFlow<()> {
        for object in run {
            // A list has fewer than 2^32 objects.
            self.objects = self.objects.saturating_add(1);
            let columns = if P::IS_FINITE { self.columns.of(&object.look()) } else { self.columns.all() };
            let range = index(columns.start)..index(columns.end);
            let nearest = self.row.nearest.get_mut(range.clone()).unwrap_or_default();
            let numbers = self.row.numbers.get_mut(range).unwrap_or_default();
            for (x, (nearest, number)) in columns.zip(nearest.iter_mut().zip(numbers)) {
                let ray = self.world.ray::<N>(self.columns.camera.eye, self.columns.direction(x));
                let end = if N::TRIANGLES || N::PLANES { same_place(*nearest) } else { *nearest };
                let Some(t) = object.intersect(&ray, end) else { continue };
                let (near, far) = if t < *nearest { (t, *nearest) } else { (*nearest, t) };
                if (N::TRIANGLES || N::PLANES) && far < same_place(near) {
                    *number = UNDECIDED;
                } else if t < *nearest {
                    *number = self.objects;
                }
                *nearest = near;
            }
        }
        ControlFlow::Continue(())
    }
}
