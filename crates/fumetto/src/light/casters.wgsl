// Finds the puffs whose shadow volume can touch anything that is seen.

struct Casters {
    count: u32,
    light: u32,
}

@group(0) @binding(1) var<uniform> casters: Casters;
@group(0) @binding(2) var<uniform> pyramid: Pyramid;
@group(0) @binding(3) var<uniform> lights: Lights;
@group(0) @binding(4) var<storage, read> puffs: array<Puff>;
@group(0) @binding(5) var<storage, read> styles: array<ObjectStyle>;
@group(0) @binding(6) var<storage, read> nearness: array<u32>;
@group(0) @binding(7) var<storage, read_write> flags: array<u32>;

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let item = (group.y * groups.x + group.x) * 256u + lane;
    if item >= casters.count {
        return;
    }
    let puff = puffs[item];
    let style = styles[puff_object(puff)];
    let fade = puff_fade(puff);
    var casts = 0u;
    if puff.radius > 0.0 && fade.x < 1.0 && fade.y > 0.0 && (style.flags & THROWS_SHADOW) != 0u {
        let volume = volume_of(puff, style, lights.light[casters.light]);
        let half = abs(volume.along_px) + abs(volume.side_px);
        casts = u32(visible(volume.px, half, volume.nearest));
    }
    flags[item] = casts;
}
