// How the surface that paint lies on draws it (ten Bosch, section 2: forces "to take into account the surface's
// shape"). Uses what `ground.wgsl` does.

// Paint feels a surface up to this share of its radius away, the less the farther: it lies on it. Also in `scene.rs`.
const REACH: f32 = 0.25;

// The nearest place of the ground.
struct Surface {
    place: vec3f,
    // Which side of it is which does not matter.
    normal: vec3f,
    // `NOWHERE`: there is none within reach.
    away: f32,
}

// As far as a cell at most.
fn surface_near(place: vec3f, reach: f32) -> Surface {
    var surface = Surface(place, vec3f(0.0), NOWHERE);
    let end = ground.low + vec3f(ground.counts) * ground.cell;
    if any(place + reach < ground.low) || any(place - reach > end) {
        return surface;
    }
    let first = ground_cell(place - reach);
    let last = ground_cell(place + reach);
    for (var z = first.z; z <= last.z; z++) {
        for (var y = first.y; y <= last.y; y++) {
            for (var x = first.x; x <= last.x; x++) {
                let cell = (z * ground.counts.y + y) * ground.counts.x + x;
                for (var entry = ground_cells[cell]; entry < ground_cells[cell + 1u]; entry++) {
                    let corner = ground_cells[entry] * 3u;
                    let corners = array(
                        ground_corners[corner].xyz,
                        ground_corners[corner + 1u].xyz,
                        ground_corners[corner + 2u].xyz,
                    );
                    let nearest = nearest_of(corners, place);
                    let away = distance(nearest, place);
                    let across = cross(corners[1] - corners[0], corners[2] - corners[0]);
                    if away <= reach && away < surface.away && dot(across, across) > 0.0 {
                        surface = Surface(nearest, normalize(across), away);
                    }
                }
            }
        }
    }
    return surface;
}

fn reach_of(radius: f32) -> f32 {
    return min(REACH * radius, ground.cell);
}

// What of the way down lies along a surface: 1 long where it stands upright, and nothing where it is level.
fn down_along(surface: Surface, gravity: vec3f) -> vec3f {
    let has_gravity = any(gravity != vec3f(0.0));
    let down = normalize(select(vec3f(0.0, -1.0, 0.0), gravity, has_gravity));
    return down - dot(down, surface.normal) * surface.normal;
}

// The same at a place, the less of it the farther the surface is.
fn drawn_at(place: vec3f, radius: f32, gravity: vec3f) -> vec3f {
    let reach = reach_of(radius);
    let surface = surface_near(place, reach);
    if surface.away == NOWHERE {
        return vec3f(0.0);
    }
    return (1.0 - surface.away / max(reach, 1e-20)) * down_along(surface, gravity);
}

// Where something comes to that slides from one place to another: as high above the surface as it was.
fn slid(place: vec3f, way: vec3f, radius: f32) -> vec3f {
    let reach = reach_of(radius);
    let before = surface_near(place, reach);
    let after = surface_near(place + way, reach);
    if before.away == NOWHERE || after.away <= before.away || after.away == NOWHERE {
        return place + way;
    }
    return after.place + (place + way - after.place) * (before.away / after.away);
}
