//! Models whose materials say nothing special draw the pictures of the models that they extend, bit for bit in Q16.16.

use rta_core::color::Rgb;
use rta_core::illumination::table::Tabled;
use rta_core::illumination::{
    HallGreenberg, Illumination, KayGreenberg, KayGreenbergRow, Newell, NewellRow, Phong, Whitted,
};
use rta_core::needs::Everything;
use rta_core::scalar::{Exponent, Unit};
use rta_core::{Q16, Scalar};
use rta_scenes::description::Surface;
use rta_tests::exact::{Bits, DEPTH, Exact, shipped_scene};

/// The type of coefficients.
type Part = <Q16 as Scalar>::Unit;

fn picture(exact: &Exact, model: impl Illumination<Q16>, depth: u32) -> Vec<Bits> {
    exact.picture::<_, Everything>(model, depth).expect("it fits")
}

#[test]
fn kay_and_greenbergs_clear_glass_is_whitteds() {
    let exact = Exact::new(&shipped_scene("glass-2"), 64, 48);
    let density = |bits: u64| {
        let one = <Part as Unit>::Positive::new(bits, -8);
        vec![KayGreenbergRow { density: Rgb::new(one, one, one) }; exact.scene().said.len()]
    };
    let of = |rows: &[KayGreenbergRow<Q16>]| {
        picture(&exact, KayGreenberg { rows, ..KayGreenberg::default() }, DEPTH)
    };
    let whitted = picture(&exact, Whitted::default(), DEPTH);
    assert!(of(&density(0)) == whitted, "A is 1");
    let bottle = of(&density(64));
    let darker = bottle.iter().zip(&whitted).filter(|(one, other)| one.g < other.g).count();
    let brighter = bottle.iter().zip(&whitted).filter(|(one, other)| one.g > other.g).count();
    assert!(darker > 64 && brighter == 0, "{darker} of the pixels are darker, {brighter} brighter");
}

#[test]
fn newells_closed_walls_are_phongs_surfaces_without_rays() {
    for name in ["glass-2", "hall-22"] {
        let exact = Exact::new(&shipped_scene(name), 64, 48);
        let (least, most) = (Part::ZERO, Part::ZERO);
        let row = NewellRow { has_edge: true, exponent: Exponent::new(2, 0), least, most };
        let rows = vec![row; exact.scene().said.len()];
        let newell = Newell { rows: &rows, ..Newell::default() };
        assert!(picture(&exact, newell, DEPTH) == picture(&exact, Phong::default(), 0), "{name}");
    }
}

#[test]
fn hall_and_greenbergs_opaque_things_are_diffuse() {
    let mut scene = shipped_scene("glass-2");
    scene.spheres.iter_mut().for_each(|sphere| sphere.surface = Surface::Opaque);
    let exact = Exact::new(&scene, 64, 48);
    let model = HallGreenberg::default();
    let rows: Vec<_> = exact.scene().said.iter().map(|material| model.row(material)).collect();
    let hall = picture(&exact, model.over(&rows), DEPTH);
    assert!(hall == picture(&exact, Whitted::default(), DEPTH));
}
