// Light to flat colour: the diffuse term of every light through the object's ramp (McGuire & Fein 2004,
// section 1.2).

// Whether any pixel may show a triangle.
override HAS_MESHES: bool = false;

// Whether this paints straight into the picture, where nothing is half transparent.
override IS_PICTURE: bool = false;

// Whether any object's style asks for these.
override HAS_ROWS: bool = false;
override HAS_GOOCH: bool = false;
override HAS_HIGHLIGHT: bool = false;
override HAS_RIM: bool = false;
override HAS_EXAGGERATION: bool = false;
override HAS_STEPS: bool = false;
override HAS_HATCHING: bool = false;

// Whether any pixel may show a volume.
override HAS_VOLUMES: bool = false;

struct Sampling {
    // Pixels of the picture to one texel of the normal layer.
    step: i32,
    form_side: f32,
    form_objects: f32,
    // The same of the smoothed distances that strokes are laid on.
    ground_step: i32,
    // What lies so much farther is another form, in pixels as deep as wide.
    ground_far_px: f32,
}

@group(0) @binding(1) var<uniform> sampling: Sampling;
@group(0) @binding(2) var<uniform> lights: Lights;
@group(0) @binding(3) var<storage, read> puffs: array<Puff>;
@group(0) @binding(4) var<uniform> styles: array<ObjectStyle, MAX_OBJECTS>;
@group(0) @binding(5) var id_layer: texture_2d<u32>;
@group(0) @binding(6) var depth_layer: texture_depth_2d;
@group(0) @binding(7) var normals: texture_2d<f32>;
@group(0) @binding(8) var shadows: texture_2d<f32>;
@group(0) @binding(9) var ramps: texture_2d<f32>;
@group(0) @binding(10) var linear: sampler;
@group(0) @binding(11) var<storage, read> sources: array<Source>;
@group(0) @binding(12) var<storage, read> vertices: array<Vertex>;
@group(0) @binding(13) var<storage, read> triangles: array<Triangle>;
@group(0) @binding(14) var<storage, read> parts: array<Part>;
@group(0) @binding(15) var textures: texture_2d_array<f32>;
@group(0) @binding(16) var textures_sampler: sampler;
@group(0) @binding(17) var<storage, read> smoothed: array<u32>;
@group(0) @binding(18) var<storage, read> grids: array<FormGrid>;
@group(0) @binding(19) var form_field: texture_3d<f32>;
@group(0) @binding(20) var<uniform> tones: array<ToneStyle, MAX_OBJECTS>;
@group(0) @binding(21) var hits: texture_2d<u32>;
@group(0) @binding(22) var light_layer: texture_2d<f32>;
@group(0) @binding(23) var<uniform> hatches: array<HatchStyle, MAX_OBJECTS>;
@group(0) @binding(24) var ground_layer: texture_2d<f32>;
@group(0) @binding(25) var turns_layer: texture_2d<f32>;

// The normal between the layer's texels, from those that lie about as deep.
fn normal_at(px: vec2i, distance: f32) -> vec3f {
    if sampling.step == 1 {
        return textureLoad(normals, px, 0).xyz;
    }
    let at = vec2f(px) / f32(sampling.step);
    let cell = vec2i(floor(at));
    let part = at - floor(at);
    let last = vec2i(textureDimensions(normals)) - 1;
    var normal = vec3f(0.0);
    for (var corner = 0; corner < 4; corner++) {
        let step = vec2i(corner & 1, corner >> 1);
        let texel = textureLoad(normals, min(cell + step, last), 0);
        let bilinear = select(1.0 - part, part, step == vec2i(1));
        // Texels elsewhere in depth count for almost nothing, unless there are no others.
        let apart = abs(texel.w - log2(distance)) * 64.0;
        normal += texel.xyz * ((bilinear.x * bilinear.y + 1e-3) / (1.0 + apart * apart * apart * apart));
    }
    return normal;
}

// What a pixel shows.
struct Seen {
    object: u32,
    opacity: f32,
    // Unit length.
    normal: vec3f,
    // What tones are multiplied by; linear.
    colour: vec3f,
    // Of a triangle: its corners' numbers and weights, its part, and the side that is seen, 1 or -1. Of a
    // puff: 0.
    corners: vec3u,
    weights: vec3f,
    part: u32,
    side: f32,
    // Of a volume: how much of each light that throws shadows comes through it, and of its own there is.
    through: vec4f,
    heat: f32,
}

fn seen_at(id: u32, px: vec2i, distance: f32) -> Seen {
    var seen: Seen;
    if HAS_MESHES && (id & TRIANGLE_BIT) != 0u {
        let surface = mesh_surface(id & ~TRIANGLE_BIT, vec2f(px) + 0.5);
        seen.object = parts[surface.part].object;
        seen.opacity = 1.0;
        seen.normal = surface.normal;
        seen.colour = mix(vec3f(1.0), own_colour(surface.colour.rgb, seen.object), styles[seen.object].material);
        seen.corners = surface.corners;
        seen.weights = surface.weights;
        seen.part = surface.part;
        seen.side = surface.side;
        return seen;
    }
    let puff = puffs[id - 1u];
    let normal = normal_at(px, distance);
    seen.object = puff_object(puff);
    seen.opacity = puff_fade(puff).y;
    seen.normal = normal / max(length(normal), 1e-6);
    seen.colour = vec3f(1.0);
    if is_volume(seen.object) {
        let own = unpack4x8unorm(textureLoad(hits, px, 0).w);
        seen.opacity = 1.0;
        seen.heat = own.a;
        seen.colour = mix(vec3f(1.0), own_colour(own.rgb, seen.object), styles[seen.object].material);
        seen.through = textureLoad(light_layer, px, 0);
    }
    return seen;
}

fn is_volume(object: u32) -> bool {
    return HAS_VOLUMES && (styles[object].flags & IS_VOLUME) != 0u;
}

// The own colour of a mesh or a volume, as its style takes it.
fn own_colour(linear: vec3f, object: u32) -> vec3f {
    if HAS_STEPS && tones[object].material_steps > 0.0 {
        return quantised(linear, tones[object].material_steps);
    }
    return linear;
}

// Where a pixel is, and from where it is seen.
struct Sight {
    px: vec2f,
    distance: f32,
    place: vec3f,
    toward_eye: vec3f,
}

// What one light adds where nothing keeps it away; relief shows in the first.
fn amount_of(number: u32, seen: Seen, at: Sight, toward_light: vec3f) -> f32 {
    let light = lights.light[number];
    let wrap = select(styles[seen.object].wrap, 1.0, HAS_GOOCH && tones[seen.object].is_gooch != 0u);
    var plain = diffuse(light, seen.normal, toward_light, wrap);
    if is_volume(seen.object) {
        let through = select(1.0, seen.through[max(light.channel, 0)], light.channel >= 0);
        plain = through * mix(light.intensity, plain, styles[seen.object].relief);
    }
    if HAS_EXAGGERATION && number == 0u && tones[seen.object].exaggerate_amount > 0.0 {
        let relief = light.intensity * exaggerated(seen, at, toward_light, tones[seen.object]);
        return mix(plain, relief, tones[seen.object].exaggerate_amount);
    }
    return plain;
}

// The colour of an amount of light, encoded; `shine` is the highlight's term.
fn colour_of(seen: Seen, at: Sight, amount: f32, shine: f32) -> vec3f {
    let facing = max(dot(seen.normal, at.toward_eye), 0.0);
    if HAS_HIGHLIGHT && shine >= tones[seen.object].highlight_from {
        return tones[seen.object].highlight_colour;
    }
    if HAS_RIM && facing < tones[seen.object].rim_width && amount >= tones[seen.object].rim_from {
        return tones[seen.object].rim_colour;
    }
    if HAS_GOOCH && tones[seen.object].is_gooch != 0u {
        return cool_to_warm(tones[seen.object], seen.colour, amount);
    }
    var row = styles[seen.object].ramp_row;
    if HAS_ROWS && tones[seen.object].axis != AXIS_NONE {
        row = row_of(tones[seen.object], facing, at.place, at.distance);
    }
    let colour = ramp_colour(ramps, amount, row);
    // White leaves a picked tone exactly as it is.
    if (HAS_MESHES || HAS_VOLUMES) && any(abs(seen.colour - 1.0) > vec3f(1e-3)) {
        return encoded(decoded(colour) * seen.colour);
    }
    return colour;
}

// A colour, encoded, with strokes over it.
fn hatched_over(colour: vec3f, seen: Seen, at: Sight, id: u32, amount: f32) -> vec3f {
    let style = hatches[seen.object];
    if style.follow == FOLLOW_NOTHING {
        return colour;
    }
    let cover = hatched(style, laid_at(style, seen, id, at.px, at.distance), amount, at.px);
    if cover == 0.0 || cover == 1.0 {
        return select(colour, style.colour, cover == 1.0);
    }
    return encoded(mix(decoded(colour), decoded(style.colour), cover));
}

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let px = vec2i(position.xy);
    let id = textureLoad(id_layer, px, 0).x;
    if id == 0u {
        discard;
    }
    let distance = distance_of(textureLoad(depth_layer, px, 0));
    let seen = seen_at(id, px, distance);
    if (styles[seen.object].flags & IS_MASK) != 0u {
        discard;
    }
    let place = (view.world_from_view * vec4f(ray_of(position.xy) * distance, 1.0)).xyz;
    let at = Sight(position.xy, distance, place, normalize(view.world_from_view[3].xyz - place));
    let shadow = textureSampleLevel(shadows, linear, position.xy / view.size_px, 0.0);
    let shows_shadows = (styles[seen.object].flags & SHOWS_SHADOWS) != 0u;
    var amount = select(0.0, styles[seen.object].glow * seen.heat, HAS_VOLUMES);
    var shine = 0.0;
    for (var i = 0u; i < lights.count; i++) {
        let light = lights.light[i];
        let kept = select(0.0, kept_of(light, shadow), shows_shadows);
        let toward_light = toward(light, place);
        amount += amount_of(i, seen, at, toward_light) * (1.0 - kept);
        if HAS_HIGHLIGHT {
            let gloss = tones[seen.object].gloss;
            shine = max(shine, select(blinn_phong(light, seen.normal, toward_light, at.toward_eye, gloss), 0.0, kept >= 0.5));
        }
    }
    var colour = colour_of(seen, at, amount, shine);
    if HAS_HATCHING {
        colour = hatched_over(colour, seen, at, id, amount);
    }
    return vec4f(colour, select(styles[seen.object].opacity * seen.opacity, 1.0, IS_PICTURE));
}
