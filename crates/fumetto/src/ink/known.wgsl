// Candidates of models, which are found once.

@group(0) @binding(1) var<storage, read> candidates: array<Candidate>;

fn candidate_at(number: u32) -> Candidate {
    return candidates[number];
}

// Place on the list, and corner of the strip, of a vertex that is drawn by indices.
fn strip_corner(index: u32) -> vec2u {
    return vec2u(index / 4u, index % 4u);
}
