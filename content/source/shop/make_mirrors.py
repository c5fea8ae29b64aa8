"""Writes a dressing room with two mirrors that face each other and a basin of water: python3 content/source/shop/make_mirrors.py [FILE]"""
import os
import sys

sys.dont_write_bytecode = True

from solid_kit import Model, box, circle, joined, lathe, moved, ring, turned  # noqa: E402

X, Z, HEIGHT = 3.0, 2.5, 3.0                     # half the room's width and depth, its height
PANE = (0.35, 2.45, 1.1)                         # of a mirror: lower and upper edge, half its width
PANE_OUT, FRAME_OUT, FRAME_WIDTH = 0.04, 0.08, 0.09  # metres before the wall; metres
VASE = [(0.0, 0.0), (0.13, 0.0), (0.19, 0.12), (0.21, 0.24), (0.17, 0.38), (0.09, 0.48), (0.075, 0.54), (0.12, 0.62), (0.10, 0.62),
        (0.05, 0.54), (0.0, 0.50)]
BASIN = [(0.0, 0.0), (0.22, 0.0), (0.22, 0.05), (0.15, 0.12), (0.14, 0.45), (0.30, 0.62), (0.58, 0.70), (0.62, 0.76), (0.62, 0.84),
         (0.55, 0.84), (0.54, 0.76), (0.0, 0.70)]


def _materials(model):
    for name, colour, roughness in (("Plaster", (204, 196, 182), 0.9), ("Boards", (140, 108, 79), 0.7), ("Beam", (111, 84, 63), 0.8),
                                    ("Gilt", (206, 173, 101), 0.35), ("Clay", (188, 118, 84), 0.6), ("Cloth", (79, 112, 157), 0.9),
                                    ("Stone", (174, 170, 162), 0.8), ("Glass", (63, 69, 69), 0.2), ("Water", (25, 36, 39), 0.1)):
        model.material(name, colour, roughness)


def _room(model):
    def wall(a, b):
        return [(a[0], 0.0, a[1]), (b[0], 0.0, b[1]), (b[0], HEIGHT, b[1]), (a[0], HEIGHT, a[1])]
    corners = [(-X, Z), (-X, -Z), (X, -Z), (X, Z)]
    model.add("Room/Walls", [wall(a, b) for a, b in zip(corners, corners[1:] + corners[:1])], "Plaster")
    model.add("Room/Floor", [[(-X, 0.0, Z), (X, 0.0, Z), (X, 0.0, -Z), (-X, 0.0, -Z)]], "Boards")
    model.add("Room/Ceiling", [[(-X, HEIGHT, -Z), (X, HEIGHT, -Z), (X, HEIGHT, Z), (-X, HEIGHT, Z)]], "Plaster")
    beams = [box(x - 0.09, x + 0.09, HEIGHT - 0.22, HEIGHT + 0.1, -Z - 0.1, Z + 0.1) for x in (-1.8, -0.6, 0.6, 1.8)]
    model.add("Room/Beams", joined(*beams), "Beam")


def _mirror(model, name, deg):
    """On the wall -x, or by 180 degrees on the other."""
    low, high, half = PANE

    def outline(more):
        return [(-half - more, low - more), (half + more, low - more), (half + more, high + more), (-half - more, high + more)]
    glass = [[(y, -z) for z, y in outline(0.0)]]
    glass = [[(-X + PANE_OUT, y, z) for y, z in glass[0]]]
    frame = turned(turned(ring(outline(FRAME_WIDTH), outline(0.0), -0.02, FRAME_OUT), "x", 90.0), "y", 90.0)
    model.add(f"{name}/Glass", turned(glass, "y", deg), "Glass")
    model.add(f"{name}/Frame", turned(moved(frame, x=-X), "y", deg), "Gilt")


def _legs(half_x, half_z, half, height):
    return [box(x - half, x + half, 0.0, height, z - half, z + half) for x in (-half_x, half_x) for z in (-half_z, half_z)]


def _things(model):
    model.group("Table", translation=[-1.1, 0.0, -1.45])
    model.add("Table/Board", box(-0.75, 0.75, 0.71, 0.77, -0.4, 0.4, 0.01), "Boards")
    model.add("Table/Legs", joined(*_legs(0.68, 0.33, 0.04, 0.71)), "Boards")
    model.add("Table/Vase", lathe(VASE, 40), "Clay", 50.0, translation=[-0.35, 0.77, 0.05])
    bowl = lathe([(0.0, 0.0), (0.08, 0.0), (0.2, 0.13), (0.18, 0.13), (0.0, 0.04)], 40)
    model.add("Table/Bowl", bowl, "Stone", translation=[0.3, 0.77, 0.0])
    model.group("Stool", translation=[-1.75, 0.0, 0.35])
    model.add("Stool/Seat", box(-0.25, 0.25, 0.42, 0.48, -0.25, 0.25, 0.01), "Boards")
    model.add("Stool/Legs", joined(*_legs(0.21, 0.21, 0.03, 0.42)), "Boards")
    cushion = lathe([(0.0, 0.0), (0.17, 0.0), (0.225, 0.025), (0.235, 0.05), (0.21, 0.085), (0.12, 0.11), (0.0, 0.118)], 40)
    model.add("Stool/Cushion", cushion, "Cloth", 60.0, translation=[0.0, 0.48, 0.0])
    model.add("Basin", lathe(BASIN, 48), "Stone", translation=[0.55, 0.0, 0.45])
    model.add("Basin/Water", [[(x, 0.0, -z) for x, z in circle(0.546, 48)]], "Water", translation=[0.0, 0.79, 0.0])
    model.add("Vase", lathe([(1.35 * r, 1.6 * y) for r, y in VASE], 40), "Clay", 50.0, translation=[2.3, 0.0, -1.9])


def main():
    path = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "models", "mirrors.glb")
    model = Model("make_mirrors.py")
    _materials(model)
    _room(model)
    _mirror(model, "Mirror_West", 0.0)
    _mirror(model, "Mirror_East", 180.0)
    _things(model)
    model.write(path)


if __name__ == "__main__":
    main()
