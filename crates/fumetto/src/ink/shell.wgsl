// Outlines by a larger copy of the model, of which only the far side is drawn (Real-Time Rendering, section
// 11.2: procedural geometry). Where the surface ends, it is made longer, and drawn from both sides.

@group(0) @binding(1) var<uniform> styles: array<ObjectStyle, MAX_OBJECTS>;
@group(0) @binding(2) var<uniform> lights: Lights;
@group(0) @binding(3) var<uniform> pens: array<Pen, MAX_PENS>;
@group(0) @binding(4) var<storage, read> vertices: array<Vertex>;
@group(0) @binding(5) var<storage, read> triangles: array<Triangle>;
@group(0) @binding(6) var<storage, read> parts: array<Part>;
@group(0) @binding(7) var<storage, read> pushes: array<Push>;

// How far the shell lies behind where it would be, in widths of the line: it must not come out through
// creases of the model itself.
const BIAS: f32 = 1.0;

struct Corner {
    @builtin(position) position: vec4f,
    // As in the ink layer.
    @location(0) @interpolate(flat) mark: vec2u,
}

// How a vertex moves. One of a surface that the device makes goes along its normal, and the surface has no end.
fn push_of(part: Part, vertex: u32) -> Push {
    if (part.look & NO_SOURCES) != 0u {
        return Push(vertices[vertex].normal, 1.0, 0u, 0.0);
    }
    return pushes[vertex];
}

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Corner {
    let triangle = triangles[index / 3u];
    let corners = triangle.corners;
    let a = vertices[corners.x].position;
    let b = vertices[corners.y].position;
    let c = vertices[corners.z].position;
    let normal = cross(b - a, c - a);
    let is_far_side = dot(normal, view.world_from_view[3].xyz - a) <= 0.0;
    let part = parts[triangle.part];
    let ends = push_of(part, corners.x).sideways_length + push_of(part, corners.y).sideways_length
        + push_of(part, corners.z).sideways_length > 0.0;
    let number = pen_number(part.object, select(BOUNDARY, SILHOUETTE, is_far_side));
    let pen = pens[number];
    if (pen.flags & DRAWS) == 0u || !(is_far_side || ends) {
        return Corner(vec4f(0.0, 0.0, 0.0, 1.0), vec2u(0u));
    }
    let own = corners[index % 3u];
    let place = vertices[own].position;
    let push = push_of(part, own);
    let world = part.world_from_part;
    let outward = unit(turned_normal(world, octahedral_unpacked(push.outward)));
    let sideways = unit((world * vec4f(octahedral_unpacked(push.sideways), 0.0)).xyz);
    let distance = max(clip_from_world(place).w, view.near);
    let width = max(pen.width_px * distance / view.focal_px, pen.width_m) * thinned(styles[part.object], outward, place);
    // Where the surface ends, going outward must not take back in the picture what going sideways gives.
    let ray = place - view.world_from_view[3].xyz;
    let against = push.sideways_length > 0.0 && dot(outward, ray) * dot(sideways, ray) > 0.0;
    let outward_length = select(0.0, push.outward_length, is_far_side && !against);
    let way = sideways * push.sideways_length + outward * outward_length;
    var position = clip_from_world(place + way * width);
    let depth = max(position.w, view.near);
    position.z *= depth / (depth + BIAS * width);
    return Corner(position, vec2u(number + 1u, 255u));
}

fn unit(v: vec3f) -> vec3f {
    return v * inverseSqrt(max(dot(v, v), 1e-30));
}

@fragment
fn fragment(corner: Corner) -> @location(0) vec2u {
    return corner.mark;
}
