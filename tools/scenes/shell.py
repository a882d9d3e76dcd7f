"""Writes `scenes/shell.nrrd`: a whelk's shell, as a scanner would see it.

A tube that winds up a cone and grows as it winds, with ribs across and cords along, cut open at its mouth. Numbers fall
from 255 within its wall to 0 outside. Run it from the repository's root: `python3 tools/scenes/shell.py`. It needs
NumPy, and its numbers are the same everywhere.
"""

import gzip
import math

import numpy as np

SIDES = (80, 128, 80)
# Millimetres between samples; the shell is about 38 mm high.
SPACING = 0.3
# Turns from the tip to the mouth, and how much wider each is than the one before.
TURNS = 6.2
GROWTH = 1.62
# Of the last turn, in millimetres: radius of the path, radius of the tube, and the way down.
PATH, TUBE, DROP = 4.7, 5.7, 24.5
RIBS = 11
# The wall's thickness over the tube's radius, and how far the mouth is open, in turns.
WALL = 0.13
MOUTH = 0.42


def size_at(turn):
    return GROWTH ** (turn - TURNS)


def rounded(turn, steps=96):
    """Middle and radius of the tube at many places along it."""
    for t in np.linspace(0.4, turn, int(steps * turn)):
        size = size_at(t)
        angle = 2 * math.pi * t
        yield t, (PATH * size * math.cos(angle), -DROP * size, PATH * size * math.sin(angle)), TUBE * size


def main():
    x, y, z = (SPACING * (np.arange(side, dtype=np.float32) - 0.5 * (side - 1)) for side in SIDES)
    x, y, z = np.meshgrid(x, y - 16.5, z, indexing="ij")
    outer = np.full(x.shape, 1e3, np.float32)
    inner = np.full(x.shape, 1e3, np.float32)
    for t, (cx, cy, cz), radius in rounded(TURNS):
        # A little higher than wide, drawn out downward to a spout at the last turn.
        dx, dy, dz = x - cx, y - cy, z - cz
        stretch = np.where(dy < 0, 1.25 + 0.55 * max(t - TURNS + 1.2, 0), 1.12).astype(np.float32)
        away = np.sqrt(dx * dx + (dy / stretch) ** 2 + dz * dz)
        rib = 1 + 0.07 * math.cos(2 * math.pi * RIBS * t) * min(1, 0.4 + t / TURNS)
        cord = 1 + 0.018 * np.cos(11 * np.arctan2(dy / stretch, np.hypot(dx + cx, dz + cz) - PATH * size_at(t)))
        outer = np.minimum(outer, away - radius * rib * cord)
        if t > TURNS - 1.0:
            inner = np.minimum(inner, away - radius * (1 - WALL))
    # The mouth: what is left of the last tube beyond its end is air.
    for t in np.linspace(TURNS, TURNS + MOUTH, 40):
        size, angle = size_at(TURNS), 2 * math.pi * t
        cx, cy, cz = PATH * size * math.cos(angle) * 1.12, -DROP * size, PATH * size * math.sin(angle) * 1.12
        away = np.sqrt((x - cx) ** 2 + ((y - cy) / 1.5) ** 2 + (z - cz) ** 2)
        inner = np.minimum(inner, away - TUBE * (0.86 - 0.2 * (t - TURNS)))
    distance = np.maximum(outer, -inner)
    values = np.clip(128 - 127 * distance / (1.6 * SPACING), 0, 255).astype(np.uint8)
    header = (
        "NRRD0004\n# written by tools/scenes/shell.py\ntype: uint8\ndimension: 3\nspace dimension: 3\n"
        f"sizes: {SIDES[0]} {SIDES[1]} {SIDES[2]}\n"
        f"space directions: ({SPACING},0,0) (0,{SPACING},0) (0,0,{SPACING})\n"
        f"space origin: ({-0.5 * SPACING * (SIDES[0] - 1)},{-0.5 * SPACING * (SIDES[1] - 1)},{-0.5 * SPACING * (SIDES[2] - 1)})\n"
        "encoding: gzip\n\n"
    )
    with open("scenes/shell.nrrd", "wb") as file:
        file.write(header.encode())
        file.write(gzip.compress(values.transpose(2, 1, 0).tobytes(), 9, mtime=0))


main()
