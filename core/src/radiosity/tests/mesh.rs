use super::{Faces, Wall, furnace};
use crate::radiosity::{Cast, Casts, Error, Fault, Mesh, Patch, Rays};
use crate::scalar::read::{Read, direction, place};
use crate::scalar::vector::{UnitVector, Vector};
use crate::scalar::{Magnitude, Scalar};
use crate::scene::Object;
use crate::{Q16, Q20};

const GREY: Wall = Wall { reflectance: [0.5; 3], emission: [0.0; 3] };

/// A trapezium on a plane that is aslant, four units by one and two.
const TRAPEZIUM: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [2.0, 0.0, 2.0], [1.5, 1.0, 1.5], [0.5, 1.0, 0.5]];

fn areas_and_places<S: Read>(rounding: f64) {
    let mut faces = Faces::<S>::new();
    faces.push(TRAPEZIUM, [4, 2], GREY);
    faces.push([[3.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 1.0, 0.0], [3.0, 1.0, 0.0]], [3, 5], GREY);
    let mesh = faces.mesh();
    let area = |patch: Patch| {
        let area = mesh.area(patch).expect("it is there");
        S::shine(S::intensity(area))
    };
    let root = libm::sqrt(2.0);
    // Rows of a width that falls from 2 to 1.
    for (cell, exact) in
        [([0, 0], 1.75 / 8.0 * root), ([3, 0], 1.75 / 8.0 * root), ([1, 1], 1.25 / 8.0 * root)]
    {
        let found = area(Patch { quad: 0, cell });
        assert!((found - exact).abs() < rounding, "{cell:?}: {found}, {exact}");
    }
    assert!((area(Patch { quad: 1, cell: [2, 4] }) - 1.0 / 15.0).abs() < rounding);
    let whole: f64 = mesh.patches().map(area).sum();
    assert!((whole - 1.5 * root - 1.0).abs() < 20.0 * rounding, "{whole}");
    assert_eq!(mesh.len(), 23);
    let numbers = mesh.patches().map(|patch| mesh.number(patch).expect("it is there"));
    assert!(numbers.eq(0..23));
    assert!((0..23).map(|number| mesh.patch(number)).eq(mesh.patches().map(Some)));
    assert!(mesh.patch(23).is_none());
}

#[test]
fn areas_of_patches_in_every_format() {
    areas_and_places::<f64>(1e-15);
    areas_and_places::<f32>(1e-6);
    areas_and_places::<Q16>(4e-5);
    areas_and_places::<Q20>(2e-5);
}

fn located<S: Read>(rounding: f64) {
    let mut faces = Faces::<S>::new();
    faces.push(TRAPEZIUM, [4, 2], GREY);
    faces.push([[3.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 1.0, 0.0], [3.0, 1.0, 0.0]], [3, 5], GREY);
    let mesh = faces.mesh();
    for (number, quad) in faces.quads.iter().enumerate() {
        for step in 0..100u32 {
            let (u, v) = (f64::from(step % 10) / 10.0 + 0.05, f64::from(step / 10) / 10.0 + 0.03);
            let there = quad.place([S::unit(u), S::unit(v)]);
            let corner = u32::from(u < v);
            let (found, at) = mesh
                .locate(Object::Triangle(quad.triangle + half(number, u, v, corner)), there)
                .expect("it is met");
            let at = at.map(S::read);
            assert_eq!(found, number);
            assert!((at[0] - u).abs() < rounding && (at[1] - v).abs() < rounding, "{u}, {v}: {at:?}");
        }
    }
    assert!(mesh.locate(Object::Triangle(4), place::<S>([0.0; 3])).is_none(), "a triangle without patches");
    assert!(mesh.locate(Object::Floor, place::<S>([0.0; 3])).is_none());
    let cell = |u: f64, v: f64| {
        mesh.at(1, [S::unit(u), S::unit(v)]).and_then(|patch| mesh.number(patch)).expect("it is there") - 8
    };
    assert_eq!([cell(0.0, 0.0), cell(0.4, 0.21), cell(1.0, 1.0), cell(0.999, 0.0)], [0, 4, 14, 2]);
}

/// Returns in which of the two triangles (u, v) lies: on which side of the diagonal.
fn half(quad: usize, u: f64, v: f64, square: u32) -> u32 {
    if quad == 1 {
        return square;
    }
    // In the plane of the trapezium: x from 0 to 2, the diagonal to (1.5, 1).
    let x = u * (2.0 - v) + 0.5 * v;
    u32::from(x < 1.5 * v)
}

#[test]
fn places_are_found_again_in_every_format() {
    located::<f64>(1e-9);
    located::<f32>(1e-6);
    located::<Q16>(8e-5);
    located::<Q20>(5e-6);
}

#[test]
fn what_is_wrong_is_refused() {
    let faces = Faces::<Q16>::cube(2, false, furnace(0.5, 1.0));
    let check = |change: &dyn Fn(&mut Faces<Q16>)| {
        let mut wrong = Faces::<Q16>::cube(2, false, furnace(0.5, 1.0));
        change(&mut wrong);
        Mesh::new(&wrong.quads, &faces.bare()).map(|mesh| mesh.len())
    };
    let fault = |quad, fault| Err(Error::Quad { quad, fault });
    assert_eq!(check(&|_| ()), Ok(24));
    assert_eq!(check(&|faces| faces.quads[1].triangle = 1), fault(1, Fault::Triangles));
    assert_eq!(check(&|faces| faces.quads[5].triangle = 11), fault(5, Fault::Triangles));
    assert_eq!(check(&|faces| faces.quads[2].first = 9), fault(2, Fault::Patches));
    assert_eq!(check(&|faces| faces.quads[0].patches = [0, 1]), fault(0, Fault::Patches));
    let half = <Q16 as Scalar>::Unit::from_num(0.99);
    assert_eq!(check(&|faces| faces.quads[3].reflectance.g = half), fault(3, Fault::Reflectance));
    assert_eq!(check(&|faces| faces.quads[3].reflectance.b = -half), fault(3, Fault::Reflectance));
    assert_eq!(check(&|faces| faces.quads[4].corners.swap(2, 3)), fault(4, Fault::Area));
}

#[test]
fn light_that_does_not_fit_is_refused() {
    let mut faces = Faces::<Q16>::cube(1, false, furnace(0.5, 1.0));
    faces.quads[4].emission.g = crate::scalar::Radiance(Q16::from_num(20_000));
    let Err(Error::Exceeds(bound)) = Mesh::new(&faces.quads, &faces.bare()) else {
        panic!("40000 is more than 32768");
    };
    assert_eq!(bound.object, Some(Object::Triangle(8)));
    assert_eq!(bound.bound, Magnitude::new(40_000, 0));
    let text = std::string::ToString::to_string(&Error::Exceeds(bound));
    assert!(text.contains("triangle 9") && text.contains("radiosity"), "{text}");
    faces.quads[4].emission.g = crate::scalar::Radiance(Q16::from_num(16_000));
    assert!(Mesh::new(&faces.quads, &faces.bare()).is_ok());
    assert!(faces.mesh().site(Patch { quad: 5, cell: [0, 0] }).is_some_and(|site| site.normal.y() < -0.9));
}

extern crate std;

/// Checks that rays leave a quadrilateral that is a little bent, the red wall of the Cornell box, in unit directions.
fn leaves_in_unit_directions<S: Read>(rounding: f64) {
    let corners = [[0.032, 0.0, 0.0], [0.064, 5.592, 0.0], [0.0, 5.592, 5.488], [0.0, 0.0, 5.488]];
    let mut faces = Faces::<S>::new();
    faces.push(corners, [8, 8], GREY);
    // Of the first triangle alone: edges (.032, 5.592, 0) and (-.032, 5.592, 5.488).
    let normal = [5.592 * 5.488, -0.032 * 5.488, 0.032 * 5.592 * 2.0];
    let length = libm::sqrt(normal.iter().map(|c| c * c).sum());
    faces.triangles[0].normal = direction::<S>(normal.map(|c| c / length));
    let site = faces.mesh().site(Patch { quad: 0, cell: [3, 5] }).expect("it is there");
    let rays = Rays { count: 64, seed: 0 };
    for k in 0..64 {
        let cast: Cast<S> = rays.cast(0, 0, k);
        let leaves = site.frame.vector(cast.direction);
        let [x, y, z] = [leaves.x(), leaves.y(), leaves.z()].map(S::read);
        assert!((x * x + y * y + z * z - 1.0).abs() < rounding, "{k}: {leaves:?}");
        let [_, _, height] = cast.direction.map(S::read);
        assert!((S::read(leaves.dot(site.normal)) - height).abs() < rounding, "{k}: {leaves:?}");
    }
}

#[test]
fn rays_leave_a_bent_quadrilateral_in_unit_directions() {
    leaves_in_unit_directions::<f64>(1e-14);
    leaves_in_unit_directions::<f32>(1e-6);
    leaves_in_unit_directions::<Q16>(2e-8);
    leaves_in_unit_directions::<Q20>(2e-8);
}
