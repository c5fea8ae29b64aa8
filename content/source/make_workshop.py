"""Writes a machine shop: python3 content/source/make_workshop.py [FILE]"""
import math
import os
import sys

sys.dont_write_bytecode = True
_HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(_HERE, "shop"))

import locomotive  # noqa: E402
import machines  # noqa: E402
from solid_kit import Model, box, joined, moved, plate, ring, turned  # noqa: E402

HALF_X, HALF_Z, HEIGHT, WALL = 3.2, 2.4, 3.1, 0.25
WINDOW = (-2.2, -0.4, 1.35, 2.55)  # x and y, in the wall at -z


def _materials(model):
    locomotive.materials(model)
    model.material("Grey_Green", (118, 142, 128), 0.5)
    model.material("Iron", (104, 106, 110), 0.5, 0.5)
    model.material("Dark_Wood", (104, 72, 46), 0.7)
    model.material("Blue", (66, 102, 148), 0.4)
    model.material("White", (240, 236, 224), 0.6)
    model.material("Plaster", (222, 214, 198), 0.9)
    model.material("Concrete", (168, 164, 158), 0.9)


def _room(model):
    x, z, t = HALF_X, HALF_Z, WALL
    model.add("Room/Floor", box(-x - t, x + t, -0.2, 0.0, -z - t, z + t), "Concrete")
    model.add("Room/Ceiling", box(-x - t, x + t, HEIGHT, HEIGHT + 0.2, -z - t, z + t), "Plaster")
    model.add("Room/Wall_West", box(-x - t, -x, 0.0, HEIGHT, -z - t, z + t), "Plaster")
    model.add("Room/Wall_East", box(x, x + t, 0.0, HEIGHT, -z - t, z + t), "Plaster")
    model.add("Room/Wall_South", box(-x, x, 0.0, HEIGHT, z, z + t), "Plaster")
    x0, x1, y0, y1 = WINDOW
    outer, hole = [(-x, 0.0), (x, 0.0), (x, HEIGHT), (-x, HEIGHT)], [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    model.add("Room/Wall_North", moved(turned(ring(outer, hole, 0.0, t), "x", 90.0), 0.0, 0.0, -z - t), "Plaster")
    bars = [box(x0 + (x1 - x0) * i / 4 - 0.018, x0 + (x1 - x0) * i / 4 + 0.018, y0, y1, -0.03, 0.03) for i in (1, 2, 3)]
    cross = box(x0, x1, (y0 + y1) / 2 - 0.018, (y0 + y1) / 2 + 0.018, -0.025, 0.025)
    sill = box(x0 - 0.08, x1 + 0.08, y0 - 0.04, y0, -0.10, 0.20, 0.008)
    model.add("Room/Window", moved(joined(*bars, cross), 0.0, 0.0, -z - 0.13), "White")
    model.add("Room/Sill", moved(sill, 0.0, 0.0, -z), "White")
    model.add("Room/Skirting", joined(box(-x, x, 0.0, 0.12, -z, -z + 0.02), box(-x, -x + 0.02, 0.0, 0.12, -z + 0.02, z), box(x - 0.02, x, 0.0, 0.12, -z + 0.02, z)), "Dark_Wood")
    model.add("Room/Beams", joined(*[box(bx - 0.09, bx + 0.09, HEIGHT - 0.22, HEIGHT, -z, z) for bx in (-2.1, -0.7, 0.7, 2.1)]), "Dark_Wood")


def _quarter(deg):
    half = math.radians(deg) / 2
    return [0.0, round(math.sin(half), 6), 0.0, round(math.cos(half), 6)]


def _place(model, name, parts, at, deg=0.0):
    model.group(name, translation=list(at), **({"rotation": _quarter(deg)} if deg else {}))
    for part, solid, material in parts:
        model.add(f"{name}/{part}", solid, material)


def main():
    path = sys.argv[1] if len(sys.argv) > 1 else os.path.join(_HERE, "..", "models", "workshop.glb")
    model = Model("make_workshop.py")
    _materials(model)
    _room(model)
    _place(model, "Lathe", machines.engine_lathe(), (0.35, 0.0, -1.75))
    _place(model, "Drill_Press", machines.drill_press(), (-1.75, 0.0, -1.75), 25.0)
    _place(model, "Workbench", machines.workbench(), (2.78, 0.0, 0.25), -90.0)
    _place(model, "Vise", machines.vise(), (2.52, 0.90, 0.95), -90.0)
    _place(model, "Toolbox", machines.toolbox(), (2.92, 0.90, -0.52), -80.0)
    _place(model, "Locomotive", locomotive.parts(), (2.72, 0.93, 0.22), -78.0)
    _place(model, "Tools", machines.tool_wall(), (HALF_X - 0.051, 1.35, 0.25), -90.0)
    _place(model, "Gears", machines.gears(), (1.85, 1.95, -HALF_Z + 0.021))
    stool = machines.stool()
    _place(model, "Stool", stool, (1.75, 0.0, 0.75))
    _place(model, "Barrel", machines.barrel(), (-2.75, 0.0, -0.35))
    lamp = machines.lamp(0.95)
    _place(model, "Lamp_1", lamp, (0.2, HEIGHT, -1.1))
    _place(model, "Lamp_2", lamp, (2.25, HEIGHT, 0.2))
    model.write(path)


if __name__ == "__main__":
    main()
