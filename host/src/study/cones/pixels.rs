//! Pixels of which it is known what is right.

/// A pixel.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// What is in it.
    pub name: &'static str,
    /// The statements of its scene behind those of [`EYE`], or from the first on.
    things: &'static str,
    /// Whether there is more than the things' own colours: the whole scene is in `things`.
    is_whole: bool,
}

/// An eye that sees a pixel of 1/20 on each side, and a white sky.
const EYE: &str = "\
model flat
camera at 0 0 0  look 0 1 0  lens 20
sky white
ambient white
";

impl Case {
    /// Returns the text of its scene.
    #[must_use]
    pub fn text(&self) -> String {
        let before = if self.is_whole { "" } else { EYE };
        format!("rta 1\n{before}{}", self.things)
    }
}

const fn seen(name: &'static str, things: &'static str) -> Case {
    Case { name, things, is_whole: false }
}

const fn whole(name: &'static str, things: &'static str) -> Case {
    Case { name, things, is_whole: true }
}

/// The pixels. Balls are so large that their edges are nearly straight.
pub const CASES: &[Case] = &[
    seen("a ball hides half of it", "sphere at -100 200 0  radius 100  color black\n"),
    seen(
        "one ball behind another hides the same half",
        "sphere at -100 200 0  radius 100  color black\nsphere at -150 300 0  radius 150  color black\n",
    ),
    seen(
        "two faces that meet, of two things",
        "polygon -9 50 -9  0 50 -9  0 50 9  -9 50 9  color black\npolygon 0 50 -9  9 50 -9  9 50 9  0 50 9  color black\n",
    ),
    seen("two faces that meet, of one thing", "polygon -9 50 -9  9 50 -9  9 50 9  -9 50 9  color black\n"),
    seen("a closed box: its front and its back", "box from -9 50 -9  to 0 60 9  color black\n"),
    seen(
        "a grey wall behind a black ball",
        "sphere at -100 200 0  radius 100  color black\npolygon -40 400 -40  40 400 -40  40 400 40  -40 400 40  color grey .5\n",
    ),
    seen(
        "two balls through each other",
        "sphere at -2.05 50 0  radius 2  color black\nsphere at -2.05 50.5 0  radius 2  color grey .5\n",
    ),
    seen(
        "nine small balls in a row",
        "sphere at -.8 50 0  radius .1  color black\nsphere at -.6 51 0  radius .1  color black\nsphere at -.4 52 0  radius .1  color black\nsphere at -.2 53 0  radius .1  color black\nsphere at 0 54 0  radius .1  color black\nsphere at .2 55 0  radius .1  color black\nsphere at .4 56 0  radius .1  color black\nsphere at .6 57 0  radius .1  color black\nsphere at .8 58 0  radius .1  color black\n",
    ),
    whole(
        "the floor, of which tiles are small",
        "model flat\ncamera at 0 0 1  look 0 1 -.2  lens 20\nsky white\nambient white\nfloor black white  tile .1\n",
    ),
    whole(
        "a texture of small cubes",
        "model flat\ncamera at 0 0 0  look 0 1 0  lens 20\nsky white\nambient white\ntexture cubes checker black white  scale .3\nmaterial tiled like matte  texture cubes\npolygon -9 50 -9  9 50 -9  9 50 9  -9 50 9  of tiled\n",
    ),
    whole(
        "the edge of a shadow of a lamp without a radius",
        "model lambert\ncamera at 0 0 5  look 0 0 -1  lens 20\nsky black\nambient black\nfloor white white\nlamp at 0 0 100  power 5000  square\npolygon -90 -90 90  0 -90 90  0 90 90  -90 90 90  color white\n",
    ),
    whole(
        "the middle of a penumbra",
        "model lambert\ncamera at 0 0 3.5  look 0 0 -1  lens 20\nsky black\nambient black\nfloor white white\nlamp at 0 0 10  radius .5  power 50  square\npolygon -90 -90 4  0 -90 4  0 90 4  -90 90 4  color white\n",
    ),
    whole(
        "the penumbra of two balls behind each other",
        "model lambert\ncamera at 0 0 .5  look 0 0 -1  lens 20\nsky black\nambient black\nfloor white white\nlamp at 0 0 10  radius .5  power 50  square\nsphere at -2 0 4  radius 2  color white\nsphere at -3 0 6  radius 3  color white\n",
    ),
    whole(
        "the rim of a ball that mirrors a wall",
        "model whitted\ncamera at 0 0 0  look 0 1 0  lens 20\nsky white\nambient white\nsphere at -100 200 0  radius 100  of mirror  color white\npolygon 40 0 -900  40 900 -900  40 900 900  40 0 900  color black\n",
    ),
    whole(
        "a glass ball as large as half of it",
        "model whitted\ncamera at 0 0 0  look 0 1 0  lens 20\nsky white\nambient white\nsphere at .3 20 0  radius .35  of crown\npolygon -9 50 -9  .2 50 -9  .2 50 9  -9 50 9  color black\n",
    ),
];
