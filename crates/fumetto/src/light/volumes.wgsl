// What is drawn of shadow volumes: the faces of those that triangles keep from one light.
struct Volumes {
    light: u32,
    triangles: u32,
    edges: u32,
    // Vertices of a side: 3 where volumes end in one point, infinitely far away, as under a sun; else 6.
    side_vertices: u32,
}

// On a cap: it is seen by the light from its back.
const TURNED: u32 = 0x80000000u;
