/// A value that changes over a particle's life, linear between its points.
///
/// Before the first point and after the last the value stays.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// `[age, value]` pairs: at least one, ages from 0 (birth) to 1 (death) and rising.
    pub points: Vec<[f32; 2]>,
}

impl Curve {
    /// The same value for the whole of life.
    #[must_use]
    pub fn constant(value: f32) -> Self {
        Self { points: vec![[0.0, value]] }
    }

    /// The largest value that it has.
    #[must_use]
    pub fn largest(&self) -> f32 {
        self.points.iter().map(|&[_, value]| value).fold(0.0, f32::max)
    }

    /// The mean value over life.
    #[must_use]
    pub fn mean(&self) -> f32 {
        let [Some(&first), Some(&last)] = [self.points.first(), self.points.last()] else { return 0.0 };
        let between = self.points.windows(2).map(|pair| {
            let [[age0, value0], [age1, value1]] = [pair[0], pair[1]];
            0.5 * (value0 + value1) * (age1 - age0)
        });
        first[0] * first[1] + between.sum::<f32>() + (1.0 - last[0]) * last[1]
    }

    /// The value at `age`, from 0 to 1.
    #[must_use]
    pub fn at(&self, age: f32) -> f32 {
        let after = self.points.partition_point(|point| point[0] <= age);
        match (after.checked_sub(1).map(|i| self.points[i]), self.points.get(after)) {
            (Some([age0, value0]), Some(&[age1, value1])) => {
                value0 + (value1 - value0) * (age - age0) / (age1 - age0)
            }
            (Some([_, value]), None) | (None, Some(&[_, value])) => value,
            (None, None) => unreachable!("a curve has at least one point"),
        }
    }
}
