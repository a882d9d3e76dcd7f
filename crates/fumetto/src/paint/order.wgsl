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
