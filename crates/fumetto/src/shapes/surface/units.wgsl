// Sums over lists. Lists are in no order, and a sum of floats depends on it: so all that is added is rounded to units
// first, and sums of whole numbers are the same in any order.

// A point of so many units of density is inside, whatever noise does. Beyond four times this, floats have no ones.
const INSIDE_UNITS: f32 = 4194304.0;
const FULL_UNITS: f32 = 2.0 * INSIDE_UNITS;
// Units of a gradient of one threshold for each cell. Sums of what is steeper than 2048 thresholds for each cell wrap
// around: in any order alike, too.
const SLOPE_UNITS: f32 = 1048576.0;

// What the field is measured in.
struct Units {
    cell_m: f32,
    // One of density, and one of its gradient.
    density: f32,
    slope: f32,
}

fn units() -> Units {
    let cell_m = lattice.cell_m;
    let density = recipe.threshold * (1.0 + recipe.noise_amplitude) / INSIDE_UNITS;
    return Units(cell_m, density, recipe.threshold / (SLOPE_UNITS * cell_m));
}
