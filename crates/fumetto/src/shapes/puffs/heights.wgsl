// The atlas's heights and margins, four neighbours in a texel, so that one look-up finds all that is mixed
// between texels: height and margin in bytes, of this texel, the right one, those below.

@group(0) @binding(0) var atlas_texture: texture_2d<f32>;

fn bytes_at(at: vec2u) -> u32 {
    let texel = textureLoad(atlas_texture, min(at, textureDimensions(atlas_texture) - 1u), 0).zw;
    return pack4x8unorm(vec4f(texel, 0.0, 0.0));
}

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec2u {
    let at = vec2u(position.xy);
    return vec2u(
        bytes_at(at) | (bytes_at(at + vec2u(1u, 0u)) << 16u),
        bytes_at(at + vec2u(0u, 1u)) | (bytes_at(at + vec2u(1u, 1u)) << 16u),
    );
}
