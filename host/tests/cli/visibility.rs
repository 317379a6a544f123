//! `rta visibility` from outside.

use super::folder::{Folder, decoder};

/// The cells of the rows of all tables, one table after the other.
fn rows(text: &str) -> Vec<Vec<&str>> {
    let rows = text.lines().filter(|line| line.starts_with('|') && !line.contains("-: |"));
    rows.map(|line| line.trim_matches('|').split('|').map(str::trim).collect()).collect()
}

#[test]
fn all_algorithms_see_the_same() {
    let folder = Folder::new();
    let args = ["visibility", "scene.dat", "--size", "32x24", "--tessellate", "4", "-o", "ids.png"];
    let text = folder.prints(&args);
    let rows = rows(&text);
    let names =
        ["ray casting", "ray casting by boxes", "z-buffer", "z-buffer by rows", "painter", "scan-line"];
    let names = [&names[..], &["area subdivision", "scan-plane", "rta's tracer, f64"]].concat();
    assert_eq!(rows[0], ["algorithm", "ids", "pixels apart", "steps", "bytes", "ms"]);
    assert_eq!(rows[1..].iter().map(|row| row[0]).collect::<Vec<_>>(), names);
    assert!(rows[1..].iter().all(|row| row[1] == "equal"), "{text}");
    assert!(text.ends_with("all ids are equal\n"), "{text}");
    let mut picture = decoder(&folder.path("ids.png"));
    assert_eq!((picture.info().width, picture.info().height), (32, 24));
    let mut bytes = vec![0; 32 * 24 * 3];
    picture.next_frame(&mut bytes).unwrap();
    let colors: std::collections::BTreeSet<_> = bytes.chunks(3).collect();
    assert!(colors.len() > 8, "{}", colors.len());
}

#[test]
fn costs_stand_beside_those_of_1974() {
    let folder = Folder::new();
    let args = ["visibility", "scene.dat", "--size", "16x12", "--tessellate", "2", "--faces", "40,400"];
    let text = folder.prints(&args);
    let rows = rows(&text);
    let tables: Vec<_> = rows.iter().filter(|row| row[0].contains("1974")).collect();
    assert_eq!(tables[0][1..], ["1", "10", "507"]);
    let [few, many] = [1, 2].map(|column| rows[10][column].parse::<usize>().unwrap());
    assert!((20..80).contains(&few) && (200..800).contains(&many), "{text}");
    let costs: Vec<_> =
        rows[13..21].iter().map(|row| [row[1].parse::<f64>().unwrap(), row[2].parse().unwrap()]).collect();
    assert!(costs.iter().all(|[few, many]| few < many), "{text}");
    let least = costs.iter().map(|cost| cost[0]).fold(f64::INFINITY, f64::min);
    assert!((least - 1.0).abs() < 1e-9, "{text}");
}
