// What is known of a piece once lines are in order.

// How a piece lies in its line.
const BACKWARD: u32 = 1u;
const CLOSED: u32 = 2u;
const TAIL: u32 = 4u;

// Pixels between joints on a long piece, and how many it has at most.
const STEP_PX: f32 = 6.0;
const MOST_JOINTS: f32 = 256.0;

// Joints on a piece, that at its end left out.
fn joints_in(record: Record) -> u32 {
    return u32(clamp(distance(record.start.xy, record.end.xy) / STEP_PX, 1.0, MOST_JOINTS));
}
