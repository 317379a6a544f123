//! The one scene that all techniques draw, and what is changed of it for those that need it.

use rta_scenes::{Reading, shipped};

use crate::request::error::RequestError;
use crate::request::scene_file::SceneFile;

/// Lines of the scene.
const METAL: &str = "material metal  diffuse .2  specular .7  exponent 200\n";
const CLEAR: &str =
    "material clear  index 1.5  diffuse 0  specular .1  transmit .85  exponent 100  absorb .45 .85 .6\n";
const GLAZE: &str = "material glaze  diffuse .8  specular .15  exponent 40\n";

const LAMP: &str =
    "quad 1.4 2.6 2.98  2.6 2.6 2.98  2.6 1.4 2.98  1.4 1.4 2.98  patches 2 2  color .8 .8 .8  of shade\n";

/// The scene with other lines in the place of some of its own.
#[derive(Clone, Copy, Debug)]
pub struct Variant {
    /// Stem of its file's name.
    pub name: &'static str,
    /// Each line, and what takes its place.
    pub lines: &'static [[&'static str; 2]],
}

/// As it is shipped.
pub const PLAIN: Variant = Variant { name: "techniques", lines: &[] };

/// Without mirrors and glass: all surfaces are diffuse, as first radiosity has them.
pub const MATTE: Variant = Variant {
    name: "techniques-matte",
    lines: &[
        [METAL, "material metal  diffuse 1\n"],
        [CLEAR, "material clear  diffuse 1\n"],
        [GLAZE, "material glaze  diffuse 1\n"],
    ],
};

/// The metal ball sees a sky of two colours in the place of the room.
pub const MAPPED: Variant = Variant {
    name: "techniques-mapped",
    lines: &[[
        METAL,
        "sky horizon .75 .7 .65  zenith .2 .3 .55\n\
         material metal  diffuse .2  specular .7  exponent 200  mirror .7  surroundings\n",
    ]],
};

/// The glazed ball has dents.
pub const DENTED: Variant = Variant {
    name: "techniques-dented",
    lines: &[[
        GLAZE,
        "texture dents marble black white  2 1  scale .3\n\
         material glaze  diffuse .8  specular .15  exponent 40  bump dents .02\n",
    ]],
};

/// The metal ball is rough.
pub const ROUGH: Variant = Variant {
    name: "techniques-rough",
    lines: &[[METAL, "material metal  diffuse .2  specular .7  exponent 200  roughness .2\n"]],
};

/// The lamp is a ball, as bright straight below as the flat one.
pub const ROUND: Variant = Variant {
    name: "techniques-round",
    lines: &[[LAMP, "lamp at 2 2 2.6  radius .35  power 6.9  color 1 .93 .84\n"]],
};

/// All of them.
pub const ALL: [Variant; 6] = [PLAIN, MATTE, MAPPED, DENTED, ROUGH, ROUND];

impl Variant {
    /// Returns the scene as a text in the language `.rta`.
    #[must_use]
    pub fn text(&self) -> String {
        self.lines.iter().fold(shipped::TECHNIQUES.to_owned(), |text, [from, to]| text.replace(from, to))
    }

    /// Returns the scene, read in a way.
    ///
    /// # Errors
    /// Those of [`SceneFile::of_text`].
    pub fn scene(&self, reading: Reading) -> Result<SceneFile, RequestError> {
        SceneFile::of_text(self.name, &self.text(), reading)
    }
}
