//! Bakes the scenes of the tests in `tests/all/baked.rs`. A firmware's build script is one call of `bake`, as the first
//! below; here a scene is baked in several formats, so the other files are written under names of their own.

use core::error::Error;
use std::env;
use std::fs;
use std::path::PathBuf;

use rta_scenes::bake::{Format, Model, Recipe, SAMPLES, TEXELS, bake, module};
use rta_scenes::sampler::{Lamps, Spreading};

/// Scene files, and the name of each in Rust.
const SCENES: [(&str, &str); 3] = [
    ("juggler", "../../scenes/juggler.dat"),
    ("hall_22", "../../scenes/hall-22.dat"),
    ("glass_2", "../../scenes/glass-2.dat"),
];

fn main() -> Result<(), Box<dyn Error>> {
    // Writes juggler.rs.
    bake("../../scenes/juggler.dat", Format::Q16)?;

    for (name, file) in SCENES {
        for (suffix, format) in [("q16", Format::Q16), ("q20", Format::Q20), ("f32", Format::F32)] {
            write(&format!("{name}_{suffix}"), file, &Recipe::new(format))?;
        }
    }
    // A scene without secondary rays, and one with another model.
    write("opaque_q16", "../boards/scenes/opaque.dat", &Recipe::new(Format::Q16))?;
    write(
        "whitted_q16",
        "../../scenes/hall-22.dat",
        &Recipe { model: Model::Whitted, ..Recipe::new(Format::Q16) },
    )?;
    for (suffix, format) in [("q16", Format::Q16), ("f32", Format::F32)] {
        write(&format!("tiles_{suffix}"), "../scenes/tiles.rta", &Recipe::new(format))?;
    }
    // Triangles, cones, and a hierarchy, which is baked only where there are many objects.
    for (suffix, format) in [("q16", Format::Q16), ("f32", Format::F32)] {
        let recipe = Recipe { model: Model::Whitted, ..Recipe::new(format) };
        write(&format!("solids_{suffix}"), "../scenes/solids.nff", &recipe)?;
        write(&format!("kinds_{suffix}"), "../scenes/kinds.nff", &recipe)?;
        write(&format!("balls_2_{suffix}"), "../../scenes/balls2.nff", &recipe)?;
    }
    write("glass_2_f64", "../../scenes/glass-2.dat", &Recipe::new(Format::F64))?;
    write_drawn()?;
    write_spread()
}

/// The scene of everything that spreads rays.
const SPREAD: &str = "../boards/scenes/spread.rta";

/// Few things, of which none spreads rays; what the scenes of some that do have besides, how lamps are asked, and the number format.
const ROOM: &str = "rta 1
sky horizon .8 .87 .97  zenith .15 .3 .65
ambient grey .2
floor grey .8 .25 .3 .35
sphere at 0 0 1  radius 1  color .9 .6 .3
sphere at 2.2 0 .7  radius .7  color .9 .9 .9  of mirror
";
const SPREADING: [(&str, Lamps, &str); 9] = [
    (
        "Q16",
        Lamps::Point,
        "camera at 0 -8 2  to 0 0 1  lens 1.2  aperture .4\npicture 8 8  samples 16\nlamp at -4 -5 6  power .9\n",
    ),
    (
        "Q20",
        Lamps::Point,
        "camera at 0 -8 2  to 0 0 1  lens 1.2\nlamp at -4 -5 6  power .9\nmaterial dull like mirror  roughness .3\n\
         sphere at -2.2 0 .7  radius .7  color .9 .9 .9  of dull\n",
    ),
    ("Q16", Lamps::Area, "camera at 0 -8 2  to 0 0 1  lens 1.2\nlamp at -4 -5 6  radius 1.2  power .9\n"),
    (
        "Q20",
        Lamps::Area,
        "camera at 0 -8 2  to 0 0 1  lens 1.2\nlamp corner 2 -2 4  edges 1.5 0 0  0 1.5 .5  power .9\n",
    ),
    ("F32", Lamps::Fixed(2), "camera at 0 -8 2  to 0 0 1  lens 1.2\nlamp at -4 -5 6  radius 1.2  power .9\n"),
    (
        // So many that they have a hierarchy, and of each kind one that moves.
        "Q16",
        Lamps::Point,
        "camera at 0 -8 2  to 0 0 1  lens 1.2  shutter .25 1\nlamp at -4 -5 6  power .9\n\
         ellipsoid at -2 0 1  radii .3 .3 .8  color .3 .5 .9  moves 0 0 1\n\
         cylinder at 0 5 0  radius .3  color .4 .9 .4  moves 1.5 0 0\n\
         cone from -1 -2 0 radius .5  to -1 -2 1 radius 0  color .9 .9 .2  moves .8 .2 0\n\
         triangle 1 -3 0  2 -3 0  1.5 -3 1  color .8 .3 .8  moves 0 0 .6\n\
         sphere at 1 -1 .4  radius .4  color .2 .8 .8  moves -1 0 .5\n",
    ),
    (
        // An eye and lamps that move, by themselves and along a path, and nothing else.
        "Q16",
        Lamps::Area,
        "path p linear  at 0 0 0 0  at 1 4 0 0\ncamera at 0 -8 2  to 0 0 1  lens 1.2  shutter 0 .25  along p\n\
         lamp at -4 -5 6  radius 1  power .5  moves 0 0 -4\n\
         lamp corner 2 -2 4  edges 1.5 0 0  0 1.5 .5  power .5  along p\n",
    ),
    (
        // Beams of a lamp with a size, in air that ends before the sky.
        "Q16",
        Lamps::Area,
        "camera at 0 -8 2  to 0 0 1  lens 1.2\nmedium extinction .05  albedo .9  shadows 16  reach 30\n\
         lamp at 0 6 5  radius 1  power 30\nsphere at 0 4 3  radius .8\n",
    ),
    ("Q20", Lamps::Point, "camera at 0 -8 2  to 0 0 1  lens 1.2  moves .5 0 .2\nlamp at -4 -5 6  power .9\n"),
];

/// Bakes scenes whose rays are spread, and writes the tests of `tests/all/spread.rs`.
fn write_spread() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed={SPREAD}");
    let all = fs::read_to_string(SPREAD)?;
    let balls: String = (0..24)
        .map(|i| format!("sphere at {} {} .3  radius .3  color .7 .7 .7\n", i % 8 - 4, 3 + i / 8))
        .collect();
    let scenes = SPREADING.iter().map(|(format, lamps, own)| {
        let balls = if own.contains("ellipsoid") { &balls } else { "" };
        (*format, *lamps, format!("{ROOM}{own}{balls}"))
    });
    let scenes =
        ["Q16", "Q20", "F32"].map(|format| (format, Lamps::Area, all.clone())).into_iter().chain(scenes);
    let mut tests = String::new();
    for (number, (name, lamps, text)) in scenes.enumerate() {
        let format = match name {
            "Q16" => Format::Q16,
            "Q20" => Format::Q20,
            _ => Format::F32,
        };
        let read = rta_scenes::read(text.as_bytes(), "spread.rta")?;
        let recipe = Recipe { spreading: Spreading::of(&read, lamps, SAMPLES), ..Recipe::of(format, &read) };
        fs::write(out()?.join(format!("spread_{number}.rs")), module(&read, "spread.rta", &recipe)?)?;
        tests += &format!("spread! {{ spread_{number}: {name}, {lamps:?}, {text:?} }}\n");
    }
    Ok(fs::write(out()?.join("spread.rs"), tests)?)
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
const SURFACES: [&str; 2] = ["../scenes/surfaces.rta", "../scenes/wavelengths.rta"];

/// Bakes the scene `models.rta` with every model, and with each choice, and writes the tests of `tests/all/drawn.rs`.
fn write_drawn() -> Result<(), Box<dyn Error>> {
    const FILE: &str = "../scenes/models.rta";
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
        read.load_pictures("../scenes".as_ref(), TEXELS)?;
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
