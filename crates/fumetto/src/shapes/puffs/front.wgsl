// Picks the puffs to draw first: in every cell of the screen the one that is nearest, at the level whose
// cells are as wide as half to one radius of the puff. Together they leave few gaps, and the pyramid over
// them hides most others; fewer and larger cells were measured to cost more in the end.

struct Range {
    count: u32,
}

@group(0) @binding(1) var<uniform> range: Range;
@group(0) @binding(2) var<uniform> pyramid: Pyramid;
@group(0) @binding(3) var<storage, read> puffs: array<Puff>;
@group(0) @binding(4) var<uniform> styles: array<ObjectStyle, MAX_OBJECTS>;
@group(0) @binding(5) var<storage, read_write> nearness: array<atomic<u32>>;
@group(0) @binding(6) var<storage, read_write> flags: array<u32>;

struct Candidate {
    cell: u32,
    bits: u32,
    on_screen: bool,
}

fn candidate(item: u32) -> Candidate {
    let puff = puffs[item];
    let sprite = sprite_of(puff);
    let fade = puff_fade(puff);
    let shown = sprite.distance > 0.0 && fade.x < 1.0 && fade.y > 0.0 && (styles[puff_object(puff)].flags & IN_CEL) != 0u;
    let level = min(u32(max(floor(log2(max(sprite.radius_px, 1.0) / CELL_PX)), 0.0)), pyramid.levels - 1u);
    let grid = pyramid.level[level];
    let at = vec2i(floor(sprite.px / (CELL_PX * exp2(f32(level)))));
    if !shown || any(at < vec2i(0)) || any(at >= vec2i(grid.yz)) {
        return Candidate(0u, 0u, false);
    }
    return Candidate(grid.x + u32(at.y) * grid.y + u32(at.x), bitcast<u32>(depth_of(sprite.distance)), true);
}

@compute @workgroup_size(256)
fn compete(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let item = (group.y * groups.x + group.x) * 256u + lane;
    if item < range.count {
        let own = candidate(item);
        if own.on_screen {
            atomicMax(&nearness[own.cell], own.bits);
        }
    }
}

@compute @workgroup_size(256)
fn choose(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let item = (group.y * groups.x + group.x) * 256u + lane;
    if item < range.count {
        let own = candidate(item);
        flags[item] = select(0u, FRONT, own.on_screen && atomicLoad(&nearness[own.cell]) == own.bits);
    }
}
