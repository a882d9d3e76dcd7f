//! What is told about a file that was read in spite of something.

/// Most notes about one file: who has so many to read needs no more of them.
const MAX_NOTES: usize = 50;

/// Sentences about one file.
pub(crate) struct Notes {
    file: String,
    said: Vec<String>,
    left_out: usize,
}

impl Notes {
    /// None yet about `file`.
    pub(crate) fn new(file: &str) -> Self {
        Self { file: file.to_owned(), said: Vec::new(), left_out: 0 }
    }

    /// Tells about a part of the file, once.
    pub(crate) fn say(&mut self, element: &str, what: impl AsRef<str>) {
        self.add(format!("{}: {element}: {}", self.file, what.as_ref()));
    }

    /// Tells about the whole file, once.
    pub(crate) fn say_of_all(&mut self, what: impl AsRef<str>) {
        self.add(format!("{}: {}", self.file, what.as_ref()));
    }

    fn add(&mut self, note: String) {
        if self.said.contains(&note) {
            return;
        }
        if self.said.len() < MAX_NOTES {
            self.said.push(note);
        } else {
            self.left_out += 1;
        }
    }

    /// All that was said, and how many more there were.
    pub(crate) fn finish(mut self) -> Vec<String> {
        if self.left_out > 0 {
            self.said.push(format!("{}: and {} more such notes", self.file, self.left_out));
        }
        self.said
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn notes_are_told_once_and_counted_beyond_the_first() {
        let mut notes = Notes::new("a.glb");
        for i in 0..60 {
            notes.say(&format!("mesh {i}"), "is odd");
            notes.say("mesh 0", "is odd");
        }
        let told = notes.finish();
        assert_eq!(told.len(), MAX_NOTES + 1);
        assert_eq!(told[0], "a.glb: mesh 0: is odd");
        assert_eq!(told[MAX_NOTES], "a.glb: and 10 more such notes");
    }
}
