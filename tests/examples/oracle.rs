//! Draws the shipped scenes and the random ones with the oracle, as PPM files in the folder named, 320 x 200 for a
//! 4:3 screen at depth 5:
//!
//! ```text
//! cargo run --release -p rta-tests --example oracle -- FOLDER
//! ```

use rta_scenes::{dat, shipped};
use rta_tests::{oracle, random_scenes};

const SIZE: (usize, usize) = (320, 200);

fn main() -> Result<(), Box<dyn core::error::Error>> {
    let folder = std::env::args_os().nth(1).ok_or("name the folder for the pictures")?;
    let mut scenes = random_scenes::all();
    for (name, text) in shipped::ALL {
        scenes.push((name.trim_end_matches(".dat"), dat::read(text.as_bytes(), name)?));
    }
    for (name, scene) in scenes {
        let picture = oracle::render(&scene, SIZE.0, SIZE.1, 4.0 / 3.0, 5);
        let mut file = format!("P6 {} {} 255\n", SIZE.0, SIZE.1).into_bytes();
        // Clamped and rounded, so the cast cuts nothing off.
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        file.extend(picture.iter().flatten().map(|part| (part.clamp(0.0, 1.0) * 255.0).round() as u8));
        std::fs::write(std::path::Path::new(&folder).join(name).with_extension("ppm"), file)?;
    }
    Ok(())
}
