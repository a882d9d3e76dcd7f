"""Writes `scenes/box.glb`: the open box with a stripe that shows every kind of edge.

After figure 11.4 of Akenine-Möller, Haines and Hoffman, "Real-Time Rendering": walls as thin as
paper, open on top, so that the rim's edges have one triangle only. Three corners are sharp; the one at
the back on the right is round, so that a silhouette runs where no crease is. Seen from the front, a
little from the right and from above, all four kinds show.

Vertices are split where normals or materials differ: weld them by place before counting. Then the box
has 48 places, 82 triangles and 129 edges, and no edge is of two of these kinds:

    boundary    12   the rim
    crease      21   3 sharp corners in 3 rows each, and 12 round the floor: two triangles that turn by
                     84 to 90 degrees (no other edge turns by more than 12)
    material    24   above and below the stripe, 12 each
    plain       72   the rest: inside the walls and the floor, and down the round corner

Seen from EYE, 9 edges are silhouettes (one triangle faces the eye, the other does not): 6 of the
creases, and 3 plain ones, one above the other on the round corner.

Run it from the repository's root: `python3 tools/scenes/box.py`; it needs NumPy.
"""

import numpy as np

from glb import Glb

EYE = (2.2, 3.1, 4.5)
HALF_WIDTH, HALF_DEPTH = 1.0, 0.8
# Rows meet at these heights. The walls lean outward, as straight as they are flat.
HEIGHTS = [0.0, 0.5, 0.85, 1.25]
FLARE_PER_M = 0.1
ROUND, ROUND_STEPS = 0.6, 8
STRIPE_ROW = 1


def outline():
    """Anticlockwise as seen from below, from the front left corner: x and z."""
    corners = [(-HALF_WIDTH, HALF_DEPTH), (HALF_WIDTH, HALF_DEPTH)]
    for angle in np.linspace(0.0, 0.5 * np.pi, ROUND_STEPS + 1):
        corners.append((
            HALF_WIDTH - ROUND + ROUND * np.cos(angle),
            -HALF_DEPTH + ROUND - ROUND * np.sin(angle),
        ))
    return np.array(corners + [(-HALF_WIDTH, -HALF_DEPTH)])


def walls(row):
    """One row of the walls, with places of its own."""
    ring = outline()
    count = len(ring)
    places = []
    for y in HEIGHTS[row : row + 2]:
        wide = 1.0 + FLARE_PER_M * y
        places += [(x * wide, y, z * wide) for x, z in ring]
    triangles = []
    for k in range(count):
        m = (k + 1) % count
        triangles += [(k, m, count + m), (k, count + m, count + k)]
    return np.array(places), np.array(triangles)


def floor():
    ring = outline()
    places = np.array([(x, HEIGHTS[0], z) for x, z in ring])
    # A fan from the front left corner: it keeps clear of slivers, for the round corner lies opposite.
    return places, np.array([(0, k + 1, k) for k in range(1, len(ring) - 1)])


model = Glb()
card = model.material("card", "#e0b478", double_sided=True)
stripe = model.material("stripe", "#c8584e", double_sided=True)
parts = [(card, walls(row)) for row in range(3) if row != STRIPE_ROW]
model.node("box", parts + [(card, floor()), (stripe, walls(STRIPE_ROW))])
model.save("scenes/box.glb")
