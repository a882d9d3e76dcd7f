//! TOML text as a tree that remembers where every key and value stood.

mod parse;
mod set;
mod tree;

pub(crate) use parse::{parse_document, parse_value};
pub(crate) use set::apply as set;
pub(crate) use tree::{Array, Entry, Node, Place, Table, Value};
