//! What panels ask for. It is done after all of them were shown, so that they show one state.

use fumetto_scene::edit::{Edit, Path};

use crate::app::Goal;
use crate::commands::Command;

/// Something to be done after the panels were shown.
#[derive(Debug)]
pub(crate) enum Request {
    /// A change of the scene; those of one gesture become one step of undoing.
    Edit { edit: Edit, gesture: Option<String> },
    /// The pointer is up: what comes next is another step.
    EndGesture,
    /// As if its menu entry had been chosen.
    Do(Command),
    /// Shows something in the inspector.
    Select(Path),
    /// Goes on to another scene.
    Leave(Goal),
    /// Writes the scene's style to a file of its own.
    SaveStyle,
    /// Goes to a frame.
    Seek(u32),
    /// Shows the text there, in bytes.
    ShowText(std::ops::Range<usize>),
}

/// The requests of one moment.
#[derive(Debug, Default)]
pub(crate) struct Requests(Vec<Request>);

impl Requests {
    pub(crate) fn push(&mut self, request: Request) {
        self.0.push(request);
    }

    /// A change that is a step of its own.
    pub(crate) fn edit(&mut self, edit: Edit) {
        self.push(Request::Edit { edit, gesture: None });
    }

    /// A change that joins those of the same gesture before it.
    pub(crate) fn drag(&mut self, gesture: impl Into<String>, edit: Edit) {
        self.push(Request::Edit { edit, gesture: Some(gesture.into()) });
    }

    pub(crate) fn take(&mut self) -> Vec<Request> {
        std::mem::take(&mut self.0)
    }
}
