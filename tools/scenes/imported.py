"""Simulates a burst of hot smoke in Blender, for `scenes/imported.toml`: `blender -b -P imported.py -- FOLDER`.

Blender's cache holds a dozen grids; what is kept of every fourth frame is the density and the temperature, as half
floats, rounded so that they pack well, without voxels that nobody sees (Debian and Ubuntu: blender and python3-openvdb).
"""

import sys
import tempfile
from pathlib import Path

import bpy
import pyopenvdb

FRAMES = 36
FIRST = 8
EVERY = 4
BURNS = 32
# Of the density, below which there is nothing.
LEAST = 0.04
# To a unit, of density and temperature.
STEPS = 16
HEAT_STEPS = 6


def domain():
    bpy.ops.mesh.primitive_cube_add(size=1, location=(0, 0, 3))
    thing = bpy.context.object
    thing.scale = (4.8, 4.8, 6)
    fluid = thing.modifiers.new("Fluid", "FLUID")
    fluid.fluid_type = "DOMAIN"
    settings = fluid.domain_settings
    settings.domain_type = "GAS"
    settings.resolution_max = 64
    settings.use_noise = False
    settings.vorticity = 0.12
    settings.alpha = 0.4
    settings.beta = 3.0
    settings.cache_type = "ALL"
    settings.cache_frame_start, settings.cache_frame_end = 1, FRAMES
    settings.cache_data_format = "OPENVDB"
    return thing, settings


def sources():
    """Two lumps on the ground."""
    lumps = []
    for place, radius in (((0.1, 0, 0.55), 0.5), ((-0.35, 0.15, 0.4), 0.3)):
        bpy.ops.mesh.primitive_uv_sphere_add(radius=radius, location=place)
        lumps.append(bpy.context.object)
    return lumps


def burn(lump):
    """Lets it burn for more than a second."""
    fluid = lump.modifiers.new("Fluid", "FLUID")
    fluid.fluid_type = "FLOW"
    flow = fluid.flow_settings
    flow.flow_type = "SMOKE"
    flow.flow_behavior = "INFLOW"
    flow.temperature = 3.0
    flow.density = 1.0
    flow.use_initial_velocity = True
    flow.velocity_normal = 1.5
    for frame, on in ((1, True), (BURNS, True), (BURNS + 1, False)):
        flow.use_inflow = on
        flow.keyframe_insert("use_inflow", frame=frame)


def keep(cached: Path, out: Path) -> None:
    """Density and temperature of one file, where there is any density."""
    density = pyopenvdb.read(str(cached), "density")
    heat = pyopenvdb.read(str(cached), "temperature")
    density.mapOn(lambda value: round(value * STEPS) / STEPS if value >= LEAST else 0.0)
    seen = density.getConstAccessor()
    for item in heat.iterOnValues():
        item.value = round(item.value * HEAT_STEPS) / HEAT_STEPS if seen.getValue(item.min) > 0.0 else 0.0
    for grid in (density, heat):
        grid.prune()
        grid.saveFloatAsHalf = True
    pyopenvdb.write(str(out), [density, heat])


def main(folder: str) -> None:
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    lumps = sources()
    room, settings = domain()
    for lump in lumps:
        burn(lump)
    # Without a window, the first updates fail in the fluid modifier's Python and the next ones work.
    for _ in range(5):
        try:
            bpy.context.view_layer.update()
        except SystemError:
            pass
    bpy.context.view_layer.objects.active = room
    with tempfile.TemporaryDirectory() as cache:
        settings.cache_directory = cache
        bpy.ops.fluid.bake_all()
        for frame in range(FIRST, FRAMES + 1, EVERY):
            cached = Path(cache) / "data" / f"fluid_data_{frame:04}.vdb"
            keep(cached, Path(folder) / f"burst.{frame:02}.vdb")


main(sys.argv[sys.argv.index("--") + 1])
