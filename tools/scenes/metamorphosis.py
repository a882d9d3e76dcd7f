"""Places the particles of `scenes/metamorphosis.toml`: a cloud, a rabbit, and a smaller cloud.

Run it from the repository's root: `python3 tools/scenes/metamorphosis.py`; it needs nothing else.
"""

import math
import random

# A particle's skin lies at this share of its radius, at the scene's threshold.
SKIN = math.sqrt(1.0 - math.sqrt(0.35))


def ball(center, radius):
    """A particle whose own skin has this radius."""
    return (*center, radius / SKIN)


def limb(start, end, radii, count):
    """Balls in a row, whose radii run from one to the other."""
    for step in range(count):
        t = step / (count - 1)
        center = [a + t * (b - a) for a, b in zip(start, end)]
        yield ball(center, radii[0] + t * (radii[1] - radii[0]))


def rabbit():
    """Sits and looks to the right."""
    particles = [
        ball((-0.55, 0.95, 0.0), 0.86),
        ball((-0.1, 1.1, 0.0), 0.78),
        ball((0.32, 1.2, 0.0), 0.62),
        ball((0.62, 1.5, 0.0), 0.46),
        ball((1.0, 2.05, 0.0), 0.5),
        ball((1.3, 1.93, 0.0), 0.3),
        ball((1.2, 1.85, 0.16), 0.24),
        ball((1.2, 1.85, -0.16), 0.24),
        ball((-1.5, 0.78, 0.0), 0.3),
        ball((-1.62, 0.92, 0.08), 0.18),
    ]
    for side in (-1.0, 1.0):
        particles += limb((0.86, 2.4, 0.16 * side), (0.3 + 0.22 * side, 3.55, 0.3 * side), (0.19, 0.13), 9)
        particles += limb((-0.75, 0.55, 0.5 * side), (-0.2, 0.62, 0.55 * side), (0.46, 0.36), 4)
        particles += limb((-0.35, 0.2, 0.52 * side), (0.25, 0.17, 0.54 * side), (0.2, 0.16), 5)
        particles += limb((0.5, 0.95, 0.28 * side), (0.72, 0.2, 0.3 * side), (0.27, 0.15), 5)
        particles += limb((0.72, 0.17, 0.3 * side), (0.98, 0.15, 0.31 * side), (0.15, 0.13), 3)
    return particles


def cloud(center, width, height, count, seed):
    """Heaps on a flat base, the largest in the middle."""
    rng = random.Random(seed)
    particles = []
    for _ in range(count):
        x = rng.uniform(-1.0, 1.0)
        top = height * (1.0 - abs(x) ** 1.7)
        radius = (0.28 + 0.42 * (1.0 - abs(x))) * rng.uniform(0.75, 1.15) * height / 1.6
        y = rng.uniform(0.0, max(top - radius, 0.05))
        z = rng.uniform(-0.45, 0.45) * width * (1.0 - 0.6 * abs(x))
        particles.append(ball((center[0] + x * width, center[1] + y, center[2] + z), radius))
    return particles


def write(name, particles):
    with open(f"scenes/metamorphosis-{name}.csv", "w", encoding="utf-8") as file:
        file.write("x,y,z,radius\n")
        for particle in particles:
            file.write(",".join(f"{value:.3f}" for value in particle) + "\n")


if __name__ == "__main__":
    write("cloud", cloud((-1.2, 1.2, 0.0), 2.1, 1.7, 44, 11))
    write("rabbit", rabbit())
    write("wisps", cloud((-1.9, 2.1, 0.0), 0.95, 0.9, 14, 5) + cloud((1.6, 1.0, 0.2), 1.3, 1.1, 20, 8))
