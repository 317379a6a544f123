//! Outputs: nothing of the scene is lost, nothing half-written stays, and what is written in which way.

use std::fs;
#[cfg(unix)]
use std::process::{Command, Output, Stdio};

use clap::CommandFactory;
use rta::args::Cli;

use super::folder::{Folder, SCENE};

/// Arguments of a picture that takes longer than any test waits.
#[cfg(unix)]
const HUGE: [&str; 12] =
    ["render", "scene.dat", "-o", "out.png", "-d", "none", "-s", "9000x9000", "-f", "f64", "--threads", "1"];

#[cfg(unix)]
fn links(folder: &Folder) {
    std::os::unix::fs::symlink("scene.dat", folder.path("link.dat")).unwrap();
    fs::hard_link(folder.path("scene.dat"), folder.path("hard.dat")).unwrap();
    std::os::unix::fs::symlink(folder.path("scene.dat"), folder.path("scene.png")).unwrap();
    fs::create_dir(folder.path("sub")).unwrap();
}

#[cfg(unix)]
#[test]
fn the_scene_is_never_the_output() {
    let folder = Folder::new();
    links(&folder);
    let itself = &["the output is the input itself"];
    for output in ["scene.dat", "./scene.dat", "sub/../scene.dat", "link.dat", "hard.dat"] {
        for scene in ["scene.dat", "link.dat", "hard.dat"] {
            folder.refuses(&["bake", scene, "-o", output], itself);
            folder.refuses(&["render", scene, "-o", output, "--as", "ppm"], itself);
        }
        let mut standard_input = folder.command(&["bake", "-", "-o", output]);
        let input = fs::File::open(folder.path("scene.dat")).unwrap();
        assert_eq!(standard_input.stdin(input).output().unwrap().status.code(), Some(2), "{output}");
    }
    folder.refuses(&["render", "scene.dat", "-o", "scene.png"], itself);
    // A file of a report bears the scene's name.
    folder.refuses(&["report", "scene.dat", "-o", "."], itself);
    assert_eq!(fs::read_to_string(folder.path("scene.dat")).unwrap(), SCENE);
}

#[cfg(unix)]
#[test]
fn the_scene_is_not_standard_output_either() {
    let folder = Folder::new();
    for args in [
        &["check", "scene.dat"][..],
        &["hash", "scene.dat"],
        &["explain", "scene.dat", "-p", "1,1"],
        &["palette", "scene.dat", "-s", "9x9", "-d", "vga", "--no-instructions"],
        &["bake", "scene.dat", "-o", "-"],
        &["render", "scene.dat", "-o", "-"],
        &["render", "scene.dat", "-o", "/dev/stdout"],
    ] {
        let output = fs::File::options().append(true).open(folder.path("scene.dat")).unwrap();
        let Output { status, stderr, .. } = folder.command(args).stdout(output).output().unwrap();
        assert_eq!(status.code(), Some(2), "{args:?}");
        let message = "rta: error: cannot write ";
        assert!(String::from_utf8(stderr).unwrap().starts_with(message), "{args:?}");
        assert_eq!(fs::read_to_string(folder.path("scene.dat")).unwrap(), SCENE, "{args:?}");
    }
    // What is no ordinary file may be both.
    folder.refuses(&["render", "/dev/null", "-o", "/dev/null"], &["empty file"]);
}

/// Starts a shell that runs `before` and then becomes rta.
#[cfg(unix)]
fn after(folder: &Folder, before: &str, args: &[&str]) -> std::process::Child {
    let program = folder.command(args);
    let mut shell = Command::new("sh");
    shell.args(["-c", &format!("{before}; exec \"$0\" \"$@\"")]).arg(program.get_program()).args(args);
    shell.current_dir(folder.path("")).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
    shell.spawn().unwrap()
}

#[cfg(unix)]
fn send(signal: &str, child: &std::process::Child) {
    std::thread::sleep(core::time::Duration::from_millis(300));
    assert!(Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap().success());
}

/// Returns whether this process ignores a signal.
#[cfg(target_os = "linux")]
fn is_ignored(signal: u32) -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:")).unwrap();
    u64::from_str_radix(mask.trim(), 16).unwrap() >> (signal - 1) & 1 == 1
}

#[cfg(target_os = "linux")]
#[test]
fn ignored_signals_stay_ignored_and_the_others_leave_nothing_behind() {
    // What this test itself was started without, as under nohup, the program does not get either.
    let (interrupt, hangup) = (is_ignored(2), is_ignored(1));
    let other = if interrupt { "-HUP" } else { "-INT" };
    for (ignored, signals, last) in [
        ("USR1", &[][..], "-TERM"),
        ("USR1", &[], other),
        ("HUP", &["-HUP"], "-TERM"),
        ("INT HUP", &["-INT", "-HUP"], "-TERM"),
        ("TERM", &["-TERM"], other),
    ] {
        if last == other && interrupt && hangup {
            continue;
        }
        let folder = Folder::new();
        let mut child = after(&folder, &format!("trap '' {ignored}"), &HUGE);
        for signal in signals {
            send(signal, &child);
        }
        std::thread::sleep(core::time::Duration::from_millis(300));
        assert!(child.try_wait().unwrap().is_none(), "{ignored} ends it");
        send(last, &child);
        let Output { status, stderr, .. } = child.wait_with_output().unwrap();
        assert_eq!(status.code(), Some(130), "{ignored}: {}", String::from_utf8_lossy(&stderr));
        assert_eq!(folder.names(), ["scene.dat"], "{ignored}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn not_even_the_end_without_warning_leaves_something() {
    let folder = Folder::new();
    let child = folder.command(&HUGE).stderr(Stdio::null()).spawn().unwrap();
    send("-KILL", &child);
    assert!(!child.wait_with_output().unwrap().status.success());
    // Where the folder for temporary files knows no files without names, the hidden one stays.
    let hidden = folder.names().into_iter().filter(|name| name.starts_with(".rta-")).count();
    assert_eq!(folder.names().len(), 1 + hidden);
    assert!(hidden == 0 || !["ext4", "xfs", "btrfs", "tmpfs"].contains(&file_system(&folder).as_str()));
}

/// Returns the name of the file system of a folder, as `stat` tells it.
#[cfg(target_os = "linux")]
fn file_system(folder: &Folder) -> String {
    let told = Command::new("stat").args(["-f", "-c", "%T"]).arg(folder.path("")).output().unwrap();
    String::from_utf8(told.stdout).unwrap().trim().replace("ext2/ext3", "ext4")
}

#[cfg(target_os = "linux")]
#[test]
fn a_file_beyond_the_limit_is_an_error() {
    let folder = Folder::new();
    folder.scene("out.ppm", "precious");
    let child = after(
        &folder,
        "ulimit -f 8",
        &["render", "scene.dat", "-o", "out.ppm", "-d", "none", "-s", "400x400"],
    );
    let Output { status, stderr, .. } = child.wait_with_output().unwrap();
    let message = String::from_utf8(stderr).unwrap();
    assert_eq!(
        (status.code(), message.as_str()),
        (Some(2), "rta: error: cannot write out.ppm: File too large\n")
    );
    assert_eq!(fs::read(folder.path("out.ppm")).unwrap(), b"precious");
    assert_eq!(folder.names(), ["out.ppm", "scene.dat"]);
}

#[cfg(unix)]
#[test]
fn a_pipe_that_nobody_reads_is_no_error_for_any_output() {
    let folder = Folder::new();
    let none = ["-d", "none", "-s", "300x200"];
    let kinds = ["png", "ppm", "pfm"].into_iter();
    #[cfg(feature = "image")]
    let kinds = kinds.chain(["bmp", "tga", "qoi", "hdr"]);
    let pictures = kinds.map(|kind| [&["render", "scene.dat", "-o", "-", "--as", kind], &none[..]].concat());
    let others = [
        &["render", "scene.dat", "-o", "-"][..],
        &["bake", "scene.dat", "-o", "-"],
        &["check", "scene.dat"],
        &["hash", "scene.dat"],
        &["explain", "scene.dat", "-p", "1,1"],
        &["palette", "scene.dat", "-s", "9x9", "-d", "vga", "--no-instructions"],
        &["completions", "bash"],
        &["render", "--help"],
    ];
    for args in pictures.chain(others.map(<[_]>::to_vec)) {
        let mut command = folder.command(&args);
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        let Output { status, stderr, .. } = child.wait_with_output().unwrap();
        assert!(
            status.success() && stderr.is_empty(),
            "{args:?}: {status} {}",
            String::from_utf8_lossy(&stderr)
        );
    }
}

#[cfg(unix)]
#[test]
fn a_file_has_the_permissions_of_any_other() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::new();
    let mode = |name: &str| fs::metadata(folder.path(name)).unwrap().permissions().mode() & 0o777;
    for (mask, wanted) in [("022", 0o644), ("077", 0o600), ("002", 0o664)] {
        let name = format!("{mask}.png");
        let made = after(&folder, &format!("umask {mask}"), &["render", "scene.dat", "-q", "-o", &name]);
        assert!(made.wait_with_output().unwrap().status.success());
        assert_eq!(mode(&name), wanted, "umask {mask}");
    }
    // A file that was there keeps its own.
    fs::set_permissions(folder.path("022.png"), fs::Permissions::from_mode(0o755)).unwrap();
    folder.renders(&["scene.dat", "-o", "022.png"]);
    assert_eq!(mode("022.png"), 0o755);
}

#[test]
fn a_line_tells_of_the_picture_unless_it_is_not_wanted() {
    let folder = Folder::new();
    let told = |args: &[&str]| String::from_utf8(folder.rta(args).stderr).unwrap();
    let line = told(&["render", "scene.dat", "-o", "a.png", "-f", "q16"]);
    let start =
        "rta: a.png: PNG, 320x200, device vga, sampled colour table, format q16, model rta, depth 5; ";
    assert!(line.starts_with(start) && line.ends_with(" s\n"), "{line}");
    assert!(
        told(&["render", "scene.dat", "-o", "-", "--as", "ppm"]).starts_with("rta: standard output: PPM, ")
    );
    assert_eq!(told(&["render", "scene.dat", "-o", "a.png", "-q"]), "");
}

#[test]
fn the_shell_and_man_are_told_of_every_command() {
    let folder = Folder::new();
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = folder.prints(&["completions", shell]);
        assert!(script.contains("stability") && script.contains("jitter"), "{shell}");
    }
    assert_eq!(folder.prints(&["man", "-o", "man"]), "");
    let page = |name: &str| fs::read_to_string(folder.path("man").join(name)).unwrap();
    assert!(page("rta.1").contains("rta\\-render(1)"));
    assert!(page("rta-render.1").contains("\\-\\-jitter"));
    let commands = Cli::command().get_subcommands().filter(|command| !command.is_hide_set()).count();
    assert_eq!(fs::read_dir(folder.path("man")).unwrap().count(), 1 + commands);
}

#[cfg(feature = "image")]
#[test]
fn every_kind_of_picture_file_shows_the_picture() {
    let folder = Folder::new();
    for device in ["vga", "none"] {
        let render = |name: &str| folder.renders(&["scene.dat", "-o", name, "-s", "60x40", "-d", device]);
        render("a.ppm");
        let pixels = fs::read(folder.path("a.ppm")).unwrap().split_off("P6\n60 40\n255\n".len());
        for name in ["a.bmp", "a.tga", "a.qoi", "a.pnm"] {
            render(name);
            if name == "a.pnm" {
                assert_eq!(fs::read(folder.path("a.ppm")).unwrap(), fs::read(folder.path(name)).unwrap());
                continue;
            }
            let read = image::open(folder.path(name)).unwrap().into_rgb8();
            assert_eq!((read.dimensions(), read.as_raw()), ((60, 40), &pixels), "{name} of {device}");
        }
    }
    folder.renders(&["scene.dat", "-o", "a.hdr", "-s", "60x40", "-d", "none"]);
    folder.renders(&["scene.dat", "-o", "a.pfm", "-s", "60x40", "-d", "none"]);
    let light = image::open(folder.path("a.hdr")).unwrap().into_rgb32f();
    let floats = fs::read(folder.path("a.pfm")).unwrap().split_off("PF\n60 40\n-1.0\n".len());
    let rows = floats.chunks(60 * 12).rev().flatten().copied().collect::<Vec<_>>();
    let wanted = rows.as_chunks().0.iter().copied().map(f32::from_le_bytes);
    for (pixel, want) in light.pixels().zip(wanted.collect::<Vec<_>>().chunks(3)) {
        // Three mantissas of 8 bits share the exponent of the brightest.
        let step = want.iter().fold(0.0_f32, |most, register| most.max(*register)) / 128.0;
        for (got, want) in pixel.0.iter().zip(want) {
            assert!((got - want).abs() <= step, "{pixel:?} instead of {want:?}");
        }
    }
}
