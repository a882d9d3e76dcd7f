"""Draws a density with Blender's Cycles, for `volumes.py`: `blender -b -P cycles.py -- FOLDER VOXELS WANTED`.

FOLDER holds `density.raw`, 32-bit floats with x first of a box from -1 to 1, and `truth.raw`, 640 x 480 floats. Light is
scattered once. Doubles the samples of steps of one and of four voxels until a picture is within an RMSE of WANTED, and
prints of the fastest: the step, samples, milliseconds and RMSE. (Debian and Ubuntu: blender and python3-openvdb.)
"""

import math
import sys
import time
from pathlib import Path

import bpy
import numpy as np
import pyopenvdb

WIDTH, HEIGHT = 640, 480
EXTINCTION = 6.0
MOST_SAMPLES = 256


def volume(folder, voxels, shift):
    """The density as a file whose first voxel lies `shift` voxels beside where it should."""
    field = np.fromfile(folder / "density.raw", dtype=np.float32).reshape(voxels, voxels, voxels)
    grid = pyopenvdb.FloatGrid()
    grid.name = "density"
    grid.copyFromArray(np.ascontiguousarray(field.transpose(2, 1, 0)))
    side = 2 / voxels
    first = side * (0.5 + shift) - 1
    grid.transform = pyopenvdb.createLinearTransform(
        [[side, 0, 0, 0], [0, side, 0, 0], [0, 0, side, 0], [first, first, first, 1]]
    )
    path = folder / "density.vdb"
    pyopenvdb.write(str(path), grids=[grid])
    return path


def scene(path):
    """The camera looks along -z, as Fumetto's does; Blender's way up does not matter here."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    here = bpy.context.scene
    bpy.ops.object.volume_import(filepath=str(path), align="WORLD")
    ball = bpy.context.object
    ball.rotation_euler = (0, 0, 0)
    ball.location = (0, 0, 0)
    material = bpy.data.materials.new("matter")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    matter, output = nodes.new("ShaderNodeVolumePrincipled"), nodes.new("ShaderNodeOutputMaterial")
    matter.inputs["Color"].default_value = (1, 1, 1, 1)
    matter.inputs["Density"].default_value = EXTINCTION
    links.new(matter.outputs["Volume"], output.inputs["Volume"])
    ball.data.materials.append(material)
    sun = bpy.data.lights.new("sun", "SUN")
    # Their phase function is that of all directions, ours gives all to each.
    sun.energy, sun.angle = 4 * math.pi, 0
    lamp = bpy.data.objects.new("sun", sun)
    lamp.rotation_mode = "QUATERNION"
    from mathutils import Vector

    lamp.rotation_quaternion = Vector((0.5, -1.0, -0.6)).to_track_quat("-Z", "Y")
    camera = bpy.data.cameras.new("eye")
    camera.sensor_fit, camera.angle = "VERTICAL", math.radians(36)
    eye = bpy.data.objects.new("eye", camera)
    eye.location = (0, 0, 4)
    for thing in (lamp, eye):
        here.collection.objects.link(thing)
    here.camera = eye
    here.render.engine = "CYCLES"
    here.render.threads_mode, here.render.threads = "FIXED", 2
    here.render.resolution_x, here.render.resolution_y, here.render.resolution_percentage = WIDTH, HEIGHT, 100
    here.render.image_settings.file_format, here.render.image_settings.color_depth = "OPEN_EXR", "32"
    here.view_settings.view_transform = "Raw"
    cycles = here.cycles
    cycles.max_bounces = cycles.volume_bounces = 0
    cycles.use_denoising = cycles.use_adaptive_sampling = False
    cycles.pixel_filter_type, cycles.filter_width = "BOX", 1.0
    return here


def draw(here, folder, samples, rate):
    """Milliseconds, and the picture from above down."""
    here.cycles.samples, here.cycles.volume_step_rate = samples, rate
    here.render.filepath = str(folder / "cycles.exr")
    begin = time.perf_counter()
    bpy.ops.render.render(write_still=True)
    spent = 1e3 * (time.perf_counter() - begin)
    image = bpy.data.images.load(here.render.filepath)
    pixels = np.array(image.pixels[:], dtype=np.float32).reshape(HEIGHT, WIDTH, 4)[::-1, :, 0]
    bpy.data.images.remove(image)
    return spent, pixels


def main():
    folder, voxels, wanted = sys.argv[sys.argv.index("--") + 1 :]
    folder, voxels, wanted = Path(folder), int(voxels), float(wanted)
    truth = np.fromfile(folder / "truth.raw", dtype=np.float32).reshape(HEIGHT, WIDTH)
    rmse = lambda picture: float(np.sqrt(np.mean((picture - truth) ** 2)))
    # Blender up to 4.5 draws a file half a voxel beside where it says.
    tried = [(rmse(draw(scene(volume(folder, voxels, shift)), folder, 4, 1)[1]), shift) for shift in (0, -0.5)]
    here = scene(volume(folder, voxels, min(tried)[1]))
    found = []
    for rate in (1, 4):
        samples = 1
        while samples <= MOST_SAMPLES:
            spent, picture = draw(here, folder, samples, rate)
            if rmse(picture) <= wanted:
                found.append((spent, rate, samples, rmse(picture)))
                break
            samples *= 2
    if found:
        spent, rate, samples, error = min(found)
        print("CYCLES", rate, samples, spent, error)
    else:
        print("CYCLES none", min(tried))


main()
