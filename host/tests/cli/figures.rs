//! `rta figures` from outside.

use std::fs;

use rta::study::figures::thesis::{self, room, technique, techniques};
use rta::study::figures::{Content, keywords, list};
use rta_scenes::shipped;

use super::folder::{Folder, decoder};

#[test]
fn two_runs_leave_one_page_with_every_figure() {
    let folder = Folder::new();
    assert_eq!(folder.prints(&["figures", "--coarse", "8", "-o", "a"]), "");
    assert_eq!(folder.prints(&["figures", "--coarse", "8", "-o", "b/c"]), "");
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
    names.extend(of_the_thesis());
    let entries = |path: &str| {
        let entries = fs::read_dir(folder.path(path)).unwrap();
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect::<Vec<_>>()
    };
    let mut there = entries("a");
    there.retain(|name| name != "keywords" && name != "thesis");
    for below in ["keywords", "thesis"] {
        there.extend(entries(&format!("a/{below}")).iter().map(|name| format!("{below}/{name}")));
    }
    names.sort();
    there.sort();
    assert_eq!(there, names);
    for name in names {
        let read = |run: &str| untimed(fs::read(folder.path(&format!("{run}/{name}"))).unwrap());
        assert!(read("a") == read("b/c"), "{name}");
    }
    second_page(&folder);
}

/// Returns the files of the second page.
fn of_the_thesis() -> Vec<String> {
    let pictures = thesis::names().map(|name| format!("thesis/{name}.png"));
    let scenes = room::ALL.iter().map(|variant| format!("thesis/{}.rta", variant.name));
    let solved = techniques::ALL
        .iter()
        .filter(|technique| matches!(technique.way, technique::Way::Traced { solved: Some(_), .. }))
        .map(|technique| format!("thesis/{}.txt", technique.name));
    pictures.chain(scenes).chain(solved).chain(["thesis.html".to_owned()]).collect()
}

/// Returns a file without the seconds that were measured.
fn untimed(file: Vec<u8>) -> Vec<u8> {
    let Ok(text) = String::from_utf8(file.clone()) else { return file };
    let mut parts = text.split("<span class=\"seconds\">");
    let first = parts.next().unwrap_or_default().to_owned();
    parts
        .fold(first, |text, part| text + part.split_once("</span>").map_or(part, |(_, rest)| rest))
        .into_bytes()
}

/// Every technique is on the second page, with a picture that no other has or with why there is none.
fn second_page(folder: &Folder) {
    let page = fs::read_to_string(folder.path("a/thesis.html")).unwrap();
    let drawn = techniques::ALL.iter().filter(|technique| technique.is_drawn()).count();
    // In the table and at the picture, and three compositions in two formats.
    assert_eq!(page.matches("<span class=\"seconds\">").count(), 2 * drawn + 3 * 2);
    let mut pictures = Vec::new();
    for technique in techniques::ALL {
        let part = page.split(&format!(" id=\"{}\">", technique.name)).nth(1).expect(technique.name);
        let part = part.split("<h3>").nth(1).unwrap();
        assert!(part.starts_with(&format!("{}: ", technique.year)), "{part}");
        if technique.is_drawn() {
            let name = format!("thesis/{}.png", technique.name);
            assert!(part.contains(&format!("<img src=\"{name}\"")), "{part}");
            pictures.push((name.clone(), fs::read(folder.path(&format!("a/{name}"))).unwrap()));
        } else {
            assert!(!part.contains("<img") && part.contains("<p><b>"), "{part}");
        }
    }
    errors_fall(&page);
    for (place, (name, picture)) in pictures.iter().enumerate() {
        let twin = pictures[..place].iter().find(|(_, other)| other == picture);
        assert!(twin.is_none(), "{name} is {twin:?}");
    }
}

/// Techniques that find more of the light are nearer to paths: those with an ambient term or without mirrors, then two passes, then few paths.
fn errors_fall(page: &str) {
    let error = |name: &str| -> f64 {
        let row = page.split(&format!("<a href=\"#{name}\">")).nth(1).unwrap();
        row.split("<td>").nth(2).unwrap().split('<').next().unwrap().parse().unwrap()
    };
    let (two, few) = (error("wallace-cohen-greenberg"), error("kajiya"));
    assert!(few < two, "{few}, {two}");
    for name in ["romney", "phong", "whitted", "kay-greenberg", "goral", "cohen-greenberg", "cohen-chen"] {
        assert!(two < error(name), "{name}: {two}, {}", error(name));
    }
    assert!(error("kay-greenberg") < error("whitted"), "glass that takes light away");
    assert!(error("whitted") < error("romney"), "lamps where they are");
}

#[test]
fn years_ascend_from_1969_to_1988() {
    let years: Vec<_> = techniques::ALL.iter().map(|technique| technique.year).collect();
    assert!(years.is_sorted(), "{years:?}");
    assert_eq!((years.first(), years.last()), (Some(&1969), Some(&1988)));
}

#[test]
fn variants_of_the_room_change_what_they_are_to_change() {
    let texts: Vec<_> = room::ALL.iter().map(room::Variant::text).collect();
    for (variant, text) in room::ALL.iter().zip(&texts) {
        for [from, to] in variant.lines {
            assert!(!text.contains(from) && text.contains(to), "{}: {to}", variant.name);
        }
        let scene = variant.scene(rta_scenes::Reading::default()).expect("a scene");
        assert!(scene.description.warnings.is_empty(), "{:?}", scene.description.warnings);
    }
    assert!((1..texts.len()).all(|place| !texts[..place].contains(&texts[place])));
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
