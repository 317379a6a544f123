//! The visitors that find the part of a lamp's light that reaches a surface.

use core::marker::PhantomData;
use core::ops::ControlFlow;

use heapless::Vec;

use super::{Accelerator, Lists};
use crate::needs::Needs;
use crate::ray::Ray;
use crate::scalar::{Scalar, Unit};
use crate::scene::{Object, Visit};
use crate::shape::Primitive;
use crate::world::World;

/// Room for the transparent objects in the way of a shadow ray. Where there are as many or more, which is rare, the scene is
/// searched again in the order of its lists.
const MANY: usize = 8;

/// Returns the part, 0 to 1, of the light that the candidates of an accelerator let through.
pub(super) fn through<S: Scalar, N: Needs, A: Accelerator<S>>(
    accelerator: &A,
    world: &World<'_, S>,
    ray: &Ray<S>,
    t_max: S,
) -> S::Unit {
    if A::IN_ORDER {
        let mut part = S::Unit::ONE;
        let filter = |_, kt: S::Unit| {
            part = part.times(kt);
            if part > S::Unit::ZERO { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        };
        let mut visitor = Through::<S, N, _> { world, ray, t_max, filter, needs: PhantomData };
        let is_hidden = accelerator.candidates::<N>(&world.scene, ray, &mut visitor).is_break();
        return if is_hidden { S::Unit::ZERO } else { part };
    }
    let mut filters = Filters::<S, MANY>::new();
    let filter = |object, kt| {
        filters.add(object, kt);
        ControlFlow::Continue(())
    };
    let mut visitor = Through::<S, N, _> { world, ray, t_max, filter, needs: PhantomData };
    if accelerator.candidates::<N>(&world.scene, ray, &mut visitor).is_break() {
        return S::Unit::ZERO;
    }
    filters.product().unwrap_or_else(|| through::<S, N, _>(&Lists, world, ray, t_max))
}

/// Visits the objects in the way of a shadow ray, and stops where none of its light is left: at an opaque object, or where
/// `filter` says so. It is called with each transparent object and the part that this lets through.
struct Through<'r, S: Scalar, N, F> {
    world: &'r World<'r, S>,
    ray: &'r Ray<S>,
    t_max: S,
    filter: F,
    needs: PhantomData<N>,
}

impl<S: Scalar, N: Needs, F: FnMut(Object, S::Unit) -> ControlFlow<()>> Visit<S> for Through<'_, S, N, F> {
    fn t_max(&self) -> S {
        self.t_max
    }

    fn run<P: Primitive<S>>(&mut self, first: Object, run: &[P]) -> ControlFlow<()> {
        for (i, primitive) in (0..).zip(run) {
            if primitive.intersect(self.ray, self.t_max).is_some() {
                match transmitted::<S, N>(self.world, primitive.look().material) {
                    Some(kt) => (self.filter)(first.after(i), kt)?,
                    None => return ControlFlow::Break(()),
                }
            }
        }
        ControlFlow::Continue(())
    }
}

/// Returns the part of a shadow ray's light that the material of that number lets through, 0 to 1; `None` where it casts a full
/// shadow.
pub fn transmitted<S: Scalar, N: Needs>(world: &World<'_, S>, material: u16) -> Option<S::Unit> {
    if N::TRANSPARENT_SHADOWS {
        world.scene.material(material).glass::<N>().map(|glass| glass.kt)
    } else {
        None
    }
}

/// The transparent objects in the way of a shadow ray, added in any order and sorted in order of [`Object`], on which the
/// rounding of their product depends. There is room for fewer than `MOST`.
pub struct Filters<S: Scalar, const MOST: usize>(Vec<(Object, S::Unit), MOST>);

impl<S: Scalar, const MOST: usize> Filters<S, MOST> {
    /// Returns an empty list.
    #[allow(clippy::new_without_default, reason = "one way is enough")]
    pub const fn new() -> Self {
        Self(Vec::new())
    }

    /// Returns whether no object was added.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Adds an object that lets the part `kt` through.
    pub fn add(&mut self, object: Object, kt: S::Unit) {
        // Once it is full, its content does not matter: `product` returns `None`.
        let _ = self.0.push((object, kt));
        let mut rest = self.0.as_mut_slice();
        while let [.., before, last] = rest
            && last.0 < before.0
        {
            core::mem::swap(before, last);
            let end = rest.len() - 1;
            rest = rest.get_mut(..end).unwrap_or_default();
        }
    }

    /// Returns the part of the light that passes all of them, 0 to 1; `None` if they were too many.
    pub fn product(&self) -> Option<S::Unit> {
        let part = self.0.iter().fold(S::Unit::ONE, |part, (_, kt)| part.times(*kt));
        (!self.0.is_full()).then_some(part)
    }
}
