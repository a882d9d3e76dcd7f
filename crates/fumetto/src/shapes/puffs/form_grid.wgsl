// Where one object's density is sampled.
struct FormGrid {
    // Corner of the first cell.
    origin: vec3f,
    cell: f32,
    cells: vec3u,
    // Standard deviation of the smoothing, in cells.
    sigma: f32,
    // Radius of a typical lobe, in metres.
    radius: f32,
    pad: vec3f,
}

