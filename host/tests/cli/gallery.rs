//! `rta gallery` from outside: what is refused. What it draws is compared in the package of tests.

use std::fs;

use super::folder::Folder;

#[test]
fn a_picture_that_cannot_be_written_is_named_and_there_is_no_page() {
    let folder = Folder::new();
    folder.refuses(&["gallery"], &["--output"]);
    folder.refuses(&["gallery", "-o", "a", "--check", "."], &["--check"]);
    folder.refuses(&["gallery", "--check", ".", "--no-report"], &["--no-report"]);
    fs::write(folder.path("taken"), "").unwrap();
    folder.refuses(&["gallery", "-o", "taken"], &["cannot write taken"]);
    fs::create_dir_all(folder.path("page/index.html")).unwrap();
    folder.refuses(&["gallery", "-o", "page"], &["cannot write page/index.html"]);
    assert!(!folder.path("page/scenes").exists(), "nothing is drawn for a page that cannot be written");
    fs::create_dir_all(folder.path("half/scenes/hall-22-pixrect.png")).unwrap();
    let words = ["rta render scenes/hall-22.dat ", "cannot write half/scenes/hall-22-pixrect.png"];
    folder.refuses(&["gallery", "-o", "half"], &words);
    let names = fs::read_dir(folder.path("half")).unwrap().count();
    assert_eq!(names, 1, "there is no page of pictures that are not there");
    assert!(
        folder.path("half/scenes/juggler-vga.png").exists()
            && !folder.path("half/scenes/juggler.gif").exists()
    );
}
