//! The source of what a baked scene has of several wavelengths.

use core::fmt::{self, Write};

use super::literal::{Literal, color};
use super::module::{ALLOW, accelerator, material, write_names};
use crate::accelerator::bvh::Built;
use crate::narrow::Narrowed;

/// Writes the weights of the wavelengths, the scene at all but the first of them, and the numbers of the `dispersive` materials; all are
/// empty where there are no such materials.
pub(super) fn write<S: Literal>(
    out: &mut impl Write,
    scene: &Narrowed<S>,
    hierarchy: &Built<S>,
    dispersive: &[u16],
) -> fmt::Result {
    let spectrum = scene.spectrum.as_ref().filter(|_| !dispersive.is_empty());
    let (weights, further) =
        spectrum.map_or((&[][..], &[][..]), |spectrum| (&spectrum.weights, &spectrum.further));
    let unit = "<Number as ::rta_core::Scalar>::Unit";
    writeln!(out, "\n/// The weights of the wavelengths.\n{ALLOW}")?;
    writeln!(out, "pub static WEIGHTS: [::rta_core::color::Rgb<{unit}>; {}] = {{", weights.len())?;
    write_names(out, S::CONSTRUCTORS)?;
    let weights: Vec<_> = weights.iter().map(|&weight| color::<S>(weight)).collect();
    writeln!(out, "    [{}]\n}};", weights.join(", "))?;
    let accelerator = accelerator(hierarchy);
    writeln!(out, "\n/// The scene at each wavelength but the first.\n{ALLOW}")?;
    writeln!(
        out,
        "pub static FURTHER: [::rta_core::range::Admitted<'static, Number, {accelerator}>; {}] = {{",
        further.len()
    )?;
    write_names(out, S::CONSTRUCTORS)?;
    writeln!(out, "    [")?;
    for table in further {
        let materials: Vec<_> = table.materials.iter().map(material::<S>).collect();
        writeln!(out, "        SCENE.with_materials(const {{ &[{}] }}),", materials.join(", "))?;
    }
    writeln!(out, "    ]\n}};")?;
    writeln!(out, "\n/// The materials whose light depends on the wavelength.\n{ALLOW}")?;
    writeln!(out, "pub static DISPERSIVE: [u16; {}] = {dispersive:?};", dispersive.len())
}
