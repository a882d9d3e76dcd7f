// Outlines of puffs, into the ink.

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec2u {
    let px = vec2u(position.xy);
    let inside = px % vec2u(4u, 2u);
    let marks = textureLoad(found, px / vec2u(4u, 2u))[2u * inside.y + inside.x / 2u];
    let mark = select(marks & 0xffffu, marks >> 16u, (inside.x & 1u) != 0u);
    if mark == 0u {
        discard;
    }
    return vec2u(mark & 0xffu, mark >> 8u);
}
