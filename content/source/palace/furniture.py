"""Tables, benches, chairs, chests, chandeliers and a shelf."""
import math

import plan
from mesh_kit import Solid, box, lathe, make_mesh, place, prism, sweep

TABLE_SPOTS = [(-1.62, -3.9), (1.62, -3.9), (-1.62, 3.9), (1.62, 3.9)]


def _trestle(half, top):
    """A trestle end: a waisted board over a foot."""
    outline = [(-half, 0.0), (half, 0.0), (half, 0.07), (half * 0.30, top * 0.6), (half * 0.62, top),
               (-half * 0.62, top), (-half * 0.30, top * 0.6), (-half, 0.07)]
    return prism(outline, "y", -0.035, 0.035)


def _table(length=3.2, width=0.78):
    solid = box(-width / 2, width / 2, -length / 2, length / 2, 0.71, 0.77, 0.012)
    for end in (-1, 1):
        solid.merge(_trestle(0.32, 0.715), (0, end * (length / 2 - 0.4), 0))
    solid.merge(box(-0.04, 0.04, -length / 2 + 0.28, length / 2 - 0.28, 0.24, 0.33))
    return solid


def _bench(length=3.0):
    solid = box(-0.14, 0.14, -length / 2, length / 2, 0.41, 0.455)
    for end in (-1, 1):
        solid.merge(_trestle(0.15, 0.415), (0, end * (length / 2 - 0.35), 0))
    solid.merge(box(-0.02, 0.02, -length / 2 + 0.25, length / 2 - 0.25, 0.33, 0.415))
    return solid


def _chair():
    """A high-backed chair with a pointed crest; it faces -y."""
    solid = box(-0.31, 0.31, -0.27, 0.27, 0.43, 0.49, 0.012)
    for x in (-0.27, 0.27):
        solid.merge(box(x - 0.035, x + 0.035, -0.26, -0.19, 0.0, 0.72))
        solid.merge(box(x - 0.035, x + 0.035, 0.19, 0.26, 0.0, 1.32))
        solid.merge(box(x - 0.045, x + 0.045, -0.29, 0.2, 0.70, 0.745))
    crest = [(-0.24, 0.52), (0.24, 0.52), (0.24, 1.22), (0.14, 1.38), (0.0, 1.52), (-0.14, 1.38), (-0.24, 1.22)]
    return solid.merge(prism(crest, "y", 0.205, 0.245))


def _chest():
    """A chest with a barrel lid."""
    solid = box(-0.62, 0.62, -0.30, 0.30, 0.05, 0.48, 0.012)
    for x in (-0.55, 0.55):
        solid.merge(box(x - 0.05, x + 0.05, -0.31, 0.31, 0.0, 0.10))
    lid = [(0.315 * math.cos(a), 0.475 + 0.17 * math.sin(a)) for a in [math.pi * i / 6 for i in range(7)]]
    return solid.merge(prism(lid, "x", -0.635, 0.635))


def _chest_straps():
    solid = Solid()
    for x in (-0.38, 0.38):
        ring = [(0.33 * math.cos(a), 0.465 + 0.195 * math.sin(a)) for a in [math.pi * i / 6 for i in range(7)]]
        solid.merge(prism(ring, "x", x - 0.035, x + 0.035))
    return solid.merge(box(-0.08, 0.08, -0.322, -0.25, 0.34, 0.50))


def _chandelier():
    """A wheel of iron on three chains, with eight candle cups."""
    radius, sides, solid = 0.85, 12, Solid()
    circle = [(radius * math.cos(2 * math.pi * i / sides), radius * math.sin(2 * math.pi * i / sides), 0.0) for i in range(sides)]
    solid.merge(sweep(circle, [(-0.05, -0.02), (0.05, -0.02), (0.05, 0.02), (-0.05, 0.02)], (0, 0, 1), closed=True))
    for i in range(8):
        a = math.pi * i / 4
        solid.merge(box(-0.028, 0.028, -0.028, 0.028, 0.03, 0.24), (radius * math.cos(a), radius * math.sin(a), 0))
    for i in range(2):
        solid.merge(box(-radius, radius, -0.02, 0.02, -0.02, 0.02), (0, 0, 0.004 * i), 90 * i + 22.5)
    for i in range(3):
        a = 2 * math.pi * i / 3
        path = [(radius * math.cos(a), radius * math.sin(a), 0.03), (0.0, 0.0, 1.6)]
        solid.merge(sweep(path, [(-0.012, -0.012), (0.012, -0.012), (0.0, 0.014)], (-math.sin(a), math.cos(a), 0)))
    return solid


def _chandeliers():
    mesh = make_mesh("Chandelier", _chandelier(), "Iron", smooth_deg=30)
    chain = make_mesh("Chain", sweep([(0, 0, 1.55), (0, 0, 4.3)], [(-0.02, -0.02), (0.02, -0.02), (0.0, 0.02)], (1, 0, 0)), "Iron")
    for i, y in enumerate((-4.8, 4.8)):
        place(f"Furniture/Chandelier_{i + 1:02d}", mesh, (0, y, 4.55))
        place(f"Furniture/Chandelier_{i + 1:02d}/Chain", chain)


def _side_room():
    (x0, x1), (y0, y1) = plan.ROOM_X, plan.ROOM_Y
    chair, chest, straps, table = _MESHES["Chair"], _MESHES["Chest"], _MESHES["Chest_Straps"], _MESHES["Table"]
    place("SideRoom/Table", table, (x0 + 1.6, 4.4, 0))
    place("SideRoom/Chair", chair, (x0 + 0.75, 4.4, 0), 90)
    place("SideRoom/Chest", chest, (x0 + 2.4, y1 - 0.42, 0))
    place("SideRoom/Chest/Straps", straps)
    shelf = Solid()
    for z in (0.35, 0.95, 1.55):
        shelf.merge(box(-0.6, 0.6, -0.2, 0.2, z, z + 0.04))
    for x in (-0.62, 0.62):
        shelf.merge(box(x - 0.03, x + 0.03, -0.21, 0.21, 0.0, 1.85))
    place("SideRoom/Shelf", make_mesh("Shelf", shelf, "Plank", grain=0), (x0 + 1.4, y0 + 0.26, 0))
    jug = lathe([(0.05, 0.0, 0), (0.09, 0.10, 0), (0.04, 0.20, 0), (0.055, 0.25, 0)], 8)
    place("SideRoom/Jug", make_mesh("Jug", jug, "Bronze", smooth_deg=60), (x0 + 1.55, 4.9, 0.77))


_MESHES = {}


def build():
    """Places Furniture/ in the hall and the furniture of SideRoom/."""
    for name, solid, material, grain in (("Table", _table(), "Plank", 1), ("Bench", _bench(), "Plank", 1),
        ("Chair", _chair(), "Plank", 2),
                                         ("Chest", _chest(), "Plank", 0), ("Chest_Straps", _chest_straps(), "Iron", None)):
        _MESHES[name] = make_mesh(name, solid, material, grain=grain)
    for i, (x, y) in enumerate(TABLE_SPOTS):
        place(f"Furniture/Table_{i + 1:02d}", _MESHES["Table"], (x, y, 0))
        for j, side in enumerate((-1, 1)):
            place(f"Furniture/Bench_{2 * i + j + 1:02d}", _MESHES["Bench"], (x + side * 0.56, y, 0))
    for i, x in enumerate((-4.6, 4.6)):
        place(f"Furniture/Chair_{i + 1:02d}", _MESHES["Chair"], (x, plan.HALL_Y - 0.55, 0))
    place("Furniture/Chest_01", _MESHES["Chest"], (plan.HALL_X - 0.55, 4.8, 0), -90)
    place("Furniture/Chest_01/Straps", _MESHES["Chest_Straps"])
    _chandeliers()
    _side_room()
