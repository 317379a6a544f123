//! A description as a scene file of the thesis.

use core::fmt::{self, Display, Write};

use crate::description::{Camera, Cylinder, Description, Ellipsoid, Floor, Lamp, Sphere, Surface};
use crate::numbers::Numbers;

impl Description {
    /// The scene as the thesis's scene file, or `None` if that format cannot say what is in it: without a floor, with
    /// cones, triangles, planes, coefficients or ellipsoids seen from the inside, or seen by a camera that is not held upright.
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
        if has_insides
            || !(self.cones.is_empty()
                && self.triangles.is_empty()
                && self.planes.is_empty()
                && self.camera == camera)
            || surfaces.any(|surface| matches!(surface, Surface::Finish { .. } | Surface::Of(_)))
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
            Type(surface)
        )?;
    }
    writeln!(text, "{} # ellipsoids", scene.ellipsoids.len())?;
    for Ellipsoid { position, color, radii, surface, .. } in &scene.ellipsoids {
        writeln!(text, "{}  {}  {}  {}", Numbers(position), Numbers(color), Numbers(radii), Type(surface))?;
    }
    writeln!(text, "{} # spheres", scene.spheres.len())?;
    for Sphere { position, color, radius, surface, .. } in &scene.spheres {
        writeln!(
            text,
            "{}  {}  {}  {}",
            Numbers(position),
            Numbers(color),
            Numbers(&[*radius]),
            Type(surface)
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
struct Type<'a>(&'a Surface);

impl Display for Type<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self.0 {
            Surface::Opaque => write!(f, "0"),
            Surface::Shiny => write!(f, "1"),
            Surface::Mirror => write!(f, "2"),
            Surface::Transparent { ks, kt, ior } => write!(f, "3  {}", Numbers(&[ks, kt, ior])),
            Surface::Finish { .. } | Surface::Of(_) => Err(fmt::Error),
        }
    }
}
