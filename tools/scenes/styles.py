"""Writes `scenes/styles.toml`, a plate with one puff of smoke for each style preset, and `scenes/card.obj`, what they
stand before.

Rows are groups of presets as `fumetto_scene::presets` has them, in its order.

Run it from the repository's root: `python3 tools/scenes/styles.py`.
"""

ACROSS = 8
TILE = (2.8, 2.24)
CARD_SIZE = (2.7, 2.14)
PAPER = "#f3eee1"

# Presets, each with the colour behind it; none for that of the plate itself.
TILES = [
    ("cartoon", "#9cc9e6"), ("mcguire", None), ("flat", "#9cc9e6"), ("no-ink", "#4a93d4"),
    ("cel", "#9cc9e6"), ("anime", "#4a93d4"), ("comic", "#fbd160"), ("ligne-claire", "#9cc9e6"),
    ("pencil", None), ("sketch", None), ("crosshatch", None), ("brush", None),
    ("charcoal", None), ("crayon", None), ("sumi", None), ("chalk", "#26312e"),
    ("engraving", None), ("woodcut", None), ("scratchboard", "#0f0f10"), ("ukiyo-e", "#e8d9ae"),
    ("newspaper", None), ("manga", None), ("risograph", None), ("poster", "#83afa6"),
    ("watercolour", None), ("gouache", "#83afa6"), ("pastel", "#bfe3dc"), ("clay", "#83afa6"),
    ("technical", None), ("blueprint", "#1b4b8a"), ("noir", "#2b2935"), ("silhouette", "#fbd160"),
    ("sunset", "#8a6fa8"), ("moonlight", "#131a38"), ("neon", "#0c0720"), ("mist", "#d8e2e5"),
    ("storm", "#8d97a6"), ("dust", "#9fc3cf"), ("fire", "#2b2935"), ("soot", "#d9a877"),
]

# Strokes follow the lines of models and surfaces: these puffs have a skin, and leave nothing behind that is too small
# for a stroke.
SKINS = {"sketch", "brush", "charcoal", "crayon", "sumi", "chalk"}

# A puff of smoke, and what it leaves behind: x, y, z, radius.
PUFF = [
    (0.20, 0.07, 0.00, 0.50), (-0.30, -0.02, 0.04, 0.40), (0.65, -0.05, 0.00, 0.36), (0.05, 0.41, 0.00, 0.34),
    (0.43, 0.41, -0.04, 0.29), (0.01, -0.21, 0.26, 0.34), (0.46, -0.24, 0.21, 0.29), (-0.64, -0.14, 0.00, 0.24),
    (0.91, -0.17, 0.00, 0.19), (0.22, 0.70, 0.00, 0.17), (-0.33, 0.32, 0.00, 0.21), (-0.76, -0.52, 0.00, 0.15),
    (-0.97, -0.73, 0.00, 0.09),
]

HEAD = f"""# A plate of styles: one puff of smoke in every preset.
#
# Written by tools/scenes/styles.py. What counts for a whole picture, the largest `clean` and the largest `smooth` of
# strokes, counts for the plate: alone, styles that keep small shapes keep more of them.
format = 1

[camera]
eye = [0.0, 0.0, 120.0]
target = [0.0, 0.0, 0.0]
fov = 5.343

[[light]]
kind = "sun"
direction = [0.7, -0.8, -0.6]

[background]
colour = "{PAPER}"

[output]
size = [1120, 560]
antialias = 2

[time]
frames = [0, 0]
"""

CARD = """# A card, one metre on a side.
v -0.5 -0.5 0
v 0.5 -0.5 0
v 0.5 0.5 0
v -0.5 0.5 0
f 1 2 3 4
"""


def place(number):
    """The middle of a tile."""
    rows = -(-len(TILES) // ACROSS)
    column, row = number % ACROSS, number // ACROSS
    return (column - 0.5 * (ACROSS - 1)) * TILE[0], (0.5 * (rows - 1) - row) * TILE[1]


def cards():
    """One object for each colour, copied to where it is wanted."""
    places = {}
    for number, (_, colour) in enumerate(TILES):
        if colour:
            places.setdefault(colour, []).append(place(number))
    for number, (colour, middles) in enumerate(places.items()):
        scale = f"scale = [{CARD_SIZE[0]}, {CARD_SIZE[1]}, 1]"
        copies = "".join(f"  {{ position = [{x:.2f}, {y:.2f}, -1.6], {scale} }},\n" for x, y in middles)
        yield f"""
[[object]]
name = "card {number + 1}"
kind = "mesh"
model = "card.obj"
transform = [
{copies}]
style = {{ tones = ["{colour}"], ink = {{ on = false }}, shadow = {{ on = false, receive = false }} }}
"""


def puffs():
    for number, (preset, _) in enumerate(TILES):
        left, low = place(number)
        skin = preset in SKINS
        balls = PUFF[:-2] if skin else PUFF
        particles = [
            f"{{ center = [{left + x:.2f}, {low + y:.2f}, {z:.2f}], radius = {r:.2f} }}" for x, y, z, r in balls
        ]
        lines = "".join(f"  {', '.join(particles[k:k + 2])},\n" for k in range(0, len(particles), 2))
        shape = "shape = { surface = { threshold = 0.2, subdivisions = 72, size = 1.22 } }\n" if skin else ""
        yield f"""
[[object]]
name = "{preset}"
kind = "cloud"
style = {{ preset = "{preset}", height = 1000 }}
{shape}particles = [
{lines}]
"""


with open("scenes/styles.toml", "w", encoding="utf-8") as scene:
    scene.write(HEAD + "".join(cards()) + "".join(puffs()))
with open("scenes/card.obj", "w", encoding="utf-8") as card:
    card.write(CARD)
