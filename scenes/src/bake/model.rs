//! The source of a baked scene's illumination model: its rows of the scene's materials, and the air around it.

use core::fmt::{self, Write};

use rta_core::color::Rgb;
use rta_core::illumination::air::{Distance, Fog, Haze, Medium};
use rta_core::illumination::fresnel::Conductor;
use rta_core::illumination::microfacet::Roughness;
use rta_core::illumination::table::{Exact, MOST_SLOPES, PositiveOf, Reflection, Row, Tabled, Value};
use rta_core::scalar::Unit;

use super::Model;
use super::literal::{Literal, color, length, light, unit};
use super::module::{ALLOW, exponent, write_names};
use crate::description::{Air, Material};
use crate::narrow::Narrowed;
use crate::narrow::air::{Layer, layers};
use crate::narrow::variant::{Source, Visitor};

const PATH: &str = "::rta_core::illumination";

/// Writes the functions `models` and `model`, which return the model for the scene at each of its wavelengths and at the first; `middle`
/// is the length of the ray in the middle of the picture, and `spectrum` whether the picture is one of several wavelengths.
pub(super) fn write<S: Literal>(
    out: &mut impl Write,
    scene: &Narrowed<S>,
    (model, air): (Model, &Air),
    (middle, spectrum): (S, bool),
) -> fmt::Result {
    let further = scene.spectrum.iter().filter(|_| spectrum).flat_map(|spectrum| &spectrum.further);
    let said: Vec<_> = core::iter::once(&scene.said).chain(further.map(|table| &table.said)).collect();
    let shading = "impl ::rta_core::illumination::Illumination<Number> + Copy";
    writeln!(out, "\n/// Returns the illumination model `{model}` for this scene.\n{ALLOW}")?;
    writeln!(out, "pub fn model() -> {shading} {{\n    let [first, ..] = models();\n    first\n}}")?;
    writeln!(out, "\n/// Returns the illumination model at each wavelength.\n{ALLOW}")?;
    writeln!(out, "pub fn models() -> [{shading}; {}] {{", said.len())?;
    write_names(out, S::CONSTRUCTORS)?;
    writeln!(out, "    use ::rta_core::illumination::table::Tabled;")?;
    let (fading, medium) = layers(air, (middle, model.is_attenuated()), &scene.sky, scene.ambient);
    let airs =
        [fading.as_ref().map(fading_of::<S>), medium.as_ref().map(medium_of::<S>)].into_iter().flatten();
    let airs: Vec<_> = airs.collect();
    writeln!(out, "    [")?;
    for said in said {
        let ready = scene.options.with_model(model, Baked { model, middle, scene, said });
        let ready = airs.iter().fold(ready, |model, air| {
            format!("{PATH}::air::Through {{ model: {model}, air: {PATH}::air::{air} }}")
        });
        writeln!(out, "        {ready},")?;
    }
    writeln!(out, "    ]\n}}")
}

/// A model that is to be written for a scene, with the length of the ray in the middle of the picture.
struct Baked<'a, S: Literal> {
    model: Model,
    middle: S,
    scene: &'a Narrowed<S>,
    said: &'a [Material],
}

impl<S: Literal> Visitor<S> for Baked<'_, S> {
    type Output = String;

    /// Returns an expression of the model over its rows.
    fn visit<M: Tabled<S> + 'static>(self, model: M, Source { text, argument }: Source<S>) -> String {
        let argument = argument.map_or_else(String::new, |value| format!("({})", literal(value)));
        let focused = format!("Tabled::<Number>::focused({text}{argument}, {})", length(self.middle));
        let rows = if M::Row::NAME.is_empty() {
            Vec::new()
        } else {
            self.scene.options.rows(self.model, &model, self.said)
        };
        let rows: Vec<_> = rows.iter().map(row).collect();
        format!("Tabled::<Number>::over(&{focused}, const {{ &[{}] }})", rows.join(", "))
    }
}

fn row<S: Literal, R: Row<S>>(row: &R) -> String {
    let mut fields = Vec::new();
    row.fields(|name, value| fields.push(format!("{name}: {}", literal(value))));
    format!("\n        {PATH}::{} {{ {} }}", R::NAME, fields.join(", "))
}

fn literal<S: Literal>(value: Value<S>) -> String {
    match value {
        Value::Unit(value) => unit::<S>(value),
        Value::Positive(value) => positive::<S>(value),
        Value::Exponent(value) => exponent(value),
        Value::Color(value) => color::<S>(value),
        Value::Positives(value) => positives::<S>(value),
        Value::Flag(value) => value.to_string(),
        Value::Reflection(value) => reflection(value),
        Value::Exact(Exact { metal, plain }) => {
            let metal = metal.map_or_else(
                || "None".into(),
                |Rgb { r, g, b }| format!("Some(Rgb::new({}))", [r, g, b].map(conductor::<S>).join(", ")),
            );
            format!("{PATH}::table::Exact {{ metal: {metal}, plain: {} }}", reflection(plain))
        }
        Value::Slopes(own) => slopes::<S>(own),
    }
}

/// Returns the expression of the slopes of a material.
pub(super) fn slopes<S: Literal>(slopes: [Roughness<S::Unit>; MOST_SLOPES]) -> String {
    let slope = |Roughness { share, inverse }| {
        let (share, inverse) = (unit::<S>(share), positive::<S>(inverse));
        format!("{PATH}::microfacet::Roughness {{ share: {share}, inverse: {inverse} }}")
    };
    format!("[{}]", slopes.map(slope).join(", "))
}

fn reflection<S: Literal>(
    Reflection { f0, q, denser, is_metal, is_thin, is_tinted }: Reflection<S>,
) -> String {
    let (f0, q) = (color::<S>(f0), unit::<S>(q));
    format!(
        "{PATH}::table::Reflection {{ f0: {f0}, q: {q}, denser: {denser}, is_metal: {is_metal}, \
         is_thin: {is_thin}, is_tinted: {is_tinted} }}"
    )
}

fn conductor<S: Literal>(Conductor { difference, product, scale }: Conductor<S::Unit>) -> String {
    let [difference, product, scale] = [difference, product, scale].map(unit::<S>);
    format!("{PATH}::fresnel::Conductor {{ difference: {difference}, product: {product}, scale: {scale} }}")
}

fn positive<S: Literal>(value: PositiveOf<S>) -> String {
    S::power_literal(value)
}

fn positives<S: Literal>(Rgb { r, g, b }: Rgb<PositiveOf<S>>) -> String {
    format!("Rgb::new({}, {}, {})", positive::<S>(r), positive::<S>(g), positive::<S>(b))
}

fn fading_of<S: Literal>(layer: &Layer<S>) -> String {
    match *layer {
        Layer::Distance(Distance { exponent: p, reference }) => {
            format!("Distance {{ exponent: {}, reference: {} }}", exponent(p), length(reference))
        }
        Layer::Haze(Haze { near, far, color }) => {
            format!("Haze {{ near: {}, far: {}, color: {} }}", length(near), length(far), light::<S>(color))
        }
    }
}

/// Returns a medium as an expression: one that scatters nothing is fog.
fn medium_of<S: Literal>(medium: &Medium<S>) -> String {
    let Medium { fog: Fog { density, glow }, albedo, phase, halvings, shadows, reach, fades } = *medium;
    let fog = format!("Fog {{ density: {}, glow: {} }}", positives::<S>(density), light::<S>(glow));
    if albedo == S::Unit::ZERO && reach.is_none() {
        return fog;
    }
    let reach = reach.map_or_else(|| "None".into(), |reach| format!("Some({})", length(reach)));
    let (albedo, forward) = (unit::<S>(albedo), unit::<S>(phase.forward));
    format!(
        "Medium {{ fog: {PATH}::air::{fog}, albedo: {albedo}, phase: {PATH}::fade::Phase {{ forward: {forward} }}, \
         halvings: {halvings}, shadows: {shadows}, reach: {reach}, fades: {fades} }}"
    )
}
