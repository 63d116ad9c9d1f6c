"""A scene of Blender's, in its language: blender -b -P box.py -- OUT WIDTH HEIGHT SEED [BOUNCES]. Cycles renders it to a PNG file."""
import sys

import bpy

out, width, height, seed, *rest = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene


def material(name, color):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    made.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (*color, 1)
    return made


def add(kind, color, **placed):
    getattr(bpy.ops.mesh, f"primitive_{kind}_add")(**placed)
    bpy.context.object.data.materials.append(material(kind, color))


add("plane", (0.7, 0.7, 0.7), size=20)
add("plane", (0.8, 0.1, 0.1), size=20, location=(0, 4, 0), rotation=(1.5708, 0, 0))
add("cube", (0.2, 0.5, 0.9), size=1.4, location=(-1, 0, 0.7), rotation=(0, 0, 0.5))
add("uv_sphere", (0.9, 0.8, 0.3), radius=0.8, location=(1, 0, 0.8))
bpy.ops.object.light_add(type="AREA", location=(3, -4, 5), rotation=(0.8, 0, 0.6))
bpy.context.object.data.energy, bpy.context.object.data.size = 600, 1
bpy.ops.object.camera_add(location=(0, -7, 2.5), rotation=(1.3, 0, 0))
scene.camera = bpy.context.object

scene.render.engine = "CYCLES"
scene.cycles.samples, scene.cycles.seed = 16, int(seed)
scene.cycles.use_denoising = False
scene.cycles.max_bounces = int(rest[0]) if rest else 4
scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = int(width), int(height), 100
scene.render.image_settings.file_format, scene.render.image_settings.color_depth = "PNG", "16"
scene.view_settings.view_transform = "Standard"
scene.render.filepath = out
bpy.ops.render.render(write_still=True)
