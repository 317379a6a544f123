//! The scenes of the program: baked by build.rs, each with what it needs and in Q16.16.

use picture::{DEPTH, DrawError};
use rta_core::Q16;
use rta_core::prelude::*;
use rta_core::range::Admitted;
use rta_drivers::display::Display;
use rta_drivers::painter::Painter;
use rta_drivers::quantize::Adaptive;

// `NAMES`, and `draw`, which draws the scene of a number.
include!(concat!(env!("OUT_DIR"), "/scenes.rs"));

/// Draws a scene on all of the display.
fn paint<D: Display, M: Illumination<Q16>, N: Needs, A: Accelerator<Q16>>(
    _needs: N,
    scene: &Admitted<'_, Q16, A>,
    model: M,
    camera: &Camera<Q16>,
    (display, table): (D, Adaptive),
) -> Result<D, DrawError<D::Error>> {
    let screen = display.capabilities();
    let raster = Raster::new(screen.width, screen.height).map_err(DrawError::Tracer)?;
    let tracer: Tracer<'_, _, _, N, { DEPTH as usize }, _> =
        Tracer::new(scene, model, DEPTH.into()).map_err(DrawError::Tracer)?;
    let mut painter = Painter::new(display, table).map_err(DrawError::Display)?;
    let most = painter.light_max();
    for y in 0..raster.height() {
        let light = Pixels::row(&tracer, camera, raster, y).map(|light| light.levels(most));
        painter.put_row(0, y, light).map_err(DrawError::Display)?;
    }
    painter.update().map_err(DrawError::Display)?;
    Ok(painter.into_parts().0)
}
