// How something drifts with air that stays as it is.

struct Drift {
    // How far, and how fast after it.
    shift: vec3f,
    velocity: vec3f,
}

// The exact solution of dv/dt = acceleration + drag (air - v) after `dt` seconds.
fn drift(velocity: vec3f, air: Air, dt: f32) -> Drift {
    if air.drag > 0.0 {
        let settled = air.velocity + air.acceleration / air.drag;
        let left = exp(-air.drag * dt);
        return Drift(
            settled * dt + (velocity - settled) * ((1.0 - left) / air.drag),
            settled + (velocity - settled) * left,
        );
    }
    return Drift(velocity * dt + 0.5 * dt * dt * air.acceleration, velocity + air.acceleration * dt);
}
