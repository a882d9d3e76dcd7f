//! The points of a curve: how they are written, and how they come, go and move.

use fumetto_scene::edit::Value;

use super::curve::Axes;
use super::number::number_of;

/// The points of a curve, never none.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Points(pub(super) Vec<[f64; 2]>);

impl Points {
    pub(super) fn read(value: &Value) -> Option<Self> {
        let point = |point: &Value| Some([number_of(point.get(0)?)?, number_of(point.get(1)?)?]);
        let points: Option<Vec<_>> = value.as_array()?.iter().map(point).collect();
        points.filter(|points| !points.is_empty()).map(Self)
    }

    pub(super) fn write(&self) -> Value {
        let number = |number: &f64| Value::Float(f64::from(*number as f32));
        let point = |point: &[f64; 2]| Value::Array(point.iter().map(number).collect());
        Value::Array(self.0.iter().map(point).collect())
    }

    pub(super) fn nearest(&self, far: impl Fn([f64; 2]) -> f32) -> Option<(usize, f32)> {
        let all = self.0.iter().enumerate().map(|(i, point)| (i, far(*point)));
        all.min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// With point `i` elsewhere, but still between its neighbours.
    pub(super) fn moved(&self, i: usize, [x, y]: [f64; 2], axes: &Axes) -> Self {
        let mut points = self.0.clone();
        let gap = 1e-3;
        let from = if i == 0 { axes.x.min() } else { points[i - 1][0] + gap };
        let to = points.get(i + 1).map_or(axes.x.max(), |next| next[0] - gap);
        points[i] = [x.min(to).max(from), axes.y.clamped(y)];
        Self(points)
    }

    /// With another point; which it is.
    pub(super) fn with(&self, point: [f64; 2], axes: &Axes) -> (Self, usize) {
        let i = self.0.partition_point(|other| other[0] < point[0]);
        let mut points = self.0.clone();
        points.insert(i, point);
        (Self(points).moved(i, point, axes), i)
    }

    /// With another point half way to the next, or behind the last.
    pub(super) fn split(&self, i: usize, axes: &Axes) -> (Self, usize) {
        let [x, y] = self.0[i];
        let middle = match (self.0.get(i + 1), i.checked_sub(1)) {
            (Some(next), _) => [0.5 * (x + next[0]), 0.5 * (y + next[1])],
            (None, _) if axes.x.max() > 1.0 => [x + 1.0, y],
            (None, Some(last)) => [0.5 * (x + self.0[last][0]), 0.5 * (y + self.0[last][1])],
            (None, None) => [if x < 0.5 { 1.0 } else { 0.0 }, y],
        };
        self.with(middle, axes)
    }

    /// Without point `i`, unless it is the only one.
    pub(super) fn without(&self, i: usize) -> Option<Self> {
        let mut points = self.0.clone();
        points.remove(i);
        (!points.is_empty()).then_some(Self(points))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fumetto_scene::limits;

    const AXES: Axes = Axes { x: limits::SHARE, x_unit: "", y: limits::FACTOR, y_unit: "" };

    #[test]
    fn points_keep_their_order() {
        let points = Points(vec![[0.0, 1.0], [0.5, 2.0], [1.0, 0.0]]);
        let moved = points.moved(1, [3.0, -4.0], &AXES);
        assert!(moved.0[1][0] < 1.0 && moved.0[1][0] > 0.99);
        assert_eq!(moved.0[1][1], 0.0, "no factor is negative");
        let (more, i) = points.with([0.75, 1.0], &AXES);
        assert_eq!((i, more.0.len()), (2, 4));
        let (more, i) = points.split(2, &AXES);
        assert_eq!((i, more.0[2]), (2, [0.75, 1.0]));
        assert_eq!(Points(vec![[0.0, 1.0]]).without(0), None);
    }

    #[test]
    fn a_curve_is_read_as_it_is_written() {
        let point = |x: Value, y: Value| Value::Array(vec![x, y]);
        let value = Value::Array(vec![point(0.into(), 0.1.into()), point(1.0.into(), 2.into())]);
        let points = Points::read(&value).expect("points");
        assert_eq!(points.0, [[0.0, 0.1], [1.0, 2.0]]);
        assert_eq!(Points::read(&points.write()), Some(Points(vec![[0.0, f64::from(0.1_f32)], [1.0, 2.0]])));
    }
}
