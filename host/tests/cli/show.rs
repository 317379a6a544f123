//! The picture of `rta show` and what its keys do to it, without a window.

use core::time::Duration;
use std::time::Instant;

use rta::args::ShowArgs;
use rta::device::{Device, Target};
use rta::engine::{Format, Model};
use rta::picture::Pixels;
use rta::request::Request;
use rta::scene::Scene;
use rta::show::{Command, Show};

fn show(scene: Scene) -> Show {
    let request = ShowArgs::default().tracing.request(Target::On(Device::Vga));
    let request = Request { size: Some("80x50".parse().expect("a size")), ..request };
    Show::new(scene, None, request, Some(2)).expect("it begins")
}

fn complete(show: &mut Show) {
    let begun = Instant::now();
    while !show.is_complete() {
        show.advance(Duration::from_millis(5)).expect("the device takes it");
        assert!(begun.elapsed() < Duration::from_secs(120), "{}", show.title());
        std::thread::sleep(Duration::from_millis(1));
    }
}

fn pixels(show: &mut Show) -> Pixels {
    show.shown().expect("the device answers").picture().pixels.clone()
}

#[test]
fn keys_change_the_picture_and_back() {
    let mut show = show(Scene::juggler().expect("it is well formed"));
    complete(&mut show);
    assert!(show.title().contains("juggler | vga | f32 | rta | depth 5 | tolerant | "), "{}", show.title());
    let first = pixels(&mut show);
    // The key goes round in a circle.
    let others = Model::ALL.len() - 1;
    for (there, back, word) in [
        (vec![Command::Model], vec![Command::Model; others], "| whitted |"),
        (vec![Command::Table], vec![Command::Table; 2], "| uniform |"),
        (vec![Command::Shallower; 5], vec![Command::Deeper; 5], "| depth 0 |"),
        (
            vec![Command::Format, Command::Model],
            [vec![Command::Format; 3], vec![Command::Model; others]].concat(),
            "| f64 |",
        ),
    ] {
        for (keys, away) in [(there, true), (back, false)] {
            for key in keys {
                show.obey(key);
            }
            complete(&mut show);
            assert_eq!(show.title().contains(word), away, "{}", show.title());
            assert_eq!(pixels(&mut show) != first, away, "{}", show.title());
        }
    }
}

#[test]
fn a_key_does_not_wait_for_the_picture() {
    let mut show = show(Scene::juggler().expect("it is well formed"));
    show.obey(Command::Device);
    assert_eq!((show.request().target, show.request().size), (Target::On(Device::Graphigs), None));
    for _ in 0..50 {
        show.obey(Command::Reload);
    }
    show.obey(Command::Device);
    show.obey(Command::Device);
    assert_eq!(show.request().target, Target::None);
    show.obey(Command::Device);
    assert_eq!(show.request().target, Target::On(Device::Vga));
    complete(&mut show);
}

#[test]
fn depth_stays_within_its_limits() {
    let mut show = show(Scene::juggler().expect("it is well formed"));
    for _ in 0..40 {
        show.obey(Command::Deeper);
    }
    assert_eq!(show.request().depth, rta::engine::MAX_DEPTH);
    for _ in 0..40 {
        show.obey(Command::Shallower);
    }
    assert_eq!(show.request().depth, 0);
}

#[test]
fn what_does_not_fit_is_told_and_everything_stays() {
    let mut scene = Scene::juggler().expect("it is well formed");
    for sphere in scene.description.spheres.iter_mut().take(1) {
        sphere.position = [1e6, 0.0, 0.0];
    }
    let mut show = show(scene);
    show.obey(Command::Format);
    complete(&mut show);
    let before = pixels(&mut show);
    show.obey(Command::Format);
    assert_eq!(show.request().format, Format::F64);
    assert!(show.title().contains("sphere 1"), "{}", show.title());
    assert_eq!(pixels(&mut show), before);
    show.obey(Command::Model);
    assert_eq!(show.request().model, Model::Whitted);
    assert!(!show.title().contains("sphere 1"));
}
