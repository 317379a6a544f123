//! A technique of image synthesis, and how it is drawn.

use super::room::Variant;

/// A technique of image synthesis.
#[derive(Clone, Copy, Debug)]
pub struct Technique {
    /// Stem of its picture's name, and its place on the page.
    pub name: &'static str,
    /// The year of its paper.
    pub year: u16,
    /// What it is called.
    pub title: &'static str,
    /// Its paper, without the year.
    pub paper: &'static str,
    /// What it does, and what is to be seen of it, in whole sentences.
    pub words: &'static str,
    /// What the thesis's table prints in the place of what is right here, where the project knows it.
    pub printed: Option<&'static str>,
    /// How it is drawn.
    pub way: Way,
}

/// How a technique is drawn.
#[derive(Clone, Copy, Debug)]
pub enum Way {
    /// By the tracer.
    Traced {
        /// The scene.
        scene: Variant,
        /// Options of `rta radiosity` for light that is solved before, if it is.
        solved: Option<&'static str>,
        /// Options of `rta render`.
        options: &'static str,
        /// What the picture is compared with.
        against: Against,
    },
    /// By an algorithm of `rta visibility`, by its name, on the scene's triangles.
    Visible {
        /// The algorithm.
        algorithm: &'static str,
        /// How bright what is seen is.
        shade: Shade,
    },
    /// Not at all: the program does not have it. What it would be, and what there is instead, in whole sentences.
    Absent(&'static str),
}

/// What a picture is compared with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Against {
    /// Paths of light in the scene as it is shipped.
    Paths,
    /// Paths of light in the technique's own scene. Both are seen through a [`LENS`].
    OwnPaths,
    /// Nothing: another scene is drawn.
    Nothing,
}

/// How bright the visible triangles of an algorithm are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shade {
    /// By the angle at which the eye sees a face, and by its distance (Warnock 1969): |N.V| min(1, d0/d), d0 being that in the middle of the
    /// picture.
    Angle,
    /// By depth alone: the inverse of the distance along the axis of view, the nearest being 1. It is what a depth buffer holds.
    Depth,
}

/// The lens of the picture of distributed rays, as options.
pub const LENS: &str = "--aperture .12 --focus 4.5";

impl Technique {
    /// Returns who published it.
    #[must_use]
    pub fn authors(&self) -> &'static str {
        self.paper.split_once(", \"").map_or(self.paper, |(authors, _)| authors)
    }

    /// Returns whether there is a picture.
    #[must_use]
    pub const fn is_drawn(&self) -> bool {
        !matches!(self.way, Way::Absent(_))
    }
}
