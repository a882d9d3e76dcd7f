//! Values between key frames.

use std::sync::Arc;

use glam::{Quat, Vec4};

/// How a curve goes from key to key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Interpolation {
    /// It stays until the next key.
    Step,
    /// It goes straight, or along the shortest turn.
    Linear,
    /// It follows a cubic with given tangents.
    CubicSpline,
}

/// Values over time.
#[derive(Clone, Debug)]
pub(super) struct Curve {
    /// Seconds, each after the one before; at least one.
    pub(super) times_secs: Arc<[f32]>,
    /// A value each; for splines, three each: the tangent before it, the value, the tangent after it.
    pub(super) values: Arc<[Vec4]>,
    pub(super) interpolation: Interpolation,
}

impl Curve {
    /// The value at a time; before the first key and after the last one it stays.
    pub(super) fn at(&self, time_secs: f32) -> Vec4 {
        self.between(time_secs, Vec4::lerp)
    }

    /// The same for turns, whose values are quaternions.
    pub(super) fn rotation_at(&self, time_secs: f32) -> Quat {
        let turn = |value: Vec4| Quat::from_vec4(value.normalize_or(Vec4::W));
        turn(self.between(time_secs, |from, to, share| turn(from).slerp(turn(to), share).into()))
    }

    fn between(&self, time_secs: f32, linear: impl Fn(Vec4, Vec4, f32) -> Vec4) -> Vec4 {
        let last = self.times_secs.len() - 1;
        let next = self.times_secs.partition_point(|&key| key <= time_secs);
        if next == 0 {
            return self.value(0);
        }
        let key = next - 1;
        if key == last {
            return self.value(last);
        }
        let span_secs = self.times_secs[next] - self.times_secs[key];
        let share = (time_secs - self.times_secs[key]) / span_secs;
        match self.interpolation {
            Interpolation::Step => self.value(key),
            Interpolation::Linear => linear(self.value(key), self.value(next), share),
            Interpolation::CubicSpline => self.spline(key, share, span_secs),
        }
    }

    fn value(&self, key: usize) -> Vec4 {
        match self.interpolation {
            Interpolation::CubicSpline => self.values[3 * key + 1],
            _ => self.values[key],
        }
    }

    /// The Hermite spline of glTF 2.0, appendix C.4.
    fn spline(&self, key: usize, t: f32, span_secs: f32) -> Vec4 {
        let leaving = span_secs * self.values[3 * key + 2];
        let arriving = span_secs * self.values[3 * (key + 1)];
        let (t2, t3) = (t * t, t * t * t);
        (2.0 * t3 - 3.0 * t2 + 1.0) * self.value(key)
            + (t3 - 2.0 * t2 + t) * leaving
            + (3.0 * t2 - 2.0 * t3) * self.value(key + 1)
            + (t3 - t2) * arriving
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(interpolation: Interpolation, values: &[f32]) -> Curve {
        let values = values.iter().map(|&value| Vec4::splat(value)).collect();
        Curve { times_secs: [1.0, 3.0].into(), values, interpolation }
    }

    #[test]
    fn steps_and_lines_pass_through_their_keys() {
        let step = curve(Interpolation::Step, &[5.0, 7.0]);
        let line = curve(Interpolation::Linear, &[5.0, 7.0]);
        for (time, stepped, straight) in
            [(0.0, 5.0, 5.0), (1.0, 5.0, 5.0), (2.5, 5.0, 6.5), (3.0, 7.0, 7.0), (9.0, 7.0, 7.0)]
        {
            assert_eq!(step.at(time).x, stepped, "{time}");
            assert_eq!(line.at(time).x, straight, "{time}");
        }
    }

    #[test]
    fn a_spline_is_the_cubic_that_its_tangents_ask_for() {
        // x = t³ over [1, 3]: values 1 and 27, tangents 3 and 27.
        let cubic = curve(Interpolation::CubicSpline, &[0.0, 1.0, 3.0, 27.0, 27.0, 0.0]);
        for time in [1.0_f32, 1.5, 2.0, 2.75, 3.0] {
            assert!((cubic.at(time).x - time.powi(3)).abs() < 1e-4, "{time}");
        }
    }

    #[test]
    fn turns_take_the_shorter_way_at_an_even_pace() {
        let from = Quat::from_rotation_y(0.2);
        let to = -Quat::from_rotation_y(1.4);
        let values = [Vec4::from(from), Vec4::from(to)].into();
        let curve = Curve { times_secs: [0.0, 1.0].into(), values, interpolation: Interpolation::Linear };
        assert!(curve.rotation_at(0.25).angle_between(Quat::from_rotation_y(0.5)) < 1e-3);
    }
}
