// What vortices give to places; goes behind `tree` and `induced`.

struct Probe {
    places: u32,
    count: u32,
    pad0: u32,
    pad1: u32,
}

@group(0) @binding(0) var<uniform> probe: Probe;
@group(0) @binding(1) var<storage, read> leaves: array<Leaf>;
@group(0) @binding(2) var<storage, read> nodes: array<Node>;
@group(0) @binding(3) var<storage, read_write> found: array<vec4f>;

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    let item = group.x * 256u + lane;
    if item < probe.count {
        found[item] = vec4f(induced(found[item].xyz, probe.places), 0.0);
    }
}
