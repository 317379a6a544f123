//! The illumination models that a picture can be computed with, chosen when the program runs: those of the core's list.

use core::fmt;

use rta_core::illumination::Illumination;
use rta_core::scalar::Scalar;
use rta_scenes::{bake, description};

/// Makes the type and the dispatch from the list. `$d` is a dollar sign, for the macro that this one defines.
macro_rules! models {
    (($d:tt) $($Model:ident $name:literal $about:tt)*) => {
        /// The illumination model.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, clap::ValueEnum)]
        pub enum Model {
            $(#[doc = $about] #[value(name = $name)] $Model,)*
        }

        impl Model {
            /// All models, in the order of the core's list.
            pub const ALL: &[Self] = &[$(Self::$Model),*];
        }

        impl fmt::Display for Model {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(match self {
                    $(Self::$Model => $name,)*
                })
            }
        }

        impl From<Model> for bake::Model {
            fn from(model: Model) -> Self {
                match model {
                    $(Model::$Model => Self::$Model,)*
                }
            }
        }

        /// Evaluates an expression in which a variable is the core's model of a [`Model`], with its default coefficients:
        /// `in_model!(model, inner => picture::<S, _>(scene, inner))`. It is the only place where the program chooses
        /// code by its model.
        macro_rules! in_model {
            ($d model:expr, $d inner:ident => $d body:expr) => {
                match $d model {
                    $($crate::engine::Model::$Model => {
                        let $d inner = ::rta_core::illumination::$Model::default();
                        $d body
                    })*
                }
            };
        }
    };
}
rta_core::with_models!(models ($));
pub(crate) use in_model;

impl Model {
    /// The model after this one, in a circle.
    #[must_use]
    pub fn next(self) -> Self {
        let after = Self::ALL.iter().copied().skip_while(|model| *model != self).nth(1);
        after.or(Self::ALL.first().copied()).unwrap_or(self)
    }

    /// Whether the light of lamps is attenuated with their distance, which decides how bright they are in a scene that is
    /// scaled.
    #[must_use]
    pub fn is_attenuated(self) -> bool {
        const fn of<S: Scalar, M: Illumination<S>>(_: &M) -> bool {
            M::ATTENUATION
        }
        // It does not depend on the number format.
        in_model!(self, model => of::<f32, _>(&model))
    }
}

impl From<description::Model> for Model {
    fn from(model: description::Model) -> Self {
        match model {
            description::Model::Rta => Self::Rta,
            description::Model::Phong => Self::Phong,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Model;

    #[test]
    fn each_model_comes_once_in_a_circle_and_has_its_own_name() {
        let circle: Vec<_> = core::iter::successors(Some(Model::Rta), |model| Some(model.next()))
            .take(Model::ALL.len())
            .collect();
        assert_eq!(circle, Model::ALL);
        assert_eq!(circle.last().copied().map(Model::next), Some(Model::Rta));
        let names: std::collections::BTreeSet<_> = Model::ALL.iter().map(ToString::to_string).collect();
        assert_eq!(names.len(), Model::ALL.len());
    }
}
