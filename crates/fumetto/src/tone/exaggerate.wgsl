// Shading that brings out relief of all sizes (Rusinkiewicz, Burns & DeCarlo, "Exaggerated Shading for
// Depicting Shape and Detail", 2006). At each size the light is pulled down until it grazes the surface as
// it is when smoothed a little more; so every bump has a lit and a shaded side, wherever it lies.

// Also in `smooth.rs`.
const MAX_SCALES: i32 = 8;

// Directions from which a puff's smoother normals are gathered.
const SPOKES: i32 = 8;

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
        let at = seen.corners[corner] * u32(MAX_SCALES) + u32(scale);
        // Shapes that are made on the device have no smoothed normals.
        if at >= arrayLength(&smoothed) {
            return seen.normal;
        }
        sum += octahedral_unpacked(smoothed[at]) * seen.weights[corner];
    }
    let normal = turned_normal(parts[seen.part].world_from_part, sum) * seen.side;
    return normal / max(length(normal), 1e-20);
}

// The sum of a puff's normals on a circle of `radius_px` around a pixel, from what lies about as deep.
fn normals_around(px: vec2f, distance: f32, radius_px: f32, depth: f32) -> vec3f {
    let last = vec2i(textureDimensions(normals)) - 1;
    var sum = vec3f(0.0);
    for (var spoke = 0; spoke < SPOKES; spoke++) {
        // Half a turn between spokes from circle to circle would do; this keeps them from lining up.
        let angle = (f32(spoke) + radius_px) * (6.2831853 / f32(SPOKES));
        let at = (px + radius_px * vec2f(cos(angle), sin(angle))) / f32(sampling.step);
        let texel = textureLoad(normals, clamp(vec2i(at), vec2i(0), last), 0);
        sum += select(vec3f(0.0), texel.xyz, abs(exp2(texel.w) - distance) < depth);
    }
    return sum;
}

// How much light there is from 0 to 1 (equation 2): the mean over all sizes, and the smoothest surface as
// the light really falls on it.
fn exaggerated(seen: Seen, px: vec2f, distance: f32, toward_light: vec3f, tone: ToneStyle) -> f32 {
    var normal = seen.normal;
    var gathered = seen.normal;
    var sum = 0.0;
    for (var scale = 0; scale < tone.exaggerate_scales; scale++) {
        var smoother = normal;
        if HAS_MESHES && seen.side != 0.0 {
            smoother = smoothed_mesh_normal(seen, scale);
        } else {
            // Sizes grow by √2 up to the puff's radius.
            let radius = seen.radius * exp2(0.5 * f32(scale + 1 - tone.exaggerate_scales));
            gathered += normals_around(px, distance, radius * view.focal_px / distance, 2.0 * radius);
            smoother = gathered / max(length(gathered), 1e-6);
        }
        sum += grazing(normal, smoother, toward_light, tone.exaggerate_contrast);
        normal = smoother;
    }
    return 0.5 + 0.5 * (sum + dot(normal, toward_light)) / f32(tone.exaggerate_scales + 1);
}
