//! Tables of comma-, semicolon- or tab-separated values, through the `csv` crate.

use csv::{ByteRecord, ReaderBuilder, Trim};

use super::columns::{Cell, Columns};
use super::{MAX_PARTICLES, ParticleTable};
use crate::{FormatError, Position};

const HINT: &str = " in the first line that does not start with `#`, such as `x,y,z,radius,mass`";

/// Reads the particles of a CSV file.
pub(super) fn read(file: &str, bytes: &[u8]) -> Result<ParticleTable, FormatError> {
    let mut reader = ReaderBuilder::new()
        .delimiter(delimiter(bytes))
        .comment(Some(b'#'))
        .trim(Trim::All)
        .has_headers(false)
        .flexible(true) // uneven rows get a message of our own
        .from_reader(bytes);
    let mut row = ByteRecord::new();
    let mut next = |row: &mut ByteRecord| {
        reader.read_byte_record(row).map_err(|error| FormatError::Malformed {
            file: file.to_owned(),
            position: error.position().map(|at| Position::Line(at.line())),
            problem: format!("{error}; export the table again"),
        })
    };

    if !next(&mut row)? {
        return Err(FormatError::NoParticles { file: file.to_owned() });
    }
    let names = row.iter().map(|name| String::from_utf8_lossy(name).into_owned()).collect();
    let columns = Columns::find(file, names, HINT)?;

    let mut particles = Vec::new();
    while next(&mut row)? {
        if particles.len() == MAX_PARTICLES {
            // The row at hand is one too many; the rest is only counted.
            let mut asked = MAX_PARTICLES as u64 + 1;
            while next(&mut row)? {
                asked += 1;
            }
            return Err(FormatError::TooManyParticles {
                file: file.to_owned(),
                asked,
                allowed: MAX_PARTICLES,
            });
        }
        let position = Position::Line(row.position().map_or(0, csv::Position::line));
        if row.len() != columns.count() {
            return Err(uneven(file, position, row.len(), columns.count()));
        }
        particles.push(columns.particle(position, |column| Cell::Text(&row[column]))?);
    }
    if particles.is_empty() {
        return Err(FormatError::NoParticles { file: file.to_owned() });
    }
    let notes = columns.default_notes().into_iter().chain(columns.ignored_note()).collect();
    Ok(ParticleTable { particles, notes })
}

/// The error about a row that is longer or shorter than the header.
fn uneven(file: &str, position: Position, fields: usize, names: usize) -> FormatError {
    FormatError::Malformed {
        file: file.to_owned(),
        position: Some(position),
        problem: format!(
            "{fields} values stand under {names} column names; give every row one value for each"
        ),
    }
}

/// The separator that the header shows: of comma, semicolon and tab the one that it holds most of.
fn delimiter(bytes: &[u8]) -> u8 {
    let mut lines = bytes.split(|&byte| byte == b'\n' || byte == b'\r');
    let header =
        lines.find(|line| !line.trim_ascii().is_empty() && !line.starts_with(b"#")).unwrap_or_default();
    let count = |separator: u8| header.iter().filter(|&&byte| byte == separator).count();
    // The comma comes last because it wins a draw.
    [b'\t', b';', b','].into_iter().max_by_key(|&separator| count(separator)).unwrap_or(b',')
}
