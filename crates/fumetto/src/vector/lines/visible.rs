//! Chains cut where they come into sight and go out of it.

use std::ops::Range;

use super::{
    chains::Chain,
    hidden::{Hidden, Piece},
    segments::Segment,
    sight::{Sight, Spot},
};

/// A line on the picture, all of it in sight or all hidden.
#[derive(Clone, Debug)]
pub(crate) struct Run {
    pub(crate) stops: Vec<Stop>,
    pub(crate) is_closed: bool,
    pub(crate) is_hidden: bool,
}

/// A place on a line.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stop {
    pub(crate) spot: Spot,
    /// Share of the first light that falls on the surface.
    pub(crate) lit: f32,
}

/// All of what a view has of its lines.
pub(crate) struct View<'a> {
    pub(crate) sight: &'a Sight,
    pub(crate) segments: &'a [Segment],
    /// Each segment's, as far as it is in front of the camera.
    pub(crate) pieces: &'a [Piece],
    /// What triangles hide of pieces, sorted.
    pub(crate) hidden: &'a [Hidden],
    /// Whether something that is no triangle stands before a spot.
    pub(crate) covered: &'a (dyn Fn(Spot) -> bool + Sync),
    /// Whether a segment is not drawn for the light on it.
    pub(crate) is_gone: &'a (dyn Fn(&Segment) -> bool + Sync),
}

/// Part of a chain by its length on the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Span {
    from: f32,
    to: f32,
    is_hidden: bool,
}

/// Pixels between places at which it is asked what covers a line.
const COVER_STEP_PX: f32 = 1.0;

impl View<'_> {
    /// The runs of a chain, from its start to its end. Pieces in sight that are shorter than `line_px` are not
    /// drawn, and gaps that are shorter than `gap_px` are drawn over.
    pub(crate) fn runs(&self, chain: &Chain, line_px: f32, gap_px: f32) -> Vec<Run> {
        let (stops, lengths, mut dark) = self.walk(chain);
        let Some(&length) = lengths.last() else { return Vec::new() };
        dark.sort_by(|a, b| a.start.total_cmp(&b.start));
        if length < line_px {
            return Vec::new();
        }
        let spans = cleaned(spans(&dark, length), [line_px, gap_px], chain.is_closed);
        let run = |spans: &[Span], is_closed: bool| {
            let mut found = Vec::new();
            for span in spans {
                let part = part(&stops, &lengths, *span);
                let skip = usize::from(!found.is_empty());
                found.extend(part.into_iter().skip(skip));
            }
            Run { stops: found, is_closed, is_hidden: spans[0].is_hidden }
        };
        match spans[..] {
            [only] => vec![run(&[only], chain.is_closed)],
            // What is cut only because the chain begins somewhere is one.
            [first, .., last] if chain.is_closed && first.is_hidden == last.is_hidden => {
                let inner = spans[1..spans.len() - 1].iter().map(|span| run(&[*span], false));
                inner.chain([run(&[last, first], false)]).collect()
            }
            _ => spans.iter().map(|span| run(&[*span], false)).collect(),
        }
    }

    /// A chain's places, their distances from the start along it, and what of it is hidden.
    fn walk(&self, chain: &Chain) -> (Vec<Stop>, Vec<f32>, Vec<Range<f32>>) {
        let mut stops: Vec<Stop> = Vec::with_capacity(chain.links.len() + 1);
        let mut lengths: Vec<f32> = Vec::with_capacity(chain.links.len() + 1);
        let mut dark: Vec<Range<f32>> = Vec::new();
        for &(number, is_reversed) in &chain.links {
            let (segment, piece) = (&self.segments[number], &self.pieces[number]);
            let order = if is_reversed { [1, 0] } else { [0, 1] };
            let [start, end] = order.map(|end| Stop { spot: piece.spots[end], lit: segment.lit[end] });
            let before = lengths.last().copied().unwrap_or(0.0);
            let length = (end.spot.x - start.spot.x).hypot(end.spot.y - start.spot.y);
            if stops.is_empty() {
                stops.push(start);
                lengths.push(0.0);
            }
            stops.push(end);
            lengths.push(before + length);
            let mut hide = |from: f32, to: f32| {
                let (from, to) = if is_reversed { (1.0 - to, 1.0 - from) } else { (from, to) };
                dark.push(before + from * length..before + to * length);
            };
            if segment.is_behind || (self.is_gone)(segment) {
                hide(0.0, 1.0);
                continue;
            }
            let first = self.hidden.partition_point(|hidden| (hidden.piece as usize) < number);
            let own = self.hidden[first..].iter().take_while(|hidden| hidden.piece as usize == number);
            own.for_each(|hidden| hide(hidden.from, hidden.to));
            self.beyond(piece).into_iter().for_each(|[from, to]| hide(from, to));
            self.cover(number, length, &mut hide);
        }
        (stops, lengths, dark)
    }

    /// What of a piece is beyond the picture.
    fn beyond(&self, piece: &Piece) -> Vec<[f32; 2]> {
        let [start, end] = piece.spots;
        let [width, height] = self.sight.size_px;
        let mut range = [0.0_f32, 1.0_f32];
        for (from, to) in [
            (start.x, end.x),
            (width - start.x, width - end.x),
            (start.y, end.y),
            (height - start.y, height - end.y),
        ] {
            match (from >= 0.0, to >= 0.0) {
                (true, true) => {}
                (true, false) => range[1] = range[1].min(from / (from - to)),
                (false, true) => range[0] = range[0].max(from / (from - to)),
                (false, false) => return vec![[0.0, 1.0]],
            }
        }
        if range[0] >= range[1] {
            return vec![[0.0, 1.0]];
        }
        [[0.0, range[0]], [range[1], 1.0]].into_iter().filter(|part| part[0] < part[1]).collect()
    }

    /// What puffs and volumes hide of a piece.
    fn cover(&self, number: usize, length: f32, hide: &mut impl FnMut(f32, f32)) {
        let [start, end] = self.pieces[number].spots;
        let steps = (length / COVER_STEP_PX).ceil().clamp(1.0, 8192.0) as u32;
        for step in 0..steps {
            let (from, to) = (step as f32 / steps as f32, (step + 1) as f32 / steps as f32);
            let share = 0.5 * (from + to);
            let mix = |a: f32, b: f32| a + share * (b - a);
            let spot =
                Spot { x: mix(start.x, end.x), y: mix(start.y, end.y), near: mix(start.near, end.near) };
            if (self.covered)(spot) {
                hide(from, to);
            }
        }
    }
}

/// Between two triangles side by side there is a slit, for lines along their sides are not hidden; in pixels.
const SLIT_PX: f32 = 0.1;

/// A length in spans that are in sight and hidden in turn; `dark` is sorted.
fn spans(dark: &[Range<f32>], length: f32) -> Vec<Span> {
    let mut spans: Vec<Span> = Vec::new();
    let mut at = 0.0;
    for hidden in dark {
        let slit = if spans.is_empty() { 0.0 } else { SLIT_PX };
        if hidden.start > at + slit {
            spans.push(Span { from: at, to: hidden.start, is_hidden: false });
            at = hidden.start;
        }
        if hidden.end > at {
            match spans.last_mut().filter(|last| last.is_hidden) {
                Some(last) => last.to = hidden.end,
                None => spans.push(Span { from: at, to: hidden.end, is_hidden: true }),
            }
            at = hidden.end;
        }
    }
    if at < length || spans.is_empty() {
        spans.push(Span { from: at, to: length, is_hidden: false });
    }
    spans
}

/// First bridges short gaps between what is in sight, then hides short pieces.
fn cleaned(spans: Vec<Span>, [line_px, gap_px]: [f32; 2], is_closed: bool) -> Vec<Span> {
    let spans = turned(spans, |span| span.is_hidden && span.to - span.from < gap_px, is_closed);
    turned(spans, |span| !span.is_hidden && span.to - span.from < line_px, is_closed)
}

/// Gives spans that are `short` to their neighbours. Those at the ends of an open chain have one, and those that have
/// none stay.
fn turned(mut spans: Vec<Span>, short: impl Fn(&Span) -> bool, is_closed: bool) -> Vec<Span> {
    let count = spans.len();
    if count < 2 {
        return spans;
    }
    // A closed chain's last and first may be parts of one.
    let is_split = is_closed && spans[0].is_hidden == spans[count - 1].is_hidden;
    let whole = |index: usize| {
        let Span { from, to, is_hidden } = spans[index];
        let other = if index == 0 { spans[count - 1] } else { spans[0] };
        let more = if is_split && (index == 0 || index + 1 == count) { other.to - other.from } else { 0.0 };
        Span { from, to: to + more, is_hidden }
    };
    let flips: Vec<bool> = (0..count).map(|index| short(&whole(index))).collect();
    for (span, flips) in spans.iter_mut().zip(flips) {
        span.is_hidden ^= flips;
    }
    let mut joined: Vec<Span> = Vec::with_capacity(count);
    for span in spans {
        match joined.last_mut().filter(|last| last.is_hidden == span.is_hidden) {
            Some(last) => last.to = span.to,
            None => joined.push(span),
        }
    }
    joined
}

/// The places of a span, its ends included.
fn part(stops: &[Stop], lengths: &[f32], span: Span) -> Vec<Stop> {
    let at = |length: f32| {
        let after = lengths.partition_point(|&known| known < length).clamp(1, stops.len() - 1);
        let (a, b) = (&stops[after - 1], &stops[after]);
        let share = (length - lengths[after - 1]) / (lengths[after] - lengths[after - 1]).max(1e-12);
        let share = share.clamp(0.0, 1.0);
        let mix = |a: f32, b: f32| a + share * (b - a);
        let spot = Spot {
            x: mix(a.spot.x, b.spot.x),
            y: mix(a.spot.y, b.spot.y),
            near: mix(a.spot.near, b.spot.near),
        };
        Stop { spot, lit: mix(a.lit, b.lit) }
    };
    let inner = stops.iter().zip(lengths).filter(|(_, length)| **length > span.from && **length < span.to);
    let inner = inner.map(|(stop, _)| *stop);
    std::iter::once(at(span.from)).chain(inner).chain([at(span.to)]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const LEAST: [f32; 2] = [3.0, 1.0];

    fn told(spans: &[Span]) -> Vec<(f32, bool)> {
        spans.iter().map(|span| (span.to, span.is_hidden)).collect()
    }

    #[test]
    fn overlapping_shadows_are_one() {
        let found = spans(&[1.0..3.0, 2.0..2.5, 2.9..4.0], 10.0);
        assert_eq!(told(&found), [(1.0, false), (4.0, true), (10.0, false)]);
    }

    #[test]
    fn short_gaps_are_bridged_and_crumbs_hidden() {
        let found = cleaned(spans(&[2.0..2.5, 5.0..8.0, 9.0..20.0], 30.0), LEAST, false);
        assert_eq!(told(&found), [(5.0, false), (20.0, true), (30.0, false)]);
    }

    #[test]
    fn a_ring_knows_no_beginning() {
        // Two pixels at the start and two at the end are four together.
        let found = cleaned(spans(&[2.0..8.0], 10.0), LEAST, true);
        assert_eq!(told(&found), [(2.0, false), (8.0, true), (10.0, false)]);
        let open = cleaned(spans(&[2.0..8.0], 10.0), LEAST, false);
        assert_eq!(told(&open), [(10.0, true)]);
    }
}
