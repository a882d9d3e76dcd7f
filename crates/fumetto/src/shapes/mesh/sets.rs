//! Disjoint sets (union by lowest number, path halving).

/// Disjoint sets of numbers.
#[derive(Debug, Default)]
pub(crate) struct Sets(Vec<usize>);

impl Sets {
    pub(crate) fn new(count: usize) -> Self {
        Self((0..count).collect())
    }

    /// One more number, in a set of its own.
    pub(crate) fn add(&mut self) -> usize {
        self.0.push(self.0.len());
        self.0.len() - 1
    }

    /// The lowest number of a set; halves the way to it for the next time.
    pub(crate) fn find(&mut self, mut number: usize) -> usize {
        while self.0[number] != number {
            self.0[number] = self.0[self.0[number]];
            number = self.0[number];
        }
        number
    }

    /// Makes one set of those that the two are in.
    pub(crate) fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.find(a), self.find(b));
        self.0[a.max(b)] = a.min(b);
    }

    /// Makes one set of those that `numbers` are in.
    pub(super) fn join_all(&mut self, numbers: impl Iterator<Item = usize>) {
        let mut last = None;
        for number in numbers {
            self.join(number, last.unwrap_or(number));
            last = Some(number);
        }
    }
}
