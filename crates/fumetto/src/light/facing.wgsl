// How a triangle stands to one light. Its volume runs as it does, or the other way round; neither if it
// throws no shadow.
const FORWARD: u32 = 1u;
const BACKWARD: u32 = 2u;

// Sine of the angle up to which light only grazes a facet, which then keeps none away: the sides of its volume
// would lie in its own plane, or in that of the triangle next to it.
const EDGE_ON: f32 = 1e-3;

// It looks away from the light by so little that smooth shading may still be lit there.
const AT_TERMINATOR: u32 = 4u;

// It looks away from the light, and though its shading is lit in parts, all that it shows lies in shadow.
const IN_VALLEY: u32 = 8u;
