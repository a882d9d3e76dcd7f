use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use web_time::Instant;

/// A picture that takes longer than this is drawn coarser while things move: pointer, menus and picture share one
/// device, and none may be behind the hand by more than a tenth of a second.
const LONGEST: Duration = Duration::from_millis(60);

/// One that takes less than this share of [`LONGEST`] may be drawn finer.
const EASY_SHARE: f64 = 0.4;

/// The coarsest picture has this many of its pixels behind one.
const COARSEST: u32 = 8;

/// How fine pictures may be so that they come in time, and whether the next may begin.
///
/// One picture at a time is under way. Whatever else is asked for meanwhile waits, so a slow picture never queues up
/// behind others.
#[derive(Debug)]
pub(crate) struct Pace {
    under_way: Option<UnderWay>,
    /// A pixel of the picture is as wide as this many of the screen.
    coarseness: u32,
    /// How long the last one took.
    took: Option<Duration>,
}

#[derive(Debug)]
struct UnderWay {
    since: Instant,
    done: Arc<AtomicBool>,
    /// Whether what it takes says how fine the next should be.
    counts: bool,
}

impl Default for Pace {
    /// Begins coarse: a weak machine should show something soon.
    fn default() -> Self {
        Self { under_way: None, coarseness: 2, took: None }
    }
}

impl Pace {
    /// Whether the device is free for another picture.
    pub(crate) fn is_free(&mut self) -> bool {
        let Some(under_way) = &self.under_way else { return true };
        if !under_way.done.load(Ordering::Acquire) {
            return false;
        }
        let took = under_way.since.elapsed();
        if under_way.counts {
            self.adapt(took);
        }
        self.took = Some(took);
        self.under_way = None;
        true
    }

    /// Whether a picture is under way.
    pub(crate) fn is_busy(&self) -> bool {
        self.under_way.is_some()
    }

    /// Another picture was handed to the queue; `wake` is called when it is done. What is drawn at `coarseness` 1
    /// without need tells nothing about what moves.
    pub(crate) fn begin(&mut self, queue: &wgpu::Queue, counts: bool, wake: impl FnOnce() + Send + 'static) {
        let done = Arc::new(AtomicBool::new(false));
        let under_way = UnderWay { since: Instant::now(), done: done.clone(), counts };
        self.under_way = Some(under_way);
        queue.on_submitted_work_done(move || {
            done.store(true, Ordering::Release);
            wake();
        });
    }

    fn adapt(&mut self, took: Duration) {
        if took > LONGEST {
            self.coarseness = (self.coarseness + 1).min(COARSEST);
        } else if took.as_secs_f64() < EASY_SHARE * LONGEST.as_secs_f64() {
            self.coarseness = (self.coarseness - 1).max(1);
        }
    }

    /// A pixel of a picture that moves should be as wide as this many of the screen.
    pub(crate) fn coarseness(&self) -> u32 {
        self.coarseness
    }

    /// How long the last picture took, with all that was asked for before it.
    pub(crate) fn took(&self) -> Option<Duration> {
        self.took
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slow_pictures_get_coarser_and_quick_ones_finer() {
        let mut pace = Pace::default();
        for _ in 0..20 {
            pace.adapt(Duration::from_millis(200));
        }
        assert_eq!(pace.coarseness(), COARSEST);
        pace.adapt(Duration::from_millis(40));
        assert_eq!(pace.coarseness(), COARSEST, "what is quick enough stays");
        for _ in 0..20 {
            pace.adapt(Duration::from_millis(5));
        }
        assert_eq!(pace.coarseness(), 1);
    }
}
