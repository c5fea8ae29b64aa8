"""Blender materials from the drawn textures; UVs are metres, so a two-metre tile is scaled by 0.5."""
import bpy
import numpy as np

import textures


def _image(name, pixels, is_data):
    size = pixels.shape[0]
    image = bpy.data.images.new(name, size, size, alpha=False, is_data=is_data)
    rgba = np.ones((size, size, 4), np.float32)
    rgba[..., :3] = np.clip(pixels[::-1], 0.0, 1.0)
    image.pixels.foreach_set(rgba.ravel())
    image.pack()
    return image


def _texture_node(tree, image, scale):
    node = tree.nodes.new("ShaderNodeTexImage")
    node.image = image
    mapping = tree.nodes.new("ShaderNodeMapping")
    mapping.inputs["Scale"].default_value = (scale, scale, 1.0)
    uv = tree.nodes.new("ShaderNodeUVMap")
    uv.uv_map = "UVMap"
    tree.links.new(uv.outputs["UV"], mapping.inputs["Vector"])
    tree.links.new(mapping.outputs["Vector"], node.inputs["Vector"])
    return node


def _make_material(name):
    colour, height = textures.TEXTURES[name]()
    roughness, metalness = textures.SURFACE[name]
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    material.use_backface_culling = True
    tree = material.node_tree
    shader = tree.nodes["Principled BSDF"]
    shader.inputs["Roughness"].default_value = roughness
    shader.inputs["Metallic"].default_value = metalness
    scale = 1.0 / textures.TILE_M
    base = _texture_node(tree, _image(name + "_colour", colour, False), scale)
    tree.links.new(base.outputs["Color"], shader.inputs["Base Color"])
    if height is None:
        return
    bumps = _texture_node(tree, _image(name + "_normal", textures.normal_map(height), True), scale)
    normal = tree.nodes.new("ShaderNodeNormalMap")
    tree.links.new(bumps.outputs["Color"], normal.inputs["Color"])
    tree.links.new(normal.outputs["Normal"], shader.inputs["Normal"])


def make_materials():
    """Creates every material of the hall."""
    for name in textures.TEXTURES:
        _make_material(name)
