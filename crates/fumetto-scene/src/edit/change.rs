use super::syntax::SyntaxError;
use super::{Path, Value};

/// A change of a scene's text. Paths may go by names; see [`Path`].
#[derive(Clone, Debug, PartialEq)]
pub enum Edit {
    /// Puts `value` at `path`, making the tables on the way. Of a table or an array that is there already, only
    /// what differs is written anew.
    Set {
        /// Of a key, or of an element that exists.
        path: Path,
        /// What it is to be.
        value: Value,
    },
    /// Takes a key away, so that its default counts, or an element of an array. What is not there stays so.
    Remove {
        /// Of the key or element.
        path: Path,
    },
    /// Puts a new element into an array, which is made where there is none. Its `name` gets a number where
    /// another has it already.
    Insert {
        /// Of the array.
        list: Path,
        /// The number that the element gets; at most as many as there are.
        index: usize,
        /// The element.
        item: Item,
    },
    /// Puts a copy of an element right behind it, under a name of its own.
    Duplicate {
        /// Of the element.
        path: Path,
    },
    /// Gives an element another place in its array. Its comments go with it.
    Move {
        /// Of the element.
        path: Path,
        /// Its number from now on.
        to: usize,
    },
    /// Gives an object or a camera another name, which no other has.
    Rename {
        /// Of the object or camera.
        path: Path,
        /// Its name from now on.
        name: String,
    },
    /// Takes the place of the whole text, be it TOML or not.
    ReplaceText(
        /// The new text.
        String,
    ),
    /// Several edits as one step; where one of them cannot be done, none is.
    All {
        /// What the step is called in menus.
        label: String,
        /// One after the other.
        edits: Vec<Self>,
    },
}

/// A new element of an array.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    /// Written in the way of the others.
    Value(Value),
    /// TOML with comments: the element under its full header, as `[[object.force]]`. Where the others are not
    /// under headers it is written in their way.
    Snippet(String),
}

impl Edit {
    /// What it is called in menus: "Set camera.fov".
    #[must_use]
    pub fn label(&self) -> String {
        match self {
            Self::Set { path, .. } => format!("Set {path}"),
            Self::Remove { path } => format!("Remove {path}"),
            Self::Insert { list, .. } => format!("Add {list}"),
            Self::Duplicate { path } => format!("Duplicate {path}"),
            Self::Move { path, .. } => format!("Move {path}"),
            Self::Rename { name, .. } => format!("Rename to {name}"),
            Self::ReplaceText(_) => "Edit text".to_owned(),
            Self::All { label, .. } => label.clone(),
        }
    }
}

/// Why an edit cannot be done. Nothing was changed.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum EditError {
    /// The text has to be mended first.
    #[error("the scene's text has to be mended first: {0}")]
    Syntax(#[from] SyntaxError),
    /// There is no such element.
    #[error("there is no `{0}` in the scene")]
    Missing(Path),
    /// The path leads through something that has nothing inside.
    #[error("`{0}` can have nothing inside, for it is neither a table nor an array")]
    NotATable(Path),
    /// Only arrays have elements.
    #[error("`{0}` is no array")]
    NotAnArray(Path),
    /// An element's number is too large.
    #[error("`{list}` has {len} elements, so none can become number {index}")]
    OutOfRange {
        /// Of the array.
        list: Path,
        /// How many elements it has.
        len: usize,
        /// The number that was asked for, from 0.
        index: usize,
    },
    /// A snippet is not what its array holds.
    #[error("this is no element of `{0}`: a snippet begins with the header of that array")]
    BadSnippet(Path),
    /// A name is needed.
    #[error("the name is empty; give it at least one letter")]
    EmptyName,
    /// Names differ.
    #[error("another is named {0:?} already; choose another name")]
    NameTaken(String),
    /// The text would be too long.
    #[error(
        "the scene would have {bytes} bytes of text, but at most {most} are allowed; put particles into a file of their own"
    )]
    TooLong {
        /// How long it would be.
        bytes: usize,
        /// How long it may be.
        most: usize,
    },
    /// What came out is no TOML.
    #[error("this cannot be written into the scene's text: {0}")]
    Unwritable(SyntaxError),
}
