//! Asks of a build without the checks of a debug build what the tests `deterministic` and `baseline` ask of one with them:
//!
//! ```text
//! cargo run --release -p rta-tests --bin same-bytes
//! ```
//!
//! No test, as tests unwind at a panic, where release builds abort: everything below would be compiled once more for them.

use std::process::ExitCode;

use rta_tests::{baseline, deterministic};

fn main() -> ExitCode {
    deterministic::every_build_draws_the_same_bytes();
    deterministic::every_build_draws_the_same_bytes_of_nff();
    deterministic::any_number_of_threads_draws_the_same_bytes();
    deterministic::any_order_of_rows_draws_the_same_bytes();
    let wrong = baseline::differences();
    for difference in &wrong {
        println!("{difference}");
    }
    println!("{} pictures of the baseline differ", wrong.len());
    if wrong.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
