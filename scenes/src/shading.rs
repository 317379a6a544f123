//! An illumination model behind a pointer, so that one tracer serves all models that do not need one of their own.
//!
//! A tracer is some 100 KiB of code in each number format. The models whose pictures are drawn most have one of their own; what
//! the others pay for sharing one is a call through a pointer for each of their decisions.

use std::sync::Arc;

use rta_core::accelerator::{Accelerator, Lists};
use rta_core::color::Rgb;
use rta_core::illumination::air::Through;
use rta_core::illumination::table::Tabled;
use rta_core::illumination::{Illumination, Passage, Secondary, Way};
use rta_core::light::Incident;
use rta_core::material;
use rta_core::needs::{Everything, Needs};
use rta_core::range::Admitted;
use rta_core::scalar::Unit;
use rta_core::scene::Limits;
use rta_core::surface::Surface;
use rta_core::trace::decision::direct;
use rta_core::trace::{Spectrum, Tracer};
use rta_core::vector::Vec3;
use rta_core::{Error, Q16, Q20, Scalar};

use crate::description::{Air, Material};
use crate::model::Model;
use crate::narrow::air::{Layers, layers};
use crate::narrow::variant::{Options, Source, Visitor};
use crate::narrow::{Narrow, Narrowed, spectrum as narrow};

/// Returns the part of the light of a lamp that reaches a place: see [`Illumination::along`].
type Lit<'a, S> = &'a mut dyn FnMut(Vec3<S>, usize) -> <S as Scalar>::Unit;

/// The methods of an illumination model for [`Everything`], with weights of three registers.
trait Shading<S: Scalar>: Send + Sync {
    fn ambient(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light>;
    fn is_lit(&self, surface: &Surface<S>) -> bool;
    fn is_reached(&self, surface: &Surface<S>, incident: &Incident<S>) -> bool;
    fn direct(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light>;
    fn diffuse(&self, surface: &Surface<S>) -> Rgb<S::Unit>;
    fn fades(&self) -> bool;
    fn cutoff(&self) -> S::Unit;
    fn secondary(&self, surface: &Surface<S>) -> Secondary<Rgb<S::Unit>>;
    fn along(&self, way: &Way<S>, lit: Lit<S>) -> Option<Passage<S, Rgb<S::Unit>>>;
    /// Returns what the model draws of the materials of a scene, in the order of their numbers, as text: what prints alike is alike, as
    /// numbers print exactly.
    fn drawn(&self, materials: &[material::Material<S>]) -> Vec<String>;
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

    fn is_reached(&self, surface: &Surface<S>, incident: &Incident<S>) -> bool {
        self.model.over(&self.rows).is_reached::<Everything>(surface, incident)
    }

    fn direct(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light> {
        direct::<S, _, Everything>(&self.model.over(&self.rows), surface, incident)
    }

    fn diffuse(&self, surface: &Surface<S>) -> Rgb<S::Unit> {
        self.model.over(&self.rows).diffuse::<Everything>(surface)
    }

    fn fades(&self) -> bool {
        self.model.fades()
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

    fn drawn(&self, materials: &[material::Material<S>]) -> Vec<String> {
        let glass = |material: &material::Material<S>| {
            material.glass::<Everything>().filter(|_| M::REFRACTS).copied()
        };
        materials.iter().map(glass).zip(&self.rows).map(|drawn| format!("{drawn:?}")).collect()
    }
}

/// Any illumination model with the rows that it needs of a scene's materials.
#[derive(Clone)]
pub struct Shaded<S: Scalar>(Arc<dyn Shading<S>>);

/// Any illumination model with any air, ready for one scene.
pub type AnyModel<S> = Through<Shaded<S>, Layers<S>>;

/// A number format in which any model can be traced.
pub trait Shade: Narrow {
    /// Returns a model and the air of a scene with what is said of its materials at one wavelength, compiled once for each format.
    fn at_one(
        model: Model,
        air: &Air,
        scene: &Narrowed<Self>,
        limits: Limits<Self>,
        said: &[Material],
    ) -> AnyModel<Self> {
        at_one(model, air, scene, limits, said)
    }
}

macro_rules! formats {
    ($($f:ty)*) => {
        $(impl Shade for $f {
            // Here, for the crates above: they need not compile all models.
            #[inline(never)]
            fn at_one(
                model: Model,
                air: &Air,
                scene: &Narrowed<Self>,
                limits: Limits<Self>,
                said: &[Material],
            ) -> AnyModel<Self> {
                at_one(model, air, scene, limits, said)
            }
        })*
    };
}

formats!(f32 f64 Q16 Q20);

/// Returns a model and the air of a scene with these limits, ready to be traced.
pub fn any_model<S: Shade>(model: Model, air: &Air, scene: &Narrowed<S>, limits: Limits<S>) -> AnyModel<S> {
    S::at_one(model, air, scene, limits, &scene.said)
}

fn at_one<S: Narrow>(
    model: Model,
    air: &Air,
    scene: &Narrowed<S>,
    limits: Limits<S>,
    said: &[Material],
) -> AnyModel<S> {
    let middle = middle(scene, limits);
    let air = layers(air, (middle, model.is_attenuated()), &scene.sky, scene.ambient);
    Through { model: shaded(model, middle, said, &scene.options), air }
}

/// A model at each wavelength of a scene, ready to be traced.
#[derive(Clone)]
pub struct Wavelengths<S: Scalar> {
    /// Of the first.
    first: AnyModel<S>,
    /// Of the others.
    further: Vec<AnyModel<S>>,
    /// The numbers of the materials whose light depends on the wavelength.
    dispersive: Vec<u16>,
}

impl<S: Shade> Wavelengths<S> {
    /// Returns a model and the air of a scene with these limits at each wavelength; at one alone where nothing that the model draws
    /// depends on them.
    pub fn new(model: Model, air: &Air, scene: &Narrowed<S>, limits: Limits<S>) -> Self {
        let first = any_model(model, air, scene, limits);
        let mut all = Self { first, further: Vec::new(), dispersive: Vec::new() };
        let Some(narrow::Spectrum { further, .. }) = &scene.spectrum else { return all };
        let models = further.iter().map(|table| S::at_one(model, air, scene, limits, &table.said));
        let models: Vec<_> = models.collect();
        let drawn = all.first.model.0.drawn(&scene.materials);
        let others = models.iter().zip(further).map(|(own, table)| own.model.0.drawn(&table.materials));
        let others: Vec<_> = others.collect();
        let differs = |i: usize| others.iter().any(|other| other.get(i) != drawn.get(i));
        all.dispersive = (0..).zip(0..drawn.len()).filter(|(_, i)| differs(*i)).map(|(n, _)| n).collect();
        if all.is_dispersive() {
            all.further = models;
        }
        all
    }

    /// Returns the numbers of the materials whose light depends on the wavelength: none where the picture is that of one wavelength.
    #[must_use]
    pub fn dispersive(&self) -> &[u16] {
        &self.dispersive
    }

    /// Returns whether the picture is one of several wavelengths.
    #[must_use]
    pub fn is_dispersive(&self) -> bool {
        !self.dispersive.is_empty()
    }

    /// Returns the model at the first wavelength.
    #[must_use]
    pub fn into_first(self) -> AnyModel<S> {
        self.first
    }

    /// Calls `draw` with the tracers of all wavelengths, with rays of that depth and that cut-off, or the model's own.
    ///
    /// # Errors
    /// Those of [`Tracer::new`].
    pub fn with_tracer<N: Needs, const STACK: usize, A: Accelerator<S> + Copy, R>(
        &self,
        scene: &Narrowed<S>,
        admitted: &Admitted<'_, S, A>,
        (depth, cutoff): (u32, Option<S::Unit>),
        draw: impl FnOnce(&AnySpectrum<'_, S, N, STACK, A>) -> R,
    ) -> Result<R, Error> {
        let tracer = |scene, model: &AnyModel<S>| {
            let tracer = Tracer::new(scene, model.clone(), depth)?;
            Ok(if let Some(cutoff) = cutoff { tracer.with_cutoff(cutoff) } else { tracer })
        };
        let first = tracer(admitted, &self.first)?;
        let spectrum = scene.spectrum.as_ref().filter(|_| self.is_dispersive());
        // One wavelength has all of the light.
        let one = [Rgb::new(S::Unit::ONE, S::Unit::ONE, S::Unit::ONE)];
        let (weights, tables) =
            spectrum.map_or((&one[..], &[][..]), |spectrum| (&spectrum.weights, &spectrum.further));
        let scenes: Vec<_> = tables.iter().map(|table| admitted.with_materials(&table.materials)).collect();
        let further = scenes.iter().zip(&self.further).map(|(scene, model)| tracer(scene, model));
        let further = further.collect::<Result<Vec<_>, Error>>()?;
        Ok(draw(&Spectrum { weights, first, further: &further, dispersive: &self.dispersive }))
    }
}

/// The tracers of any illumination model at several wavelengths, or at one.
pub type AnySpectrum<'a, S, N, const STACK: usize, A> = Spectrum<'a, S, AnyModel<S>, N, STACK, A>;

/// Returns the length of the ray in the middle of the picture of a scene with these limits, 1 if it meets nothing.
pub(crate) fn middle<S: Narrow>(scene: &Narrowed<S>, limits: Limits<S>) -> S {
    let admitted = Admitted::baked(scene.scene(), limits, Lists);
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
    /// [`Illumination::is_reached`] tells.
    const BOTH_SIDES: bool = true;
    const ALONG: bool = true;

    fn ambient<N: Needs>(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        self.0.ambient(surface, ambient)
    }

    fn is_lit<N: Needs>(&self, surface: &Surface<S>) -> bool {
        self.0.is_lit(surface)
    }

    fn is_reached<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> bool {
        // Before what stands for a point of a mesh is asked, the point itself is; all else `direct` asks.
        surface.mesh.is_none() || self.0.is_reached(surface, incident)
    }

    fn direct<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light> {
        self.0.direct(surface, incident)
    }

    fn diffuse<N: Needs>(&self, surface: &Surface<S>) -> Rgb<S::Unit> {
        self.0.diffuse(surface)
    }

    fn fades(&self) -> bool {
        self.0.fades()
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
