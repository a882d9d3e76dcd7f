// Of faces across x.
const AXIS: u32 = 0u;
const FACING: vec3u = vec3u(1u, 0u, 0u);
