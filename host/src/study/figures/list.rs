//! The figures, in the order of the page. A new one is its entry here and the function that it names.

use super::Content::{Curves, Picture};
use super::{Figure, cones, curves, meshes, pictures};

/// All figures.
pub const ALL: &[Figure] = &[
    Figure {
        name: "refraction",
        place: "Figure 2.5",
        title: "Index of refraction over the wavelength",
        caption: "Glass bends blue light more than red. The steeper a curve, the wider the spectrum behind a prism: flint is chosen where \
                  colours are to be parted, quartz and crown where they are not.",
        formula: "n² = 1 + Σ B λ² / (λ² − C) (Sellmeier); n = A + B / λ² through the index at 587.6 nm by Abbe's number (Cauchy)",
        source: "Daimon and Masumura 2007; Rheims 1997; Malitson 1965; Li 1976; Chemnitz 2017; Halliday and Resnick.",
        content: Curves(curves::refraction),
    },
    Figure {
        name: "distributions",
        place: "Figure 2.8",
        title: "Distributions of facets",
        caption: "All four have half of their facets at 10 degrees, so that their highlights are of one size. Beyond that Trowbridge's has by \
                  far the most facets: its highlights have a wide, faint rim.",
        formula: "power (cos α)ⁿ; gauss exp(−(c α)²); trowbridge (c² / (cos² α (c² − 1) + 1))²; beckmann exp(−tan² α / m²) / (m² cos⁴ α)",
        source: "Blinn 1977; Torrance and Sparrow 1967; Trowbridge and Reitz 1975; Beckmann and Spizzichino 1963; Hall 1989.",
        content: Curves(curves::distributions),
    },
    Figure {
        name: "mach-bands",
        place: "Figure 3.2",
        title: "The terminator with and without an exponent",
        caption: "Lambert's light has a kink where N.L becomes 0, and the eye sees a dark band there that does not exist (Mach). With any \
                  exponent above 1 the slope begins at 0 and the band is gone.",
        formula: "I = C (ka Ia + kd (N.L)ᵖ)",
        source: "Bouknight 1970.",
        content: Curves(curves::mach_bands),
    },
    Figure {
        name: "terminators",
        place: "Figure 3.2",
        title: "Mach's band on a ball",
        caption: "One ball and one lamp, on the right, by two models with their own shares of ambient and diffuse light. By \
                  Lambert's a line is seen at the terminator, by Bouknight's none.",
        formula: "lambert: C (ka Ia + kd N.L); bouknight: C (ka Ia + kd (N.L)^1.25)",
        source: "Lambert 1760; Bouknight 1970.",
        content: Picture(pictures::terminators),
    },
    Figure {
        name: "gouraud-phong",
        place: "Figure 3.4",
        title: "Gouraud's shading beside Phong's",
        caption: "Two triangles stand for a part of a cylinder. Gouraud interpolates the cosines of the vertices: there is a kink at the edge, and \
                  the brightest place can only be a vertex. Phong interpolates the normals, and nearly meets the cylinder.",
        formula: "Gouraud Σ bᵢ (Nᵢ.L); Phong N.L with N = Σ bᵢ Nᵢ / |Σ bᵢ Nᵢ|",
        source: "Gouraud 1971; Phong 1975.",
        content: Curves(curves::gouraud),
    },
    Figure {
        name: "masking",
        place: "Section 2.3.7",
        title: "Facets in shadow or hidden",
        caption: "Between grooves in the shape of a V the light falls off with kinks, and the slope of the facets does not matter. By \
                  Sancer's formula it falls off smoothly, and rougher surfaces hide more.",
        formula: "Torrance, Sparrow min(1, 2 (N.H)(N.V) / (V.H), 2 (N.H)(N.L) / (V.H)); Sancer 1 / (1 + U(N.L) + U(N.V)), U(c) = exp(−A²) / (2 A √π) \
                  − erfc(A) / 2, A = c / (m √(1 − c²))",
        source: "Torrance and Sparrow 1967; Sancer 1969.",
        content: Curves(curves::masking),
    },
    Figure {
        name: "mesh",
        place: "Sections 3.5.5 and 3.5.6",
        title: "A mesh in four ways",
        caption: "Flat faces; the light of the corners mixed, which loses the highlight where no corner is in it; the normals mixed; and cosines \
                  expanded to the second order about the middle of each triangle, which is nearly the same.",
        formula: "Gouraud Σ bᵢ Iᵢ; Phong I(Σ bᵢ Nᵢ / |Σ bᵢ Nᵢ|); Bishop and Weimer I to the second order in bᵢ − ⅓",
        source: "Gouraud 1971; Phong 1975; Bishop and Weimer 1986.",
        content: Picture(pictures::mesh),
    },
    Figure {
        name: "mesh-error",
        place: "Section 3.5.5",
        title: "Error of a mesh over its fineness",
        caption: "A ball is cut into 2 N x N quadrilaterals and compared with the ball itself. All three ways err by the square of the size of \
                  a face; Gouraud's needs more faces for the same error.",
        formula: "mean |ΔI| over the picture, whitted with exponent 8, eye and lamp far away",
        source: "Gouraud 1971; Phong 1975; Bishop and Weimer 1986.",
        content: Curves(meshes::errors),
    },
    Figure {
        name: "prism",
        place: "Section 3.6.2",
        title: "A prism",
        caption: "White light comes through slits; a prism of dense flint bends blue more than red and spreads it.",
        formula: "sin θ / sin θ' = n(λ), by Abbe's number; fifteen wavelengths, each with a weight of its own in the three registers",
        source: "Newton 1704; Wyman, Sloan and Shirley 2013.",
        content: Picture(pictures::prism),
    },
    Figure {
        name: "cones",
        place: "Section 3.6",
        title: "One cone over each pixel",
        caption: "From the left: one cone, one ray, 64 rays, and four times the difference of the first from the third, about grey. Edges are \
                  smooth, also in mirrors. Wrong are places where things meet or are before each other, shadows of lamps without a radius, \
                  the rims of curved mirrors and glass, and what rough surfaces show.",
        formula: "Δα = 2 ρ / K of what a mirror of the radius K reflects; part = lens(ρ, R, q) / π ρ² of a ball; the product of what things leave",
        source: "Amanatides 1984.",
        content: Picture(cones::sheet),
    },
    Figure {
        name: "fresnel-glasses",
        place: "Section 2.3.7",
        title: "Reflectance of glasses",
        caption: "Seen straight on glass reflects a few hundredths of the light, and at a grazing angle all of it.",
        formula: "F = ½ ((g − c) / (g + c))² (1 + ((c (g + c) − 1) / (c (g − c) + 1))²), c = cos θ, g² = n² + c² − 1",
        source: "Fresnel's equations as Cook and Torrance 1982 have them; indices as in figure 2.5, diamond Peter 1923.",
        content: Curves(curves::glasses),
    },
    Figure {
        name: "fresnel-metals",
        place: "Section 2.3.7",
        title: "Reflectance of metals in three registers",
        caption: "A metal has its colour where it is seen straight on. At a grazing angle all registers go to 1: its highlights turn white there.",
        formula: "Fresnel's equations with the complex index n − i k at 611, 549 and 464 nm",
        source: "Johnson and Christy 1972; Cook and Torrance 1982.",
        content: Curves(curves::metals),
    },
    Figure {
        name: "fresnel-green",
        place: "Section 2.3.7",
        title: "Reflectance of five metals in green light",
        caption: "Silver and aluminium send back nearly all light, whatever its colour; iron half of it. Each dips before it goes to 1.",
        formula: "Fresnel's equations with the complex index n − i k at 549 nm",
        source: "Johnson and Christy 1972 and 1974; Rakic 1995.",
        content: Curves(curves::five_metals),
    },
    Figure {
        name: "attenuation",
        place: "Section 3.5.2",
        title: "What is left of light on its way to the eye",
        caption: "Warnock and Romney let far things sink into black. Haze begins and ends at a distance of its own, fog takes the same part \
                  of the light on each piece of the way.",
        formula: "warnock min(1, d₀ / d); romney p min(1, (d₀ / d)ᵖ); haze i t 1 − (d − i) / (t − i); fog s exp(−s d)",
        source: "Warnock 1969; Romney 1970; Bouguer and Beer.",
        content: Curves(curves::attenuation),
    },
    Figure {
        name: "models",
        place: "Chapter 3",
        title: "One ball in every model",
        caption: "The models of the program, each with its defaults. They draw one scene, whose lamp does not fade.",
        formula: "as rta models lists them",
        source: "As the names under the pictures say.",
        content: Picture(pictures::models),
    },
    Figure {
        name: "textures",
        place: "Section 3.5.6",
        title: "Solid textures",
        caption: "Checker, marble and wood fill space; a surface shows where it cuts them, without seams.",
        formula: "checker ⌊x⌋ + ⌊y⌋ + ⌊z⌋ mod 2; marble wave(x + a turbulence); wood wave(√(x² + y²) + a noise)",
        source: "Perlin 1985; Peachey 1985.",
        content: Picture(pictures::textures),
    },
];
