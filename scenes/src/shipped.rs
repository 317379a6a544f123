//! The scenes that come with rta: the thesis's scene files, and one in NFF.

/// Eric Graham's Juggler (Amiga, 1987; used with his leave and this mention): 70 spheres, three of them mirrors.
pub const JUGGLER: &str = include_str!("../juggler.dat");

/// A hall of 22 objects, half of them mirrors, as the thesis timed on the RT PC.
pub const HALL_22: &str = include_str!("../hall-22.dat");

/// Two objects, one of them transparent, as the thesis timed on the SPARCstation and the PS/2.
pub const GLASS_2: &str = include_str!("../glass-2.dat");

/// All of the thesis's: file name and text.
pub const ALL: [(&str, &str); 3] =
    [("juggler.dat", JUGGLER), ("hall-22.dat", HALL_22), ("glass-2.dat", GLASS_2)];

/// Spheres on a plane, `balls` of the second size of Eric Haines's Standard Procedural Databases (1987), in NFF.
pub const BALLS_2: &str = include_str!("../balls2.nff");
