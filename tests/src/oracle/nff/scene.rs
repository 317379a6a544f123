//! A scene in NFF and its reader.

use core::str::FromStr;
use std::collections::VecDeque;

use super::super::Color;
use super::super::vector::Vector;
use super::shape::{Ball, Outline, Shape, Triangle};
use super::tube::Tube;

/// A scene in NFF.
pub struct Scene {
    pub(super) view: View,
    pub(super) background: Color,
    pub(super) lamps: Vec<Lamp>,
    pub(super) objects: Vec<Object>,
}

impl Scene {
    /// Returns the number of pixels in a row.
    #[must_use]
    pub fn width(&self) -> usize {
        self.view.resolution[0]
    }
}

/// The entity `v`.
#[derive(Default)]
pub(super) struct View {
    pub(super) from: Vector,
    pub(super) at: Vector,
    pub(super) up: Vector,
    /// In degrees, between the centres of the first and the last row of pixels.
    pub(super) angle: f64,
    /// Pixels in a row, and rows.
    pub(super) resolution: [usize; 2],
}

pub(super) struct Lamp {
    pub(super) position: Vector,
    pub(super) color: Color,
}

/// The entity `f`: what the surfaces that follow are made of.
#[derive(Clone, Copy, Default)]
pub(super) struct Fill {
    pub(super) color: Color,
    pub(super) kd: f64,
    pub(super) ks: f64,
    pub(super) shine: f64,
    /// Weight of the transmitted ray.
    pub(super) kt: f64,
    /// Index of refraction of the inside.
    pub(super) ior: f64,
}

pub(super) struct Object {
    pub(super) shape: Shape,
    pub(super) fill: Fill,
}

/// Reads a scene. What has no extent (a polygon without area, a cone without height) is left out.
///
/// # Errors
/// A text that is no NFF, with the token at which that is seen.
pub fn read(text: &str) -> Result<Scene, String> {
    let words = text.lines().flat_map(|line| line.split('#').next().unwrap_or_default().split_whitespace());
    let mut words = Words(words.collect());
    let mut scene =
        Scene { view: View::default(), background: [0.0; 3], lamps: Vec::new(), objects: Vec::new() };
    let mut uncoloured = Vec::new();
    let mut fill = Fill::default();
    while let Some(entity) = words.0.pop_front() {
        let shapes = match entity {
            "v" => {
                scene.view = words.view()?;
                continue;
            }
            "b" => {
                scene.background = words.vector()?;
                continue;
            }
            "f" => {
                let (color, [kd, ks, shine, kt, ior]) = (words.vector()?, words.numbers()?);
                // No index at all is that of the outside.
                let ior = if ior == 0.0 { 1.0 } else { ior };
                fill = Fill { color, kd, ks, shine, kt, ior };
                continue;
            }
            "l" => {
                let position = words.vector()?;
                let has_color = words.0.front().is_some_and(|word| f64::from_str(word).is_ok());
                let color = if has_color { words.vector()? } else { [f64::NAN; 3] };
                uncoloured.push(!has_color);
                scene.lamps.push(Lamp { position, color });
                continue;
            }
            "s" => {
                let (center, radius) = (words.vector()?, words.number()?);
                vec![Some(Shape::Ball(Ball { center, radius: radius.abs(), inside_only: radius < 0.0 }))]
            }
            "c" => {
                let (base, base_radius) = (words.vector()?, words.number()?);
                let (apex, apex_radius) = (words.vector()?, words.number()?);
                vec![Tube::new([base, apex], [base_radius, apex_radius]).map(Shape::Tube)]
            }
            "p" => vec![Outline::new(words.corners(Words::vector)?).map(Shape::Outline)],
            "pp" => fan(&words.corners(|words| Ok((words.vector()?, words.vector()?)))?),
            other => return Err(format!("found {other:?}, expected an entity")),
        };
        scene.objects.extend(shapes.into_iter().flatten().map(|shape| Object { shape, fill }));
    }
    // The reference leaves it to the renderer and names this.
    let power = 1.0 / (scene.lamps.len() as f64).sqrt();
    for (lamp, _) in scene.lamps.iter_mut().zip(uncoloured).filter(|(_, uncoloured)| *uncoloured) {
        lamp.color = [power; 3];
    }
    Ok(scene)
}

/// Returns the triangles between the first corner of a convex polygon and each edge that does not touch it.
fn fan(corners: &[(Vector, Vector)]) -> Vec<Option<Shape>> {
    let Some((&first, rest)) = corners.split_first() else { return Vec::new() };
    let edges = rest.iter().zip(rest.iter().skip(1));
    let triangle = |(&second, &third): (&(Vector, Vector), &(Vector, Vector))| {
        let corners = [first, second, third];
        Triangle::new(corners.map(|(place, _)| place), corners.map(|(_, normal)| normal)).map(Shape::Triangle)
    };
    edges.map(triangle).collect()
}

/// The words of a file that are still to be read.
struct Words<'a>(VecDeque<&'a str>);

impl Words<'_> {
    fn parse<T: FromStr>(&mut self) -> Result<T, String> {
        let word = self.0.pop_front().unwrap_or("the end of the file");
        word.parse().map_err(|_| format!("found {word:?}, expected a number"))
    }

    fn number(&mut self) -> Result<f64, String> {
        self.parse()
    }

    fn numbers<const N: usize>(&mut self) -> Result<[f64; N], String> {
        let mut numbers = [0.0; N];
        for number in &mut numbers {
            *number = self.number()?;
        }
        Ok(numbers)
    }

    fn vector(&mut self) -> Result<Vector, String> {
        self.numbers()
    }

    fn corners<T>(&mut self, corner: impl Fn(&mut Self) -> Result<T, String>) -> Result<Vec<T>, String> {
        let count: usize = self.parse()?;
        (0..count).map(|_| corner(self)).collect()
    }

    fn view(&mut self) -> Result<View, String> {
        let mut view = View::default();
        for _ in 0..6 {
            match self.0.pop_front().unwrap_or_default() {
                "from" => view.from = self.vector()?,
                "at" => view.at = self.vector()?,
                "up" => view.up = self.vector()?,
                "angle" => view.angle = self.number()?,
                // Nothing is cut off in front of it.
                "hither" => _ = self.number()?,
                "resolution" => view.resolution = [self.parse()?, self.parse()?],
                other => return Err(format!("found {other:?}, expected a line of the view")),
            }
        }
        Ok(view)
    }
}
