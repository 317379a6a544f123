//! The materials that every scene knows.

use crate::description::{Dispersion, Kind, Material, Slope, Surface};

/// A glass: its index near the D line, and how that depends on the wavelength.
struct Glass {
    name: &'static str,
    index: f64,
    dispersion: Curve,
}

/// How an index depends on the wavelength.
enum Curve {
    Unknown,
    /// Cauchy's formula, by the Abbe number.
    Abbe(f64),
    /// Cauchy's formula with three terms.
    Cauchy([f64; 3]),
    /// Sellmeier's formula: the first term, then B, and C in square micrometres.
    Sellmeier(f64, &'static [[f64; 2]]),
    /// Sellmeier's formula: the first term, then B, and the root of C in micrometres.
    Roots(f64, &'static [[f64; 2]]),
}

const fn glass(name: &'static str, index: f64, dispersion: Curve) -> Glass {
    Glass { name, index, dispersion }
}

/// Clear glasses and liquids. `crown`, `dense-flint` and `rock-salt-thesis` are as the thesis has them, from Halliday and
/// Resnick, "Physics"; the others are the measurements named beside them.
const GLASSES: &[Glass] = &[
    glass("vacuum", 1.0, Curve::Unknown),
    glass("air", 1.00028, Curve::Unknown), // Ciddor 1996, 15 C
    glass("ice", 1.3097, Curve::Unknown),  // Warren and Brandt 2008
    glass("water", 1.3334, Curve::Sellmeier(1.0, &WATER)), // Daimon and Masumura 2007, 20 C
    glass("ethyl-alcohol", 1.3617, Curve::Cauchy([1.35265, 0.00306, 0.00002])), // Rheims 1997
    glass("fused-quartz", 1.4584, Curve::Roots(1.0, &QUARTZ)), // Malitson 1965
    glass("crown", 1.52, Curve::Abbe(59.0)),
    glass("bk7", 1.5168, Curve::Sellmeier(1.0, &BK7)), // Schott 2017
    glass("rock-salt", 1.5443, Curve::Roots(1.00055, &SALT)), // Li 1976
    glass("rock-salt-thesis", 1.53, Curve::Unknown),
    glass("carbon-disulfide", 1.6281, Curve::Roots(1.0, &DISULFIDE)), // Chemnitz 2017
    glass("dense-flint", 1.66, Curve::Abbe(33.0)),
    glass("sf2", 1.6477, Curve::Sellmeier(1.0, &SF2)), // Schott 2017
    glass("methylene-iodide", 1.74, Curve::Unknown),   // Halliday and Resnick
    glass("diamond", 2.4173, Curve::Roots(1.0, &DIAMOND)), // Peter 1923
];

const WATER: [[f64; 2]; 4] = [
    [0.5684027565, 0.005101829712],
    [0.1726177391, 0.01821153936],
    [0.02086189578, 0.02620722293],
    [0.1130748688, 10.69792721],
];
const QUARTZ: [[f64; 2]; 3] = [[0.6961663, 0.0684043], [0.4079426, 0.1162414], [0.8974794, 9.896161]];
const BK7: [[f64; 2]; 3] =
    [[1.03961212, 0.00600069867], [0.231792344, 0.0200179144], [1.01046945, 103.560653]];
const SALT: [[f64; 2]; 7] = [
    [0.198, 0.05],
    [0.48398, 0.1],
    [0.38696, 0.128],
    [0.25998, 0.158],
    [0.08796, 40.5],
    [3.17064, 60.98],
    [0.30038, 120.34],
];
const DISULFIDE: [[f64; 2]; 2] = [[1.499426, 0.178763], [0.089531, 6.591946]];
const SF2: [[f64; 2]; 3] =
    [[1.40301821, 0.0105795466], [0.231767504, 0.0493226978], [0.939056586, 112.405955]];
const DIAMOND: [[f64; 2]; 2] = [[0.3306, 0.175], [4.3356, 0.106]];

/// Glasses that colour what comes through, by what is left after one unit of length. Made for pictures, measured nowhere.
const TINTED: [(&str, [f64; 3]); 4] = [
    ("bottle", [0.55, 0.90, 0.60]),
    ("amber", [0.95, 0.70, 0.25]),
    ("smoke", [0.6, 0.6, 0.6]),
    ("ink", [0.15, 0.3, 0.9]),
];

/// What tinted glasses refract by.
const TINTED_INDEX: f64 = 1.5;

/// A metal: what it reflects at perpendicular incidence under D65, in linear sRGB, and its optical constants n and k at 611, 549 and 464
/// nm, the wavelengths that look like the three registers.
struct Metal {
    name: &'static str,
    reflected: [f64; 3],
    nk: [[f64; 2]; 3],
}

const COPPER: Metal = Metal {
    name: "copper", // Johnson and Christy 1972
    reflected: [0.932, 0.623, 0.522],
    nk: [[0.3669, 3.1213], [1.0162, 2.5785], [1.2464, 2.4520]],
};

const METALS: [Metal; 5] = [
    Metal {
        name: "gold", // Johnson and Christy 1972
        reflected: [0.999, 0.728, 0.365],
        nk: [[0.2234, 3.2036], [0.4283, 2.4599], [1.3353, 1.8725]],
    },
    Metal {
        name: "silver", // Johnson and Christy 1972
        reflected: [0.989, 0.984, 0.978],
        nk: [[0.0583, 4.1029], [0.0599, 3.5892], [0.0464, 2.7925]],
    },
    COPPER,
    Metal {
        name: "aluminium", // Rakic 1995
        reflected: [0.907, 0.916, 0.922],
        nk: [[1.3195, 7.3068], [1.0109, 6.6157], [0.6825, 5.6230]],
    },
    Metal {
        name: "iron", // Johnson and Christy 1974
        reflected: [0.530, 0.513, 0.494],
        nk: [[2.8903, 3.0397], [2.9500, 2.9300], [2.6420, 2.8025]],
    },
];

/// The angle, in degrees, at which the highlights of metals have half their strength.
const METAL_GLOSS: f64 = 10.0;

/// Cook and Torrance 1982: share of microfacets s and their slope m. The diffuse coefficient is 1 - s.
const PAPER: [(&str, f64, f64); 6] = [
    ("carbon", 0.3, 0.4),
    ("rubber", 0.4, 0.3),
    ("obsidian", 0.8, 0.15),
    ("army-olive", 0.3, 0.5),
    ("ironox", 0.2, 0.35),
    ("copper-plastic", 0.1, 0.15),
];

/// Returns what an object of a built-in material is made of, if there is one of this name: one of the thesis's types, or a material.
pub(super) fn surface(name: &str) -> Option<Result<Surface, Material>> {
    match name {
        "opaque" => Some(Ok(Surface::Opaque)),
        "shiny" => Some(Ok(Surface::Shiny)),
        "mirror" => Some(Ok(Surface::Mirror)),
        _ => material(name).map(Err),
    }
}

/// Returns the built-in material of this name, if there is one.
pub fn material(name: &str) -> Option<Material> {
    let named = Material { name: name.into(), ..Material::default() };
    let of_kind = |kind| Material { kind, ..named.clone() };
    match name {
        "opaque" => return Some(named),
        "shiny" => return Some(of_kind(Kind::Shiny)),
        "mirror" => return Some(of_kind(Kind::Mirror)),
        "matte" => return Some(Material { diffuse: Some(1.0), ..named }),
        "plastic" => {
            let (diffuse, specular, gloss, index) = (Some(0.8), Some(0.2), Some(8.0), Some(1.5));
            return Some(Material { diffuse, specular, gloss, index, ..of_kind(Kind::Shiny) });
        }
        // A metal of two slopes (Cook and Torrance 1982).
        "cook-copper" => {
            let slopes = vec![Slope { slope: 0.4, share: 0.4 }, Slope { slope: 0.2, share: 0.6 }];
            return Some(Material { slopes, specular: Some(1.0), ..metal(named, &COPPER) });
        }
        // Without microfacets (Cook and Torrance 1982).
        "lunar-dust" => return Some(Material { diffuse: Some(1.0), specular: Some(0.0), ..named }),
        _ => {}
    }
    if let Some(Glass { index, dispersion, .. }) = GLASSES.iter().find(|glass| glass.name == name) {
        let sellmeier = |offset, terms| Some(Dispersion::Sellmeier { offset, terms });
        let dispersion = match *dispersion {
            Curve::Unknown => None,
            Curve::Abbe(number) => Some(Dispersion::Abbe(number)),
            Curve::Cauchy(terms) => Some(Dispersion::Cauchy(terms)),
            Curve::Sellmeier(offset, terms) => sellmeier(offset, terms.to_vec()),
            Curve::Roots(offset, terms) => {
                sellmeier(offset, terms.iter().map(|[b, c]| [*b, c * c]).collect())
            }
        };
        return Some(Material { index: Some(*index), dispersion, ..of_kind(Kind::Glass) });
    }
    if let Some((_, left)) = TINTED.iter().find(|(own, _)| *own == name) {
        let (index, absorb) = (Some(TINTED_INDEX), Some(*left));
        return Some(Material { index, absorb, ..of_kind(Kind::Glass) });
    }
    if let Some(own) = METALS.iter().find(|own| own.name == name) {
        return Some(metal(named, own));
    }
    let (_, share, slope) = *PAPER.iter().find(|(own, ..)| *own == name)?;
    let slopes = vec![Slope { slope, share: 1.0 }];
    let (diffuse, specular) = (Some(1.0 - share), Some(share));
    let like = Material { diffuse, specular, slopes, ..of_kind(Kind::Shiny) };
    Some(match name {
        // With the reflectance of vinyl, 0.04.
        "copper-plastic" => Material { color: Some(COPPER.reflected), index: Some(1.5), ..like },
        _ => like,
    })
}

fn metal(named: Material, &Metal { reflected, nk, .. }: &Metal) -> Material {
    let (metal, color, nk) = (Some(reflected), Some(reflected), Some(nk));
    Material { kind: Kind::Metal, metal, nk, color, gloss: Some(METAL_GLOSS), ..named }
}

/// Returns the names of all built-in materials.
pub(super) fn names() -> impl Iterator<Item = &'static str> {
    let simple = ["opaque", "shiny", "mirror", "plastic", "matte"].into_iter();
    let glasses = GLASSES.iter().map(|glass| glass.name).chain(TINTED.iter().map(|(name, _)| *name));
    let metals = METALS.iter().map(|metal| metal.name);
    let paper = ["cook-copper", "lunar-dust"].into_iter().chain(PAPER.iter().map(|(name, ..)| *name));
    simple.chain(glasses).chain(metals).chain(paper)
}
