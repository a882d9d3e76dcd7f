// Shades every puff sprite to flat tones, once for all puffs that show it (McGuire & Fein 2004, section
// 1.2, the fixed-function variant). Light must come from suns: it is the same for all puffs.

@group(0) @binding(1) var<uniform> atlas: Atlas;
@group(0) @binding(2) var<uniform> lights: Lights;
@group(0) @binding(3) var<uniform> styles: array<ObjectStyle, MAX_OBJECTS>;
@group(0) @binding(4) var atlas_texture: texture_2d<f32>;
@group(0) @binding(5) var linear: sampler;
@group(0) @binding(6) var ramps: texture_2d<f32>;

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let tile = vec2u(position.xy / SPRITE_PX);
    let style = styles[tile.y / ROTATIONS];
    let angle = f32(tile.y % ROTATIONS) * (6.2831853 / f32(ROTATIONS));
    let p = (fract(position.xy / SPRITE_PX) * 2.0 - 1.0) * vec2f(TILE_EXTENT, -TILE_EXTENT);
    let level = max(log2(atlas.tile_px / SPRITE_PX), 0.0);
    let texel = textureSampleLevel(atlas_texture, linear, atlas_uv(p, f32(tile.x), floor(level), atlas), 0.0);
    let flat_normal = screen_from_puff(texel_normal(texel), vec2f(cos(angle), sin(angle)));
    let own = vec3f(flat_normal, sqrt(max(1.0 - dot(flat_normal, flat_normal), 0.0)));
    let normal = normalize((view.world_from_view * vec4f(own, 0.0)).xyz);
    var amount = 0.0;
    for (var i = 0u; i < lights.count; i++) {
        let light = lights.light[i];
        amount += diffuse(light, normal, toward(light, vec3f(0.0)), style.wrap);
    }
    return vec4f(ramp_colour(ramps, amount, style.ramp_row), 1.0);
}
