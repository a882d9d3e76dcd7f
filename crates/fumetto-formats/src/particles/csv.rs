//! Tables of comma-, semicolon- or tab-separated values, through the `csv` crate.

use csv::{ByteRecord, ReaderBuilder, Trim};

use super::columns::{Cell, Columns};
use super::{MAX_PARTICLES, ParticleTable};
use crate::{FormatError, Position};

const HINT: &str = " in the first line that does not start with `#`, such as `x,y,z,radius,mass`";

/// What Excel starts UTF-8 with.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// Reads the particles of a CSV file.
pub(super) fn read(file: &str, bytes: &[u8]) -> Result<ParticleTable, FormatError> {
    let bytes = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes);
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
    let mut lines = LineCounter::new(bytes);
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
        let start = row.position().map_or(0, csv::Position::byte);
        let position = Position::Line(lines.row_after(start as usize));
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

/// Numbers the lines of rows.
///
/// The `csv` crate's own number is where it began to look for the row: before the comments, the empty
/// lines and the second half of a line end that stand in front of it.
struct LineCounter<'a> {
    bytes: &'a [u8],
    line_end: u8,
    counted: usize,
    line: u64,
}

impl<'a> LineCounter<'a> {
    fn new(bytes: &'a [u8]) -> Self {
        let line_end = if bytes.contains(&b'\n') { b'\n' } else { b'\r' };
        Self { bytes, line_end, counted: 0, line: 1 }
    }

    /// The line, from 1, of the first row at or after `start`, which is beyond the last one asked for.
    fn row_after(&mut self, start: usize) -> u64 {
        let mut row = start;
        loop {
            match self.bytes.get(row) {
                Some(b'\n' | b'\r') => row += 1,
                // As the `csv` crate has it, a comment ends at a line feed and nowhere else.
                Some(b'#') => row += self.bytes[row..].iter().take_while(|&&byte| byte != b'\n').count(),
                _ => break,
            }
        }
        let passed = self.bytes.get(self.counted..row).unwrap_or_default();
        self.line += passed.iter().filter(|&&byte| byte == self.line_end).count() as u64;
        self.counted = row;
        self.line
    }
}
