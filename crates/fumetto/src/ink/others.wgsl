// What may hide the lines of inner surfaces: all that is drawn but the surfaces that they lie inside.

// Layers of detail of one level are looked at together; 0 are the first ones.
@group(0) @binding(0) var<uniform> level: u32;
@group(0) @binding(1) var<uniform> styles: array<ObjectStyle, MAX_OBJECTS>;
@group(0) @binding(2) var<storage, read> puffs: array<Puff>;
@group(0) @binding(3) var<storage, read> triangles: array<Triangle>;
@group(0) @binding(4) var<storage, read> parts: array<Part>;
@group(0) @binding(5) var id_layer: texture_2d<u32>;
@group(0) @binding(6) var depth_layer: texture_depth_2d;

struct Other {
    @location(0) id: u32,
    @builtin(frag_depth) depth: f32,
}

@fragment
fn fragment(@builtin(position) position: vec4f) -> Other {
    let px = vec2i(position.xy);
    let id = textureLoad(id_layer, px, 0).x;
    if id == 0u || styles[object_of(id)].details > level {
        discard;
    }
    return Other(id, textureLoad(depth_layer, px, 0));
}
