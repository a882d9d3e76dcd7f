// The depth that each texel of the mask stands for, where software rasterisers read it quickly: `cast` looks there
// many times.

@group(0) @binding(0) var<uniform> casting: Casting;
@group(0) @binding(1) var depth_layer: texture_depth_2d;

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) f32 {
    let at = vec2i(position.xy) * i32(casting.step);
    return textureLoad(depth_layer, min(at, vec2i(textureDimensions(depth_layer)) - 1), 0);
}
