// The nearest puff of every pixel: nailboards, billboards whose pixels carry depth (Schaufler 1997; McGuire
// & Fein 2004, section 1.4). Each list is walked until nothing can be nearer than what is seen. Writes puff + 1
// and the bits of the depth. What the puff looks like there is worked out once per pixel afterwards.

@group(0) @binding(10) var depth_layer: texture_depth_2d;

// What each pixel sees: a puff + 1.
var<private> ids: array<u32, 16>;

// A puff seen from a block.
struct Seen {
    // Of the first pixel: from the puff's middle in pixels, and in the atlas.
    offset: vec2f,
    texel: vec2f,
    picture: Picture,
    radius_px2: f32,
    distance: f32,
    // In parts of 255.
    radius: f32,
    // More than this is inside.
    margin: f32,
    id: u32,
}

fn look(seen: Seen, pixel: u32) {
    let step = vec2f(pixel_of(pixel));
    let offset = seen.offset + step;
    let picture = seen.picture;
    let texel = seen.texel + step.x * picture.step + step.y * vec2f(-picture.step.y, picture.step.x);
    let first = floor(texel);
    let share = texel - first;
    let four = textureLoad(heights, vec2i(first)).xy;
    let left = vec4f(vec4u(four.x & 0xffu, (four.x >> 8u) & 0xffu, four.y & 0xffu, (four.y >> 8u) & 0xffu));
    let right = vec4f(vec4u((four.x >> 16u) & 0xffu, four.x >> 24u, (four.y >> 16u) & 0xffu, four.y >> 24u));
    let across = mix(left, right, share.x);
    let surface = mix(across.xy, across.zw, share.y);
    let distance = seen.distance - surface.x * seen.radius;
    let there = dot(offset, offset) <= seen.radius_px2 && surface.y > seen.margin;
    let before = distances[pixel];
    let nearer = there && (distance < before || (distance == before && seen.id < ids[pixel]));
    distances[pixel] = select(before, distance, nearer);
    ids[pixel] = select(ids[pixel], seen.id, nearer);
}

fn walk(slot: u32, lane: u32, is_empty: bool) {
    let px = block_px(slot, lane);
    for (var pixel = 0u; pixel < 16u; pixel++) {
        let at = px + pixel_of(pixel);
        // Nothing is nearer than what lies beyond the screen.
        distances[pixel] = select(0.0, NOWHERE, all(vec2f(at) < view.size_px));
        ids[pixel] = 0u;
        if !is_empty {
            distances[pixel] = min(distance_of(textureLoad(depth_layer, at, 0)), distances[pixel]);
        }
    }
    let place = vec2f(px) + 0.5;
    for (var levels = summary.levels; levels != 0u; levels &= levels - 1u) {
        var list = list_of(firstTrailingBit(levels), px);
        loop {
            let id = next_of(&list, rank_limit(farthest()));
            if id == 0u {
                break;
            }
            let at = bitcast<vec4f>(textureLoad(projected, projected_at(id - 1u, 0u)));
            let picture = picture_unpacked(textureLoad(projected, projected_at(id - 1u, 1u)));
            let offset = place - at.xy;
            let radius = at.z * at.w / (view.focal_px * 255.0);
            let margin = margin_byte(picture.erosion);
            let seen = Seen(offset, texel_of(picture, offset), picture, at.z * at.z, at.w, radius, margin, id);
            // Spelled out, so that what each pixel sees stays in registers.
            look(seen, 0u);
            look(seen, 1u);
            look(seen, 2u);
            look(seen, 3u);
            look(seen, 4u);
            look(seen, 5u);
            look(seen, 6u);
            look(seen, 7u);
            look(seen, 8u);
            look(seen, 9u);
            look(seen, 10u);
            look(seen, 11u);
            look(seen, 12u);
            look(seen, 13u);
            look(seen, 14u);
            look(seen, 15u);
        }
    }
    // Two pixels to a texel.
    for (var pixel = 0u; pixel < 16u; pixel += 2u) {
        let left = vec2u(ids[pixel], bitcast<u32>(depth_of(distances[pixel])));
        let right = vec2u(ids[pixel + 1u], bitcast<u32>(depth_of(distances[pixel + 1u])));
        textureStore(found, (px + pixel_of(pixel)) / vec2u(2u, 1u), vec4u(left, right));
    }
}

@compute @workgroup_size(64)
fn alone(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = slot_of(group, groups, lane);
    if slot < draw[1] {
        walk(slot, lane, true);
    }
}

// Where the depth layer holds something already.
@compute @workgroup_size(64)
fn among(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = slot_of(group, groups, lane);
    if slot < draw[1] {
        walk(slot, lane, false);
    }
}
