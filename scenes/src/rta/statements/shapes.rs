//! The objects.

use super::things::object;
use super::{ALONG, MOVES, OF, PLACE};
use crate::numbers::Range::{Any, NotNegative, NotZero, Positive};
use crate::polygon::MOST_CORNERS;
use crate::rta::table::Kind::{Color, Number, Share, Vector, Whole};
use crate::rta::table::{Part, Statement, Value as V, either, may, must};

const CORNERS: &[V] =
    &[V("first corner", Vector(Any)), V("second corner", Vector(Any)), V("third corner", Vector(Any))];
const NORMALS: &[V] =
    &[V("first normal", Vector(Any)), V("second normal", Vector(Any)), V("third normal", Vector(Any))];
const UV: &[V] = &[
    V("first u", Number(Any)),
    V("first v", Number(Any)),
    V("second u", Number(Any)),
    V("second v", Number(Any)),
    V("third u", Number(Any)),
    V("third v", Number(Any)),
];
const QUAD: &[V] = &[
    V("first corner", Vector(Any)),
    V("second corner", Vector(Any)),
    V("third corner", Vector(Any)),
    V("fourth corner", Vector(Any)),
];
const COLOR: Part =
    may("color", &[V("colour", Color(NotNegative))], "its colour: the part of the light that it sends back")
        .default("that of its material, or white");
const INSIDE: Part = may("inside", &[], "it is seen from the inside only");
const PATCHES: Part = may(
    "patches",
    &[V("patches along u", Whole(1, 1000)), V("patches along v", Whole(1, 1000))],
    "of each side: u goes from the first corner to the second, v to the fourth",
)
.default("1 1");
const ONE_SIDED: Part = may("one-sided", &[], "it is seen only from where its corners run counterclockwise");
const GOURAUD: Part = either(9, "gouraud", &[], "with normals: the light of its corners is mixed");
const BISHOP: Part =
    either(9, "bishop-weimer", &[], "with normals: cosines are expanded to the second order");

/// In the order in which a scene is written, but that a quad stands where its triangles do.
pub(super) const SHAPES: &[Statement] = &[
    object(
        "sphere",
        "A sphere",
        &[
            must("at", PLACE, "its centre"),
            must("radius", &[V("radius", Number(NotZero))], "below 0 it is seen from the inside only"),
            COLOR,
            OF,
            MOVES,
            ALONG,
        ],
    ),
    object(
        "ellipsoid",
        "An ellipsoid along the axes of the world",
        &[
            must("at", PLACE, "its centre"),
            must("radii", &[V("radii", Vector(Positive))], "along x, y and z"),
            INSIDE,
            COLOR,
            OF,
            MOVES,
            ALONG,
        ],
    ),
    object(
        "cylinder",
        "An endless vertical cylinder",
        &[
            must("at", PLACE, "a point of its axis, whose z plays no part"),
            must("radius", &[V("radius", Number(Positive))], "its radius"),
            COLOR,
            OF,
            MOVES,
            ALONG,
        ],
    ),
    object(
        "cone",
        "A cone or cylinder between two points",
        &[
            must("from", PLACE, "one end").tail(&[must(
                "radius",
                &[V("radius", Number(NotNegative))],
                "its radius there",
            )]),
            must("to", PLACE, "the other end").tail(&[must(
                "radius",
                &[V("radius", Number(NotNegative))],
                "its radius there",
            )]),
            INSIDE,
            may("capped", &[], "discs close its ends"),
            COLOR,
            OF,
            MOVES,
            ALONG,
        ],
    ),
    object(
        "triangle",
        "A triangle",
        &[
            must("", CORNERS, "its corners"),
            may("normals", NORMALS, "at the corners: it is shaded as if it were curved"),
            may("uv", UV, "texture coordinates of its corners"),
            ONE_SIDED,
            COLOR,
            OF,
            GOURAUD,
            BISHOP,
            MOVES,
            ALONG,
        ],
    ),
    object(
        "polygon",
        "A polygon, which may be concave; it is cut into triangles",
        &[
            must("", CORNERS, "its corners, in order")
                .more(MOST_CORNERS as usize, &[V("next corner", Vector(Any))]),
            may("normals", NORMALS, "one a corner")
                .more(MOST_CORNERS as usize, &[V("next normal", Vector(Any))]),
            ONE_SIDED,
            COLOR,
            OF,
            GOURAUD,
            BISHOP,
            MOVES,
            ALONG,
        ],
    ),
    object(
        "quad",
        "A convex quadrilateral, which radiosity divides into patches",
        &[
            must("", QUAD, "its corners, counterclockwise as its outside is seen"),
            PATCHES,
            may(
                "emitting",
                &[V("least u", Share), V("least v", Share), V("largest u", Share), V("largest v", Share)],
                "the part of it that emits, where its material does",
            )
            .default("all of it"),
            ONE_SIDED,
            COLOR,
            OF,
            MOVES,
            ALONG,
        ],
    ),
    object(
        "box",
        "A box along the axes of the world: six quads, below, above, at the least and largest x, and so along y",
        &[
            must("from", PLACE, "a corner"),
            must("to", PLACE, "the opposite corner"),
            PATCHES,
            may("inside", &[], "its outsides are inside: it is a room"),
            ONE_SIDED,
            COLOR,
            OF,
            MOVES,
            ALONG,
        ],
    ),
    object(
        "plane",
        "An infinite plane",
        &[
            must("at", PLACE, "a point of it"),
            must("normal", &[V("normal", Vector(Any))], "its normal, of any length"),
            COLOR,
            OF,
            MOVES,
            ALONG,
        ],
    ),
];
