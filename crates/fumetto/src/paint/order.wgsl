// What a volume is to do in one step.
struct Order {
    start: vec3f,
    // Radius that pressure drives it to.
    desired: f32,
    end: vec3f,
    // Radius at first.
    first: f32,
    // 0: is not there. 1: comes now. 2: is there.
    state: u32,
}

const COMES: u32 = 1u;
const IS_THERE: u32 = 2u;
