//! Bakes the scenes of the tests in `tests/all/baked.rs`. A firmware's build script is one call of `bake`, as the first
//! below; here a scene is baked in several formats, so the other files are written under names of their own.

use core::error::Error;
use std::env;
use std::fs;
use std::path::PathBuf;

use rta_scenes::bake::{Format, Model, Recipe, TEXELS, bake, module};

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
    write("glass_2_f64", "../scenes/glass-2.dat", &Recipe::new(Format::F64))?;
    write_drawn()
}

/// What else than its name a model is drawn with: its options, and air.
const CHOICES: [&str; 22] = [
    "bouknight mach 1",
    "bouknight p 1.7",
    "romney p 7",
    "newell edge 3 .1 .9",
    "blinn-full power 30",
    "blinn-full gauss 4",
    "blinn-full trowbridge .9",
    "blinn-full gloss 15",
    "cook-torrance sancer",
    "cook-torrance exact",
    "cook-torrance published mirror .5 gloss 12",
    "cook-torrance sancer exact published",
    "hall-greenberg cutoff .2",
    "rta\nspectral 3",
    "whitted\nspectral 9",
    "cook-torrance exact\nspectral 3",
    "hall-greenberg\nspectral 5\nmedium extinction .05  albedo .5",
    "lambert\nspectral 9",
    "lambert\nattenuation haze 5 20",
    "blinn\nattenuation romney 2\nmedium extinction .1 .1 .12  albedo 0",
    "whitted\nmedium extinction .1 .1 .12  albedo .8  anisotropy .3  shadows 16",
    "kay-greenberg\nattenuation warnock from 6\nmedium extinction .05  albedo .5",
];

/// Scenes with coats, and one of several wavelengths.
const SURFACES: [&str; 2] = ["scenes/surfaces.rta", "scenes/wavelengths.rta"];

/// Bakes the scene `models.rta` with every model, and with each choice, and writes the tests of `tests/all/drawn.rs`.
fn write_drawn() -> Result<(), Box<dyn Error>> {
    const FILE: &str = "scenes/models.rta";
    println!("cargo::rerun-if-changed={FILE}");
    let scene = fs::read_to_string(FILE)?;
    let names = Model::ALL.iter().map(|model| model.name());
    let mut texts: Vec<_> = names.chain(CHOICES).map(|choice| format!("{scene}model {choice}\n")).collect();
    for file in SURFACES {
        println!("cargo::rerun-if-changed={file}");
        texts.push(fs::read_to_string(file)?);
    }
    let mut tests = String::new();
    for (number, text) in texts.iter().enumerate() {
        let name = format!("drawn_{number}");
        let mut read = rta_scenes::read(text.as_bytes(), "models.rta")?;
        read.load_pictures("scenes".as_ref(), TEXELS)?;
        let recipe = Recipe { model: read.model, ..Recipe::new(Format::Q16) };
        fs::write(out()?.join(&name).with_extension("rs"), module(&read, &name, &recipe)?)?;
        tests += &format!("drawn! {{ {name}: {text:?} }}\n");
    }
    Ok(fs::write(out()?.join("drawn.rs"), tests)?)
}

/// Returns the folder of what is baked.
fn out() -> Result<PathBuf, env::VarError> {
    env::var("OUT_DIR").map(PathBuf::from)
}

/// Bakes the scene `file` into `name`.rs.
fn write(name: &str, file: &str, recipe: &Recipe) -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed={file}");
    let text = fs::read(file)?;
    let source = module(&rta_scenes::read(&text, file)?, name, recipe)?;
    fs::write(out()?.join(name).with_extension("rs"), source)?;
    Ok(())
}
