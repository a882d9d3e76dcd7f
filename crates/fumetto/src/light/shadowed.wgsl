// Turns the mask's bits into channels.

@group(0) @binding(0) var<uniform> casting: Casting;
@group(0) @binding(1) var<storage, read> mask: array<u32>;

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let at = vec2u(position.xy);
    let index = at.y * casting.size.x + at.x;
    let bits = mask[index / (32u / TEXEL_BITS)] >> (index % (32u / TEXEL_BITS) * TEXEL_BITS);
    return vec4f((vec4u(bits) >> vec4u(0u, 1u, 2u, 3u)) & vec4u(1u));
}
