//! The ids that rta's own tracer sees in `f64`: its triangles, hit by its rays.

use rta_core::ray::Ray;
use rta_core::scalar::vector::UnitVector;
use rta_core::shape::{Primitive, Triangle};
use rta_core::vector::{UnitVec3, Vec3};
use rta_scenes::description::{self, Surface};
use rta_scenes::narrow::triangle;

use super::integer::{View, pixels};

/// Returns the id of each pixel: the nearest hit in `f64`, and of equal ones the first. A triangle is asked by the rays within a pixel of those that
/// can meet it, as the tracer's hierarchies leave alone what a ray cannot meet.
#[must_use]
pub fn traced(view: &View) -> Vec<u32> {
    let size = view.raster.size;
    let (mut ids, mut distances) = (view.blank(), vec![f64::INFINITY; size.pixels()]);
    for (id, own) in view.each() {
        let Some(triangle) = core_triangle(own.vertices.map(|vertex| vertex.map(|c| c as f64))) else {
            continue;
        };
        let wider = |range: &core::ops::Range<u32>, side: u32| {
            range.start.saturating_sub(1)..(range.end + 1).min(side)
        };
        let (columns, rows) = (wider(&own.columns, size.width()), wider(&own.rows, size.height()));
        for y in rows {
            let start = y as usize * size.columns();
            let row = distances
                .get_mut(start + columns.start as usize..start + columns.end as usize)
                .unwrap_or_default();
            let held = pixels(&mut ids, size.width(), y, columns.clone());
            for (x, (held, nearest)) in columns.clone().zip(held.iter_mut().zip(row)) {
                let [dx, dy, dz] = view.raster.ray(x, y).map(|c| c as f64);
                let direction = UnitVector::normalize(UnitVec3::<f64>::new(dx, dy, dz));
                let ray =
                    direction.map(|(direction, _)| Ray::new(Vec3::<f64>::new(0.0, 0.0, 0.0), direction));
                if let Some(t) = ray.and_then(|ray| triangle.intersect(&ray, *nearest)) {
                    (*held, *nearest) = (id, t);
                }
            }
        }
    }
    ids
}

/// Returns the tracer's triangle.
fn core_triangle(vertices: [[f64; 3]; 3]) -> Option<Triangle<f64>> {
    let own = description::Triangle {
        vertices,
        normals: None,
        one_sided: false,
        color: [0.0; 3],
        surface: Surface::Opaque,
        line: 0,
    };
    triangle::narrow(0, &own).ok()
}
