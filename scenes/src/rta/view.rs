//! The statements that a scene has once: camera, picture, model, air, sky and floor.

use super::Reader;
use super::models;
use super::said::Said;
use crate::description::{Attenuation, Camera, Fading, Floor, Journey, Medium, Optics, Side, Sky, Surface};
use crate::error::{Found, SceneError};
use crate::numbers::{Numbers, Range};
use crate::space::{Triple, cross, difference, length, unit};

/// How near the upward direction may come to that of view: the sine of the angle between them.
const UPRIGHT: f64 = 1e-9;

/// Pixels of a picture where a scene says nothing.
pub(super) const SIZE: [u32; 2] = [320, 200];
/// Shape of the screen where a scene says nothing.
pub(super) const SCREEN: [f64; 2] = [4.0, 3.0];

/// Returns whether pixels are square on a screen of that shape.
pub(super) fn is_square([width, height]: [u32; 2], [across, up]: [f64; 2]) -> bool {
    f64::from(width) * up == f64::from(height) * across
}

fn shown(vector: Triple) -> Found {
    Found::Number(Numbers(&vector).to_string())
}

impl<'a> Reader<'a> {
    pub(super) fn camera(&mut self, said: &Said<'a>) -> Result<(), SceneError> {
        let eye = said.triple("at").unwrap_or_default();
        let view = match said.part("to") {
            Some(to) if unit(difference(to.numbers(0), eye)).is_none() => {
                let expected = "a place to look at (another than that of the camera)";
                return Err(said.error(to.word(0).1, expected, shown(to.numbers(0))));
            }
            Some(to) => difference(to.numbers(0), eye),
            None => said.triple("look").unwrap_or_default(),
        };
        let Some(forward) = unit(view) else {
            let place = said.part("look").map_or(said.place, |look| look.word(0).1);
            return Err(said.error(place, "the camera's direction (not zero)", shown(view)));
        };
        let up = said.triple("up");
        if let Some((part, up)) = said.part("up").zip(up)
            && unit(up).is_none_or(|up| length(cross(forward, up)) < UPRIGHT)
        {
            let expected = "the camera's up (a direction that is not along the view)";
            return Err(said.error(part.word(0).1, expected, shown(up)));
        }
        let side = if said.has("high") { Side::Height } else { Side::Width };
        self.scene.camera = Camera { eye, view, focal: said.number("lens").unwrap_or(1.0), side, up };
        self.angle = said.number("angle");
        self.scene.optics = Optics {
            focus: said.number("focus"),
            aperture: said.number("aperture"),
            shutter: said.part("shutter").map(|shutter| shutter.numbers(0)),
            hither: said.number("hither"),
            moves: said.triple("moves"),
        };
        let along = self.along(said)?;
        self.scene.details.journey = along.map(|path| Journey { path, aim: said.triple("to") });
        Ok(())
    }

    /// Turns the angle of view into the distance of the image, of which the longer side is 1.
    pub(super) fn widen(&mut self) {
        let Some(angle) = self.angle else { return };
        let shape = match (self.scene.settings.screen, self.scene.raster) {
            (Some(screen), _) => screen,
            (None, Some(size)) => size.map(f64::from),
            (None, None) => SCREEN,
        };
        let [width, height] = shape;
        self.scene.camera.side = if width >= height { Side::Width } else { Side::Height };
        // An angle that is next to nothing is the smallest that a float can tell from it.
        let focal = 0.5 / (angle.to_radians() / 2.0).tan();
        self.scene.camera.focal = focal.clamp(f64::MIN_POSITIVE, f64::MAX);
    }

    pub(super) fn picture(&mut self, said: &Said<'a>) -> Result<(), SceneError> {
        let size = said.part("").map_or(SIZE, |part| [part.whole(0), part.whole(1)]);
        let screen = said.part("screen").map_or(SCREEN, |part| part.numbers(0));
        if let Some(samples) = said.part("samples") {
            let number = samples.whole(0);
            if number.isqrt().pow(2) != number {
                let (word, place) = samples.word(0);
                let expected = "the samples of the picture (a square number: 1, 4, 9, 16 ... 1024)";
                return Err(said.error(place, expected, Found::token(word)));
            }
        }
        self.scene.raster = Some(size);
        let settings = &mut self.scene.settings;
        settings.screen = (!is_square(size, screen)).then_some(screen);
        settings.depth = said.whole("depth");
        settings.samples = said.whole("samples");
        settings.cutoff = said.number("cutoff");
        Ok(())
    }

    pub(super) fn model(&mut self, said: &Said<'a>) -> Result<(), SceneError> {
        let model = models::model(said)?;
        self.scene.settings.model_options = models::options(said, model.name())?;
        self.scene.model = model;
        Ok(())
    }

    pub(super) fn attenuation(&mut self, said: &Said<'a>) -> Result<(), SceneError> {
        let Some(part) = said.part("") else { return Ok(()) };
        let (name, place) = part.word(0);
        let given = part.data.len() - 1;
        const NAMES: [&str; 5] = ["none", "warnock", "romney", "haze", "fog"];
        let (least, most) = match name {
            "none" | "warnock" => (0, 0),
            "romney" => (0, 1),
            "haze" => (2, 2),
            "fog" => (1, 3),
            _ => {
                let expected = format!("an attenuation ({})", super::nearest::any_of(&NAMES));
                return Err(said.error(place, expected, super::nearest::found(name, NAMES)));
            }
        };
        if given < least || (name == "fog" && given == 2) {
            let numbers = if name == "haze" { "two numbers" } else { "one number or three" };
            let expected = format!("{numbers} behind \"{name}\" of the attenuation");
            return Err(said.error(place, expected, Found::Told(format!("{given} of them"))));
        }
        if let Some(spare) = part.data.get(most + 1) {
            let expected = format!("nothing more behind \"{name}\" of the attenuation");
            return Err(said.error(spare.place, expected, Found::token(spare.word)));
        }
        let fading = match name {
            "none" => return Ok(()),
            "fog" => {
                let extinction = if given == 1 { [part.number(1); 3] } else { part.numbers(1) };
                return self.fill(said, Medium::fog(extinction));
            }
            "warnock" => Fading::Warnock,
            "romney" => Fading::Romney(if given == 0 { 4.0 } else { part.number(1) }),
            _ => Fading::Haze(part.numbers(1)),
        };
        let is_wrong = match fading {
            Fading::Haze([near, far]) => near >= far,
            Fading::Romney(power) => power <= 0.0,
            Fading::Warnock => false,
        };
        if is_wrong {
            let (word, place) = part.word(given);
            let expected = match fading {
                Fading::Haze([near, _]) => {
                    format!("the distance of full haze (a number > {})", Numbers(&[near]))
                }
                _ => format!("the power of the attenuation ({})", Range::Positive),
            };
            return Err(said.error(place, expected, Found::token(word)));
        }
        let (from, color) = (said.number("from"), said.triple("color"));
        self.scene.air.attenuation = Some(Attenuation { fading, from, color });
        Ok(())
    }

    pub(super) fn medium(&mut self, said: &Said<'a>) -> Result<(), SceneError> {
        let medium = Medium {
            extinction: said.triple("extinction").unwrap_or_default(),
            albedo: said.number("albedo").unwrap_or(1.0),
            anisotropy: said.number("anisotropy").unwrap_or(0.0),
            shadows: said.whole("shadows").unwrap_or(0),
            reach: said.number("reach"),
        };
        self.fill(said, medium)
    }

    fn fill(&mut self, said: &Said<'a>, medium: Medium) -> Result<(), SceneError> {
        if self.scene.air.medium.is_some() {
            let found = Found::Told("a second: fog is a medium too".into());
            return Err(said.error(said.place, "one medium", found));
        }
        self.scene.air.medium = Some(medium);
        Ok(())
    }

    pub(super) fn spectral(&mut self, said: &Said<'a>) -> Result<(), SceneError> {
        let number = said.whole("").unwrap_or(1);
        if number.is_multiple_of(2) {
            let (word, place) = said.part("").map_or(("", said.place), |part| part.word(0));
            let expected = "the number of wavelengths of the spectral (an odd number from 1 to 31)";
            return Err(said.error(place, expected, Found::token(word)));
        }
        self.scene.settings.wavelengths = Some(number);
        Ok(())
    }

    pub(super) fn sky(&mut self, said: &Said<'a>) -> Result<(), SceneError> {
        if let Some(map) = said.part("map") {
            self.scene.details.sky_map = Some(map.word(0).0.to_owned());
            return Ok(());
        }
        let flat = said.triple("").unwrap_or_default();
        let [horizon, zenith] = ["horizon", "zenith"].map(|part| said.triple(part).unwrap_or(flat));
        self.scene.sky = Sky { horizon, zenith };
        Ok(())
    }

    pub(super) fn floor(&mut self, said: &Said<'a>) -> Result<(), SceneError> {
        let colors = said.part("").map_or([[0.0; 3]; 2], |part| [part.numbers(0), part.numbers(3)]);
        let surface = match said.part("of") {
            Some(of) => self.refer(said, of)?,
            None => Surface::Opaque,
        };
        self.scene.details.tile = said.number("tile").filter(|tile| *tile != 3.0);
        self.scene.floor = Some(Floor { colors, surface });
        Ok(())
    }
}
