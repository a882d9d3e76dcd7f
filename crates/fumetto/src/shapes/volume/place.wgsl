// Brings the surfaces that rays have met into the depth and id layers.

@group(0) @binding(0) var hits: texture_2d<u32>;

struct Placed {
    @location(0) id: u32,
    @builtin(frag_depth) depth: f32,
}

@fragment
fn fragment(@builtin(position) position: vec4f) -> Placed {
    let hit = textureLoad(hits, vec2i(position.xy), 0);
    if hit.x == 0u {
        discard;
    }
    return Placed(hit.x, bitcast<f32>(hit.y));
}
