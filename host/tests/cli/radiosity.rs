//! `rta radiosity`, and pictures with its light.

use super::folder::Folder;

const ROOM: &str = include_str!("../../../scenes/room-g.rta");
const CORNELL: &str = include_str!("../../../scenes/cornell.rta");
const FURNACE: &str = include_str!("../../../scenes/furnace.rta");

/// Returns the radiosity of a patch.
fn patch(folder: &Folder, args: &[&str]) -> [f64; 3] {
    let told = folder.prints(&[&["radiosity"], args].concat());
    let numbers: Vec<f64> = told.split_whitespace().map(|word| word.parse().expect("a number")).collect();
    numbers.try_into().expect("three numbers")
}

/// Returns the means of a quad in a table.
fn mean(table: &str, quad: &str) -> [f64; 3] {
    let line = table.lines().find(|line| line.split_whitespace().next() == Some(quad)).expect("a quad");
    let numbers: Vec<f64> =
        line.split_whitespace().skip(4).map(|word| word.parse().expect("a number")).collect();
    numbers.try_into().expect("three numbers")
}

fn assert_close(got: [f64; 3], want: [f64; 3], part: f64) {
    for (got, want) in got.into_iter().zip(want) {
        assert!((got - want).abs() <= part * want, "{got} is not {want} within {part}");
    }
}

#[test]
fn the_walls_of_room_g_have_their_radiosity() {
    let folder = Folder::new();
    folder.scene("g.rta", ROOM);
    let of = |patches: &str, name: &str| patch(&folder, &["g.rta", "--patches", patches, "--patch", name]);
    assert_close(of("3", "0,4"), [0.039_004_646, 0.039_004_646, 0.033_164_680], 2e-8);
    assert_close(of("3", "0,0"), [0.033_128_509, 0.029_036_387, 0.025_416_548], 2e-8);
    assert_close(of("6", "0,0"), [0.029_751_323, 0.025_128_289, 0.022_030_406], 2e-8);
    assert_close(of("1", "2,0"), [0.246_054_836, 0.045_026_192, 0.036_634_001], 2e-8);
    for format in ["f32", "q16", "q20"] {
        let got = patch(&folder, &["g.rta", "--patches", "3", "--patch", "0,4", "--format", format]);
        assert_close(got, [0.039_004_646, 0.039_004_646, 0.033_164_680], 2e-3);
    }
    for (method, part) in [("gauss", 2e-8), ("shoot", 0.05), ("gather", 2e-8)] {
        let got = patch(&folder, &["g.rta", "--patches", "3", "--patch", "0,4", "--method", method]);
        assert_close(got, [0.039_004_646, 0.039_004_646, 0.033_164_680], part);
    }
    for factors in ["rays:256", "hemicube:50"] {
        let got = patch(&folder, &["g.rta", "--patches", "3", "--patch", "0,4", "--factors", factors]);
        assert_close(got, [0.039_004_646, 0.039_004_646, 0.033_164_680], 0.06);
    }
}

#[test]
fn the_cornell_box_is_as_the_mesh_and_the_paths_have_it() {
    let folder = Folder::new();
    folder.scene("c.rta", CORNELL);
    let table = folder.prints(&["radiosity", "c.rta"]);
    for (quad, mesh, paths) in [
        ("0", [0.3477, 0.2312, 0.0628], [0.3529, 0.2347, 0.0636]),
        ("2", [0.3019, 0.1800, 0.0423], [0.3053, 0.1820, 0.0427]),
        ("3", [0.5266, 0.3453, 0.0933], [0.5307, 0.3479, 0.0938]),
        ("4", [0.1096, 0.2376, 0.01434], [0.1100, 0.2385, 0.01434]),
        ("5", [0.4383, 0.0293, 0.0067], [0.4451, 0.0297, 0.0068]),
        ("6", [0.9932, 0.6953, 0.2044], [0.9951, 0.6965, 0.2044]),
        ("11", [2.2726, 1.5034, 0.4681], [2.2873, 1.5113, 0.4701]),
    ] {
        assert_close(mean(&table, quad), mesh, 0.02);
        assert_close(mean(&table, quad), paths, 0.03);
    }
    assert!(table.contains("sweeps") && !table.contains("NOT DONE"), "{table}");
}

#[test]
fn a_furnace_is_alike_everywhere() {
    let folder = Folder::new();
    folder.scene("f.rta", FURNACE);
    let table = folder.prints(&["radiosity", "f.rta"]);
    for quad in ["0", "1", "5"] {
        assert_close(mean(&table, quad), [2.0; 3], 1e-9);
    }
}

#[test]
fn a_solution_is_kept_and_shown_and_is_that_of_its_scene() {
    let folder = Folder::new();
    folder.scene("g.rta", ROOM);
    folder.prints(&["radiosity", "g.rta", "--patches", "3", "-o", "g.txt"]);
    let render = |args: &[&str]| picture(&folder, "g.rta", 24, args);
    let mean = |light: &[[f64; 3]]| mean_of(light.iter().copied()).iter().sum::<f64>();
    let (both, all) = (
        render(&["--light", "g.txt", "--samples", "64"]),
        render(&["--light", "g.txt", "--light-as", "all"]),
    );
    let direct = render(&["--samples", "64"]);
    // Both ways have the same light, but for what a patch is too large to show.
    assert!((mean(&both) / mean(&all) - 1.0).abs() < 0.03, "{} {}", mean(&both), mean(&all));
    assert!(mean(&both) > 1.3 * mean(&direct), "{} {}", mean(&both), mean(&direct));
    // A board's way.
    let solved = render(&["--light", "solve", "--samples", "64", "--format", "q16"]);
    assert!((mean(&both) / mean(&solved) - 1.0).abs() < 0.05, "{} {}", mean(&both), mean(&solved));
    // Seen from elsewhere it is the same solution; of another room it is none.
    folder.scene("h.rta", ROOM.replace("at .5 .02 .5", "at .4 .1 .5"));
    assert!(
        folder.rta(&["render", "h.rta", "-o", "h.png", "--light", "g.txt", "--size", "8x8"]).status.success()
    );
    folder.scene("i.rta", ROOM.replace(".6 .1 .1", ".6 .1 .2"));
    folder.refuses(&["render", "i.rta", "-o", "i.png", "--light", "g.txt"], &["g.txt", "another scene"]);
    folder.refuses(&["render", "g.rta", "-o", "i.png", "--light", "i.rta"], &["i.rta", "line 1"]);
    folder.refuses(&["render", "g.rta", "-o", "i.png", "--light", "nothing.txt"], &["nothing.txt"]);
    folder.refuses(&["render", "g.rta", "-o", "i.png", "--light", "solve", "--light-as", "all"], &["solve"]);
    for way in [["--aa", "whitted"], ["--sampler", "grid"]] {
        let args = [&["render", "g.rta", "-o", "i.png", "--light", "g.txt"], &way[..]].concat();
        folder.refuses(&args, &["--light", "spread"]);
    }
    let source = folder.prints(&["bake", "g.rta", "-o", "-", "--light", "g.txt"]);
    assert!(
        source.contains("const PATCHES: usize = 54") && source.contains("RADIOSITY: bool = true"),
        "{source}"
    );
}

#[test]
fn light_is_gathered_for_a_picture_whatever_the_threads() {
    let folder = Folder::new();
    folder.scene("c.rta", CORNELL);
    folder.prints(&["radiosity", "c.rta", "--factors", "rays:16", "-o", "c.txt"]);
    let drawn = |args: &[&str]| picture(&folder, "c.rta", 32, &[&["--light", "c.txt"], args].concat());
    let one = drawn(&["--light-as", "cache:64:.3", "--samples", "4", "--threads", "1"]);
    assert!(one == drawn(&["--light-as", "cache:64:0.3", "--samples", "4", "--threads", "2"]));
    // It has the light of the patches, and of a board's solution.
    let mean = |light: &[[f64; 3]]| mean_of(light.iter().copied()).iter().sum::<f64>();
    let solved = drawn(&["--light-as", "indirect", "--samples", "4"]);
    assert!((mean(&one) / mean(&solved) - 1.0).abs() < 0.03, "{} {}", mean(&one), mean(&solved));
    let way = ["--light", "solve", "--light-as", "cache", "--samples", "4", "--format", "q16"];
    let fixed = picture(&folder, "c.rta", 32, &way);
    assert!((mean(&one) / mean(&fixed) - 1.0).abs() < 0.03, "{} {}", mean(&one), mean(&fixed));
    // Parts of the picture have the light of the whole.
    let asked =
        ["c.rta", "--light", "c.txt", "--light-as", "cache:64:.3", "--samples", "4", "--size", "32x32"];
    let render = |more: &[&str]| folder.renders(&[&asked[..], &["--device", "none"], more].concat());
    render(&["--as", "pfm", "-o", "a.part", "--rows", "0..9"]);
    render(&["--as", "pfm", "-o", "b.part", "--rows", "9..32"]);
    render(&["-o", "whole.pfm"]);
    assert!(folder.rta(&["merge", "-q", "-o", "merged.pfm", "a.part", "b.part"]).status.success());
    let [merged, whole] = ["merged.pfm", "whole.pfm"].map(|name| std::fs::read(folder.path(name)));
    assert!(merged.expect("a picture") == whole.expect("a picture"));
    let bake = ["bake", "c.rta", "-o", "-", "--light", "c.txt", "--light-as", "cache"];
    folder.refuses(&bake, &["--light-as cache", "baked"]);
    folder.scene("m.rta", format!("{CORNELL}sphere at 2 2 4  radius .1  moves .1 0 0\n"));
    let moving = ["render", "m.rta", "-o", "m.png", "--light", "solve", "--light-as", "cache"];
    folder.refuses(&moving, &["--light-as cache", "nothing moves"]);
}

/// Returns the light of a picture of `side` x `side` pixels, row by row from the bottom.
fn picture(folder: &Folder, scene: &str, side: usize, args: &[&str]) -> Vec<[f64; 3]> {
    let size = format!("{side}x{side}");
    let args = [&["render", scene, "-o", "p.pfm", "--device", "none", "--size", &size], args].concat();
    let ended = folder.rta(&args);
    assert!(ended.status.success(), "{}", String::from_utf8_lossy(&ended.stderr));
    let bytes = std::fs::read(folder.path("p.pfm")).expect("a picture");
    let floats = bytes[format!("PF\n{side} {side}\n-1.0\n").len()..].chunks_exact(4);
    let floats: Vec<_> =
        floats.map(|float| f32::from_le_bytes(float.try_into().expect("four bytes")).into()).collect();
    floats.chunks_exact(3).map(|rgb| [rgb[0], rgb[1], rgb[2]]).collect()
}

/// Returns the mean of some light.
fn mean_of(light: impl Iterator<Item = [f64; 3]> + Clone) -> [f64; 3] {
    let count = light.clone().count() as f64;
    light.fold([0.0; 3], |sum, own| [0, 1, 2].map(|i| sum[i] + own[i] / count))
}

/// Room G with so much light that what a patch sends back is well above a level of a display.
fn bright_room() -> String {
    ROOM.replace(".3183098861837907", "6.366197723675814")
}

#[test]
fn two_passes_have_the_light_of_each_patch_once() {
    const PATCHES: usize = 6;
    const PIXELS: usize = 8;
    let folder = Folder::new();
    // The floor fills the picture: its patches are squares of pixels.
    let scene =
        bright_room().replace("at .5 .02 .5  look 0 1 0  lens .6", "at .5 .5 .9999  look 0 0 -1  lens 1");
    folder.scene("g.rta", &scene);
    let solve = ["g.rta", "--factors", "exact", "--patches", "6"];
    folder.prints(&[&["radiosity"], &solve[..], &["-o", "g.txt"]].concat());
    let light = picture(&folder, "g.rta", PATCHES * PIXELS, &["--light", "g.txt", "--samples", "64"]);
    for number in [0, 2, 7, 14, 21, 35] {
        let (column, row) = (number % PATCHES, number / PATCHES);
        let rows = light.chunks_exact(PATCHES * PIXELS).skip(row * PIXELS).take(PIXELS);
        let shown = mean_of(rows.flat_map(|row| row.iter().skip(column * PIXELS).take(PIXELS)).copied());
        let solved = patch(&folder, &[&solve[..], &["--patch", &format!("0,{number}")]].concat());
        // Direct light, and what else arrives, times the reflectance: B / pi, within a level of a display.
        for (shown, solved) in shown.into_iter().zip(solved) {
            let solved = solved / core::f64::consts::PI;
            assert!((shown - solved).abs() < 1.0 / 255.0, "patch {number}: {shown}, not {solved}");
            assert!(solved > 0.05);
        }
    }
}

#[test]
fn the_image_of_a_patch_in_a_mirror_is_the_patch() {
    let folder = Folder::new();
    let wall = "color .6 .1 .1";
    let scene =
        bright_room().replace("model lambert", "model whitted").replace(wall, "color 1 1 1  of mirror");
    let seen = |camera: &str| {
        let own = scene.replace("at .5 .02 .5  look 0 1 0  lens .6", camera);
        folder.scene("m.rta", &own);
        if !folder.path("m.txt").exists() {
            folder.prints(&["radiosity", "m.rta", "-o", "m.txt"]);
        }
        let light = picture(&folder, "m.rta", 4, &["--light", "m.txt", "--samples", "256"]);
        mean_of(light.into_iter())
    };
    // The floor and the front wall by the wall x = 0, and as they are seen from there.
    for (by_mirror, from_there) in [
        ("at .5 .5 .5  look -1 0 -.8  lens 60", "at .0005 .5 .0996  look 1 0 -.8  lens 60"),
        ("at .5 .5 .5  look -1 .3 -.4  lens 60", "at .0005 .6502 .2998  look 1 .3 -.4  lens 60"),
    ] {
        assert_close(seen(by_mirror), seen(from_there), 0.003);
    }
}

#[test]
fn what_cannot_be_solved_is_refused() {
    let folder = Folder::new();
    folder.scene("g.rta", ROOM);
    folder.scene("b.rta", "rta 1\ncamera at 0 -8 2  look 0 1 0\nsphere at 0 0 1  radius 1\nlamp at 1 1 9");
    folder.refuses(&["radiosity", "b.rta"], &["b.rta", "nothing in it takes part"]);
    folder.scene(
        "d.rta",
        "rta 1\ncamera at 0 -8 2  look 0 1 0\nlamp at 1 1 9\nquad 0 0 0  1 0 0  1 1 0  0 1 0",
    );
    folder.refuses(&["radiosity", "d.rta"], &["d.rta", "nothing in it emits"]);
    folder.refuses(&["radiosity", "g.rta", "--patches", "2"], &["quad 1", "more patches"]);
    folder.refuses(&["radiosity", "g.rta", "--patch", "6,0"], &["no quad 6"]);
    folder.refuses(&["radiosity", "g.rta", "--patch", "0,36"], &["no patch 36"]);
    folder.refuses(&["radiosity", "g.rta", "--patch", "0"], &["WALL,NUMBER"]);
    folder.refuses(&["radiosity", "g.rta", "--factors", "hemicube:3"], &["even number"]);
    folder.scene("c.rta", CORNELL);
    folder.refuses(&["radiosity", "c.rta", "--factors", "exact"], &["exact factors"]);
}
