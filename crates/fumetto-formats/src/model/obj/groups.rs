//! Vertices as OBJ has them, each value for itself, and the triangles between them.

use glam::{Vec2, Vec3, Vec4};
use rustc_hash::FxHashMap;

use crate::excerpt::excerpt;
use crate::model::mend::Surface;

/// The values that corners of faces refer to.
#[derive(Default)]
pub(super) struct Vertices {
    pub(super) positions: Vec<Vec3>,
    /// As many as positions, or fewer when the last ones have none.
    pub(super) colours: Vec<Vec4>,
    pub(super) uvs: Vec<Vec2>,
    pub(super) normals: Vec<Vec3>,
}

/// A face's corner: places in [`Vertices`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Corner {
    pub(super) position: u32,
    uv: Option<u32>,
    normal: Option<u32>,
}

/// The triangles of one name and one material.
pub(super) struct Group {
    /// Its name's place among all names.
    pub(super) name: usize,
    /// The place of its material's name there.
    pub(super) material: Option<usize>,
    pub(super) triangles: Vec<[Corner; 3]>,
}

impl Vertices {
    /// The corner that is written as `word`, such as `3`, `3/1`, `3//2` or `-1/-1/-1`.
    pub(super) fn corner(&self, word: &str) -> Result<Corner, String> {
        let mut indices = word.split('/');
        let mut next = |count: usize, kind: &str| match indices.next() {
            None | Some("") => Ok(None),
            Some(index) => place(index, count, kind).map(Some),
        };
        let position = next(self.positions.len(), "vertices")?;
        let uv = next(self.uvs.len(), "texture coordinates")?;
        let normal = next(self.normals.len(), "normals")?;
        match (position, indices.next()) {
            (Some(position), None) => Ok(Corner { position, uv, normal }),
            _ => Err(format!("`{}` is no corner of a face; export it again", excerpt(word.as_bytes()))),
        }
    }
}

/// The place, from 0, of an index that counts from 1, or backwards from the last one.
fn place(index: &str, count: usize, kind: &str) -> Result<u32, String> {
    let shown = || excerpt(index.as_bytes());
    let number: i64 = index.parse().map_err(|_| format!("`{}` is no index; export it again", shown()))?;
    let place = if number < 0 { number.checked_add(count as i64) } else { number.checked_sub(1) };
    let place = place.and_then(|place| usize::try_from(place).ok()).filter(|&place| place < count);
    let outside = || format!("index {} is not among the {count} {kind} above it; export it again", shown());
    place.and_then(|place| u32::try_from(place).ok()).ok_or_else(outside)
}

impl Group {
    /// Its triangles with vertices of their own: one for every corner that is different.
    pub(super) fn surface(&self, vertices: &Vertices) -> Surface {
        let mut numbers: FxHashMap<Corner, u32> = FxHashMap::default();
        let mut corners = Vec::new();
        let mut number = |corner: Corner| {
            *numbers.entry(corner).or_insert_with(|| {
                corners.push(corner);
                corners.len() as u32 - 1
            })
        };
        let triangles = self.triangles.iter().map(|triangle| triangle.map(&mut number)).collect();

        let textured = corners.iter().any(|corner| corner.uv.is_some());
        let shaded = corners.iter().any(|corner| corner.normal.is_some());
        let coloured = !vertices.colours.is_empty();
        // What only some corners have is zero at the others: normals are then computed.
        let position = |corner: &Corner| vertices.positions[corner.position as usize];
        let uv = |corner: &Corner| corner.uv.map_or(Vec2::ZERO, |uv| vertices.uvs[uv as usize]);
        let normal =
            |corner: &Corner| corner.normal.map_or(Vec3::ZERO, |normal| vertices.normals[normal as usize]);
        let colour =
            |corner: &Corner| vertices.colours.get(corner.position as usize).copied().unwrap_or(Vec4::ONE);
        Surface {
            positions: corners.iter().map(position).collect(),
            normals: if shaded { corners.iter().map(normal).collect() } else { Vec::new() },
            uvs: if textured { corners.iter().map(uv).collect() } else { Vec::new() },
            colours: if coloured { corners.iter().map(colour).collect() } else { Vec::new() },
            triangles,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indices_count_from_one_or_backwards() {
        assert_eq!(place("1", 4, "vertices"), Ok(0));
        assert_eq!(place("4", 4, "vertices"), Ok(3));
        assert_eq!(place("-1", 4, "vertices"), Ok(3));
        assert_eq!(place("-4", 4, "vertices"), Ok(0));
        for outside in ["0", "5", "-5", "9223372036854775807", "-9223372036854775808", "99999999999999999999"]
        {
            assert!(place(outside, 4, "vertices").is_err(), "{outside}");
        }
    }
}
