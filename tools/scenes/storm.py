"""Writes `scenes/storm.csv`: the puffs of a thunderhead.

Masses make a dark base, three towers of unlike height that boil up from it, and an anvil that the wind draws out
at the top; each mass carries lobes on the sides that are seen. Run it from the repository's root:
`python3 tools/scenes/storm.py`. It needs nothing but Python, and its numbers are the same everywhere.
"""

import csv
import math

# Middle (height is over the base) and radius of each mass, in metres of a model cloud.
BASE = [
    (-4.3, 0.45, 0.0, 0.65), (-3.2, 0.70, 0.0, 1.05), (-1.8, 0.90, 0.2, 1.35), (0.0, 1.00, 0.3, 1.50),
    (1.8, 0.90, 0.2, 1.35), (3.2, 0.65, 0.0, 1.00), (4.3, 0.40, 0.0, 0.65),
]
TOWERS = [
    (-0.9, 2.40, 0.1, 1.40), (0.7, 2.30, 0.2, 1.35), (-0.4, 3.60, 0.0, 1.40), (0.5, 4.10, -0.1, 1.15),
    (-1.0, 4.60, 0.0, 1.10), (-0.2, 5.20, -0.1, 1.25), (-2.9, 2.00, 0.0, 0.95), (-3.0, 2.75, 0.0, 0.65),
    (2.6, 2.10, 0.0, 1.00), (2.9, 3.00, -0.1, 0.75),
]
ANVIL = [
    (-3.1, 6.05, -0.4, 0.50), (-2.1, 5.95, -0.3, 0.75), (1.2, 5.85, -0.3, 0.95), (2.2, 5.95, -0.4, 0.84),
    (3.2, 6.05, -0.4, 0.70), (4.0, 6.12, -0.5, 0.54), (4.7, 6.18, -0.5, 0.36),
]
LOBES = 9
# Turn from lobe to lobe: the golden angle.
GOLDEN = math.pi * (3.0 - math.sqrt(5.0))


def lobes(number, mass):
    """Lobes on a spiral over the half of a mass that faces the viewer and the sky."""
    x, y, z, radius = mass
    for i in range(LOBES):
        along = 1.0 - 1.15 * (i + 0.5) / LOBES
        across = math.sqrt(1.0 - along * along)
        turn = GOLDEN * i + 1.7 * number
        # The spiral's axis leans from the sky toward the viewer.
        side, up, front = across * math.cos(turn), along, across * math.sin(turn)
        up, front = 0.8 * up - 0.6 * front, 0.6 * up + 0.8 * front
        size = radius * (0.38 + 0.17 * ((7 * i + 3 * number) % 5) / 4.0)
        off = radius * 0.9
        yield (x + off * side, y + off * up, z + off * front, size)


def main():
    masses = BASE + TOWERS + ANVIL
    puffs = masses + [lobe for number, mass in enumerate(masses) for lobe in lobes(number, mass)]
    with open("scenes/storm.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["x", "y", "z", "radius"])
        for x, y, z, radius in puffs:
            writer.writerow([f"{value:.3f}" for value in (x, max(y, 0.55 * radius), z, radius)])


main()
