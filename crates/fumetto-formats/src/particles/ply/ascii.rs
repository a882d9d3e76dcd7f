//! Rows of text: one line for each.

use fumetto_scene::Particle;

use super::header::{Element, Kind, Property};
use super::{Position, Rows};
use crate::FormatError;
use crate::excerpt::excerpt;
use crate::particles::columns::Cell;

/// Reads the vertices from `body`, which follows `header_lines` lines.
pub(super) fn read(
    rows: &Rows<'_>,
    body: &[u8],
    line_end: u8,
    header_lines: u64,
) -> Result<Vec<Particle>, FormatError> {
    let mut lines = (header_lines + 1..)
        .zip(body.split(|&byte| byte == line_end))
        .filter(|(_, line)| !line.trim_ascii().is_empty());

    // A row without properties has no line.
    for element in rows.before.iter().filter(|element| !element.properties.is_empty()) {
        for row in 0..element.count {
            lines.next().ok_or_else(|| rows.cut_off(element, row))?;
        }
    }

    let mut particles = rows.storage();
    let mut cells = Vec::with_capacity(rows.vertex.properties.len());
    for row in 0..rows.vertex.count {
        let (number, line) = lines.next().ok_or_else(|| rows.cut_off(rows.vertex, row))?;
        let position = Position::Line(number);
        split_row(rows, position, line, &mut cells)?;
        particles.push(rows.columns.particle(position, |column| Cell::Text(cells[column]))?);
    }
    Ok(particles)
}

/// Fills `cells` with a vertex's values, one for each property; a list's is its length.
fn split_row<'a>(
    rows: &Rows<'_>,
    position: Position,
    line: &'a [u8],
    cells: &mut Vec<&'a [u8]>,
) -> Result<(), FormatError> {
    let Element { properties, .. } = rows.vertex;
    let mut words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
    cells.clear();
    for Property { kind, .. } in properties {
        let Some(word) = words.next() else { break };
        if let Kind::List { .. } = kind {
            let length = std::str::from_utf8(word).ok().and_then(|word| word.parse::<usize>().ok());
            let Some(length) = length else {
                let problem =
                    format!("`{}` is not the length of a list; export the file again", excerpt(word));
                return Err(rows.malformed(position, problem));
            };
            if length > 0 && words.nth(length - 1).is_none() {
                break;
            }
        }
        cells.push(word);
    }
    if cells.len() == properties.len() {
        return Ok(());
    }
    let problem = format!(
        "the row ends after {} of {} properties; export the file again",
        cells.len(),
        properties.len()
    );
    Err(rows.malformed(position, problem))
}
