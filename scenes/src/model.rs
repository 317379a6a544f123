//! The illumination models that a scene can be drawn with, chosen when a program runs: those of the core's list.

use core::fmt;

use rta_core::illumination::{Facts, Illumination};
use rta_core::light::Lamp;
use rta_core::needs::Used;
use rta_core::scalar::Scalar;
use rta_core::scene::Scene;

use crate::used;

/// Makes the type and the dispatch from the list. `$d` is a dollar sign, for the macro that this one defines.
macro_rules! models {
    (($d:tt) $($Model:ident $name:literal $facts:tt)*) => {
        /// An illumination model.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Model {
            $(#[doc = concat!("The model `", $name, "`.")] $Model,)*
        }

        impl Model {
            /// All models, in the order of the core's list.
            pub const ALL: &[Self] = &[$(Self::$Model),*];

            /// Returns the name on a command line.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$Model => $name,)*
                }
            }

            /// Returns the name of its type in the core.
            pub(crate) const fn type_name(self) -> &'static str {
                match self {
                    $(Self::$Model => stringify!($Model),)*
                }
            }

            /// Returns what is to be said of it.
            #[must_use]
            pub const fn facts(self) -> Facts {
                match self {
                    $(Self::$Model => Facts $facts,)*
                }
            }

            /// Returns what a help text says of it, without a full stop.
            #[must_use]
            pub const fn about(self) -> &'static str {
                self.facts().about
            }
        }

        /// Evaluates an expression in which a variable is the core's model of a [`Model`](crate::model::Model), with its
        /// default coefficients: `in_model!(model, inner => picture::<S, _>(scene, inner))`. It is the only place where a
        /// program chooses code by its model.
        #[macro_export]
        macro_rules! in_model {
            ($d model:expr, $d inner:ident => $d body:expr) => {
                match $d model {
                    $($d crate::model::Model::$Model => {
                        let $d inner = $d crate::model::illumination::$Model::default();
                        $d body
                    })*
                }
            };
        }
    };
}
rta_core::with_models!(models ($));

pub use rta_core::illumination;

impl Model {
    /// Returns the one after this one, in a circle.
    #[must_use]
    pub fn next(self) -> Self {
        let after = Self::ALL.iter().copied().skip_while(|one| *one != self).nth(1);
        after.or(Self::ALL.first().copied()).unwrap_or(self)
    }
}

impl fmt::Display for Model {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The constants of [`Illumination`] on which the needs of a scene depend. They do not depend on the number format.
#[derive(Clone, Copy)]
struct Traits {
    specular: bool,
    attenuation: bool,
}

impl Traits {
    const fn of<S: Scalar, M: Illumination<S>>(_: &M) -> Self {
        Self { specular: M::SPECULAR, attenuation: M::ATTENUATION }
    }
}

impl Model {
    fn traits(self) -> Traits {
        in_model!(self, model => Traits::of::<f32, _>(&model))
    }

    /// Returns whether the light of lamps is attenuated with their distance, which decides how bright they are in a scene that
    /// is scaled.
    #[must_use]
    pub fn is_attenuated(self) -> bool {
        self.traits().attenuation
    }

    /// Returns what of a scene is used where this model draws it.
    #[must_use]
    pub fn used<S: Scalar>(self, scene: &Scene<S>) -> Used {
        let Traits { specular, attenuation } = self.traits();
        let used = used::by(scene, specular);
        let fades = |lamp: &Lamp<S>| lamp.fall_off.fades(attenuation);
        let attenuation = used.lamps && scene.lamps.iter().any(fades);
        let several_fall_offs = attenuation && !scene.lamps.iter().all(fades);
        Used { attenuation, several_fall_offs, ..used }
    }
}
