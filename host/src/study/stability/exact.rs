//! Numbers rounded to a format and read back as `f64`, so that the reference computes with the very numbers of the format.

use rta_scenes::description::{Description, Material, Surface};
use rta_scenes::narrow::Narrow;

/// The scene with each number rounded to what `S` makes of it. What is beyond the range of the format stays as it is, so
/// that it is refused for what it is; so do radiances and intensities.
#[must_use]
pub fn rounded<S: Narrow>(scene: &Description) -> Description {
    let mut scene = scene.clone();
    let length = |value: &mut f64| {
        if value.abs() < S::largest() {
            *value = S::length(*value).to_f64();
        }
    };
    let radius = |value: &mut f64| {
        if *value >= S::SMALLEST_RADIUS {
            length(value);
        }
    };
    let unit = |value: &mut f64| {
        if value.abs() <= S::LARGEST_COLOR {
            *value = S::unit_to_f64(S::unit(*value));
        }
    };
    let index = |index: &mut f64| {
        let mut eta = if *index > 1.0 { 1.0 / *index } else { *index };
        unit(&mut eta);
        *index = if *index > 1.0 { 1.0 / eta } else { eta };
    };
    let surface = |surface: &mut Surface| {
        if let Surface::Transparent { ks, kt, ior } = surface {
            unit(ks);
            unit(kt);
            index(ior);
        }
    };
    for material in &mut scene.materials {
        let Material { ambient, diffuse, back, specular, transmit, mirror, metal, .. } = material;
        let shares = [ambient, diffuse, back, specular, transmit, mirror];
        shares.into_iter().flatten().chain(metal.iter_mut().flatten()).for_each(unit);
        material.index.iter_mut().for_each(index);
    }
    scene.camera.eye.iter_mut().for_each(length);
    for cylinder in &mut scene.cylinders {
        cylinder.position.iter_mut().for_each(length);
        cylinder.color.iter_mut().for_each(unit);
        radius(&mut cylinder.radius);
        surface(&mut cylinder.surface);
    }
    for ellipsoid in &mut scene.ellipsoids {
        ellipsoid.position.iter_mut().for_each(length);
        ellipsoid.color.iter_mut().for_each(unit);
        ellipsoid.radii.iter_mut().for_each(radius);
        surface(&mut ellipsoid.surface);
    }
    for sphere in &mut scene.spheres {
        sphere.position.iter_mut().for_each(length);
        sphere.color.iter_mut().for_each(unit);
        radius(&mut sphere.radius);
        surface(&mut sphere.surface);
    }
    for cone in &mut scene.cones {
        cone.base.iter_mut().chain(&mut cone.apex).for_each(length);
        cone.color.iter_mut().for_each(unit);
        for end in [&mut cone.base_radius, &mut cone.apex_radius] {
            radius(end);
        }
        surface(&mut cone.surface);
    }
    for triangle in &mut scene.triangles {
        triangle.vertices.as_flattened_mut().iter_mut().for_each(length);
        triangle.color.iter_mut().for_each(unit);
        surface(&mut triangle.surface);
    }
    for lamp in &mut scene.lamps {
        lamp.position.iter_mut().for_each(length);
        radius(&mut lamp.radius);
    }
    if let Some(floor) = &mut scene.floor {
        floor.colors.as_flattened_mut().iter_mut().for_each(unit);
    }
    scene
}
