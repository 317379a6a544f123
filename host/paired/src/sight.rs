//! Places on lamps, whose directions a format may compute in one step.

use rta_core::light::area;
use rta_core::scalar::Sight;

use crate::{Format, Paired, PairedVector};

/// Returns what [`sight`](rta_core::scalar::Scalar::sight) does; `None` where the format does.
#[track_caller]
pub(crate) fn sight<S: Format>(
    [axis, normal]: [PairedVector<S::UnitVector>; 2],
    sine: Paired<S::Unit>,
    pair: [Paired<S::Unit>; 2],
) -> Option<Sight<Paired<S>>> {
    let format = S::sight((axis.format, normal.format), sine.format, pair.map(|number| number.format))?;
    let twin = area::sight::<f64>((axis.twin, normal.twin), sine.twin, pair.map(|number| number.twin));
    let errors = [axis.error(), normal.error(), sine.error()];
    let unit = |format, twin| Paired { format, twin }.noted("sight", errors);
    Some(Sight {
        direction: PairedVector { format: format.direction, twin: twin.direction }.noted("sight", errors),
        cosine: unit(format.cosine, twin.cosine),
        // Where the format saturates, so does the twin.
        slanted: unit(format.slanted, twin.slanted.clamp(-2.0, 2.0)),
        reach: unit(format.reach, twin.reach),
    })
}
