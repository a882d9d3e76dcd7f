"""Writes `scenes/steps.glb`: a flight of crooked steps with things in the way, for paint to run down.

Seven steps between two walls with round posts; a ball, a crate and a tub stand on them, so that paint has to find its
way around. Every part is a closed solid.

Run it from the repository's root: `python3 tools/scenes/steps.py`; it needs NumPy.
"""

import random

import numpy as np

from glb import Glb
from solids import ball, box, lathe, loft, move, tube

COUNT, RISE, TREAD = 7, 0.42, 0.78
WIDTH = 2.6
rng = random.Random(3)
model = Glb()

stone = [model.material(f"step {k}", colour) for k, colour in
    enumerate(("#efe6d2", "#f3ead8", "#e9dfca", "#f1e8d6", "#ebe1cd", "#f3ead8", "#efe6d2"))]
wall, cap = model.material("wall", "#e2d6bf"), model.material("cap", "#cdbfa6")
floor, crate, hoop = model.material("floor", "#f4ecdb"), model.material("crate", "#c99a63"), model.material("hoop", "#8a6238")
rubber, stripe, clay, leaf = (model.material(*m) for m in
    (("ball", "#e9e2d6"), ("stripe", "#4d5a6b"), ("clay", "#c8714a"), ("leaf", "#6f9c5a")))


def step(k):
    """The k-th from below, a little worn in the middle of its edge."""
    top, front = RISE * (k + 1), TREAD * (COUNT - 1 - k) - 0.5 * COUNT * TREAD
    xs = np.linspace(-WIDTH, WIDTH, 15)
    rings = []
    for x in xs:
        worn = 0.035 * np.cos(0.5 * np.pi * x / WIDTH) + 0.012 * np.sin(5.0 * x + k)
        nose = front + TREAD + 0.05 - 0.6 * worn
        rings.append([(x, top, front - TREAD * 0.3), (x, -0.4, front - TREAD * 0.3), (x, -0.4, front + TREAD),
            (x, top - 0.11, front + TREAD), (x, top - 0.09, nose), (x, top - worn * 0.5, nose - 0.03)])
    return loft(rings, caps="fan")


def side(sign):
    """A wall that goes down beside the steps, with a coping."""
    back, end = -0.5 * COUNT * TREAD - 0.4, 0.5 * COUNT * TREAD + 0.35
    inner, outer = sign * WIDTH * 0.985, sign * (WIDTH + 0.42)
    low, high = min(inner, outer), max(inner, outer)
    slope = [(back, RISE * COUNT + 0.75), (end, 0.78)]
    body = loft([[(x, -0.4, slope[0][0]), (x, -0.4, slope[1][0]), (x, slope[1][1], slope[1][0]),
        (x, slope[0][1], slope[0][0])] for x in (low, high)])
    top = loft([[(x, y0, slope[0][0] - 0.05) , (x, y1, slope[1][0] + 0.05), (x, y1 + 0.24, slope[1][0] + 0.05),
        (x, y0 + 0.24, slope[0][0] - 0.05)] for x, y0, y1 in ((low - 0.07, slope[0][1] - 0.1, slope[1][1] - 0.1),
        (high + 0.07, slope[0][1] - 0.1, slope[1][1] - 0.1))])
    post = lathe([(0.0, -0.4), (0.42, -0.4), (0.4, 1.15), (0.5, 1.2), (0.5, 1.34), (0.3, 1.4), (0.0, 1.4)], 20)
    globe = ball((0.0, 1.72, 0.0), (0.36, 0.36, 0.36), 18)
    at = (0.5 * (inner + outer), 0.0, end + 0.1)
    return [(wall, body), (cap, top), (cap, move(post, at)), (wall, move(globe, at))]


def on(k):
    """Height and depth of the middle of the k-th tread."""
    return RISE * (k + 1), TREAD * (COUNT - 1 - k) - 0.5 * COUNT * TREAD + 0.42 * TREAD


model.node("floor", [(floor, box((-9.0, -0.5, -6.0), (9.0, 0.0, 9.0)))])
model.node("steps", [(stone[k], step(k)) for k in range(COUNT)], crease_degrees=35)
y = RISE * COUNT
model.node("landing", [(stone[0], box((-WIDTH - 0.5, -0.4, -0.5 * COUNT * TREAD - 2.6),
    (WIDTH + 0.5, y - 0.004, -0.5 * COUNT * TREAD + 0.3)))])
for sign in (-1, 1):
    model.node(f"side {sign}", side(sign), crease_degrees=40)

height, depth = on(4)
model.node("crate", [(crate, box((-1.1, height - 0.06, depth - 0.36), (-0.38, height + 0.62, depth + 0.3))),
    (hoop, box((-1.14, height + 0.1, depth - 0.4), (-0.34, height + 0.2, depth + 0.34))),
    (hoop, box((-1.14, height + 0.42, depth - 0.4), (-0.34, height + 0.52, depth + 0.34)))])
height, depth = on(2)
middle = (0.75, height + 0.4, depth)
belt = [(stripe, tube([(middle[0] + 0.425 * np.cos(a), middle[1] + 0.28 * np.sin(a), middle[2] + 0.31 * np.sin(a))
    for a in np.linspace(0, 2 * np.pi, 33)], 0.045, 8))]
model.node("ball", [(rubber, ball(middle, (0.42, 0.42, 0.42), 24))] + belt)
height, depth = on(5)
pot = lathe([(0.0, -0.05), (0.24, -0.05), (0.33, 0.42), (0.38, 0.44), (0.38, 0.54), (0.0, 0.54)], 18)
lobes = [(leaf, ball((1.55 + u, height + 0.72 + v, depth + w), (r, r, r), 12)) for u, v, w, r in
    ((0, 0.06, 0, 0.3), (-0.22, -0.04, 0.08, 0.22), (0.22, -0.02, 0.05, 0.23), (0.02, 0.24, -0.05, 0.22))]
model.node("tub", [(clay, move(pot, (1.55, height, depth)))] + lobes)
model.save("scenes/steps.glb")
