// What a pixel shows. Uses `styles`, `puffs`, `vertices`, `triangles`, `parts` and `depth_layer` of the program that it is part of.
struct Seen {
    id: u32,
    object: u32,
    // Of the object's style.
    flags: u32,
    piece: u32,
    material: u32,
    place: vec3f,
    // Along the line of sight.
    distance: f32,
    // Of a triangle's plane, on the side that is seen, or away from a puff's middle.
    normal: vec3f,
    // Cosine between that and the viewer.
    facing: f32,
    // Of a puff; 0 for a triangle.
    radius: f32,
    opacity: f32,
}

fn seen_at(id: u32, px: vec2i) -> Seen {
    let depth = textureLoad(depth_layer, px, 0);
    let ray = world_ray(vec2f(px) + 0.5);
    var seen = Seen();
    seen.id = id;
    seen.distance = select(1e30, distance_of(depth), depth > 0.0);
    seen.place = view.world_from_view[3].xyz + ray * seen.distance;
    seen.opacity = 1.0;
    if id == 0u {
        return seen;
    }
    if (id & TRIANGLE_BIT) == 0u {
        let puff = puffs[id - 1u];
        seen.object = puff_object(puff);
        seen.normal = normalize(seen.place - puff.center);
        seen.radius = puff.radius;
        seen.opacity = puff_fade(puff).y;
    } else {
        let number = id & ~TRIANGLE_BIT;
        let triangle = triangles[number];
        let a = vertices[triangle.corners.x].position;
        let across = cross(vertices[triangle.corners.y].position - a, vertices[triangle.corners.z].position - a);
        seen.object = parts[triangle.part].object;
        seen.piece = piece_of(number);
        seen.material = parts[triangle.part].material;
        seen.normal = across * (-sign(dot(across, ray)) * inverseSqrt(max(dot(across, across), 1e-30)));
    }
    seen.facing = -dot(seen.normal, ray) * inverseSqrt(dot(ray, ray));
    seen.flags = styles[seen.object].flags;
    return seen;
}
