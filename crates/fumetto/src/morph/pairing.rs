//! Who becomes whom.
//!
//! Both sets are halved again and again, each along the same axis in the order of its own particles, until one
//! of the two has a single particle left: what lies on the left stays on the left, whatever the distance
//! between the sets. Then pairs that lie close swap partners where that makes their ways shorter. It takes
//! O(n log² n) for n particles; a best assignment would take O(n³).

use fumetto_scene::Particle;
use glam::Vec3;

/// One from each set, by number; nobody where a particle is born or absorbed.
///
/// `main` pairs move. Of the others the one that is there goes to, or comes from, the `main` partner of its
/// partner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Pair {
    pub(super) from: usize,
    pub(super) to: usize,
    pub(super) kind: Kind,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// One becomes the other.
    Moved,
    /// `to` grows out of `from`, which becomes another.
    Born,
    /// `from` is absorbed in `to`, which another becomes.
    Absorbed,
}

/// Rounds of swaps; most of what they gain is gained in the first.
const ROUNDS: usize = 4;
/// Pairs that each looks at as neighbours, in the order of halving.
const NEIGHBOURS: usize = 16;

/// Pairs all of `from` with all of `to`: every particle of either set has at least one partner.
///
/// With as many in both sets it is one each, and ways are no longer in all than if each became the one of the
/// same number. The same sets give the same pairs. Where one set is empty there are none.
pub(super) fn pairs(from: &[Particle], to: &[Particle]) -> Vec<Pair> {
    let mut pairs = Vec::with_capacity(from.len().max(to.len()));
    let numbers = |particles: &[Particle]| (0..particles.len()).collect::<Vec<_>>();
    halve([from, to], [&mut numbers(from), &mut numbers(to)], &mut pairs);
    let mut moved: Vec<usize> = (0..pairs.len()).filter(|&index| pairs[index].kind == Kind::Moved).collect();
    for _ in 0..ROUNDS {
        if !swap_neighbours([from, to], &mut pairs, &moved) {
            break;
        }
        moved.reverse();
    }
    let same = |index| Pair { from: index, to: index, kind: Kind::Moved };
    let by_number = || (0..from.len()).map(same);
    let all =
        |pairs: &mut dyn Iterator<Item = Pair>| -> f64 { pairs.map(|pair| way([from, to], pair)).sum() };
    if from.len() == to.len() && all(&mut by_number()) <= all(&mut pairs.iter().copied()) {
        return by_number().collect();
    }
    pairs
}

/// What a pair costs: the square of the way, and of how much the radius changes.
fn way([from, to]: [&[Particle]; 2], pair: Pair) -> f64 {
    let (from, to) = (from[pair.from], to[pair.to]);
    let grown = f64::from(from.radius - to.radius);
    f64::from(Vec3::from(from.center).distance_squared(to.center.into())) + grown * grown
}

fn halve(sets: [&[Particle]; 2], [from, to]: [&mut [usize]; 2], pairs: &mut Vec<Pair>) {
    if from.is_empty() || to.is_empty() {
        return;
    }
    if from.len() == 1 || to.len() == 1 {
        meet(sets, [from, to], pairs);
        return;
    }
    let axis = longest_axis(sets, [from, to]);
    for (set, numbers) in [(sets[0], &mut *from), (sets[1], &mut *to)] {
        let place = |number: &usize| set[*number].center[axis];
        numbers.sort_unstable_by(|a, b| place(a).total_cmp(&place(b)).then(a.cmp(b)));
    }
    // The smaller set in halves, the larger in the same shares; either half of either has somebody.
    let share = |len: usize, of: usize, half: usize| (len * half + of / 2) / of;
    let halves = if from.len() <= to.len() {
        let half = from.len() / 2;
        [half, share(to.len(), from.len(), half)]
    } else {
        let half = to.len() / 2;
        [share(from.len(), to.len(), half), half]
    };
    let (from_low, from_high) = from.split_at_mut(halves[0]);
    let (to_low, to_high) = to.split_at_mut(halves[1]);
    halve(sets, [from_low, to_low], pairs);
    halve(sets, [from_high, to_high], pairs);
}

/// The axis along which the two sets together extend farthest.
fn longest_axis(sets: [&[Particle]; 2], numbers: [&[usize]; 2]) -> usize {
    let extent = |axis: usize| -> f32 {
        let of_set = |side: usize| {
            let places = numbers[side].iter().map(|&number| sets[side][number].center[axis]);
            let ends = places
                .fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)]);
            ends[1] - ends[0]
        };
        of_set(0) + of_set(1)
    };
    let extents = [0, 1, 2].map(extent);
    (0..3).fold(0, |best, axis| if extents[axis] > extents[best] { axis } else { best })
}

/// One particle meets some: it becomes the one for which the way is shortest, or that one becomes it.
fn meet(sets: [&[Particle]; 2], [from, to]: [&mut [usize]; 2], pairs: &mut Vec<Pair>) {
    let of = |from: usize, to: usize, kind: Kind| Pair { from, to, kind };
    let mut all: Vec<Pair> = if from.len() == 1 {
        to.iter().map(|&to| of(from[0], to, Kind::Born)).collect()
    } else {
        from.iter().map(|&from| of(from, to[0], Kind::Absorbed)).collect()
    };
    let shortest = (0..all.len()).min_by(|&a, &b| way(sets, all[a]).total_cmp(&way(sets, all[b])));
    if let Some(shortest) = shortest {
        all[shortest].kind = Kind::Moved;
    }
    pairs.extend(all);
}

/// Lets pairs that come after one another exchange their `to` where that shortens their ways; tells whether
/// any did. Only those that have nobody else depending on them.
fn swap_neighbours(sets: [&[Particle]; 2], pairs: &mut [Pair], moved: &[usize]) -> bool {
    let mut swapped = false;
    for (place, &a) in moved.iter().enumerate() {
        for &b in moved[place + 1..].iter().take(NEIGHBOURS) {
            let crossed = [Pair { to: pairs[b].to, ..pairs[a] }, Pair { to: pairs[a].to, ..pairs[b] }];
            let now = way(sets, pairs[a]) + way(sets, pairs[b]);
            if way(sets, crossed[0]) + way(sets, crossed[1]) < now {
                [pairs[a], pairs[b]] = crossed;
                swapped = true;
            }
        }
    }
    swapped
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Any numbers from 0 to 1, from a seed.
    fn cloud(count: usize, seed: u32) -> Vec<Particle> {
        let mut state = seed;
        let mut random = || {
            state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
            (state >> 8) as f32 / 16_777_216.0
        };
        (0..count)
            .map(|_| Particle { center: [random(), random(), random()], radius: 0.1 + random(), mass: 1.0 })
            .collect()
    }

    fn sum(from: &[Particle], to: &[Particle], pairs: &[Pair]) -> f64 {
        pairs.iter().map(|&pair| way([from, to], pair)).sum()
    }

    #[test]
    fn as_many_on_both_sides_are_a_permutation_no_dearer_than_by_number() {
        for count in [1, 2, 3, 10, 57, 400] {
            let (from, to) = (cloud(count, 1), cloud(count, 99));
            let pairs = pairs(&from, &to);
            let mut ends: [Vec<usize>; 2] =
                [pairs.iter().map(|pair| pair.from).collect(), pairs.iter().map(|pair| pair.to).collect()];
            ends.iter_mut().for_each(|numbers| numbers.sort_unstable());
            assert_eq!(ends, [(0..count).collect::<Vec<_>>(), (0..count).collect()]);
            assert!(pairs.iter().all(|pair| pair.kind == Kind::Moved));
            let by_number: Vec<_> =
                (0..count).map(|index| Pair { from: index, to: index, kind: Kind::Moved }).collect();
            let [paired, by_number] = [&pairs, &by_number].map(|pairs| sum(&from, &to, pairs));
            assert!(paired <= by_number);
            // Random partners are a third of the cube's side apart along each axis, near ones much less.
            assert!(count < 50 || paired < 0.55 * by_number, "{count}: {paired} of {by_number}");
        }
    }

    #[test]
    fn a_cloud_that_only_drifts_keeps_everybody() {
        let from = cloud(200, 7);
        let mut to: Vec<_> = from
            .iter()
            .map(|p| Particle { center: [p.center[0] + 50.0, p.center[1] - 3.0, p.center[2]], ..*p })
            .collect();
        to.rotate_left(31);
        for pair in pairs(&from, &to) {
            assert_eq!(pair.from, (pair.to + 31) % 200);
        }
    }

    #[test]
    fn unequal_sets_leave_nobody_alone() {
        for (few, many) in [(1, 9), (3, 10), (40, 1000), (999, 1000)] {
            for (from, to) in [(cloud(few, 5), cloud(many, 6)), (cloud(many, 5), cloud(few, 6))] {
                let pairs = pairs(&from, &to);
                assert_eq!(pairs.len(), many);
                let moved = pairs.iter().filter(|pair| pair.kind == Kind::Moved);
                assert_eq!(moved.count(), few);
                for number in 0..from.len() {
                    let moved = pairs.iter().filter(|p| p.from == number && p.kind == Kind::Moved);
                    assert!(moved.count() <= 1);
                    assert!(pairs.iter().any(|pair| pair.from == number));
                }
                for number in 0..to.len() {
                    assert!(pairs.iter().any(|pair| pair.to == number));
                }
            }
        }
        assert!(pairs(&[], &cloud(3, 1)).is_empty() && pairs(&cloud(3, 1), &[]).is_empty());
    }

    #[test]
    fn a_hundred_thousand_and_particles_at_one_place_take_no_time_to_speak_of() {
        let begin = std::time::Instant::now();
        assert_eq!(pairs(&cloud(100_000, 3), &cloud(70_000, 4)).len(), 100_000);
        let same = vec![Particle { center: [1.0; 3], radius: 1.0, mass: 1.0 }; 20_000];
        assert_eq!(pairs(&same, &same).len(), 20_000);
        assert!(begin.elapsed().as_secs() < 30, "it took {:?}", begin.elapsed());
    }
}
