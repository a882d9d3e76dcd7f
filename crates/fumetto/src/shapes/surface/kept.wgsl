// The place of a block, by its number.
fn kept_place(block: u32) -> vec3i {
    return kept[block / IN_REGION] + vec3i((vec3u(block) >> vec3u(0u, 3u, 6u)) & vec3u(7u));
}
