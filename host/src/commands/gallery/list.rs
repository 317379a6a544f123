//! The pictures of the documents. A new one is its line here, and where it is shown.

use rta_scenes::shipped;

use crate::study::figures::keywords;

/// A picture of a document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Its file, from the root of the repository.
    pub file: String,
    /// What is to be seen in it, as the document has it in place of the picture.
    pub alt: String,
    /// The command that draws it.
    pub command: &'static str,
    /// The file that the command leaves, from the folder in which it is run.
    pub made: String,
    /// The scene, if it stands in the document and in no file.
    pub scene: Option<String>,
}

/// Draws figures, and the pictures of the page about the scene language.
const FIGURES: &str = "rta figures -o figures";
/// Draws a diagram of what it has measured.
const REPORT: &str = "rta report scenes/glass-2.dat -o report";
/// Draws a room by all ways to find light that goes round, and a diagram of what they cost.
const LIGHT: &str = "rta report --light scenes/cornell.rta -o light";

/// What is to be seen in a picture, and the command that draws it and nothing else.
const DRAWN: &[(&str, &str)] = &[
    ("The Juggler", "rta render scenes/juggler.dat -o scenes/juggler-vga.png"),
    (
        "The Juggler without stair-steps",
        "rta render scenes/juggler.dat -o scenes/juggler-smooth.png --aa whitted",
    ),
    (
        "22 objects, half of them mirrors",
        "rta render scenes/hall-22.dat -o scenes/hall-22-pixrect.png --device pixrect --size 384x300",
    ),
    (
        "A glass sphere",
        "rta render scenes/glass-2.dat -o scenes/glass-2-graphigs.png --device graphigs --size 300x300",
    ),
    #[cfg(feature = "image")] // a GIF
    ("The Juggler juggles", "rta juggle -o scenes/juggler.gif --size 160x100 --format q16"),
    (
        "The hall with 22 objects, thirteen times",
        "rta compare scenes/hall-22.dat -o scenes/models.png --size 256x192",
    ),
    (
        "Five metals in a row",
        "rta render scenes/metals.rta -o scenes/metals.png --device none --size 400x225",
    ),
    (
        "Glasses that absorb light",
        "rta render scenes/glasses.rta -o scenes/glasses.png --device none --size 400x225",
    ),
    (
        "A hall that ends in haze",
        "rta render scenes/haze.rta -o scenes/haze.png --device none --size 400x225",
    ),
    (
        "A table of textures",
        "rta render scenes/textures.rta -o scenes/textures.png --device none --size 320x200",
    ),
    (
        "Three metal balls under a picture of the sky",
        "rta render scenes/chrome.rta -o scenes/chrome.png --device none --size 320x200",
    ),
    (
        "White slits that a prism spreads into colours",
        "rta render scenes/prism.rta -o scenes/prism.png --device none --size 320x200",
    ),
    ("One vase four times", "rta render scenes/mesh.rta -o scenes/mesh.png --device none"),
    (
        "The Juggler as triangles, each of a colour of its own",
        "rta visibility scenes/juggler.dat -o scenes/visible.png --size 320x240",
    ),
    (
        "The four scenes without a device, on a VGA, with graPHIGS and with PIXRECT",
        "rta compare scenes/juggler.dat scenes/hall-22.dat scenes/glass-2.dat scenes/balls2.nff -o scenes/colors.png \
         --devices none,vga,graphigs,pixrect",
    ),
];

/// The file of a picture, what is to be seen in it, the command that draws it among others, and its file in the command's folder.
const AMONG_OTHERS: &[[&str; 4]] = &[
    [
        "scenes/figure-fresnel-metals.png",
        "Reflectance over the angle of incidence",
        FIGURES,
        "fresnel-metals.png",
    ],
    [
        "scenes/figure-gouraud-phong.png",
        "The cosine across the edge of two triangles",
        FIGURES,
        "gouraud-phong.png",
    ],
    [
        "scenes/glass-2-report.png",
        "Work-precision diagram of glass-2: error against retired instructions",
        REPORT,
        "glass-2.png",
    ],
    [
        "scenes/cornell-light-pictures.png",
        "The Cornell box by ambient light, distributed rays, radiosity, two passes, an irradiance cache and paths",
        LIGHT,
        "cornell-light-pictures.png",
    ],
    [
        "scenes/cornell-light.png",
        "Work-precision diagram of the Cornell box: error against cost by six methods",
        LIGHT,
        "cornell-light.png",
    ],
];

/// Returns all pictures.
#[must_use]
pub fn all() -> Vec<Picture> {
    let drawn = DRAWN.iter().map(|&(alt, command)| {
        let file = output(command).to_owned();
        Picture { made: file.clone(), file, alt: alt.to_owned(), command, scene: None }
    });
    let others = AMONG_OTHERS.iter().map(|&[file, alt, command, name]| {
        let made = format!("{}/{name}", output(command));
        Picture { file: file.to_owned(), alt: alt.to_owned(), command, made, scene: None }
    });
    let words = keywords::examples(shipped::PAGE).into_iter().map(|keywords::Example { name, alt, text }| {
        let made = format!("{}/keywords/{name}.png", output(FIGURES));
        Picture {
            file: format!("scenes/pictures/{name}.png"),
            alt,
            command: FIGURES,
            made,
            scene: Some(text),
        }
    });
    drawn.chain(others).chain(words).collect()
}

impl Picture {
    /// Returns whether it is of a report, which shows costs that were measured, and which differ between machines and builds.
    #[must_use]
    pub fn is_measured(&self) -> bool {
        [REPORT, LIGHT].contains(&self.command)
    }
}

/// Returns the file or the folder that a command writes to.
fn output(command: &str) -> &str {
    let after = command.split_once(" -o ").map_or("", |(_, after)| after);
    after.split(' ').next().unwrap_or_default()
}
