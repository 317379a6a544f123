//! The secondary rays of a point.

mod rough;

use super::decision::{Branch, Start, branch, mirrored_sky, refract, secondary};
use super::dice::Dice;
use super::{Observer, Pending, Tracer, Waiting};
use crate::accelerator::Accelerator;
use crate::color::Rgb;
use crate::illumination::{Illumination, Secondary, Weight};
use crate::material::Glass;
use crate::needs::Needs;
use crate::scalar::Scalar;
use crate::scalar::vector::{LengthVector, UnitVector};
use crate::surface::Surface;

/// The rays that still wait, and the light that arrived.
type Sum<'t, S, W, T, const STACK: usize> =
    (&'t mut Waiting<S, W, T, STACK>, &'t mut Rgb<<S as Scalar>::Light>);

/// A ray that spawns others, the dice of its sample, and its node in the tree.
type Parent<'t, S, W, D> = (&'t Pending<S, W>, D, <D as Dice<S>>::Node);

/// A ray to be traced, and its node in the tree.
type Child<S, W, T> = Option<(Pending<S, W>, T)>;

impl<S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize, A: Accelerator<S>>
    Tracer<'_, S, M, N, STACK, A>
{
    /// Spawns the secondary rays of a surface: pushes the transmitted one and returns the reflected one, which is followed next. Adds to
    /// the light what the reflected one brings where it sees the sky alone.
    #[cfg_attr(not(target_os = "none"), inline(always))]
    pub fn spawn<D: Dice<S>, O: Observer<S> + ?Sized>(
        &self,
        surface: &Surface<S>,
        parent: Parent<S, M::Weight, D>,
        sum: Sum<S, M::Weight, D::Node, STACK>,
        observer: &mut O,
    ) -> Child<S, M::Weight, D::Node> {
        if !D::STILL
            && N::GLOSS
            && let (_, dice, node) = parent
            && let Some((roughness, words)) = dice.facet(surface.number, node)
        {
            let facets = dice.facets::<N>(surface.number, roughness);
            return self.spawn_rough(surface, (facets, words), parent, sum, observer);
        }
        if N::MESHES && surface.mesh.is_some() {
            return self.spawn_of_mesh(surface, parent, sum, observer);
        }
        self.spawn_by::<D, O, false>(surface, parent, sum, observer)
    }

    /// Spawns the secondary rays of a point of a mesh.
    #[inline(never)] // scenes without meshes do not pay for it
    fn spawn_of_mesh<D: Dice<S>, O: Observer<S> + ?Sized>(
        &self,
        surface: &Surface<S>,
        parent: Parent<S, M::Weight, D>,
        sum: Sum<S, M::Weight, D::Node, STACK>,
        observer: &mut O,
    ) -> Child<S, M::Weight, D::Node> {
        self.spawn_by::<D, O, true>(surface, parent, sum, observer)
    }

    /// Spawns the secondary rays of a surface that is a point of a mesh or not: two functions, so that all of the second is inlined.
    #[inline]
    fn spawn_by<D: Dice<S>, O: Observer<S> + ?Sized, const MESH: bool>(
        &self,
        surface: &Surface<S>,
        parent: Parent<S, M::Weight, D>,
        sum: Sum<S, M::Weight, D::Node, STACK>,
        observer: &mut O,
    ) -> Child<S, M::Weight, D::Node> {
        let secondary = if MESH {
            secondary::<S, M, N>(&self.model, surface)
        } else {
            self.model.secondary::<N>(surface)
        };
        self.spawn_about::<D, O>((surface, surface), secondary, parent, sum, observer)
    }

    /// Spawns the secondary rays of a surface with the weights `secondary`, reflected and refracted about the normal of `facet`: of the surface
    /// itself, or of one that has the normal of one of its facets.
    #[inline(always)] // not inlined, it costs a small machine 24 bytes of stack
    fn spawn_about<D: Dice<S>, O: Observer<S> + ?Sized>(
        &self,
        (surface, facet): (&Surface<S>, &Surface<S>),
        secondary: Secondary<M::Weight>,
        (parent, _, node): Parent<S, M::Weight, D>,
        (pending, light): Sum<S, M::Weight, D::Node, STACK>,
        observer: &mut O,
    ) -> Child<S, M::Weight, D::Node> {
        let start = |direction, leaves: bool| {
            let (side, direction) = (surface.side::<N>(), surface.fold::<N>(direction, leaves));
            let (origin, _) =
                surface.point.leave(if leaves { side } else { -side }, direction, surface.extent);
            Start { origin, direction }
        };
        let reflected = || start(surface.incoming.reflect(facet.normal), true);
        let mut is_total = false;
        let refracted = |glass: &Glass<S>| {
            let direction = refract(facet, glass);
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
            let node = D::child(node, branch.kind);
            (Pending { start, branch }, node)
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
