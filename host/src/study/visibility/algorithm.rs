//! The list of algorithms.

use super::integer::View;
use super::outcome::{LeftOut, Outcome};
use super::{casting, painter, scanline, scanplane, subdivision, zbuffer};

/// An algorithm that tells what is seen at each pixel.
#[derive(Clone, Copy, Debug)]
pub struct Algorithm {
    /// Its name.
    pub name: &'static str,
    /// Who published it.
    pub source: &'static str,
    /// Whether it is exact; else its ids may be others within 1e-9 of an edge.
    pub is_exact: bool,
    /// Draws.
    pub draw: fn(&View) -> Result<Outcome, LeftOut>,
}

const fn exact(
    name: &'static str,
    source: &'static str,
    draw: fn(&View) -> Result<Outcome, LeftOut>,
) -> Algorithm {
    Algorithm { name, source, is_exact: true, draw }
}

/// All algorithms, and two of them in two forms. The first that is run is what the others are compared with.
pub const ALL: [Algorithm; 8] = [
    exact("ray casting", "Appel 1968", casting::exhaustive),
    exact("ray casting by boxes", "a hierarchy of them", casting::by_hierarchy),
    exact("z-buffer", "Catmull 1974", zbuffer::whole),
    exact("z-buffer by rows", "one row in memory", zbuffer::banded),
    exact("painter", "Fuchs, Kedem and Naylor 1980", painter::painted),
    exact("scan-line", "Bouknight 1970, Watkins 1970", scanline::scanned),
    exact("area subdivision", "Warnock 1969", subdivision::subdivided),
    Algorithm { is_exact: false, ..exact("scan-plane", "Hamlin and Gear 1977", scanplane::swept) },
];
