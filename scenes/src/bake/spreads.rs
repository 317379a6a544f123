//! The source of what spreads rays in a baked scene, and of what moves in it.

use core::fmt::{self, Write};

use rta_core::light::area::Square;
use rta_core::needs::Used;
use rta_core::sampling::Places;
use rta_core::scene::Object;
use rta_core::trace::dice::Spread;

use super::literal::{Literal, direction, length, place, unit};
use super::model;
use super::module::{ALLOW, List, write_names};
use crate::narrow::Narrowed;
use crate::sampler::{Adaptive, Lamps, Spreading};

/// Returns what of a scene that needs `used` is needed to spread its rays, too.
pub(super) fn used<S: Literal>(scene: &Narrowed<S>, spreading: Option<&Spreading>, used: Used) -> Used {
    let Some(spreading) = spreading else { return Used { spread_air: false, ..used } };
    let has_squares = !scene.spreads.squares.is_empty();
    let has_size = has_squares || scene.lamps.iter().any(|lamp| lamp.radius > S::ZERO);
    let area_lamps = used.lamps && spreading.lamps != Lamps::Point && has_size;
    Used {
        area_lamps,
        square_lamps: area_lamps && has_squares,
        cone_lamps: area_lamps && spreading.lamps == Lamps::Cone,
        radiosity: scene.lit.is_some(),
        lens: scene.spreads.aperture.is_some(),
        eye_motion: scene.spreads.eye.is_some(),
        gloss: used.mirror && !scene.spreads.roughness.is_empty(),
        grooves: used.mirror && !scene.spreads.slopes.is_empty(),
        ..used
    }
}

/// Returns the name of the list of a scene that an object is in; the floor is in none.
const fn list(object: Object) -> Option<&'static str> {
    Some(match object {
        Object::Cylinder(_) => "CYLINDERS",
        Object::Ellipsoid(_) => "ELLIPSOIDS",
        Object::Sphere(_) => "SPHERES",
        Object::Cone(_) => "CONES",
        Object::Triangle(_) => "TRIANGLES",
        Object::Plane(_) => "PLANES",
        Object::Lamp(_) => "LAMPS",
        Object::Floor => return None,
    })
}

/// Returns whether something in a list moves, while rays are spread.
pub(super) fn moves<S: Literal>(scene: &Narrowed<S>, spreading: Option<&Spreading>, name: &str) -> bool {
    spreading.is_some() && scene.spreads.motions.iter().any(|motion| list(motion.object) == Some(name))
}

/// Writes samples, what spreads their rays, what moves, and the memory of it; all are empty where nothing is spread. `lists` are those in
/// which something moves.
pub(super) fn write<S: Literal>(
    out: &mut impl Write,
    scene: &Narrowed<S>,
    spreading: Option<&Spreading>,
    lists: &[List],
) -> fmt::Result {
    let sobol = "::rta_core::sampling::Sobol";
    let samples = spreading.map_or_else(
        || "None".into(),
        |Spreading { samples, .. }| format!("{sobol}::new({}, {})", samples.samples(), samples.seed()),
    );
    writeln!(out, "\n/// The samples of a pixel whose rays are spread; `None` where they are not.\n{ALLOW}")?;
    writeln!(out, "pub const SAMPLES: Option<{sobol}> = {samples};")?;
    writeln!(out, "\n/// What spreads rays.\n{ALLOW}")?;
    writeln!(out, "pub static SPREAD: ::rta_core::trace::dice::Spread<'static, Number> = {{")?;
    write_names(out, S::CONSTRUCTORS)?;
    write_spread(out, &spreading.map_or(Spread::NONE, |spreading| scene.spread(spreading)))?;
    let motions = spreading.map_or(&[][..], |_| &scene.spreads.motions);
    let motion = "::rta_core::trace::moving::Motion";
    writeln!(out, "}};\n\n/// What moves while the shutter is open.\n{ALLOW}")?;
    writeln!(out, "pub static MOTIONS: [{motion}<Number>; {}] = {{", motions.len())?;
    write_names(out, S::CONSTRUCTORS)?;
    writeln!(out, "    [")?;
    for own in motions {
        let (object, by) = (own.object, place::<S>(own.by));
        writeln!(out, "        {motion} {{ object: ::rta_core::scene::Object::{object:?}, by: {by} }},")?;
    }
    writeln!(out, "    ]\n}};")?;
    write_room(out, lists)
}

/// Writes how pixels are antialiased, if they are.
pub(super) fn write_adaptive(out: &mut impl Write, adaptive: Option<Adaptive>) -> fmt::Result {
    let path = "::rta_core::raster::corners::Cutting";
    let (cutting, has_contrast) = match adaptive {
        None => ("None".into(), false),
        Some(Adaptive::Whitted(cutting)) => {
            (format!("{path}::new({}, {})", cutting.depth(), cutting.tolerance()), false)
        }
        Some(Adaptive::Mitchell) => ("None".into(), true),
    };
    writeln!(
        out,
        "\n/// How pixels are cut where the light at their corners differs; `None` where they are not.\n{ALLOW}"
    )?;
    writeln!(out, "pub const CUTTING: Option<{path}> = {cutting};")?;
    writeln!(out, "\n/// Whether pixels have more samples where the contrast is high.\n{ALLOW}")?;
    writeln!(out, "pub const CONTRAST: bool = {has_contrast};")
}

/// Writes the fields of what spreads, within an item.
fn write_spread<S: Literal>(out: &mut impl Write, spread: &Spread<S>) -> fmt::Result {
    let Spread { lamps, split, squares, aperture, roughness, slopes, bodies, indirect: _, eye } = spread;
    let square = |square: &Option<Square<S>>| {
        let Some(Square { corner, middle, edges, normal, least: (least, inverse) }) = square else {
            return "None".to_owned();
        };
        format!(
            "Some(::rta_core::light::area::Square {{ corner: {}, middle: {}, edges: [{}], normal: {}, least: ({}, {}) }})",
            place::<S>(*corner),
            place::<S>(*middle),
            edges.map(place::<S>).join(", "),
            direction::<S>(*normal),
            length(*least),
            S::inverse_literal(*inverse)
        )
    };
    let squares: Vec<_> = squares.iter().map(square).collect();
    let roughness: Vec<_> = roughness.iter().map(|&own| unit::<S>(own)).collect();
    let slopes: Vec<_> = slopes.iter().map(|&own| model::slopes::<S>(own)).collect();
    let aperture = aperture.map_or_else(
        || "None".into(),
        |lens| {
            let (radius, shift) = (length(lens.radius), unit::<S>(lens.shift));
            let axes = lens.axes.map(direction::<S>).join(", ");
            format!(
                "Some(::rta_core::camera::Aperture {{ radius: {radius}, shift: {shift}, axes: [{axes}] }})"
            )
        },
    );
    let eye = eye.map_or_else(|| "None".into(), |by| format!("Some({})", place::<S>(by)));
    writeln!(
        out,
        "    ::rta_core::trace::dice::Spread {{\n        lamps: ::rta_core::trace::dice::Lamps::{lamps:?},\n        \
         split: {split},\n        squares: const {{ &[{}] }},\n        aperture: {aperture},\n        \
         roughness: const {{ &[{}] }},\n        slopes: const {{ &[{}] }},\n        bodies: &{bodies:?},\n        indirect: None,\n        eye: {eye},\n    }}",
        squares.join(", "),
        roughness.join(", "),
        slopes.join(", ")
    )
}

/// Writes the type of the memory of what moves: copies of the lists in which something does.
fn write_room(out: &mut impl Write, lists: &[List]) -> fmt::Result {
    let moving = "::rta_core::trace::moving";
    // A list of any length has no default of its own.
    let default = if lists.is_empty() { ", Default" } else { "" };
    writeln!(out, "\n/// The memory of what moves.\n{ALLOW}\n#[derive(Clone, Copy, Debug{default})]")?;
    writeln!(out, "pub struct Room {{")?;
    for List { name, path, objects } in lists {
        writeln!(out, "    {}: [::rta_core::{path}<Number>; {}],", name.to_lowercase(), objects.len())?;
    }
    writeln!(out, "}}")?;
    if !lists.is_empty() {
        writeln!(out, "\nimpl Default for Room {{\n    fn default() -> Self {{\n        Self {{")?;
        for List { name, .. } in lists {
            writeln!(out, "            {}: {name},", name.to_lowercase())?;
        }
        writeln!(out, "        }}\n    }}\n}}")?;
    }
    writeln!(
        out,
        "\nimpl {moving}::Room<Number> for Room {{\n    fn copies<'c>(\n        &'c mut self,\n        \
         _: &::rta_core::scene::Scene<'_, Number>,\n        _: &[{moving}::Motion<Number>],\n    \
         ) -> ::rta_core::scene::Copies<'c, Number> {{\n        ::rta_core::scene::Copies {{"
    )?;
    for List { name, .. } in lists {
        let name = name.to_lowercase();
        writeln!(out, "            {name}: &mut self.{name},")?;
    }
    writeln!(out, "            ..::rta_core::scene::Copies::none()\n        }}\n    }}\n}}")
}
