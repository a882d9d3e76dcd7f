//! What was done, so that it can be undone.

use std::collections::VecDeque;

use crate::limits::{MAX_HISTORY_BYTES, MAX_HISTORY_STEPS};

/// One piece of a text that became another.
#[derive(Clone, Debug, PartialEq)]
struct Patch {
    at: usize,
    old: String,
    new: String,
}

/// A patch with its name in menus.
#[derive(Clone, Debug)]
pub(super) struct Step {
    label: String,
    patch: Patch,
    /// Edits of the same gesture become one step.
    gesture: Option<String>,
}

/// Steps back and forth.
#[derive(Clone, Debug, Default)]
pub(super) struct History {
    done: VecDeque<Step>,
    undone: Vec<Step>,
    bytes: usize,
}

impl Patch {
    /// What lies between the first and the last letter that differ.
    fn between(old: &str, new: &str) -> Self {
        let same = |(a, b): &(u8, u8)| a == b;
        let mut start = old.bytes().zip(new.bytes()).take_while(same).count();
        while !old.is_char_boundary(start) || !new.is_char_boundary(start) {
            start -= 1;
        }
        let room = old.len().min(new.len()) - start;
        let mut tail = old.bytes().rev().zip(new.bytes().rev()).take(room).take_while(same).count();
        while !old.is_char_boundary(old.len() - tail) || !new.is_char_boundary(new.len() - tail) {
            tail -= 1;
        }
        let middle = |text: &str| text[start..text.len() - tail].to_owned();
        Self { at: start, old: middle(old), new: middle(new) }
    }

    fn forth(&self, text: &str) -> String {
        [&text[..self.at], &self.new, &text[self.at + self.old.len()..]].concat()
    }

    fn back(&self, text: &str) -> String {
        [&text[..self.at], &self.old, &text[self.at + self.new.len()..]].concat()
    }
}

impl Step {
    fn bytes(&self) -> usize {
        size_of::<Self>() + self.label.len() + self.patch.old.len() + self.patch.new.len()
    }
}

impl History {
    /// Notes that `old` became `new`. Forgets what was undone, and the oldest steps where there are too many.
    pub(super) fn add(&mut self, old: &str, new: &str, label: String, gesture: Option<&str>) {
        self.bytes -= self.undone.drain(..).map(|step| step.bytes()).sum::<usize>();
        let last = self.done.back().filter(|last| gesture.is_some() && last.gesture.as_deref() == gesture);
        let step = match last {
            Some(last) => {
                let patch = Patch::between(&last.patch.back(old), new);
                Step { patch, ..last.clone() }
            }
            None => Step { label, patch: Patch::between(old, new), gesture: gesture.map(str::to_owned) },
        };
        if last.is_some() {
            self.bytes -= self.done.pop_back().map_or(0, |last| last.bytes());
        }
        // A drag that came back to where it began is no step.
        if step.patch.old != step.patch.new {
            self.bytes += step.bytes();
            self.done.push_back(step);
        }
        while self.done.len() > MAX_HISTORY_STEPS || self.bytes > MAX_HISTORY_BYTES {
            let Some(oldest) = self.done.pop_front() else { break };
            self.bytes -= oldest.bytes();
        }
    }

    /// The text before the last step.
    pub(super) fn undo(&mut self, text: &str) -> Option<String> {
        self.end_gesture();
        let step = self.done.pop_back()?;
        let before = step.patch.back(text);
        self.undone.push(step);
        Some(before)
    }

    /// The text after the step that was undone last.
    pub(super) fn redo(&mut self, text: &str) -> Option<String> {
        let step = self.undone.pop()?;
        let after = step.patch.forth(text);
        self.done.push_back(step);
        Some(after)
    }

    /// What comes next is a step of its own.
    pub(super) fn end_gesture(&mut self) {
        if let Some(last) = self.done.back_mut() {
            last.gesture = None;
        }
    }

    pub(super) fn last_done(&self) -> Option<&str> {
        self.done.back().map(|step| step.label.as_str())
    }

    pub(super) fn last_undone(&self) -> Option<&str> {
        self.undone.last().map(|step| step.label.as_str())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_patch_goes_back_and_forth_over_any_letters() {
        for (old, new) in [("", "a"), ("aaa", "aa"), ("xéy", "xêy"), ("aé", "aéé"), ("é", "è"), ("ab", "ab")]
        {
            let patch = Patch::between(old, new);
            assert_eq!((patch.forth(old), patch.back(new)), (new.to_owned(), old.to_owned()));
        }
        assert_eq!(Patch::between("fov = 40", "fov = 45").new, "5");
    }

    #[test]
    fn what_is_kept_is_bounded() {
        let mut history = History::default();
        let mut text = String::new();
        for _ in 0..MAX_HISTORY_STEPS + 10 {
            let new = format!("{text}a");
            history.add(&text, &new, "Type".to_owned(), None);
            text = new;
        }
        assert_eq!(history.done.len(), MAX_HISTORY_STEPS);
        let long = "b".repeat(MAX_HISTORY_BYTES);
        history.add(&text, &long, "Paste".to_owned(), None);
        assert_eq!((history.done.len(), history.bytes), (0, 0));
    }
}
