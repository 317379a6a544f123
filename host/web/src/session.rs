//! A picture or a film that is being drawn on a display.

use std::borrow::Cow;

use rta_core::color::Rgb;
use rta_core::raster::lattice::Lattice;
use rta_scenes::description::Description;

use crate::failure::Failure;
use crate::json;
use crate::picture::{self, Picture, Setup};
use crate::pictures::Pictures;
use crate::request::{Request, Time};
use crate::screen::Screen;

/// A scene, its picture or a frame of its film, and the display that shows it.
pub(crate) struct Session {
    request: Request,
    scene: Description,
    setup: Setup,
    shown: Shown,
}

/// A picture and the display that shows it.
struct Shown {
    picture: Box<dyn Picture>,
    screen: Screen,
    /// Rows that were drawn.
    drawn: u32,
}

/// What the scene is called: a name that leaves it to the text which of the languages it is.
const NAME: &str = "scene";

/// Reads the scene of a request and gives it the pictures that it names.
fn read(request: &Request, text: &[u8], pictures: &Pictures) -> Result<(Description, Setup), Failure> {
    let mut scene = rta_scenes::read(text, NAME)?;
    pictures.give(&mut scene)?;
    let setup = Setup::new(request, &scene)?;
    Ok((scene, setup))
}

/// Returns the number of pictures that a request asks for: 1 where nothing moves.
fn frames(request: &Request, scene: &Description) -> u32 {
    match request.time {
        Time::Film(frames) if scene.moves() => frames,
        _ => 1,
    }
}

/// Calls `act` with the scene as it is in frame `number` of what a request asks for; what fails there names the frame of a film.
fn in_frame<T>(
    request: &Request,
    scene: &Description,
    number: u32,
    act: impl FnOnce(&Description) -> Result<T, Failure>,
) -> Result<T, Failure> {
    let frames = frames(request, scene);
    if number >= frames {
        return Err(Failure::plain(format!("there are {frames} frames, no frame {number}")));
    }
    let instant = match request.time {
        Time::Instant(instant) => instant,
        Time::Film(frames) => f64::from(number) / f64::from(frames),
    };
    let still = if scene.moves() { Cow::Owned(scene.at(instant)) } else { Cow::Borrowed(scene) };
    act(&still).map_err(|failure| match frames {
        1 => failure,
        _ => Failure { message: format!("frame {number}, the instant {instant}: {failure}"), ..failure },
    })
}

/// Reads the scene of a request and proves that it fits the number format, in all frames. Returns what [`Session::start`] tells of it.
///
/// # Errors
/// [`Failure`] with the place in the text.
pub(crate) fn check(request: &[u8], pictures: &Pictures) -> Result<String, Failure> {
    let (request, text) = Request::parse(request)?;
    let (scene, setup) = read(&request, text, pictures)?;
    for number in 0..frames(&request, &scene) {
        in_frame(&request, &scene, number, |scene| picture::admit(&request, scene, setup))?;
    }
    Ok(summary(&request, &scene, setup))
}

/// What is said of a scene whose rays the program spreads.
const SPREADS: &str = "on a page no rays are spread: its lens is a pinhole here, its rough materials are smooth, and its lamps are points";

/// Returns whether rays would be spread in a scene: over a lens, or over the facets of rough materials or of the model.
fn spreads(scene: &Description) -> bool {
    let is_above = |size: Option<f64>| size.is_some_and(|size| size > 0.0);
    is_above(scene.optics.aperture)
        || scene.has_emitters()
        || scene.has_lobes()
        || scene.materials.iter().any(|own| is_above(own.roughness))
}

/// Returns width, height, model, depth, whether anything moves, the number of frames and warnings, as JSON.
fn summary(request: &Request, scene: &Description, setup: Setup) -> String {
    let warning = |(line, text): (u32, &str)| {
        let line = Some(line).filter(|line| *line > 0);
        json::object([("line", json::or_null(line, |line| line.to_string())), ("message", json::text(text))])
    };
    let own = scene.warnings.iter().map(|warning| (warning.line, warning.text.as_str()));
    let warnings = own.chain(spreads(scene).then_some((0, SPREADS))).map(warning);
    json::object([
        ("width", setup.raster.width().to_string()),
        ("height", setup.raster.height().to_string()),
        ("model", json::text(setup.model.name())),
        ("depth", setup.depth.to_string()),
        ("moves", scene.moves().to_string()),
        ("frames", frames(request, scene).to_string()),
        ("warnings", json::list(warnings)),
    ])
}

impl Shown {
    /// Makes the picture of a scene in which nothing moves ready to be drawn: its colour table, and a display that is switched on.
    fn new(request: &Request, scene: &Description, setup: Setup) -> Result<Self, Failure> {
        let picture = picture::picture(request, scene, setup)?;
        let (raster, capabilities) = (setup.raster, request.device.capabilities());
        let lattice = Lattice::new(raster, request.table.samples());
        let samples = match request.table.samples() {
            0 => Vec::new(),
            _ => picture.on_grid(lattice).map_err(Failure::plain)?,
        };
        let table =
            request.table.table(&capabilities, &samples, lattice.grid().width()).map_err(Failure::plain)?;
        let dither = request.dither.unwrap_or_else(|| request.table.dithering(&capabilities));
        let screen = Screen::new(request.device, table, dither, raster.width() as usize)?;
        Ok(Self { picture, screen, drawn: 0 })
    }
}

impl Session {
    /// Makes the picture of a request ready to be drawn, or the first frame of its film. Returns it and what there is to say about it.
    ///
    /// # Errors
    /// [`Failure`], with the place in the scene's text where there is one.
    pub(crate) fn start(request: &[u8], pictures: &Pictures) -> Result<(Self, String), Failure> {
        let (request, text) = Request::parse(request)?;
        let (scene, setup) = read(&request, text, pictures)?;
        let shown = in_frame(&request, &scene, 0, |scene| Shown::new(&request, scene, setup))?;
        let summary = summary(&request, &scene, setup);
        Ok((Self { request, scene, setup, shown }, summary))
    }

    /// Makes another frame of the film ready to be drawn.
    ///
    /// # Errors
    /// [`Failure`] if the film has no such frame.
    pub(crate) fn frame(&mut self, number: u32) -> Result<(), Failure> {
        let Self { request, scene, setup, .. } = &*self;
        self.shown = in_frame(request, scene, number, |scene| Shown::new(request, scene, *setup))?;
        Ok(())
    }

    /// Traces row `y`, draws it and returns it as it lies in the display's memory: the entry of the colour table for each pixel.
    ///
    /// # Errors
    /// [`Failure`] if the picture has no such row.
    pub(crate) fn row(&mut self, y: u32) -> Result<Vec<u8>, Failure> {
        let (raster, Shown { picture, screen, drawn }) = (self.setup.raster, &mut self.shown);
        if y >= raster.height() {
            return Err(Failure::plain(format!("the picture has {} rows, no row {y}", raster.height())));
        }
        let light = picture.row(y, screen.light_max()).map_err(Failure::plain)?;
        screen.put_row(y, &light)?;
        *drawn = (*drawn).max(y + 1);
        screen.indices(y, raster.width() as usize)
    }

    /// Returns the entries of the colour table so far: red, green and blue.
    ///
    /// # Errors
    /// [`Failure`] if the display does not answer.
    pub(crate) fn colors(&mut self) -> Result<Vec<u8>, Failure> {
        let colors = self.shown.screen.colors()?;
        Ok(colors.into_iter().flat_map(|Rgb { r, g, b }| [r, g, b]).collect())
    }

    /// Traces a pixel once more and returns what its rays meet, as [`Explanation::json`](crate::explain::Explanation::json) tells it.
    ///
    /// # Errors
    /// [`Failure`] if the picture has no such pixel.
    pub(crate) fn explain(&mut self, x: u32, y: u32) -> Result<String, Failure> {
        let (raster, Shown { picture, screen, drawn }) = (self.setup.raster, &mut self.shown);
        if x >= raster.width() || y >= raster.height() {
            return Err(Failure::plain(format!("the picture has no pixel {x},{y}")));
        }
        let explanation = picture.explain(x, y).map_err(Failure::plain)?;
        let mut shown = None;
        if y < *drawn {
            let indices = screen.indices(y, raster.width() as usize)?;
            let index = indices.get(x as usize).copied().unwrap_or_default();
            shown = screen.colors()?.get(usize::from(index)).map(|entry| (index, *entry));
        }
        Ok(explanation.json(&self.scene, shown))
    }
}

#[cfg(test)]
mod tests {
    use rta_scenes::shipped;

    use super::{Session, check};
    use crate::pictures::Pictures;

    const NONE: Pictures = Pictures::new();

    fn request(settings: &str, scene: &str) -> Vec<u8> {
        format!("{settings}\n{scene}").into_bytes()
    }

    #[test]
    fn rows_are_drawn_and_pixels_explained() {
        for (device, width, height) in [("vga", 40, 25), ("graphigs", 128, 128), ("pixrect", 144, 112)] {
            let request =
                request(&format!("{device} 8 q16 auto auto sampled auto instant 0"), shipped::GLASS_2);
            let (mut session, summary) = Session::start(&request, &NONE).expect("a picture");
            assert_eq!(check(&request, &NONE).as_ref(), Ok(&summary));
            assert!(
                summary.starts_with(&format!("{{\"width\":{width},\"height\":{height},\"model\":\"rta\""))
            );
            let before = session.explain(0, 0).expect("a pixel");
            assert!(before.contains("\"index\":null,\"color\":null"), "{before}");
            for y in 0..height {
                let row = session.row(y).expect("a row");
                assert_eq!(row.len(), width as usize);
                let colors = session.colors().expect("a colour table").len() / 3;
                assert!(row.iter().all(|&index| usize::from(index) < colors));
            }
            let after = session.explain(width / 2, height / 2).expect("a pixel");
            assert!(
                after.contains("\"text\":\"sphere 1, glass, at ") && !after.contains("null,\"rays\""),
                "{after}"
            );
            assert!(session.colors().is_ok_and(|colors| colors.len() > 30 && colors.len() % 3 == 0));
            let outside = [session.explain(width, 0), session.explain(0, height)];
            assert!(outside.iter().all(Result::is_err) && session.row(height).is_err());
        }
    }

    #[test]
    fn frames_are_the_pictures_of_their_instants() {
        let picture = |session: &mut Session| -> (Vec<_>, Vec<u8>) {
            let rows = (0..25).map(|y| session.row(y).expect("a row"));
            (rows.collect(), session.colors().expect("a colour table"))
        };
        let start = |time: &str, scene: &str| {
            Session::start(&request(&format!("vga 8 q16 auto auto sampled auto {time}"), scene), &NONE)
        };
        let (mut film, summary) = start("frames 5", shipped::JUGGLING).expect("a film");
        assert!(summary.contains(r#""moves":true,"frames":5,"#), "{summary}");
        let mut before = None;
        for number in [0, 3, 4] {
            film.frame(number).expect("a frame");
            let instant = format!("instant {}", f64::from(number) / 5.0);
            let (mut still, _) = start(&instant, shipped::JUGGLING).expect("a picture");
            let frame = picture(&mut film);
            assert_eq!(frame, picture(&mut still), "{number}");
            assert!(before.replace(frame.clone()) != Some(frame), "{number}");
        }
        let failure = film.frame(5).expect_err("there are five");
        assert_eq!(failure.message, "there are 5 frames, no frame 5");
        // Where nothing moves, a film is one picture.
        let (mut still, summary) = start("frames 5", shipped::GLASS_2).expect("a picture");
        assert!(summary.contains(r#""moves":false,"frames":1,"#), "{summary}");
        assert!(still.frame(1).is_err());
        // What fits at the beginning need not fit later.
        let flight = "rta 1\npath flight at 0 0 0 0 at 1 0 0 200000\ncamera at 0 -8 2 look 0 1 0\n\
            sphere at 0 0 1 radius 1 color 1 1 1 along flight\n";
        let failure =
            check(&request("vga 8 q16 auto auto sampled auto frames 4", flight), &NONE).expect_err("too far");
        assert_eq!(failure.line, Some(4));
        assert!(failure.message.starts_with("frame 1, the instant 0.25: sphere 1"), "{failure}");
        assert!(start("instant 0", flight).is_ok() && start("instant 0.25", flight).is_err());
    }

    #[test]
    fn what_the_program_would_spread_is_said() {
        let told = |scene: &str| check(&request("vga 8 q16 auto auto sampled auto instant 0", scene), &NONE);
        let camera = "rta 1\ncamera at 0 -8 2 look 0 1 0";
        for (scene, is_spread) in [
            (format!("{camera}\n"), false),
            (format!("{camera} aperture .1\n"), true),
            (
                format!(
                    "{camera}\nmaterial brushed roughness .3 mirror 1\nsphere at 0 0 1 radius 1 of brushed\n"
                ),
                true,
            ),
        ] {
            let told = told(&scene).expect("a scene");
            assert_eq!(told.contains("no rays are spread"), is_spread, "{scene}: {told}");
        }
    }

    #[test]
    fn errors_have_their_place() {
        let place = |scene: &str| {
            let failure = check(&request("vga 1 q16 auto auto sampled auto instant 0", scene), &NONE)
                .expect_err("no scene");
            (failure.line, failure.column)
        };
        assert_eq!(place("0 -7 2.3\n0 1 zero"), (Some(2), Some(5)));
        assert_eq!(place(""), (Some(1), Some(1)));
        let far = shipped::GLASS_2.replace("-1.7 3.2 0.9 ", "-1.7 90000 0.9 ");
        assert_eq!(place(&far), (Some(9), None));
        // Pictures are asked for in the line that names them.
        let textured = "rta 1\ncamera at 0 -8 2  look 0 1 0\ntexture globe image \"globe.png\"\n";
        assert_eq!(place(textured), (Some(3), None));
    }
}
