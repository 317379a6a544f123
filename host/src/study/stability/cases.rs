//! The cases: situations that are known to break ray tracers, each as a scene with rays that are aimed at them.

use rta_scenes::description::{
    Camera, Cone, Cylinder, Description, Ellipsoid, FallOff, Floor, Lamp, Sky, Sphere, Surface, Triangle,
};
use rta_scenes::model::Model;
use rta_scenes::sampler::Spreading;

use super::aim::{Aim, Stand};
use super::triple::Triple;

mod models;
mod spread;

/// One case.
#[derive(Clone, Debug)]
pub struct Case {
    /// Its name in the table.
    pub name: String,
    /// The scene.
    pub scene: Description,
    /// Recursion depth.
    pub depth: u32,
    /// The position of the eye.
    pub stand: Stand,
    /// The directions of the rays.
    pub aim: Aim,
    /// The illumination models; the rays take turns between them.
    pub models: &'static [Model],
    /// Whether its convex objects are searched for acne, which needs to be done once for each scene.
    pub acne: bool,
    /// The number of rays that was asked for is divided by this, where each ray from the eye casts very many others, or where
    /// there are many such cases.
    pub thinning: usize,
    /// How rays are spread, in the cases where they are: then `aim` is the picture, and the eye stays where it is.
    pub spreading: Option<Spreading>,
}

/// The models of all cases that are not about a model: one with attenuated lamps and weights of three registers, one with halfway
/// vectors and powers of cosines. No other is added, so that the tables of all versions can be compared.
const BOTH: &[Model] = &[Model::Rta, Model::Whitted];

const GREY: Triple = [0.7, 0.6, 0.5];
const MILKY: Triple = [0.95, 0.95, 0.9];

/// Glass of an index of refraction, which reflects an eighth.
const fn glass(ior: f64) -> Surface {
    Surface::Transparent { ks: 0.125, kt: 0.875, ior }
}

/// A sky and nothing else, seen from `eye`.
fn empty(eye: Triple, view: Triple) -> Description {
    Description {
        ambient: [0.2, 0.2, 0.25],
        sky: Sky { horizon: [0.8, 0.85, 0.95], zenith: [0.15, 0.3, 0.65] },
        ..Description::empty(Camera::upright(eye, view, 1.0))
    }
}

/// A chequered floor and one lamp, seen from `eye`.
fn plain(eye: Triple, view: Triple) -> Description {
    let floor = Some(Floor { colors: [[0.9, 0.9, 0.9], [0.1, 0.1, 0.2]], surface: Surface::Opaque });
    Description { floor, ..empty(eye, view) }.lamp([-4.0, -5.0, 7.0], 60.0, 0.5)
}

/// Scenes in a few words.
trait Add {
    fn ball(self, position: Triple, radius: f64, surface: Surface) -> Self;
    fn egg(self, position: Triple, radii: Triple, surface: Surface) -> Self;
    fn column(self, position: [f64; 2], radius: f64, surface: Surface) -> Self;
    fn rod(self, ends: [Triple; 2], radii: [f64; 2], surface: Surface) -> Self;
    fn patch(self, vertices: [Triple; 3], normals: Option<[Triple; 3]>, surface: Surface) -> Self;
    fn lamp(self, position: Triple, intensity: f64, radius: f64) -> Self;
    fn focal(self, focal: f64) -> Self;
    fn dark(self) -> Self;
}

impl Add for Description {
    fn ball(mut self, position: Triple, radius: f64, surface: Surface) -> Self {
        let color = if matches!(surface, Surface::Opaque | Surface::Shiny) { GREY } else { MILKY };
        self.spheres.push(Sphere { position, color, radius, surface, line: 0 });
        self
    }
    fn egg(mut self, position: Triple, radii: Triple, surface: Surface) -> Self {
        self.ellipsoids.push(Ellipsoid {
            position,
            color: GREY,
            radii,
            inside_only: false,
            surface,
            line: 0,
        });
        self
    }
    fn column(mut self, [x, y]: [f64; 2], radius: f64, surface: Surface) -> Self {
        self.cylinders.push(Cylinder { position: [x, y, 0.0], color: MILKY, radius, surface, line: 0 });
        self
    }
    fn rod(mut self, [base, apex]: [Triple; 2], [wide, narrow]: [f64; 2], surface: Surface) -> Self {
        self.cones.push(Cone {
            base,
            base_radius: wide,
            apex,
            apex_radius: narrow,
            capped: false,
            inside_only: false,
            color: GREY,
            surface,
            line: 0,
        });
        self
    }
    fn patch(mut self, vertices: [Triple; 3], normals: Option<[Triple; 3]>, surface: Surface) -> Self {
        // Coincident ones are told apart by their colours.
        let color = if self.triangles.len().is_multiple_of(2) { GREY } else { MILKY };
        self.triangles.push(Triangle { vertices, normals, one_sided: false, color, surface, line: 0 });
        self
    }
    fn lamp(mut self, position: Triple, intensity: f64, radius: f64) -> Self {
        let color = [intensity, intensity, 0.75 * intensity];
        self.lamps.push(Lamp { position, color, radius, fall_off: FallOff::OfModel, line: 0 });
        self
    }
    fn focal(mut self, focal: f64) -> Self {
        self.camera.focal = focal;
        self
    }
    fn dark(mut self) -> Self {
        self.lamps.clear();
        self
    }
}

/// Returns all cases.
#[must_use]
#[allow(clippy::too_many_lines)] // it is a list
pub fn all() -> Vec<Case> {
    use Surface::{Mirror, Opaque, Shiny};
    const NORTH: Triple = [0.0, 1.0, 0.0];
    let ahead = || plain([0.0, 0.0, 2.0], NORTH);
    let sky = |distance: f64| empty([0.0; 3], [0.0, distance, 0.0]).lamp([-3.0, -3.0, 3.0], 40.0, 0.0);
    let mut cases = Vec::new();
    let mut add = |name, stand, aim, depth, scene| {
        let name = String::from(name);
        cases.push(Case {
            name,
            scene,
            depth,
            stand,
            aim,
            models: BOTH,
            acne: true,
            thinning: 1,
            spreading: None,
        });
    };
    let still = Stand::Shaken(0.01);
    let stir = Stand::Shaken(0.5);

    // Where hit turns into miss.
    add("silhouette, radius 1 at 5", stir, Aim::Silhouette, 2, sky(5.0).ball([0.0, 5.0, 0.0], 1.0, Shiny));
    add("silhouette, radius 1 at 50", stir, Aim::Silhouette, 2, sky(50.0).ball([0.0, 50.0, 0.0], 1.0, Shiny));
    add(
        "silhouette, radius 1 at 1000",
        stir,
        Aim::Silhouette,
        2,
        sky(1e3).ball([600.0, 800.0, 0.0], 1.0, Shiny),
    );
    add("silhouette of a cylinder", stir, Aim::Silhouette, 2, sky(5.0).column([0.0, 9.0], 1.0, Shiny));
    add("tangents of a sphere", stir, Aim::Tangent, 2, sky(5.0).ball([0.0, 5.0, 0.0], 1.0, Mirror));
    add("tangents of a glass", stir, Aim::Tangent, 5, sky(5.0).ball([0.0, 5.0, 0.0], 1.0, glass(1.5)));
    add("the floor's horizon", Stand::AboveFloor, Aim::Horizon, 1, plain([0.0, 0.0, 1.0], NORTH));

    let away = Description { floor: plain([0.0; 3], NORTH).floor, ..empty([300.0, -500.0, 1.0], NORTH) };
    add("the floor's horizon, far from the origin", Stand::AboveFloor, Aim::Horizon, 1, away);

    // Large beside small.
    let radii =
        |large: f64| ahead().ball([0.0, 3.0, 2.0], 0.001, Opaque).ball([0.0, 4.0, 1.0 - large], large, Shiny);
    add("radii 0.001 and 10000, picture", still, Aim::Picture, 2, radii(1e4));
    add("radii 0.001 and 10000, silhouette", still, Aim::Silhouette, 2, radii(1e4));
    add("radii 0.001 and 200, silhouette", still, Aim::Silhouette, 2, radii(200.0));
    let far =
        |d: f64| sky(1.0).ball([0.0, d, 0.0], 1.0, Shiny).ball([2.0, d, 0.5], 1.0, Mirror).focal(0.2 * d);
    add("radius 1 at distance 1000", still, Aim::Picture, 3, far(1e3));
    add("radius 1 at distance 400", still, Aim::Picture, 3, far(400.0));
    let disc = |s| sky(5.0).egg([0.0, 15.0, 0.0], [10.0, 10.0, 0.01], s);
    let needle = |s| sky(5.0).egg([0.0, 5.0, 0.0], [0.002, 0.002, 2.0], s);
    add("ellipsoid 1000 : 1000 : 1", stir, Aim::Picture, 2, disc(Shiny));
    add("ellipsoid 1000 : 1000 : 1, mirror", stir, Aim::Picture, 2, disc(Mirror));
    add("ellipsoid 1000 : 1000 : 1, silhouette", stir, Aim::Silhouette, 2, disc(Shiny));
    add("ellipsoid 1 : 1 : 1000, silhouette", stir, Aim::Silhouette, 2, needle(Shiny));
    add("ellipsoid 1 : 1 : 1000, glass", stir, Aim::Silhouette, 5, needle(glass(1.5)));

    // The eye where it should not be.
    let eyed = |surface| ahead().ball([0.0, 2.0, 2.0], 1.0, surface).ball([3.0, 6.0, 1.0], 1.0, Opaque);
    add("eye on an opaque sphere", Stand::OnSurface, Aim::Picture, 3, eyed(Opaque));
    add("eye on a glass sphere", Stand::OnSurface, Aim::Picture, 5, eyed(glass(1.5)));
    add("eye on the floor", Stand::Shaken(0.0), Aim::Picture, 2, plain([1.0, 0.0, 0.0], [0.0, 1.0, 0.1]));
    let within = |surface| {
        plain([0.1, 1.7, 2.2], NORTH).ball([0.0, 2.0, 2.0], 1.0, surface).ball([3.0, 6.0, 1.0], 1.0, Opaque)
    };
    add("eye inside glass", still, Aim::Picture, 5, within(glass(1.5)));
    add("eye inside a mirror ball", still, Aim::Picture, 8, within(Mirror));
    let hollow =
        plain([0.0, 2.5, 2.0], NORTH).ball([0.0, 3.0, 3.0], 2.0, Shiny).lamp([0.5, 3.5, 3.5], 2.0, 0.2);
    add("eye and lamp inside an object", still, Aim::Picture, 2, hollow);

    // Lamps where they should not be, and surfaces in the same place.
    let lamp_in = ahead().dark().ball([0.0, 5.0, 2.0], 1.0, Opaque).lamp([0.2, 4.9, 2.1], 40.0, 0.3);
    add("lamp inside an opaque sphere", still, Aim::Picture, 2, lamp_in);
    let lamp_in = ahead().dark().ball([0.0, 5.0, 2.0], 1.0, glass(1.5)).lamp([0.2, 4.9, 2.1], 40.0, 0.3);
    add("lamp inside a glass", still, Aim::Picture, 5, lamp_in);
    let lamp_on = ahead().dark().ball([0.0, 5.0, 2.0], 1.0, Shiny).lamp([0.0, 4.0, 2.0], 2.0, 0.0);
    add("lamp on a sphere", still, Aim::Picture, 2, lamp_on.lamp([2.0, 4.0, 0.0], 2.0, 0.1));
    let twice = ahead().ball([0.0, 5.0, 2.0], 1.0, Shiny).ball([0.0, 5.0, 2.0], 1.0, Mirror);
    let twice = twice.ball([2.5, 5.0, 2.0], 1.0, glass(1.5)).ball([2.5, 5.0, 2.0], 1.0, glass(1.5));
    add("coincident spheres", still, Aim::Picture, 5, twice);
    let touching = ahead().ball([-1.0, 5.0, 1.0], 1.0, Shiny).ball([1.0, 5.0, 1.0], 1.0, Mirror);
    add("touching spheres", still, Aim::Picture, 5, touching.ball([0.0, 4.0, 2.0], 0.5, glass(1.5)));

    // Refraction.
    let nested = ahead().ball([0.0, 5.0, 2.0], 1.5, glass(1.5)).ball([0.0, 5.0, 2.0], 1.0, glass(1.33));
    add("nested glass", still, Aim::Picture, 6, nested.ball([0.0, 5.0, 2.0], 0.5, glass(0.7)));
    let inside = |ior| plain([0.0, 2.9, 2.0], NORTH).ball([0.0, 2.0, 2.0], 1.0, glass(ior));
    add("critical angle of 1.5 within 1e-6", Stand::Shaken(0.02), Aim::Critical(1.5), 4, inside(1.5));
    add("critical angle of 4 within 1e-6", Stand::Shaken(0.02), Aim::Critical(4.0), 4, inside(4.0));
    add("critical angle of 1.2 within 1e-6", Stand::Shaken(0.02), Aim::Critical(1.2), 4, inside(1.2));
    for (name, ior) in [("index of refraction 1", 1.0), ("index of refraction 1.0001", 1.0001)] {
        add(name, still, Aim::Picture, 5, ahead().ball([0.0, 5.0, 2.0], 1.0, glass(ior)));
    }
    let four = ahead().ball([0.0, 5.0, 2.0], 1.0, glass(4.0)).ball([2.5, 5.0, 2.0], 1.0, glass(0.25));
    add("index of refraction 4 and 1/4", still, Aim::Picture, 5, four);
    let hall = plain([0.0, 0.0, 2.0], [1.0, 0.01, -0.01]).focal(4.0).column([-302.0, 0.0], 300.0, Mirror);
    add("hall of mirrors, depth 32", still, Aim::Picture, 32, hall.column([302.0, 0.0], 300.0, Mirror));

    // Lamps of all strengths at all distances.
    let ball = || ahead().dark().ball([0.0, 5.0, 2.0], 1.0, Shiny);
    add("lamp of 1e6 at 1000", still, Aim::Picture, 2, ball().lamp([-300.0, -400.0, 800.0], 1e6, 2.0));
    add("lamp of 1e6 at 200", still, Aim::Picture, 2, ball().lamp([-60.0, -80.0, 160.0], 1e6, 2.0));
    add("lamp of 1e6 at 0.01", still, Aim::Picture, 2, ball().lamp([0.0, 3.99, 2.0], 1e6, 0.0));
    add("lamp of 1e-4 at 0.01", still, Aim::Picture, 2, ball().lamp([0.0, 3.99, 2.0], 1e-4, 0.001));
    add("lamp of 1e-4 at 1000", still, Aim::Picture, 2, ball().lamp([-300.0, -400.0, 800.0], 1e-4, 2.0));
    // Straight down, at the very place of the floor that the lamp all but touches.
    let touched = plain([0.0, 0.0, 1.0], [0.0, 0.0, -1.0]).dark().lamp([1e-20; 3], 1e4, 0.0);
    add("lamp of 1e4 at 1e-20", Stand::Shaken(0.0), Aim::Center, 2, touched);
    let crowd = (0..1000).fold(ball(), |scene, i| {
        let (ring, turn) = (f64::from(i % 25), f64::from(i) * 0.0097);
        scene.lamp([(4.0 + ring) * turn.sin(), (4.0 + ring) * turn.cos(), 2.0 + 0.3 * ring], 0.1, 0.01)
    });
    add("1000 lamps", still, Aim::Picture, 2, crowd);
    add("no lamp", still, Aim::Picture, 2, ball());
    add("no object", still, Aim::Picture, 2, empty([0.0, 0.0, 2.0], NORTH));

    // Cameras.
    let over = |view: Triple| plain([0.3, 5.2, 5.0], view).ball([0.0, 5.0, 1.0], 1.0, Mirror);
    add("view to the nadir", Stand::Shaken(1e-7), Aim::Picture, 3, over([0.0, 0.0, -1.0]));
    let under = plain([0.3, 5.2, 0.5], [0.0, 0.0, 1.0]).ball([0.0, 5.0, 5.0], 1.0, Mirror);
    add("view to the zenith", Stand::Shaken(1e-7), Aim::Picture, 3, under);
    let focal = |f| ahead().ball([0.0, 5.0, 2.0], 1.0, Mirror).ball([-1.5, 4.0, 0.5], 0.5, Shiny).focal(f);
    add("focal distance 0.01", still, Aim::Picture, 3, focal(0.01));
    add("focal distance 100", still, Aim::Picture, 3, focal(100.0));

    // Thin solids.
    let aslant = [[-3.0, 3.0, 0.5], [3.0, 7.0, 3.0]];
    let rod = |radii, surface| sky(5.0).rod(aslant, radii, surface);
    let thin = 7.6 / 4096.0; // their length is 7.6
    add("cylinder 4096 : 1", stir, Aim::Silhouette, 2, rod([thin; 2], Shiny));
    add("cylinder 4096 : 1, glass", stir, Aim::Silhouette, 5, rod([thin; 2], glass(1.5)));
    add("cone 4096 : 1", stir, Aim::Silhouette, 2, rod([thin, 0.0], Shiny));
    add("cone 64 : 1", stir, Aim::Silhouette, 2, rod([64.0 * thin, 0.0], Shiny));
    let needle = sky(5.0).egg([0.0, 5.0, 0.0], [2.0, 2.0 / 4096.0, 2.0 / 4096.0], Shiny);
    add("ellipsoid 4096 : 1 : 1", stir, Aim::Silhouette, 2, needle);
    add("the apex of a cone", stir, Aim::Apex, 2, rod([1.0, 0.0], Shiny));
    let tube = |surface| sky(5.0).rod([[0.0, 2.0, 0.0], [0.0, 8.0, 0.0]], [1.0, 1.0], surface);
    add("along the axis of a tube", stir, Aim::Axis, 2, tube(Shiny));
    add("along the axis of a mirror tube", Stand::Shaken(0.2), Aim::Axis, 5, tube(Mirror));
    add("along the axis of a glass tube", Stand::Shaken(0.2), Aim::Axis, 5, tube(glass(1.5)));

    // Meshes: slivers, normals that differ much from the face's, and surfaces in one place.
    let sliver = [[-3.0, 5.0, -1.0], [3.0, 5.0, 1.0], [3.0, 5.0, 1.0 + 6.0 / 4096.0]];
    add("triangle 4096 : 1", stir, Aim::Edge, 2, sky(5.0).patch(sliver, None, Shiny));
    let corners = [[-2.0, 5.0, -1.5], [2.0, 5.0, -1.5], [0.0, 5.0, 2.0]];
    let bent = Some([[-0.8, -0.6, 0.0], [0.8, -0.6, 0.0], [0.0, -0.6, 0.8]]);
    for (name, depth, surface) in
        [("normals of a mirror, mixed", 4, Mirror), ("normals of a glass, mixed", 5, glass(1.5))]
    {
        add(name, still, Aim::Picture, depth, sky(5.0).patch(corners, bent, surface));
    }
    let [a, b, c] = [[-0.3, 4.0, -1.0], [1.7, 6.0, -0.5], [-1.1, 5.2, 2.0]];
    let turned = |surface| {
        let orders = [[a, b, c], [c, b, a], [b, c, a]];
        orders.into_iter().fold(sky(5.0), |scene, vertices| scene.patch(vertices, None, surface))
    };
    add("coincident triangles", still, Aim::Picture, 3, turned(Opaque));
    add("coincident triangles, mirrors", still, Aim::Picture, 3, turned(Mirror));

    for case in &mut cases {
        case.thinning = match case.aim {
            Aim::Center => 1000, // they are all the same
            _ if case.scene.lamps.len() == 1000 => 100,
            _ => 1,
        };
    }
    cases.extend(models::all());
    cases.extend(spread::all());
    cases
}
