//! What holds rta together: an independent oracle, generated scenes, and how pictures are compared.

pub mod baseline;
pub mod boards;
pub mod close;
pub mod exact;
pub mod golden;
pub mod measure;
pub mod oracle;
pub mod picture;
pub mod random_scenes;
