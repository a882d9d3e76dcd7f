//! When things are born: exact counts, from the clock alone.

use fumetto_scene::{Burst, Emitter};

/// When things are born.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Timetable<'a> {
    /// A second, while `active`.
    pub(crate) rate: f32,
    /// Seconds: from, until.
    pub(crate) active: [f32; 2],
    /// Many at once.
    pub(crate) bursts: &'a [Burst],
}

impl<'a> Timetable<'a> {
    /// Of an emitter's particles.
    pub(crate) fn of(emitter: &'a Emitter) -> Self {
        Self { rate: emitter.rate, active: emitter.active, bursts: &emitter.bursts }
    }
}

/// The births of one step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Births {
    /// Number of the first one, counted from the very first.
    pub(crate) first: u64,
    /// All of them.
    pub(crate) count: u64,
    /// Those that come at once; they are the first ones.
    pub(crate) burst: u64,
}

/// Births from `start` up to `end`, in seconds.
pub(crate) fn births_between(timetable: Timetable<'_>, start: f64, end: f64) -> Births {
    let burst = bursts_before(timetable, end) - bursts_before(timetable, start);
    let stream = stream_before(timetable, end) - stream_before(timetable, start);
    let first = bursts_before(timetable, start) + stream_before(timetable, start);
    Births { first, count: burst + stream, burst }
}

/// Births of the continuous stream before `time`.
fn stream_before(timetable: Timetable<'_>, time: f64) -> u64 {
    let [from, until] = timetable.active.map(f64::from);
    (f64::from(timetable.rate) * (time.min(until) - from).max(0.0)).floor() as u64
}

fn bursts_before(timetable: Timetable<'_>, time: f64) -> u64 {
    timetable
        .bursts
        .iter()
        .filter(|burst| f64::from(burst.at) < time)
        .map(|burst| u64::from(burst.count))
        .sum()
}

#[cfg(test)]
mod tests {
    use fumetto_scene::{Burst, Curve, EmitterShape, Source};

    use super::*;

    fn emitter() -> Emitter {
        Emitter {
            shape: EmitterShape::Point { center: [0.0; 3] },
            rate: 10.0,
            bursts: vec![Burst { at: 0.5, count: 7 }],
            count: None,
            active: [0.25, 2.25],
            velocity: [0.0; 3],
            spread_deg: 0.0,
            speed_jitter: 0.0,
            life: [1.0; 2],
            radius: [1.0; 2],
            mass: [1.0; 2],
            radius_over_life: Curve::constant(1.0),
            mass_over_life: Curve::constant(1.0),
            erosion_over_life: Curve::constant(0.0),
            opacity_over_life: Curve::constant(1.0),
            rings: None,
            source: Source { heat: 1.0, smoke: 1.0, expansion: 0.0, secs: 0.1 },
        }
    }

    #[test]
    fn steps_of_any_length_add_up_to_the_same_births() {
        let emitter = emitter();
        for steps in [1, 7, 24, 1000] {
            let mut next = 0;
            for step in 0..steps {
                let time = |step| 3.0 * f64::from(step) / f64::from(steps);
                let births = births_between(Timetable::of(&emitter), time(step), time(step + 1));
                assert_eq!(births.first, next, "births are numbered without gaps");
                next += births.count;
            }
            assert_eq!(next, 20 + 7, "10 a second for 2 seconds, and the burst");
        }
    }

    #[test]
    fn a_burst_comes_in_the_step_that_holds_its_moment() {
        let emitter = emitter();
        assert_eq!(births_between(Timetable::of(&emitter), 0.4, 0.5).burst, 0);
        assert_eq!(births_between(Timetable::of(&emitter), 0.5, 0.6).burst, 7);
    }

    #[test]
    fn nothing_is_born_while_the_emitter_is_not_active() {
        assert_eq!(births_between(Timetable::of(&emitter()), 0.0, 0.25).count, 0);
        assert_eq!(births_between(Timetable::of(&emitter()), 2.3, 9.0).count, 0);
    }
}
