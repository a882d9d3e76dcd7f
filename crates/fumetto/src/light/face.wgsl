// Faces of shadow volumes as they are counted: what lies behind what is seen adds one where the ray from the
// camera leaves a volume, and takes one away where it enters. So a camera inside a volume changes nothing.

@group(0) @binding(1) var<uniform> lights: Lights;
@group(0) @binding(2) var<uniform> volumes: Volumes;
@group(0) @binding(3) var<storage, read> vertices: array<Vertex>;

struct Corner {
    // As the body's, so that a cap lies exactly on its triangle.
    @builtin(position) @invariant position: vec4f,
    // -1 on what is seen from outside when its corners run clockwise.
    @location(0) @interpolate(flat) way: f32,
}

// Where light that passes a place goes, infinitely far away: a direction, for which depth is 0.
fn clip_at_infinity(place: vec3f) -> vec4f {
    let light = lights.light[volumes.light];
    let away = (view.view_from_world * vec4f(place * light.is_point - light.vector, 0.0)).xyz;
    return clip_of_view(away, 0.0);
}

@fragment
fn fragment(corner: Corner, @builtin(front_facing) is_front: bool) -> @location(0) f32 {
    return select(1.0, -1.0, is_front) * corner.way;
}
