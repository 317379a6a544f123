//! The scene readers never panic, and what they read can be written and read again.
#![no_main]

use libfuzzer_sys::fuzz_target;

#[path = "../../src/fuzzed.rs"]
mod fuzzed;

fuzz_target!(|text: &[u8]| {
    fuzzed::check(text);
});
