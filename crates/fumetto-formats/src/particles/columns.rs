//! Which column means what, and what a particle's values may be: the same for every format.

use std::fmt;

use fumetto_scene::Particle;

use super::{DEFAULT_MASS, DEFAULT_RADIUS};
use crate::excerpt::{excerpt, list};
use crate::{FormatError, Position};

/// The names of a radius, the best first. `pscale` is Houdini's.
const RADIUS_NAMES: [&str; 3] = ["radius", "r", "pscale"];

/// The names of a mass, the best first.
const MASS_NAMES: [&str; 3] = ["mass", "m", "weight"];

/// The columns that hold particles, found by name.
pub(super) struct Columns {
    file: String,
    names: Vec<String>,
    center: [usize; 3],
    radius: Option<usize>,
    mass: Option<usize>,
}

/// One value of a row as its file holds it.
#[derive(Clone, Copy)]
pub(super) enum Cell<'a> {
    /// Text, without spaces around it.
    Text(&'a [u8]),
    /// A number of a binary file.
    Number(f64),
}

impl Columns {
    /// Finds the columns of `file` among `names`; `hint` says how its format names them.
    pub(super) fn find(file: &str, names: Vec<String>, hint: &'static str) -> Result<Self, FormatError> {
        let place = |wanted: &str| names.iter().position(|name| name.eq_ignore_ascii_case(wanted));
        let axes = ["x", "y", "z"].map(|axis| (axis, place(axis)));
        let [(_, Some(x)), (_, Some(y)), (_, Some(z))] = axes else {
            let missing: Vec<_> = axes.iter().filter(|(_, at)| at.is_none()).map(|&(axis, _)| axis).collect();
            return Err(FormatError::MissingColumns {
                file: file.to_owned(),
                missing: list(missing.into_iter()),
                found: list(names.iter().map(String::as_str)),
                hint,
            });
        };
        let radius = RADIUS_NAMES.into_iter().find_map(place);
        let mass = MASS_NAMES.into_iter().find_map(place);
        let columns = Self { file: file.to_owned(), center: [x, y, z], radius, mass, names };
        columns.refuse_twins()?;
        Ok(columns)
    }

    /// Refuses two columns of the same name where it would be a guess which of them is meant.
    fn refuse_twins(&self) -> Result<(), FormatError> {
        for column in self.used() {
            let name = &self.names[column];
            if self.names.iter().filter(|other| other.eq_ignore_ascii_case(name)).count() > 1 {
                return Err(FormatError::Malformed {
                    file: self.file.clone(),
                    position: None,
                    problem: format!(
                        "two columns are called `{}`; rename the one that is not meant",
                        excerpt(name.as_bytes())
                    ),
                });
            }
        }
        Ok(())
    }

    /// The columns that are read.
    fn used(&self) -> impl Iterator<Item = usize> {
        self.center.into_iter().chain(self.radius).chain(self.mass)
    }

    /// The number of columns, read or not.
    pub(super) fn count(&self) -> usize {
        self.names.len()
    }

    /// The particle of the row at `position`, whose values are `cell`.
    pub(super) fn particle<'a>(
        &self,
        position: Position,
        cell: impl Fn(usize) -> Cell<'a>,
    ) -> Result<Particle, FormatError> {
        let finite = |column: usize| {
            cell(column).number().map_err(|problem| self.bad_value(position, column, cell(column), problem))
        };
        let positive = |column: Option<usize>, default: f32| {
            let Some(column) = column else { return Ok(default) };
            let value = finite(column)?;
            if value > 0.0 {
                return Ok(value);
            }
            Err(self.bad_value(position, column, cell(column), "is not above zero, as it has to be"))
        };
        let [x, y, z] = self.center;
        Ok(Particle {
            center: [finite(x)?, finite(y)?, finite(z)?],
            radius: positive(self.radius, DEFAULT_RADIUS)?,
            mass: positive(self.mass, DEFAULT_MASS)?,
        })
    }

    fn bad_value(
        &self,
        position: Position,
        column: usize,
        cell: Cell<'_>,
        problem: &'static str,
    ) -> FormatError {
        FormatError::BadValue {
            file: self.file.clone(),
            position,
            column: excerpt(self.names[column].as_bytes()),
            found: cell.to_string(),
            problem,
        }
    }

    /// What was assumed for want of a column.
    pub(super) fn default_notes(&self) -> Vec<String> {
        let file = &self.file;
        let radius = self.radius.is_none().then(|| {
            format!("{file} has no column `radius`: every particle has a radius of {DEFAULT_RADIUS} m")
        });
        let mass = self
            .mass
            .is_none()
            .then(|| format!("{file} has no column `mass`: every particle has a mass of {DEFAULT_MASS}"));
        radius.into_iter().chain(mass).collect()
    }

    /// A sentence about the columns that are not read, if there are any.
    pub(super) fn ignored_note(&self) -> Option<String> {
        let unused: Vec<_> =
            (0..self.count()).filter(|column| !self.used().any(|used| used == *column)).collect();
        let named: Vec<_> = unused.into_iter().map(|column| self.names[column].as_str()).collect();
        let what = if named.len() == 1 { "column" } else { "columns" };
        let note = || format!("{}: ignored the {what} {}", self.file, list(named.iter().copied()));
        (!named.is_empty()).then(note)
    }
}

impl Cell<'_> {
    /// The value as the engine keeps it, or what is wrong with it.
    fn number(self) -> Result<f32, &'static str> {
        let value = match self {
            Cell::Text(text) => std::str::from_utf8(text).ok().and_then(|text| text.parse().ok()),
            Cell::Number(number) => Some(number as f32),
        };
        match value {
            None => Err("is not a number; write one like 0.25, with a point"),
            Some(value) if !value.is_finite() => Err("is not a finite number that single precision can hold"),
            Some(value) => Ok(value),
        }
    }
}

impl fmt::Display for Cell<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Text(text) => f.write_str(&excerpt(text)),
            // Scientific, for a wild 1e300 would fill a page.
            Self::Number(number) if number.is_finite() && number.abs() >= 1e9 => write!(f, "{number:e}"),
            Self::Number(number) => number.fmt(f),
        }
    }
}
