//! The table that finds bricks on the GPU, and tells how far it is to the next one.

use super::{
    BrickMap,
    map::{NODE, entry_of},
};

/// Bits of a slot for each of its coordinates in the atlas. Also in `brick.wgsl`.
const SLOT_BITS: u32 = 8;

/// Marks bricks with matter. Also in `brick.wgsl`.
const IS_KEPT: u32 = 1 << 31;

/// Bricks of a box in which distances are measured, at most: it takes two dozen look-ups for each.
const MOST_MEASURED: usize = 1 << 21;

/// The map's table: for numbers of bricks the places of their slots in an atlas of `slots`, and for a brick without
/// matter how many bricks it is away from the nearest one with some, or less.
pub(super) fn table(map: &BrickMap, slots: [u32; 3]) -> Vec<u32> {
    let nodes = map.nodes.map(|side| side as usize);
    let mut table = map.table.clone();
    for entry in table.iter_mut().skip(nodes.iter().product()) {
        *entry = entry.checked_sub(1).map_or(1, |number| IS_KEPT | packed(number, slots));
    }
    let bricks = nodes.map(|side| side * NODE as usize);
    if bricks.iter().product::<usize>() <= MOST_MEASURED {
        measure(&mut table, nodes, bricks);
    }
    if table.is_empty() { vec![0] } else { table }
}

fn packed(number: u32, [across, down, _]: [u32; 3]) -> u32 {
    let [x, y, z] = [number % across, number / across % down, number / (across * down)];
    x | y << SLOT_BITS | z << (2 * SLOT_BITS)
}

/// Writes how far it is from each brick without matter to one that has some, along the axis on which that is farthest
/// (Deakin and Knoll, "Accelerated Volume Rendering with Chebyshev Distance Maps", 2019).
fn measure(table: &mut [u32], nodes: [usize; 3], sides: [usize; 3]) {
    // One more brick all round, as far from matter as can be.
    let [width, height, depth] = sides.map(|side| side + 2);
    let farthest = sides.iter().fold(1, |most, &side| most.max(side as u32));
    let mut away = vec![farthest; width * height * depth];
    let padded = |[x, y, z]: [usize; 3]| ((z + 1) * height + y + 1) * width + x + 1;
    let [columns, rows, layers] = sides;
    let bricks = || {
        let row = move |y, z| (0..columns).map(move |x| [x, y, z]);
        (0..layers).flat_map(move |z| (0..rows).flat_map(move |y| row(y, z)))
    };
    let entries: Vec<_> = bricks().map(|brick| (padded(brick), entry_of(table, nodes, brick))).collect();
    for (at, entry) in &entries {
        if entry.is_some_and(|entry| table[entry] & IS_KEPT != 0) {
            away[*at] = 0;
        }
    }
    // The least of the neighbours' distances, and one more: of those before it, and then of those after it.
    let before = before(width, height);
    for (at, _) in &entries {
        away[*at] = before.iter().map(|back| away[at - back] + 1).fold(away[*at], u32::min);
    }
    for (at, entry) in entries.iter().rev() {
        away[*at] = before.iter().map(|back| away[at + back] + 1).fold(away[*at], u32::min);
        if let Some(entry) = entry.filter(|_| away[*at] > 0) {
            table[entry] = away[*at];
        }
    }
}

/// How far before a brick those of its neighbours lie that come before it.
fn before(width: usize, height: usize) -> Vec<usize> {
    let [width, height] = [width, height].map(|side| side as isize);
    let line = |y: isize, z: isize| [-1, 0, 1].map(|x: isize| (z * height + y) * width + x);
    let all = [-1, 0, 1].into_iter().flat_map(|z| [-1, 0, 1].into_iter().flat_map(move |y| line(y, z)));
    all.filter(|&step| step < 0).map(isize::unsigned_abs).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_void_is_as_wide_as_it_is_far_to_the_nearest_brick() {
        let side = NODE as usize;
        // The node in the middle has no bricks.
        let nodes = [3, 1, 1];
        let mut table = vec![0; 3 + 2 * side.pow(3)];
        [table[0], table[2]] = [3, (3 + side.pow(3)) as u32];
        let kept = [[3, 4, 5], [9, 4, 5], [15, 15, 0], [40, 2, 11]];
        for brick in kept {
            let entry = entry_of(&table, nodes, brick).expect("its node has bricks");
            table[entry] = IS_KEPT;
        }
        measure(&mut table, nodes, nodes.map(|nodes| nodes * side));
        let across = 3 * side;
        for brick in (0..side).flat_map(|z| (0..side).flat_map(move |y| (0..across).map(move |x| [x, y, z])))
        {
            let away = |other: &[usize; 3]| (0..3).map(|axis| brick[axis].abs_diff(other[axis])).max();
            let nearest = kept.iter().filter_map(away).min().expect("some are kept") as u32;
            if let Some(entry) = entry_of(&table, nodes, brick) {
                assert_eq!(table[entry], if nearest == 0 { IS_KEPT } else { nearest }, "{brick:?}");
            }
        }
    }
}
