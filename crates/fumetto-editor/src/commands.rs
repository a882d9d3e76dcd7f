//! Everything that can be asked for by a key, a menu or the palette, in one table.

use egui::{Key, KeyboardShortcut, Modifiers};

use crate::view::Side;

/// Something to be done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Command {
    New,
    Open,
    Save,
    SaveAs,
    Undo,
    Redo,
    Rename,
    Duplicate,
    Delete,
    Play,
    PreviousFrame,
    NextFrame,
    FirstFrame,
    LastFrame,
    FrameAll,
    FrameSelected,
    SceneCamera,
    KeepView,
    LookFrom(Side),
    Render,
    Export,
    ToggleTree,
    ToggleInspector,
    ToggleText,
    ToggleStyles,
    ToggleGrid,
    ToggleTimes,
    Palette,
    ToggleTheme,
    Quit,
}

/// How a command is shown and reached.
pub(crate) struct Entry {
    pub(crate) command: Command,
    pub(crate) menu: Menu,
    pub(crate) name: &'static str,
    pub(crate) shortcut: Option<KeyboardShortcut>,
    /// Whether it works while a text is being typed.
    pub(crate) while_typing: bool,
}

/// Where an entry is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Menu {
    File,
    Edit,
    View,
    Time,
}

impl Menu {
    pub(crate) const ALL: [Self; 4] = [Self::File, Self::Edit, Self::View, Self::Time];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::File => "File",
            Self::Edit => "Edit",
            Self::View => "View",
            Self::Time => "Time",
        }
    }
}

const fn bare(key: Key) -> Option<KeyboardShortcut> {
    Some(KeyboardShortcut::new(Modifiers::NONE, key))
}

const fn with_command(key: Key) -> Option<KeyboardShortcut> {
    Some(KeyboardShortcut::new(Modifiers::COMMAND, key))
}

const fn with_shift(key: Key) -> Option<KeyboardShortcut> {
    Some(KeyboardShortcut::new(Modifiers::COMMAND.plus(Modifiers::SHIFT), key))
}

const fn entry(
    menu: Menu,
    command: Command,
    name: &'static str,
    shortcut: Option<KeyboardShortcut>,
    while_typing: bool,
) -> Entry {
    Entry { command, menu, name, shortcut, while_typing }
}

/// All commands, in the order of the menus.
pub(crate) const ALL: &[Entry] = &[
    entry(Menu::File, Command::New, "New scene", with_command(Key::N), true),
    entry(Menu::File, Command::Open, "Open…", with_command(Key::O), true),
    entry(Menu::File, Command::Save, "Save", with_command(Key::S), true),
    entry(Menu::File, Command::SaveAs, "Save as…", with_shift(Key::S), true),
    entry(Menu::File, Command::Render, "Render…", bare(Key::F12), true),
    entry(Menu::File, Command::Export, "Export…", with_command(Key::E), true),
    entry(Menu::File, Command::Quit, "Quit", with_command(Key::Q), true),
    entry(Menu::Edit, Command::Undo, "Undo", with_command(Key::Z), false),
    entry(Menu::Edit, Command::Redo, "Redo", with_shift(Key::Z), false),
    entry(Menu::Edit, Command::Rename, "Rename", bare(Key::Enter), false),
    entry(Menu::Edit, Command::Duplicate, "Duplicate", with_command(Key::D), false),
    entry(Menu::Edit, Command::Delete, "Delete", bare(Key::Delete), false),
    entry(Menu::Edit, Command::Palette, "Find a command…", with_command(Key::P), true),
    entry(Menu::View, Command::FrameAll, "Frame all", bare(Key::Home), false),
    entry(Menu::View, Command::FrameSelected, "Frame selected", bare(Key::F), false),
    entry(Menu::View, Command::SceneCamera, "Through the scene's camera", bare(Key::Num0), false),
    entry(Menu::View, Command::KeepView, "Put the scene's camera here", with_command(Key::Num0), false),
    entry(Menu::View, Command::LookFrom(Side::Front), "From the front", bare(Key::Num1), false),
    entry(Menu::View, Command::LookFrom(Side::Back), "From the back", with_command(Key::Num1), false),
    entry(Menu::View, Command::LookFrom(Side::Right), "From the right", bare(Key::Num3), false),
    entry(Menu::View, Command::LookFrom(Side::Left), "From the left", with_command(Key::Num3), false),
    entry(Menu::View, Command::LookFrom(Side::Top), "From above", bare(Key::Num7), false),
    entry(Menu::View, Command::LookFrom(Side::Bottom), "From below", with_command(Key::Num7), false),
    entry(Menu::View, Command::ToggleTree, "Scene", bare(Key::F2), true),
    entry(Menu::View, Command::ToggleInspector, "Inspector", bare(Key::F3), true),
    entry(Menu::View, Command::ToggleStyles, "Styles", bare(Key::F4), true),
    entry(Menu::View, Command::ToggleText, "Text and problems", bare(Key::F6), true),
    entry(Menu::View, Command::ToggleGrid, "Grid and axes", bare(Key::G), false),
    entry(Menu::View, Command::ToggleTimes, "Times", bare(Key::F7), true),
    entry(Menu::View, Command::ToggleTheme, "Light or dark", bare(Key::F8), true),
    entry(Menu::Time, Command::Play, "Play or pause", bare(Key::Space), false),
    entry(Menu::Time, Command::PreviousFrame, "Previous frame", bare(Key::ArrowLeft), false),
    entry(Menu::Time, Command::NextFrame, "Next frame", bare(Key::ArrowRight), false),
    entry(Menu::Time, Command::FirstFrame, "First frame", with_command(Key::ArrowLeft), false),
    entry(Menu::Time, Command::LastFrame, "Last frame", with_command(Key::ArrowRight), false),
];

/// The commands whose keys were pressed; none while a question waits for its answer.
pub(crate) fn pressed(ctx: &egui::Context) -> Vec<Command> {
    if ctx.memory(|memory| memory.top_modal_layer().is_some()) {
        return Vec::new();
    }
    let typing = ctx.text_edit_focused();
    let focused = ctx.memory(|memory| memory.focused().is_some());
    let mut found = Vec::new();
    // Those with more keys first: Ctrl+Shift+S is no Ctrl+S.
    let mut entries: Vec<&Entry> = ALL
        .iter()
        .filter(|entry| entry.while_typing || !typing)
        .filter(|entry| !(focused && entry.shortcut.as_ref().is_some_and(steers_focus)))
        .collect();
    entries.sort_by_key(|entry| entry.shortcut.is_none_or(|keys| !keys.modifiers.shift));
    for entry in entries {
        if let Some(keys) = &entry.shortcut
            && ctx.input_mut(|input| input.consume_shortcut(keys))
        {
            found.push(entry.command);
        }
    }
    found
}

/// Whether a shortcut means something to whatever has the focus: Space and Enter press a button, arrows go along a
/// list, and Delete is meant for what is there.
fn steers_focus(keys: &KeyboardShortcut) -> bool {
    let steers = [Key::Space, Key::Enter, Key::Delete, Key::ArrowLeft, Key::ArrowRight];
    steers.contains(&keys.logical_key) && keys.modifiers.is_none()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The commands of a key that is pressed while `show` is shown for the third time.
    fn commands(key: Key, mut show: impl FnMut(&mut egui::Ui)) -> Vec<Command> {
        let ctx = egui::Context::default();
        let mut found = Vec::new();
        for pass in 0..3 {
            let mut input = egui::RawInput::default();
            if pass == 2 {
                let modifiers = Modifiers::NONE;
                input.events.push(egui::Event::Key {
                    key,
                    physical_key: None,
                    pressed: true,
                    repeat: false,
                    modifiers,
                });
            }
            let mut shown = ctx.run_ui(input, |ui| {
                found.extend(pressed(ui.ctx()));
                show(ui);
            });
            shown.textures_delta.clear();
        }
        found
    }

    #[test]
    fn keys_do_nothing_beneath_a_question() {
        let question = |ui: &mut egui::Ui| {
            egui::Modal::new(egui::Id::unique("question")).show(ui.ctx(), |ui| ui.label("Really?"));
        };
        for (key, command) in [(Key::Delete, Command::Delete), (Key::Space, Command::Play)] {
            assert_eq!(commands(key, |_| {}), [command]);
            assert_eq!(commands(key, question), []);
        }
    }

    #[test]
    fn a_button_with_the_focus_has_its_keys() {
        let mut clicks = 0;
        let found = commands(Key::Enter, |ui| {
            let button = ui.button("Start");
            button.request_focus();
            clicks += u32::from(button.clicked());
        });
        assert_eq!((found, clicks), (vec![], 1));
        assert_eq!(commands(Key::Enter, |_| {}), [Command::Rename]);
    }

    #[test]
    fn no_two_commands_have_one_shortcut_or_name() {
        for (i, one) in ALL.iter().enumerate() {
            for other in &ALL[i + 1..] {
                assert!(one.name != other.name && one.command != other.command, "{}", one.name);
                assert!(one.shortcut.is_none() || one.shortcut != other.shortcut, "{}", one.name);
            }
        }
    }
}
