// Copies pre-shaded sprites to where the id layer shows their puffs. Where any light is kept away, the
// darkest tone takes their place.

// Whether this paints straight into the picture, where nothing is half transparent.
override IS_PICTURE: bool = false;
// Whether anything throws shadows.
override HAS_SHADOWS: bool = true;

@group(0) @binding(1) var projected: texture_storage_2d<rgba32uint, read>;
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
    let at = bitcast<vec4f>(textureLoad(projected, projected_at(id - 1u, 0u)));
    let picture = picture_unpacked(textureLoad(projected, projected_at(id - 1u, 1u)));
    let puff = textureLoad(projected, projected_at(id - 1u, 2u)).yz;
    let object = (puff.x >> 8u) & 0xffu;
    let offset = position.xy - at.xy;
    let turned = vec2f(-picture.step.y, picture.step.x);
    // The puff's frame is that of its picture, whose texels are as wide as steps are long.
    let p = (offset.x * picture.step + offset.y * turned) / (length(picture.step) * at.z);
    let inside = clamp(p * (0.5 / TILE_EXTENT) + 0.5, vec2f(0.0), vec2f(0.999));
    let rotation = ((puff.x >> 16u) * ROTATIONS + 32768u) >> 16u;
    let tile = vec2u(puff.x & 0xffu, object * ROTATIONS + rotation % ROTATIONS);
    var colour = textureLoad(sprites, vec2i((vec2f(tile) + inside) * SPRITE_PX), 0).rgb;
    if HAS_SHADOWS {
        let shadow = textureSampleLevel(shadows, linear, position.xy / view.size_px, 0.0);
        let kept = (styles[object].flags & SHOWS_SHADOWS) != 0u && any(shadow >= vec4f(0.5));
        colour = select(colour, ramp_colour(ramps, 0.0, styles[object].ramp_row), kept);
    }
    return vec4f(colour, select(styles[object].opacity * unpack2x16unorm(puff.y).y, 1.0, IS_PICTURE));
}
