// Writes the joints of every line in order. Lines that there is no room for are left out.

@group(0) @binding(0) var<uniform> tally: Tally;
@group(0) @binding(1) var<storage, read> records: array<Record>;
@group(0) @binding(2) var<storage, read> known: array<vec4u>;
@group(0) @binding(3) var<storage, read> turns: array<u32>;
@group(0) @binding(4) var<storage, read> totals: array<u32>;
@group(0) @binding(5) var<storage, read> starts: array<u32>;
@group(0) @binding(6) var<storage, read_write> joints: array<Joint>;

@compute @workgroup_size(256)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= tally.count {
        return;
    }
    let record = records[id.x];
    let rank = known[id.x];
    let first = starts[rank.w];
    let last = first + totals[rank.w] - 1u;
    let end = min(last, arrayLength(&joints) - 1u);
    let turn = turns[id.x];
    let runs_back = (turn & BACKWARD) != 0u;
    let begin = select(record.start, record.end, runs_back);
    let end_place = select(record.end, record.start, runs_back);
    let lit_length = unpack2x16float(record.lit_length);
    let count = joints_in(record);
    let own = first + rank.y - count;
    let is_tail = (turn & TAIL) != 0u;
    for (var step = 0u; step < count + u32(is_tail) && own + step <= end; step++) {
        let share = f32(step) / f32(count);
        let place = mix(begin, end_place, share);
        joints[own + step] = Joint(
            place.xy,
            place.z,
            bitcast<f32>(rank.z) - (1.0 - share) * lit_length.y,
            record.outward,
            record.pen,
            record.candidate,
            first,
            end,
            u32((turn & CLOSED) != 0u && end == last),
            lit_length.x,
            0u,
        );
    }
}
