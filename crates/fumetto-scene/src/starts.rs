//! Commented scenes to start from.

/// Smoke that rises from a mouth.
pub const SMOKE: &str = include_str!("../templates/smoke.toml");

/// A cloud of listed particles.
pub const CLOUD: &str = include_str!("../templates/cloud.toml");

/// A burst of smoke.
pub const EXPLOSION: &str = include_str!("../templates/explosion.toml");
