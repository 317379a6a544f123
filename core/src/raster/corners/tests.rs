//! Edges through a pixel, against the exact part of it that they cover.

use heapless::Vec;

use super::{Corners, Cutting, Force, Keep, Packed};
use crate::color::Rgb;
use crate::raster::Raster;
use crate::raster::edge::{Edge, camera, random_edges};
use crate::scalar::vector::{UnitVec3, Vec3, Vector};
use crate::trace::{Observer, Trace};

/// Returns rms error, mean error and mean number of rays of 20000 random edges through a picture of one pixel.
fn measured<const PLACES: usize>(depth: u8) -> [f64; 3] {
    let (camera, raster) = (camera(), Raster::new(1, 1).expect("a pixel"));
    let cutting = Cutting::new(depth, 16).expect("not deep");
    let (mut n, mut sums) = (0.0, [0.0; 3]);
    for (edge, cover) in random_edges() {
        let mut above = [Rgb::BLACK; 2];
        let rows = Corners::<_, _, PLACES>::new(&edge, (&camera, raster), cutting, &mut above, 0);
        let mut rows = rows.expect("room");
        let mut light = 0.0;
        assert!(rows.next_row(|pixel| light = pixel.r));
        let error = light - cover;
        let rays = u32::try_from(rows.rays()).expect("few");
        sums = [sums[0] + error * error, sums[1] + error, sums[2] + f64::from(rays)];
        n += 1.0;
    }
    [libm::sqrt(sums[0] / n), sums[1] / n, sums[2] / n]
}

#[test]
fn errors_and_rays_are_those_of_theory() {
    let cases = [
        (measured::<4>(0), 0.197, 4.0),
        (measured::<9>(1), 0.0804, 9.0),
        (measured::<25>(2), 0.0298, 18.0),
        (measured::<81>(3), 0.0107, 35.0),
        (measured::<289>(4), 0.0038, 68.0),
    ];
    for ([rms, mean, rays], want, count) in cases {
        assert!((rms / want - 1.0).abs() < 0.05, "{rms} instead of {want}");
        assert!(mean.abs() < 1e-3, "{mean}");
        assert!((rays / count - 1.0).abs() < 0.05, "{rays} instead of {count}");
    }
}

#[test]
fn a_pixel_without_an_edge_costs_one_ray() {
    let edge = Edge { normal: [1.0, 0.0], distance: 9.0 };
    let (camera, raster) = (camera(), Raster::new(40, 30).expect("small"));
    let mut above = [Rgb::BLACK; 41];
    let rows = Corners::<_, _>::new(&edge, (&camera, raster), Cutting::default(), &mut above, 0);
    let mut rows = rows.expect("room");
    let mut pixels = 0;
    while rows.next_row(|light| {
        assert!((light.g - 1.0).abs() < 1e-12);
        pixels += 1;
    }) {}
    assert_eq!((pixels, rows.rays()), (1200, 41 * 31));
}

#[test]
fn what_has_no_room_is_refused() {
    let edge = Edge { normal: [1.0, 0.0], distance: 0.0 };
    let (camera, raster) = (camera(), Raster::new(2, 2).expect("small"));
    let deep = Cutting::new(3, 16).expect("not deep");
    let mut above = [Rgb::BLACK; 3];
    assert!(Corners::<_, _, 80>::new(&edge, (&camera, raster), deep, &mut above, 0).is_none());
    assert!(Corners::<_, _, 81>::new(&edge, (&camera, raster), deep, &mut above[..2], 0).is_none());
    assert!(Cutting::new(5, 16).is_none());
}

/// The light of a small picture.
type Lights<L> = Vec<L, 1200>;

fn put<L: core::fmt::Debug>(lights: &mut Lights<L>, light: L) {
    lights.push(light).expect("small");
}

/// Draws the picture of an edge from a row on.
fn drawn(edge: &Edge, raster: Raster, first: u32, shares: bool) -> (Lights<f64>, u64) {
    let camera = camera();
    let cutting = Cutting::default();
    let (mut above, mut edges) = ([Rgb::BLACK; 41], [Rgb::BLACK; 120]);
    assert_eq!(40 * cutting.edges(), edges.len());
    let edges = &mut edges[..if shares { 120 } else { 0 }];
    let rows = Corners::<_, _>::new(edge, (&camera, raster), cutting, &mut above, first);
    let (mut rows, mut lights) = (rows.expect("room").sharing(edges), Lights::new());
    while rows.next_row(|light| put(&mut lights, light.r)) {}
    (lights, rows.rays())
}

#[test]
fn shared_edges_take_fewer_rays_for_the_same_picture() {
    let raster = Raster::new(40, 30).expect("small");
    for normal in [[0.8, 0.6], [0.6, -0.8], [0.9998, 0.02]] {
        let edge = Edge { normal, distance: 0.013 };
        let (alone, rays) = drawn(&edge, raster, 0, false);
        let (shared, fewer) = drawn(&edge, raster, 0, true);
        assert_eq!(alone, shared);
        assert!(fewer < rays, "{fewer}, {rays}");
        let (part, _) = drawn(&edge, raster, 11, true);
        assert_eq!(part, alone[11 * 40..]);
    }
}

struct Only(u32, u32);

impl Force for Only {
    fn is_cut(&self, x: u32, y: u32) -> bool {
        (x, y) == (self.0, self.1)
    }
}

#[test]
fn a_forced_pixel_is_cut_to_the_full_depth() {
    let edge = Edge { normal: [1.0, 0.0], distance: 9.0 };
    let (camera, raster) = (camera(), Raster::new(8, 6).expect("small"));
    let mut above = [Rgb::BLACK; 9];
    let rows = Corners::<_, _>::new(&edge, (&camera, raster), Cutting::default(), &mut above, 0);
    let mut rows = rows.expect("room").forced(Only(3, 2));
    while rows.next_row(|light| assert!((light.r - 1.0).abs() < 1e-12)) {}
    // The middles of the four pixels to its right are looked at: that it would be cut was not known of those to its left.
    assert_eq!(rows.rays(), 9 * 7 + 25 - 4 + 4);
}

#[test]
fn the_middle_is_seen_near_a_pixel_that_is_cut() {
    // Through pixel 4, whose left quarters alone are cut; the four pixels on either side are asked in their middles.
    let edge = Edge { normal: [1.0, 0.0], distance: 4.4 / 12.0 - 0.5 };
    let (camera, raster) = (camera(), Raster::new(12, 1).expect("small"));
    let mut above = [Rgb::BLACK; 13];
    let rows = Corners::<_, _>::new(&edge, (&camera, raster), Cutting::default(), &mut above, 0);
    let (mut rows, mut lights) = (rows.expect("room"), Lights::new());
    while rows.next_row(|light| put(&mut lights, light.r)) {}
    // Of the columns 0 to 4 of its lattice, those at 1 and 2, and without the corners of the pixel those at 0 and, in the middle, at 4.
    let (cut, middles) = (rows.rays() - 2 * 13, 8);
    assert_eq!(cut, 5 + 5 + 3 + 1 + middles);
    assert!((lights[3] - 1.0).abs() < 1e-12 && lights[5].abs() < 1e-12, "{lights:?}");
}

/// White where a point of the image plane is in one of some boxes, black elsewhere.
struct Boxes([[[f64; 2]; 2]; 2]);

impl Trace<f64> for Boxes {
    type Memory = ();

    fn trace<O: Observer<f64> + ?Sized>(
        &self,
        _origin: Vec3<f64>,
        direction: UnitVec3<f64>,
        (): &mut (),
        _observer: &mut O,
    ) -> Rgb<f64> {
        let place = [direction.x() / direction.y() + 0.5, 0.5 - direction.z() / direction.y()];
        let is_in = |[low, high]: &[[f64; 2]; 2]| (0..2).all(|i| (low[i]..high[i]).contains(&place[i]));
        let light = f64::from(u8::from(self.0.iter().any(is_in)));
        Rgb::new(light, light, light)
    }
}

/// Returns the light of the pixels of a picture of two pixels side by side, with the corner of the first white and a box, in pixels.
fn beside_a_corner(low: [f64; 2], high: [f64; 2]) -> Lights<f64> {
    let boxes = Boxes([[[-1.0, -1.0], [0.01, 0.01]], [[low[0] / 2.0, low[1]], [high[0] / 2.0, high[1]]]]);
    let (camera, raster) = (camera(), Raster::new(2, 1).expect("small"));
    let mut above = [Rgb::BLACK; 3];
    let rows = Corners::<_, _>::new(&boxes, (&camera, raster), Cutting::default(), &mut above, 0);
    let (mut rows, mut lights) = (rows.expect("room"), Lights::new());
    while rows.next_row(|light| put(&mut lights, light.r)) {}
    lights
}

#[test]
fn what_is_known_of_the_edges_is_compared() {
    // The first pixel meets the bar in its middle and on the edge in common; the second has it neither at its corners nor in its middle.
    let lights = beside_a_corner([0.4, 0.45], [1.3, 0.55]);
    // Squares of 1/16 with two white corners of four: two above and two below the bar at each of the columns 0 and 1.
    assert!((lights[1] - (0.5 + 1.0) / 16.0).abs() < 1e-12, "{lights:?}");
    // Within the first pixel the upper left quarter meets the bar on the edge of the upper right one, whose corners are black.
    let lights = beside_a_corner([0.2, 0.2], [0.8, 0.3]);
    // Columns 1, 2 and 3 of one row have the weight 1/16, and its corner 1/64.
    assert!((lights[0] - 3.0 / 16.0 - 1.0 / 64.0).abs() < 1e-12, "{lights:?}");
}

/// A picture whose corners are rounded to levels before they are kept, one by one.
#[derive(Clone, Copy)]
struct Rounded(Rgb<f64>);

impl Keep<f64> for Rounded {
    fn keep(light: Rgb<f64>) -> Self {
        Self(light.map(|light| libm::floor(light * 63.0 + 0.5) / 63.0))
    }

    fn light(self) -> Rgb<f64> {
        self.0
    }
}

#[test]
fn packed_rows_have_the_levels_of_a_display() {
    assert_eq!(size_of::<[Packed<63>; 321]>(), 963);
    let edge = crate::raster::edge::Tinted {
        edge: Edge { normal: [0.8, 0.6], distance: 0.1 },
        dark: [0.2, 0.97, 0.413],
    };
    let (camera, raster) = (camera(), Raster::new(40, 30).expect("small"));
    let (mut packed, mut rounded) = ([Packed::<63>::default(); 41], [Rounded(Rgb::BLACK); 41]);
    let mut whole = [Rgb::BLACK; 41];
    let (view, cutting) = ((&camera, raster), Cutting::default());
    let mut packed = Corners::<_, _, 25, _>::new(&edge, view, cutting, &mut packed, 0).expect("room");
    let mut rounded = Corners::<_, _, 25, _>::new(&edge, view, cutting, &mut rounded, 0).expect("room");
    let mut whole = Corners::<_, _>::new(&edge, view, cutting, &mut whole, 0).expect("room");
    let [mut a, mut b, mut c] = [const { Lights::new() }; 3];
    while packed.next_row(|light| put(&mut a, light)) {}
    while rounded.next_row(|light| put(&mut b, light)) {}
    while whole.next_row(|light| put(&mut c, light)) {}
    for ((packed, rounded), whole) in a.iter().zip(&b).zip(&c) {
        assert!((packed.g - rounded.g).abs() < 1e-12 && (packed.b - rounded.b).abs() < 1e-12);
        assert!((packed.b - whole.b).abs() <= 0.5 / 63.0 + 1e-12, "{packed:?}, {whole:?}");
    }
    assert_ne!(a, c);
}
