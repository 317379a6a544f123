//! The source of a baked scene's illumination model: its rows of the scene's materials, and the air around it.

use core::fmt::{self, Write};

use rta_core::color::Rgb;
use rta_core::illumination::air::{Distance, Fog, Haze};
use rta_core::illumination::microfacet::Roughness;
use rta_core::illumination::table::{PositiveOf, Reflection, Row, Tabled, Value};

use super::Model;
use super::literal::Literal;
use super::module::{ALLOW, color, exponent, length, light, unit, write_names};
use crate::description::Air;
use crate::narrow::Narrowed;
use crate::narrow::air::{Layer, layers};

/// Writes the function `model`, which returns the model for the scene; `middle` is the length of the ray in the middle of the
/// picture.
pub(super) fn write<S: Literal>(
    out: &mut impl Write,
    scene: &Narrowed<S>,
    (model, air): (Model, &Air),
    middle: S,
) -> fmt::Result {
    let mut rows = String::new();
    in_model!(model, model => write_rows(&mut rows, &model, scene))?;
    let name = model.type_name();
    writeln!(out, "\n/// Returns the illumination model `{model}` for this scene.\n{ALLOW}")?;
    writeln!(out, "pub fn model() -> impl ::rta_core::illumination::Illumination<Number> + Copy {{")?;
    write_names(out, S::CONSTRUCTORS)?;
    writeln!(out, "    use ::rta_core::illumination::table::Tabled;\n{rows}")?;
    let focused = format!("::rta_core::illumination::{name}::default(), {}", length(middle));
    let model = format!("Tabled::<Number>::over(&Tabled::<Number>::focused({focused}), &ROWS)");
    let (fading, fog) = layers(air, middle, &scene.sky, scene.ambient);
    let airs = [fading.as_ref().map(fading_of::<S>), fog.as_ref().map(fog_of::<S>)].into_iter().flatten();
    let model = airs.fold(model, |model, air| {
        format!("::rta_core::illumination::air::Through {{ model: {model}, air: ::rta_core::illumination::air::{air} }}")
    });
    writeln!(out, "    {model}\n}}")
}

fn write_rows<S: Literal, M: Tabled<S>>(out: &mut impl Write, model: &M, scene: &Narrowed<S>) -> fmt::Result {
    if M::Row::NAME.is_empty() {
        return write!(out, "    static ROWS: [(); 0] = [];");
    }
    let path = format!("::rta_core::illumination::{}", M::Row::NAME);
    writeln!(out, "    static ROWS: [{path}<Number>; {}] = [", scene.said.len())?;
    for material in &scene.said {
        let mut fields = Vec::new();
        model.row(material).fields(|name, value| fields.push(format!("{name}: {}", literal(value))));
        writeln!(out, "        {path} {{ {} }},", fields.join(", "))?;
    }
    write!(out, "    ];")
}

fn literal<S: Literal>(value: Value<S>) -> String {
    match value {
        Value::Unit(value) => unit::<S>(value),
        Value::Positive(value) => positive::<S>(value),
        Value::Exponent(value) => exponent(value),
        Value::Color(value) => color::<S>(value),
        Value::Positives(value) => positives::<S>(value),
        Value::Flag(value) => value.to_string(),
        Value::Reflection(Reflection { f0, q, denser, is_metal, is_tinted }) => {
            let (f0, q) = (color::<S>(f0), unit::<S>(q));
            format!(
                "::rta_core::illumination::table::Reflection {{ f0: {f0}, q: {q}, denser: {denser}, \
                 is_metal: {is_metal}, is_tinted: {is_tinted} }}"
            )
        }
        Value::Slopes(slopes) => {
            let slope = |Roughness { share, inverse }| {
                let (share, inverse) = (unit::<S>(share), positive::<S>(inverse));
                format!(
                    "::rta_core::illumination::microfacet::Roughness {{ share: {share}, inverse: {inverse} }}"
                )
            };
            format!("[{}]", slopes.map(slope).join(", "))
        }
    }
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

fn fog_of<S: Literal>(Fog { density, glow }: &Fog<S>) -> String {
    format!("Fog {{ density: {}, glow: {} }}", positives::<S>(*density), light::<S>(*glow))
}
