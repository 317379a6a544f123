//! Random descriptions with all that a scene can say.

use proptest::prelude::*;
use rta_core::scene::Object;
use rta_scenes::description::{
    Air, Attenuation, Camera, Cone, Cylinder, Description, Detail, Details, Ellipsoid, Fading, FallOff,
    Floor, Journey, Keyframe, Lamp, LampShape, Medium, Model, ModelOption, Optics, Path, Plane, Settings,
    Shading, Side, Sky, Sphere, Surface, Triangle,
};

mod material;

use material::{material, textures};

type Triple = [f64; 3];

fn place() -> impl Strategy<Value = Triple> {
    prop_oneof![
        prop::array::uniform3(-100.0..=100.0),
        prop::array::uniform3(prop::num::f64::NORMAL.prop_map(|c| c % 9.0))
    ]
}

fn direction() -> impl Strategy<Value = Triple> {
    prop::array::uniform3(0.1..=1.0_f64).prop_flat_map(|[x, y, z]| {
        (any::<bool>(), any::<bool>())
            .prop_map(move |(a, b)| [if a { x } else { -x }, y, if b { z } else { -z }])
    })
}

fn color() -> impl Strategy<Value = Triple> {
    prop_oneof![
        prop::array::uniform3(0.0..=1.0),
        (0.0..=1.0).prop_map(|c| [c; 3]),
        Just([0.0; 3]),
        Just([1.0; 3])
    ]
}

fn positive() -> impl Strategy<Value = f64> {
    prop_oneof![0.01..=100.0, 1e-12..=1e-6, 1e15..=1e18]
}

fn maybe<T: core::fmt::Debug>(of: impl Strategy<Value = T>) -> impl Strategy<Value = Option<T>> {
    prop::option::of(of)
}

fn surface() -> impl Strategy<Value = Surface> {
    let share = || prop_oneof![Just(0.0), 0.0..=1.0];
    let finish = (share(), share(), 0.0..=1500.0, share(), positive())
        .prop_map(|(kd, ks, exponent, kt, ior)| Surface::Finish { kd, ks, exponent, kt, ior });
    prop_oneof![
        Just(Surface::Opaque),
        Just(Surface::Shiny),
        Just(Surface::Mirror),
        (share(), positive()).prop_map(|(ks, ior)| Surface::Transparent { ks, kt: 1.0 - ks, ior }),
        finish,
        (0..6_u16).prop_map(Surface::Of),
    ]
}

fn lamps() -> impl Strategy<Value = Vec<(Lamp, Option<LampShape>)>> {
    let fall_off = prop_oneof![Just(FallOff::OfModel), Just(FallOff::Square), Just(FallOff::Constant)];
    let power = prop_oneof![
        Just([1.0; 3]),
        Just([0.0; 3]),
        positive().prop_map(|c| [c; 3]),
        prop::array::uniform3(0.0..=4e4)
    ];
    let radius = prop_oneof![Just(0.0), positive()];
    let lamp = (place(), power, radius, fall_off).prop_map(|(position, color, radius, fall_off)| Lamp {
        position,
        color,
        radius,
        fall_off,
        line: 0,
    });
    let area = (place(), direction())
        .prop_map(|(corner, edge)| LampShape::Area { corner, edges: [edge, [0.0, 1.0, 5.0]] });
    let shape = prop_oneof![3 => Just(None), 1 => direction().prop_map(|to| Some(LampShape::Toward(to))), 1 => area.prop_map(Some)];
    prop::collection::vec((lamp, shape), 0..4)
}

fn objects() -> impl Strategy<Value = Description> {
    let look = || (color(), surface());
    let cylinder = (place(), positive(), look()).prop_map(|(position, radius, (color, surface))| Cylinder {
        position,
        color,
        radius,
        surface,
        line: 0,
    });
    let radii = prop_oneof![positive().prop_map(|radius| [radius; 3]), prop::array::uniform3(positive())];
    let ellipsoid = (place(), radii, any::<bool>(), look()).prop_map(
        |(position, radii, inside_only, (color, surface))| Ellipsoid {
            position,
            color,
            radii,
            inside_only,
            surface,
            line: 0,
        },
    );
    let sphere = (place(), positive(), look()).prop_map(|(position, radius, (color, surface))| Sphere {
        position,
        color,
        radius,
        surface,
        line: 0,
    });
    let cone = (
        place(),
        place(),
        prop_oneof![positive().prop_map(|radius| [radius, 0.0]), [positive(), positive()]],
        [any::<bool>(), any::<bool>()],
        look(),
    )
        .prop_map(|(base, apex, [base_radius, apex_radius], [capped, inside_only], (color, surface))| Cone {
            base,
            base_radius,
            apex,
            apex_radius,
            capped,
            inside_only,
            color,
            surface,
            line: 0,
        });
    let normals = maybe(prop::array::uniform3(direction()));
    let triangle = (place(), normals, any::<bool>(), look()).prop_map(
        |([x, y, z], normals, one_sided, (color, surface))| {
            let vertices = [[x, y, z], [x + 1.0, y, z], [x, y + 2.0, z + 3.0]];
            Triangle { vertices, normals, one_sided, color, surface, line: 0 }
        },
    );
    let plane = (place(), direction(), look()).prop_map(|(point, normal, (color, surface))| Plane {
        point,
        normal,
        color,
        surface,
        line: 0,
    });
    (
        prop::collection::vec(cylinder, 0..3),
        prop::collection::vec(ellipsoid, 0..4),
        prop::collection::vec(sphere, 0..6),
        prop::collection::vec(cone, 0..3),
        prop::collection::vec(triangle, 0..4),
        prop::collection::vec(plane, 0..3),
    )
        .prop_map(|(cylinders, ellipsoids, spheres, cones, triangles, planes)| {
            let camera = Camera::upright([0.0; 3], [0.0, 1.0, 0.0], 1.0);
            Description {
                cylinders,
                ellipsoids,
                spheres,
                cones,
                triangles,
                planes,
                ..Description::empty(camera)
            }
        })
}

fn camera() -> impl Strategy<Value = Camera> {
    let side = prop_oneof![Just(Side::Width), Just(Side::Height)];
    let up = maybe(Just([0.0, 0.0, 1.0]));
    (place(), direction(), positive(), side, up).prop_map(|(eye, view, focal, side, up)| Camera {
        eye,
        view,
        focal,
        side,
        up,
    })
}

fn settings() -> impl Strategy<Value = (Settings, Model)> {
    let model = prop_oneof![
        Just((Model::Rta, Vec::new())),
        Just((Model::Phong, Vec::new())),
        Just((Model::Bouknight, vec![ModelOption { name: "mach".into(), numbers: vec![2.0] }])),
        Just((Model::Flat, Vec::new())),
        Just((Model::HallGreenberg, Vec::new())),
    ];
    let screen = maybe([1.0..=4.0, 1.0..=4.0_f64]);
    (model, screen, maybe(0..=32_u32), maybe(1..=9_u32), maybe(0.0..=1.0), maybe(0..=15_u32)).prop_map(
        |((model, model_options), screen, depth, side, cutoff, half)| {
            let (samples, wavelengths) = (side.map(|side| side * side), half.map(|half| 2 * half + 1));
            (Settings { screen, depth, samples, cutoff, wavelengths, model_options }, model)
        },
    )
}

fn air() -> impl Strategy<Value = Air> {
    let fading = prop_oneof![
        Just(Fading::Warnock),
        positive().prop_map(Fading::Romney),
        (0.0..=9.0, 0.1..=9.0).prop_map(|(near, more): (f64, f64)| Fading::Haze([near, near + more])),
    ];
    let attenuation = (fading, maybe(positive()), maybe(color()))
        .prop_map(|(fading, from, color)| Attenuation { fading, from, color });
    let medium = (color(), 0.0..=1.0, -0.9..=0.9, 0..=64_u32, maybe(positive()));
    let medium = medium.prop_map(|(extinction, albedo, anisotropy, shadows, reach)| Medium {
        extinction,
        albedo,
        anisotropy,
        shadows,
        reach,
    });
    (maybe(attenuation), maybe(medium)).prop_map(|(attenuation, medium)| Air { attenuation, medium })
}

fn details() -> impl Strategy<Value = Details> {
    let object = (0..4_u32, 0..5_u8).prop_map(|(number, kind)| match kind {
        0 => Object::Cylinder(number),
        1 => Object::Ellipsoid(number),
        2 => Object::Sphere(number),
        3 => Object::Plane(number),
        _ => Object::Triangle(number),
    });
    let shading = prop_oneof![Just(Shading::Normals), Just(Shading::Gouraud), Just(Shading::BishopWeimer)];
    let uv = maybe(prop::array::uniform3([0.0..=1.0, 0.0..=1.0_f64]));
    let detail = (shading, maybe(place()), maybe(path_name()), uv)
        .prop_map(|(shading, moves, along, uv)| Detail { shading, moves, along, uv });
    let keyframes = prop::collection::vec((0.01..=0.1_f64, place()), 2..9).prop_map(|steps| {
        let mut time = 0.0;
        let keyframe = |(step, place)| {
            time += step;
            Keyframe { time, place }
        };
        steps.into_iter().map(keyframe).collect()
    });
    let path = (any::<bool>(), keyframes).prop_map(|(linear, keyframes)| Path {
        name: "a".into(),
        linear,
        keyframes,
    });
    let journey = (path_name(), maybe(place())).prop_map(|(path, aim)| Journey { path, aim });
    let lamp_paths = prop::collection::btree_map(0..4_usize, path_name(), 0..3);
    let lamp_moves = prop::collection::btree_map(0..4_usize, place(), 0..3);
    let moves = (maybe(path), maybe(journey), lamp_paths, lamp_moves);
    let file = maybe("[a-zA-Z #/.é]{0,9}");
    (prop::collection::btree_map(object, detail, 0..5), maybe(positive()), file, moves).prop_map(
        |(objects, tile, sky_map, (path, journey, lamp_paths, lamp_moves))| {
            let second = path.clone().map(|path| Path { name: "b-2".into(), ..path });
            let paths = path.into_iter().chain(second).collect();
            Details { objects, tile, sky_map, paths, journey, lamp_paths, lamp_moves, ..Details::default() }
        },
    )
}

/// Returns the name of a path, which there may be none of.
fn path_name() -> impl Strategy<Value = String> {
    prop_oneof![Just("a".to_owned()), Just("b-2".to_owned()), Just("c".to_owned())]
}

/// Returns any scene.
pub(crate) fn scene() -> impl Strategy<Value = Description> {
    let floor = maybe((color(), color(), surface()))
        .prop_map(|floor| floor.map(|(first, second, surface)| Floor { colors: [first, second], surface }));
    let sky = (color(), color()).prop_map(|(horizon, zenith)| Sky { horizon, zenith });
    let shutter = maybe([-1.0..=1.0, 0.0..=1.0_f64]);
    let optics = (maybe(positive()), maybe(positive()), shutter, maybe(positive()), maybe(place()));
    let optics = optics.prop_map(|(focus, aperture, shutter, hither, moves)| Optics {
        focus,
        aperture,
        shutter,
        hither,
        moves,
    });
    let materials = prop::collection::vec(material(), 0..6);
    let raster = maybe([1..=2000_u32, 1..=2000_u32]);
    let around = (floor, sky, color(), optics, raster);
    (objects(), camera(), materials, textures(), lamps(), settings(), air(), details(), around).prop_map(
        |(objects, camera, materials, textures, lamps, (settings, model), air, details, around)| {
            let (floor, sky, ambient, optics, raster) = around;
            let shapes =
                lamps.iter().enumerate().filter_map(|(number, (_, shape))| Some((number, shape.clone()?)));
            let details = Details { lamps: shapes.collect(), ..details };
            let lamps = lamps.into_iter().map(|(lamp, _)| lamp).collect();
            Description {
                camera,
                materials,
                textures,
                lamps,
                settings,
                model,
                air,
                details,
                floor,
                sky,
                ambient,
                optics,
                raster,
                ..objects
            }
        },
    )
}
