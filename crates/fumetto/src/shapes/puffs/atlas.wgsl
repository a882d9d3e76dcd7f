// Renders bundles of balls to the atlas, one column a variant: normal x and y, height over the middle,
// and margin (McGuire & Fein 2004, section 1.1). Smaller and smaller copies lie below each other.

struct Bundles {
    tile_px: f32,
    // Half the width of a tile over the puff's radius.
    extent: f32,
    balls: u32,
    holes: u32,
}

@group(0) @binding(0) var<uniform> bundles: Bundles;
// Middle and radius; `balls` to a variant.
@group(0) @binding(1) var<storage, read> balls: array<vec4f>;
// Middle, and the erosion at which it opens; `holes` to a variant.
@group(0) @binding(2) var<storage, read> holes: array<vec4f>;

// How much erosion the matter at `p` outlives: each ball shrinks on its own, so that a bundle breaks
// up into smaller scallops, and holes open in the middle. Negative outside, there the distance.
fn margin_at(p: vec2f, variant: u32) -> f32 {
    var margin = -1e9;
    for (var i = 0u; i < bundles.balls; i++) {
        let ball = balls[variant * bundles.balls + i];
        margin = max(margin, ball.w - distance(p, ball.xy));
    }
    if margin <= 0.0 {
        return margin;
    }
    // A ball of average size is gone at erosion 1, larger ones last no longer.
    margin = margin / (0.5 * margin + 0.3);
    for (var i = 0u; i < bundles.holes; i++) {
        let hole = holes[variant * bundles.holes + i];
        margin = min(margin, hole.w + distance(p, hole.xy));
    }
    return clamp(margin, 1e-4, 0.999);
}

fn texel_at(p: vec2f, variant: u32) -> vec4f {
    var height = 0.0;
    var normal = vec2f(0.0);
    // Two texels farther, normals go on as at the rim: between texels they are mixed with those inside.
    var nearest = -4.0 * bundles.extent / bundles.tile_px;
    for (var i = 0u; i < bundles.balls; i++) {
        let ball = balls[variant * bundles.balls + i];
        let offset = (p - ball.xy) / ball.w;
        let inside = 1.0 - dot(offset, offset);
        let top = ball.z + ball.w * sqrt(max(inside, 0.0));
        if inside > 0.0 && top > height {
            height = top;
            normal = offset;
        }
        let margin = ball.w - distance(p, ball.xy);
        if height == 0.0 && ball.w > 0.0 && margin > nearest {
            nearest = margin;
            normal = offset / max(length(offset), 1.0);
        }
    }
    return vec4f(0.5 + 0.5 * normal, height, (margin_at(p, variant) + 0.5) / 1.5);
}

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    // Copies of the tile begin at 0, 1, 1½, 1¾… of its height.
    let level = floor(-log2(1.0 - 0.5 * position.y / bundles.tile_px));
    let side = bundles.tile_px * exp2(-level);
    let top = bundles.tile_px * (2.0 - 2.0 * exp2(-level));
    let variant = u32(position.x / bundles.tile_px);
    let at = vec2f(position.x - f32(variant) * bundles.tile_px, position.y - top);
    if at.x >= side {
        return vec4f(0.0);
    }
    // A texel of a copy is the mean of what the tile shows there.
    let samples = u32(min(exp2(level), 4.0));
    var sum = vec4f(0.0);
    for (var i = 0u; i < samples * samples; i++) {
        let inside = (vec2f(vec2u(i % samples, i / samples)) + 0.5) / f32(samples) - 0.5;
        let uv = (at + inside) / side;
        sum += texel_at((uv * 2.0 - 1.0) * vec2f(bundles.extent, -bundles.extent), variant);
    }
    return sum / f32(samples * samples);
}
