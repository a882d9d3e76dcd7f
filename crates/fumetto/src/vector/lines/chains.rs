//! Pieces that share an end, one after the other.

use glam::Vec3;
use rustc_hash::FxHashMap;

use super::segments::Segment;

/// Where more than two pieces of a line meet, two go on as one if they turn by less than this: the cosine of 40
/// degrees.
const GOES_ON: f32 = 0.766;

/// Connected pieces of lines of one object and kind.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Chain {
    /// Numbers of segments, and whether each is passed from its end to its start.
    pub(crate) links: Vec<(usize, bool)>,
    /// Whether it ends where it begins.
    pub(crate) is_closed: bool,
}

/// How many segments end at each place.
pub(crate) struct Joints {
    ends: FxHashMap<[u32; 3], u32>,
}

impl Joints {
    pub(crate) fn new(segments: &[Segment]) -> Self {
        let mut ends = FxHashMap::default();
        for end in segments.iter().flat_map(|segment| segment.ends) {
            *ends.entry(bits(end)).or_default() += 1;
        }
        Self { ends }
    }

    /// Whether a chain touches no other at its ends.
    pub(crate) fn is_alone(&self, chain: &Chain, segments: &[Segment]) -> bool {
        let (first, last) = (chain.links[0], chain.links[chain.links.len() - 1]);
        let outer = [(first.0, usize::from(first.1)), (last.0, usize::from(!last.1))];
        let is_free =
            |(number, end): (usize, usize)| self.ends.get(&bits(segments[number].ends[end])) == Some(&1);
        chain.is_closed || outer.into_iter().all(is_free)
    }
}

/// What tells a place. Adding 0 makes one of the two zeros.
fn bits(place: Vec3) -> [u32; 3] {
    place.to_array().map(|along| (along + 0.0).to_bits())
}

/// An end of a segment: twice its number, and 1 of its last.
type End = usize;

/// All segments in chains, each in one.
pub(crate) fn chains(segments: &[Segment]) -> Vec<Chain> {
    let partners = partners(segments);
    let mut is_done = vec![false; segments.len()];
    let mut chains = Vec::new();
    // First those that end somewhere, from there.
    let ends = (0..2 * segments.len()).filter(|&end| partners[end].is_none());
    for end in ends.chain((0..segments.len()).map(|number| 2 * number)) {
        if !is_done[end / 2] {
            chains.push(follow(end, &partners, &mut is_done));
        }
    }
    chains
}

fn follow(start: End, partners: &[Option<End>], is_done: &mut [bool]) -> Chain {
    let mut chain = Chain::default();
    let mut at = start;
    loop {
        is_done[at / 2] = true;
        chain.links.push((at / 2, at % 2 == 1));
        match partners[at ^ 1] {
            Some(next) if next == start => {
                chain.is_closed = true;
                return chain;
            }
            Some(next) if !is_done[next / 2] => at = next,
            _ => return chain,
        }
    }
}

/// For each end the one with which the line goes on.
fn partners(segments: &[Segment]) -> Vec<Option<End>> {
    let mut meeting: FxHashMap<_, Vec<End>> = FxHashMap::default();
    let mut order = Vec::new();
    for (number, segment) in segments.iter().enumerate() {
        for last in 0..2 {
            let key = (segment.object, segment.kind as u32, bits(segment.ends[last]));
            let ends = meeting.entry(key).or_default();
            if ends.is_empty() {
                order.push(key);
            }
            ends.push(2 * number + last);
        }
    }
    let mut partners = vec![None; 2 * segments.len()];
    for key in order {
        let Some(mut open) = meeting.remove(&key) else { continue };
        if let [a, b] = open[..] {
            (partners[a], partners[b]) = (Some(b), Some(a));
            continue;
        }
        while let Some((a, b)) = straightest(segments, &open) {
            (partners[a], partners[b]) = (Some(b), Some(a));
            open.retain(|&end| end != a && end != b);
        }
    }
    partners
}

/// The two ends between which a line turns the least, if that is little.
fn straightest(segments: &[Segment], open: &[End]) -> Option<(End, End)> {
    // More than these meet where a model is broken.
    let open = &open[..open.len().min(16)];
    let outward = |end: End| -> Vec3 {
        let [start, last] = segments[end / 2].ends;
        let along = (last - start).normalize_or_zero();
        if end.is_multiple_of(2) { along } else { -along }
    };
    let pairs = open.iter().enumerate().flat_map(|(at, &a)| open[at + 1..].iter().map(move |&b| (a, b)));
    let turned = pairs.filter(|(a, b)| a / 2 != b / 2).map(|(a, b)| (-outward(a).dot(outward(b)), a, b));
    let best = turned.filter(|(goes_on, ..)| *goes_on > GOES_ON).max_by(|a, b| a.0.total_cmp(&b.0));
    best.map(|(_, a, b)| (a, b))
}

#[cfg(test)]
mod tests {
    use fumetto_scene::EdgeKind;

    use super::*;

    fn segments(ends: &[[[f32; 2]; 2]]) -> Vec<Segment> {
        let place = |[x, y]: [f32; 2]| Vec3::new(x, y, 0.0);
        let segment = |ends: &[[f32; 2]; 2]| Segment {
            ends: ends.map(place),
            lit: [0.0; 2],
            object: 0,
            kind: EdgeKind::Crease,
            is_behind: false,
            slack: 0.0,
            sheet: 0,
        };
        ends.iter().map(segment).collect()
    }

    #[test]
    fn pieces_go_on_whichever_way_they_point() {
        let found = chains(&segments(&[
            [[0.0, 0.0], [1.0, 0.0]],
            [[2.0, 1.0], [1.0, 0.0]],
            [[2.0, 1.0], [3.0, 1.0]],
        ]));
        assert_eq!(found, [Chain { links: vec![(0, false), (1, true), (2, false)], is_closed: false }]);
    }

    #[test]
    fn rings_close() {
        let found = chains(&segments(&[
            [[0.0, 0.0], [1.0, 0.0]],
            [[0.0, 1.0], [1.0, 0.0]],
            [[0.0, 1.0], [0.0, 0.0]],
        ]));
        assert_eq!(found.len(), 1);
        assert!(found[0].is_closed && found[0].links.len() == 3);
    }

    #[test]
    fn where_three_meet_the_straight_one_goes_on() {
        let tee = [[[-1.0, 0.0], [0.0, 0.0]], [[0.0, 0.0], [1.0, 0.0]], [[0.0, 0.0], [0.0, 1.0]]];
        let mut lengths: Vec<usize> = chains(&segments(&tee)).iter().map(|chain| chain.links.len()).collect();
        lengths.sort_unstable();
        assert_eq!(lengths, [1, 2]);
    }
}
