//! The corpus of the readers' fuzz target: texts that reach different places of the readers, and those that were a bug once.

use std::fs;

use rta_tests::fuzzed::check;

/// The corpus, which the fuzz target begins with.
const CORPUS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/fuzz/seeds");

#[test]
fn texts_of_the_corpus_are_answered_and_what_is_read_is_written() {
    let (mut read, mut refused) = (0, 0);
    for entry in fs::read_dir(CORPUS).expect("a corpus") {
        let path = entry.expect("a file").path();
        let text = fs::read(&path).expect("a file");
        // Told by name only where it fails.
        println!("{}", path.display());
        *(if check(&text) { &mut read } else { &mut refused }) += 1;
    }
    assert!(read >= 10 && refused >= 10, "{read} are read, {refused} refused");
}
