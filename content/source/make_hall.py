"""Builds the palace hall and writes it as binary glTF.

blender -b --factory-startup --python content/source/make_hall.py -- content/models/hall.glb
"""
import os
import sys

import bpy

sys.dont_write_bytecode = True
_HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [_HERE, os.path.join(_HERE, 'palace')]

import courtyard  # noqa: E402  (Blender runs this file without its folder on the path)
import furniture  # noqa: E402
import glb_file  # noqa: E402
import hall  # noqa: E402
import materials  # noqa: E402
import side_room  # noqa: E402
import statue  # noqa: E402


def _export(path):
    bpy.ops.export_scene.gltf(filepath=path, export_format="GLB", export_image_format="JPEG",
                              export_normals=True, export_texcoords=True, export_tangents=False, export_colors=False,
                              export_animations=False, export_extras=True, export_yup=True, export_cameras=False)


def _tidy(path):
    """Shortens names (Blender wants whole paths, unique), and lets viewers that cannot scale textures read the file."""
    document, binary = glb_file.read_glb(path)
    for node in document["nodes"]:
        node["name"] = node["name"].rsplit("/", 1)[-1]
    for material in document["materials"]:
        for texture in (material.get("normalTexture"), material["pbrMetallicRoughness"]["baseColorTexture"]):
            if texture:
                texture["extensions"]["KHR_texture_transform"] = {"scale": [0.5, 0.5]}
    document.pop("extensionsRequired", None)
    document["asset"]["copyright"] = "CC0-1.0, made by the scripts in content/source"
    glb_file.write_glb(path, document, binary)


def main():
    path = os.path.abspath(sys.argv[sys.argv.index("--") + 1])
    bpy.ops.wm.read_factory_settings(use_empty=True)
    materials.make_materials()
    for part in (hall, side_room, courtyard, furniture, statue):
        part.build()
    bpy.context.view_layer.update()
    _export(path)
    _tidy(path)


main()
