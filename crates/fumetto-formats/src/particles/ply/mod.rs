//! PLY, the Stanford polygon format, of which the element `vertex` is read.
//!
//! It is read here rather than through a crate: of those that exist, the kept one (`ply-rs-bw` 4) lets
//! a later element or property of the same name silently replace the earlier one, so that all that
//! follows is read from the wrong bytes; runs as often as the header says for an element without
//! properties; refuses `nan`, `.5` and comments that are not UTF-8 in places where a message could name
//! the column or nothing is wrong at all. Our part of the format is small: the header in [`header`],
//! text rows in [`ascii`], binary rows in [`binary`].

mod ascii;
mod binary;
mod header;

use fumetto_scene::Particle;

use self::header::{Element, Encoding, Header};
use super::columns::Columns;
use super::{MAX_PARTICLES, ParticleTable};
use crate::{FormatError, Position};

const HINT: &str = " as scalar properties of the element `vertex`";

/// Reads the vertices of a PLY file.
pub(super) fn read(file: &str, bytes: &[u8]) -> Result<ParticleTable, FormatError> {
    let header = Header::read(file, bytes)?;
    let Some((vertex, before)) = header.vertex() else {
        return Err(FormatError::Malformed {
            file: file.to_owned(),
            position: None,
            problem: "no element is called `vertex`; export the particles as points".to_owned(),
        });
    };
    let names = vertex.properties.iter().map(header::Property::column_name).collect();
    let columns = Columns::find(file, names, HINT)?;
    check_count(file, vertex, header.encoding, bytes.len() - header.length)?;

    let body = &bytes[header.length..];
    let rows = Rows { file, before, vertex, columns: &columns };
    let particles = match header.encoding {
        Encoding::Ascii => ascii::read(&rows, body, header.line_end, header.lines)?,
        Encoding::LittleEndian | Encoding::BigEndian => binary::read(&rows, body, header.encoding)?,
    };
    Ok(ParticleTable { particles, notes: columns.default_notes() })
}

/// What both readers of rows need to know.
struct Rows<'a> {
    file: &'a str,
    /// The elements whose rows come before the vertices.
    before: &'a [Element],
    vertex: &'a Element,
    columns: &'a Columns,
}

impl Rows<'_> {
    /// Room for the vertices; the count was checked against the file's length.
    fn storage(&self) -> Vec<Particle> {
        Vec::with_capacity(self.vertex.count as usize)
    }

    /// The error that the file ends, or makes no sense, within `element`.
    fn cut_off(&self, element: &Element, row: u64) -> FormatError {
        FormatError::Malformed {
            file: self.file.to_owned(),
            position: None,
            problem: format!(
                "row {} of the {} that the header promises for `{}` is not whole; the file is cut off or damaged, so \
                 export or copy it again",
                row + 1,
                element.count,
                element.shown_name()
            ),
        }
    }

    /// The error that a row cannot be understood.
    fn malformed(&self, position: Position, problem: String) -> FormatError {
        FormatError::Malformed { file: self.file.to_owned(), position: Some(position), problem }
    }
}

/// Refuses counts that no scene holds, or that the `available` bytes cannot, before anything is allocated.
fn check_count(
    file: &str,
    vertex: &Element,
    encoding: Encoding,
    available: usize,
) -> Result<(), FormatError> {
    let asked = vertex.count;
    if asked == 0 {
        return Err(FormatError::NoParticles { file: file.to_owned() });
    }
    if asked > MAX_PARTICLES as u64 {
        return Err(FormatError::TooManyParticles { file: file.to_owned(), asked, allowed: MAX_PARTICLES });
    }
    let least = asked * vertex.least_row_bytes(encoding);
    // The last line of a text file may lack its end.
    let least = if encoding == Encoding::Ascii { least - 1 } else { least };
    if least > available as u64 {
        return Err(FormatError::Malformed {
            file: file.to_owned(),
            position: None,
            problem: format!(
                "the header promises {asked} vertices, which take {least} bytes at least, but only {available} follow; \
                 the file is cut off, so export or copy it again"
            ),
        });
    }
    Ok(())
}
