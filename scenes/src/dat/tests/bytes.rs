//! Any bytes are answered.

use super::{SCENE, read};

#[test]
fn any_bytes_are_answered() {
    // Every beginning of the scene with every byte put behind it, or in place of what follows: no panic, and an
    // error that points into the text.
    for cut in 0..SCENE.len() {
        for byte in 0..=255 {
            let mut text = SCENE.as_bytes().split_at(cut).0.to_vec();
            text.push(byte);
            if byte % 2 == 0 {
                text.extend_from_slice(SCENE.as_bytes().split_at(cut).1);
            }
            if let Err(error) = read(&text, "s.dat") {
                assert!((1..=20).contains(&error.line) && (1..=60).contains(&error.column), "{error}");
            }
        }
    }
}
