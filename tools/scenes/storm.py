"""Writes `scenes/storm.csv`: the puffs of a thunderhead.

A dark base, three towers of unlike height that boil up from it, and an anvil that the wind draws out at the
top. Run it from the repository's root: `python3 tools/scenes/storm.py`. It needs nothing but Python, and its
numbers are the same everywhere.
"""

import csv

# Middle (height is over the base) and radius of each puff, in metres of a model cloud.
BASE = [
    (-5.3, 0.55, 0.0, 0.75), (-4.2, 0.75, 0.2, 1.05), (-2.9, 0.85, 0.3, 1.25), (-1.5, 0.95, 0.4, 1.40),
    (0.0, 1.00, 0.4, 1.45), (1.5, 0.95, 0.3, 1.35), (2.9, 0.80, 0.2, 1.15), (4.1, 0.60, 0.1, 0.85),
    (5.0, 0.45, 0.0, 0.55),
]
# The tall tower, from below; and those beside it.
TALL = [
    (-0.9, 2.10, 0.2, 1.50), (-0.6, 3.20, 0.1, 1.45), (-0.9, 4.20, 0.0, 1.35), (-0.3, 5.05, -0.1, 1.25),
    (-1.75, 3.00, 0.6, 0.95), (0.45, 2.60, 0.8, 1.00), (-1.70, 4.30, 0.5, 0.80), (0.35, 4.10, 0.7, 0.90),
    (-0.75, 3.40, 1.1, 0.85), (-0.55, 4.85, 0.7, 0.75), (-1.25, 5.20, 0.1, 0.75),
]
LEFT = [
    (-3.4, 1.80, 0.1, 1.05), (-3.1, 2.55, 0.0, 0.85), (-4.2, 1.45, 0.3, 0.75), (-2.6, 1.90, 0.8, 0.80),
    (-3.55, 2.00, 0.75, 0.65),
]
RIGHT = [
    (2.1, 1.90, 0.1, 1.15), (2.5, 2.75, 0.0, 1.00), (2.2, 3.45, -0.1, 0.75), (3.35, 1.80, 0.2, 0.80),
    (1.55, 2.10, 0.9, 0.80), (2.85, 2.15, 0.8, 0.70),
]
ANVIL = [
    (-1.6, 5.75, -0.3, 0.75), (-0.4, 5.95, -0.3, 0.95), (0.8, 5.95, -0.3, 0.90), (1.9, 6.00, -0.4, 0.78),
    (2.9, 6.05, -0.4, 0.65), (3.8, 6.10, -0.5, 0.52), (4.55, 6.15, -0.5, 0.40), (5.15, 6.18, -0.5, 0.28),
    (-2.4, 5.85, -0.3, 0.50),
]


def main():
    with open("scenes/storm.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["x", "y", "z", "radius"])
        for puff in BASE + TALL + LEFT + RIGHT + ANVIL:
            writer.writerow([f"{value:.3f}" for value in puff])


main()
