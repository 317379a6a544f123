//! Lamps, paths, textures and materials: the statements that a scene has as often as it likes, but for its objects.

use super::{A_MATERIAL, A_TEXTURE, ALONG, COLORS, MOVES, PLACE};
use crate::numbers::Range::{Any, Between, Gloss, NotNegative, Part as Fraction, Positive, Share as Unit};
use crate::rta::table::Kind::{Axis, Color, File, Name, New, Number, Offset, Share, Vector, Whole};
use crate::rta::table::{Part, Statement, Value as V, either, may, must, one};

const SHARE: Part = may("share", &[V("share", Share)], "their part of all facets").default("1");

pub(super) const fn object(keyword: &'static str, about: &'static str, parts: &'static [Part]) -> Statement {
    Statement { keyword, noun: keyword, once: false, about, parts }
}

/// In the order in which a scene is written.
pub(super) const THINGS: &[Statement] = &[
    object(
        "lamp",
        "A lamp",
        &[
            one(0, "at", PLACE, "a sphere, or a point"),
            one(0, "toward", &[V("direction", Vector(Any))], "far away, in this direction"),
            one(
                0,
                "corner",
                &[V("corner", Vector(Any))],
                "a parallelogram with this corner; seen as a sphere of its area",
            )
            .tail(&[must(
                "edges",
                &[V("first edge", Vector(Any)), V("second edge", Vector(Any))],
                "its edges from there",
            )]),
            may("radius", &[V("radius", Number(NotNegative))], "with 0 it shines unseen").default("0"),
            may("color", &[V("colour", Color(NotNegative))], "its colour").default("white"),
            may("power", &[V("power", Number(Positive))], "multiplies its colour").default("1"),
            either(1, "square", &[], "its light falls with the square of the distance"),
            either(1, "constant", &[], "its light does not depend on the distance")
                .default("as the model has it"),
            MOVES,
            ALONG,
        ],
    ),
    object(
        "path",
        "A path with a name, for the frames of a film",
        &[
            must("", &[V("name", New)], "its name"),
            may("linear", &[], "it goes straight from place to place").default("a smooth curve through them"),
            Part {
                repeats: true,
                ..must(
                    "at",
                    &[V("time", Number(Between(0.0, 1.0))), V("place", Vector(Any))],
                    "where it is, from the earliest time to the latest; two of them or more",
                )
            },
        ],
    ),
    object(
        "texture",
        "A texture with a name",
        &[
            must("", &[V("name", New)], "its name"),
            one(0, "checker", COLORS, "cubes in two colours"),
            one(0, "marble", COLORS, "turbulent waves, with octaves and amount")
                .more(1, &[V("octaves", Whole(1, 16)), V("amount", Number(NotNegative))])
                .default("4 2"),
            one(0, "wood", COLORS, "rings, with an amount of noise")
                .more(1, &[V("amount", Number(NotNegative))])
                .default(".1"),
            one(0, "image", &[V("file", File)], "a picture").tail(&[
                may("nearest", &[], "its pixels have edges"),
                may("plane", &[V("first axis", Axis), V("second axis", Axis)], "the axes that it lies along"),
            ]),
            may("at", PLACE, "its origin").default("0 0 0"),
            may("scale", &[V("scale", Number(Positive))], "units of the scene for one of it").default("1"),
        ],
    ),
    object(
        "material",
        "A material with a name, for every model at once: each uses what it knows",
        &[
            must("", &[V("name", New)], "its name"),
            may("like", &[V("material", Name(A_MATERIAL))], "all that another material says, before this")
                .default("opaque"),
            may("color", &[V("colour", Color(NotNegative))], "colour of objects that have none"),
            may("ambient", &[V("ambient", Share)], "coefficient of ambient light, ka").default("as diffuse"),
            may("diffuse", &[V("diffuse", Number(NotNegative))], "diffuse coefficient, kd"),
            may("back", &[V("back", Share)], "coefficient of light from behind, kdt"),
            may(
                "specular",
                &[V("specular", Number(NotNegative))],
                "coefficient of highlights and mirror rays, ks; share of microfacets, s",
            ),
            may(
                "transmit",
                &[V("transmit", Number(NotNegative))],
                "share of the light that comes through, kt",
            ),
            may("mirror", &[V("mirror", Share)], "share of the mirror ray in models of microfacets"),
            may("exponent", &[V("exponent", Number(NotNegative))], "exponent of highlights, 0 to 1000")
                .default("50"),
            may(
                "gloss",
                &[V("gloss", Number(Gloss))],
                "angle at which highlights have half their strength, for every model",
            ),
            may(
                "roughness",
                &[V("roughness", Share)],
                "of the facets that reflect and refract rays: 0 is a mirror, 1 is dull",
            )
            .default("0"),
            Part {
                repeats: true,
                ..may(
                    "slope",
                    &[V("slope", Number(Between(0.01, 1.0)))],
                    "slope of microfacets, m; up to four, with shares that add up to 1",
                )
                .tail(&[SHARE])
                .default(".3")
            },
            may("index", &[V("index", Number(Positive))], "index of refraction").default("1"),
            either(0, "abbe", &[V("Abbe number", Number(Positive))], "dispersion, by Cauchy's formula"),
            either(
                0,
                "sellmeier",
                &[V("offset", Offset), V("B", Number(Any)), V("C", Number(Any))],
                "dispersion: B and C in square micrometres, in pairs",
            )
            .more(15, &[V("B", Number(Any)), V("C", Number(Any))]),
            may("metal", &[V("reflectance", Color(Unit))], "what a metal reflects straight back"),
            may(
                "nk",
                &[
                    V("n of red", Number(Positive)),
                    V("k of red", Number(NotNegative)),
                    V("n of green", Number(Positive)),
                    V("k of green", Number(NotNegative)),
                    V("n of blue", Number(Positive)),
                    V("k of blue", Number(NotNegative)),
                ],
                "optical constants of a metal, for models that compute what it reflects; with metal that is its colour",
            ),
            may(
                "absorb",
                &[V("absorption", Color(Fraction))],
                "what is left of light inside, after a length of 1",
            )
            .tail(&[may("over", &[V("length", Number(Positive))], "after this length").default("1")]),
            may(
                "edge",
                &[V("exponent", Whole(1, 3)), V("least transmission", Share), V("most transmission", Share)],
                "a thin wall transmits the first share at its edges, the second face on",
            ),
            may("thin", &[], "a thin wall: light goes straight through"),
            may(
                "emits",
                &[V("light", Color(NotNegative))],
                "the radiance that its outside sends out; a quad that emits lights the scene",
            )
            .default("black"),
            may("surroundings", &[], "its mirror rays see the sky alone, and no things"),
            may("texture", &[V("texture", Name(A_TEXTURE))], "gives its colour"),
            may(
                "bump",
                &[V("texture", Name(A_TEXTURE)), V("height", Number(Any))],
                "gives its bumps, of this height",
            ),
        ],
    ),
];
