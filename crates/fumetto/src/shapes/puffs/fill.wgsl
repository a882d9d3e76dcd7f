// The nearest puffs, into depth and id, where nothing else is nearer.

struct Body {
    @builtin(frag_depth) depth: f32,
    @location(0) id: u32,
}

@fragment
fn fragment(@builtin(position) position: vec4f) -> Body {
    let px = vec2u(position.xy);
    let pair = textureLoad(found, px / vec2u(2u, 1u));
    let seen = select(pair.xy, pair.zw, (px.x & 1u) != 0u);
    return Body(select(0.0, bitcast<f32>(seen.y), seen.x != 0u), seen.x);
}
