//! Fixed point draws the same bytes. `cargo run --release -p rta-tests --bin same-bytes` asks it of a release build.

use rta_tests::deterministic;

#[test]
fn every_build_draws_the_same_bytes() {
    deterministic::every_build_draws_the_same_bytes();
}

#[test]
fn every_build_draws_the_same_bytes_of_nff() {
    deterministic::every_build_draws_the_same_bytes_of_nff();
}

#[test]
fn any_number_of_threads_draws_the_same_bytes() {
    deterministic::any_number_of_threads_draws_the_same_bytes();
}

#[test]
fn any_order_of_rows_draws_the_same_bytes() {
    deterministic::any_order_of_rows_draws_the_same_bytes();
}
