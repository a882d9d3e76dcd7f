// Fills the normal layer from the id layer: the puff's own normal, or that of a volume's surface, bent toward
// the form of the cloud.
// Also keeps the distance, as a logarithm so that half floats hold it to a thousandth, for passes that
// must not mix what lies far apart.

// Halvings of the puff's picture that its normals are taken from when only the form counts.
const SMOOTHING: f32 = 5.0;

struct Sampling {
    // Pixels of the picture to one texel of this layer.
    step: u32,
    form_side: f32,
    form_objects: f32,
}

@group(0) @binding(1) var<uniform> atlas: Atlas;
@group(0) @binding(2) var<uniform> sampling: Sampling;
@group(0) @binding(3) var<storage, read> puffs: array<Puff>;
@group(0) @binding(4) var<uniform> styles: array<ObjectStyle, MAX_OBJECTS>;
@group(0) @binding(5) var<storage, read> grids: array<FormGrid>;
@group(0) @binding(6) var atlas_texture: texture_2d<f32>;
@group(0) @binding(7) var linear: sampler;
@group(0) @binding(8) var form_field: texture_3d<f32>;
@group(0) @binding(9) var id_layer: texture_2d<u32>;
@group(0) @binding(10) var depth_layer: texture_depth_2d;
@group(0) @binding(11) var hits: texture_2d<u32>;

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let at = vec2i(position.xy) * i32(sampling.step);
    let id = textureLoad(id_layer, at, 0).x;
    if id == 0u {
        return vec4f(0.0);
    }
    let puff = puffs[id - 1u];
    let sprite = sprite_of(puff);
    let rotation = puff_rotation(puff);
    let px = vec2f(at) + 0.5;
    let p = puff_from_px(px - sprite.px, sprite.radius_px, rotation);
    let object = puff_object(puff);
    let form = styles[object].form;
    // The more the cloud counts, the smoother is the single puff: its bumps would only be flecks.
    let level = min(atlas_level(sprite.radius_px, atlas) + round(SMOOTHING * form), atlas.levels - 1.0);
    let inside = p * (min(length(p), 0.98) / max(length(p), 1e-3));
    let uv = atlas_uv(inside, f32(puff_variant(puff)), level, atlas);
    let texel = textureSampleLevel(atlas_texture, linear, uv, 0.0);
    let flat_normal = screen_from_puff(texel_normal(texel), rotation);
    let own = vec3f(flat_normal, sqrt(max(1.0 - dot(flat_normal, flat_normal), 0.0)));
    var own_world = (view.world_from_view * vec4f(own, 0.0)).xyz;
    if (styles[object].flags & IS_VOLUME) != 0u {
        own_world = octahedral_unpacked(textureLoad(hits, at, 0).z);
    }
    let distance = distance_of(textureLoad(depth_layer, at, 0));
    let place = (view.world_from_view * vec4f(ray_of(px) * distance, 1.0)).xyz;
    let bent = mix(own_world, form_at(place, object), form);
    return vec4f(bent / max(length(bent), 1e-4), log2(distance));
}
