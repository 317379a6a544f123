//! What texts mean.

use super::{EVERYTHING, FIRST, METALS, PRISM, accepted, scene};
use crate::description::{
    Attenuation, Axis, Camera, Coefficients, Dispersion, Fading, FallOff, Kind, LampShape, Medium, Model,
    Pattern, Side, Sky, Slope, Surface,
};
use crate::rta::{builtin, help, statements, table::Part};

#[test]
fn the_first_scene_is_what_it_says() {
    let first = accepted(FIRST);
    assert_eq!(first.camera, Camera::upright([0.0, -8.0, 2.0], [0.0, 1.0, -0.1], 1.2));
    assert_eq!(first.sky, Sky { horizon: [0.8, 0.87, 0.97], zenith: [0.15, 0.3, 0.65] });
    assert_eq!(first.ambient, [0.25; 3]);
    assert_eq!((first.lamps[0].color, first.lamps[0].fall_off), ([75.0; 3], FallOff::OfModel));
    let floor = first.floor.as_ref().expect("it has a floor");
    assert_eq!((floor.colors, floor.surface), ([[0.9; 3], [0.1; 3]], Surface::Opaque));
    let [shiny, crown] = first.spheres.as_slice() else { panic!("two spheres") };
    assert_eq!((shiny.color, shiny.surface, shiny.line), ([0.9, 0.2, 0.1], Surface::Shiny, 7));
    assert_eq!((crown.color, crown.surface), ([1.0; 3], Surface::Of(0)));
    assert_eq!((first.materials[0].kind, first.materials[0].index), (Kind::Glass, Some(1.52)));
    assert_eq!((first.model, first.raster), (Model::Rta, None));
    assert_eq!(first.warnings, []);
}

#[test]
fn the_metals_are_made_of_metals() {
    let metals = accepted(METALS);
    let [copper, gold] = metals.materials.as_slice() else { panic!("two materials") };
    let slope = |slope, share| Slope { slope, share };
    assert_eq!(copper.slopes, [slope(0.4, 0.4), slope(0.2, 0.6)]);
    assert_eq!((copper.kind, copper.gloss, gold.gloss), (Kind::Metal, Some(10.0), Some(18.0)));
    assert_eq!(gold.metal, Some([0.999, 0.728, 0.365]));
    assert_eq!(metals.spheres[1].color, [0.999, 0.728, 0.365]);
    // 20 degrees to either side of the longer one, which is the wider.
    assert!((metals.camera.focal - 0.5 / 20_f64.to_radians().tan()).abs() < 1e-12);
    assert_eq!((metals.camera.side, metals.camera.view), (Side::Width, [0.0, 9.0, -1.0]));
}

#[test]
fn the_prism_is_kept_and_told_once() {
    let prism = accepted(PRISM);
    assert_eq!(prism.raster, Some([640, 400]));
    let settings = &prism.settings;
    assert_eq!(
        (settings.screen, settings.samples, settings.wavelengths),
        (Some([4.0, 3.0]), Some(16), Some(9))
    );
    assert_eq!((prism.optics.focus, prism.optics.aperture), (Some(12.0), Some(0.05)));
    let fading = Fading::Haze([40.0, 200.0]);
    let haze = Attenuation { fading, from: None, color: Some([0.7, 0.75, 0.8]) };
    assert_eq!(prism.air.attenuation, Some(haze));
    let medium = Medium { extinction: [0.01, 0.01, 0.012], albedo: 0.9, anisotropy: 0.0, shadows: 16 };
    assert_eq!(prism.air.medium, Some(medium));
    let (lamp, edges) = (&prism.lamps[0], [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    assert_eq!(prism.details.lamps[&0], LampShape::Area { corner: [-4.0, -5.0, 7.0], edges });
    assert_eq!((lamp.position, lamp.color), ([-3.5, -4.5, 7.0], [60.0, 57.0, 54.0]));
    assert!((lamp.radius - core::f64::consts::FRAC_1_PI.sqrt()).abs() < 1e-12);
    let [flint, slab] = prism.materials.as_slice() else { panic!("two materials") };
    assert_eq!(flint.dispersion, Some(Dispersion::Abbe(33.0)));
    let left = flint.absorb.expect("it absorbs").map(|part| part.powi(10));
    assert!(left.iter().zip([0.9, 0.95, 0.9]).all(|(a, b)| (a - b).abs() < 1e-12), "{left:?}");
    assert_eq!((slab.texture.as_deref(), slab.bump.clone()), (Some("veins"), Some(("veins".into(), 0.05))));
    let Pattern::Marble { octaves, amount, .. } = prism.textures[0].pattern else { panic!("marble") };
    assert_eq!((octaves, amount, prism.textures[0].scale), (5, 2.5, 0.5));
    assert_eq!(prism.triangles.len(), 2);
    let mut told: Vec<_> = prism.warnings.iter().map(|warning| warning.text.as_str()).collect();
    told.sort_unstable();
    told.dedup();
    assert_eq!(told.len(), prism.warnings.len(), "{told:?}");
    assert!(told.iter().all(|text| !text.contains("not drawn")), "{told:?}");
}

#[test]
fn everything_is_somewhere() {
    let all = accepted(EVERYTHING);
    assert_eq!((all.camera.side, all.camera.up), (Side::Height, Some([0.0, 0.1, 1.0])));
    assert_eq!(
        (all.camera.eye, all.optics.shutter, all.optics.hither),
        ([1.0, -20.0, 3.0], Some([0.0, 0.5]), Some(0.1))
    );
    // The screen has the shape of its pixels.
    assert_eq!((all.raster, all.settings.screen, all.settings.depth), (Some([160, 100]), None, Some(3)));
    assert_eq!((all.model, all.settings.model_options[0].numbers.as_slice()), (Model::Bouknight, &[2.0][..]));
    assert_eq!(all.details.sky_map.as_deref(), Some("skies/evening # 1.png"));
    assert!((all.ambient[0] - 0.051_269_458).abs() < 1e-8);
    assert_eq!(all.air.medium.as_ref().map(|medium| medium.extinction), Some([0.01; 3]));
    let Pattern::Image { plane, nearest, .. } = all.textures[3].pattern else { panic!("an image") };
    assert_eq!((plane, nearest), (Some([Axis::X, Axis::Z]), true));
    let of = |name: &str| all.materials.iter().find(|material| material.name == name).expect(name);
    assert_eq!(
        (of("b").exponent, of("b").index, of("b").thin, of("a").thin),
        (Some(20.0), Some(1.4), true, false)
    );
    let half = of("b").absorb.expect("it absorbs")[0];
    assert!((half * half - 0.5).abs() < 1e-15);
    let sellmeier = Dispersion::Sellmeier { offset: 1.5, terms: vec![[0.2, 0.01], [0.3, 0.02]] };
    assert_eq!((of("c").dispersion.clone(), of("c").kind), (Some(sellmeier), Kind::Metal));
    assert_eq!((of("d").nk, of("d").slopes.len()), (Some([[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]]), 4));
    let [near, far, area] = all.lamps.as_slice() else { panic!("three lamps") };
    assert_eq!((near.color, near.fall_off), ([15.0, 30.0, 30.0], FallOff::Square));
    assert_eq!((far.fall_off, area.fall_off), (FallOff::Constant, FallOff::Constant));
    let [x, y, z] = far.position;
    assert!(x > 500.0 && (x + y).abs() < 1e-9 && (z - 2.0 * x).abs() < 1e-9, "{:?}", far.position);
    assert_eq!((all.spheres.len(), all.ellipsoids.len(), all.cones.len(), all.planes.len()), (1, 2, 1, 1));
    assert!(all.ellipsoids[0].inside_only && all.ellipsoids[0].radii == [1.0; 3] && all.cones[0].capped);
    assert_eq!((all.triangles.len(), all.details.objects.len()), (25, 30));
    let [swing, lift] = all.details.paths.as_slice() else { panic!("two paths") };
    assert_eq!((swing.linear, swing.keyframes.len(), lift.linear, lift.keyframes.len()), (false, 3, true, 2));
}

#[test]
fn every_keyword_is_in_the_scene_of_everything_and_in_the_help() {
    fn each(parts: &[Part], of: &str, check: &impl Fn(&str, &str)) {
        for part in parts {
            check(of, part.keyword);
            each(part.tail, of, check);
        }
    }
    let all = FIRST.to_owned() + METALS + PRISM + EVERYTHING;
    let words: Vec<_> = all.split_whitespace().collect();
    let help = help();
    for statement in statements::all() {
        assert!(words.contains(&statement.keyword), "{}", statement.keyword);
        assert!(help.contains(&format!("\n{}: {}", statement.keyword, statement.about)));
        each(statement.parts, statement.keyword, &|of, keyword| {
            assert!(keyword.is_empty() || words.contains(&keyword), "{of} {keyword}");
            assert!(help.contains(&format!("    {keyword}")), "{of} {keyword}");
        });
    }
    for name in builtin::names() {
        assert!(help.contains(name) && builtin::material(name).is_some(), "{name}");
    }
}

#[test]
fn built_in_materials_have_the_coefficients_of_the_law() {
    let of = |name| builtin::material(name).expect(name).coefficients();
    let Some(Coefficients { kd, ks, kt, index, .. }) = of("diamond") else { panic!("coefficients") };
    assert_eq!((kd, ks, kt, index), (0.0, 0.1, 0.9, 2.4173));
    let Some(Coefficients { kd, ks, kt, .. }) = of("iron") else { panic!("coefficients") };
    assert_eq!((kd, ks, kt), (0.4, 0.6, 0.0));
    let Some(Coefficients { kd, ks, .. }) = of("plastic") else { panic!("coefficients") };
    assert_eq!((kd, ks), (0.8, 0.2));
    assert_eq!(builtin::material("ink").expect("ink").absorb, Some([0.15, 0.3, 0.9]));
    // The dispersions give the stated index near the D line.
    for name in builtin::names() {
        let material = builtin::material(name).expect(name);
        if let Some(Dispersion::Sellmeier { offset, terms }) = &material.dispersion {
            let square = 0.5893_f64.powi(2);
            let sum: f64 = terms.iter().map(|[b, c]| b * square / (square - c)).sum();
            let index = (offset + sum).sqrt();
            assert!((index - material.index.expect(name)).abs() < 3e-4, "{name}: {index}");
        }
    }
}

#[test]
fn what_is_seldom_meant_is_told() {
    let told = |lines: &str| {
        let scene = scene(&format!("lamp at 0 0 9\n{lines}"));
        scene.warnings.into_iter().map(|warning| warning.text).collect::<Vec<_>>()
    };
    assert_eq!(told("material a diffuse .6 specular .4"), Vec::<String>::new());
    assert!(
        told("material a diffuse .8 specular .4")[0]
            .starts_with("diffuse, specular and transmit add up to 1.2")
    );
    assert!(told("material a specular .1 exponent 2000")[0].contains("larger than 1000"));
    assert_eq!(told("material a specular 0 exponent 2000"), Vec::<String>::new());
    let many = told("sphere at 0 0 1 radius 1 color 2 1 1\nsphere at 0 0 1 radius 1 color 255 1 1");
    assert_eq!(
        many,
        ["the colour of this sphere has a register of 2: colours go from 0 to 1; and 1 others more like it"
            .replace("others ", "")]
    );
    assert!(told("triangle 0 0 0 1 1 1 2 2 2")[0].contains("has no area"));
    assert_eq!(told("model newell edge 2"), Vec::<String>::new());
}

#[test]
fn the_angle_lies_across_the_longer_side() {
    let camera = |picture: &str| {
        super::accepted(&format!("rta 1\ncamera at 0 0 0 look 0 1 0 angle 90\n{picture}")).camera
    };
    for (picture, side) in [
        ("", Side::Width),
        ("picture 100 200", Side::Width),
        ("picture 100 200 screen 1 2", Side::Height),
        ("picture 200 100 screen 3 4", Side::Height),
    ] {
        let camera = camera(picture);
        assert_eq!(camera.side, side, "{picture}");
        assert!((camera.focal - 0.5).abs() < 1e-12);
    }
}
