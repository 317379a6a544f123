//! An illumination model with the options that a scene gives it.
//!
//! An option is of one of three kinds: it chooses a type of the core (how facets are distributed, say), it is a parameter of the model, or
//! it is what the model takes a material for that does not say it itself.

use std::borrow::Cow;

use rta_core::Scalar;
use rta_core::illumination::table::{Exact, Kind, Tabled, Value};
use rta_core::illumination::{
    BlinnFull, BlinnFullRow, Bouknight, ByGauss, ByPower, ByTrowbridge, CookTorrance, Facets, Grooves,
    HallGreenberg, Hidden, Published, Romney, Slopes,
};

use super::{Narrow, exponent};
use crate::description::{Description, Edge, Material, ModelOption};
use crate::model::Model;

/// The options that a scene gives to the model that it is made for.
#[derive(Clone, Debug, Default)]
pub struct Options {
    model: Option<Model>,
    options: Vec<ModelOption>,
}

/// The source text that makes a model. Names in it begin with `::`, and `Number` is the number format.
pub(crate) struct Source<S: Scalar> {
    /// An expression, or a function.
    pub(crate) text: String,
    /// The argument of the function.
    pub(crate) argument: Option<Value<S>>,
}

impl<S: Scalar> Source<S> {
    fn of(name: &str, argument: Option<Value<S>>) -> Self {
        Self { text: path(name), argument }
    }
}

/// Something that is done with a model in the numbers `S`.
pub(crate) trait Visitor<S: Narrow> {
    /// What comes of it.
    type Output;
    /// Does it; `source` makes the model.
    fn visit<M: Tabled<S> + 'static>(self, model: M, source: Source<S>) -> Self::Output;
}

/// Returns the path of a name among the core's illumination models.
fn path(name: &str) -> String {
    format!("::rta_core::illumination::{name}")
}

impl Options {
    /// Returns the options of a scene.
    #[must_use]
    pub fn of(scene: &Description) -> Self {
        Self { model: Some(scene.model), options: scene.settings.model_options.clone() }
    }

    /// Returns the numbers of an option of a model, if it is given.
    pub(super) fn numbers(&self, model: Model, name: &str) -> Option<&[f64]> {
        let own = self.options.iter().filter(|_| self.model == Some(model));
        own.into_iter().find(|option| option.name == name).map(|option| option.numbers.as_slice())
    }

    /// Returns the number of an option of a model, if it is given with one.
    pub(super) fn number(&self, model: Model, name: &str) -> Option<f64> {
        self.numbers(model, name)?.first().copied()
    }

    /// Does something with a model as the options have it.
    pub(crate) fn with_model<S: Narrow, V: Visitor<S>>(&self, model: Model, visitor: V) -> V::Output {
        let has = |name| self.numbers(model, name).is_some();
        match model {
            Model::Bouknight if has("mach") || has("p") => {
                let mach = || 1.0 + 0.5_f64.powf(self.number(model, "mach").unwrap_or(2.0));
                let p = exponent(self.number(model, "p").unwrap_or_else(mach));
                let source = Source::of("Bouknight::with_exponent", Some(Value::Exponent(p)));
                visitor.visit(Bouknight::with_exponent(p), source)
            }
            Model::Romney if has("p") => {
                let p = exponent(self.number(model, "p").unwrap_or(2.0));
                let source = Source::of("Romney::with_exponent", Some(Value::Exponent(p)));
                visitor.visit(Romney::with_exponent(p), source)
            }
            Model::BlinnFull => {
                let default = BlinnFullRow::default();
                let number = |name| self.number(model, name);
                let plain = BlinnFullRow {
                    exponent: number("power").map_or(default.exponent, exponent),
                    narrowness: number("gauss").map_or(default.narrowness, <S as Narrow>::power),
                    roundness: number("trowbridge").map_or(default.roundness, S::unit),
                    ..default
                };
                if has("power") {
                    faceted((ByPower, "ByPower"), plain, visitor)
                } else if has("gauss") {
                    faceted((ByGauss, "ByGauss"), plain, visitor)
                } else {
                    faceted((ByTrowbridge, "ByTrowbridge"), plain, visitor)
                }
            }
            Model::CookTorrance => {
                let (exact, slopes, grooves) = (has("exact"), path("Slopes"), path("Grooves"));
                let published = |hidden| format!("{}({hidden})", path("Published"));
                match (has("sancer"), has("published")) {
                    (false, false) => hiding(exact, (Grooves, grooves), visitor),
                    (true, false) => hiding(exact, (Slopes, slopes), visitor),
                    (false, true) => hiding(exact, (Published(Grooves), published(grooves)), visitor),
                    (true, true) => hiding(exact, (Published(Slopes), published(slopes)), visitor),
                }
            }
            Model::HallGreenberg if has("cutoff") => {
                let cutoff = S::unit(self.number(model, "cutoff").unwrap_or(0.0));
                let source = Source::of("HallGreenberg::with_cutoff", Some(Value::Unit(cutoff)));
                visitor.visit(HallGreenberg::with_cutoff(cutoff), source)
            }
            _ => in_model!(model, core => {
                visitor.visit(core, Source::of(&format!("{}::default()", model.type_name()), None))
            }),
        }
    }

    /// Returns the rows that a model needs of materials, in their order. `core` is the core's model of `model`.
    pub(crate) fn rows<S: Narrow, M: Tabled<S>>(
        &self,
        model: Model,
        core: &M,
        said: &[Material],
    ) -> Vec<M::Row> {
        said.iter().map(|material| core.row(&*self.said(model, material))).collect()
    }

    /// Returns a material as a model takes it: what it does not say is as the options have it.
    #[must_use]
    pub fn said<'m>(&self, model: Model, material: &'m Material) -> Cow<'m, Material> {
        let number = |name| self.number(model, name);
        let gloss = number("gloss");
        let has_facets = material.kind != Kind::Opaque || material.specular.is_some_and(|share| share > 0.0);
        let mirror = number("mirror").filter(|_| has_facets && material.kind != Kind::Mirror);
        let transmitted = material.coefficients().map_or(0.0, |own| own.kt.min(1.0));
        let edge = self.numbers(model, "edge").filter(|_| transmitted > 0.0).map(|numbers| Edge {
            exponent: numbers.first().map_or(2, |n| if *n < 2.0 { 1 } else { 2 + u8::from(*n >= 3.0) }),
            least: numbers.get(1).copied().unwrap_or(0.0),
            most: numbers.get(2).copied().unwrap_or(transmitted),
        });
        if gloss.is_none() && mirror.is_none() && edge.is_none() {
            return Cow::Borrowed(material);
        }
        Cow::Owned(Material {
            gloss: material.gloss.or(gloss),
            mirror: material.mirror.or(mirror),
            edge: material.edge.or(edge),
            ..material.clone()
        })
    }
}

/// Does something with Blinn's model whose facets are distributed so. What `plain` says is in the rows.
fn faceted<S: Narrow, V: Visitor<S>, D: Facets<S> + 'static>(
    (distribution, name): (D, &str),
    plain: BlinnFullRow<S>,
    visitor: V,
) -> V::Output {
    let source = Source::of(&format!("BlinnFull::with_facets({})", path(name)), None);
    visitor.visit(BlinnFull { plain, ..BlinnFull::with_facets(distribution) }, source)
}

/// Does something with the model of Cook and Torrance whose facets hide each other so and reflect exactly, or by an approximation.
fn hiding<S: Narrow, V: Visitor<S>, G: Hidden<S::Unit> + 'static>(
    exact: bool,
    (hidden, name): (G, String),
    visitor: V,
) -> V::Output {
    let reflection = path(if exact { "table::Exact" } else { "table::Reflection" });
    let text = format!("CookTorrance::<Number, _, {reflection}<Number>>::with_hidden({name})");
    let source = Source::of(&text, None);
    if exact {
        visitor.visit(CookTorrance::<S, G, Exact<S>>::with_hidden(hidden), source)
    } else {
        visitor.visit(CookTorrance::<S, G>::with_hidden(hidden), source)
    }
}
