// Along lines, from piece to piece; a piece has the number of the joint that it begins at. Uses `joints` of the program
// that it is part of.

fn piece_after(piece: u32) -> u32 {
    let joint = joints[piece];
    if piece + 1u < joint.last {
        return piece + 1u;
    }
    return select(NONE, joint.first, joint.is_closed != 0u);
}

fn piece_before(piece: u32) -> u32 {
    let joint = joints[piece];
    if piece > joint.first {
        return piece - 1u;
    }
    return select(NONE, joint.last - 1u, joint.is_closed != 0u);
}

fn length_px(piece: u32) -> f32 {
    return distance(joints[piece].px, joints[piece + 1u].px);
}
