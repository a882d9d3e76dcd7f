"""Writes `scenes/balls.glb`: a ball that hangs still, and a smaller one that swings past it.

Run it from the repository's root: `python3 tools/scenes/balls.py`; it needs NumPy.
"""

import numpy as np

from glb import Glb
from solids import ball

# Seconds of a swing there and back, how far it goes, and for how long it is written down.
PERIOD, REACH, SECONDS = 4.0, 2.6, 8.0
HIGH, ROPE = 2.7, 6.0


def main():
    glb = Glb()
    red, blue = glb.material("still", "#c2593f"), glb.material("swinging", "#3f6f8f")
    glb.node("still", [(red, ball((0.0, 1.3, 0.0), (0.34, 0.34, 0.34), 32))], crease_degrees=180.0)
    swinging = glb.node("swinging", [(blue, ball((0.0, 0.0, 0.0), (0.3, 0.3, 0.3), 28))], crease_degrees=180.0)
    times = np.linspace(0.0, SECONDS, 97)
    along = -REACH * np.cos(2.0 * np.pi * times / PERIOD)
    # On a circle round where its rope would hang.
    above = HIGH + ROPE - np.sqrt(ROPE**2 - along**2)
    glb.animate(swinging, "translation", times, np.stack([along, above, np.zeros_like(along)], axis=1))
    glb.save("scenes/balls.glb")


if __name__ == "__main__":
    main()
