// Cubes around one particle.
struct Around {
    first: vec3i,
    size: vec3u,
}

// Those in the lattice that the particle's box meets.
fn around(blob: Blob, side: i32) -> Around {
    if blob.radius == 0.0 {
        return Around(vec3i(0), vec3u(0u));
    }
    // Regions begin at whole numbers of either cube.
    let low = lattice.first * BLOCK / side;
    let high = low + vec3i(lattice.regions) * (REGION * BLOCK / side) - 1;
    let first = max(vec3i(first_cube(blob.center - blob.radius, lattice.cell_m, side)), low);
    let last = min(vec3i(last_cube(blob.center + blob.radius, lattice.cell_m, side)), high);
    return Around(first, vec3u(max(last - first + 1, vec3i(0))));
}

// Whether the particle touches the cube at a place.
fn touches(blob: Blob, place: vec3i, side: i32) -> bool {
    let low = vec3f(place * side);
    let center = blob.center / lattice.cell_m;
    let off = center - clamp(center, low, low + f32(side));
    let reach = blob.radius / lattice.cell_m + SLACK;
    return dot(off, off) <= reach * reach;
}
