//! A description as a scene file of the thesis.

use core::fmt::{self, Display, Write};

use super::SHARES_TOLERANCE;
use crate::description::{
    Air, Camera, Cylinder, Description, Details, Ellipsoid, FallOff, Floor, Lamp, Material, Model, Optics,
    Settings, Sphere, Surface,
};
use crate::numbers::Numbers;

impl Description {
    /// The scene as the thesis's scene file, or `None` if that format cannot say what is in it: without a floor, with
    /// cones, triangles, planes, other materials than the types 0 to 3, ellipsoids seen from the inside, lamps with a fall-off of
    /// their own, or settings, made for another model than the thesis's, or seen by a camera that is not held upright.
    ///
    /// [`read`](super::read) gives the same scene back, digit for digit, with the lines of the new file.
    #[must_use]
    pub fn to_dat(&self) -> Option<String> {
        let floor = self.floor.as_ref()?;
        let has_insides = self.ellipsoids.iter().any(|ellipsoid| ellipsoid.inside_only);
        let cylinders = self.cylinders.iter().map(|c| &c.surface);
        let ellipsoids = self.ellipsoids.iter().map(|e| &e.surface);
        let mut surfaces = cylinders.chain(ellipsoids).chain(self.spheres.iter().map(|s| &s.surface));
        let camera = Camera::upright(self.camera.eye, self.camera.view, self.camera.focal);
        let says_more = self.model != Model::Rta
            || self.air != Air::default()
            || self.details != Details::default()
            || self.settings != Settings::default()
            || self.optics != Optics::default()
            || self.raster.is_some()
            || floor.surface != Surface::Opaque
            || self.lamps.iter().any(|lamp| lamp.fall_off != FallOff::OfModel);
        if has_insides
            || says_more
            || !(self.cones.is_empty()
                && self.triangles.is_empty()
                && self.planes.is_empty()
                && self.camera == camera)
            || surfaces.any(|surface| plain(surface, &self.materials).is_none())
        {
            return None;
        }
        let mut text = String::new();
        write_scene(&mut text, self, floor).ok()?;
        Some(text)
    }
}

fn write_scene(text: &mut String, scene: &Description, floor: &Floor) -> fmt::Result {
    writeln!(text, "{}\n{}", Numbers(&scene.camera.eye), Numbers(&scene.camera.view))?;
    writeln!(text, "{}", Numbers(&[scene.camera.focal]))?;
    writeln!(text, "{} # cylinders", scene.cylinders.len())?;
    for Cylinder { position, color, radius, surface, .. } in &scene.cylinders {
        writeln!(
            text,
            "{}  {}  {}  {}",
            Numbers(position),
            Numbers(color),
            Numbers(&[*radius]),
            Type(surface, &scene.materials)
        )?;
    }
    writeln!(text, "{} # ellipsoids", scene.ellipsoids.len())?;
    for Ellipsoid { position, color, radii, surface, .. } in &scene.ellipsoids {
        writeln!(
            text,
            "{}  {}  {}  {}",
            Numbers(position),
            Numbers(color),
            Numbers(radii),
            Type(surface, &scene.materials)
        )?;
    }
    writeln!(text, "{} # spheres", scene.spheres.len())?;
    for Sphere { position, color, radius, surface, .. } in &scene.spheres {
        writeln!(
            text,
            "{}  {}  {}  {}",
            Numbers(position),
            Numbers(color),
            Numbers(&[*radius]),
            Type(surface, &scene.materials)
        )?;
    }
    writeln!(text, "{} # lamps", scene.lamps.len())?;
    for Lamp { position, color, radius, .. } in &scene.lamps {
        writeln!(text, "{}  {}  {}", Numbers(position), Numbers(color), Numbers(&[*radius]))?;
    }
    let [first, second] = &floor.colors;
    for color in [first, second, &scene.ambient, &scene.sky.horizon, &scene.sky.zenith] {
        writeln!(text, "{}", Numbers(color))?;
    }
    Ok(())
}

/// The type of a surface, with what follows it.
struct Type<'a>(&'a Surface, &'a [Material]);

impl Display for Type<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match plain(self.0, self.1).ok_or(fmt::Error)? {
            Surface::Opaque => write!(f, "0"),
            Surface::Shiny => write!(f, "1"),
            Surface::Mirror => write!(f, "2"),
            Surface::Transparent { ks, kt, ior } => write!(f, "3  {}", Numbers(&[ks, kt, ior])),
            Surface::Finish { .. } | Surface::Of(_) => Err(fmt::Error),
        }
    }
}

/// Returns a surface as one of the types 0 to 3, if it is one: a material may say what type 3 says.
fn plain(surface: &Surface, materials: &[Material]) -> Option<Surface> {
    let number = match *surface {
        Surface::Finish { .. } => return None,
        Surface::Of(number) => number,
        other => return Some(other),
    };
    let material = materials.get(usize::from(number))?;
    let (Some(ks), Some(kt)) = (material.specular, material.transmit) else { return None };
    let glass = Surface::Transparent { ks, kt, ior: material.index.unwrap_or(1.0) };
    let index = material.index.or(Some(1.0));
    let said = Material { name: String::new(), line: 0, index, ..material.clone() };
    let is_glass = said == Material::of(&glass, materials) && (ks + kt - 1.0).abs() <= SHARES_TOLERANCE;
    is_glass.then_some(glass)
}
