// What moves smoke in a grid; goes with `step.wgsl`.

@group(0) @binding(7) var<storage, read> solid: array<vec2u>;

// So often it tries to leave an obstacle in a step.
const TURNS: u32 = 4u;

// Moves a particle with the air for `dt` seconds, by the midpoint method.
fn moved(start: Particle, dt: f32) -> Particle {
    var particle = start;
    let half_way = start.position + 0.5 * dt * velocity_at(start.position);
    particle.carried = velocity_at(half_way);
    particle.position = clear_of_solids(kept(start.position + dt * particle.carried));
    particle.age += dt;
    return particle;
}

// No closed wall lets anything through, however a long step rounds its corner.
fn kept(place: vec3f) -> vec3f {
    let bits = vec3u(grid.open) >> vec3u(0u, 2u, 4u);
    let low = (bits & vec3u(1u)) != vec3u(0u);
    let high = (bits & vec3u(2u)) != vec3u(0u);
    let walled = max(place, select(grid.origin, place, low));
    return min(walled, select(grid.origin + grid.side * vec3f(grid.cells), place, high));
}

// How far the surface of obstacles is from a place, in cells; below zero inside.
fn distance_at(place: vec3f) -> f32 {
    let p = (place - grid.origin) / grid.side - 0.5;
    let stride = vec3u(1u, grid.cells.x, grid.cells.x * grid.cells.y);
    let a = around(p, grid.cells - 1u, stride);
    let c = vec3u(a.first % stride.y, a.first / stride.y % grid.cells.y, a.first / stride.z);
    let x = vec3u(1u, 0u, 0u);
    let y = vec3u(0u, 1u, 0u);
    let z = vec3u(0u, 0u, 1u);
    let low = vec4f(solid_at(c).w, solid_at(c + x).w, solid_at(c + y).w, solid_at(c + x + y).w);
    let high = vec4f(solid_at(c + z).w, solid_at(c + x + z).w, solid_at(c + y + z).w, solid_at(c + x + y + z).w);
    return blend(low, high, a.share);
}

// What got into an obstacle leaves it by the nearest way.
fn clear_of_solids(place: vec3f) -> vec3f {
    var p = place;
    if grid.solids == 0u {
        return p;
    }
    for (var turn = 0u; turn < TURNS; turn++) {
        let inside = -distance_at(p);
        if inside <= 0.0 {
            break;
        }
        let arm = 0.5 * grid.side;
        let slope = vec3f(
            distance_at(p + vec3f(arm, 0.0, 0.0)) - distance_at(p - vec3f(arm, 0.0, 0.0)),
            distance_at(p + vec3f(0.0, arm, 0.0)) - distance_at(p - vec3f(0.0, arm, 0.0)),
            distance_at(p + vec3f(0.0, 0.0, arm)) - distance_at(p - vec3f(0.0, 0.0, arm)),
        );
        // A little farther, so that rounding leaves nothing inside.
        p += slope * ((inside + 0.02) * grid.side / max(length(slope), 1e-6));
    }
    return p;
}
