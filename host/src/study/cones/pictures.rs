//! Scenes in which cones meet what they are good at, and what they are not.

/// A scene of which there is a picture.
#[derive(Clone, Copy, Debug)]
pub struct Picture {
    /// Its name.
    pub title: &'static str,
    /// What is in it that is of interest.
    pub about: &'static str,
    /// Its text.
    pub text: &'static str,
}

/// Width and height of the pictures in pixels.
pub const SIZE: [u32; 2] = [96, 72];

/// The scenes.
pub const PICTURES: &[Picture] = &[
    Picture {
        title: "edges",
        about: "balls before each other, tiles up to the horizon, shadows of a lamp without a radius",
        text: EDGES,
    },
    Picture {
        title: "mirrors",
        about: "a mirror, balls that are mirrors, and what they mirror",
        text: MIRRORS,
    },
    Picture { title: "glass", about: "a ball, a pane and a box of glass", text: GLASS },
    Picture { title: "gloss", about: "a rough mirror and rough glass", text: GLOSS },
    Picture { title: "penumbra", about: "soft shadows of two things", text: PENUMBRA },
];

const EDGES: &str = "\
rta 1
camera at 0 -7 1.6  to 0 0 .9  lens 1.4
sky horizon .7 .75 .8  zenith .15 .3 .65
ambient grey .25
floor .8 .8 .8  .15 .15 .2  tile 1
lamp at -4 -6 8  power 40  square
sphere at -1.2 0 .8  radius .8  color .8 .2 .15
sphere at -.3 1.5 1  radius 1  color .2 .6 .25
sphere at 1.3 .5 .7  radius .7  color .2 .3 .8
box from .9 -2.2 0  to 1.5 -1.6 .6  color .8 .7 .3
";

const MIRRORS: &str = "\
rta 1
camera at 0 -7 2.4  to 0 0 .8  lens 1.4
sky horizon .7 .75 .8  zenith .15 .3 .65
ambient grey .25
floor .8 .8 .8  .15 .15 .2  tile 1
lamp at -4 -6 8  power 40  square
sphere at -1.3 0 1  radius 1  of mirror  color .9 .9 .9
sphere at 1.1 -.6 .7  radius .7  of mirror  color .9 .8 .5
sphere at .3 -2 .3  radius .3  color .8 .2 .15
polygon -3 3 0  3 3 0  3 3 3  -3 3 3  of mirror  color .8 .8 .85
";

const GLASS: &str = "\
rta 1
camera at 0 -7 2.4  to 0 0 .8  lens 1.4
sky horizon .7 .75 .8  zenith .15 .3 .65
ambient grey .25
floor .8 .8 .8  .15 .15 .2  tile 1
lamp at -4 -6 8  power 40  square
sphere at -1.2 0 1  radius 1  of crown
box from .5 -1 0  to 1.7 .2 1.2  of crown
sphere at .4 2.5 .8  radius .8  color .8 .2 .15
polygon -2 -2.4 0  -.9 -2.6 0  -.9 -2.6 .9  -2 -2.4 .9  of crown
";

const GLOSS: &str = "\
rta 1
camera at 0 -7 2.4  to 0 0 .7  lens 1.4
sky horizon .7 .75 .8  zenith .15 .3 .65
ambient grey .2
floor .8 .8 .8  .15 .15 .2  tile 1
lamp at -4 -6 8  power 40  square
material brushed like mirror  roughness .1
material frosted like crown  roughness .1
sphere at -1.1 0 1  radius 1  of brushed  color .9 .9 .9
sphere at 1.2 -.5 .9  radius .9  of frosted
sphere at .2 2.5 .6  radius .6  color .8 .2 .1
polygon -3 4 0  3 4 0  3 4 3  -3 4 3  of brushed  color .8 .8 .85
";

const PENUMBRA: &str = "\
rta 1
camera at 0 -7 3.2  to 0 0 .5  lens 1.3
sky .1 .13 .2
ambient grey .1
floor .8 .8 .8  .6 .6 .65
lamp at -2 -2 6  radius .7  power 30  square
sphere at .6 0 .8  radius .8  color .8 .35 .2
sphere at -.4 -1 2  radius .4  color .3 .7 .4
triangle -2.6 .4 0  -2.6 2 0  -1.2 1.2 2.4  color .3 .5 .8
";
