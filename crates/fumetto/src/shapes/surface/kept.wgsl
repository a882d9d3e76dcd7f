// The place of a block, by its number.
fn kept_place(block: u32) -> vec3i {
    let within = vec3i((vec3u(block) >> vec3u(0u, 3u, 6u)) & vec3u(7u));
    return lattice.first + place_in(lattice.regions, kept[block / IN_REGION]) * REGION + within;
}
