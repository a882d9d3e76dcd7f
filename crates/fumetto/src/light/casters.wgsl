// Finds the puffs whose shadow volume can touch anything that is seen, and how much of the screen it covers.

// Pieces of a volume that are looked at one by one: the whole is as near as its nearest end, though most
// of it lies deeper.
const PIECES: u32 = 4u;

// Texels of the mask beyond which a volume is worked on by many invocations.
const SMALL_TEXELS: f32 = 1024.0;

@group(0) @binding(1) var<uniform> casting: Casting;
@group(0) @binding(2) var<uniform> pyramid: Pyramid;
@group(0) @binding(3) var<uniform> lights: Lights;
@group(0) @binding(4) var<storage, read> puffs: array<Puff>;
@group(0) @binding(5) var<uniform> styles: array<ObjectStyle, MAX_OBJECTS>;
@group(0) @binding(6) var<storage, read> nearness: array<u32>;
@group(0) @binding(7) var<storage, read_write> flags: array<u32>;

fn touches(volume: Volume) -> bool {
    let end = volume.middle + volume.axis * volume.last;
    let from_px = px_of(volume.middle);
    let to_px = px_of(end);
    var seen = false;
    for (var piece = 0u; piece < PIECES; piece++) {
        let low = f32(piece) / f32(PIECES);
        let high = f32(piece + 1u) / f32(PIECES);
        let nearest = min(-mix(volume.middle.z, end.z, low), -mix(volume.middle.z, end.z, high)) - volume.radius;
        let a = mix(from_px, to_px, low);
        let b = mix(from_px, to_px, high);
        let half = 0.5 * abs(b - a) + volume.radius * view.focal_px / nearest;
        seen |= visible(0.5 * (a + b), half, nearest);
    }
    return seen;
}

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let item = (group.y * groups.x + group.x) * 256u + lane;
    if item >= casting.count {
        return;
    }
    let puff = puffs[item];
    let style = styles[puff_object(puff)];
    let fade = puff_fade(puff);
    var casts = 0u;
    if puff.radius > 0.0 && fade.x < 1.0 && fade.y > 0.0 && (style.flags & THROWS_SHADOW) != 0u {
        let volume = volume_of(puff, style, lights.light[casting.light]);
        // One that reaches about the camera may touch anything.
        if volume.nearest <= view.near || touches(volume) {
            let texels = 4.0 * length(volume.along_px) * length(volume.side_px) / (casting.step * casting.step);
            casts = select(CASTS_LARGE, CASTS_SMALL, texels <= SMALL_TEXELS);
        }
    }
    flags[item] = casts;
}
