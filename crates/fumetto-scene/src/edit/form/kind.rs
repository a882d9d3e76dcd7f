use super::docs::Docs;
use crate::edit::Value;
use crate::limits::Limit;

/// What a value can be, and so how it is edited.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// True or false.
    Bool,
    /// A whole number.
    Integer {
        /// Where it may lie.
        range: Limit,
        /// Short, as "px"; empty where there is none.
        unit: &'static str,
    },
    /// A number.
    Number {
        /// Where it may lie.
        range: Limit,
        /// Short, as "m/s"; empty where there is none.
        unit: &'static str,
    },
    /// Any text.
    Text,
    /// The path of a file.
    File {
        /// How names of such files end, without the dot.
        formats: Vec<String>,
        /// Names of what is built in and may stand in place of a file.
        names: Vec<String>,
    },
    /// `"#rrggbb"` in sRGB, or `[r, g, b]` in linear light.
    Colour,
    /// As many numbers as it says, all of one kind.
    Vector {
        /// How many.
        len: usize,
        /// Whether they are whole numbers.
        whole: bool,
        /// Where each may lie.
        range: Limit,
        /// Short, as "m"; empty where there is none.
        unit: &'static str,
    },
    /// One of several words.
    Choice(Vec<Word>),
    /// One of several shapes.
    Union(Vec<Alternative>),
    /// A table: a form of its own, at the same path.
    Table,
    /// Elements in a row.
    List {
        /// What each is.
        item: Box<Self>,
        /// A new one.
        start: Value,
        /// How many there have to be, where that is fixed.
        len: Option<usize>,
        /// Whether a lone element may stand without brackets, as `[camera]`.
        alone: bool,
    },
    /// Points `[x, y]` with rising x, and lines between them.
    Curve {
        /// Where x may lie: 0 to 1 for the course of a life, or seconds.
        x: Limit,
        /// The unit of x, empty for the course of a life.
        x_unit: &'static str,
        /// Where y may lie.
        y: Limit,
        /// The unit of y.
        y_unit: &'static str,
    },
    /// Flat colours from dark to light: each a colour, or `{ colour, from }` with the amount of light from which it
    /// is drawn.
    Ramp,
}

/// One of several words.
#[derive(Clone, Debug, PartialEq)]
pub struct Word {
    /// As it is written.
    pub word: String,
    /// What it means.
    pub docs: Docs,
}

/// One of several shapes of a value.
#[derive(Clone, Debug, PartialEq)]
pub struct Alternative {
    /// What it is called.
    pub name: String,
    /// What it means.
    pub docs: Docs,
    /// What is edited: at `key` in the value where there is a key, else the value itself.
    pub kind: Kind,
    /// The only key of the table that the value is: `px` in `{ px = 2.0 }`.
    pub key: Option<String>,
    /// What the whole value becomes when this is chosen; keys that both have in common are kept.
    pub start: Value,
}
