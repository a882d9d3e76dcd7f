// Shading that brings out relief of all sizes (Rusinkiewicz, Burns & DeCarlo, "Exaggerated Shading for
// Depicting Shape and Detail", 2006). At each size the light is pulled down until it grazes the surface as
// it is when smoothed a little more; so every bump has a lit and a shaded side, wherever it lies.

// Also in `smooth.rs`.
const MAX_SCALES: i32 = 8;

// Light on `normal`, which is `smoother` with relief on it, from -1 to 1 (the paper's equation 1).
fn grazing(normal: vec3f, smoother: vec3f, toward_light: vec3f, contrast: f32) -> f32 {
    let along = toward_light - smoother * dot(smoother, toward_light);
    // Where the light stands above the surface, no side of it is lit more than the others.
    let l = along / max(length(along), 1e-3);
    return clamp(contrast * dot(normal, l), -1.0, 1.0);
}

// The normal of a triangle's pixel as it is when smoothed; `scale` counts from 0.
fn smoothed_mesh_normal(seen: Seen, scale: i32) -> vec3f {
    var sum = vec3f(0.0);
    for (var corner = 0; corner < 3; corner++) {
        let normal = smoothed[seen.corners[corner] * u32(MAX_SCALES) + u32(scale)];
        sum += octahedral_unpacked(normal) * seen.weights[corner];
    }
    let normal = turned_normal(parts[seen.part].world_from_part, sum) * seen.side;
    return normal / max(length(normal), 1e-20);
}

// How much light there is from 0 to 1 (equation 2): the mean over all sizes, and the smoothest surface as
// the light really falls on it.
fn exaggerated(seen: Seen, at: Sight, toward_light: vec3f, tone: ToneStyle) -> f32 {
    // Smoke has two sizes of its own, its puffs or its surface and the whole cloud's form; the others lie in
    // between. Only what comes from files has smoothed normals.
    let is_model = HAS_MESHES && seen.side != 0.0 && (parts[seen.part].look & NO_SOURCES) == 0u;
    let form = select(form_at(at.place, seen.object), vec3f(0.0), is_model);
    var normal = seen.normal;
    var sum = 0.0;
    for (var scale = 0; scale < tone.exaggerate_scales; scale++) {
        let bent = mix(seen.normal, form, f32(scale + 1) / f32(tone.exaggerate_scales));
        var smoother = bent / max(length(bent), 1e-4);
        if is_model {
            smoother = smoothed_mesh_normal(seen, scale);
        }
        sum += grazing(normal, smoother, toward_light, tone.exaggerate_contrast);
        normal = smoother;
    }
    return 0.5 + 0.5 * (sum + dot(normal, toward_light)) / f32(tone.exaggerate_scales + 1);
}
