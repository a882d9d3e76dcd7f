//! The system's windows that ask for files. They answer later; meanwhile editing goes on.

use std::path::PathBuf;
use std::sync::mpsc::{Receiver, Sender, channel};

use egui::Context;
use rfd::AsyncFileDialog;

/// What a window was asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Purpose {
    /// A scene to open.
    Open,
    /// A name for the scene.
    Save,
    /// A name for what is rendered or exported.
    Output,
    /// A name for the style.
    Style,
}

/// What a window answered.
#[derive(Debug)]
pub(crate) struct Answer {
    pub(crate) purpose: Purpose,
    /// The project that was open when it was asked.
    pub(crate) project: u64,
    /// None where it was closed.
    pub(crate) path: Option<PathBuf>,
}

/// The windows that are open, and what they answered.
pub(crate) struct Dialogs {
    sender: Sender<Answer>,
    answers: Receiver<Answer>,
}

impl Default for Dialogs {
    fn default() -> Self {
        let (sender, answers) = channel();
        Self { sender, answers }
    }
}

impl Dialogs {
    /// Asks for a file of the project with this id; `name` is what is offered.
    pub(crate) fn ask(&self, ctx: &Context, purpose: Purpose, project: u64, name: &str) {
        let dialog = AsyncFileDialog::new().set_file_name(name);
        let (sender, ctx) = (self.sender.clone(), ctx.clone());
        let answer = move |file: Option<rfd::FileHandle>| {
            let path = file.map(|file| file.path().to_owned());
            // Nobody listens any more once the editor has gone.
            let _ = sender.send(Answer { purpose, project, path });
            ctx.request_repaint();
        };
        let scenes = dialog.clone().add_filter("Scenes", &["toml"]);
        match purpose {
            Purpose::Open => wait_for(scenes.pick_file(), answer),
            Purpose::Save => wait_for(scenes.save_file(), answer),
            Purpose::Style => wait_for(dialog.add_filter("Styles", &["toml"]).save_file(), answer),
            Purpose::Output => wait_for(dialog.save_file(), answer),
        }
    }

    /// The answers that came in.
    pub(crate) fn answers(&self) -> Vec<Answer> {
        self.answers.try_iter().collect()
    }
}

fn wait_for<T: 'static>(
    asked: impl Future<Output = T> + Send + 'static,
    answer: impl FnOnce(T) + Send + 'static,
) {
    let waiting = move || answer(pollster::block_on(asked));
    // Without a thread to wait in there is no answer, as if the window had been closed.
    let _ = std::thread::Builder::new().name("dialog".into()).spawn(waiting);
}
