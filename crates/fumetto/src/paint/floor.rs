//! How high models are under the cells of a grid.

use fumetto_scene::Cells;
use glam::{Vec2, Vec3, Vec3Swizzles as _};

use crate::shapes::mesh::Geometry;

/// What a cell lies on. `Floor` of `cells.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct Floor {
    /// Its height; [`NOTHING`] where no model is.
    pub(super) height: f32,
    /// How deep paint may lie on it before it spills.
    pub(super) hold: f32,
}

/// Lower than anything. Also in `cells.wgsl`.
pub(super) const NOTHING: f32 = -1e30;

/// Cells along a bump of what holds more paint than elsewhere.
const BUMP_CELLS: f32 = 3.0;

/// Where the first cell begins, along x and z.
pub(super) fn corner(cells: &Cells) -> Vec2 {
    let [columns, rows] = cells.count();
    let middle = Vec2::new(cells.center[0], cells.center[2]);
    middle - 0.5 * cells.cell_m * Vec2::new(columns as f32, rows as f32)
}

/// Row after row along x, as far as models stand there at the beginning.
pub(super) fn floors(cells: &Cells, geometry: &Geometry, seed: u32) -> Vec<Floor> {
    let [columns, rows] = cells.count();
    let hold = |number: u32| {
        let (x, z) = ((number % columns) as f32, (number / columns) as f32);
        let bumps = smooth(Vec2::new(x, z) / BUMP_CELLS, seed) + 0.5 * random(number, seed);
        // From -1 to 1, so that on the whole cells hold what they should.
        cells.depth_m * (1.0 + cells.uneven * (bumps * 4.0 / 3.0 - 1.0)).max(0.05)
    };
    let floor = |number| Floor { height: NOTHING, hold: hold(number) };
    let mut floors: Vec<_> = (0..columns * rows).map(floor).collect();
    for triangle in &geometry.triangles {
        let world_from_part = geometry.parts[triangle.part as usize].world_from_part;
        let place = |corner: u32| {
            world_from_part.transform_point3(Vec3::from(geometry.sources[corner as usize].position))
        };
        raise(&mut floors, cells, triangle.corners.map(place));
    }
    floors
}

/// Raises the floor of those cells over whose middle a triangle lies.
fn raise(floors: &mut [Floor], cells: &Cells, places: [Vec3; 3]) {
    let [columns, rows] = cells.count();
    let first = corner(cells);
    let [a, b, c] = places.map(|place| (place.xz() - first) / cells.cell_m - 0.5);
    let area = (b - a).perp_dot(c - a);
    if area.abs() < f32::MIN_POSITIVE || !area.is_finite() {
        return;
    }
    let (low, high) = (a.min(b).min(c).ceil(), a.max(b).max(c).floor());
    let [bottom, top] = [-0.5, 0.5].map(|side| cells.center[1] + side * cells.size[1]);
    for row in low.y.max(0.0) as u32..(high.y + 1.0).clamp(0.0, rows as f32) as u32 {
        for column in low.x.max(0.0) as u32..(high.x + 1.0).clamp(0.0, columns as f32) as u32 {
            let at = Vec2::new(column as f32, row as f32);
            let shares = [(b - at).perp_dot(c - at), (c - at).perp_dot(a - at), (a - at).perp_dot(b - at)]
                .map(|double_area| double_area / area);
            let height: f32 = shares.iter().zip(places).map(|(share, place)| share * place.y).sum();
            // Neighbours must leave no gap between them.
            let is_over = shares.iter().all(|share| *share >= -1e-5);
            let floor = &mut floors[(row * columns + column) as usize];
            if is_over && (bottom..=top).contains(&height) && height > floor.height {
                floor.height = height;
            }
        }
    }
}

/// From 0 to 1, the same for the same numbers (PCG, as `random.wgsl` has it).
pub(super) fn random(number: u32, seed: u32) -> f32 {
    let pcg = |input: u32| {
        let state = input.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
        (word >> 22) ^ word
    };
    (pcg(number.wrapping_add(pcg(seed))) >> 8) as f32 / (1 << 24) as f32
}

/// Random numbers at whole places, mixed between them.
fn smooth(at: Vec2, seed: u32) -> f32 {
    let (cell, part) = (at.floor(), at - at.floor());
    let ease = part * part * (3.0 - 2.0 * part);
    let corner = |x: f32, z: f32| {
        let number = ((cell.x + x) as u32).wrapping_mul(0x9e37_79b9) ^ ((cell.y + z) as u32);
        random(number, seed ^ 0x5bd1_e995)
    };
    let row = |z: f32| corner(0.0, z) + (corner(1.0, z) - corner(0.0, z)) * ease.x;
    row(0.0) + (row(1.0) - row(0.0)) * ease.y
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cells(uneven: f32) -> Cells {
        Cells {
            center: [0.0, 1.0, 0.0],
            size: [4.0, 4.0, 2.0],
            cell_m: 0.5,
            depth_m: 0.1,
            speed_m_per_s: 1.0,
            uneven,
        }
    }

    #[test]
    fn cells_lie_on_the_highest_triangle_over_their_middle() {
        let cells = cells(0.0);
        assert_eq!(cells.count(), [8, 4]);
        let nothing = Floor { height: NOTHING, hold: cells.depth_m };
        let mut floors = vec![nothing; 32];
        let quad = |floors: &mut [Floor], [x0, x1]: [f32; 2], y: [f32; 2], [z0, z1]: [f32; 2]| {
            let at = |x: f32, z: f32| Vec3::new(x, if x == x0 { y[0] } else { y[1] }, z);
            raise(floors, &cells, [at(x0, z0), at(x1, z0), at(x1, z1)]);
            raise(floors, &cells, [at(x0, z0), at(x1, z1), at(x0, z1)]);
        };
        quad(&mut floors, [-9.0, 1.0], [0.0, 0.0], [-9.0, 9.0]);
        // A step on the left, a ramp in the next row, a ceiling above the box, a wall.
        quad(&mut floors, [-2.0, -1.0], [0.5, 0.5], [-1.0, -0.5]);
        quad(&mut floors, [-2.0, 0.0], [0.0, 2.0], [-0.5, 0.0]);
        quad(&mut floors, [-2.0, 2.0], [9.0, 9.0], [-1.0, 1.0]);
        raise(&mut floors, &cells, [Vec3::ZERO, Vec3::Y, Vec3::new(1.0, 1.0, 0.0)]);
        let heights: Vec<f32> = floors.iter().map(|floor| floor.height).collect();
        assert_eq!(heights[..8], [0.5, 0.5, 0.0, 0.0, 0.0, 0.0, NOTHING, NOTHING]);
        let ramp = [0.25, 0.75, 1.25, 1.75, 0.0, 0.0];
        assert!(heights[8..14].iter().zip(ramp).all(|(a, b)| (a - b).abs() < 1e-5), "{heights:?}");
        assert_eq!(heights[24..30], [0.0; 6]);
    }

    #[test]
    fn uneven_cells_hold_what_they_should_on_the_whole() {
        let geometry = Geometry::default();
        let large = Cells { size: [40.0, 1.0, 40.0], ..cells(0.8) };
        let holds: Vec<f32> = floors(&large, &geometry, 7).iter().map(|floor| floor.hold).collect();
        let mean = holds.iter().sum::<f32>() / holds.len() as f32;
        assert!((mean - 0.1).abs() < 0.01, "{mean}");
        assert!(holds.iter().all(|hold| *hold > 0.0));
        assert!(holds.iter().any(|hold| *hold < 0.06) && holds.iter().any(|hold| *hold > 0.14));
    }
}
