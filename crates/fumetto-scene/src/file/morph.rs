use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::ParticlesFile;
use crate::limits;

/// One change of a cloud into another.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct MorphFile {
    /// From when until when it changes, in seconds; not before the change that is listed above it ends.
    #[schemars(transform = &limits::SECONDS)]
    pub during: [f32; 2],
    /// What it becomes: particles listed here, or a .ply or .csv file relative to the scene file.
    pub particles: ParticlesFile,
    /// How it gets under way and comes to rest. Default "in-out".
    #[serde(default)]
    pub ease: EaseFile,
}

/// How a change gets under way and comes to rest.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, JsonSchema, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum EaseFile {
    /// Slow at both ends.
    #[default]
    InOut,
    /// Slow at first.
    In,
    /// Slow at last.
    Out,
    /// Even all the way.
    Linear,
}
