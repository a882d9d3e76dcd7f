// Lays a cel with its ink over what is there, and averages the samples of each pixel in linear light.

// One sample a pixel and nothing half transparent: colours are only copied.
override HARD: bool = false;

struct Compose {
    // Samples along each side of a pixel.
    samples: i32,
    // 0 nothing, 1 an image stretched over the picture, 2 one scaled to cover it.
    under: u32,
    // Pixels along a cell of the layer that tells how much ink is around.
    cell: f32,
    // Area of the gathering window, in pixels.
    window: f32,
}

@group(0) @binding(0) var<uniform> compose: Compose;
@group(0) @binding(1) var<uniform> styles: array<ObjectStyle, MAX_OBJECTS>;
@group(0) @binding(2) var cel: texture_2d<f32>;
@group(0) @binding(3) var ink: texture_2d<u32>;
@group(0) @binding(4) var around: texture_2d<f32>;
@group(0) @binding(5) var under: texture_2d<f32>;
@group(0) @binding(6) var linear: sampler;

// What lies under the cel; straight alpha, encoded.
fn under_at(position: vec2f, size: vec2f) -> vec4f {
    if compose.under == 0u {
        return vec4f(0.0);
    }
    let image = vec2f(textureDimensions(under));
    let cover = max(size.x / image.x, size.y / image.y) * image;
    let shown = select(size, cover, compose.under == 2u);
    return textureSampleLevel(under, linear, 0.5 + (position - 0.5 * size) / shown, 0.0);
}

// The cel with its ink at one sample; straight alpha, encoded.
fn drawn_at(at: vec2i) -> vec4f {
    let mark = textureLoad(ink, at, 0).xy;
    if mark.x != 0u {
        let style = styles[mark.x - 1u];
        let cells = vec2f(at) / (compose.cell * vec2f(textureDimensions(around)));
        let inked_px = textureSampleLevel(around, linear, cells, 0.0).x * compose.window;
        // A line is at least as wide as it is where the light thins it.
        let narrowest = style.ink_width_px * (1.0 - style.ink_lit_thinning);
        if inked_px >= style.ink_shortest_px * narrowest * 0.7 {
            return vec4f(style.ink_colour, style.opacity * f32(mark.y) / 255.0);
        }
    }
    return textureLoad(cel, at, 0);
}

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let size = vec2f(textureDimensions(cel)) / f32(compose.samples);
    let first = vec2i(position.xy) * compose.samples;
    let below = under_at(position.xy, size);
    if HARD {
        let drawn = drawn_at(first);
        return select(below, vec4f(drawn.rgb, 1.0), drawn.a > 0.0);
    }
    var sum = vec4f(0.0);
    for (var y = 0; y < compose.samples; y++) {
        for (var x = 0; x < compose.samples; x++) {
            let drawn = drawn_at(first + vec2i(x, y));
            sum += vec4f(decoded(drawn.rgb) * drawn.a, drawn.a);
        }
    }
    sum /= f32(compose.samples * compose.samples);
    let over = sum + vec4f(decoded(below.rgb) * below.a, below.a) * (1.0 - sum.a);
    return vec4f(encoded(over.rgb / max(over.a, 1e-6)), over.a);
}
