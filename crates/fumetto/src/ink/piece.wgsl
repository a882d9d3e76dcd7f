// A number that triangles share which hang together. Uses `triangles`, `parts` and `pieces` of the program that
// it is part of.
fn piece_of(number: u32) -> u32 {
    let part = triangles[number].part;
    // A surface that the device makes is one piece.
    return select(pieces[number], TRIANGLE_BIT | part, (parts[part].look & NO_SOURCES) != 0u);
}
