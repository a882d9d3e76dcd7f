// Triangles of models.

// A vertex as the model's file has it.
struct Source {
    position: vec3f,
    normal: u32,
    uv: vec2f,
    // Linear, as four halves.
    colour: vec2u,
    part: u32,
}

// A vertex as it lies in the world at the moment that is drawn.
struct Vertex {
    position: vec3f,
    // Octahedral, as two snorm16.
    normal: u32,
}

struct Triangle {
    // Numbers of its vertices, counter-clockwise seen from outside.
    corners: vec3u,
    // Number of the part that it belongs to.
    part: u32,
}

// What moves together and is of one material.
struct Part {
    world_from_part: mat4x4f,
    // Linear; times the vertex's own.
    colour: vec4f,
    object: u32,
    // Materials of one model have numbers of their own, which start after those of the models before it.
    material: u32,
    // Layer of the texture array, or -1.
    texture: i32,
    // How the texture goes on beyond its sides, along u in bits 0..2 and along v in bits 2..4: 0 repeats,
    // 1 mirrors, 2 stretches its edge. Bit 4: is seen from behind, too. Bit 5: its vertices have no source,
    // and it is of the part's colour all over. In bits 16..32, as a fraction of 65535: the alpha under which
    // there is no surface.
    look: u32,
}

const DOUBLE_SIDED: u32 = 16u;
const NO_SOURCES: u32 = 32u;

// Numbers in the id layer with this bit are of triangles.
const TRIANGLE_BIT: u32 = 0x80000000u;

// How a vertex moves when its object gets larger all round, in the coordinates of its part: octahedral
// directions, and how far for a width of 1.
struct Push {
    // Away from the object's inside.
    outward: u32,
    outward_length: f32,
    // Beyond the surface's end; nowhere where it has none.
    sideways: u32,
    sideways_length: f32,
}

// A normal of a part, in the world, of any length: normals go by the cofactors, which also hold where a scale
// is 0 or negative.
fn turned_normal(world: mat4x4f, normal: vec3f) -> vec3f {
    let x = cross(world[1].xyz, world[2].xyz);
    let y = cross(world[2].xyz, world[0].xyz);
    let z = cross(world[0].xyz, world[1].xyz);
    let mirrored = select(1.0, -1.0, dot(world[0].xyz, x) < 0.0);
    return mirrored * (x * normal.x + y * normal.y + z * normal.z);
}
