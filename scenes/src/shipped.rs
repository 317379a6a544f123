//! The scenes that come with rta: the thesis's scene files, and one in NFF.

/// Eric Graham's Juggler (Amiga, 1987; used with his leave and this mention): 70 spheres, three of them mirrors.
pub const JUGGLER: &str = include_str!("../juggler.dat");

/// The Juggler with balls that fly, and an eye that moves a little, in the scene language.
pub const JUGGLING: &str = include_str!("../juggler.rta");

/// A hall of 22 objects, half of them mirrors, as the thesis timed on the RT PC.
pub const HALL_22: &str = include_str!("../hall-22.dat");

/// Two objects, one of them transparent, as the thesis timed on the SPARCstation and the PS/2.
pub const GLASS_2: &str = include_str!("../glass-2.dat");

/// All of the thesis's: file name and text.
pub const ALL: [(&str, &str); 3] =
    [("juggler.dat", JUGGLER), ("hall-22.dat", HALL_22), ("glass-2.dat", GLASS_2)];

/// The page about the scene language, with a scene for each keyword.
pub const PAGE: &str = include_str!("../README.md");

/// The picture files that scenes of the page name: names and contents, PNG.
pub const PICTURES: [(&str, &[u8]); 2] =
    [("evening.png", include_bytes!("../evening.png")), ("globe.png", include_bytes!("../globe.png"))];

/// A prism in front of a slit, in many wavelengths.
pub const PRISM: &str = include_str!("../prism.rta");

/// One vase four times: flat, and as Gouraud, Phong, and Bishop and Weimer shaded it.
pub const MESH: &str = include_str!("../mesh.rta");

/// One room that techniques of image synthesis from 1969 to 1988 are shown on.
pub const TECHNIQUES: &str = include_str!("../techniques.rta");

/// Spheres on a plane, `balls` of the second size of Eric Haines's Standard Procedural Databases (1987), in NFF.
pub const BALLS_2: &str = include_str!("../balls2.nff");

/// The scene files that pictures of the documents are drawn from, in a folder of their own with [`PICTURES`]: names and texts.
pub const FILES: [(&str, &str); 13] = [
    ("balls2.nff", BALLS_2),
    ("chrome.rta", include_str!("../chrome.rta")),
    ("cornell.rta", CORNELL),
    ("glass-2.dat", GLASS_2),
    ("glasses.rta", include_str!("../glasses.rta")),
    ("hall-22.dat", HALL_22),
    ("haze.rta", include_str!("../haze.rta")),
    ("juggler.dat", JUGGLER),
    ("juggler.rta", JUGGLING),
    ("mesh.rta", MESH),
    ("metals.rta", include_str!("../metals.rta")),
    ("prism.rta", PRISM),
    ("textures.rta", include_str!("../textures.rta")),
];

/// Small scenes whose rays spread, each in one way: names and texts.
pub const SPREADING: [(&str, &str); 4] = [
    ("penumbra", include_str!("../penumbra.rta")),
    ("gloss", include_str!("../gloss.rta")),
    ("lens", include_str!("../lens.rta")),
    ("motion", include_str!("../motion.rta")),
];

/// The Cornell box (C. Goral and others 1984; as it was measured later), lit by a quad that emits.
pub const CORNELL: &str = include_str!("../cornell.rta");
