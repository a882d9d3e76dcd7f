"""Writes `scenes/sheet.glb`: a sheet of paper with poppies on it, as shapes that only their outlines tell.

Petals, leaves and stems lie flat on each other like cut paper, each a hair above the one below, so that lines run
where one ends. Seen from above, x to the right and z down the sheet.

Run it from the repository's root: `python3 tools/scenes/sheet.py`; it needs NumPy.
"""

import random

import numpy as np

from glb import Glb
from solids import loft

rng = random.Random(21)
model = Glb()
paper = model.material("paper", "#ffffff")


def flat(outline, low, high):
    """An outline in x and z as a slab."""
    return loft([[(x, y, z) for x, z in outline] for y in (low, high)])


def band(left, right, low, high):
    outline = list(left) + list(right)[::-1]
    return loft([[(x, y, z) for x, z in outline] for y in (low, high)], caps="strip")


def sheet():
    """Torn by hand against a ruler: its edges are almost straight."""
    half = np.array([5.4, 2.95])
    points = []
    for k, (a, b) in enumerate((((-1, -1), (1, -1)), ((1, -1), (1, 1)), ((1, 1), (-1, 1)), ((-1, 1), (-1, -1)))):
        a, b = half * a, half * b
        along = (b - a) / np.linalg.norm(b - a)
        out = np.array([along[1], -along[0]])
        for t in np.linspace(0.0, 1.0, 44)[:-1]:
            points.append(a + (b - a) * t + out * rng.uniform(-0.012, 0.022))
    return flat(points[::-1], -0.1, 0.0)


def petal(at, angle, length, width, low):
    """Broad and wavy at its outer edge."""
    points = []
    for t in np.linspace(-1.0, 1.0, 33):
        a = angle + 0.5 * np.pi * width * t
        r = length * (1.0 - 0.62 * abs(t) ** 3.2) * (1.0 + 0.035 * np.sin(9.0 * t + 3.0 * angle) + 0.02 * np.sin(21.0 * t))
        points.append((at[0] + r * np.cos(a), at[1] + r * np.sin(a)))
    points.append((at[0] + 0.05 * np.cos(angle + 2.0), at[1] + 0.05 * np.sin(angle + 2.0)))
    return flat(points, low, low + 0.004)


def disc(at, radius, low, count=22, wobble=0.03):
    angles = 2.0 * np.pi * np.arange(count) / count
    reach = radius * (1.0 + wobble * np.sin(3 * angles + at[0]))
    return flat([(at[0] + r * np.cos(a), at[1] + r * np.sin(a)) for a, r in zip(angles, reach)], low, low + 0.004)


def poppy(name, at, size, turn, low):
    parts = []
    for k, (angle, length, width) in enumerate(((0.4, 1.0, 0.95), (2.5, 1.02, 0.95), (4.45, 0.98, 0.9), (1.45, 0.86, 0.85),
            (5.7, 0.84, 0.8))):
        parts.append((paper, petal(at, turn + angle, size * length, width, low + 0.005 * k)))
    low += 0.03
    parts.append((paper, disc(at, 0.27 * size, low)))
    for k in range(11):
        a = turn + 2.0 * np.pi * k / 11
        r = size * (0.36 + 0.03 * (k % 2))
        dot = (at[0] + r * np.cos(a), at[1] + r * np.sin(a))
        parts.append((paper, disc(dot, 0.035 * size, low, 10)))
    parts.append((paper, disc(at, 0.14 * size, low + 0.01)))
    model.node(name, parts)


def curve(start, end, bend, count=26):
    start, end = np.array(start, float), np.array(end, float)
    side = np.array([start[1] - end[1], end[0] - start[0]])
    t = np.linspace(0.0, 1.0, count)[:, None]
    return start + (end - start) * t + side * bend * 4.0 * t * (1.0 - t)


def offset(path, widths):
    ahead = np.gradient(path, axis=0)
    ahead /= np.linalg.norm(ahead, axis=1, keepdims=True)
    side = np.stack([-ahead[:, 1], ahead[:, 0]], axis=1) * np.asarray(widths)[:, None]
    return path + side, path - side


def stem(start, end, bend, low, width=0.045):
    path = curve(start, end, bend)
    return band(*offset(path, np.linspace(1.15, 0.85, len(path)) * width), low, low + 0.003)


def leaf(start, end, bend, width, low):
    """Jagged, like a poppy's."""
    path = curve(start, end, bend, 40)
    t = np.linspace(0.0, 1.0, len(path))
    shape = width * np.sin(np.pi * t) ** 0.8 * (0.72 + 0.28 * np.abs(np.sin(5.5 * np.pi * t))) + 0.012
    return band(*offset(path, shape), low, low + 0.003)


model.node("sheet", [(paper, sheet())])
stems = [stem((-1.9, 2.6), (-2.2, -0.5), 0.06, 0.004), stem((0.25, 2.75), (0.35, -1.0), -0.05, 0.006),
    stem((2.0, 2.55), (2.75, 0.25), -0.08, 0.004), stem((3.6, 2.5), (3.95, -1.25), 0.05, 0.005, 0.035)]
leaves = [leaf((-1.8, 2.4), (-3.6, 0.9), 0.16, 0.2, 0.012), leaf((-1.85, 1.7), (-0.75, 0.55), -0.15, 0.15, 0.016),
    leaf((0.3, 2.3), (1.45, 1.0), -0.14, 0.17, 0.02), leaf((0.25, 1.7), (-0.6, 1.15), 0.12, 0.13, 0.024),
    leaf((2.1, 2.3), (3.35, 1.75), -0.2, 0.17, 0.028), leaf((3.7, 1.6), (4.7, 0.6), -0.15, 0.14, 0.032)]
model.node("green", [(paper, mesh) for mesh in stems + leaves])
poppy("left", (-2.25, -0.75), 1.15, 0.3, 0.045)
poppy("middle", (0.4, -1.25), 1.3, 1.1, 0.045)
poppy("right", (2.85, 0.1), 0.95, 2.2, 0.045)
# A bud.
bud = [(paper, petal((3.95, -1.2), -1.35, 0.52, 0.62, 0.045)), (paper, petal((3.95, -1.2), -1.75, 0.46, 0.5, 0.05))]
model.node("bud", bud)
model.save("scenes/sheet.glb")
