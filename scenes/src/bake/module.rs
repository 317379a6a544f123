//! The source of a baked scene, item by item.

use core::fmt::{self, Write};

use rta_core::material::{Finish, Glass, Material};
use rta_core::needs::Used;
use rta_core::scalar::Exponent;
use rta_core::scene::Limits;
use rta_core::shape::Cone;

use super::Recipe;
use super::coats;
use super::literal::{Literal, color, direction, length, light, place, unit};
use crate::accelerator::bvh::Built;
use crate::narrow::{Narrow, Narrowed};

/// An item may not need all its names, and nobody reads its numbers.
pub(super) const ALLOW: &str = "#[allow(dead_code, unused_imports, clippy::unreadable_literal, clippy::default_constructed_unit_structs, unreachable_pub)]";

/// Writes number format, needs, scene and eye; returns the lists for which `is_moving`, which are items of their own, as something copies
/// them.
pub(super) fn write<S: Literal>(
    out: &mut impl Write,
    name: &str,
    (scene, hierarchy): (&Narrowed<S>, &Built<S>),
    limits: Limits<S>,
    used: Used,
    recipe: &Recipe,
    is_moving: impl Fn(&str) -> bool,
) -> Result<Vec<List>, fmt::Error> {
    let (format, aspect) = (<S as Narrow>::NAME, recipe.aspect);
    let model = recipe.model;
    let name = name.replace(['\n', '\r'], " ");
    writeln!(out, "// {name} in {format} for a screen of the shape {aspect:.4} : 1 and the model {model}.")?;
    writeln!(
        out,
        "// Made by `rta bake`, which has proved its range: change the scene and bake it again.\n"
    )?;
    writeln!(out, "/// The number format: {format}.\npub type Number = {};\n", S::PATH)?;
    write_needs(out, used)?;
    let (moving, still) = lists(scene).into_iter().partition::<Vec<_>, _>(|list| is_moving(list.name));
    for List { name, path, objects } in &moving {
        writeln!(out, "\n/// A list in which something moves.\n{ALLOW}")?;
        writeln!(out, "static {name}: [::rta_core::{path}<Number>; {}] = {{", objects.len())?;
        write_names(out, S::CONSTRUCTORS)?;
        writeln!(out, "    [")?;
        write_objects(out, path, objects)?;
        writeln!(out, "    ]\n}};")?;
    }
    writeln!(out, "\n/// The scene.\n{ALLOW}")?;
    let accelerator = accelerator(hierarchy);
    writeln!(out, "pub const SCENE: ::rta_core::range::Admitted<'static, Number, {accelerator}> = {{")?;
    write_names(out, S::CONSTRUCTORS)?;
    for List { name, path, objects } in &still {
        write_list(out, name, path, objects)?;
    }
    write_surfaces(out, scene)?;
    if hierarchy.bvh().is_some() {
        write_hierarchy(out, hierarchy)?;
    }
    writeln!(
        out,
        "    ::rta_core::range::Admitted::baked(\n        ::rta_core::scene::Scene {{\n            \
         cylinders: &CYLINDERS,\n            ellipsoids: &ELLIPSOIDS,\n            spheres: &SPHERES,\n            \
         cones: &CONES,\n            triangles: &TRIANGLES,\n            planes: &PLANES,\n            lamps: &LAMPS,\n            \
         materials: &MATERIALS,\n            coats: &COATS,\n            pool: &POOL,"
    )?;
    match &scene.floor {
        None => writeln!(out, "            floor: None,")?,
        Some(floor) => {
            let [even, odd] = floor.colors;
            let (even, odd) = (color::<S>(even), color::<S>(odd));
            let tile = floor.tile.map_or_else(|| "None".into(), |side| format!("Some({})", length(side)));
            writeln!(
                out,
                "            floor: Some(::rta_core::shape::Floor {{ colors: [{even}, {odd}], tile: {tile}, material: {} }}),",
                floor.material
            )?;
        }
    }
    let (horizon, zenith) = (light::<S>(scene.sky.horizon), light::<S>(scene.sky.zenith));
    writeln!(
        out,
        "            sky: ::rta_core::scene::Sky {{ horizon: {horizon}, zenith: {zenith} }},\n            \
         ambient: {},\n        }},",
        light::<S>(scene.ambient)
    )?;
    writeln!(
        out,
        "        ::rta_core::scene::Limits {{ floor_end: {}, cylinder_end: {}, depth: {} }},\n        {},\n    )\n}};",
        length(limits.floor_end),
        length(limits.cylinder_end),
        limits.depth,
        match hierarchy.bvh() {
            Some(_) => "::rta_core::accelerator::Bvh { nodes: &NODES, order: &ORDER }",
            None => "::rta_core::accelerator::Lists",
        }
    )?;
    let camera = &scene.camera;
    writeln!(out, "\n/// The eye.\n{ALLOW}\npub const CAMERA: ::rta_core::camera::Camera<Number> = {{")?;
    write_names(out, S::CONSTRUCTORS)?;
    writeln!(
        out,
        "    ::rta_core::camera::Camera {{\n        eye: {},\n        forward: {},\n        right: {},\n        up: {},\n    }}\n}};",
        place::<S>(camera.eye),
        direction::<S>(camera.forward),
        direction::<S>(camera.right),
        direction::<S>(camera.up)
    )?;
    Ok(moving)
}

/// Returns the type of the accelerator.
pub(super) fn accelerator<S: Literal>(hierarchy: &Built<S>) -> &'static str {
    match hierarchy.bvh() {
        Some(_) => "::rta_core::accelerator::Bvh<'static, Number>",
        None => "::rta_core::accelerator::Lists",
    }
}

fn write_needs(out: &mut impl Write, used: Used) -> fmt::Result {
    writeln!(out, "/// What the scene needs.\n{ALLOW}\n#[derive(Clone, Copy, Debug)]\npub struct Needs;\n")?;
    writeln!(out, "impl ::rta_core::needs::Needs for Needs {{")?;
    for (name, value) in used.named() {
        writeln!(out, "    const {name}: bool = {value};")?;
    }
    writeln!(out, "}}")
}

/// Short names for what the expressions are made of, within one item.
pub(super) fn write_names(out: &mut impl Write, constructors: &str) -> fmt::Result {
    out.write_str(
        "    use ::rta_core::Scalar;
    use ::rta_core::color::Rgb;
    use ::rta_core::material::{Finish, Glass, Material};
    type Unit = <Number as Scalar>::Unit;
    type Light = <Number as Scalar>::Light;
    type Place = <Number as Scalar>::Vector;
    type Direction = <Number as Scalar>::UnitVector;
",
    )?;
    out.write_str(constructors)
}

/// A list of objects as a static of its own: what is in it stays in flash, while the scene, a constant, is known to the
/// compiler wherever it is used.
fn write_list(out: &mut impl Write, name: &str, path: &str, objects: &[String]) -> fmt::Result {
    writeln!(out, "    static {name}: [::rta_core::{path}<Number>; {}] = [", objects.len())?;
    write_objects(out, path, objects)?;
    writeln!(out, "    ];")
}

fn write_objects(out: &mut impl Write, path: &str, objects: &[String]) -> fmt::Result {
    objects.iter().try_for_each(|object| writeln!(out, "        ::rta_core::{path} {{ {object} }},"))
}

/// A list of a scene.
pub(super) struct List {
    /// The name of its static.
    pub(super) name: &'static str,
    /// The path of its type in the core.
    pub(super) path: &'static str,
    /// The fields of each object.
    pub(super) objects: Vec<String>,
}

/// Returns the lists of a scene in which something may move.
fn lists<S: Literal>(scene: &Narrowed<S>) -> [List; 7] {
    let cylinders = scene.cylinders.iter().map(|c| {
        format!(
            "center: {}, radius: {}, inverse_radius: {}, color: {}, material: {}",
            place::<S>(c.center),
            length(c.radius),
            S::inverse_literal(c.inverse_radius),
            color::<S>(c.color),
            c.material
        )
    });
    let ellipsoids = scene.ellipsoids.iter().map(|e| {
        format!(
            "center: {}, radii: {}, extent: {}, inverse_extent: {}, squash: {}, thickness: {}, inside_only: {}, color: {}, material: {}",
            place::<S>(e.center),
            place::<S>(e.radii),
            length(e.extent),
            S::inverse_literal(e.inverse_extent),
            direction::<S>(e.squash),
            unit::<S>(e.thickness),
            e.inside_only,
            color::<S>(e.color),
            e.material
        )
    });
    let spheres = scene.spheres.iter().map(|s| {
        format!(
            "center: {}, radius: {}, inverse_radius: {}, color: {}, material: {}",
            place::<S>(s.center),
            length(s.radius),
            S::inverse_literal(s.inverse_radius),
            color::<S>(s.color),
            s.material
        )
    });
    let cones = scene.cones.iter().map(|c| {
        let Cone { half_height, waist, cosine, sine, radii: [base, apex], capped, inside_only, .. } = *c;
        let [half_height, waist, cosine, sine] = [half_height, waist, cosine, sine].map(unit::<S>);
        format!(
            "center: {}, axis: {}, span: {}, inverse_span: {}, half_height: {half_height}, waist: {waist}, cosine: {cosine}, \
             sine: {sine}, radii: [{}, {}], capped: {capped}, inside_only: {inside_only}, color: {}, material: {}",
            place::<S>(c.center),
            direction::<S>(c.axis),
            length(c.span),
            S::inverse_literal(c.inverse_span),
            unit::<S>(base),
            unit::<S>(apex),
            color::<S>(c.color),
            c.material
        )
    });
    let triangles = scene.triangles.iter().map(|t| {
        let normals = match t.normals {
            None => "None".to_owned(),
            Some(normals) => format!("Some([{}])", normals.map(direction::<S>).join(", ")),
        };
        format!(
            "vertices: [{}], extent: {}, normal: {}, normals: {normals}, one_sided: {}, color: {}, material: {}",
            t.vertices.map(place::<S>).join(", "),
            length(t.extent),
            direction::<S>(t.normal),
            t.one_sided,
            color::<S>(t.color),
            t.material
        )
    });
    let planes = scene.planes.iter().map(|p| {
        let (center, normal) = (place::<S>(p.center), direction::<S>(p.normal));
        let (color, material) = (color::<S>(p.color), p.material);
        format!("center: {center}, normal: {normal}, color: {color}, material: {material}")
    });
    let lamps = scene.lamps.iter().map(|l| {
        format!(
            "position: {}, radius: {}, inverse_radius: {}, power: {}, tint: {}, fall_off: ::rta_core::light::FallOff::{:?}",
            place::<S>(l.position),
            length(l.radius),
            S::inverse_literal(l.inverse_radius),
            S::power_literal(l.power),
            color::<S>(l.tint),
            l.fall_off
        )
    });
    let list = |name, path, objects| List { name, path, objects };
    [
        list("CYLINDERS", "shape::Cylinder", cylinders.collect()),
        list("ELLIPSOIDS", "shape::Ellipsoid", ellipsoids.collect()),
        list("SPHERES", "shape::Sphere", spheres.collect()),
        list("CONES", "shape::Cone", cones.collect()),
        list("TRIANGLES", "shape::Triangle", triangles.collect()),
        list("PLANES", "shape::Plane", planes.collect()),
        list("LAMPS", "light::Lamp", lamps.collect()),
    ]
}

fn write_surfaces<S: Literal>(out: &mut impl Write, scene: &Narrowed<S>) -> fmt::Result {
    let materials = scene.materials.iter().map(material).collect::<Vec<_>>();
    writeln!(
        out,
        "    static MATERIALS: [Material<Number>; {}] = [{}];",
        materials.len(),
        materials.join(", ")
    )?;
    coats::write(out, scene)
}

fn write_hierarchy<S: Literal>(out: &mut impl Write, hierarchy: &Built<S>) -> fmt::Result {
    let nodes = hierarchy.nodes.iter().map(|n| {
        let (center, radius) = (place::<S>(n.center), length(n.radius));
        format!("center: {center}, radius: {radius}, first: {}, end: {}, skip: {}", n.first, n.end, n.skip)
    });
    write_list(out, "NODES", "accelerator::Node", &nodes.collect::<Vec<_>>())?;
    writeln!(out, "    static ORDER: [::rta_core::scene::Object; {}] = [", hierarchy.order.len())?;
    for object in &hierarchy.order {
        writeln!(out, "        ::rta_core::scene::Object::{object:?},")?;
    }
    writeln!(out, "    ];")
}

pub(super) fn material<S: Literal>(material: &Material<S>) -> String {
    match material {
        Material::Opaque => "Material::Opaque".into(),
        Material::Shiny => "Material::Shiny".into(),
        Material::Mirror => "Material::Mirror".into(),
        Material::Transparent(glass) => format!("Material::Transparent({})", self::glass(glass)),
        Material::Finish(Finish { ka, kd, exponent, reflected, glass }) => format!(
            "Material::Finish(Finish {{ ka: {}, kd: {}, exponent: {}, reflected: {}, glass: {} }})",
            unit::<S>(*ka),
            unit::<S>(*kd),
            self::exponent(*exponent),
            self::exponent(*reflected),
            self::glass(glass)
        ),
    }
}

pub(super) fn exponent(exponent: Exponent) -> String {
    let (mantissa, places) = exponent.parts();
    format!("::rta_core::scalar::Exponent::new({mantissa}, {places})")
}

fn glass<S: Literal>(glass: &Glass<S>) -> String {
    let [ks, kt, eta] = [glass.ks, glass.kt, glass.eta].map(unit::<S>);
    format!("Glass {{ ks: {ks}, kt: {kt}, eta: {eta}, denser: {} }}", glass.denser)
}
