//! Scenes that are baked when this program is built draw what the engine draws of their files. A package of its own: what bakes them
//! is compiled for its build script, and no other test has need of that.

mod baked;
mod drawn;
mod spread;
