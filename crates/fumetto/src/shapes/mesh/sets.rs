//! Disjoint sets (union by lowest number, path halving).

/// Disjoint sets of numbers.
pub(super) struct Sets(Vec<usize>);

impl Sets {
    pub(super) fn new(count: usize) -> Self {
        Self((0..count).collect())
    }

    /// The lowest number of a set; halves the way to it for the next time.
    pub(super) fn find(&mut self, mut number: usize) -> usize {
        while self.0[number] != number {
            self.0[number] = self.0[self.0[number]];
            number = self.0[number];
        }
        number
    }

    /// Makes one set of those that `numbers` are in.
    pub(super) fn join_all(&mut self, numbers: impl Iterator<Item = usize>) {
        let mut last = None;
        for number in numbers {
            let (a, b) = (self.find(number), self.find(last.unwrap_or(number)));
            self.0[a.max(b)] = a.min(b);
            last = Some(number);
        }
    }
}
