// Of faces across y.
const AXIS: u32 = 1u;
const FACING: vec3u = vec3u(0u, 1u, 0u);
