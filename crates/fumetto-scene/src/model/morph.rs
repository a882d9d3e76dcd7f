use crate::Particle;

/// Particles that are given.
#[derive(Clone, Debug, PartialEq)]
pub enum Given {
    /// The scene lists them.
    Listed(Vec<Particle>),
    /// They are in a PLY or CSV file.
    File(String),
}

/// A cloud that becomes another, and another again.
#[derive(Clone, Debug, PartialEq)]
pub struct Metamorphosis {
    /// What it is at first.
    pub start: Given,
    /// Its changes; at least one, in the order of time, none before the one ahead of it ends.
    pub changes: Vec<Morph>,
}

/// One change.
#[derive(Clone, Debug, PartialEq)]
pub struct Morph {
    /// From when until when, in seconds; the second is later.
    pub during_secs: [f32; 2],
    /// What it becomes.
    pub particles: Given,
    /// How it gets under way and comes to rest.
    pub ease: Ease,
}

/// How a change gets under way and comes to rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ease {
    /// Slow at both ends.
    InOut,
    /// Slow at first.
    In,
    /// Slow at last.
    Out,
    /// Even all the way.
    Linear,
}

impl Metamorphosis {
    /// Everything that it ever is, in the order of time.
    pub fn all(&self) -> impl Iterator<Item = &Given> {
        std::iter::once(&self.start).chain(self.changes.iter().map(|change| &change.particles))
    }
}

impl Given {
    /// The path of its file, if it has one.
    #[must_use]
    pub fn file(&self) -> Option<&str> {
        match self {
            Self::Listed(_) => None,
            Self::File(path) => Some(path),
        }
    }

    /// The particles, if the scene lists them.
    #[must_use]
    pub fn listed(&self) -> Option<&[Particle]> {
        match self {
            Self::Listed(particles) => Some(particles),
            Self::File(_) => None,
        }
    }
}

impl Morph {
    /// How much of it is done at a moment, 0 to 1, eased.
    #[must_use]
    pub fn share_at(&self, secs: f32) -> f32 {
        let [from, until] = self.during_secs;
        let t = ((secs - from) / (until - from)).clamp(0.0, 1.0);
        match self.ease {
            Ease::InOut => t * t * (3.0 - 2.0 * t),
            Ease::In => t * t,
            Ease::Out => t * (2.0 - t),
            Ease::Linear => t,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_ease_runs_from_nothing_to_all_and_never_back() {
        for ease in [Ease::InOut, Ease::In, Ease::Out, Ease::Linear] {
            let morph = Morph { during_secs: [1.0, 3.0], particles: Given::Listed(Vec::new()), ease };
            assert_eq!([0.0, 1.0, 3.0, 9.0].map(|secs| morph.share_at(secs)), [0.0, 0.0, 1.0, 1.0]);
            let shares: Vec<_> = (0..=40).map(|tick| morph.share_at(1.0 + tick as f32 / 20.0)).collect();
            assert!(shares.is_sorted(), "{ease:?}: {shares:?}");
        }
    }
}
