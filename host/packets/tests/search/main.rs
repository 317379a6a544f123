//! What the packets promise: they find what one object after the other finds, to the last bit, whatever the scene, the number
//! format and the place of the eye, and a picture whose rays are followed four by four is that of single rays.
//!
//! It is one program, since linking takes longer than most of these tests.

mod compare;
mod equal;
mod random;
mod scenes;
mod spread;
mod wrong;
