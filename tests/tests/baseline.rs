//! No picture changes unnoticed.
//!
//! `RTA_BLESS=1 cargo test -p rta-tests --test baseline` records in `tests/baseline.csv` what is drawn now.

use rta_tests::baseline;

#[test]
fn no_picture_has_changed() {
    if std::env::var_os("RTA_BLESS").is_some_and(|value| !value.is_empty() && value != "0") {
        baseline::record();
        return;
    }
    let wrong = baseline::differences();
    assert!(wrong.is_empty(), "{} pictures differ:\n{}", wrong.len(), wrong.join("\n"));
}
