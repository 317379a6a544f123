//! Whether a number format admits a scene: the range proof in a format that is chosen when the program runs.

use rta_core::accelerator::Lists;
use rta_core::range::Bound;
use rta_scenes::OutOfRange;
use rta_scenes::description::Description;
use rta_scenes::in_format;
use rta_scenes::narrow::{Narrow, NarrowError, narrow};

use super::Format;

/// The formats in the order in which they are suggested: fixed point first, the finest that fits.
const SUGGESTED: [Format; 4] = [Format::Q20, Format::Q16, Format::F32, Format::F64];

/// The range proof of a scene in a number format, and whether it holds.
#[derive(Debug)]
pub struct Verdict {
    /// The bounds of all quantities; none where the scene's own numbers do not fit the format.
    pub rows: Vec<Bound>,
    /// Why the scene is refused, if it is.
    pub refused: Option<Refusal>,
}

/// Why a scene is refused.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Refusal {
    /// A number of the scene does not fit the format.
    #[error(transparent)]
    Narrow(#[from] NarrowError),
    /// A quantity that the tracer computes may not fit the format.
    #[error(transparent)]
    Range(#[from] OutOfRange),
}

/// Returns the range proof of a scene in `format`, for a screen of the shape `aspect : 1`.
pub fn verdict(scene: &Description, format: Format, aspect: f64) -> Verdict {
    in_format!(format, S => prove::<S>(scene, aspect))
}

fn prove<S: Narrow>(scene: &Description, aspect: f64) -> Verdict {
    match narrow::<S>(scene, aspect) {
        Err(error) => Verdict { rows: Vec::new(), refused: Some(error.into()) },
        Ok(narrowed) => {
            let proof = narrowed.scene().prove(&narrowed.camera, &Lists);
            Verdict {
                rows: proof.bounds.to_vec(),
                refused: proof.refused.map(|error| OutOfRange::new(error, scene).into()),
            }
        }
    }
}

/// Returns whether a format admits a scene, for a screen of the shape `aspect : 1` and rays of this depth.
pub fn admits(scene: &Description, format: Format, aspect: f64, depth: u32) -> bool {
    fn admits<S: Narrow>(scene: &Description, aspect: f64, depth: u32) -> bool {
        narrow::<S>(scene, aspect).is_ok_and(|narrowed| {
            let admitted = narrowed.admit();
            admitted.is_ok_and(|admitted| depth <= u32::from(admitted.limits.depth))
        })
    }
    in_format!(format, S => admits::<S>(scene, aspect, depth))
}

/// Returns the formats other than `format` that admit the scene, the finest fixed point first.
pub fn alternatives(scene: &Description, format: Format, aspect: f64, depth: u32) -> Vec<Format> {
    let mut fitting: Vec<Format> = Vec::with_capacity(SUGGESTED.len());
    for other in SUGGESTED.into_iter().filter(|other| *other != format) {
        // All limits of f64 are beyond those of f32.
        let is_wider = other == Format::F64 && fitting.contains(&Format::F32);
        if is_wider || admits(scene, other, aspect, depth) {
            fitting.push(other);
        }
    }
    fitting
}

#[cfg(test)]
mod tests {
    use rta_scenes::{dat, shipped};

    use super::*;

    #[test]
    fn shipped_scenes_are_admitted_to_every_format() {
        for (name, text) in shipped::ALL {
            let scene = dat::read(text.as_bytes(), name).expect("a shipped scene");
            for format in SUGGESTED {
                let verdict = verdict(&scene, format, 4.0 / 3.0);
                assert!(verdict.refused.is_none(), "{name} in {format}: {:?}", verdict.refused);
                assert_eq!(verdict.rows.len(), 13);
            }
        }
    }

    #[test]
    fn a_wide_scene_is_refused_by_name_and_another_format_suggested() {
        let mut scene = dat::read(shipped::GLASS_2.as_bytes(), "glass-2.dat").expect("a shipped scene");
        scene.lamps.iter_mut().for_each(|lamp| lamp.position = [0.0, 1500.0, 900.0]);
        let refusal = verdict(&scene, Format::Q20, 1.0).refused.expect("it is too wide").to_string();
        assert!(
            refusal.starts_with("lamp 1 (line 11) and the observer are out of the number format's range: distance between two places 17"),
            "{refusal}"
        );
        assert!(refusal.ends_with("beyond the largest 1536"), "{refusal}");
        assert_eq!(alternatives(&scene, Format::Q20, 1.0, 5), [Format::Q16, Format::F32, Format::F64]);
    }

    #[test]
    fn a_mirror_that_makes_light_is_refused_where_its_weights_do_not_fit() {
        let mut scene = dat::read(shipped::HALL_22.as_bytes(), "hall-22.dat").expect("a shipped scene");
        scene.spheres.iter_mut().for_each(|sphere| sphere.color = [1.1, 0.5, 0.5]);
        let verdict = verdict(&scene, Format::Q16, 1.0);
        assert!(verdict.refused.is_none());
        let row = verdict.rows.iter().map(|row| row.quantity.to_string()).find(|row| row.contains("weight"));
        assert_eq!(row.as_deref(), Some("weight of a ray at depth 7"));
        for (depth, fitting) in
            [(7, [Format::Q20, Format::F32, Format::F64].as_slice()), (8, &[Format::F32, Format::F64])]
        {
            assert_eq!(admits(&scene, Format::Q16, 1.0, depth), depth == 7);
            assert_eq!(alternatives(&scene, Format::Q16, 1.0, depth), fitting);
        }
    }
}
