//! Picture files never make their reader panic or take more memory than it says, and what it reads is a picture.
#![no_main]

use std::alloc::{GlobalAlloc, Layout, System};
use std::panic;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use libfuzzer_sys::fuzz_target;

#[path = "../../src/fuzzed_picture.rs"]
mod fuzzed_picture;

/// The most memory that a reading may take at a time, in bytes. The decoder has 8 bytes a pixel, the picture another 4 and its colours 3;
/// decoders have tables besides, and some do not count all that they take: a progressive JPEG its coefficients, a TGA file its pixels.
const MEMORY: usize = 4 << 20;

/// The system's allocator, and what it has given: memory that is asked for and never written to does not show in the size of the process.
struct Counted;

static NOW: AtomicUsize = AtomicUsize::new(0);
static MOST: AtomicUsize = AtomicUsize::new(0);

// SAFETY: the system's allocator does all of it.
unsafe impl GlobalAlloc for Counted {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        MOST.fetch_max(NOW.fetch_add(layout.size(), Relaxed) + layout.size(), Relaxed);
        unsafe { System.alloc(layout) }
    }

    // Without this, zeros that nobody reads are written.
    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        MOST.fetch_max(NOW.fetch_add(layout.size(), Relaxed) + layout.size(), Relaxed);
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        NOW.fetch_sub(layout.size(), Relaxed);
        unsafe { System.dealloc(place, layout) }
    }
}

#[global_allocator]
static COUNTED: Counted = Counted;

/// A panic of a decoder is answered by the reader, which catches it. Others end the run, by the hook that is there.
fn pass_decoders_over() {
    let end = panic::take_hook();
    panic::set_hook(Box::new(move |info| {
        if !info.location().is_some_and(|place| place.file().contains("registry")) {
            end(info);
        }
    }));
}

fuzz_target!(init: pass_decoders_over(), |bytes: &[u8]| {
    let before = NOW.load(Relaxed);
    MOST.store(before, Relaxed);
    let _ = fuzzed_picture::check(bytes);
    let taken = MOST.load(Relaxed) - before;
    assert!(taken <= MEMORY, "{taken} bytes of memory");
});
