//! A picture that is being drawn on a display.

use rta_core::color::Rgb;
use rta_core::raster::Raster;
use rta_core::raster::lattice::Lattice;
use rta_scenes::description::Description;

use crate::failure::Failure;
use crate::json;
use crate::picture::{self, Picture, Setup};
use crate::request::Request;
use crate::screen::Screen;

/// A scene, its picture and the display that shows it.
pub(crate) struct Session {
    scene: Description,
    picture: Box<dyn Picture>,
    screen: Screen,
    raster: Raster,
    /// Rows that were drawn.
    drawn: u32,
}

/// What the scene is called: a name that leaves it to the text which of the languages it is.
const NAME: &str = "scene";

/// Reads the scene of a request.
fn read(request: &Request) -> Result<(Description, Setup), Failure> {
    let mut scene = rta_scenes::read(request.text, NAME)?;
    // There are no files beside the scene, so this tells the first picture that it names.
    scene.load_pictures("".as_ref(), 1).map_err(|error| Failure {
        line: Some(error.line).filter(|line| *line > 0),
        ..Failure::plain("a page has no picture files; a scene that names one is drawn by the program")
    })?;
    let setup = Setup::new(request, &scene)?;
    Ok((scene, setup))
}

/// Reads the scene of a request and proves that it fits the number format. Returns what [`Session::start`] tells of it.
///
/// # Errors
/// [`Failure`] with the place in the text.
pub(crate) fn check(request: &[u8]) -> Result<String, Failure> {
    let request = Request::parse(request)?;
    let (scene, setup) = read(&request)?;
    picture::admit(&request, &scene, setup)?;
    Ok(summary(&scene, setup))
}

/// Returns width, height, model, depth and warnings, as JSON.
fn summary(scene: &Description, setup: Setup) -> String {
    let warnings = scene.warnings.iter().map(|warning| {
        let line = Some(warning.line).filter(|line| *line > 0);
        json::object([
            ("line", json::or_null(line, |line| line.to_string())),
            ("message", json::text(&warning.text)),
        ])
    });
    json::object([
        ("width", setup.raster.width().to_string()),
        ("height", setup.raster.height().to_string()),
        ("model", json::text(setup.model.name())),
        ("depth", setup.depth.to_string()),
        ("warnings", json::list(warnings)),
    ])
}

impl Session {
    /// Makes the picture of a request ready to be drawn. Returns it and what there is to say about it.
    ///
    /// # Errors
    /// [`Failure`], with the place in the scene's text where there is one.
    pub(crate) fn start(request: &[u8]) -> Result<(Self, String), Failure> {
        let request = Request::parse(request)?;
        let (scene, setup) = read(&request)?;
        let picture = picture::picture(&request, &scene, setup)?;
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
        let summary = summary(&scene, setup);
        Ok((Self { scene, picture, screen, raster, drawn: 0 }, summary))
    }

    /// Traces row `y`, draws it and returns it as the display shows it: red, green, blue and 255 for each pixel.
    ///
    /// # Errors
    /// [`Failure`] if the picture has no such row.
    pub(crate) fn row(&mut self, y: u32) -> Result<Vec<u8>, Failure> {
        if y >= self.raster.height() {
            return Err(Failure::plain(format!("the picture has {} rows, no row {y}", self.raster.height())));
        }
        let light = self.picture.row(y, self.screen.light_max()).map_err(Failure::plain)?;
        self.screen.put_row(y, &light)?;
        self.drawn = self.drawn.max(y + 1);
        let entries = self.screen.colors()?;
        let indices = self.screen.indices(y, self.raster.width() as usize)?;
        let pixels = indices.iter().flat_map(|index| {
            let Rgb { r, g, b } = entries.get(usize::from(*index)).copied().unwrap_or_default();
            [r, g, b, u8::MAX]
        });
        Ok(pixels.collect())
    }

    /// Returns the entries of the colour table so far: red, green and blue.
    ///
    /// # Errors
    /// [`Failure`] if the display does not answer.
    pub(crate) fn colors(&mut self) -> Result<Vec<u8>, Failure> {
        Ok(self.screen.colors()?.into_iter().flat_map(|color| [color.r, color.g, color.b]).collect())
    }

    /// Traces a pixel once more and returns what its rays meet, as [`Explanation::json`](crate::explain::Explanation::json) tells it.
    ///
    /// # Errors
    /// [`Failure`] if the picture has no such pixel.
    pub(crate) fn explain(&mut self, x: u32, y: u32) -> Result<String, Failure> {
        if x >= self.raster.width() || y >= self.raster.height() {
            return Err(Failure::plain(format!("the picture has no pixel {x},{y}")));
        }
        let explanation = self.picture.explain(x, y).map_err(Failure::plain)?;
        let mut shown = None;
        if y < self.drawn {
            let indices = self.screen.indices(y, self.raster.width() as usize)?;
            let index = indices.get(x as usize).copied().unwrap_or_default();
            shown = self.screen.colors()?.get(usize::from(index)).map(|entry| (index, *entry));
        }
        Ok(explanation.json(&self.scene, shown))
    }
}

#[cfg(test)]
mod tests {
    use rta_scenes::shipped;

    use super::{Session, check};

    fn request(settings: &str, scene: &str) -> Vec<u8> {
        format!("{settings}\n{scene}").into_bytes()
    }

    #[test]
    fn rows_are_drawn_and_pixels_explained() {
        for (device, width, height) in [("vga", 40, 25), ("graphigs", 128, 128), ("pixrect", 144, 112)] {
            let request = request(&format!("{device} 8 q16 auto auto sampled auto"), shipped::GLASS_2);
            let (mut session, summary) = Session::start(&request).expect("a picture");
            assert_eq!(check(&request).as_ref(), Ok(&summary));
            assert!(
                summary.starts_with(&format!("{{\"width\":{width},\"height\":{height},\"model\":\"rta\""))
            );
            let before = session.explain(0, 0).expect("a pixel");
            assert!(before.contains("\"index\":null,\"color\":null"), "{before}");
            for y in 0..height {
                let row = session.row(y).expect("a row");
                assert_eq!(row.len(), 4 * width as usize);
                assert!(row.iter().skip(3).step_by(4).all(|&alpha| alpha == 255));
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
    fn errors_have_their_place() {
        let place = |scene: &str| {
            let failure = check(&request("vga 1 q16 auto auto sampled auto", scene)).expect_err("no scene");
            (failure.line, failure.column)
        };
        assert_eq!(place("0 -7 2.3\n0 1 zero"), (Some(2), Some(5)));
        assert_eq!(place(""), (Some(1), Some(1)));
        let far = shipped::GLASS_2.replace("-1.7 3.2 0.9 ", "-1.7 90000 0.9 ");
        assert_eq!(place(&far), (Some(9), None));
        // Readers of pictures are not part of the module.
        let textured = "rta 1\ncamera at 0 -8 2  look 0 1 0\ntexture globe image \"globe.png\"\n";
        let failure = check(&request("vga 1 q16 auto auto sampled auto", textured)).expect_err("no picture");
        assert_eq!(failure.line, Some(3));
        assert!(failure.message.starts_with("a page has no picture files"), "{failure}");
    }
}
