//! Radiosity: the light of all diffuse surfaces of a scene, in a number format that is chosen when the program runs.

use core::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use rta_args::radiosity::{Factors, Method};
use rta_core::color::Rgb;
use rta_core::needs::Everything;
use rta_core::radiosity::{self, Casts, HemiCube, Matrix, Mesh, Rays, Solver, Stop};
use rta_core::range::Admitted;
use rta_core::scalar::Scalar;
use rta_packets::{Packets, ShadowCache, ToF32};
use rta_scenes::description::Description;
use rta_scenes::in_format;
use rta_scenes::narrow::quads::quads;
use rta_scenes::narrow::{Narrow, narrow};
use rta_scenes::solution::{Arriving, Solution, patch_areas, patch_count};

use super::bands::BandsError;
use super::progress::Progress;
use super::{EngineError, Format};

mod counted;
mod exact;
mod light;

use counted::Counted;
pub use exact::is_plain_room;
use light::{Found, gathered, rows, shot};

/// The most patches whose factors are kept: 512 MB of them in `f64`.
pub const MOST_IN_MATRIX: usize = 8192;

/// How often a patch asks what emits for light, each time from four places of it by a ray to another place on each patch that emits: where it
/// lies in a shadow's edge, one time has much noise.
const LAMP_ROUNDS: u32 = 4;

/// How a scene is solved.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// Number format.
    pub format: Format,
    /// How the light is found.
    pub method: Method,
    /// What a patch sees; `None` for exact factors where there are such, and else 64 rays.
    pub factors: Option<Factors>,
    /// Patches along both sides of each quad, where they are not those of the scene.
    pub patches: Option<u16>,
    /// Seed of the rays.
    pub seed: u32,
    /// The most sweeps, or a hundredth of the most shots.
    pub sweeps: Option<u16>,
}

/// A solved scene.
#[derive(Clone, Debug)]
pub struct Solved {
    /// The scene as it was solved: all of it that takes part is quads.
    pub scene: Description,
    /// What arrives at its patches.
    pub solution: Solution,
    /// The radiosity of its patches, linear RGB.
    pub radiosity: Vec<[f64; 3]>,
    /// What it was solved with.
    pub factors: Factors,
    /// Sweeps, or shots.
    pub rounds: u32,
    /// The largest change in the last sweep, or the part of what was emitted that is unshot.
    pub left: f64,
    /// Whether that is small enough.
    pub is_done: bool,
    /// What is emitted, and what surfaces absorb, each a sum over areas, linear RGB.
    pub balance: [[f64; 3]; 2],
    /// Rays that it took, of factors and to what emits.
    pub rays: u64,
}

/// Why a scene is not solved.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RadiosityError {
    /// It has nothing that takes part.
    #[error(
        "nothing in it takes part: radiosity is for quads, boxes, triangles and polygons that reflect diffusely"
    )]
    NoQuads,
    /// It has nothing that emits light.
    #[error("nothing in it emits: give a quad a material that emits")]
    NoLight,
    /// A part of a quad that emits holds the middle of no patch.
    #[error("quad {0} emits in a part that holds the middle of none of its patches: it needs more patches")]
    NoPatch(usize),
    /// A hemi-cube has no such number of cells.
    #[error("a hemi-cube has an even number of cells along a side, up to 1024, not {0}")]
    Cells(u16),
    /// Exact factors are not known.
    #[error(
        "exact factors are for rooms whose sides are rectangles along the axes, with nothing in them: --factors rays or hemicube"
    )]
    NoRoom,
    /// There are too many patches for all factors to be kept.
    #[error(
        "{0} patches are too many for {MOST_IN_MATRIX}, whose factors are kept: --method gather or shoot"
    )]
    Patches(usize),
    /// There is no patch of that name.
    #[error("{}", no_such_patch(*wall, *number, *quads, *patches))]
    NoSuchPatch {
        /// The quad, from 0.
        wall: usize,
        /// The patch, from 0.
        number: usize,
        /// How many quads there are.
        quads: usize,
        /// How many patches the quad has along u and v, if there is one.
        patches: Option<[u16; 2]>,
    },
    /// A quad, or the light, does not fit.
    #[error(transparent)]
    Radiosity(#[from] radiosity::Error),
    /// The scene does not fit the number format.
    #[error(transparent)]
    Engine(#[from] EngineError),
    /// It was interrupted.
    #[error(transparent)]
    Bands(#[from] BandsError),
}

fn no_such_patch(wall: usize, number: usize, quads: usize, patches: Option<[u16; 2]>) -> String {
    match patches {
        None => format!("there is no quad {wall}: it has {quads}, from 0"),
        Some([nu, nv]) => {
            let count = u32::from(nu) * u32::from(nv);
            format!("there is no patch {number} in quad {wall}: it has {count}, from 0")
        }
    }
}

/// Solves for the radiosity of a scene.
///
/// # Errors
/// [`RadiosityError`]; [`BandsError::Interrupted`] soon after `stop` becomes true.
pub fn solve(scene: &Description, settings: &Settings, stop: &AtomicBool) -> Result<Solved, RadiosityError> {
    let scene = scene.meshed(settings.patches);
    let mut emits = false;
    for (number, quad) in scene.quads.iter().enumerate() {
        if scene.emission(quad).is_some() {
            let [[i, j], [k, l]] = quad.emitting_patches();
            if i >= k || j >= l {
                return Err(RadiosityError::NoPatch(number));
            }
            emits = true;
        }
    }
    if scene.quads.is_empty() {
        return Err(RadiosityError::NoQuads);
    }
    if !emits {
        return Err(RadiosityError::NoLight);
    }
    let count = patch_count(&scene.quads);
    let is_plain = is_plain_room(&scene);
    let factors = settings.factors.unwrap_or(if is_plain && count <= MOST_IN_MATRIX / 4 {
        Factors::Exact
    } else {
        Factors::Rays(64)
    });
    if factors == Factors::Exact && !is_plain {
        return Err(RadiosityError::NoRoom);
    }
    // Exact factors are kept, whatever the method.
    let method = match settings.method {
        Method::Gather if factors == Factors::Exact => Method::Seidel,
        method => method,
    };
    if matches!(method, Method::Seidel | Method::Gauss) && count > MOST_IN_MATRIX {
        return Err(RadiosityError::Patches(count));
    }
    let settings = Settings { method, ..*settings };
    in_format!(settings.format, S => solved_in::<S>(scene, (settings, factors), stop))
}

fn solved_in<S: Narrow + ToF32>(
    scene: Description,
    (settings, factors): (Settings, Factors),
    stop: &AtomicBool,
) -> Result<Solved, RadiosityError> {
    let narrowed = narrow::<S>(&scene, 1.0).map_err(EngineError::from)?;
    let limits = narrowed.admit().map_err(EngineError::from)?.limits;
    let packets = Packets::build::<S>(&scene);
    let rays = AtomicU64::new(0);
    let admitted = Admitted::baked(narrowed.scene(), limits, Counted { search: &packets, rays: &rays });
    let quads = quads::<S>(&scene).map_err(EngineError::from)?;
    let mesh = Mesh::new(&quads, &admitted.scene)?;
    let work = Work { admitted: &admitted, mesh, scene: &scene, settings, stop };
    let found = match factors {
        Factors::Exact => work.found(Rays { count: 64, seed: settings.seed }, true)?,
        Factors::Rays(count) => work.found(Rays { count, seed: settings.seed }, false)?,
        Factors::HemiCube(side) => {
            let cells = HemiCube::new(side).ok_or(RadiosityError::Cells(side))?;
            work.found(cells, false)?
        }
    };
    let areas = patch_areas(&scene);
    let light = |light: Rgb<S::Light>| [light.r, light.g, light.b].map(S::light_to_f64);
    let mut arriving = Vec::with_capacity(areas.len());
    let (mut radiosity, mut balance) = (Vec::with_capacity(areas.len()), [[0.0; 3]; 2]);
    let own = found.direct.iter().zip(&found.indirect).zip(mesh.patches().zip(areas));
    for ((direct, indirect), (patch, area)) in own {
        let own = Arriving { direct: light(*direct), indirect: light(*indirect) };
        let reflectance = quads.get(patch.quad).map_or([0.0; 3], |quad| {
            let Rgb { r, g, b } = quad.reflectance;
            [r, g, b].map(S::unit_to_f64)
        });
        let emitted = light(mesh.emitted(patch));
        let mut bright = [0.0; 3];
        let [sent, absorbed] = &mut balance;
        for ((((((bright, sent), absorbed), rho), emitted), direct), indirect) in bright
            .iter_mut()
            .zip(sent)
            .zip(absorbed)
            .zip(reflectance)
            .zip(emitted)
            .zip(own.direct)
            .zip(own.indirect)
        {
            *bright = emitted + rho * (direct + indirect);
            *sent += area * emitted;
            *absorbed += area * (1.0 - rho) * (direct + indirect);
        }
        radiosity.push(bright);
        arriving.push(own);
    }
    let Found { rounds, left, is_done, .. } = found;
    let solution = Solution { patches: settings.patches, arriving };
    let rays = rays.load(Ordering::Relaxed);
    Ok(Solved { scene, solution, radiosity, factors, rounds, left, is_done, balance, rays })
}

/// A scene that is being solved.
struct Work<'a, S: Scalar> {
    admitted: &'a Admitted<'a, S, Counted<'a, &'a Packets>>,
    mesh: Mesh<'a, S>,
    scene: &'a Description,
    settings: Settings,
    stop: &'a AtomicBool,
}

impl<S: Narrow + ToF32> Work<'_, S> {
    /// Solves by the method, where patches see by `casts`, or, if `is_exact`, by exact factors.
    fn found<C: Casts<S>>(&self, casts: C, is_exact: bool) -> Result<Found<S>, RadiosityError> {
        let Settings { method, seed, sweeps, .. } = self.settings;
        let solver = Solver::<S, Everything, C, _>::new(self.admitted, self.mesh, casts, seed);
        let count = self.mesh.len();
        match method {
            Method::Gather => {
                let stop = Stop { sweeps: sweeps.unwrap_or(16), ..Stop::default() };
                gathered(&solver, self.direct(casts), stop, self.stop)
            }
            Method::Shoot => {
                shot(&solver, self.direct(casts), u32::from(sweeps.unwrap_or(1000)) * 100, self.stop)
            }
            Method::Seidel | Method::Gauss => {
                let mut room = vec![S::unit(0.0); count * count];
                let mut progress = Progress::new(u32::try_from(count).unwrap_or(u32::MAX));
                let mut number = 0;
                let exact = is_exact.then(|| exact::Rectangles::of(self.scene));
                let matrix = Matrix::new(self.mesh, &mut room, |patch, row| {
                    number += 1;
                    progress.reached(number);
                    if self.stop.load(Ordering::Relaxed) {
                        return Ok(());
                    }
                    match &exact {
                        Some(rectangles) => {
                            rectangles.row::<S>(number as usize - 1, row);
                            Ok(())
                        }
                        None => solver.factors(patch, row),
                    }
                })?;
                if self.stop.load(Ordering::Relaxed) {
                    return Err(BandsError::Interrupted.into());
                }
                rows(
                    &matrix,
                    method == Method::Gauss,
                    Stop { sweeps: sweeps.unwrap_or(1000), bits: Stop::STILL },
                )
            }
        }
    }

    /// Returns what arrives at each patch straight from what emits: the mean of several solvers with different places on lamps.
    fn direct<C: Casts<S>>(&self, casts: C) -> Vec<Rgb<S::Light>> {
        let mut sums = vec![[0.0; 3]; self.mesh.len()];
        let mut cache = ShadowCache::default();
        for number in 0..LAMP_ROUNDS {
            let seed = self.settings.seed.wrapping_add(number);
            let solver = Solver::<S, Everything, C, _>::new(self.admitted, self.mesh, casts, seed);
            for (sum, patch) in sums.iter_mut().zip(self.mesh.patches()) {
                let Rgb { r, g, b } = solver.arriving(patch, &mut cache);
                sum.iter_mut().zip([r, g, b]).for_each(|(sum, light)| *sum += S::light_to_f64(light));
            }
        }
        let mean = |sum: [f64; 3]| {
            let [r, g, b] = sum.map(|sum| S::light(sum / f64::from(LAMP_ROUNDS)));
            Rgb::new(r, g, b)
        };
        sums.into_iter().map(mean).collect()
    }
}
