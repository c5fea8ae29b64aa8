"""Builds the palace hall and writes it as binary glTF.

blender -b --factory-startup --python content/source/make_hall.py -- content/models/hall.glb
"""
import os
import sys

import bpy

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

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


def _shorten_names(path):
    """Blender needs unique names, so objects carry their whole path; in the file the tree says it already."""
    document, binary = glb_file.read_glb(path)
    for node in document["nodes"]:
        node["name"] = node["name"].rsplit("/", 1)[-1]
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
    _shorten_names(path)


main()
