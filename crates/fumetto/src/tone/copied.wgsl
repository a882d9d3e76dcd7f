// Copies pre-shaded sprites to where the id layer shows their puffs. Where any light is kept away, the
// darkest tone takes their place.

// Whether this paints straight into the picture, where nothing is half transparent.
override IS_PICTURE: bool = false;

@group(0) @binding(1) var<storage, read> puffs: array<Puff>;
@group(0) @binding(2) var<uniform> styles: array<ObjectStyle, MAX_OBJECTS>;
@group(0) @binding(3) var id_layer: texture_2d<u32>;
@group(0) @binding(4) var sprites: texture_2d<f32>;
@group(0) @binding(5) var ramps: texture_2d<f32>;
@group(0) @binding(6) var shadows: texture_2d<f32>;
@group(0) @binding(7) var linear: sampler;

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let id = textureLoad(id_layer, vec2i(position.xy), 0).x;
    if id == 0u {
        discard;
    }
    let puff = puffs[id - 1u];
    let object = puff_object(puff);
    let sprite = sprite_of(puff);
    let p = puff_from_px(position.xy - sprite.px, sprite.radius_px, puff_rotation(puff));
    let inside = clamp(vec2f(p.x, -p.y) * (0.5 / TILE_EXTENT) + 0.5, vec2f(0.0), vec2f(0.999));
    let rotation = ((puff.look >> 16u) * ROTATIONS + 32768u) >> 16u;
    let tile = vec2u(puff_variant(puff), object * ROTATIONS + rotation % ROTATIONS);
    var colour = textureLoad(sprites, vec2i((vec2f(tile) + inside) * SPRITE_PX), 0).rgb;
    let shadow = textureSampleLevel(shadows, linear, position.xy / view.size_px, 0.0);
    let kept = (styles[object].flags & SHOWS_SHADOWS) != 0u && any(shadow >= vec4f(0.5));
    colour = select(colour, ramp_colour(ramps, 0.0, styles[object].ramp_row), kept);
    return vec4f(colour, select(styles[object].opacity * puff_fade(puff).y, 1.0, IS_PICTURE));
}
