//! What does not fit a format is named.

#![allow(clippy::indexing_slicing)] // a test may panic

use rta_core::Q16;

use super::*;
use crate::{dat, shipped};

fn refused(edit: impl Fn(&mut Description)) -> String {
    let mut scene = dat::read(shipped::GLASS_2.as_bytes(), "glass-2.dat").expect("a shipped scene");
    edit(&mut scene);
    match narrow::<Q16>(&scene, 1.0) {
        Ok(_) => "admitted".into(),
        Err(error) => error.to_string(),
    }
}

#[test]
fn errors_name_object_number_and_limit() {
    assert_eq!(refused(|_| ()), "admitted");
    assert_eq!(
        refused(|s| s.spheres[1].position[0] = -40000.0),
        "sphere 2 (line 9) is out of q16's range: x (with the radius) 40000.9, beyond the largest 32767.9"
    );
    assert_eq!(
        refused(|s| s.spheres[0].radius = 1e-5),
        "sphere 1 (line 8) is out of q16's range: the radius 1e-5, below the smallest 0.000244141"
    );
    assert!(
        refused(|s| s.lamps[1].color[2] = 1e12)
            .starts_with("lamp 2 (line 12) is out of q16's range: the intensity")
    );
    assert!(refused(|s| s.camera.eye[2] = 1e300).starts_with("the observer is out of q16's range: z"));
    assert!(refused(|s| s.sky.zenith[2] = 1e6).starts_with("the zenith is out of q16's range"));
    assert!(refused(|s| s.spheres[0].color[1] = 2.0).contains("beyond the largest 1.99"));
}
