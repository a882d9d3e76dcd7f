use std::ops::Range;

/// Pieces of a text to be replaced, all of them places in the text as it was.
#[derive(Clone, Debug, Default)]
pub(super) struct Splices {
    all: Vec<(Range<usize>, String)>,
}

impl Splices {
    /// Puts `text` in the place of `range`.
    pub(super) fn replace(&mut self, range: Range<usize>, text: impl Into<String>) {
        self.all.push((range, text.into()));
    }

    /// Puts `text` before byte `at`. What is put to the same place comes in the order of the calls.
    pub(super) fn insert(&mut self, at: usize, text: impl Into<String>) {
        self.replace(at..at, text);
    }

    /// Takes `range` away.
    pub(super) fn remove(&mut self, range: Range<usize>) {
        self.replace(range, "");
    }

    /// The text with all of this done. Line breaks are as the text's own.
    pub(super) fn apply(mut self, text: &str) -> String {
        let windows = text.contains("\r\n");
        self.all.sort_by_key(|(range, _)| (range.start, range.end));
        let mut done = String::with_capacity(text.len());
        let mut at = 0;
        for (range, new) in self.all {
            done.push_str(text.get(at..range.start).unwrap_or_default());
            if windows {
                done.push_str(&new.replace("\r\n", "\n").replace('\n', "\r\n"));
            } else {
                done.push_str(&new);
            }
            at = at.max(range.end);
        }
        done.push_str(text.get(at..).unwrap_or_default());
        done
    }
}
