//! Materials and textures.

use proptest::prelude::*;
use rta_scenes::description::{Axis, Dispersion, Edge, Kind, Material, Pattern, Slope, Texture};

use super::{color, maybe, place, positive};

fn dispersion() -> impl Strategy<Value = Dispersion> {
    let terms = prop::collection::vec([0.0..=2.0, 0.0..=200.0_f64], 1..4);
    let offset = prop_oneof![Just(1.0), 0.5..=2.0];
    prop_oneof![
        positive().prop_map(Dispersion::Abbe),
        (offset, terms).prop_map(|(offset, terms)| Dispersion::Sellmeier { offset, terms }),
    ]
}

pub(super) fn material() -> impl Strategy<Value = Material> {
    let kind = prop_oneof![
        Just(Kind::Opaque),
        Just(Kind::Shiny),
        Just(Kind::Mirror),
        Just(Kind::Glass),
        Just(Kind::Metal)
    ];
    let name = prop_oneof!["[a-z][a-z0-9-]{0,3}", Just("gold".to_owned()), Just("No Name".to_owned())];
    let shares = (
        maybe(0.0..=1.0),
        maybe(0.0..=2.0),
        maybe(0.0..=1.0),
        maybe(0.0..=2.0),
        maybe(0.0..=2.0),
        maybe(0.0..=1.0),
    );
    let one = (0.01..=1.0).prop_map(|slope| vec![Slope { slope, share: 1.0 }]);
    let two = (0.01..=1.0, 0.01..=1.0, 0.0..=1.0).prop_map(|(first, second, share)| {
        vec![Slope { slope: first, share }, Slope { slope: second, share: 1.0 - share }]
    });
    let slopes = prop_oneof![Just(Vec::new()), one, two];
    let rough = maybe(0.0..=1.0);
    let facets =
        (maybe(0.0..=2000.0), maybe(0.1..=44.0), rough, slopes, maybe(positive()), maybe(dispersion()));
    let nk = prop::array::uniform3([0.1..=3.0, 0.0..=9.0_f64]);
    let edge =
        (1..=3_u8, 0.0..=1.0, 0.0..=1.0).prop_map(|(exponent, least, most)| Edge { exponent, least, most });
    let absorb = prop::array::uniform3(1e-9..=1.0_f64);
    let rest = (
        [maybe(color()), maybe(color())],
        maybe(nk),
        maybe(absorb),
        maybe(edge),
        prop::array::uniform3(any::<bool>()),
        maybe(-1.0..=1.0),
    );
    (name, kind, maybe(color()), shares, facets, rest).prop_map(
        |(name, kind, color, shares, facets, rest)| {
            let (ambient, diffuse, back, specular, transmit, mirror) = shares;
            let (exponent, gloss, roughness, slopes, index, dispersion) = facets;
            let ([metal, emits], nk, absorb, edge, [thin, surroundings, has_texture], bump) = rest;
            Material {
                name,
                kind,
                color,
                ambient,
                diffuse,
                back,
                specular,
                transmit,
                mirror,
                exponent,
                gloss,
                roughness,
                slopes,
                index,
                dispersion,
                metal,
                nk,
                absorb,
                edge,
                thin,
                emits,
                surroundings,
                texture: has_texture.then(|| "t0".into()),
                bump: bump.map(|height| ("t1".into(), height)),
                line: 0,
            }
        },
    )
}

pub(super) fn textures() -> impl Strategy<Value = Vec<Texture>> {
    let colors = || [color(), color()];
    let axis = || prop_oneof![Just(Axis::X), Just(Axis::Y), Just(Axis::Z)];
    let pattern = prop_oneof![
        colors().prop_map(Pattern::Checker),
        (colors(), 1..=16_u32, 0.0..=9.0).prop_map(|(colors, octaves, amount)| Pattern::Marble {
            colors,
            octaves,
            amount
        }),
        (colors(), 0.0..=9.0).prop_map(|(colors, amount)| Pattern::Wood { colors, amount }),
        ("[a-zA-Z #/.é]{0,9}", any::<bool>(), maybe([axis(), axis()]))
            .prop_map(|(file, nearest, plane)| Pattern::Image { file, nearest, plane }),
    ];
    prop::collection::vec((pattern, place(), positive()), 2..4).prop_map(|all| {
        let texture = |(number, (pattern, at, scale))| Texture {
            name: format!("t{number}"),
            pattern,
            at,
            scale,
            line: 0,
        };
        all.into_iter().enumerate().map(texture).collect()
    })
}
