//! The source of a baked scene's quads, and of the light that arrives at their patches.

use core::fmt::{self, Write};

use rta_core::color::Rgb;
use rta_core::radiosity::Quad;

use super::literal::{Literal, color, light, place};
use super::module::{ALLOW, write_names};
use crate::narrow::Narrowed;

/// Writes the quads, the number of their patches, and what arrives at these; all are empty in a scene without solved light and without any that
/// is to be solved.
pub(super) fn write<S: Literal>(out: &mut impl Write, scene: &Narrowed<S>) -> fmt::Result {
    let quads = scene.lit.as_ref().map_or(&[][..], |lit| &lit.quads);
    let arriving = scene.lit.as_ref().map_or(&[][..], |lit| &lit.arriving);
    let patches: usize = quads.iter().map(Quad::len).sum();
    writeln!(out, "\n/// The number of all patches.\n{ALLOW}\npub const PATCHES: usize = {patches};")?;
    let path = "::rta_core::radiosity::Quad";
    writeln!(out, "\n/// Quads, for radiosity.\n{ALLOW}")?;
    writeln!(out, "pub static QUADS: [{path}<Number>; {}] = {{", quads.len())?;
    write_names(out, S::CONSTRUCTORS)?;
    writeln!(out, "    [")?;
    for Quad { corners, patches, first, reflectance, emission, emitting, triangle, triangles } in quads {
        writeln!(
            out,
            "        {path} {{ corners: [{}], patches: {patches:?}, first: {first}, reflectance: {}, emission: {}, \
             emitting: {emitting:?}, triangle: {triangle}, triangles: {triangles} }},",
            corners.map(place::<S>).join(", "),
            color::<S>(*reflectance),
            light::<S>(*emission)
        )?;
    }
    writeln!(out, "    ]\n}};")?;
    writeln!(
        out,
        "\n/// The light that arrives at the patches, over pi, where it was solved ahead.\n{ALLOW}"
    )?;
    let element = "::rta_core::color::Rgb<<Number as ::rta_core::Scalar>::Light>";
    writeln!(out, "pub static ARRIVING: [{element}; {}] = {{", arriving.len())?;
    write_names(out, S::CONSTRUCTORS)?;
    writeln!(out, "    [")?;
    for own in arriving {
        writeln!(out, "        {},", light::<S>(*own))?;
    }
    writeln!(out, "    ]\n}};")?;
    let elsewhere = scene.lit.as_ref().map_or(Rgb::BLACK, |lit| lit.elsewhere);
    writeln!(
        out,
        "\n/// The light that arrives at what has no patches, over pi, where it was solved ahead.\n{ALLOW}"
    )?;
    writeln!(out, "pub static ELSEWHERE: {element} = {{")?;
    write_names(out, S::CONSTRUCTORS)?;
    writeln!(out, "    {}\n}};", light::<S>(elsewhere))
}
