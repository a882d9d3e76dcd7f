//! Which frame is to be seen: playing, pausing and scrubbing, whatever the display's rate.

/// Whether frames are left out where they come too slowly.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub(crate) enum Pacing {
    /// Playing keeps the scene's own speed, and leaves out frames where the machine is too slow.
    #[default]
    RealTime,
    /// Every frame is shown, however long it takes.
    EveryFrame,
}

/// The time that the view is at.
#[derive(Clone, Debug)]
pub(crate) struct Clock {
    pub(crate) playing: bool,
    pub(crate) looping: bool,
    pub(crate) pacing: Pacing,
    /// The first and the last frame.
    range: [u32; 2],
    fps: f32,
    /// In frames; the fraction says how near the next one is.
    at: f64,
}

impl Default for Clock {
    fn default() -> Self {
        let pacing = Pacing::default();
        Self { playing: false, looping: true, pacing, range: [0, 0], fps: 24.0, at: 0.0 }
    }
}

impl Clock {
    /// At the first frame, and at rest.
    pub(crate) fn new(pacing: Pacing) -> Self {
        Self { pacing, ..Self::default() }
    }

    /// Goes by the scene's frames from now on.
    pub(crate) fn set(&mut self, time: &fumetto_scene::Time) {
        (self.range, self.fps) = (time.frames, time.fps);
        self.at = self.at.clamp(time.frames[0].into(), f64::from(time.frames[1]) + 0.999);
    }

    pub(crate) fn range(&self) -> [u32; 2] {
        self.range
    }

    pub(crate) fn fps(&self) -> f32 {
        self.fps
    }

    pub(crate) fn frame(&self) -> u32 {
        self.at as u32
    }

    /// Goes to a frame, or to the nearest there is.
    pub(crate) fn seek(&mut self, frame: u32) {
        self.at = frame.clamp(self.range[0], self.range[1]).into();
    }

    /// Plays or pauses; a single frame cannot be played.
    pub(crate) fn toggle(&mut self) {
        self.playing = !self.playing && self.range[0] < self.range[1];
    }

    /// By so many frames, and stops there.
    pub(crate) fn step(&mut self, frames: i64) {
        self.playing = false;
        let frame = (i64::from(self.frame()) + frames).max(0);
        self.seek(u32::try_from(frame).unwrap_or(u32::MAX));
    }

    /// Lets `secs` pass; `shown` is the frame that is on the screen by now.
    pub(crate) fn tick(&mut self, secs: f32, shown: Option<u32>) {
        if !self.playing {
            return;
        }
        let first = f64::from(self.range[0]);
        let length = f64::from(self.range[1]) + 1.0 - first;
        let gone = f64::from(secs) * f64::from(self.fps);
        self.at += match self.pacing {
            Pacing::RealTime => gone,
            Pacing::EveryFrame if shown == Some(self.frame()) => gone.min(1.0),
            Pacing::EveryFrame => 0.0,
        };
        if self.at >= first + length {
            if self.looping {
                self.at = first + (self.at - first) % length;
            } else {
                self.at = self.range[1].into();
                self.playing = false;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn clock(pacing: Pacing) -> Clock {
        let mut clock = Clock { playing: true, pacing, ..Clock::default() };
        clock.set(&fumetto_scene::Time { fps: 10.0, frames: [0, 9], hold: 1, substeps: 1, pre_roll: 0.0 });
        clock
    }

    #[test]
    fn a_fast_display_plays_no_faster() {
        let (mut slow, mut fast) = (clock(Pacing::RealTime), clock(Pacing::RealTime));
        (0..5).for_each(|_| slow.tick(0.1, None));
        (0..50).for_each(|_| fast.tick(0.0101, None));
        assert_eq!((slow.frame(), fast.frame()), (5, 5));
    }

    #[test]
    fn playing_goes_round_or_stops_at_the_end() {
        let mut clock = clock(Pacing::RealTime);
        clock.tick(1.2, None);
        assert_eq!((clock.frame(), clock.playing), (2, true));
        clock.looping = false;
        clock.tick(1.2, None);
        assert_eq!((clock.frame(), clock.playing), (9, false));
    }

    #[test]
    fn every_frame_waits_for_its_picture() {
        let mut clock = clock(Pacing::EveryFrame);
        clock.tick(0.1, Some(0));
        clock.tick(5.0, Some(0));
        assert_eq!(clock.frame(), 1, "frame 1 is not shown yet");
        clock.tick(5.0, Some(1));
        assert_eq!(clock.frame(), 2, "at most one at a time");
    }

    #[test]
    fn a_shorter_scene_keeps_the_time_in_range() {
        let mut clock = clock(Pacing::RealTime);
        clock.seek(9);
        clock.set(&fumetto_scene::Time { fps: 10.0, frames: [2, 4], hold: 1, substeps: 1, pre_roll: 0.0 });
        assert_eq!(clock.frame(), 4);
        clock.step(-9);
        assert_eq!((clock.frame(), clock.playing), (2, false));
    }
}
