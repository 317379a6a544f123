//! A case of the benchmark: a scene, and how it is traced.

use core::sync::atomic::AtomicBool;
use core::time::Duration;
use std::path::Path;
use std::time::Instant;

use cpu_time::ThreadTime;
use rta_core::color::Rgb;
use rta_scenes::description::Description;

use super::spheres;
use crate::args::ShowArgs;
use crate::engine::bands;
use crate::engine::{Engine, Format};
use crate::picture::device::Target;
use crate::picture::error::PictureError;
use crate::picture::raster::Size;
use crate::request::Request;
use crate::request::scene_file::SceneFile;
use crate::study::error::StudyError;

/// How the benchmark traces each scene.
#[derive(Clone, Copy, Debug)]
pub struct Tracing {
    /// Number format.
    pub format: Format,
    /// Pixels, or as many as the scene says.
    pub size: Option<Size>,
    /// Recursion depth.
    pub depth: u32,
}

/// A scene, ready to be traced.
pub struct Case {
    /// The scene.
    pub scene: SceneFile,
    /// The text of its file; none for scenes that are part of the program.
    pub text: Option<Vec<u8>>,
    /// How it is traced.
    pub request: Request,
    /// The tracer.
    engine: Engine,
    size: Size,
}

impl Case {
    /// Returns the case of a scene file.
    ///
    /// # Errors
    /// Those of reading the scene and making it ready.
    pub fn file(path: &Path, tracing: Tracing) -> Result<Self, StudyError> {
        let (scene, text) = SceneFile::open_with_text(path)?;
        Ok(Self { text: Some(text), ..Self::new(scene, tracing)? })
    }

    /// Returns the case of a scene that is part of the program, or of random spheres.
    ///
    /// # Errors
    /// [`StudyError::NoScene`], and those of making the scene ready.
    pub fn named(name: &str, tracing: Tracing) -> Result<Self, StudyError> {
        let scene = match (SceneFile::named(name), spheres::count(name)) {
            (Some(scene), _) => scene?,
            (None, Some(count)) => spheres::scene(count),
            (None, None) => return Err(StudyError::NoScene(name.to_owned())),
        };
        Self::new(scene, tracing)
    }

    fn new(scene: SceneFile, tracing: Tracing) -> Result<Self, StudyError> {
        let Tracing { format, size, depth } = tracing;
        let asked =
            Request { format, size, depth, ..Request::of(&ShowArgs::default().tracing, Target::None) };
        // With the model that the scene was made for, so that rows can be compared with those of other versions.
        let request = asked.for_scene(None, &scene)?;
        let (engine, (size, _)) = (request.engine(&scene)?, request.raster()?);
        Ok(Self { scene, text: None, request, engine, size })
    }

    /// Pixels of the picture.
    #[must_use]
    pub const fn size(&self) -> Size {
        self.size
    }

    /// The tracer.
    #[must_use]
    pub const fn engine(&self) -> &Engine {
        &self.engine
    }

    /// Returns the number of objects, without floor and lamps.
    #[must_use]
    pub fn objects(&self) -> usize {
        let Description { cylinders, ellipsoids, spheres, cones, triangles, planes, .. } =
            &self.scene.description;
        cylinders.len() + ellipsoids.len() + spheres.len() + cones.len() + triangles.len() + planes.len()
    }

    /// Returns a black picture to trace into.
    ///
    /// # Errors
    /// [`PictureError::Memory`].
    pub fn picture(&self) -> Result<Vec<Rgb<u8>>, StudyError> {
        let mut picture = Vec::new();
        picture.try_reserve_exact(self.size.pixels()).map_err(|_| PictureError::Memory(self.size))?;
        picture.resize(self.size.pixels(), Rgb::default());
        Ok(picture)
    }

    /// Traces the picture on the calling thread and returns the CPU time that it takes.
    pub fn time(&self, picture: &mut [Rgb<u8>]) -> Duration {
        let start = ThreadTime::now();
        traced_picture(&self.engine, picture);
        start.elapsed()
    }

    /// Traces the picture with several threads, like a picture file, and returns the elapsed time.
    ///
    /// # Errors
    /// All of [`BandsError`](bands::BandsError).
    pub fn elapsed(&self, threads: u16, stop: &AtomicBool) -> Result<Duration, StudyError> {
        let pool = bands::pool(Some(threads))?;
        let start = Instant::now();
        let trace = |first, levels: &mut [_]| self.engine.level_rows(first, u8::MAX, levels);
        bands::bands(self.size, &pool, stop, trace, |_, band: Vec<Rgb<u8>>| {
            core::hint::black_box(band);
            Ok::<_, StudyError>(())
        })?;
        Ok(start.elapsed())
    }
}

/// The function that is measured: callgrind is told its name, so it must not be inlined.
#[inline(never)]
pub(super) fn traced_picture(engine: &Engine, picture: &mut [Rgb<u8>]) {
    engine.level_rows(0, u8::MAX, picture);
    // Something is left to do, so that this function is there until the picture is.
    core::hint::black_box(picture);
}

#[cfg(test)]
mod tests {
    use core::sync::atomic::AtomicBool;

    use super::{Case, Tracing};
    use crate::engine::Format;
    use crate::engine::bands::BandsError;
    use crate::study::error::StudyError;

    const TRACING: Tracing = Tracing { format: Format::F32, size: None, depth: 5 };

    #[test]
    fn every_scene_has_its_own_size() {
        let about = |name: &str| {
            let case = Case::named(name, TRACING).expect("it is in the program");
            let (size, aspect) = case.request.raster().expect("a size");
            (case.objects(), size.to_string(), aspect)
        };
        assert_eq!(about("hall-22"), (22, "320x200".to_owned(), 4.0 / 3.0));
        assert_eq!(about("balls2"), (93, "512x512".to_owned(), 1.0));
        assert_eq!(about("spheres-22"), (22, "512x512".to_owned(), 1.0));
        assert!(
            matches!(Case::named("nothing", TRACING), Err(StudyError::NoScene(name)) if name == "nothing")
        );
    }

    #[test]
    fn random_spheres_take_no_rays_but_the_eyes_and_are_seen() {
        let case = Case::named("spheres-1000", TRACING).expect("it is in the program");
        assert_eq!(case.engine().rays(), [512 * 512, 0, 0, 0]);
        let mut picture = case.picture().expect("memory");
        assert!(case.time(&mut picture) > core::time::Duration::ZERO);
        let sky = picture.iter().filter(|pixel| Some(*pixel) == picture.first()).count();
        assert!((30_000..230_000).contains(&sky), "{sky} pixels of sky");
        case.elapsed(2, &AtomicBool::new(false)).expect("nothing stops it");
        assert!(matches!(
            case.elapsed(2, &AtomicBool::new(true)),
            Err(StudyError::Bands(BandsError::Interrupted))
        ));
    }
}
