//! Bakes the scene: the program reads no file.

fn main() {
    if let Err(why) = rta_scenes::bake("../../../../scenes/juggler.dat", rta_scenes::bake::Format::Q16) {
        println!("cargo::error={why}");
    }
}
