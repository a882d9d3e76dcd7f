"""Solids to build models of: lofts, and surfaces round a field. See `glb.py` for what a mesh is."""

import numpy as np

TAU = 2.0 * np.pi


def outward(mesh):
    """The same closed mesh, turned so that its volume is positive."""
    places, triangles = np.asarray(mesh[0], float), np.asarray(mesh[1], int)
    a, b, c = (places[triangles[:, k]] for k in range(3))
    volume = np.einsum("ij,ij->i", a, np.cross(b, c)).sum()
    return (places, triangles if volume > 0.0 else triangles[:, ::-1])


def move(mesh, by):
    return (mesh[0] + np.asarray(by, float), mesh[1])


def warp(mesh, change):
    return outward((change(mesh[0]), mesh[1]))


def turned(mesh, axis, centre):
    """Turns what stands along y to stand along `axis`."""
    y = np.asarray(axis, float) / np.linalg.norm(axis)
    x = np.cross(y, (0.0, 0.0, 1.0) if abs(y[2]) < 0.8 else (1.0, 0.0, 0.0))
    x /= np.linalg.norm(x)
    return warp(mesh, lambda p: p @ np.stack([x, y, np.cross(x, y)]) + centre)


def loft(rings, caps="fan", closed=False):
    """A skin through closed rings of as many points each, and two caps. "fan" suits ends that their
    middle sees all of; "strip" suits bands, whose second half goes back along the first. `closed`
    joins the last ring to the first instead."""
    rings = np.asarray(rings, float)
    count, size = rings.shape[:2]
    places = rings.reshape(-1, 3)
    triangles = []
    for i in range(count if closed else count - 1):
        j = (i + 1) % count
        for k in range(size):
            m = (k + 1) % size
            a, b, c, d = i * size + k, i * size + m, j * size + m, j * size + k
            triangles += [(a, b, c), (a, c, d)]
    if not closed:
        for start, turned in ((0, True), ((count - 1) * size, False)):
            cap = []
            if caps == "fan":
                middle = len(places)
                places = np.vstack([places, places[start : start + size].mean(axis=0)])
                cap = [(start + k, start + (k + 1) % size, middle) for k in range(size)]
            else:
                for k in range(size // 2 - 1):
                    a, b = start + k, start + k + 1
                    c, d = start + size - 2 - k, start + size - 1 - k
                    cap += [(a, b, c), (a, c, d)]
            triangles += [t[::-1] if turned else t for t in cap]
    return outward((places, np.array(triangles)))


def box(low, high, taper=1.0):
    """Its top is `taper` times as wide as its foot."""
    low, high = np.asarray(low, float), np.asarray(high, float)
    middle, half = 0.5 * (low + high), 0.5 * (high - low)
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    rings = [
        [(middle[0] + s * x * half[0], y, middle[2] + s * z * half[2]) for x, z in corners]
        for y, s in ((low[1], 1.0), (high[1], taper))
    ]
    return loft(rings, caps="strip")


def extrude(outline, back, front, caps="fan"):
    """An outline in x and y, from z = back to z = front."""
    return loft([[(x, y, z) for x, y in outline] for z in (back, front)], caps)


def surround(outer, inner, back, front):
    """The frame between two outlines of as many points."""
    rings = [[(*p, back), (*p, front), (*q, front), (*q, back)] for p, q in zip(outer, inner)]
    return loft(rings, closed=True)


def circle(radius, count=16, turn=0.0):
    angles = TAU * (np.arange(count) + turn) / count
    return np.stack([radius * np.cos(angles), radius * np.sin(angles)], axis=1)


def lathe(profile, count=16):
    """A profile of radius and height, turned about the y axis. An end at radius 0 closes in a point."""
    rings, tips = [], {}
    for i, (radius, y) in enumerate(profile):
        if radius == 0.0:
            tips[i] = y
            continue
        rings.append([(x, y, z) for x, z in circle(radius, count)])
    places, triangles = loft(rings)
    # The caps' middles are the last two places: an end that is a point moves its cap's middle there.
    if 0 in tips:
        places[-2, 1] = tips[0]
    if len(profile) - 1 in tips:
        places[-1, 1] = tips[len(profile) - 1]
    return outward((places, triangles))


def tube(path, radii, count=10, flat=1.0):
    """A tapering tube along a path, round or flattened sideways."""
    path, radii = np.asarray(path, float), np.broadcast_to(radii, len(path))
    ahead = np.gradient(path, axis=0)
    ahead /= np.linalg.norm(ahead, axis=1, keepdims=True)
    side = np.cross(ahead[0], (0.0, 0.0, 1.0) if abs(ahead[0, 2]) < 0.8 else (0.0, 1.0, 0.0))
    rings = []
    for point, direction, radius in zip(path, ahead, radii):
        side = side - (side @ direction) * direction
        side /= np.linalg.norm(side)
        up = np.cross(direction, side)
        rings.append([point + x * flat * side + y * up for x, y in circle(radius, count)])
    return loft(rings)


def ball(centre, radii, count=14):
    """An ellipsoid."""
    heights = np.cos(np.linspace(0.0, np.pi, count // 2 + 1))
    profile = [(np.sqrt(max(1.0 - y * y, 0.0)) if 0 < i < count // 2 else 0.0, y) for i, y in enumerate(heights)]
    places, triangles = lathe(profile, count)
    return (places * np.asarray(radii, float) + np.asarray(centre, float), triangles)


def smooth_union(distances, blend):
    """The polynomial smooth minimum, one distance after another."""
    whole = distances[0]
    for other in distances[1:]:
        h = np.clip(0.5 + 0.5 * (other - whole) / blend, 0.0, 1.0)
        whole = other * (1.0 - h) + whole * h - blend * h * (1.0 - h)
    return whole


def gradient(field, points, step=1e-3):
    columns = []
    for axis in range(3):
        offset = np.zeros(3)
        offset[axis] = step
        columns.append((field(points + offset) - field(points - offset)) / (2.0 * step))
    return np.stack(columns, axis=1)


def without_pinches(inside):
    """Fills squares of the grid that are inside at two opposite corners only: four sheets would meet
    along one edge there."""
    while True:
        pinched = np.zeros(inside.shape, bool)
        for u, v in ((0, 1), (1, 2), (2, 0)):
            b, c = np.roll(inside, -1, axis=u), np.roll(inside, -1, axis=v)
            d = np.roll(b, -1, axis=v)
            square = (inside == d) & (b == c) & (inside != b)
            for back in (square, np.roll(square, 1, axis=u)):
                pinched |= back | np.roll(back, 1, axis=v)
        if not (pinched & ~inside).any():
            return inside
        inside = inside | pinched


def surface(field, low, high, cell):
    """The surface where `field` is zero (negative inside), by surface nets: one vertex a cell that the
    surface crosses, one quad an edge of the grid that does. Gibson, "Constrained elastic surface
    nets", 1998; the vertices are then pulled onto the surface by Newton's steps."""
    low = np.asarray(low, float)
    counts = np.ceil((np.asarray(high, float) - low) / cell).astype(int) + 1
    grid = np.stack(np.meshgrid(*(np.arange(n) for n in counts), indexing="ij"), axis=-1)
    inside = without_pinches((field(low + cell * grid.reshape(-1, 3)) < 0.0).reshape(counts))
    quads, cells = [], {}

    def vertex(at):
        return cells.setdefault(tuple(at), len(cells))

    for axis in range(3):
        ahead = np.roll(inside, -1, axis=axis)
        u, v = np.eye(3, dtype=int)[(axis + 1) % 3], np.eye(3, dtype=int)[(axis + 2) % 3]
        for at in np.argwhere(inside != ahead):
            quad = [vertex(at - u - v), vertex(at - v), vertex(at), vertex(at - u)]
            quads.append(quad if inside[tuple(at)] else quad[::-1])
    places = low + cell * (np.array(list(cells)) + 0.5)
    quads = np.array(quads)
    # Relaxed a little, so that the grid does not show, and each time pulled back.
    for _ in range(4):
        total, weight = np.zeros(places.shape), np.zeros((len(places), 1))
        for k in range(4):
            for other in (quads[:, (k + 1) % 4], quads[:, (k + 3) % 4]):
                np.add.at(total, quads[:, k], places[other])
                np.add.at(weight, quads[:, k], 1.0)
        places = 0.5 * places + 0.5 * total / weight
        for _ in range(3):
            slope = gradient(field, places)
            step = field(places)[:, None] * slope / np.maximum((slope**2).sum(axis=1, keepdims=True), 1e-6)
            places = places - np.clip(step, -0.5 * cell, 0.5 * cell)
    # Each quad is cut along its shorter diagonal.
    a, b, c, d = (places[quads[:, k]] for k in range(4))
    short = (np.linalg.norm(a - c, axis=1) <= np.linalg.norm(b - d, axis=1))[:, None]
    first = np.where(short, quads[:, [0, 1, 2]], quads[:, [0, 1, 3]])
    second = np.where(short, quads[:, [0, 2, 3]], quads[:, [1, 2, 3]])
    return (places, np.concatenate([first, second]))
