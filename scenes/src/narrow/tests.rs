//! What does not fit a format is named.

#![allow(clippy::indexing_slicing)] // a test may panic

use rta_core::Q16;

use super::*;
use crate::model::Model;
use crate::{dat, shipped};

fn refused(edit: impl Fn(&mut Description)) -> String {
    let mut scene = dat::read(shipped::GLASS_2.as_bytes(), "glass-2.dat").expect("a shipped scene");
    edit(&mut scene);
    match narrow::<Q16>(&scene, 1.0) {
        Ok(_) => "admitted".into(),
        Err(error) => error.to_string(),
    }
}

#[test]
fn errors_name_object_number_and_limit() {
    assert_eq!(refused(|_| ()), "admitted");
    assert_eq!(
        refused(|s| s.spheres[1].position[0] = -40000.0),
        "sphere 2 (line 9) is out of q16's range: x (with the radius) 40000.9, beyond the largest 32767.9"
    );
    assert_eq!(
        refused(|s| s.spheres[0].radius = 1e-5),
        "sphere 1 (line 8) is out of q16's range: the radius 1e-5, below the smallest 0.000244141"
    );
    assert!(
        refused(|s| s.lamps[1].color[2] = 1e12)
            .starts_with("lamp 2 (line 12) is out of q16's range: the intensity")
    );
    assert!(refused(|s| s.camera.eye[2] = 1e300).starts_with("the observer is out of q16's range: z"));
    assert!(refused(|s| s.sky.zenith[2] = 1e6).starts_with("the zenith is out of q16's range"));
    assert!(refused(|s| s.spheres[0].color[1] = 2.0).contains("beyond the largest 1.99"));
}

/// Returns how rough a ball of a material is under a model with options.
fn roughness(model: &str, material: &str) -> f64 {
    let text = format!(
        "rta 1\nmodel {model}\ncamera at 0 -5 1  look 0 1 0\nmaterial m {material}\nsphere at 0 0 1  radius 1  of m\n"
    );
    let scene = crate::read(text.as_bytes(), "lobes.rta").expect("a scene");
    let narrowed = narrow::<f64>(&scene, 1.0).expect("it is small");
    narrowed.spreads.roughness.first().copied().unwrap_or(0.0)
}

#[test]
fn models_spread_mirror_rays_by_their_own_lobes_where_they_are_asked() {
    // Trowbridge's c is the roughness, and half of the facets at an angle are half at the same angle of others.
    let ten = crate::gloss::trowbridge(10.0);
    for (model, material, exact) in [
        ("blinn-full trowbridge .4", "like mirror", 0.0),
        ("blinn-full lobes", "like mirror", 0.260_495),
        ("blinn-full trowbridge .4 lobes", "like mirror", 0.4),
        ("blinn-full trowbridge .4 lobes", "like mirror  roughness .1", 0.1),
        ("blinn-full trowbridge .4 lobes", "like mirror  roughness 0", 0.0),
        ("blinn-full trowbridge .4 lobes", "like mirror  gloss 10", ten),
        ("blinn-full trowbridge .4 gloss 10 lobes", "like mirror", ten),
        ("blinn-full trowbridge .4 lobes", "color 1 1 1", 0.0),
        ("blinn-full power lobes", "like mirror", 0.260_495),
        ("blinn-full power 45.278 lobes", "like mirror", ten),
        ("blinn-full power lobes", "like mirror  gloss 10", ten),
        ("blinn-full gauss 4.7702 lobes", "like mirror", ten),
        ("blinn-full gauss lobes", "like mirror  gloss 10", ten),
        // Nearly a half-space of facets is as rough as can be.
        ("blinn-full gauss .01 lobes", "like mirror", crate::gloss::trowbridge(89.0)),
        ("cook-torrance", "like mirror  slope .2", 0.0),
        ("cook-torrance lobes", "like mirror", 0.3),
        ("cook-torrance lobes", "like mirror  slope .2", 0.2),
        ("cook-torrance lobes", "like mirror  slope .1 share .36  slope .5 share .64", 0.404_474_968),
        ("cook-torrance gloss 10 lobes", "like mirror", crate::gloss::beckmann(10.0)),
        ("cook-torrance lobes", "color 1 1 1", 0.0),
        ("cook-torrance lobes", "color 1 1 1  specular .2  slope .2", 0.2),
    ] {
        let own = roughness(model, material);
        assert!((own - exact).abs() < 1e-5, "{model}, {material}: {own}, {exact}");
    }
    assert!((ten - 0.260_495).abs() < 1e-5);
}

#[test]
fn grooves_are_spread_by_their_own_slopes() {
    let slopes = |model: &str, material: &str| {
        let text = format!(
            "rta 1\nmodel {model}\ncamera at 0 -5 1  look 0 1 0\nmaterial m {material}\nsphere at 0 0 1  radius 1  of m\n"
        );
        let scene = crate::read(text.as_bytes(), "lobes.rta").expect("a scene");
        let spreads = narrow::<f64>(&scene, 1.0).expect("it is small").spreads;
        let own = spreads.slopes.first().copied().into_iter().flatten().filter(|slope| slope.share > 0.0);
        own.map(|slope| (slope.share, (1e6 / slope.inverse).round() / 1e6)).collect::<Vec<_>>()
    };
    for (model, material, exact) in [
        ("cook-torrance", "like mirror  slope .2", vec![]),
        ("cook-torrance lobes", "like mirror", vec![(1.0, 0.3)]),
        (
            "cook-torrance lobes",
            "like mirror  slope .1 share .25  slope .5 share .75",
            vec![(0.25, 0.1), (0.75, 0.5)],
        ),
        ("cook-torrance lobes", "like mirror  slope .2  roughness .2", vec![]),
        ("cook-torrance lobes sancer", "like mirror  slope .2", vec![]),
        ("cook-torrance lobes", "color 1 1 1", vec![]),
        ("blinn-full lobes", "like mirror", vec![]),
    ] {
        assert_eq!(slopes(model, material), exact, "{model}, {material}");
    }
}

#[test]
fn lobes_are_those_of_the_model_that_draws() {
    let text = "rta 1\nmodel cook-torrance lobes\ncamera at 0 -5 1  look 0 1 0\nsphere at 0 0 1  radius 1  of mirror\n";
    let scene = crate::read(text.as_bytes(), "lobes.rta").expect("a scene");
    for (model, rough, spreads) in [
        (Model::CookTorrance, vec![0.3], true),
        (Model::BlinnFull, Vec::new(), false),
        (Model::Whitted, Vec::new(), false),
    ] {
        let drawn = scene.drawn_by(model);
        assert_eq!(narrow::<f64>(&drawn, 1.0).expect("it is small").spreads.roughness, rough);
        assert_eq!(crate::sampler::spreads(&drawn, None), spreads);
    }
}
