//! Pipes.

use std::fs;
use std::io::Write;
use std::process::{Command, Stdio};

use super::folder::{Folder, SCENE};

#[test]
fn a_scene_comes_through_a_pipe_and_a_picture_goes_out() {
    let folder = Folder::new();
    let mut child = folder
        .command(&["render", "-q", "-", "-o", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(SCENE.as_bytes()).unwrap();
    let piped = child.wait_with_output().unwrap().stdout;
    let mut reader = png::Decoder::new(std::io::Cursor::new(piped)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut pixels).unwrap();
    assert_eq!(pixels.len(), 64_000);
    folder.refuses(&["render", "-", "-o", "out.png"], &["standard input", "empty file"]);
}

#[cfg(unix)]
#[test]
fn a_named_pipe_is_written_and_not_replaced() {
    use std::os::unix::fs::FileTypeExt;
    let folder = Folder::new();
    let pipe = folder.path("pipe.ppm");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let child = folder.command(&["render", "-q", "scene.dat", "-o", "pipe.ppm"]).spawn().unwrap();
    assert!(fs::read(&pipe).unwrap().starts_with(b"P6\n320 200\n255\n"));
    assert!(child.wait_with_output().unwrap().status.success());
    assert!(fs::metadata(&pipe).unwrap().file_type().is_fifo());
}
