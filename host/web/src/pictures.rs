//! The picture files that a page was given, for scenes that name them.

use std::collections::BTreeMap;
use std::io::Cursor;
use std::sync::Arc;

use rta_scenes::description::{Description, Pixels};
use rta_scenes::pictures::{LARGEST_SIDE, decode};

use crate::failure::Failure;

/// The most pixels on a side that a picture keeps, as in `rta render`.
const TEXELS: u32 = 1024;

/// Pictures by the names of their files.
pub(crate) struct Pictures(BTreeMap<String, Arc<Pixels>>);

impl Pictures {
    /// None yet.
    pub(crate) const fn new() -> Self {
        Self(BTreeMap::new())
    }

    /// Takes a picture file: a line with its name, and its contents. Returns the picture as it is kept, as a PPM file, of which another instance of
    /// the module can take it sooner.
    ///
    /// # Errors
    /// [`Failure`] for a file that is no picture, or a broken or too large one.
    pub(crate) fn take(&mut self, file: &[u8]) -> Result<Vec<u8>, Failure> {
        let end = file.iter().position(|&byte| byte == b'\n');
        let parts = end.and_then(|end| Some((str::from_utf8(file.get(..end)?).ok()?, file.get(end + 1..)?)));
        let (name, contents) =
            parts.ok_or_else(|| Failure::plain("a picture begins with a line that is its name"))?;
        let pixels = decode(Cursor::new(contents), name.as_ref(), LARGEST_SIDE);
        let pixels = pixels.map_err(|reason| Failure::plain(format!("the picture {name}: {reason}")))?;
        let pixels = pixels.reduced(TEXELS);
        let mut ppm = format!("P6 {} {} 255\n", pixels.width, pixels.height).into_bytes();
        ppm.extend(pixels.words.iter().flat_map(|word| {
            let [_, r, g, b] = word.to_be_bytes();
            [r, g, b]
        }));
        self.0.insert(name.to_owned(), Arc::new(pixels));
        Ok(ppm)
    }

    /// Gives a scene the pictures that it names.
    ///
    /// # Errors
    /// [`Failure`] that names all that are missing, in the line that names the first of them.
    pub(crate) fn give(&self, scene: &mut Description) -> Result<(), Failure> {
        let missing: Vec<_> = scene.named_pictures().filter(|(file, _)| self.find(file).is_none()).collect();
        if let Some((_, line)) = missing.first() {
            let mut names: Vec<_> = missing.iter().map(|(file, _)| *file).collect();
            names.sort_unstable();
            names.dedup();
            let message =
                format!("no picture {}: choose the files, or drop them on the page", names.join(", "));
            return Err(Failure { line: Some(*line).filter(|line| *line > 0), ..Failure::plain(message) });
        }
        let had = scene.take_pictures(|file| self.find(file).cloned().ok_or_else(|| "it is missing".into()));
        had.map_err(Failure::plain)
    }

    /// Returns the picture that a scene names. A page knows its files without their folders.
    fn find(&self, file: &str) -> Option<&Arc<Pixels>> {
        self.0.get(file.rsplit(['/', '\\']).next().unwrap_or(file))
    }
}

#[cfg(test)]
mod tests {
    use rta_scenes::shipped;

    use super::Pictures;

    const SCENE: &str = "rta 1\ncamera at 0 -8 2  look 0 1 0\nsky map \"sky/evening.png\"\n\
        texture globe image \"globe.png\"\ntexture map image \"globe.png\"\n";

    fn file(name: &str, contents: &[u8]) -> Vec<u8> {
        [name.as_bytes(), b"\n", contents].concat()
    }

    #[test]
    fn scenes_get_the_pictures_that_they_name() {
        let scene = || rta_scenes::read(SCENE.as_bytes(), "scene").expect("a scene");
        let mut pictures = Pictures::new();
        let failure = pictures.give(&mut scene()).expect_err("none is there");
        assert_eq!(failure.line, Some(4));
        assert!(failure.message.starts_with("no picture globe.png, sky/evening.png: "), "{failure}");
        let [(evening, contents), (globe, other)] = shipped::PICTURES;
        let ppm = pictures.take(&file(globe, other)).expect("a picture");
        assert!(pictures.give(&mut scene()).is_err_and(|failure| failure.line.is_none()));
        pictures.take(&file(evening, contents)).expect("a picture");
        let mut one = scene();
        pictures.give(&mut one).expect("all are there");
        assert_eq!(one.details.pictures.len(), 2);
        // The same from what another instance is given.
        assert_eq!(pictures.take(&file(globe, &ppm)).as_ref(), Ok(&ppm));
        let mut other = scene();
        pictures.give(&mut other).expect("all are there");
        assert_eq!(one, other);
    }

    #[test]
    fn what_is_no_picture_is_named() {
        let mut pictures = Pictures::new();
        for (given, message) in [
            (&b"no name"[..], "a picture begins with a line that is its name"),
            (b"a.png\nnone", "the picture a.png: "),
            (b"a\nnone", "the picture a: "),
            (b"a.png\nP6 9999 1 255\n", "the picture a.png: 9999 x 1 pixels, more than 8192 on a side"),
        ] {
            let failure = pictures.take(given).expect_err("no picture");
            assert!(failure.message.starts_with(message), "{failure}");
        }
    }
}
