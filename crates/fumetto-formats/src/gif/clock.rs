//! GIF counts hundredths of a second; most frame rates do not.

/// Fewest frames a second of a GIF: its delays end at 655 seconds.
pub const MIN_GIF_FPS: f32 = 0.01;

/// Most frames a second of a GIF: browsers show a delay below two hundredths as ten of them.
pub const MAX_GIF_FPS: f32 = 50.0;

/// Deals out delays so that every frame starts at the hundredth nearest to its time.
pub(super) struct Clock {
    hundredths_per_frame: f64,
    frames: u32,
}

impl Clock {
    /// A clock of `fps` frames a second, if GIF can keep it.
    pub(super) fn new(fps: f32) -> Option<Self> {
        (MIN_GIF_FPS..=MAX_GIF_FPS)
            .contains(&fps)
            .then(|| Self { hundredths_per_frame: 100.0 / f64::from(fps), frames: 0 })
    }

    /// The delay of the next frame.
    pub(super) fn tick(&mut self) -> u16 {
        let start = self.time();
        self.frames += 1;
        // At most 100 / MIN_GIF_FPS and a half.
        (self.time() - start) as u16
    }

    fn time(&self) -> f64 {
        (f64::from(self.frames) * self.hundredths_per_frame).round()
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]
    use super::*;

    fn delays(fps: f32, frames: usize) -> Vec<u16> {
        let mut clock = Clock::new(fps).unwrap();
        (0..frames).map(|_| clock.tick()).collect()
    }

    #[test]
    fn twenty_four_frames_take_a_second() {
        let delays = delays(24.0, 240);
        assert!(delays.iter().all(|delay| matches!(delay, 4 | 5)), "{delays:?}");
        for second in delays.chunks(24) {
            assert_eq!(second.iter().sum::<u16>(), 100);
        }
    }

    #[test]
    fn the_ends_of_the_range_fit() {
        assert_eq!(delays(MAX_GIF_FPS, 3), [2, 2, 2]);
        assert_eq!(delays(MIN_GIF_FPS, 2), [10_000, 10_000]);
    }

    #[test]
    fn impossible_rates_are_refused() {
        for fps in [0.0, -24.0, 60.0, f32::NAN, f32::INFINITY] {
            assert!(Clock::new(fps).is_none(), "{fps}");
        }
    }
}
