//! An illumination model behind a pointer, so that one tracer serves all models that do not need one of their own.
//!
//! A tracer is some 100 KiB of code in each number format. The models whose pictures are drawn most have one of their own; what
//! the others pay for sharing one is a call through a pointer for each of their decisions.

use std::sync::Arc;

use rta_core::Scalar;
use rta_core::accelerator::Accelerator;
use rta_core::color::Rgb;
use rta_core::illumination::air::Through;
use rta_core::illumination::table::Tabled;
use rta_core::illumination::{Illumination, Passage, Secondary, Way};
use rta_core::light::Incident;
use rta_core::needs::{Everything, Needs};
use rta_core::range::Admitted;
use rta_core::scalar::Unit;
use rta_core::surface::Surface;
use rta_core::trace::decision::direct;
use rta_core::vector::Vec3;

use crate::description::{Air, Material};
use crate::model::Model;
use crate::narrow::air::{Layers, layers};
use crate::narrow::variant::{Options, Source, Visitor};
use crate::narrow::{Narrow, Narrowed};

/// Returns the part of the light of a lamp that reaches a place: see [`Illumination::along`].
type Lit<'a, S> = &'a mut dyn FnMut(Vec3<S>, usize) -> <S as Scalar>::Unit;

/// The methods of an illumination model for [`Everything`], with weights of three registers.
trait Shading<S: Scalar>: Send + Sync {
    fn ambient(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light>;
    fn is_lit(&self, surface: &Surface<S>) -> bool;
    fn direct(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light>;
    fn cutoff(&self) -> S::Unit;
    fn secondary(&self, surface: &Surface<S>) -> Secondary<Rgb<S::Unit>>;
    fn along(&self, way: &Way<S>, lit: Lit<S>) -> Option<Passage<S, Rgb<S::Unit>>>;
}

/// A model and the rows that it needs of a scene's materials.
struct Owned<S: Scalar, M: Tabled<S>> {
    model: M,
    rows: Vec<M::Row>,
}

impl<S: Scalar, M: Tabled<S>> Shading<S> for Owned<S, M> {
    fn ambient(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        self.model.over(&self.rows).ambient::<Everything>(surface, ambient)
    }

    fn is_lit(&self, surface: &Surface<S>) -> bool {
        self.model.over(&self.rows).is_lit::<Everything>(surface)
    }

    fn direct(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light> {
        direct::<S, _, Everything>(&self.model.over(&self.rows), surface, incident)
    }

    fn cutoff(&self) -> S::Unit {
        self.model.cutoff()
    }

    fn secondary(&self, surface: &Surface<S>) -> Secondary<Rgb<S::Unit>> {
        self.model.over(&self.rows).secondary::<Everything>(surface).registers()
    }

    fn along(&self, way: &Way<S>, lit: Lit<S>) -> Option<Passage<S, Rgb<S::Unit>>> {
        self.model.over(&self.rows).along::<Everything>(way, lit).map(Passage::registers)
    }
}

/// Any illumination model with the rows that it needs of a scene's materials.
#[derive(Clone)]
pub struct Shaded<S: Scalar>(Arc<dyn Shading<S>>);

/// Any illumination model with any air, ready for one scene.
pub type AnyModel<S> = Through<Shaded<S>, Layers<S>>;

/// Returns a model and the air of a scene, ready to be traced.
pub fn any_model<S: Narrow, A: Accelerator<S>>(
    model: Model,
    air: &Air,
    scene: &Narrowed<S>,
    admitted: &Admitted<'_, S, A>,
) -> AnyModel<S> {
    let middle = middle(scene, admitted);
    let air = layers(air, (middle, model.is_attenuated()), &scene.sky, scene.ambient);
    Through { model: shaded(model, middle, &scene.said, &scene.options), air }
}

/// Returns the length of the ray in the middle of the picture, 1 if it meets nothing.
pub fn middle<S: Narrow, A: Accelerator<S>>(scene: &Narrowed<S>, admitted: &Admitted<'_, S, A>) -> S {
    let (camera, middle) = (&scene.camera, S::Unit::ZERO);
    let ray = admitted.ray::<Everything>(camera.eye, camera.direction(middle, middle));
    admitted.closest::<Everything>(&ray).map_or_else(|| S::length(1.0), |hit| hit.distance)
}

/// Returns a model with its options and its rows of materials, for a picture in whose middle a ray is so long.
pub(crate) fn shaded<S: Narrow>(model: Model, middle: S, said: &[Material], options: &Options) -> Shaded<S> {
    options.with_model(model, Chosen { model, middle, said, options })
}

/// A model that is to be made ready.
struct Chosen<'a, S> {
    model: Model,
    middle: S,
    said: &'a [Material],
    options: &'a Options,
}

impl<S: Narrow> Visitor<S> for Chosen<'_, S> {
    type Output = Shaded<S>;

    fn visit<M: Tabled<S> + 'static>(self, model: M, _source: Source<S>) -> Shaded<S> {
        let model = model.focused(self.middle);
        let rows = self.options.rows(self.model, &model, self.said);
        Shaded(Arc::new(Owned { model, rows }))
    }
}

impl<S: Scalar> Illumination<S> for Shaded<S> {
    type Weight = Rgb<S::Unit>;
    /// The model itself is asked, and returns black.
    const BOTH_SIDES: bool = true;
    const ALONG: bool = true;

    fn ambient<N: Needs>(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        self.0.ambient(surface, ambient)
    }

    fn is_lit<N: Needs>(&self, surface: &Surface<S>) -> bool {
        self.0.is_lit(surface)
    }

    fn direct<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light> {
        self.0.direct(surface, incident)
    }

    fn cutoff(&self) -> S::Unit {
        self.0.cutoff()
    }

    fn secondary<N: Needs>(&self, surface: &Surface<S>) -> Secondary<Rgb<S::Unit>> {
        self.0.secondary(surface)
    }

    fn along<N: Needs>(
        &self,
        way: &Way<S>,
        mut lit: impl FnMut(Vec3<S>, usize) -> S::Unit,
    ) -> Option<Passage<S, Rgb<S::Unit>>> {
        self.0.along(way, &mut lit)
    }
}
