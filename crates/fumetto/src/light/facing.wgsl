// How a triangle stands to one light. Its volume runs as it does, or the other way round; neither if it
// throws no shadow.
const FORWARD: u32 = 1u;
const BACKWARD: u32 = 2u;

// It looks away from the light by so little that smooth shading may still be lit there.
const AT_TERMINATOR: u32 = 4u;
