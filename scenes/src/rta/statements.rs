//! The table of statements: it reads, writes and documents the language.

use super::table::Kind::{Color, File, Name, Number, Options, Share, Spectrum, Vector, Whole};
use super::table::{Part, Statement, Value as V, either, may, must, one};
use crate::numbers::Range::{Angle, Any, Between, NotNegative, Positive};

mod shapes;
mod things;

/// What stands for a material in an error.
pub(super) const A_MATERIAL: &str = "a material defined above";
/// What stands for a texture in an error.
pub(super) const A_TEXTURE: &str = "a texture defined above";

/// What stands for a path in an error.
pub(super) const A_PATH: &str = "a path defined above";

const PLACE: &[V] = &[V("place", Vector(Any))];
const COLORS: &[V] = &[V("first colour", Color(NotNegative)), V("second colour", Color(NotNegative))];

const OF: Part = may("of", &[V("material", Name(A_MATERIAL))], "its material").default("opaque");

const ALONG: Part =
    may("along", &[V("path", Name(A_PATH))], "the path that it moves along in a film, from where it stands");

const MOVES: Part = may(
    "moves",
    &[V("motion", Vector(Any))],
    "how far it moves in the time from 0 to 1, in which the shutter is open",
);

const fn once(
    keyword: &'static str,
    noun: &'static str,
    about: &'static str,
    parts: &'static [Part],
) -> Statement {
    Statement { keyword, noun, once: true, about, parts }
}

/// Returns all statements.
pub(super) fn all() -> impl Iterator<Item = &'static Statement> {
    ONCE.iter().chain(things::THINGS).chain(shapes::SHAPES)
}

/// The statements that a scene has once.
const ONCE: &[Statement] = &[
    once(
        "camera",
        "camera",
        "Where the observer stands and looks; every scene has it",
        &[
            must("at", PLACE, "where the eye is"),
            one(0, "look", &[V("direction", Vector(Any))], "the direction of view, of any length"),
            one(0, "to", &[V("aim", Vector(Any))], "the place that it looks at"),
            may("up", &[V("up", Vector(Any))], "what is up in the picture").default("0 0 1"),
            either(1, "lens", &[V("lens", Number(Positive))], "distance of an image that is 1 wide")
                .tail(&[may("high", &[], "the image is 1 high, not 1 wide")])
                .default("1"),
            either(
                1,
                "angle",
                &[V("angle", Number(Angle))],
                "angle of view across the longer side of the picture",
            ),
            ALONG,
            may("focus", &[V("focus", Number(Positive))], "the distance that is sharp")
                .default("that of the point that it looks at"),
            may("aperture", &[V("aperture", Number(Positive))], "diameter of the lens").default("a pinhole"),
            may(
                "shutter",
                &[V("opening", Number(Any)), V("closing", Number(Any))],
                "when it opens and closes, for what moves",
            )
            .default("0 1"),
            MOVES,
            may(
                "hither",
                &[V("hither", Number(Positive))],
                "NFF's distance of the nearest thing seen; nothing is clipped",
            ),
        ],
    ),
    once(
        "picture",
        "picture",
        "How large the picture is, and how it is traced where the command line says nothing else",
        &[
            must(
                "",
                &[V("width", Whole(1, u32::MAX)), V("height", Whole(1, u32::MAX))],
                "pixels of a row, and rows",
            )
            .default("320 200"),
            may(
                "screen",
                &[V("width", Number(Positive)), V("height", Number(Positive))],
                "shape of the screen",
            )
            .default("4 3"),
            may(
                "depth",
                &[V("depth", Whole(0, 255))],
                "reflections and refractions that a ray is followed through",
            )
            .default("5"),
            may("samples", &[V("samples", Whole(1, 1024))], "samples of a pixel: 1, 4, 9, 16 ...")
                .default("1"),
            may("cutoff", &[V("cutoff", Share)], "part of its light that a ray must bring into the pixel")
                .default("0"),
        ],
    ),
    once(
        "model",
        "model",
        "The illumination model, with its options",
        &[must("", &[V("model", Name("a model")), V("options", Options)], "its name, see rta help render")
            .default("rta")],
    ),
    once(
        "attenuation",
        "attenuation",
        "How light fades on its way to the eye",
        &[
            must(
                "",
                &[V("attenuation", Name("an attenuation"))],
                "none, warnock, romney [POWER], haze NEAR FAR, or fog EXTINCTION",
            )
            .more(3, &[V("number", Number(NotNegative))])
            .default("none"),
            may("from", &[V("distance", Number(Positive))], "distance up to which nothing fades")
                .default("as far as the middle of the picture"),
            may("color", &[V("colour", Color(NotNegative))], "colour of the haze").default("the horizon's"),
        ],
    ),
    once(
        "medium",
        "medium",
        "What the scene is filled with: it absorbs light and scatters that of lamps and ambient light",
        &[
            must("extinction", &[V("extinction", Spectrum(NotNegative))], "per unit of length"),
            may("albedo", &[V("albedo", Share)], "part of it that is scattered").default("1"),
            may("anisotropy", &[V("anisotropy", Number(Between(-0.9, 0.9)))], "mean cosine of its angle")
                .default("0"),
            may("shadows", &[V("shadows", Whole(0, 1024))], "places of a ray that ask for shadows")
                .default("0"),
            may("reach", &[V("reach", Number(Positive))], "how far it reaches from where a ray starts")
                .default("up to what a ray meets, if it meets anything"),
        ],
    ),
    once(
        "spectral",
        "spectral",
        "Wavelengths instead of red, green and blue, for glass with dispersion",
        &[must("", &[V("number of wavelengths", Whole(1, 31))], "an odd number")],
    ),
    once(
        "sky",
        "sky",
        "What is seen where nothing is",
        &[
            one(0, "", &[V("colour", Color(NotNegative))], "one colour").default("black"),
            one(0, "horizon", &[V("horizon", Color(NotNegative))], "its colour at the horizon")
                .tail(&[must("zenith", &[V("zenith", Color(NotNegative))], "its colour straight up")]),
            one(
                0,
                "map",
                &[V("file", File)],
                "a picture of all directions, the zenith above, longitudes from x towards y",
            ),
        ],
    ),
    once(
        "ambient",
        "ambient light",
        "Light that comes from everywhere",
        &[must("", &[V("colour", Color(NotNegative))], "its colour").default("black")],
    ),
    once(
        "floor",
        "floor",
        "The chequered floor z = 0",
        &[
            must("", COLORS, "the tile that begins at the origin, and its neighbours"),
            may("tile", &[V("tile", Number(Positive))], "side of a tile").default("3"),
            OF,
        ],
    ),
];
