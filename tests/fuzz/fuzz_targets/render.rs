//! Whatever a number format admits is drawn, without a panic in a build that checks every operation, and with light that
//! is a number.
#![no_main]

use arbitrary::Arbitrary;
use libfuzzer_sys::fuzz_target;
use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, Rta, Whitted};
use rta_core::needs::Everything;
use rta_core::raster::{Pixels, Raster};
use rta_core::trace::Tracer;
use rta_core::{Q16, Q20};
use rta_scenes::description::{
    Camera, Cylinder, Description, Ellipsoid, FallOff, Floor, Lamp, Sky, Sphere, Surface,
};
use rta_scenes::narrow::{Narrow, Narrowed, narrow};
use rta_scenes::{dat, shipped};

/// A number that is more often interesting than not.
#[derive(Arbitrary, Clone, Copy, Debug)]
enum Number {
    /// Any bits at all, as long as they are finite.
    Any(f64),
    /// Scene size: -128 to 128 in steps of 1/256.
    Usual(i16),
    /// From -1 to 1.
    Part(i32),
    /// A power of two, next to which formats end, and a little more or less.
    Power { exponent: i8, off: i8, negative: bool },
    /// 0.
    Zero,
}

impl Number {
    fn value(self) -> f64 {
        match self {
            Self::Any(value) if value.is_finite() => value,
            Self::Any(_) | Self::Zero => 0.0,
            Self::Usual(n) => f64::from(n) / 256.0,
            Self::Part(n) => f64::from(n) / f64::from(i32::MAX),
            Self::Power { exponent, off, negative } => {
                let size = f64::from(exponent).exp2() * (1.0 + f64::from(off) * 2f64.powi(-30));
                if negative { -size } else { size }
            }
        }
    }

    /// What a reader takes for a radius.
    fn positive(self) -> f64 {
        self.value().abs().max(f64::MIN_POSITIVE)
    }
}

type Triple = [Number; 3];

fn values(triple: Triple) -> [f64; 3] {
    triple.map(Number::value)
}

fn sizes(triple: Triple) -> [f64; 3] {
    triple.map(|number| number.value().abs())
}

#[derive(Arbitrary, Clone, Copy, Debug)]
enum Made {
    Opaque,
    Shiny,
    Mirror,
    Glass { ks: u16, ior: Number },
}

impl Made {
    fn surface(self) -> Surface {
        match self {
            Self::Opaque => Surface::Opaque,
            Self::Shiny => Surface::Shiny,
            Self::Mirror => Surface::Mirror,
            Self::Glass { ks, ior } => {
                let ks = f64::from(ks) / f64::from(u16::MAX);
                Surface::Transparent { ks, kt: 1.0 - ks, ior: ior.positive() }
            }
        }
    }
}

#[derive(Arbitrary, Clone, Copy, Debug)]
enum Thing {
    Ball(Triple, Number, Triple, Made),
    Egg(Triple, Triple, Triple, Made),
    Column(Triple, Number, Triple, Made),
    Light(Triple, Option<Number>, Triple),
}

#[derive(Arbitrary, Debug)]
struct Input {
    base: u8,
    eye: Option<Triple>,
    view: Option<Triple>,
    focal: Option<Number>,
    floor: Option<[Triple; 2]>,
    lights: Option<[Triple; 3]>,
    things: Vec<Thing>,
    depth: u8,
    aspect: u8,
}

impl Input {
    /// The scene: a shipped one or none, and what is added to it.
    fn scene(&self) -> Description {
        let mut scene = match shipped::ALL.get(usize::from(self.base) % 8) {
            Some((name, text)) => dat::read(text.as_bytes(), name).expect("a shipped scene"),
            None => Description {
                ambient: [0.2; 3],
                sky: Sky { horizon: [0.8; 3], zenith: [0.2, 0.3, 0.6] },
                ..Description::empty(Camera::upright([0.0, 0.0, 2.0], [0.0, 1.0, 0.0], 1.0))
            },
        };
        if let Some(eye) = self.eye {
            scene.camera.eye = values(eye);
        }
        if let Some(view) = self.view {
            scene.camera.view = values(view);
        }
        if let Some(focal) = self.focal {
            scene.camera.focal = focal.positive();
        }
        if let Some(colors) = self.floor {
            scene.floor = Some(Floor { colors: colors.map(sizes), surface: Surface::Opaque });
        }
        if let Some([ambient, horizon, zenith]) = self.lights {
            scene.ambient = sizes(ambient);
            scene.sky = Sky { horizon: sizes(horizon), zenith: sizes(zenith) };
        }
        for &thing in self.things.iter().take(12) {
            match thing {
                Thing::Ball(position, radius, color, made) => scene.spheres.push(Sphere {
                    position: values(position),
                    color: sizes(color),
                    radius: radius.positive(),
                    surface: made.surface(),
                    line: 0,
                }),
                Thing::Egg(position, radii, color, made) => scene.ellipsoids.push(Ellipsoid {
                    position: values(position),
                    color: sizes(color),
                    radii: radii.map(Number::positive),
                    inside_only: false,
                    surface: made.surface(),
                    line: 0,
                }),
                Thing::Column(position, radius, color, made) => scene.cylinders.push(Cylinder {
                    position: values(position),
                    color: sizes(color),
                    radius: radius.positive(),
                    surface: made.surface(),
                    line: 0,
                }),
                Thing::Light(position, radius, color) => scene.lamps.push(Lamp {
                    position: values(position),
                    color: sizes(color),
                    radius: radius.map_or(0.0, |radius| radius.value().abs()),
                    fall_off: FallOff::OfModel,
                    line: 0,
                }),
            }
        }
        scene
    }
}

fn draw<S: Narrow>(scene: &Description, aspect: f64, depth: u32) {
    // What a format does not admit is not drawn; that is all there is to it.
    let Ok(narrowed) = narrow::<S>(scene, aspect) else { return };
    render(&narrowed, Rta, depth);
    render(&narrowed, Whitted::default(), depth);
}

fn render<S: Narrow, M: Illumination<S>>(narrowed: &Narrowed<S>, model: M, depth: u32) {
    let Ok(admitted) = narrowed.admit() else { return };
    let tracer: Tracer<_, _, Everything, 8> = Tracer::new(&admitted, model, depth).expect("no deeper than 8");
    let raster = Raster::new(7, 5).expect("a small one");
    for light in Pixels::new(&tracer, &narrowed.camera, raster) {
        let Rgb { r, g, b } = light.map(S::light_to_f64);
        assert!([r, g, b].iter().all(|part| part.is_finite() && *part >= 0.0), "{} {r} {g} {b}", S::NAME);
    }
}

fuzz_target!(|input: Input| {
    let scene = input.scene();
    let aspect = 2f64.powi(i32::from(input.aspect % 5) - 2);
    let depth = u32::from(input.depth % 9);
    draw::<f32>(&scene, aspect, depth);
    draw::<Q16>(&scene, aspect, depth);
    draw::<Q20>(&scene, aspect, depth);
});
