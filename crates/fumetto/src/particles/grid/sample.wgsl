// Velocity anywhere in the box, trilinear component by component.

@group(0) @binding(3) var<uniform> grid: Grid;
@group(0) @binding(4) var<storage, read> u: array<f32>;
@group(0) @binding(5) var<storage, read> v: array<f32>;
@group(0) @binding(6) var<storage, read> w: array<f32>;

// Beyond the box the air moves as at its side.
fn velocity_at(place: vec3f) -> vec3f {
    let p = (place - grid.origin) / grid.side;
    let s = face_stride();
    let last = grid.cells - 1u;
    let a = around(p - vec3f(0.0, 0.5, 0.5), last + vec3u(1u, 0u, 0u), s);
    let b = around(p - vec3f(0.5, 0.0, 0.5), last + vec3u(0u, 1u, 0u), s);
    let c = around(p - vec3f(0.5, 0.5, 0.0), last + vec3u(0u, 0u, 1u), s);
    let i = vec2u(a.first, a.first + s.z);
    let j = vec2u(b.first, b.first + s.z);
    let k = vec2u(c.first, c.first + s.z);
    return vec3f(
        blend(
            vec4f(u[i.x], u[i.x + 1u], u[i.x + s.y], u[i.x + s.y + 1u]),
            vec4f(u[i.y], u[i.y + 1u], u[i.y + s.y], u[i.y + s.y + 1u]),
            a.share,
        ),
        blend(
            vec4f(v[j.x], v[j.x + 1u], v[j.x + s.y], v[j.x + s.y + 1u]),
            vec4f(v[j.y], v[j.y + 1u], v[j.y + s.y], v[j.y + s.y + 1u]),
            b.share,
        ),
        blend(
            vec4f(w[k.x], w[k.x + 1u], w[k.x + s.y], w[k.x + s.y + 1u]),
            vec4f(w[k.y], w[k.y + 1u], w[k.y + s.y], w[k.y + s.y + 1u]),
            c.share,
        ),
    );
}
