//! The pictures that each board draws.

use std::path::PathBuf;

use rta::engine::Format;
use rta_scenes::bake::Model;
use rta_scenes::sampler::{Adaptive, Cutting, Lamps};

use super::board::{Board, Output};

/// How the colours of a picture are chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colors {
    /// By the uniform table where the picture is streamed, by the tolerant one on a screen; on a panel by error diffusion in its greys.
    Standard,
    /// By a palette made from samples of the picture.
    Sampled,
    /// By such a palette, with error diffusion.
    Dithered,
}

/// Returns the name of a way of antialiasing, as images are told it.
#[must_use]
pub const fn way(adaptive: Adaptive) -> &'static str {
    match adaptive {
        Adaptive::Whitted(_) => "whitted",
        Adaptive::Mitchell => "mitchell",
    }
}

impl Colors {
    /// Returns its name, as images are told it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Standard => "standard",
            Self::Sampled => "sampled",
            Self::Dithered => "dithered",
        }
    }
}

/// A picture that one image draws.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// The scene's name.
    pub scene: &'static str,
    /// The scene file.
    pub file: PathBuf,
    /// The illumination model; `None` for the scene's own. Footprints are recorded of the pictures without one.
    pub model: Option<Model>,
    /// The number format.
    pub format: Format,
    /// How lamps with a size are asked for their light: [`Lamps::Point`] or [`Lamps::Area`].
    pub lamps: Lamps,
    /// Whether the program solves for the radiosity of the scene.
    pub solves: bool,
    /// Whether a Z-buffer finds what the rays from the eye meet.
    pub buffered: bool,
    /// How pixels are antialiased, if they are.
    pub antialiased: Option<Adaptive>,
    /// Whether the program holds only what this scene needs, or all that any scene may need.
    pub baked: bool,
    /// How its colours are chosen.
    pub colors: Colors,
    /// Width and height in pixels.
    pub size: (u32, u32),
}

impl Picture {
    /// Whether the picture is among those that `--brief` draws.
    #[must_use]
    pub fn is_brief(&self, board: &Board) -> bool {
        if matches!(board.output, Output::File { .. }) {
            return self.scene == "juggler";
        }
        if let Some(model) = self.model {
            let is_drawn = matches!(board.name, "microbit" | "sparc" | "wasm") && BRIEF.contains(&model);
            let is_own = match self.scene {
                scene if scene == MODELS.0 => false,
                // On each processor.
                scene if scene == SPREAD.0 || scene == ROOM.0 => {
                    !matches!(board.name, "lm3s6965evb-oled" | "pc-floppy")
                }
                scene if OF_SURFACES.iter().any(|(own, _)| *own == scene) => {
                    matches!(board.name, "microbit" | "sparc" | "wasm")
                }
                _ => true,
            };
            return is_drawn || is_own;
        }
        let any_scene = matches!(
            (board.name, self.scene, self.format),
            ("microbit", "opaque", Format::Q16) | ("mps2-an386", "opaque", Format::F32)
        );
        // Every scene on two boards, and the one that another has; elsewhere the least and the most that there is.
        let this_scene = match self.format {
            Format::Q16 if matches!(board.name, "microbit" | "riscv" | "pc-floppy") => true,
            Format::Q16 => matches!(self.scene, "opaque" | "glass-2"),
            _ => self.scene == "juggler",
        };
        // Error diffusion contains all that a palette takes.
        let palette = matches!(
            (board.name, self.scene, self.format),
            ("microbit", "opaque", Format::Q16) | ("mps2-an386", "juggler", Format::F32)
        );
        match self.colors {
            Colors::Standard if self.antialiased.is_some() => board.name == ANTIALIASED,
            Colors::Standard if self.buffered => matches!(board.name, "microbit" | "sparc" | "wasm"),
            Colors::Standard => {
                if self.baked {
                    this_scene
                } else {
                    any_scene
                }
            }
            Colors::Sampled => palette,
            Colors::Dithered => palette || self.scene == "opaque" && self.format == Format::Q16,
        }
    }

    /// Returns what the program can draw, in words: the column "needs" of the footprint table, or the picture's model.
    #[must_use]
    pub fn needs(&self) -> &'static str {
        if let Some(model) = self.model {
            return model.name();
        }
        match self.colors {
            Colors::Standard if self.buffered => "Z-buffer",
            Colors::Standard if self.antialiased == Some(Adaptive::Mitchell) => "aa mitchell",
            Colors::Standard if self.antialiased.is_some() => "aa whitted",
            Colors::Standard if self.baked => "baked",
            Colors::Standard => "Everything",
            // Baked too.
            colors => colors.name(),
        }
    }

    /// Returns the name of the picture in messages and files.
    #[must_use]
    pub fn title(&self, board: &Board) -> String {
        format!("{} {} {} {}", board.name, self.scene, self.format, self.needs())
    }
}

/// The raster of pictures that are streamed.
const STREAMED: (u32, u32) = (160, 100);

/// The raster of pictures that are drawn by a given model, where the screen does not say it.
const OF_MODELS: (u32, u32) = (64, 40);

/// The models of [`MODELS`] in `--brief`: microfacets with several slopes, lamps seen through glass, absorption.
const BRIEF: [Model; 3] = [Model::CookTorrance, Model::HallGreenberg, Model::KayGreenberg];

/// The scene that every model draws on every board: a little of everything that they tell apart.
pub const MODELS: (&str, &str) = ("models", "../scenes/models.rta");

/// The scenes whose programs are measured with [`LIMITS`].
pub const MEASURED: [(&str, &str); 2] =
    [("juggler", "../../scenes/juggler.dat"), ("glass-2", "../../scenes/glass-2.dat")];

/// The most bytes of code that a program for the Cortex-M0 that draws one of [`MEASURED`] may have more with a model than with `whitted`.
pub const LIMITS: [(Model, i64); 4] = [
    (Model::Blinn, 1024),
    (Model::KayGreenberg, 2048),
    (Model::CookTorrance, 4096),
    (Model::HallGreenberg, 5120),
];

/// A scene with air, drawn by its own model.
pub const HAZE: (&str, &str) = ("haze", "../../scenes/haze.rta");

/// Scenes that every board draws by Whitted's model: patterns, pictures, bumps and mapped surroundings on all kinds of things; and wavelengths.
const OF_SURFACES: [(&str, &str); 2] =
    [("surfaces", "../scenes/surfaces.rta"), ("wavelengths", "../scenes/wavelengths.rta")];

/// A scene with everything that spreads rays, which every board draws in both fixed-point formats with 4 samples a pixel.
const SPREAD: (&str, &str) = ("spread", "scenes/spread.rta");

/// A room for whose light every board solves before it draws it.
const ROOM: (&str, &str) = ("room", "scenes/room.rta");

/// The raster of both.
const OF_SPREAD: (u32, u32) = (40, 30);

/// The board that draws the Juggler with antialiasing: the smallest.
const ANTIALIASED: &str = "microbit";

/// The scenes that are drawn: name, and file relative to the folder of the boards.
const SCENES: [(&str, &str); 4] = [
    ("opaque", "scenes/opaque.dat"),
    ("juggler", "../../scenes/juggler.dat"),
    ("glass-2", "../../scenes/glass-2.dat"),
    ("hall-22", "../../scenes/hall-22.dat"),
];

impl Board {
    /// Whether the board draws a scene with palettes too: on the two boards that are compared in what they cost, all scenes; elsewhere one. A
    /// panel has no colour table.
    fn is_colored(&self, scene: &str, format: Format) -> bool {
        match format {
            _ if matches!(self.output, Output::Panel { .. }) => false,
            Format::Q16 => self.name == "microbit" || (scene == "opaque" && self.name != "pc-floppy"),
            _ => self.name == "mps2-an386",
        }
    }

    /// Returns the pictures that the board draws.
    #[must_use]
    pub fn pictures(&self) -> Vec<Picture> {
        let mut pictures = Vec::new();
        for (scene, file) in SCENES {
            for format in [Format::Q16, Format::F32] {
                // Size and instructions are told for boards with flash; the PC's second image is there to be booted.
                let everything = self.output == Output::Semihosting;
                if self.name == "pc-floppy" && (scene != "juggler" || format != Format::Q16) {
                    continue;
                }
                // A DOS program draws all of the thesis's scenes, and in q16 only.
                if matches!(self.output, Output::File { .. }) && (scene == "opaque" || format != Format::Q16)
                {
                    continue;
                }
                let size = match self.output {
                    Output::Screen { screen: (width, height, _), .. }
                        if (self.name == "sparc" && scene == "glass-2") || self.package == "pc" =>
                    {
                        (width, height)
                    }
                    Output::File { screen: (width, height, _) } => (width, height),
                    Output::Screen { .. } => (320, 200),
                    Output::Panel { size, .. } => size,
                    Output::Semihosting | Output::Module => STREAMED,
                };
                let file = super::folder().join(file);
                let picture = Picture {
                    scene,
                    file,
                    model: None,
                    format,
                    lamps: Lamps::Point,
                    solves: false,
                    buffered: false,
                    antialiased: None,
                    baked: true,
                    colors: Colors::Standard,
                    size,
                };
                pictures.push(picture.clone());
                // One scene on each processor.
                if scene == "juggler"
                    && format == Format::Q16
                    && !matches!(self.output, Output::Panel { .. } | Output::File { .. })
                {
                    pictures.push(Picture { buffered: true, ..picture.clone() });
                }
                if scene == "juggler" && format == Format::Q16 && self.name == ANTIALIASED {
                    let ways = [Adaptive::Whitted(Cutting::default()), Adaptive::Mitchell].map(Some);
                    pictures.extend(ways.map(|antialiased| Picture { antialiased, ..picture.clone() }));
                }
                if everything {
                    pictures.push(Picture { baked: false, ..picture.clone() });
                }
                if self.is_colored(scene, format) {
                    let colors = [Colors::Sampled, Colors::Dithered];
                    pictures.extend(colors.map(|colors| Picture { colors, ..picture.clone() }));
                }
            }
        }
        if !matches!(self.output, Output::File { .. }) {
            pictures.extend(self.of_models());
        }
        pictures
    }

    /// Returns the pictures of given models: every model on every board, and on the smallest those whose programs are measured.
    fn of_models(&self) -> Vec<Picture> {
        // A PC draws on all of its screen, and so does a panel.
        let size = match self.output {
            Output::Screen { screen: (width, height, _), .. } if self.package == "pc" => (width, height),
            Output::Panel { size, .. } => size,
            _ => OF_MODELS,
        };
        let picture = |(scene, file), model| Picture {
            scene,
            file: super::folder().join(file),
            model: Some(model),
            format: Format::Q16,
            lamps: Lamps::Point,
            solves: false,
            buffered: false,
            antialiased: None,
            baked: true,
            colors: Colors::Standard,
            size,
        };
        let mut pictures: Vec<_> = Model::ALL.iter().map(|&model| picture(MODELS, model)).collect();
        pictures.extend(OF_SURFACES.map(|scene| picture(scene, Model::Whitted)));
        let size = if matches!(self.output, Output::Panel { .. }) { size } else { OF_SPREAD };
        let spread = Picture { lamps: Lamps::Area, size, ..picture(SPREAD, Model::Whitted) };
        pictures.extend([Format::Q16, Format::Q20].map(|format| Picture { format, ..spread.clone() }));
        let room = Picture { solves: true, ..spread };
        let (scene, file) = ROOM;
        pictures.push(Picture {
            scene,
            file: super::folder().join(file),
            model: Some(Model::Lambert),
            ..room
        });
        if self.name == "microbit" {
            let measured = [Model::Whitted].into_iter().chain(LIMITS.map(|(model, _)| model));
            let measured = measured.flat_map(|model| MEASURED.map(|scene| picture(scene, model)));
            pictures.extend(measured);
            pictures.push(picture(HAZE, Model::Whitted));
        }
        pictures
    }
}
