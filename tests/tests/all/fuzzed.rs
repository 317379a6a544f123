//! The corpora of the readers' fuzz targets: files that reach different places of the readers, and those that were a bug once.

use std::fs;

use rta_tests::{fuzzed, fuzzed_picture};

/// The corpora, which the fuzz targets begin with.
const TEXTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/fuzz/seeds");
const PICTURES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/fuzz/pictures");

/// Returns how many files of a folder are read, and how many refused.
fn counts(folder: &str, is_read: impl Fn(&[u8]) -> bool) -> (u32, u32) {
    let (mut read, mut refused) = (0, 0);
    for entry in fs::read_dir(folder).expect("a corpus") {
        let path = entry.expect("a file").path();
        // Told by name only where it fails.
        println!("{}", path.display());
        *(if is_read(&fs::read(&path).expect("a file")) { &mut read } else { &mut refused }) += 1;
    }
    (read, refused)
}

#[test]
fn texts_of_the_corpus_are_answered_and_what_is_read_is_written() {
    let (read, refused) = counts(TEXTS, fuzzed::check);
    assert!(read >= 10 && refused >= 10, "{read} are read, {refused} refused");
}

#[test]
fn pictures_of_the_corpus_are_answered() {
    let (read, refused) = counts(PICTURES, |bytes| match fuzzed_picture::check(bytes) {
        Ok(()) => true,
        Err(reason) => {
            println!("  {reason}");
            false
        }
    });
    assert!(read >= 40 && refused >= 25, "{read} are read, {refused} refused");
}
