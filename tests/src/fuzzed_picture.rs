//! What holds of every picture file that a scene may name, whoever wrote it: for the fuzz target and for the test of its seeds.

use std::io::Cursor;
use std::path::Path;

use rta_scenes::description::Pixels;
use rta_scenes::pictures::decode;

/// Sides of the largest picture that is decoded here, in pixels: few, so that a picture takes little time.
pub const LARGEST: u32 = 128;

/// Reads bytes as a picture, checks that it is as it is said to be, and returns whether it was read, or why not.
///
/// # Errors
/// The reason that the reader tells.
///
/// # Panics
/// The reader panics, a picture is larger than asked for or has not all of its pixels, or a reason is none.
pub fn check(bytes: &[u8]) -> Result<(), String> {
    // What does not say what it is is read as a TGA file, which never does.
    let picture = decode(Cursor::new(bytes), Path::new("fuzz.tga"), LARGEST).inspect_err(|reason| {
        assert!(!reason.trim().is_empty() && !reason.contains('\n'), "{reason}");
    })?;
    for most in [LARGEST, 5] {
        let Pixels { width, height, words } = picture.clone().reduced(most);
        assert!((1..=most).contains(&width) && (1..=most).contains(&height), "{width} x {height}");
        assert_eq!(words.len(), (width * height) as usize, "{width} x {height}");
        assert!(words.iter().all(|word| word >> 24 == 0), "a pixel is more than its colour");
    }
    Ok(())
}
