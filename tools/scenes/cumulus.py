"""Writes `scenes/cumulus.csv`: the lobes of a fair-weather cloud.

A flat base, a few towers, large lobes inside and small ones riding on their tops. Run it from the
repository's root: `python3 tools/scenes/cumulus.py`. It needs nothing but Python, and its numbers are
the same everywhere.
"""

import csv
import math
import random

# Middle, height over the base, and radius of each tower, in metres of a model cloud.
TOWERS = [
    (-2.9, 0.35, 0.55), (-2.1, 0.75, 0.8), (-1.0, 1.3, 1.05), (0.25, 1.95, 1.2),
    (1.15, 1.35, 1.0), (2.1, 0.85, 0.8), (2.9, 0.4, 0.5), (-0.4, 0.6, 1.0), (0.9, 0.5, 0.9),
]
LOBES_ON_EACH = 16
FLAT_BASE = 0.16


def lobes(rng):
    for x, height, radius in TOWERS:
        z = rng.uniform(-0.25, 0.25)
        yield x, height, z, radius
        for _ in range(LOBES_ON_EACH):
            # Directions over the upper half, sizes skewed toward the small, larger toward the top.
            azimuth = rng.uniform(0.0, 2.0 * math.pi)
            rise = rng.uniform(-0.35, 1.0)
            ring = math.sqrt(1.0 - rise * rise)
            size = radius * (0.2 + 0.34 * rng.random() ** 2 + 0.1 * max(rise, 0.0))
            reach = radius * 0.97 - 0.45 * size
            yield (
                x + reach * ring * math.cos(azimuth),
                height + reach * rise,
                z + reach * ring * math.sin(azimuth),
                size,
            )


def main():
    rng = random.Random(11)
    with open("scenes/cumulus.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["x", "y", "z", "radius"])
        for x, y, z, radius in lobes(rng):
            # Nothing hangs below the level where the vapour condenses.
            y = max(y, FLAT_BASE + 0.55 * radius)
            writer.writerow([f"{value:.3f}" for value in (x, y, z, radius)])


main()
