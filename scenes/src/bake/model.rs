//! The illumination models that a scene is baked for, and what each of them uses of it.

use rta_core::illumination::{self, Illumination};
use rta_core::needs::Used;
use rta_core::scalar::Scalar;
use rta_core::scene::Scene;

use crate::description;

macro_rules! models {
    ($($Model:ident $name:literal $about:tt)*) => {
        /// The illumination model that a baked scene is meant for: it decides what the scene needs.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Model {
            $(#[doc = $about] $Model,)*
        }

        impl Model {
            /// All models, in the order of the core's list.
            const ALL: &[Self] = &[$(Self::$Model),*];

            const fn name(self) -> &'static str {
                match self {
                    $(Self::$Model => $name,)*
                }
            }

            /// What the model says of itself. It does not depend on the number format.
            fn traits(self) -> Traits {
                match self {
                    $(Self::$Model => Traits::of::<f32, _>(&illumination::$Model::default()),)*
                }
            }
        }
    };
}
rta_core::with_models!(models);

/// The constants of [`Illumination`] on which the needs of a scene depend.
#[derive(Clone, Copy, PartialEq, Eq)]
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
    /// What of a scene is used where this model draws it.
    pub(super) fn used<S: Scalar>(self, scene: &Scene<S>) -> Used {
        let Traits { specular, attenuation } = self.traits();
        let used = Used::by(scene, specular);
        Used { attenuation: used.lamps && attenuation, ..used }
    }

    /// The name that a baked scene bears: that of the first model which uses the same of every scene. The scene serves all
    /// of these models.
    pub(super) fn representative(self) -> &'static str {
        let same = |model: &&Self| model.traits() == self.traits();
        Self::ALL.iter().find(same).map_or(self.name(), |model| model.name())
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
