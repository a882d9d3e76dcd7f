// A volume of paint as it is: all places whose distance from an axis is less than the radius in that direction.
struct Body {
    // The ends of the axis; a drop that stands has both in one place.
    start: vec3f,
    // The least radius of all vertices; all that is nearer lies inside.
    near: f32,
    end: vec3f,
    // The largest one; all that is farther lies outside. 0: there is no such volume now.
    far: f32,
    first_vertex: u32,
    first_direction: u32,
    first_patch: u32,
    // Along each edge of its icosahedron.
    pieces: u32,
    // Which bit of a pixel tells that it lies inside.
    layer: u32,
    // Number of its paint.
    coat: u32,
    // Over which length it runs into others of its layer, in metres; 0 where it does not.
    blend: f32,
}
