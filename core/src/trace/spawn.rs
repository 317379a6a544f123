//! The secondary rays of a point.

use super::decision::{Branch, Start, branch, mirrored_sky, refract, secondary};
use super::{Observer, Pending, Stack, Tracer};
use crate::accelerator::Accelerator;
use crate::color::Rgb;
use crate::illumination::{Illumination, Weight};
use crate::material::Glass;
use crate::needs::Needs;
use crate::scalar::Scalar;
use crate::scalar::vector::{LengthVector, UnitVector};
use crate::surface::Surface;

/// The rays that still wait, and the light that arrived.
type Sum<'t, S, W, const STACK: usize> = (&'t mut Stack<S, W, STACK>, &'t mut Rgb<<S as Scalar>::Light>);

impl<S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize, A: Accelerator<S>>
    Tracer<'_, S, M, N, STACK, A>
{
    /// Spawns the secondary rays of a surface: pushes the transmitted one and returns the reflected one, which is followed next. Adds to
    /// the light what the reflected one brings where it sees the sky alone.
    #[cfg_attr(not(target_os = "none"), inline(always))]
    pub(super) fn spawn<O: Observer<S> + ?Sized>(
        &self,
        surface: &Surface<S>,
        parent: &Pending<S, M::Weight>,
        sum: Sum<S, M::Weight, STACK>,
        observer: &mut O,
    ) -> Option<Pending<S, M::Weight>> {
        if N::MESHES && surface.mesh.is_some() {
            return self.spawn_of_mesh(surface, parent, sum, observer);
        }
        self.spawn_by::<O, false>(surface, parent, sum, observer)
    }

    /// Spawns the secondary rays of a point of a mesh.
    #[inline(never)] // scenes without meshes do not pay for it
    fn spawn_of_mesh<O: Observer<S> + ?Sized>(
        &self,
        surface: &Surface<S>,
        parent: &Pending<S, M::Weight>,
        sum: Sum<S, M::Weight, STACK>,
        observer: &mut O,
    ) -> Option<Pending<S, M::Weight>> {
        self.spawn_by::<O, true>(surface, parent, sum, observer)
    }

    /// Spawns the secondary rays of a surface that is a point of a mesh or not: two functions, so that all of the second is inlined.
    #[cfg_attr(not(target_os = "none"), inline(always))]
    fn spawn_by<O: Observer<S> + ?Sized, const MESH: bool>(
        &self,
        surface: &Surface<S>,
        parent: &Pending<S, M::Weight>,
        (pending, light): Sum<S, M::Weight, STACK>,
        observer: &mut O,
    ) -> Option<Pending<S, M::Weight>> {
        let secondary = if MESH {
            secondary::<S, M, N>(&self.model, surface)
        } else {
            self.model.secondary::<N>(surface)
        };
        let start = |direction, leaves: bool| {
            let (side, direction) = (surface.side::<N>(), surface.fold::<N>(direction, leaves));
            let (origin, _) =
                surface.point.leave(if leaves { side } else { -side }, direction, surface.extent);
            Start { origin, direction }
        };
        let reflected = || start(surface.incoming.reflect(surface.normal), true);
        let mut is_total = false;
        let refracted = |glass: &Glass<S>| {
            let direction = refract(surface, glass);
            is_total = direction.is_none();
            direction.map(|direction| start(direction, false))
        };
        let place = (&parent.branch, self.cutoff);
        let straight = || start(surface.incoming, false);
        let [transmitted, reflected] =
            branch::<S, M::Weight, N>(secondary, surface, place, reflected, refracted, straight);
        if is_total {
            observer.total_reflection();
        }
        let mut told = |(branch, start): (Branch<M::Weight>, Start<S>)| {
            observer.spawned(&|cutoff| !branch.weight.is_below(cutoff));
            Pending { start, branch }
        };
        if N::GLASS
            && let Some(transmitted) = transmitted
        {
            // There is room: at most one ray waits for each level, and there are no more than STACK.
            let pushed = pending.push(told(transmitted));
            debug_assert!(pushed.is_ok(), "the ray stack is one entry for each level of depth");
        }
        if N::SURROUNDINGS && surface.surroundings {
            if let Some((branch, start)) = reflected {
                let sky = mirrored_sky::<S, _, N>(&self.scene.scene, branch.weight, start.direction);
                observer.light(sky);
                *light = light.plus(sky);
            }
            return None;
        }
        reflected.map(told)
    }
}
