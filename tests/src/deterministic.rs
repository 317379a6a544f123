//! Fixed point draws the same bytes: in debug and in release, by any number of threads, in any order of rows.

use crate::exact::{Bits, DEPTH, Exact, hash, shipped_scene};
use rta_core::illumination::{Phong, Rta};
use rta_core::needs::Everything;

/// [`hash`] of each shipped scene at 320 x 200, which every build on every machine must draw.
const HASHES: [(&str, u64); 3] = [
    ("juggler", 0x77e7_0398_f855_1b5d),
    ("hall-22", 0x7968_9965_4c09_e97f),
    ("glass-2", 0xb7af_0bbd_ce82_71b9),
];

/// Asserts that shipped scenes have the bytes that every build draws.
///
/// # Panics
/// It does not.
pub fn every_build_draws_the_same_bytes() {
    let got = HASHES.map(|(name, _)| {
        let exact = Exact::new(&shipped_scene(name), 320, 200);
        let picture = exact.searched::<_, Everything>(exact.packets(), Rta, DEPTH);
        (name, hash(&picture.expect("it is drawn")))
    });
    assert!(got == HASHES, "got {got:#x?}, want {HASHES:#x?}");
}

/// [`hash`] of scenes in NFF in Phong's model: cones, triangles, a hierarchy, highlights by powers.
const NFF_HASHES: [(&str, u64); 2] =
    [("scenes/solids.nff", 0xb3ed_154e_226a_21a1), ("../scenes/balls2.nff", 0x7588_c42a_98b4_3086)];

/// Asserts that scenes in NFF have the bytes that every build draws, however they are searched.
///
/// # Panics
/// It does not.
pub fn every_build_draws_the_same_bytes_of_nff() {
    let got = NFF_HASHES.map(|(file, _)| {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
        let text = std::fs::read(path).expect("a scene file");
        let scene = rta_scenes::read(&text, file).expect("a scene");
        let exact = Exact::new(&scene, 320, 200);
        let picture = exact.searched::<_, Everything>(exact.packets(), Phong::default(), DEPTH);
        let picture = picture.expect("it is drawn");
        // As the program searches, as firmware does, and without any search.
        let bvh = exact.bvh();
        assert_eq!(bvh.is_some(), file.contains("balls2"), "a hierarchy where there are objects enough");
        if let Some(bvh) = bvh {
            let firmware = exact.searched::<_, Everything>(bvh, Phong::default(), DEPTH);
            assert!(firmware.as_ref() == Ok(&picture), "{file} by the hierarchy");
        }
        let listed = exact.picture::<_, Everything>(Phong::default(), DEPTH);
        assert!(listed.as_ref() == Ok(&picture), "{file} one by one");
        (file, hash(&picture))
    });
    assert!(got == NFF_HASHES, "got {got:#x?}, want {NFF_HASHES:#x?}");
}

/// Asserts that any number of threads draws the same bytes.
///
/// # Panics
/// It does not.
pub fn any_number_of_threads_draws_the_same_bytes() {
    for (name, want) in HASHES {
        let exact = Exact::new(&shipped_scene(name), 320, 200);
        for threads in [1, 2, 3, 7] {
            let got = hash(&exact.threaded(threads).expect("nothing stops it"));
            assert_eq!(got, want, "{name} by {threads} threads");
        }
    }
}

/// Asserts that any order of rows draws the same bytes.
///
/// # Panics
/// It does not.
pub fn any_order_of_rows_draws_the_same_bytes() {
    let mut dice = fastrand::Rng::with_seed(7);
    for (name, want) in HASHES {
        let exact = Exact::new(&shipped_scene(name), 320, 200);
        let mut pixels = vec![Bits::default(); exact.pixels()];
        let mut rows: Vec<_> = (0_u32..).zip(pixels.chunks_mut(exact.columns())).collect();
        dice.shuffle(&mut rows);
        for (y, row) in rows {
            exact.rows::<_, Everything>(exact.packets(), Rta, DEPTH, y, row).expect("it is drawn");
        }
        assert_eq!(hash(&pixels), want, "{name} with its rows shuffled");
    }
}
