//! Compares the program's `f64` with the oracle of NFF, and its other formats with its `f64`, for each scene file named:
//!
//! ```text
//! cargo run --release -p rta-tests --example nff -- [--size 96x96] FILE...
//! ```

use rta::engine::Format;
use rta_tests::agreement::{Agreement, Nff};

fn main() -> Result<(), Box<dyn core::error::Error>> {
    let mut size = None;
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        if argument == "--size" {
            let text = arguments.next().unwrap_or_default();
            let (width, height) = text.split_once('x').ok_or("a size such as 96x96")?;
            size = Some((width.parse()?, height.parse()?));
            continue;
        }
        let scene = Nff::new(&argument, &std::fs::read_to_string(&argument)?, size);
        let truth = scene.oracle()?;
        let double = scene.program(Format::F64)?;
        println!("{argument}, f64 and oracle: {}", Agreement::new(&truth, &double, 1e-3));
        for format in [Format::F32, Format::Q16, Format::Q20] {
            match scene.program(format) {
                Ok(picture) => {
                    let agreement = Agreement::new(&double, &picture, 1.0 / 63.0);
                    println!("{argument}, {format} and f64: {agreement}");
                }
                Err(error) => println!("{argument}, {format}: {error}"),
            }
        }
    }
    Ok(())
}
