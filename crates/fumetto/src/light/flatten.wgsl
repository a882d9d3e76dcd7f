// The depth layer, thinned out for the stencil.

struct Flatten {
    step: u32,
}

@group(0) @binding(0) var<uniform> flatten: Flatten;
@group(0) @binding(1) var depth_layer: texture_depth_2d;

@fragment
fn fragment(@builtin(position) position: vec4f) -> @builtin(frag_depth) f32 {
    let last = vec2i(textureDimensions(depth_layer)) - 1;
    return textureLoad(depth_layer, min(vec2i(position.xy) * i32(flatten.step), last), 0);
}
