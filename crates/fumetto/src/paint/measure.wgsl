// How far volumes reach at least and at most: a workgroup each.

@group(0) @binding(0) var<storage, read> vertices: array<vec2f>;
@group(0) @binding(1) var<storage, read_write> bodies: array<Body>;

const LANES: u32 = 64u;

var<workgroup> nearest: array<f32, LANES>;
var<workgroup> farthest: array<f32, LANES>;

@compute @workgroup_size(64)
fn main(@builtin(workgroup_id) id: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    // Beyond the last body, the last one is measured again.
    let slot = min(id.y * groups.x + id.x, arrayLength(&bodies) - 1u);
    let first = bodies[slot].first_vertex;
    let count = 10u * bodies[slot].pieces * bodies[slot].pieces + 2u;
    var near = 1e30;
    var far = 0.0;
    for (var vertex = lane; vertex < count; vertex += LANES) {
        let radius = vertices[first + vertex].x;
        near = min(near, radius);
        far = max(far, radius);
    }
    nearest[lane] = near;
    farthest[lane] = far;
    workgroupBarrier();
    if lane == 0u {
        for (var other = 1u; other < LANES; other++) {
            near = min(near, nearest[other]);
            far = max(far, farthest[other]);
        }
        bodies[slot].near = near;
        bodies[slot].far = far;
    }
}
