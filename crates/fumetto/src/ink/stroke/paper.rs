//! The tooth of paper: how deep its pores are.

/// Texels along a side; it repeats.
pub(crate) const TOOTH_SIDE: u32 = 256;

/// Sizes of its grains, in texels, and how much each counts: paper is felted from fibres of all lengths.
const GRAINS: [(u32, f32); 4] = [(2, 1.2), (4, 0.6), (16, 0.12), (64, 0.12)];

/// A hash of a lattice point in [0, 1) (PCG, as `random.wgsl`).
pub(super) fn random(x: u32, y: u32, seed: u32) -> f32 {
    let pcg = |input: u32| {
        let state = input.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
        (word >> 22) ^ word
    };
    (pcg(x.wrapping_add(pcg(y.wrapping_add(pcg(seed))))) >> 8) as f32 / 16_777_216.0
}

/// Smooth noise in [0, 1] on a lattice of `columns` by `rows` cells that repeats; `at` counts cells.
pub(super) fn value_noise(at: [f32; 2], [columns, rows]: [u32; 2], seed: u32) -> f32 {
    let cell = at.map(f32::floor);
    let [u, v] = [at[0] - cell[0], at[1] - cell[1]].map(|part| part * part * (3.0 - 2.0 * part));
    let corner = |x: i64, y: i64| {
        let wrapped =
            |place: f32, step: i64, count: u32| (place as i64 + step).rem_euclid(i64::from(count)) as u32;
        random(wrapped(cell[0], x, columns), wrapped(cell[1], y, rows), seed)
    };
    let row = |y| corner(0, y) * (1.0 - u) + corner(1, y) * u;
    row(0) * (1.0 - v) + row(1) * v
}

/// Depths of pores from 0 to 255, row by row. As many are of any depth, so that pressed half, half of it is filled.
pub(crate) fn tooth() -> Vec<u8> {
    let depth = |texel: u32| {
        let at = [texel % TOOTH_SIDE, texel / TOOTH_SIDE].map(|side| side as f32 + 0.5);
        let grain = |(seed, &(size, share)): (u32, &(u32, f32))| {
            let cells = TOOTH_SIDE / size;
            share * value_noise(at.map(|side| side / size as f32), [cells; 2], seed)
        };
        (0..).zip(&GRAINS).map(grain).sum::<f32>()
    };
    let depths: Vec<f32> = (0..TOOTH_SIDE * TOOTH_SIDE).map(depth).collect();
    let mut order: Vec<usize> = (0..depths.len()).collect();
    order.sort_by(|&a, &b| depths[a].total_cmp(&depths[b]));
    let mut ranks = vec![0; depths.len()];
    for (rank, texel) in order.into_iter().enumerate() {
        ranks[texel] = (rank * 256 / depths.len()) as u8;
    }
    ranks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pores_are_of_all_depths_alike() {
        let mut counts = [0; 256];
        for depth in tooth() {
            counts[usize::from(depth)] += 1;
        }
        assert_eq!(counts, [TOOTH_SIDE * TOOTH_SIDE / 256; 256]);
    }

    #[test]
    fn it_repeats_without_a_seam() {
        let tooth = tooth();
        let at = |x: u32, y: u32| f32::from(tooth[(y * TOOTH_SIDE + x) as usize]);
        let step = |from: u32, to: u32| (0..TOOTH_SIDE).map(|y| (at(from, y) - at(to, y)).abs()).sum::<f32>();
        let inside = step(100, 101);
        assert!(step(TOOTH_SIDE - 1, 0) < 1.5 * inside, "{} against {inside}", step(TOOTH_SIDE - 1, 0));
    }
}
