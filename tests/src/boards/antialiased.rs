//! Pictures with adaptive antialiasing as boards draw them: the engine's rays in the core's rows, packed to three bytes a pixel. Unlike the
//! host, a board cuts no pixel for things in it that are smaller.

use rta::engine::{Format, Settings};
use rta_core::Q16;
use rta_core::camera::Camera;
use rta_core::color::Rgb;
use rta_core::raster::Raster;
use rta_core::raster::contrast::Contrasts;
use rta_core::raster::corners::{Corners, Cutting, Packed};
use rta_core::trace::dice::Sample;
use rta_core::trace::{Observer, Trace};
use rta_core::vector::{UnitVec3, Vec3};
use rta_packets::ShadowCache;
use rta_packets::picture::{Format as Traced, Picture as Rays, Setup};
use rta_scenes::description::Description;
use rta_scenes::narrow::Narrow;
use rta_scenes::sampler::{Adaptive, Sampler};

use super::Failure;
use super::picture::Picture;

/// Light in a row of memory.
type Kept = Packed<{ u8::MAX }>;

/// Room for the light within a pixel.
const PLACES: usize = Cutting::places(Cutting::most());

/// Draws a row of a picture: its number, the greatest level, and the levels of its pixels.
pub(super) type Rows = Box<dyn FnMut(u32, u8, &mut [Rgb<u8>])>;

/// The rays of a picture, one by one.
struct Single<'a, S: Narrow>(&'a dyn Rays<S>);

impl<S: Narrow> Trace<S> for Single<'_, S> {
    type Memory = ShadowCache;

    /// In the middle of the picture: whoever asks for a direction has no place.
    fn trace<O: Observer<S> + ?Sized>(
        &self,
        _origin: Vec3<S>,
        _direction: UnitVec3<S>,
        memory: &mut ShadowCache,
        _observer: &mut O,
    ) -> Rgb<S::Light> {
        self.0.sample((S::unit(0.0), S::unit(0.0)), Sample::default(), memory, &mut ())
    }

    fn sample<O: Observer<S> + ?Sized>(
        &self,
        _camera: &Camera<S>,
        place: (S::Unit, S::Unit),
        sample: Sample,
        memory: &mut ShadowCache,
        _observer: &mut O,
    ) -> Rgb<S::Light> {
        self.0.sample(place, sample, memory, &mut ())
    }
}

/// Returns the rows of a picture in Q16.16 or f32.
pub(super) fn rows(
    (picture, scene): (&Picture, &Description),
    size: (u32, u32),
    adaptive: Adaptive,
) -> Result<Rows, Failure> {
    match picture.format {
        Format::Q16 => drawn::<Q16>((picture, scene), size, adaptive),
        Format::F32 => drawn::<f32>((picture, scene), size, adaptive),
        other => Err(format!("no board is antialiased in {other}").into()),
    }
}

fn drawn<S: Traced>(
    (picture, scene): (&Picture, &Description),
    (width, height): (u32, u32),
    adaptive: Adaptive,
) -> Result<Rows, Failure> {
    let raster = Raster::new(width, height)?;
    let Settings { aspect, depth, .. } = Settings::default();
    let setup = Setup { raster, aspect, depth, cutoff: None, sampling: Sampler::CENTER };
    let single = S::picture(scene, picture.model.unwrap_or(scene.model), &setup)?;
    let (rays, view, mut light) = (Single(&*single), (&single.scene().camera, raster), Vec::new());
    let row = width as usize;
    match adaptive {
        Adaptive::Whitted(cutting) => {
            let mut above = vec![Kept::default(); row + 1];
            let rows = Corners::<S, _, PLACES, _>::new(&rays, view, cutting, &mut above, 0);
            let mut rows = rows.ok_or("a row has too little room")?;
            while rows.next_row(|pixel| light.push(pixel)) {}
        }
        Adaptive::Mitchell => {
            let mut memory = vec![Kept::default(); 3 * row];
            let rows = Contrasts::new(&rays, view, 0, &mut memory, 0);
            let mut rows = rows.ok_or("a row has too little room")?;
            while rows.next_row(|pixel| light.push(pixel)) {}
        }
    }
    Ok(Box::new(move |y, most, levels| {
        let own = light.chunks_exact(row).nth(y as usize).unwrap_or_default();
        levels.iter_mut().zip(own).for_each(|(level, light)| *level = light.levels(most));
    }))
}
