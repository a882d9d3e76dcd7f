//! Rows of binary numbers, without any padding.

use fumetto_scene::Particle;

use super::header::{Element, Encoding, Kind, Scalar};
use super::{Position, Rows};
use crate::FormatError;
use crate::particles::columns::Cell;

/// Reads the vertices from `body`.
pub(super) fn read(rows: &Rows<'_>, body: &[u8], encoding: Encoding) -> Result<Vec<Particle>, FormatError> {
    let mut numbers = Numbers { rest: body, big_endian: encoding == Encoding::BigEndian };
    for element in rows.before {
        skip(rows, element, &mut numbers)?;
    }
    let mut particles = rows.storage();
    let mut values = Vec::with_capacity(rows.vertex.properties.len());
    for row in 0..rows.vertex.count {
        values.clear();
        for property in &rows.vertex.properties {
            let value = numbers.property(property.kind);
            values.push(value.ok_or_else(|| rows.cut_off(rows.vertex, row))?);
        }
        particles.push(rows.columns.particle(Position::Vertex(row), |column| Cell::Number(values[column]))?);
    }
    Ok(particles)
}

/// Passes over all rows of `element`.
fn skip(rows: &Rows<'_>, element: &Element, numbers: &mut Numbers<'_>) -> Result<(), FormatError> {
    // Rows that have all the same size are passed at once, however many a lying header promises.
    if let Some(row_bytes) = element.fixed_row_bytes() {
        let total = usize::try_from(element.count).ok().and_then(|count| count.checked_mul(row_bytes));
        let room = numbers.rest.len();
        let first_missing = || (room / row_bytes.max(1)) as u64;
        return total
            .and_then(|bytes| numbers.take(bytes))
            .map(|_| ())
            .ok_or_else(|| rows.cut_off(element, first_missing()));
    }
    // A list takes at least the bytes of its length, so this ends with the file at the latest.
    for row in 0..element.count {
        for property in &element.properties {
            numbers.property(property.kind).ok_or_else(|| rows.cut_off(element, row))?;
        }
    }
    Ok(())
}

/// What is left to read; every method answers `None` when that is too little, as it is for a list of
/// negative length.
struct Numbers<'a> {
    rest: &'a [u8],
    big_endian: bool,
}

impl<'a> Numbers<'a> {
    fn take(&mut self, count: usize) -> Option<&'a [u8]> {
        let (taken, rest) = self.rest.split_at_checked(count)?;
        self.rest = rest;
        Some(taken)
    }

    /// A property's value; a list's is its length, and its items are passed over.
    fn property(&mut self, kind: Kind) -> Option<f64> {
        match kind {
            Kind::Scalar(scalar) => self.scalar(scalar),
            Kind::List { length, item } => {
                let length = self.scalar(length).filter(|length| *length >= 0.0)?;
                self.take((length as usize).checked_mul(item.size())?)?;
                Some(length)
            }
        }
    }

    fn scalar(&mut self, scalar: Scalar) -> Option<f64> {
        Some(match scalar {
            Scalar::I8 => i8::from_be_bytes(self.bytes()?).into(),
            Scalar::U8 => u8::from_be_bytes(self.bytes()?).into(),
            Scalar::I16 => i16::from_be_bytes(self.bytes()?).into(),
            Scalar::U16 => u16::from_be_bytes(self.bytes()?).into(),
            Scalar::I32 => i32::from_be_bytes(self.bytes()?).into(),
            Scalar::U32 => u32::from_be_bytes(self.bytes()?).into(),
            Scalar::F32 => f32::from_be_bytes(self.bytes()?).into(),
            Scalar::F64 => f64::from_be_bytes(self.bytes()?),
        })
    }

    /// The next `N` bytes, turned to big-endian order.
    fn bytes<const N: usize>(&mut self) -> Option<[u8; N]> {
        let mut bytes: [u8; N] = self.take(N)?.try_into().ok()?;
        if !self.big_endian {
            bytes.reverse();
        }
        Some(bytes)
    }
}
