//! Bakes the scenes of the tests in `tests/all/baked.rs`. A firmware's build script is one call of `bake`, as the first
//! below; here a scene is baked in several formats, so the other files are written under names of their own.

use core::error::Error;
use std::env;
use std::fs;
use std::path::Path;

use rta_scenes::bake::{Format, Model, Recipe, bake, module};

/// Scene files, and the name of each in Rust.
const SCENES: [(&str, &str); 3] = [
    ("juggler", "../scenes/juggler.dat"),
    ("hall_22", "../scenes/hall-22.dat"),
    ("glass_2", "../scenes/glass-2.dat"),
];

fn main() -> Result<(), Box<dyn Error>> {
    // Writes juggler.rs.
    bake("../scenes/juggler.dat", Format::Q16)?;

    for (name, file) in SCENES {
        for (suffix, format) in [("q16", Format::Q16), ("q20", Format::Q20), ("f32", Format::F32)] {
            write(&format!("{name}_{suffix}"), file, &Recipe::new(format))?;
        }
    }
    // A scene without secondary rays, and one with another model.
    write("opaque_q16", "boards/scenes/opaque.dat", &Recipe::new(Format::Q16))?;
    write(
        "whitted_q16",
        "../scenes/hall-22.dat",
        &Recipe { model: Model::Whitted, ..Recipe::new(Format::Q16) },
    )?;
    for (suffix, format) in [("q16", Format::Q16), ("f32", Format::F32)] {
        write(&format!("tiles_{suffix}"), "scenes/tiles.rta", &Recipe::new(format))?;
    }
    // Triangles, cones, and a hierarchy, which is baked only where there are many objects.
    for (suffix, format) in [("q16", Format::Q16), ("f32", Format::F32)] {
        let recipe = Recipe { model: Model::Whitted, ..Recipe::new(format) };
        write(&format!("solids_{suffix}"), "scenes/solids.nff", &recipe)?;
        write(&format!("kinds_{suffix}"), "scenes/kinds.nff", &recipe)?;
        write(&format!("balls_2_{suffix}"), "../scenes/balls2.nff", &recipe)?;
    }
    write("glass_2_f64", "../scenes/glass-2.dat", &Recipe::new(Format::F64))
}

/// Bakes the scene `file` into `name`.rs.
fn write(name: &str, file: &str, recipe: &Recipe) -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed={file}");
    let text = fs::read(file)?;
    let source = module(&rta_scenes::read(&text, file)?, name, recipe)?;
    fs::write(Path::new(&env::var("OUT_DIR")?).join(name).with_extension("rs"), source)?;
    Ok(())
}
