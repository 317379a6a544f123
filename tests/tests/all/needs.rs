//! Sets of needs: a small one that suffices draws the same bytes, one that does not suffice is reported, and what a set
//! leaves out is not drawn.

use rta_core::Q16;
use rta_core::illumination::Rta;
use rta_core::needs::{Everything, Needs};
use rta_scenes::description::{self, Description};
use rta_scenes::narrow::narrow;
use rta_scenes::used::missing;
use rta_tests::exact::{DEPTH, Exact, shipped_scene};
use rta_tests::random_scenes;

/// The needs of a small program: diffuse spheres on a floor.
struct Plain;

impl Needs for Plain {
    const ELLIPSOIDS: bool = false;
    const CYLINDERS: bool = false;
    const SKY_GRADIENT: bool = false;
    const VISIBLE_LAMPS: bool = false;
    const GLINT: bool = false;
    const MIRROR: bool = false;
    const GLASS: bool = false;
    const TRANSPARENT_SHADOWS: bool = false;
}

fn plain() -> Description {
    let mut scene = shipped_scene("juggler");
    scene.spheres.iter_mut().for_each(|sphere| sphere.surface = description::Surface::Opaque);
    scene.lamps.iter_mut().for_each(|lamp| lamp.radius = 0.0);
    scene.sky.zenith = scene.sky.horizon;
    scene
}

#[test]
fn a_small_set_of_needs_draws_the_same_bytes() {
    let exact = Exact::new(&plain(), 160, 100);
    assert_eq!(missing::<Plain, _>(&exact.scene().scene()), None);
    let small = exact.picture::<_, Plain>(Rta, DEPTH);
    assert_eq!(small, exact.picture::<_, Everything>(Rta, DEPTH));
    // Where more is needed it is missing from the picture, too.
    let juggler = Exact::new(&shipped_scene("juggler"), 160, 100);
    assert!(missing::<Plain, _>(&juggler.scene().scene()).is_some());
    assert_ne!(juggler.picture::<_, Plain>(Rta, DEPTH), juggler.picture::<_, Everything>(Rta, DEPTH));
}

/// Returns for each constant of `Needs` its name, and the answer of `missing` for the set that lacks this one alone.
macro_rules! without {
    ($scene:expr, $($need:ident)*) => {
        [$({
            struct Without;
            impl Needs for Without {
                const $need: bool = false;
            }
            (stringify!($need), missing::<Without, _>($scene))
        }),*]
    };
}

#[test]
fn missing_names_what_is_lacking() {
    let all = random_scenes::all();
    let (_, every_type) =
        all.iter().find(|(name, _)| *name == "every-type").expect("a scene with everything");
    let mut scene = every_type.clone();
    scene.lamps.iter_mut().for_each(|lamp| lamp.radius = 0.5);
    let narrowed = narrow::<Q16>(&scene, 1.0).expect("it fits");
    assert_eq!(missing::<Everything, _>(&narrowed.scene()), None);
    for (need, said) in without!(
        &narrowed.scene(),
        SPHERES ELLIPSOIDS CYLINDERS FLOOR SKY_GRADIENT VISIBLE_LAMPS GLINT MIRROR GLASS TRANSPARENT_SHADOWS
    ) {
        assert_eq!(said, Some(need));
    }
    let simple = narrow::<Q16>(&plain(), 1.0).expect("it fits");
    for (need, said) in without!(
        &simple.scene(),
        ELLIPSOIDS CYLINDERS SKY_GRADIENT VISIBLE_LAMPS GLINT MIRROR GLASS TRANSPARENT_SHADOWS
    ) {
        assert_eq!(said, None, "{need}");
    }
}

#[test]
fn everything_a_set_leaves_out_it_does_not_draw() {
    let all = random_scenes::all();
    let (_, scene) = all.iter().find(|(name, _)| *name == "every-type").expect("a scene with everything");
    let exact = Exact::new(scene, 160, 100);
    let whole = exact.picture::<_, Everything>(Rta, DEPTH).expect("it is drawn");
    macro_rules! differs_without {
        ($($need:ident)+) => {{
            struct Without;
            impl Needs for Without {
                $(const $need: bool = false;)+
            }
            let part = exact.picture::<_, Without>(Rta, DEPTH).expect("it is drawn");
            assert!(part != whole, "{} makes no difference", stringify!($($need)+));
            part
        }};
    }
    differs_without!(SPHERES);
    differs_without!(ELLIPSOIDS);
    differs_without!(CYLINDERS);
    differs_without!(FLOOR);
    differs_without!(SKY_GRADIENT);
    differs_without!(GLINT);
    differs_without!(SHADOWS);
    differs_without!(TRANSPARENT_SHADOWS);
    // Glass takes mirrors, so that these can only be left out together.
    let reflections = differs_without!(GLASS);
    let none = differs_without!(GLASS MIRROR);
    assert!(none != reflections, "MIRROR makes no difference");
}
