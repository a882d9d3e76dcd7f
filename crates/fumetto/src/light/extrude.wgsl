// Finds the faces of shadow volumes (Crow 1977): which triangles are their caps, and at which edges they
// have sides.
//
// Every triangle that throws a shadow has a volume of its own, an endless prism, whose cap looks toward the
// light. Where two of them meet, their sides cancel; what is left over is drawn as often as it is left over
// (Kim, Kim & Turk 2008, "A shadow-volume algorithm for opaque and transparent nonmanifold casters"). So
// volumes are closed whatever the triangles are: open, crossing, or three and more on an edge.

@group(0) @binding(1) var<uniform> lights: Lights;
@group(0) @binding(2) var<uniform> volumes: Volumes;
@group(0) @binding(3) var<storage, read> vertices: array<Vertex>;
@group(0) @binding(4) var<storage, read> triangles: array<Triangle>;
@group(0) @binding(5) var<storage, read> casting: array<u32>;
@group(0) @binding(6) var<storage, read> edges: array<Edge>;

// Sine of the angle up to which a facet that looks away from the light may still be lit in parts, where its
// shading is smooth: that between the facets of a ball of 18 segments.
const TERMINATOR: f32 = 0.34;

@compute @workgroup_size(256)
fn list_caps(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let number = (group.y * groups.x + group.x) * 256u + lane;
    if number >= volumes.triangles {
        return;
    }
    let light = lights.light[volumes.light];
    let corners = triangles[number].corners;
    let a = vertices[corners.x].position;
    let normal = cross(vertices[corners.y].position - a, vertices[corners.z].position - a);
    let toward = light.vector - a * light.is_point;
    let lit = dot(normal, toward);
    let seen = dot(normal, view.world_from_view[3].xyz - a);
    let full = length(normal) * length(toward);
    let lit_casts = lit > EDGE_ON * full && (casting[number] & LIT_CASTS) != 0u;
    let unlit_casts = lit < -EDGE_ON * full && (casting[number] & UNLIT_CASTS) != 0u;
    let is_lit_seen = (lit > 0.0) == (seen > 0.0);
    var facing = select(select(0u, BACKWARD, unlit_casts), FORWARD, lit_casts);
    if facing != 0u {
        add_cap(number, unlit_casts, is_lit_seen);
    }
    // Of closed surfaces only one side casts, and no facet shadows another at the terminator.
    let is_open = (casting[number] & (LIT_CASTS | UNLIT_CASTS)) == (LIT_CASTS | UNLIT_CASTS);
    let is_grazed = abs(lit) < TERMINATOR * full;
    facings[number] = facing | select(0u, AT_TERMINATOR, is_open && is_grazed && !is_lit_seen);
}

// How often a triangle's volume has a side that runs as the triangle does.
fn sides_of(triangle: u32) -> i32 {
    let facing = facings[triangle] & (FORWARD | BACKWARD);
    return select(select(0, -1, facing == BACKWARD), 1, facing == FORWARD);
}

@compute @workgroup_size(256)
fn list_sides(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let number = (group.y * groups.x + group.x) * 256u + lane;
    if number >= volumes.edges {
        return;
    }
    let edge = edges[number];
    var left_over = sides_of(edge.sides.x);
    if edge.sides.y != NO_SIDE {
        let second = sides_of(edge.sides.y & ~SAME_WAY);
        left_over += select(-second, second, (edge.sides.y & SAME_WAY) != 0u);
    }
    for (var copy = 0; copy < abs(left_over); copy++) {
        add_side(select(edge.ends, edge.ends.yx, left_over < 0));
    }
}
