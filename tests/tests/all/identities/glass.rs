//! Identities of glass: what is not reflected is transmitted.

use rta_core::illumination::table::Tabled;
use rta_core::illumination::{HallGreenberg, HallGreenbergRow, Illumination, Secondary, Weight};
use rta_core::needs::Everything;
use rta_core::ray::Start;
use rta_core::scalar::Unit;
use rta_core::trace::decision::{Branch, branch, refract};
use rta_core::{Q16, Q20};
use rta_scenes::description::{Kind, Material};
use rta_tests::assert_close;
use rta_tests::measure::{Measure, read_direction};
use rta_tests::point::{Point, above, random};

use super::{CASES, dice, dot, in_all_formats, unit};

/// The model over one material.
fn over<S: Measure>(material: &Material) -> [HallGreenbergRow<S>; 1] {
    [HallGreenberg::default().row(material)]
}

/// Returns the weights of the reflected and of the transmitted ray as the tracer has them, of each register.
fn weights<S: Measure>(point: &Point<S>, rows: &[HallGreenbergRow<S>]) -> [Option<[f64; 3]>; 2] {
    let model = HallGreenberg::default();
    let model = model.over(rows);
    let surface = point.surface();
    let ray = |direction| Start { origin: surface.point, direction };
    let eye = Branch::eye::<S>();
    let [transmitted, reflected] = branch::<S, _, Everything>(
        model.secondary::<Everything>(&surface),
        &surface,
        (&eye, S::Unit::ZERO),
        || ray(surface.incoming),
        |glass| refract(&surface, glass).map(ray),
        || ray(surface.incoming),
    );
    [reflected, transmitted].map(|spawned| {
        let (branch, _) = spawned?;
        let registers = Weight::<S>::registers(branch.weight);
        Some([registers.r, registers.g, registers.b].map(unit::<S>))
    })
}

#[test]
fn the_two_rays_of_smooth_glass_share_all_of_the_light() {
    fn check<S: Measure>() {
        let mut dice = dice();
        let (mut total, mut shared) = (0, 0);
        for index in [0.4, 0.66, 1.0003, 1.33, 1.52, 2.4].into_iter().cycle().take(CASES) {
            let rows = over::<S>(&Material { kind: Kind::Glass, index: Some(index), ..Material::default() });
            let normal = random(&mut dice);
            let view = above(normal, &mut dice);
            let point = Point::<S>::new(normal, normal, view).glass(1.0, 1.0, index);
            let point = Point { number: 0, inside: dice.bool(), ..point };
            let [reflected, transmitted] = weights(&point, &rows);
            let case = format!("{}, {index}: {point:?}", S::NAME);
            let is_total = point
                .material
                .glass::<Everything>()
                .is_some_and(|glass| refract(&point.surface(), glass).is_none());
            assert_eq!(transmitted.is_none(), is_total, "{case}");
            total += usize::from(is_total);
            shared += usize::from(!is_total);
            let [reflected, transmitted] = [reflected, transmitted].map(Option::unwrap_or_default);
            for (reflected, transmitted) in reflected.into_iter().zip(transmitted) {
                assert_close!(reflected + transmitted, 1.0, 4.0 * S::UNIT, "of the light", "{case}");
            }
        }
        assert!(total > CASES / 10 && shared > CASES / 2, "{total} total, {shared} shared");
    }
    in_all_formats!(check);
}

#[test]
fn both_sides_of_glass_reflect_alike_along_one_refracted_ray() {
    fn check<S: Measure>() {
        let mut dice = dice();
        for index in [1.0 / 1.8, 1.1, 1.33, 1.52, 2.4].into_iter().cycle().take(CASES) {
            let rows = over::<S>(&Material { kind: Kind::Glass, index: Some(index), ..Material::default() });
            let normal = random(&mut dice);
            let view = above(normal, &mut dice);
            let outside = Point::<S>::new(normal, normal, view).glass(1.0, 1.0, index);
            let outside = Point { number: 0, ..outside };
            let Some(refracted) =
                outside.material.glass::<Everything>().and_then(|glass| refract(&outside.surface(), glass))
            else {
                continue;
            };
            // The way back: the ray inside comes from where the refracted one goes.
            let back = Point { normal: -outside.normal, view: refracted, inside: true, ..outside };
            let least = [outside, back]
                .map(|point| dot(read_direction::<S>(point.normal), read_direction::<S>(point.view)));
            let least = least[0].min(least[1]);
            // Near grazing and near the critical angle, the reflectance is as steep as a root.
            if least < 0.05 {
                continue;
            }
            let [[one, _], [other, _]] = [outside, back].map(|point| weights(&point, &rows));
            let [one, ..] = one.expect("it reflects");
            let [other, ..] = other.expect("it reflects");
            let tolerance = 32.0 * S::UNIT / (least * least);
            assert_close!(one, other, tolerance, "of the light", "{}, {index}: {outside:?}", S::NAME);
        }
    }
    in_all_formats!(check);
}

#[test]
fn thin_walls_show_lamps_behind_them_where_they_are() {
    fn check<S: Measure>() {
        let material = Material {
            kind: Kind::Glass,
            thin: true,
            index: Some(1.5),
            exponent: Some(20.0),
            ..Material::default()
        };
        let rows = over::<S>(&material);
        let model = HallGreenberg::default();
        let model = model.over(&rows);
        for turn in [0.0_f64, 5.0, 20.0] {
            let (sine, cosine) = turn.to_radians().sin_cos();
            let point =
                Point::<S>::new([0.0, 0.0, 1.0], [sine, 0.0, -cosine], [0.0, 0.0, 1.0]).glass(1.0, 1.0, 1.0);
            let point = Point { number: 0, inside: true, ..point };
            // 1 - F at the lamp's angle, F of the index 1.5 as the weights have it.
            let outside =
                Point::<S>::new([0.0, 0.0, 1.0], [0.0, 0.0, 1.0], [sine, 0.0, cosine]).glass(1.0, 1.0, 1.0);
            let Secondary { reflected, .. } =
                model.secondary::<Everything>(&Point { number: 0, ..outside }.surface());
            let wanted = (1.0 - unit::<S>(reflected.expect("it reflects").g)) * cosine.powi(20);
            let [_, green, _] = point.lit(&model);
            assert_close!(
                green,
                wanted,
                2.0 * S::LIGHT + 100.0 * S::UNIT,
                "of the light",
                "{}, {turn}",
                S::NAME
            );
        }
    }
    in_all_formats!(check);
}
