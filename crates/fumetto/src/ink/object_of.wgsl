// The object that a number in the id layer belongs to. Uses `puffs`, `triangles` and `parts` of the program that
// it is part of.
fn object_of(id: u32) -> u32 {
    if (id & TRIANGLE_BIT) != 0u {
        return parts[triangles[id & ~TRIANGLE_BIT].part].object;
    }
    return puff_object(puffs[id - 1u]);
}
