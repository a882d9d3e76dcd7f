"""Writes `scenes/stage-sky.glb`: a sky like a stage's, bent round a scene, with hills, two clouds and a disc that is the sun
by day and the moon by night.

What lies behind a scene's objects is infinitely far, where no paint comes. This sky can be painted.

Run it from the repository's root: `python3 tools/scenes/stage_sky.py`; it needs NumPy.
"""

import numpy as np

from glb import Glb

RADIUS = 24.0
# Everything is lit alike, by a sun in this direction: a stage's sky has no shading.
TOWARD_SUN = np.array([-0.45, 0.8, 0.65])
model = Glb()


def bent(places, nearer=0.0):
    """From metres along and up the backdrop to where it stands, open toward +z."""
    along, up = places[:, 0] / RADIUS, places[:, 1]
    r = RADIUS - nearer
    return np.stack([r * np.sin(along), up, -r * np.cos(along)], axis=1)


def backdrop():
    columns, rows = 49, 9
    xs, ys = np.linspace(-1.75, 1.75, columns) * RADIUS, np.linspace(-9.0, 26.0, rows)
    flat = np.array([(x, y) for y in ys for x in xs])
    triangles = []
    for row in range(rows - 1):
        for column in range(columns - 1):
            a = row * columns + column
            triangles += [(a, a + 1, a + columns + 1), (a, a + columns + 1, a + columns)]
    return bent(flat), np.array(triangles)


def hills(height, wave, phase, nearer):
    xs = np.linspace(-1.7, 1.7, 91) * RADIUS
    tops = height + wave * (np.sin(0.16 * xs + phase) + 0.45 * np.sin(0.41 * xs + 2.0 * phase))
    flat = np.concatenate([np.stack([xs, tops], axis=1), np.stack([xs, np.full(len(xs), -9.0)], axis=1)])
    n = len(xs)
    triangles = []
    for k in range(n - 1):
        triangles += [(n + k, n + k + 1, k + 1), (n + k, k + 1, k)]
    return bent(flat, nearer), np.array(triangles)


def disc(x, y, radius, nearer):
    angles = 2.0 * np.pi * np.arange(48) / 48
    flat = np.concatenate([[(x, y)], np.stack([x + radius * np.cos(angles), y + radius * np.sin(angles)], axis=1)])
    return bent(flat, nearer), np.array([(0, k + 1, (k + 1) % 48 + 1) for k in range(48)])


def cloud(x, y, size):
    """Flat below, lobes above, cut out of card."""
    lobes = [(-1.5, 0.25, 0.6), (-0.75, 0.6, 0.85), (0.2, 0.8, 1.05), (1.1, 0.5, 0.8), (1.75, 0.2, 0.55)]
    xs = np.linspace(-2.1, 2.3, 81)
    tops = np.zeros(len(xs))
    for middle, lift, radius in lobes:
        inside = np.maximum(radius**2 - (xs - middle) ** 2, 0.0)
        tops = np.maximum(tops, np.where(inside > 0.0, lift + np.sqrt(inside), 0.0))
    flat = np.concatenate([np.stack([xs, tops], axis=1), np.stack([xs, np.full(len(xs), -0.08)], axis=1)])
    n = len(xs)
    triangles = []
    for k in range(n - 1):
        triangles += [(n + k, n + k + 1, k + 1), (n + k, k + 1, k)]
    return bent(flat * size + (x, y), 1.4), np.array(triangles)


def lit(mesh):
    places, triangles = mesh
    return places, triangles, np.tile(TOWARD_SUN / np.linalg.norm(TOWARD_SUN), (len(places), 1))


air = model.material("air", "#a9d6ee", double_sided=True)
far, near = model.material("far hills", "#9cc2a8", double_sided=True), model.material("hills", "#86b079", double_sided=True)
card, light = model.material("cloud", "#ffffff", double_sided=True), model.material("sun", "#fff3c4", double_sided=True)
model.node("air", [(air, lit(backdrop()))])
model.node("sun", [(light, lit(disc(-15.5, 10.2, 1.5, 0.5)))])
model.node("far hills", [(far, lit(hills(1.4, 0.9, 0.3, 1.0)))])
model.node("hills", [(near, lit(hills(-0.6, 0.8, 1.9, 2.2)))])
model.node("clouds", [(card, lit(cloud(*at))) for at in ((-6.5, 8.2, 1.15), (5.5, 9.6, 0.85), (-24.0, 7.0, 1.0))])
model.save("scenes/stage-sky.glb")
