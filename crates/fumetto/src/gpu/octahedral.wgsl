// Unit vectors as points of an unfolded octahedron, in two snorm16 (Meyer et al., "On Floating-Point Normal
// Vectors", 2010).

fn octahedral_fold(p: vec2f) -> vec2f {
    return (1.0 - abs(p.yx)) * select(vec2f(-1.0), vec2f(1.0), p >= vec2f(0.0));
}

fn octahedral_packed(normal: vec3f) -> u32 {
    let p = normal.xy / max(abs(normal.x) + abs(normal.y) + abs(normal.z), 1e-20);
    return pack2x16snorm(select(p, octahedral_fold(p), normal.z < 0.0));
}

fn octahedral_unpacked(packed: u32) -> vec3f {
    let p = unpack2x16snorm(packed);
    let z = 1.0 - abs(p.x) - abs(p.y);
    return normalize(vec3f(select(p, octahedral_fold(p), z < 0.0), z));
}
