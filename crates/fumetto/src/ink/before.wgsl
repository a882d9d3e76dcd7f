// What lies before a line beside its middle, and which line covers which. Uses `triangles` and `parts` of the program
// that it is part of.

// What is nearer than a line by this many times its offset from the line's middle hides that half of it: of the
// same object, whose surface bulges, and of another.
const OWN_BULGE: f32 = 40.0;
const OTHER_BULGE: f32 = 4.0;

// Share of its depth by which a line of one rank may lie behind one of the next and still cover it: outlines go
// over the ends of inner lines. Ranks are of silhouettes, creases, boundaries and borders of materials.
const RANK_STEP: f32 = 4e-4;
const RANKS: vec4f = vec4f(4.0, 2.0, 3.0, 1.0);

// Whether the surface that a pixel shows is of another object.
fn is_other(id: u32, object: u32) -> bool {
    if (id & TRIANGLE_BIT) == 0u {
        return id != 0u;
    }
    return parts[triangles[id & ~TRIANGLE_BIT].part].object != object;
}
