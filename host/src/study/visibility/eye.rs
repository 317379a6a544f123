//! From faces of the world to triangles of integers before the eye.
//!
//! Faces are put in the eye's frame, clipped by the pyramid of the picture (I. Sutherland and G. Hodgman, "Reentrant Polygon Clipping", 1974) and by
//! a plane before the eye, scaled by a power of two so that all components are below 2^16, and snapped to integers. An edge that two faces share
//! is clipped to the same points in both, so no gap opens.

use rta_scenes::description::{Camera, Description};
use rta_scenes::narrow::narrow;
use rta_scenes::space::{Triple, difference, dot, unit};

use super::faces::Face;
use super::integer::{LARGEST, Raster, Triangle, View};
use crate::picture::raster::{Size, fraction};
use crate::study::error::StudyError;

/// The least distance of a vertex from the plane of the eye, in units of the integers.
const NEAREST: f64 = 16.0;

/// The most pixels of a picture.
const MOST_PIXELS: usize = 1 << 24;

/// What the eye sees of faces.
#[derive(Clone, Debug)]
pub struct Seen {
    /// The triangles and the pixels.
    pub view: View,
    /// Units of the integers in a unit of the scene, as a power of two.
    pub scale: i32,
    /// Faces of which nothing is in the pyramid.
    pub outside: usize,
    /// Faces that were clipped.
    pub clipped: usize,
    /// Triangles that have no area once they are snapped, or are seen on edge.
    pub degenerate: usize,
    /// Triangles that are seen from outside alone, and are seen from inside.
    pub turned: usize,
}

impl Seen {
    /// Returns what a camera sees of faces on a screen of the shape `aspect : 1`, from the distance `hither` on.
    ///
    /// # Errors
    /// [`StudyError::Visibility`] for a picture of more than 2^24 pixels or a camera that `f64` cannot hold, and [`StudyError::Raster`].
    pub fn new(
        faces: &[Face],
        camera: &Camera,
        (size, aspect): (Size, f64),
        hither: f64,
    ) -> Result<Self, StudyError> {
        if size.pixels() > MOST_PIXELS {
            return Err(StudyError::Visibility(
                format!("a picture of {size} has more than 2^24 pixels").into(),
            ));
        }
        let plane = narrow::<f64>(&Description::empty(camera.clone()), aspect);
        let plane = plane.map_err(|error| StudyError::Visibility(error.into()))?.camera;
        let [forward, right, up] = [plane.forward, plane.right, plane.up].map(|v| [v.x, v.y, v.z]);
        let [focal, width] = [forward, right].map(|v| dot(v, v).sqrt());
        let raster = Raster::new(size, fraction(aspect), focal / width)?;
        let axes = [right, up, forward].map(|axis| unit(axis).unwrap_or_default());
        let seen = |vertex: Triple| axes.map(|axis| dot(difference(vertex, camera.eye), axis));

        let [x, y, z] = raster.corner().map(|c| c as f64);
        let pyramid = [[-z, 0.0, x], [z, 0.0, x], [0.0, -z, y], [0.0, z, y]];
        let mut polygons: Vec<_> = faces
            .iter()
            .map(|face| {
                let polygon = face.vertices.map(seen).to_vec();
                (pyramid.iter().fold(polygon, |polygon, normal| clipped(&polygon, (*normal, 0.0))), face)
            })
            .collect();
        let components = polygons.iter().flat_map(|(polygon, _)| polygon).flatten();
        let largest = components.fold(0.0_f64, |most, c| most.max(c.abs()));
        if !largest.is_finite() {
            return Err(StudyError::Visibility("a place of the scene is too far away".into()));
        }
        // From the largest scale on; no component is anything but 0 if the largest is.
        let fits = |power: &i32| largest * 2f64.powi(*power) <= LARGEST as f64;
        let scale = if largest > 0.0 { (-1000..1000).rev().find(fits).unwrap_or(0) } else { 0 };
        let unit = 2f64.powi(scale);
        let near = (NEAREST / unit).max(hither);
        let view = View { raster, triangles: Vec::new() };
        let mut seen = Self { view, scale, outside: 0, clipped: 0, degenerate: 0, turned: 0 };
        for (polygon, face) in &mut polygons {
            *polygon = clipped(polygon, ([0.0, 0.0, 1.0], near));
            seen.add(polygon, face, unit);
        }
        Ok(seen)
    }

    /// Adds a clipped face as a fan of triangles.
    fn add(&mut self, polygon: &[Triple], face: &Face, unit: f64) {
        self.clipped += usize::from(polygon.len() > 3);
        let Some((first, rest)) = polygon.split_first().filter(|(_, rest)| rest.len() > 1) else {
            self.outside += 1;
            return;
        };
        let snapped = |vertex: Triple| vertex.map(|c| snapped(c * unit));
        for (second, third) in rest.iter().zip(rest.iter().skip(1)) {
            match Triangle::new([*first, *second, *third].map(snapped), &self.view.raster) {
                None => self.degenerate += 1,
                Some((_, false)) if face.one_sided => self.turned += 1,
                Some((triangle, _)) => self.view.triangles.push(triangle),
            }
        }
    }
}

/// Returns the nearest integer.
#[expect(clippy::cast_possible_truncation, reason = "it is below 2^16")]
fn snapped(c: f64) -> i64 {
    c.round().clamp(-(LARGEST as f64), LARGEST as f64) as i64
}

/// Returns the part of a polygon on the side `normal . place >= least`.
fn clipped(polygon: &[Triple], (normal, least): (Triple, f64)) -> Vec<Triple> {
    let height = |place: Triple| dot(normal, place) - least;
    let mut clipped = Vec::with_capacity(polygon.len() + 1);
    for (&from, &to) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let is_kept = height(from) >= 0.0;
        if is_kept {
            clipped.push(from);
        }
        if is_kept != (height(to) >= 0.0) {
            // From one end for both faces of the edge.
            let [a, b] = if from <= to { [from, to] } else { [to, from] };
            let part = height(a) / (height(a) - height(b));
            let [ax, ay, az] = a;
            let [bx, by, bz] = difference(b, a);
            clipped.push([ax + part * bx, ay + part * by, az + part * bz]);
        }
    }
    clipped
}

#[cfg(test)]
mod tests {
    use rta_scenes::description::Camera;

    use super::{Face, Seen};
    use crate::picture::raster::Size;
    use crate::study::visibility::zbuffer;

    fn seen(faces: &[[[f64; 3]; 3]], one_sided: bool) -> Seen {
        let faces: Vec<_> = faces.iter().map(|&vertices| Face { vertices, one_sided }).collect();
        let camera = Camera::upright([0.0; 3], [0.0, 1.0, 0.0], 0.5);
        Seen::new(&faces, &camera, (Size::new(16, 8).expect("a size"), 2.0), 0.0).expect("it is seen")
    }

    #[test]
    fn faces_are_clipped_scaled_and_snapped() {
        // A wall that is larger than the picture, in two triangles; 2 wide and 1 high at distance 1, it is seen to 3 and 1.5.
        let wall = |x: f64| [[-x, 3.0, -9.0], [x, 3.0, -9.0], [x, 3.0, 9.0]];
        let seen = seen(&[wall(20.0), wall(-20.0)], false);
        assert_eq!((seen.scale, seen.outside, seen.clipped, seen.degenerate), (14, 0, 2, 0));
        let vertices = seen.view.triangles.iter().flat_map(|triangle| triangle.vertices);
        assert!(
            vertices.into_iter().all(|[x, y, z]| x.abs() <= 3 << 14 && y.abs() <= 3 << 13 && z == 3 << 14)
        );
    }

    #[test]
    fn what_is_behind_or_turned_away_is_left_out() {
        let face = |y: f64| [[-1.0, y, -1.0], [1.0, y, -1.0], [0.0, y, 1.0]];
        let turned = |y: f64| {
            let [a, b, c] = face(y);
            [a, c, b]
        };
        assert_eq!(seen(&[face(-1.0)], false).outside, 1);
        assert_eq!(seen(&[face(2.0)], true).view.triangles.len(), 1);
        let away = seen(&[turned(2.0)], true);
        assert_eq!((away.turned, away.view.triangles.len()), (1, 0));
        assert_eq!(seen(&[turned(2.0)], false).view.triangles.len(), 1);
        let point = seen(&[[[0.0, 1.0, 0.0], [0.0, 1.0, 1e-9], [0.0, 1.0 + 1e-9, 0.0]], face(3.0)], false);
        assert_eq!((point.degenerate, point.view.triangles.len()), (1, 1));
    }

    #[test]
    fn neighbours_are_clipped_alike() {
        // A ground from behind the eye to far away, in strips: each pixel below the horizon is covered once.
        let quad = |x: f64| {
            let [a, b, c, d] =
                [[x, -7.3, -1.0], [x + 1.7, -7.3, -1.0], [x + 1.7, 93.1, -1.0], [x, 93.1, -1.0]];
            [[a, b, c], [a, c, d]]
        };
        let faces: Vec<_> = (-60..60).flat_map(|strip| quad(1.7 * f64::from(strip))).collect();
        let seen = seen(&faces, false);
        let outcome = zbuffer::whole(&seen.view).expect("few");
        let covered = outcome.ids.iter().filter(|id| **id != 0).count() as u64;
        assert_eq!((covered, outcome.counts.of("compares")), (16 * 4, Some(16 * 4)));
    }
}
