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
