//! TOML text as a tree that remembers where every key and value stood.

mod parse;
mod path;
mod set;
mod tree;

pub(crate) use parse::{parse_document, parse_value};
pub(crate) use path::{BadPath, PathStep, parse_path};
pub(crate) use set::apply as set;
pub(crate) use tree::{Array, Entry, Node, Place, Table, Value};
