//! Materials and textures as statements.

use super::Words;
use crate::description::{Axis, Dispersion, Kind, Material, Pattern, Texture};

const fn axis(axis: Axis) -> &'static str {
    match axis {
        Axis::X => "x",
        Axis::Y => "y",
        Axis::Z => "z",
    }
}

pub(super) fn texture(texture: &Texture, text: &mut String) {
    let mut words = Words::new("texture");
    words.name("", &texture.name);
    match &texture.pattern {
        Pattern::Checker([first, second]) => _ = words.color("checker", *first).color("", *second),
        Pattern::Marble { colors: [first, second], octaves, amount } => {
            words.color("marble", *first).color("", *second).numbers("", &[f64::from(*octaves), *amount]);
        }
        Pattern::Wood { colors: [first, second], amount } => {
            words.color("wood", *first).color("", *second).number("", *amount);
        }
        Pattern::Image { file, nearest, plane } => {
            words.file("image", file).flag("nearest", *nearest);
            words.maybe(*plane, |words, [first, second]| {
                words.name("plane", axis(first)).name("", axis(second))
            });
        }
    }
    words.vector("at", texture.at).number("scale", texture.scale).end(text);
}

pub(super) fn material(own: &Material, text: &mut String) {
    let mut words = Words::new("material");
    words.name("", &own.name);
    let is_metal = own.metal.is_some() || own.nk.is_some();
    match own.kind {
        // The only one whose dispersion has no statement of its own.
        _ if matches!(own.dispersion, Some(Dispersion::Cauchy(_))) => _ = words.name("like", "ethyl-alcohol"),
        // A metal is one by itself.
        Kind::Opaque if is_metal => _ = words.name("like", "opaque"),
        Kind::Opaque | Kind::Metal => {}
        Kind::Shiny => _ = words.name("like", "shiny"),
        Kind::Mirror => _ = words.name("like", "mirror"),
        // It says nothing that is not said again.
        Kind::Glass => _ = words.name("like", "vacuum"),
    }
    words.maybe(own.color, |words, color| words.color("color", color));
    for (keyword, number) in [
        ("ambient", own.ambient),
        ("diffuse", own.diffuse),
        ("back", own.back),
        ("specular", own.specular),
        ("transmit", own.transmit),
        ("mirror", own.mirror),
        ("exponent", own.exponent),
        ("gloss", own.gloss),
        ("roughness", own.roughness),
    ] {
        words.maybe(number, |words, number| words.number(keyword, number));
    }
    for slope in &own.slopes {
        words.number("slope", slope.slope).number("share", slope.share);
    }
    words.maybe(own.index, |words, index| words.number("index", index));
    match &own.dispersion {
        None | Some(Dispersion::Cauchy(_)) => {}
        Some(Dispersion::Abbe(number)) => _ = words.number("abbe", *number),
        Some(Dispersion::Sellmeier { offset, terms }) => {
            words.word("sellmeier");
            if *offset != 1.0 {
                words.name("", "offset").number("", *offset);
            }
            words.numbers("", terms.as_flattened());
        }
    }
    words.maybe(own.metal, |words, metal| words.color("metal", metal));
    words.maybe(own.nk, |words, nk| words.numbers("nk", nk.as_flattened()));
    words.maybe(own.absorb, |words, left| words.color("absorb", left));
    words.maybe(own.edge.as_ref(), |words, edge| {
        words.numbers("edge", &[edge.exponent.into(), edge.least, edge.most])
    });
    words.maybe(own.emits, |words, light| words.color("emits", light));
    words.flag("thin", own.thin).flag("surroundings", own.surroundings);
    words.maybe(own.texture.as_deref(), |words, texture| words.name("texture", texture));
    words
        .maybe(own.bump.as_ref(), |words, (texture, height)| words.name("bump", texture).number("", *height));
    words.end(text);
}
