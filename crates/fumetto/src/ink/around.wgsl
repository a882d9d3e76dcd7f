// How much ink there is around each cell: the mean over five by five.

@group(0) @binding(0) var shares: texture_2d<f32>;

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let last = vec2i(textureDimensions(shares)) - 1;
    var sum = 0.0;
    for (var y = -2; y <= 2; y++) {
        for (var x = -2; x <= 2; x++) {
            sum += textureLoad(shares, clamp(vec2i(position.xy) + vec2i(x, y), vec2i(0), last), 0).x;
        }
    }
    return vec4f(sum / 25.0);
}
