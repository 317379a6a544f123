//! The scene reader never panics, and what it reads it can write and read again.
#![no_main]

use libfuzzer_sys::fuzz_target;
use rta_scenes::dat;

fuzz_target!(|text: &[u8]| {
    match dat::read(text, "fuzz.dat") {
        Ok(scene) => {
            let again = scene.to_dat().expect("what is read has a floor");
            let read = dat::read(again.as_bytes(), "again.dat").expect("what is written can be read");
            assert_eq!(read.without_lines(), scene.without_lines(), "{again}");
        }
        // A message is one line and says where.
        Err(error) => assert!(error.to_string().starts_with("fuzz.dat")),
    }
});
