//! The techniques of table 3.1, in the order of their years. A new one is its entry here.
//!
//! Of the thesis's own table the project knows no more than three of its rows, by what is misprinted in them
//! ([`Technique::printed`]). The others are the techniques that its chapters 1 to 3 review.

use super::room::{DENTED, MAPPED, MATTE, PLAIN, ROUGH, ROUND, Variant};
use super::technique::{Against, Shade, Technique, Way};

/// A picture of the scene as it is shipped, against paths.
const fn traced(options: &'static str) -> Way {
    Way::Traced { scene: PLAIN, solved: None, options, against: Against::Paths }
}

/// A picture of a variant of the scene.
const fn varied(scene: Variant, options: &'static str, against: Against) -> Way {
    Way::Traced { scene, solved: None, options, against }
}

/// A picture of the scene without mirrors and glass, in solved light alone.
const fn radiosity(solved: &'static str) -> Way {
    let options = "--tessellate 4 --model lambert --light-as all --lamps fixed:1 --samples 16";
    Way::Traced { scene: MATTE, solved: Some(solved), options, against: Against::Paths }
}

/// All techniques.
pub const ALL: &[Technique] = &[
    Technique {
        name: "warnock",
        year: 1969,
        title: "Area subdivision",
        paper: "J. Warnock, \"A Hidden Surface Algorithm for Computer Generated Halftone Pictures\", Utah TR 4-15",
        words: "A window of the picture is cut in four until what is seen in it is simple. There are no lamps: a face is the brighter the \
                straighter the eye looks at it, and far faces sink into black.",
        printed: None,
        way: Way::Visible { algorithm: "area subdivision", shade: Shade::Angle },
    },
    Technique {
        name: "bouknight",
        year: 1970,
        title: "Half tones line by line",
        paper: "W. Bouknight, \"A Procedure for Generation of Three-Dimensional Half-Toned Computer Graphics Presentations\", CACM 13",
        words: "Diffuse surfaces under a lamp, with an exponent a little above 1 that keeps Mach's bands away. His scan-line algorithm finds \
                the same surfaces as rays do (rta visibility shows it), so rays find them here; they also cast the shadows.",
        printed: None,
        way: traced("--model bouknight --depth 0 --lamps fixed:1 --samples 16"),
    },
    Technique {
        name: "romney",
        year: 1970,
        title: "The lamp in the eye",
        paper: "G. Romney, \"Computer Assisted Assembly and Rendering of Solids\", Utah TR 4-20",
        words: "Where the only lamp is in the eye no shadow is seen, so none need be found. Light falls off with the fourth power of the \
                distance.",
        printed: None,
        way: traced("--model romney --depth 0 --lamps fixed:1 --samples 16"),
    },
    Technique {
        name: "gouraud",
        year: 1971,
        title: "Light mixed over a face",
        paper: "H. Gouraud, \"Continuous Shading of Curved Surfaces\", IEEE Transactions on Computers 20",
        words: "The balls are meshes of 12 x 6 faces. Light is found at the corners and mixed between them: the mesh looks round inside, its \
                outline does not, and highlights that fall between corners are lost.",
        printed: None,
        way: traced("--tessellate 6 --shading gouraud --model phong --depth 0 --lamps fixed:1 --samples 16"),
    },
    Technique {
        name: "newell",
        year: 1972,
        title: "Glass that does not bend light",
        paper: "M. Newell, R. Newell and T. Sancha, \"A Solution to the Hidden Surface Problem\", ACM National Conference",
        words: "What is behind a transparent face is painted first and shines through, straight on. Their sort of the faces from far to near is \
                not in the program (rta visibility paints by a tree of planes, of 1980); rays take its place here.",
        printed: None,
        way: traced("--model newell --lamps fixed:1 --samples 16"),
    },
    Technique {
        name: "catmull",
        year: 1974,
        title: "The depth buffer",
        paper: "E. Catmull, \"A Subdivision Algorithm for Computer Display of Curved Surfaces\", Utah",
        words: "Each pixel keeps the depth of the nearest face so far. The picture is that buffer: near is bright. It sees the same face at \
                each pixel as Warnock's windows do, from which it is told apart by its cost alone.",
        printed: None,
        way: Way::Visible { algorithm: "z-buffer", shade: Shade::Depth },
    },
    Technique {
        name: "phong",
        year: 1975,
        title: "Normals mixed over a face",
        paper: "Bui Tuong Phong, \"Illumination for Computer Generated Pictures\", CACM 18",
        words: "The same mesh as Gouraud's. Normals are mixed and light is found at each pixel: highlights are where they belong. They are \
                powers of the cosine between the reflected ray and the lamp.",
        printed: None,
        way: traced("--tessellate 6 --model phong --depth 0 --lamps fixed:1 --samples 16"),
    },
    Technique {
        name: "blinn-newell",
        year: 1976,
        title: "Mapped surroundings",
        paper: "J. Blinn and M. Newell, \"Texture and Reflection in Computer Generated Images\", CACM 19",
        words: "The metal ball reflects without a ray that is traced: its reflected ray looks up a picture of the surroundings by its direction \
                alone, here a sky of two colours. Neither the room nor the other balls are seen in it.",
        printed: None,
        way: varied(MAPPED, "--model blinn --depth 1 --lamps fixed:1 --samples 16", Against::Paths),
    },
    Technique {
        name: "blinn",
        year: 1977,
        title: "Facets",
        paper: "J. Blinn, \"Models of Light Reflection for Computer Synthesized Pictures\", SIGGRAPH 77",
        words: "Highlights of many small mirrors, which hide and shadow each other: seen at a grazing angle they are brighter and lie \
                elsewhere.",
        printed: None,
        way: traced("--model blinn-full --depth 0 --lamps fixed:1 --samples 16"),
    },
    Technique {
        name: "wrinkles",
        year: 1978,
        title: "Wrinkled surfaces",
        paper: "J. Blinn, \"Simulation of Wrinkled Surfaces\", SIGGRAPH 78",
        words: "The normal of the glazed ball is tilted as if it had dents; its outline stays round. No error is told, since the ball of the \
                reference has none.",
        printed: None,
        way: varied(DENTED, "--model blinn --depth 0 --lamps fixed:1 --samples 16", Against::Nothing),
    },
    Technique {
        name: "duff",
        year: 1979,
        title: "Phong's shading step by step",
        paper: "T. Duff, \"Smoothly Shaded Renderings of Polyhedral Objects on Raster Displays\", SIGGRAPH 79",
        words: "It finds Phong's light along a scan line by additions, with a square root and a division for each pixel.",
        printed: Some("\"Buff 1976\""),
        way: Way::Absent(
            "The program does not have it: its pixels are independent of each other. Its picture would be Phong's.",
        ),
    },
    Technique {
        name: "kay-greenberg",
        year: 1979,
        title: "Glass with a thickness",
        paper: "D. Kay and D. Greenberg, \"Transparency for Computer Synthesized Images\", SIGGRAPH 79",
        words: "Glass takes away a part of the light for each length of the way through it, so that a ball is darkest in its middle. Here \
                with traced rays for what is refracted and reflected, which were published a year later.",
        printed: Some("1977"),
        way: traced("--model kay-greenberg --lamps fixed:1 --samples 16"),
    },
    Technique {
        name: "whitted",
        year: 1980,
        title: "The tree of rays",
        paper: "T. Whitted, \"An Improved Illumination Model for Shaded Display\", CACM 23",
        words: "Reflected, refracted and shadow rays from each point, five deep: mirrors see the room, glass bends what is behind it, and \
                shadows have sharp edges. Its glass takes no light away. Walls send nothing to each other: the ambient term stands for that.",
        printed: None,
        way: traced("--model whitted --lamps fixed:1 --samples 16"),
    },
    Technique {
        name: "cook-torrance",
        year: 1982,
        title: "Metals by their indices",
        paper: "R. Cook and K. Torrance, \"A Reflectance Model for Computer Graphics\", ACM TOG 1",
        words: "Facets by Beckmann's slopes and Fresnel's equations. It is a model of light that comes from lamps: no ray is \
                reflected or refracted where the scene does not ask for one, so glass is opaque.",
        printed: Some("1984"),
        way: traced("--model cook-torrance --lamps fixed:1 --samples 16"),
    },
    Technique {
        name: "hall-greenberg",
        year: 1983,
        title: "A testbed of realism",
        paper: "R. Hall and D. Greenberg, \"A Testbed for Realistic Image Synthesis\", IEEE CG&A 3",
        words: "Whitted's rays, each weighed by Fresnel's equations and by what the material absorbs; lamps are seen through glass as \
                highlights.",
        printed: None,
        way: traced("--model hall-greenberg --lamps fixed:1 --samples 16"),
    },
    Technique {
        name: "verbeck-greenberg",
        year: 1984,
        title: "A lamp of many points",
        paper: "C. Verbeck and D. Greenberg, \"A Comprehensive Light-Source Description for Computer Graphics\", IEEE CG&A 4",
        words: "The lamp is asked at 16 fixed places, the same for each pixel: the edge of a shadow falls off in steps.",
        printed: None,
        way: traced("--lamps fixed:16 --samples 16"),
    },
    Technique {
        name: "amanatides",
        year: 1984,
        title: "Cones to lamps",
        paper: "J. Amanatides, \"Ray Tracing with Cones\", SIGGRAPH 84",
        words: "One cone from each point to a lamp, of which things hide a part: soft edges without noise. The lamp is taken for a ball, \
                which sends to its sides what the flat lamp does not, so the walls are too bright.",
        printed: None,
        way: traced("--lamps cone --samples 16"),
    },
    Technique {
        name: "cones",
        year: 1984,
        title: "Cones from the eye",
        paper: "J. Amanatides, \"Ray Tracing with Cones\", SIGGRAPH 84",
        words: "One cone over each pixel, and reflected and refracted ones: no stairs, and no samples. Cones know no flat lamp, so that the room \
                has a ball for one here, and no error is told. What they get wrong is a figure of the first page.",
        printed: None,
        way: varied(ROUND, "--integrator cones", Against::Nothing),
    },
    Technique {
        name: "cook-porter-carpenter",
        year: 1984,
        title: "Distributed rays",
        paper: "R. Cook, T. Porter and L. Carpenter, \"Distributed Ray Tracing\", SIGGRAPH 84",
        words: "Each of 64 rays a pixel has its own place on the lens and on the lamp, and its own way off a rough mirror: depth of field, soft \
                shadows and blurred reflections. Compared with paths through the same lens off the same rough metal. Motion is left out: \
                paths do not have it here.",
        printed: None,
        way: varied(ROUGH, "--lamps area --samples 64", Against::OwnPaths),
    },
    Technique {
        name: "goral",
        year: 1984,
        title: "Radiosity",
        paper: "C. Goral, K. Torrance, D. Greenberg and B. Battaile, \"Modeling the Interaction of Light Between Diffuse Surfaces\", SIGGRAPH 84",
        words: "Every surface is diffuse, and all light that goes between them is solved for at once by Gauss's elimination: the red wall \
                colours what is beside it. Theirs was an empty room; what hides what is found by 1024 rays a patch here.",
        printed: None,
        way: radiosity("--tessellate 4 --method gauss --factors rays:1024"),
    },
    Technique {
        name: "cohen-greenberg",
        year: 1985,
        title: "The hemi-cube",
        paper: "M. Cohen and D. Greenberg, \"The Hemi-Cube: A Radiosity Solution for Complex Environments\", SIGGRAPH 85",
        words: "What a patch sees is drawn on half a cube around its middle, with 20 x 20 cells on top, and the system is solved in sweeps \
                (Gauss and Seidel). The cells are rays here.",
        printed: None,
        way: radiosity("--tessellate 4 --method seidel --factors hemicube:20"),
    },
    Technique {
        name: "bishop-weimer",
        year: 1986,
        title: "Fast Phong shading",
        paper: "G. Bishop and D. Weimer, \"Fast Phong Shading\", SIGGRAPH 86",
        words: "Phong's cosines, expanded to the second order over a face of the same mesh: two additions a pixel in their day.",
        printed: None,
        way: traced(
            "--tessellate 6 --shading bishop-weimer --model phong --depth 0 --lamps fixed:1 --samples 16",
        ),
    },
    Technique {
        name: "immel",
        year: 1986,
        title: "Radiosity in all directions",
        paper: "D. Immel, M. Cohen and D. Greenberg, \"A Radiosity Method for Non-Diffuse Environments\", SIGGRAPH 86",
        words: "Each patch sends other light in each direction, so that mirrors are solved for too, with as many unknowns as pairs of patches.",
        printed: None,
        way: Way::Absent("The program does not have it: two passes and paths have what it was for."),
    },
    Technique {
        name: "kajiya",
        year: 1986,
        title: "Paths",
        paper: "J. Kajiya, \"The Rendering Equation\", SIGGRAPH 86",
        words: "One path of light for each sample, here 16 a pixel, with all that surfaces send each other. It is right in the mean; what is \
                off is noise, and the reference is nothing but more of the same.",
        printed: None,
        way: traced("--integrator paths --samples 16"),
    },
    Technique {
        name: "max",
        year: 1986,
        title: "Shafts of light",
        paper: "N. Max, \"Atmospheric Illumination and Shadows\", SIGGRAPH 86",
        words: "Dust in the air is lit by lamps and lies in shadows. Nishita, Miyamae and Nakamae (1987) gave the lamps their directions.",
        printed: None,
        way: Way::Absent(
            "Not drawn here: the program has it, and the room has no dust (the statement medium of a scene).",
        ),
    },
    Technique {
        name: "wallace-cohen-greenberg",
        year: 1987,
        title: "Two passes",
        paper: "J. Wallace, M. Cohen and D. Greenberg, \"A Two-Pass Solution to the Rendering Equation\", SIGGRAPH 87",
        words: "Radiosity for what goes between diffuse surfaces, also through mirrors and glass, then rays for what the eye sees: \
                solved light in the place of the ambient term, traced lamps, mirrors and glass.",
        printed: None,
        way: Way::Traced {
            scene: PLAIN,
            solved: Some("--method gather --factors rays:64"),
            options: "--lamps area --samples 64",
            against: Against::Paths,
        },
    },
    Technique {
        name: "rushmeier-torrance",
        year: 1987,
        title: "Zones",
        paper: "H. Rushmeier and K. Torrance, \"The Zonal Method for Calculating Light Intensities in the Presence of a Participating Medium\", \
                SIGGRAPH 87",
        words: "Radiosity with volumes of air beside the patches of surfaces: n\u{b3} of them, and factors between all.",
        printed: None,
        way: Way::Absent("The program does not have it."),
    },
    Technique {
        name: "cohen-chen",
        year: 1988,
        title: "Progressive refinement",
        paper: "M. Cohen, S. Chen, J. Wallace and D. Greenberg, \"A Progressive Refinement Approach to Fast Radiosity Image Generation\", \
                SIGGRAPH 88",
        words: "The patch with the most light left shoots it at all others; what is not shot yet is shown as ambient light. Here after 100 \
                shots, with the factors of Wallace, Elmquist and Haines (1989).",
        printed: None,
        way: radiosity("--tessellate 4 --method shoot --sweeps 1"),
    },
    Technique {
        name: "ward-rubinstein-clear",
        year: 1988,
        title: "Kept irradiance",
        paper: "G. Ward, F. Rubinstein and R. Clear, \"A Ray Tracing Solution for Diffuse Interreflection\", SIGGRAPH 88",
        words: "As two passes, but what arrives from other surfaces is found by rays at some of the places that the eye sees, close to each other \
                in corners, and mixed between them.",
        printed: None,
        way: Way::Traced {
            scene: PLAIN,
            solved: Some("--method gather --factors rays:64"),
            options: "--light-as cache --lamps area --samples 64",
            against: Against::Paths,
        },
    },
];
