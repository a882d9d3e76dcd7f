//! Taking times.

use std::time::{Duration, Instant};

/// How often to measure.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Budget {
    fewest: usize,
    most: usize,
    /// No new round begins after this, once there are the fewest.
    time: Duration,
}

impl Budget {
    /// For figures that are published. Seven rounds survive three hiccups; eight seconds a size keep a full
    /// run to some minutes.
    pub(crate) const FULL: Self = Self { fewest: 7, most: 51, time: Duration::from_secs(8) };
    /// To see that everything works.
    pub(crate) const QUICK: Self = Self { fewest: 3, most: 3, time: Duration::ZERO };

    fn allows(&self, rounds: usize, taken: Duration) -> bool {
        rounds < self.fewest || (rounds < self.most && taken < self.time)
    }
}

/// The times of one variant at one size.
#[derive(Clone, Debug, Default)]
pub(crate) struct Samples {
    sorted_ms: Vec<f64>,
    /// What came of it, where that is told.
    pub(crate) made: Option<Made>,
    /// Share of lines that changes from frame to frame for no reason, where that is told: see `flicker.rs`.
    pub(crate) flicker: Option<f64>,
}

/// What came of the work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Made {
    pub(crate) triangles: u32,
    /// Of graphics memory that was kept for it.
    pub(crate) bytes: u64,
}

impl Samples {
    pub(crate) fn add(&mut self, time: Duration) {
        let ms = time.as_secs_f64() * 1e3;
        let place = self.sorted_ms.partition_point(|other| *other < ms);
        self.sorted_ms.insert(place, ms);
    }

    /// The middle one, so that a hiccup of the machine does not count; of two middle ones the upper.
    ///
    /// # Panics
    /// When no time was taken.
    pub(crate) fn median_ms(&self) -> f64 {
        self.sorted_ms[self.sorted_ms.len() / 2]
    }

    /// The fastest: what the work takes when nothing else disturbs it.
    ///
    /// # Panics
    /// When no time was taken.
    pub(crate) fn min_ms(&self) -> f64 {
        self.sorted_ms[0]
    }

    pub(crate) fn runs(&self) -> usize {
        self.sorted_ms.len()
    }
}

/// Times all cases in turn, round by round, so that whatever else the machine does hits all alike.
pub(crate) fn rounds<Case>(
    cases: &mut [Case],
    budget: Budget,
    mut time: impl FnMut(&mut Case) -> anyhow::Result<Duration>,
) -> anyhow::Result<Vec<Samples>> {
    let mut samples = vec![Samples::default(); cases.len()];
    let begin = Instant::now();
    let mut done = 0;
    while budget.allows(done, begin.elapsed()) {
        for (case, samples) in cases.iter_mut().zip(&mut samples) {
            samples.add(time(case)?);
        }
        done += 1;
    }
    Ok(samples)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

    use super::*;

    #[test]
    fn the_median_forgives_a_hiccup() {
        let mut samples = Samples::default();
        for ms in [30, 10, 9000, 20, 40] {
            samples.add(Duration::from_millis(ms));
        }
        assert_eq!((samples.median_ms(), samples.min_ms(), samples.runs()), (30.0, 10.0, 5));
    }

    #[test]
    fn every_round_times_all_cases_in_turn() {
        let mut order = Vec::new();
        let samples = rounds(&mut ['a', 'b'], Budget::QUICK, |case| {
            order.push(*case);
            Ok(Duration::from_millis(1))
        });
        assert_eq!(order.iter().collect::<String>(), "ababab");
        assert!(samples.unwrap().iter().all(|samples| samples.runs() == 3));
    }

    #[test]
    fn a_slow_case_gets_the_fewest_rounds_and_a_quick_one_the_most() {
        let budget = Budget { fewest: 2, most: 5, time: Duration::from_secs(1) };
        let (soon, late) = (Duration::ZERO, Duration::from_secs(2));
        assert!(budget.allows(1, late) && !budget.allows(2, late));
        assert!(budget.allows(4, soon) && !budget.allows(5, soon));
    }
}
