// Of faces across z.
const AXIS: u32 = 2u;
const FACING: vec3u = vec3u(0u, 0u, 1u);
