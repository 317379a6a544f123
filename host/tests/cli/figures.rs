//! `rta figures` from outside.

use std::fs;

use rta::study::figures::{Content, keywords, list};
use rta_scenes::shipped;

use super::folder::{Folder, decoder};

#[test]
fn two_runs_leave_one_page_with_every_figure() {
    let folder = Folder::new();
    assert_eq!(folder.prints(&["figures", "-o", "a"]), "");
    assert_eq!(folder.prints(&["figures", "-o", "b/c"]), "");
    let page = fs::read_to_string(folder.path("a/index.html")).unwrap();
    let mut names = vec!["index.html".to_owned()];
    for figure in list::ALL {
        let part = page.split(&format!("<figure id=\"{}\">", figure.name)).nth(1).unwrap();
        let part = part.split("</figure>").next().unwrap();
        for words in [figure.caption, figure.formula, figure.source] {
            assert!(!words.is_empty() && part.contains(words), "{}: {words}", figure.name);
        }
        names.push(format!("{}.png", figure.name));
        if matches!(figure.content, Content::Curves(_)) {
            names.push(format!("{}.svg", figure.name));
            assert!(part.contains(&format!("<img src=\"{}.svg\"", figure.name)), "{part}");
        }
        let mut reader = decoder(&folder.path(&format!("a/{}.png", figure.name)));
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        assert!(pixels.windows(2).any(|pair| pair[0] != pair[1]), "{} is empty", figure.name);
    }
    for example in keywords::examples(shipped::PAGE) {
        assert!(page.contains(&format!("keywords/{}.png", example.name)), "{}", example.name);
        names.push(format!("keywords/{}.png", example.name));
    }
    names.extend(shipped::PICTURES.map(|(name, _)| format!("keywords/{name}")));
    let entries = |path: &str| {
        let entries = fs::read_dir(folder.path(path)).unwrap();
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect::<Vec<_>>()
    };
    let mut there = entries("a");
    there.retain(|name| name != "keywords");
    there.extend(entries("a/keywords").iter().map(|name| format!("keywords/{name}")));
    names.sort();
    there.sort();
    assert_eq!(there, names);
    for name in names {
        let read = |run: &str| fs::read(folder.path(&format!("{run}/{name}"))).unwrap();
        assert!(read("a") == read("b/c"), "{name}");
    }
}

#[test]
fn a_folder_that_cannot_be_written_is_named() {
    let folder = Folder::new();
    folder.refuses(&["figures"], &["--output"]);
    fs::write(folder.path("taken"), "").unwrap();
    folder.refuses(&["figures", "-o", "taken"], &["cannot write taken"]);
    fs::create_dir_all(folder.path("half/models.png")).unwrap();
    folder.refuses(&["figures", "-o", "half"], &["cannot write half/models.png"]);
}
