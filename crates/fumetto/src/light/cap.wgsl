// Caps of shadow volumes: the triangles that throw them, and the same infinitely far away.

// Whether these are the far ones.
override IS_FAR: bool = false;

@group(0) @binding(4) var<storage, read> triangles: array<Triangle>;
@group(0) @binding(5) var<storage, read> caps: array<u32>;

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Corner {
    let cap = caps[index / 3u];
    let place = vertices[triangles[cap & ~TURNED].corners[index % 3u]].position;
    let way = select(1.0, -1.0, (cap & TURNED) != 0u);
    if IS_FAR {
        return Corner(clip_at_infinity(place), -way);
    }
    return Corner(clip_from_world(place), way);
}
