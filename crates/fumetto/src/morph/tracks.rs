//! Where each particle is while its cloud changes.

use fumetto_scene::{Metamorphosis, Morph, Particle};

use super::pairing::{Kind, pairs};

/// The ways of all particles through all changes.
#[derive(Clone, Debug)]
pub(crate) struct Tracks {
    /// What the cloud becomes one after the other, as it was given.
    sets: Vec<Vec<Particle>>,
    legs: Vec<Leg>,
    slots: usize,
}

/// One change. Every particle keeps its slot through all of them, and so its look.
#[derive(Clone, Debug)]
struct Leg {
    morph: Morph,
    from: Vec<Particle>,
    to: Vec<Particle>,
}

impl Tracks {
    /// For a cloud that has its start and the end of each of its changes in `sets`.
    pub(crate) fn new(morph: &Metamorphosis, sets: Vec<Vec<Particle>>) -> Self {
        let mut now: Vec<Option<Particle>> = sets.first().into_iter().flatten().copied().map(Some).collect();
        let mut legs = Vec::with_capacity(morph.changes.len());
        for (change, next) in morph.changes.iter().zip(sets.iter().skip(1)) {
            let [from, to] = leg(&mut now, next);
            legs.push(Leg { morph: change.clone(), from, to });
        }
        Self { sets, legs, slots: now.len() }
    }

    /// What the cloud becomes one after the other.
    pub(crate) fn sets(&self) -> Vec<&[Particle]> {
        self.sets.iter().map(Vec::as_slice).collect()
    }

    /// Most particles at once.
    pub(crate) fn slots(&self) -> usize {
        self.slots
    }

    /// The particles of a moment; those of radius zero are not there.
    pub(crate) fn at(&self, secs: f32) -> Vec<Particle> {
        let begun = |leg: &&Leg| leg.morph.during_secs[0] <= secs;
        let Some(leg) = self.legs.iter().rev().find(begun).or(self.legs.first()) else {
            return self.sets.first().cloned().unwrap_or_default();
        };
        let share = leg.morph.share_at(secs);
        leg.from.iter().zip(&leg.to).map(|(from, to)| between(*from, *to, share)).collect()
    }
}

/// What a particle grows out of, or shrinks to.
fn nothing_at(place: Particle) -> Particle {
    Particle { radius: 0.0, mass: 0.0, ..place }
}

/// Both ends of what all slots do while those who are there `now` become the `next`. Afterwards they are these.
fn leg(now: &mut Vec<Option<Particle>>, next: &[Particle]) -> [Vec<Particle>; 2] {
    let live: Vec<(usize, Particle)> =
        now.iter().enumerate().filter_map(|(slot, particle)| Some((slot, (*particle)?))).collect();
    let from: Vec<Particle> = live.iter().map(|&(_, particle)| particle).collect();
    let mut free: Vec<usize> = (0..now.len()).rev().filter(|&slot| now[slot].is_none()).collect();
    let mut ways: Vec<(usize, Particle, Particle)> = Vec::with_capacity(now.len().max(next.len()));
    let mut after: Vec<Option<Particle>> = vec![None; now.len()];
    let mut born = |after: &mut Vec<Option<Particle>>, place: Particle, to: Particle| {
        let slot = free.pop().unwrap_or_else(|| {
            after.push(None);
            after.len() - 1
        });
        after[slot] = Some(to);
        (slot, nothing_at(place), to)
    };
    for pair in pairs(&from, next) {
        let (slot, from) = live[pair.from];
        let to = next[pair.to];
        ways.push(match pair.kind {
            Kind::Moved => {
                after[slot] = Some(to);
                (slot, from, to)
            }
            Kind::Absorbed => (slot, from, nothing_at(to)),
            Kind::Born => born(&mut after, from, to),
        });
    }
    // With nobody on the other side they come or go where they are.
    if next.is_empty() {
        ways.extend(live.iter().map(|&(slot, particle)| (slot, particle, nothing_at(particle))));
    } else if live.is_empty() {
        ways.extend(next.iter().map(|&to| born(&mut after, to, to)));
    }
    let nobody = Particle { center: [0.0; 3], radius: 0.0, mass: 0.0 };
    let mut ends = [vec![nobody; after.len()], vec![nobody; after.len()]];
    for (slot, from, to) in ways {
        (ends[0][slot], ends[1][slot]) = (from, to);
    }
    *now = after;
    ends
}

/// Exactly `from` at 0 and exactly `to` at 1.
fn between(from: Particle, to: Particle, share: f32) -> Particle {
    let mix = |a: f32, b: f32| (1.0 - share) * a + share * b;
    Particle {
        center: std::array::from_fn(|axis| mix(from.center[axis], to.center[axis])),
        radius: mix(from.radius, to.radius),
        mass: mix(from.mass, to.mass),
    }
}

#[cfg(test)]
mod tests {
    use fumetto_scene::{Ease, Given};

    use super::*;

    fn particle(x: f32, radius: f32) -> Particle {
        Particle { center: [x, 0.0, 0.0], radius, mass: 2.0 * radius }
    }

    /// A change each in second 1 to 2, 3 to 4 and so on.
    fn tracks(sets: &[&[Particle]]) -> Tracks {
        let change = |index: usize| Morph {
            during_secs: [1.0 + 2.0 * index as f32, 2.0 + 2.0 * index as f32],
            particles: Given::Listed(Vec::new()),
            ease: Ease::Linear,
        };
        let start = Given::Listed(Vec::new());
        let morph = Metamorphosis { start, changes: (0..sets.len() - 1).map(change).collect() };
        Tracks::new(&morph, sets.iter().map(|set| set.to_vec()).collect())
    }

    /// Those that are there, from left to right.
    fn there(tracks: &Tracks, secs: f32) -> Vec<Particle> {
        let mut particles = tracks.at(secs);
        particles.retain(|particle| particle.radius > 0.0);
        particles.sort_by(|a, b| a.center[0].total_cmp(&b.center[0]));
        particles
    }

    const FEW: [Particle; 0] = [];

    #[test]
    fn before_between_and_after_changes_the_cloud_is_what_was_given() {
        let [a, b, c] = [
            vec![particle(0.0, 1.0), particle(3.0, 2.0)],
            vec![particle(-5.0, 1.0), particle(1.0, 0.5), particle(4.0, 0.25), particle(6.0, 3.0)],
            vec![particle(9.0, 1.0)],
        ];
        let tracks = tracks(&[&a, &b, &c, &FEW, &a]);
        for (secs, set) in [(0.0, &a), (1.0, &a), (2.0, &b), (3.0, &b), (4.5, &c), (8.0, &a), (99.0, &a)] {
            assert_eq!(&there(&tracks, secs), set, "at {secs} s");
        }
        assert!(there(&tracks, 6.5).is_empty());
        assert_eq!(tracks.slots(), 4);
    }

    #[test]
    fn halfway_particles_are_half_the_way_and_half_as_much() {
        let tracks = tracks(&[&[particle(0.0, 1.0)], &[particle(4.0, 3.0), particle(10.0, 1.0)]]);
        // The second grows out of the first.
        assert_eq!(there(&tracks, 1.5), [particle(2.0, 2.0), particle(5.0, 0.5)]);
        assert_eq!(there(&tracks, 1.0), [particle(0.0, 1.0)]);
    }

    #[test]
    fn who_merges_goes_to_the_partner_and_fades_to_nothing() {
        let tracks = tracks(&[&[particle(0.0, 1.0), particle(4.0, 1.0)], &[particle(1.0, 2.0)]]);
        let nearly = there(&tracks, 1.999);
        assert!((nearly[1].center[0] - 1.0).abs() < 0.01 && nearly[1].radius < 0.01 && nearly[1].mass < 0.01);
    }

    #[test]
    fn everybody_keeps_a_slot_through_all_changes() {
        let left_to_right = |shift: f32| [0.0, 2.0, 4.0].map(|x| particle(x + shift, 1.0));
        let sets = [left_to_right(0.0), left_to_right(7.0), left_to_right(-2.0)];
        let tracks = tracks(&[&sets[0], &sets[1], &sets[2]]);
        assert_eq!(tracks.at(0.0), sets[0]);
        assert_eq!(tracks.at(2.5), sets[1]);
        assert_eq!(tracks.at(9.0), sets[2]);
    }
}
