use super::apply::changed;
use super::history::History;
use super::syntax::{Syntax, SyntaxError};
use super::{Edit, EditError, Path, Value};
use crate::limits::MAX_TEXT_BYTES;

/// A scene's text that is being edited, with all that can be undone.
///
/// The text is the truth: comments, order and formatting stay as they are, but for what an edit has to change. It may
/// have syntax errors; then nothing but the text itself can be edited.
#[derive(Clone, Debug)]
pub struct Document {
    text: String,
    syntax: Result<Syntax, SyntaxError>,
    saved: String,
    history: History,
    revision: u64,
}

impl Document {
    /// Begins with `text`, which counts as saved.
    ///
    /// # Errors
    /// [`EditError::TooLong`], before anything is read.
    pub fn open(text: impl Into<String>) -> Result<Self, EditError> {
        let text = text.into();
        fits(&text)?;
        let syntax = Syntax::parse(&text);
        Ok(Self { saved: text.clone(), text, syntax, history: History::default(), revision: 0 })
    }

    /// The text as it is to be saved.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Why the text is no TOML, so that only [`Edit::ReplaceText`] can change it.
    #[must_use]
    pub fn syntax_error(&self) -> Option<&SyntaxError> {
        self.syntax.as_ref().err()
    }

    /// Grows with every change of the text.
    #[must_use]
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// The value at `path`, where the text has one.
    #[must_use]
    pub fn get(&self, path: &Path) -> Option<Value> {
        self.syntax.as_ref().ok()?.get(path)
    }

    /// How many elements the array at `path` has; one for a table that stands alone, none where there is nothing.
    #[must_use]
    pub fn count(&self, path: &Path) -> usize {
        let found = self.syntax.as_ref().ok().and_then(|syntax| syntax.find(path.steps()));
        found.map_or(0, |(_, written)| written.len().unwrap_or(usize::from(written.is_table())))
    }

    /// Does an edit, as a step of its own. One that changes nothing is no step.
    ///
    /// # Errors
    /// Why it cannot be done; then all stays as it was.
    pub fn apply(&mut self, edit: &Edit) -> Result<(), EditError> {
        self.step(edit, None)
    }

    /// Does an edit of a gesture. Edits of the same `gesture` that follow each other become one step, until
    /// [`Document::end_gesture`].
    ///
    /// # Errors
    /// Why it cannot be done; then all stays as it was.
    pub fn apply_during(&mut self, gesture: &str, edit: &Edit) -> Result<(), EditError> {
        self.step(edit, Some(gesture))
    }

    /// The pointer is up, the field is left: what comes next is a step of its own.
    pub fn end_gesture(&mut self) {
        self.history.end_gesture();
    }

    /// Takes the last step back; whether there was one.
    pub fn undo(&mut self) -> bool {
        self.travel(History::undo)
    }

    /// Does again what was undone last; whether there was anything.
    pub fn redo(&mut self) -> bool {
        self.travel(History::redo)
    }

    /// The name of the step that [`Document::undo`] would take back.
    #[must_use]
    pub fn undo_label(&self) -> Option<&str> {
        self.history.last_done()
    }

    /// The name of the step that [`Document::redo`] would do again.
    #[must_use]
    pub fn redo_label(&self) -> Option<&str> {
        self.history.last_undone()
    }

    /// Whether the text differs from what was saved or opened.
    #[must_use]
    pub fn is_changed(&self) -> bool {
        self.text != self.saved
    }

    /// The text was saved as it is.
    pub fn mark_saved(&mut self) {
        self.end_gesture();
        self.saved.clone_from(&self.text);
    }

    /// What was read of the text.
    pub(super) fn syntax(&self) -> Option<&Syntax> {
        self.syntax.as_ref().ok()
    }

    fn step(&mut self, edit: &Edit, gesture: Option<&str>) -> Result<(), EditError> {
        if let Some((text, syntax)) = after(&self.text, &self.syntax, edit)?
            && text != self.text
        {
            self.history.add(&self.text, &text, edit.label(), gesture);
            self.put(text, syntax);
        }
        Ok(())
    }

    fn travel(&mut self, way: impl Fn(&mut History, &str) -> Option<String>) -> bool {
        let Some(text) = way(&mut self.history, &self.text) else { return false };
        let syntax = Syntax::parse(&text);
        self.put(text, syntax);
        true
    }

    fn put(&mut self, text: String, syntax: Result<Syntax, SyntaxError>) {
        (self.text, self.syntax) = (text, syntax);
        self.revision += 1;
    }
}

type Read = Result<Syntax, SyntaxError>;

/// What `edit` makes of a text; `None` where it changes nothing.
fn after(text: &str, syntax: &Read, edit: &Edit) -> Result<Option<(String, Read)>, EditError> {
    match edit {
        Edit::ReplaceText(new) => {
            fits(new)?;
            Ok(Some((new.clone(), Syntax::parse(new))))
        }
        Edit::All { edits, .. } => {
            let mut now: Option<(String, Read)> = None;
            for edit in edits {
                let (text, syntax) =
                    now.as_ref().map_or((text, syntax), |(text, syntax)| (text.as_str(), syntax));
                now = after(text, syntax, edit)?.or(now);
            }
            Ok(now)
        }
        _ => {
            let new = changed(syntax.as_ref().map_err(Clone::clone)?, edit)?;
            if new == text {
                return Ok(None);
            }
            fits(&new)?;
            let read = Syntax::parse(&new).map_err(EditError::Unwritable)?;
            Ok(Some((new, Ok(read))))
        }
    }
}

fn fits(text: &str) -> Result<(), EditError> {
    let (bytes, most) = (text.len(), MAX_TEXT_BYTES);
    if bytes > most { Err(EditError::TooLong { bytes, most }) } else { Ok(()) }
}
