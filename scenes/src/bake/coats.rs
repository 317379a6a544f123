//! The source of a scene's coats, and of the words that they look up.

use core::fmt::{self, Write};

use rta_core::texture::{Bump, Coat, Image, Pattern, Texture};

use super::literal::{Literal, color, direction, length, light};
use crate::narrow::Narrowed;

/// Words in a line.
const A_LINE: usize = 12;

pub(super) fn write<S: Literal>(out: &mut impl Write, scene: &Narrowed<S>) -> fmt::Result {
    let path = "::rta_core::texture::Coat<Number>";
    writeln!(out, "    static COATS: [{path}; {}] = [", scene.coats.len())?;
    for Coat { texture, bump, surroundings, emission, shading, view } in &scene.coats {
        let texture = option(texture.as_ref().map(self::texture));
        let bump = option(bump.as_ref().map(|Bump { texture, height }| {
            let (texture, height) = (self::texture(texture), length(*height));
            format!("::rta_core::texture::Bump {{ texture: {texture}, height: {height} }}")
        }));
        let view = option(view.map(direction::<S>));
        writeln!(
            out,
            "        ::rta_core::texture::Coat {{ texture: {texture}, bump: {bump}, surroundings: {surroundings}, emission: {}, \
             shading: ::rta_core::texture::Shading::{shading:?}, view: {view} }},",
            light::<S>(*emission)
        )?;
    }
    writeln!(out, "    ];\n    static POOL: [u32; {}] = [", scene.pool.len())?;
    for words in scene.pool.chunks(A_LINE) {
        let words: Vec<_> = words.iter().map(u32::to_string).collect();
        writeln!(out, "        {},", words.join(", "))?;
    }
    writeln!(out, "    ];")
}

fn option(value: Option<String>) -> String {
    value.map_or_else(|| "None".into(), |value| format!("Some({value})"))
}

fn texture<S: Literal>(texture: &Texture<S>) -> String {
    let [first, second] = texture.colors.map(color::<S>);
    let pattern = match &texture.pattern {
        Pattern::Checker => "Checker".to_owned(),
        Pattern::Marble { octaves, amount } => format!("Marble {{ octaves: {octaves}, amount: {amount} }}"),
        Pattern::Wood { amount } => format!("Wood {{ amount: {amount} }}"),
        Pattern::Image(Image { first, width, height, nearest, plane, coordinates }) => {
            let axis = |axis| format!("::rta_core::texture::Axis::{axis:?}");
            let plane = option(plane.map(|[right, up]| format!("[{}, {}]", axis(right), axis(up))));
            let coordinates = option(coordinates.map(|first| first.to_string()));
            format!(
                "Image(::rta_core::texture::Image {{ first: {first}, width: {width}, height: {height}, nearest: {nearest}, \
                 plane: {plane}, coordinates: {coordinates} }})"
            )
        }
    };
    let Texture { frequency, origin, .. } = texture;
    format!(
        "::rta_core::texture::Texture {{ pattern: ::rta_core::texture::Pattern::{pattern}, colors: [{first}, {second}], \
         frequency: {frequency}, origin: {origin:?} }}"
    )
}
