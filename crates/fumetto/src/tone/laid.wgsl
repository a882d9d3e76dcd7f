// Where on the form a pixel's strokes lie. Uses `ground_layer`, `turns_layer`, `puffs` and `parts` of the program that it is
// part of.

// Cosine between form and viewer under which strokes draw together no more.
const STEEPEST: f32 = 0.12;

// How far away the smoothed form is, and how much farther a pixel to the right and below: between the layer's
// texels, of which those count that lie about as far as what is seen.
fn ground_at(px: vec2f, distance: f32) -> vec3f {
    let at = (px - 0.5) / f32(sampling.ground_step);
    let cell = vec2i(floor(at));
    let part = at - floor(at);
    let last = vec2i(textureDimensions(ground_layer)) - 1;
    let far = distance * sampling.ground_far_px / view.focal_px;
    var sum = vec3f(0.0);
    var total = 0.0;
    for (var corner = 0; corner < 4; corner++) {
        let step = vec2i(corner & 1, corner >> 1);
        let place = min(cell + step, last);
        var texel = textureLoad(ground_layer, place, 0).xyz;
        // Where a texel is missing, the form goes on from the others as it slopes there.
        texel.x += dot(texel.yz, px - 0.5 - vec2f(place * sampling.ground_step));
        let bilinear = select(1.0 - part, part, step == vec2i(1));
        let near = texel.x > 0.0 && abs(texel.x - distance) < far;
        let weight = select(0.0, bilinear.x * bilinear.y + 1e-4, near);
        sum += weight * texel;
        total += weight;
    }
    return select(vec3f(distance, 0.0, 0.0), sum / max(total, 1e-6), total > 0.0);
}

// The gradients of the coordinates in which strokes stay, and where these begin.
struct Staying {
    gradients: mat3x3f,
    origin: vec3f,
}

fn staying(style: HatchStyle, seen: Seen, id: u32) -> Staying {
    let world = mat3x3f(vec3f(1.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0), vec3f(0.0, 0.0, 1.0));
    if style.follow != FOLLOW_OBJECT {
        return Staying(world, vec3f(0.0));
    }
    if HAS_MESHES && (id & TRIANGLE_BIT) != 0u {
        let m = parts[seen.part].world_from_part;
        let cofactors = mat3x3f(cross(m[1].xyz, m[2].xyz), cross(m[2].xyz, m[0].xyz), cross(m[0].xyz, m[1].xyz));
        let volume = dot(m[0].xyz, cofactors[0]);
        // Flattened parts have no inverse.
        if abs(volume) > 1e-20 {
            return Staying(cofactors * (1.0 / volume), m[3].xyz);
        }
        return Staying(world, m[3].xyz);
    }
    let puff = puffs[id - 1u];
    return Staying(world * (1.0 / max(puff.radius, 1e-9)), puff.center);
}

// The same at a form that is not smoothed: on the plane that touches it.
fn plane_at(normal: vec3f, ray: vec3f, distance: f32) -> vec3f {
    let steep = min(dot(normal, ray), -STEEPEST * length(ray));
    let right = dot(normal, view.world_from_view[0].xyz);
    let up = dot(normal, view.world_from_view[1].xyz);
    return vec3f(distance, vec2f(-right, up) * (distance / (steep * view.focal_px)));
}

fn laid_at(style: HatchStyle, seen: Seen, id: u32, px: vec2f, distance: f32) -> Laid {
    if style.follow == FOLLOW_SCREEN {
        let unit = 1.0 / style.scale;
        let at = (px + view.first_px) * unit * vec2f(1.0, -1.0);
        let px_m = view.focal_px / distance;
        let right = vec3f(unit, 0.0, 0.0);
        return Laid(vec3f(at, 0.0), right, vec3f(0.0, -unit, 0.0), unit, unit * px_m, px_m, vec2f(0.0));
    }
    let ray = world_ray(px);
    var ground = plane_at(seen.normal, ray, distance);
    if (style.look & IS_SMOOTHED) != 0u {
        ground = ground_at(px, distance);
    }
    let far = ground.x;
    let stays = staying(style, seen, id);
    let place = view.world_from_view[3].xyz + ray * far;
    let pixel = far / view.focal_px;
    let right = view.world_from_view[0].xyz * pixel + ray * ground.y;
    let below = view.world_from_view[1].xyz * -pixel + ray * ground.z;
    var turn = vec2f(0.0);
    if (style.look & IS_CURVED) != 0u {
        let texel = (px - 0.5) / f32(sampling.ground_step) + 0.5;
        turn = textureSampleLevel(turns_layer, linear, texel / vec2f(textureDimensions(turns_layer)), 0.0).xy;
    }
    let unit_m = length(stays.gradients[0]);
    let px_m = view.focal_px / far;
    return Laid(
        (place - stays.origin) * stays.gradients,
        right * stays.gradients,
        below * stays.gradients,
        unit_m / px_m,
        unit_m,
        px_m,
        turn,
    );
}
