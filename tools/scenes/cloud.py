"""Writes `scenes/cloud.csv`: the particles of a fair-weather cloud for one smooth skin.

A row of masses along a flat base, a few towers of unlike height over it, and on their rims lobes that make
scallops. Run it from the repository's root: `python3 tools/scenes/cloud.py`. It needs nothing but Python,
and its numbers are the same everywhere.
"""

import csv

# Middle (height is over the base) and radius of each mass, in metres of a model cloud.
BASE = [
    (-3.3, 0.40, 0.0, 0.80), (-2.3, 0.50, 0.1, 1.05), (-1.1, 0.60, 0.1, 1.25), (0.2, 0.65, 0.1, 1.35),
    (1.4, 0.60, 0.1, 1.25), (2.5, 0.48, 0.0, 1.00), (3.5, 0.38, 0.0, 0.75),
]
TOWERS = [(-1.9, 1.20, -0.1, 1.30), (-0.1, 2.00, -0.2, 1.75), (1.6, 1.35, -0.2, 1.30)]
# Lobes: middle and radius. First those of the rim from left to right, then some that face the viewer.
LOBES = [
    (-3.75, 0.45, 0.0, 0.60), (-3.00, 0.95, 0.0, 0.80), (-2.25, 1.80, 0.0, 0.95), (-1.35, 2.15, 0.1, 0.75),
    (-0.95, 2.85, 0.0, 0.95), (0.15, 3.25, 0.0, 1.10), (1.05, 2.60, 0.0, 0.85), (1.90, 2.00, 0.0, 0.95),
    (2.75, 1.20, 0.0, 0.85), (3.50, 0.75, 0.0, 0.60), (3.95, 0.38, 0.0, 0.48),
    (-2.35, 0.85, 0.60, 0.90), (-0.95, 1.30, 0.75, 1.10), (0.45, 2.15, 0.65, 1.10), (1.05, 0.95, 0.85, 1.10),
    (2.45, 0.80, 0.50, 0.80), (-0.75, 2.20, 0.70, 0.80),
]
LOBE_MASS = 1.5
# Share of a radius at which a lone particle's skin lies: nothing hangs below the base.
SKIN = 0.62


def main():
    particles = [(*mass, 1.0) for mass in BASE + TOWERS] + [(*lobe, LOBE_MASS) for lobe in LOBES]
    with open("scenes/cloud.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["x", "y", "z", "radius", "mass"])
        for x, y, z, radius, mass in particles:
            y = max(y, SKIN * radius)
            writer.writerow([f"{value:.3f}" for value in (x, y, z, radius, mass)])


main()
