"""The courtyard east of the hall: well, ground, surrounding ranges with tiled gable roofs, buttresses, the hall's roof."""
import math

import plan
from mesh_kit import Solid, arch_outline, box, carve_mesh, lathe, loft, make_mesh, place, prism, sweep

EAVE = 5.2                           # of the lower ranges
HALL_OUT_X, HALL_OUT_Y = plan.HALL_X + plan.WALL, plan.HALL_Y + plan.WALL
EAST_RANGE_X = (plan.COURT_X[1], 29.0)
NORTH_RANGE_Y = (plan.COURT_Y[1], 17.8)
EAST_RANGE_END = 18.0
TILE_SLAB = 0.2


# ---- Roofs ----------------------------------------------------------------------------------------------------------

def gable_roof(half_width, eave, ridge, overhang):
    """Outline (across, z) of a roof of two slabs that meet at the ridge."""
    slope = (ridge - eave) / half_width
    foot = half_width + overhang
    low = eave - overhang * slope
    return [(-foot, low), (0.0, ridge), (foot, low), (foot, low + TILE_SLAB), (0.0, ridge + TILE_SLAB * 1.5),
        (-foot, low + TILE_SLAB)]


def _ridge_tiles(length):
    ring = [(0.17 * math.cos(a), 0.17 * math.sin(a)) for a in (-0.5, 0.5, 1.2, 1.94, 2.64, 3.64)]
    return prism(ring, "y", -length / 2, length / 2)


def _roof(path, name, centre, turn, half_width, length, eave, ridge, overhang=0.5):
    """A gable roof along local y; slabs, ridge tiles and the two gable walls."""
    slabs = prism(gable_roof(half_width, eave, ridge, overhang), "y", -length / 2 - 0.25, length / 2 + 0.25)
    slabs.merge(_ridge_tiles(length + 0.56), (0, 0, ridge + TILE_SLAB * 1.5 + 0.02))
    place(f"{path}/Roof_Tiles{name}", make_mesh(f"Roof_Tiles{name}", slabs, "Roof_Tile"), centre, turn)
    half, end = half_width - 0.02, length / 2 - 0.02
    inner = [(-half, eave - 0.3), (half, eave - 0.3), (half, eave + 0.02), (0.0, ridge + 0.05), (-half, eave + 0.02)]
    gables = prism(inner, "y", -end, 0.6 - end).merge(prism(inner, "y", end - 0.6, end))
    place(f"{path}/Gables{name}", make_mesh(f"Gables{name}", gables, "Stone"), centre, turn)


def _roofs():
    _roof("Hall", "", (0, 0, 0), 0, HALL_OUT_X, 2 * HALL_OUT_Y, 10.05, 17.8)
    (x0, x1), (y0, y1) = EAST_RANGE_X, NORTH_RANGE_Y
    south, north = plan.COURT_Y[0] - 0.8, EAST_RANGE_END
    _roof("Courtyard", "_East", ((x0 + x1) / 2, (south + north) / 2, 0), 0, (x1 - x0) / 2, north - south, EAVE, EAVE + 3.5)
    west = HALL_OUT_X + 0.2
    _roof("Courtyard", "_North", ((west + x0 + 2.2) / 2, (y0 + y1) / 2, 0), 90, (y1 - y0) / 2, x0 + 2.2 - west, EAVE + 0.01,
        EAVE + 3.42)


# ---- Ranges ---------------------------------------------------------------------------------------------------------

def _niche(half, sill, spring, rise, depth):
    return prism(arch_outline(half, sill, spring, rise, 3), "y", -0.3, depth)


def _range_body(name, bounds, heights, face, niches):
    """A closed block with blind openings in its courtyard face, which lies at x or y = a value."""
    x0, x1, y0, y1 = bounds
    (z0, z1), (face_axis, face_at) = heights, face
    body = box(x0, x1, y0, y1, z0, z1)
    turn = {"x": -90.0, "y": 0.0}[face_axis]
    cutters = []
    for along, sizes in niches:
        at = (face_at, along, 0) if face_axis == "x" else (along, face_at, 0)
        cutters.append(Solid().merge(_niche(*sizes), at, turn))
    place(f"Courtyard/Range_{name}", carve_mesh(f"Range_{name}", body, cutters, "Stone"))


LOW_WINDOW = (0.42, 0.95, 1.75, 0.55, 0.35)
HIGH_WINDOW = (0.40, 3.2, 4.0, 0.5, 0.35)
BLIND_DOOR = (0.65, plan.COURT_Z + 0.07, 1.75, 0.75, 0.30)


def _ranges():
    (x0, x1), (y0, y1) = EAST_RANGE_X, NORTH_RANGE_Y
    low = [(y, BLIND_DOOR if y == 0 else LOW_WINDOW) for y in (-8, -4, 0, 4, 8)]
    _range_body("East", (x0, x1, plan.COURT_Y[0] - 0.8, EAST_RANGE_END), (-0.62, EAVE), ("x", x0), low)
    row = [(x, BLIND_DOOR if x == 15 else LOW_WINDOW) for x in (10, 15, 20)] + [(x, HIGH_WINDOW) for x in (10, 12.5, 15, 17.5, 20)]
    _range_body("North", (HALL_OUT_X - 0.05, x0 + 0.1, y0, y1), (-0.58, EAVE - 0.02), ("y", y0), row)
    _leaf_doors(x0, y0)
    _timber_frame(x0)


def _leaf_doors(x0, y0):
    leaf = prism([(x, z) for x, z in arch_outline(0.68, plan.COURT_Z - 0.05, 1.75, 0.78, 3)], "y", 0.18, 0.26)
    mesh = make_mesh("Range_Door", leaf, "Plank", grain=2)
    place("Courtyard/Door_East", mesh, (x0, 0, 0), -90)
    place("Courtyard/Door_North", mesh, (15, y0, 0))


def _beam_between(a, b, half=0.10, depth=0.10):
    """A timber in the plane x = 0 between two (y, z) points."""
    length = math.dist(a, b)
    uy, uz = (b[0] - a[0]) / length, (b[1] - a[1]) / length
    corner = lambda p, s: (p[0] - uz * s * half, p[1] + uy * s * half)  # noqa: E731
    return prism([corner(a, -1), corner(b, -1), corner(b, 1), corner(a, 1)], "x", -depth, 0.05)


def _timber_frame(face_x):
    """The upper storey of the east range: plaster panels between oak timbers, jettied a little."""
    y0, y1, z0, z1 = plan.COURT_Y[0] + 0.25, plan.COURT_Y[1], 2.95, EAVE - 0.02
    plaster = box(face_x - 0.16, face_x + 0.05, y0 + 0.05, y1 + 0.02, z0, z1)
    place("Courtyard/Upper_Storey", make_mesh("Upper_Storey", plaster, "Plaster"))
    frame = box(face_x - 0.30, face_x - 0.02, y0, y1 + 0.01, z0 - 0.14, z0 + 0.12)
    frame.merge(box(face_x - 0.27, face_x - 0.02, y0 + 0.01, y1 + 0.012, z1 - 0.22, z1 - 0.01))
    for i in range(9):
        y = -10.8 + 2.7 * i
        frame.merge(_beam_between((y, z0 + 0.05), (y, z1 - 0.1)), (face_x - 0.15, 0, 0))
        lean = 0.85 if i % 2 else -0.85
        if i < 8:
            centre = y + 1.35
            frame.merge(_beam_between((centre - lean, z0 + 0.05), (centre + lean, z1 - 0.1), 0.08, 0.08), (face_x - 0.15, 0, 0))
    place("Courtyard/Timber_Frame", make_mesh("Timber_Frame", frame, "Plank", grain=2))


# ---- Hall outside, gate, ground --------------------------------------------------------------------------------------

def _buttresses():
    """Stepped buttresses between the hall's windows and at its corners."""
    steps = [(-0.1, -0.55), (1.1, -0.55), (1.1, 0.7), (1.0, 0.85), (1.0, 3.6), (0.62, 4.4), (0.62, 6.9), (-0.1, 8.2)]
    mesh = make_mesh("Buttress", prism(steps, "y", -0.45, 0.45), "Stone")
    narrow = [(y, 0.0, HALL_OUT_X) for y in plan.COLUMN_Y]
    for i, (y, turn, x) in enumerate(narrow):
        place(f"Courtyard/Buttress_{i + 1:02d}", mesh, (x, y, 0), turn)
    corners = [(HALL_OUT_X - 0.2, HALL_OUT_Y - 0.2, 45), (HALL_OUT_X - 0.2, -HALL_OUT_Y + 0.2, -45),
               (-HALL_OUT_X + 0.2, HALL_OUT_Y - 0.2, 135), (-HALL_OUT_X + 0.2, -HALL_OUT_Y + 0.2, -135)]
    for i, (x, y, turn) in enumerate(corners):
        place(f"Hall/Corner_Buttress_{i + 1:02d}", mesh, (x, y, 0), turn)


def _cornice():
    """The moulded cornice under the eaves of the hall and the string course below the windows, courtyard side."""
    eaves = [(-0.30, -0.08), (-0.26, 0.06), (-0.12, 0.12), (-0.04, 0.24), (0.10, 0.26), (0.14, -0.08)]
    x, y = HALL_OUT_X, HALL_OUT_Y
    for name, sign in (("East", 1), ("West", -1)):
        path = [(sign * x, -sign * (y + 0.1), plan.WALL_TOP), (sign * x, sign * (y + 0.1), plan.WALL_TOP)]
        place(f"Hall/Cornice_{name}", make_mesh(f"Cornice_{name}", sweep(path, eaves, (0, 0, 1)), "Stone"))
    course = [(-0.08, -0.05), (-0.07, 0.04), (0.0, 0.09), (0.07, -0.05)]
    path = [(x, -y + 0.3, 3.45), (x, plan.COURT_Y[1] + 0.05, 3.45)]
    place("Courtyard/String_Course", make_mesh("Court_String_Course", sweep(path, course, (0, 0, 1)), "Stone"))


def _gate_wall():
    """The south wall of the courtyard with its closed gate."""
    y1 = plan.COURT_Y[0] - 0.02
    body = box(HALL_OUT_X - 0.1, EAST_RANGE_X[0] + 0.1, y1 - 0.7, y1, -0.66, 3.7)
    void = prism(arch_outline(1.4, plan.COURT_Z + 0.07, 1.6, 1.45, 5), "y", y1 - 1.0, y1 + 0.3)
    place("Courtyard/Gate_Wall", carve_mesh("Gate_Wall", body, [Solid().merge(void, (15, 0, 0))], "Stone"))
    leaf = prism(arch_outline(1.44, plan.COURT_Z - 0.05, 1.6, 1.49, 5), "y", y1 - 0.45, y1 - 0.33)
    place("Courtyard/Gate", make_mesh("Gate", leaf, "Plank", grain=2), (15, 0, 0))
    coping = [(-0.5, 3.66), (0.5, 3.66), (0.5, 3.78), (0.0, 4.25), (-0.5, 3.78)]
    coping_solid = Solid().merge(prism(coping, "y", HALL_OUT_X - 0.05, EAST_RANGE_X[0] + 0.05), (0, 0, 0), -90)
    place("Courtyard/Gate_Coping", make_mesh("Gate_Coping", coping_solid, "Roof_Tile"), (0, y1 - 0.35, 0))


def _ground():
    (x0, x1), (y0, y1) = plan.COURT_X, plan.COURT_Y
    court = box(x0 - 0.13, x1 + 0.5, y0 - 0.5, y1 + 0.5, plan.COURT_Z - 0.2, plan.COURT_Z)
    place("Courtyard/Ground", make_mesh("Court_Ground", court, "Ground"))
    place("Terrain", make_mesh("Terrain", box(-60, 60, -60, 60, -0.9, -0.38), "Ground"))
    path = box(x0 - 0.05, 12.6, -0.9, 0.9, plan.COURT_Z - 0.1, plan.COURT_Z + 0.05, 0.03)
    place("Courtyard/Path", make_mesh("Court_Path", path, "Flagstone"))


# ---- Well -----------------------------------------------------------------------------------------------------------

WELL = (15.0, 3.2)


def _well_ring():
    profile = [(1.22, -0.25), (1.22, 0.0), (1.08, 0.05), (1.05, 0.70), (1.14, 0.74), (1.16, 0.86), (1.10, 0.92),
               (0.80, 0.92), (0.76, 0.88), (0.76, -0.25)]
    sides, rings = 16, []
    for i in range(sides):
        a = 2 * math.pi * i / sides
        rings.append([(r * math.cos(a), r * math.sin(a), z) for r, z in profile])
    return loft(rings, closed_path=True)


def _well():
    at = (*WELL, plan.COURT_Z)
    place("Courtyard/Well", make_mesh("Well", _well_ring(), "Stone", smooth_deg=40), at)
    water = lathe([(0.78, -0.1, 0), (0.78, 0.18, 0)], 16)
    place("Courtyard/Well/Water", make_mesh("Well_Water", water, "Iron"))
    frame = Solid()
    for side in (-1, 1):
        frame.merge(box(side * 0.95 - 0.09, side * 0.95 + 0.09, -0.09, 0.09, 0.86, 2.65, 0.02))
        frame.merge(_beam_between((0.0, 2.1), (0.85, 2.62), 0.05, 0.05), (side * 0.95 + 0.025, 0, 0))
        frame.merge(_beam_between((0.0, 2.1), (-0.85, 2.62), 0.05, 0.05), (side * 0.95 + 0.025, 0, 0))
    frame.merge(box(-1.25, 1.25, -0.07, 0.07, 2.55, 2.69))
    drum = lathe([(0.10, -0.93, 0), (0.10, 0.93, 0)], 8)
    frame.merge(Solid().add([(z, x, y + 1.75) for x, y, z in drum.points], drum.faces))
    place("Courtyard/Well/Frame", make_mesh("Well_Frame", frame, "Plank", grain=2))
    roof = prism(gable_roof(0.85, 2.62, 3.4, 0.2), "x", -1.45, 1.45)
    place("Courtyard/Well/Roof_Tiles", make_mesh("Well_Roof", roof, "Roof_Tile"))
    _bucket()


def _bucket():
    bucket = lathe([(0.13, 0.93, 0), (0.17, 1.22, 0), (0.15, 1.22, 0), (0.12, 0.96, 0)], 8)
    place("Courtyard/Well/Bucket", make_mesh("Well_Bucket", bucket, "Plank", grain=2), (0.55, -0.95, -0.01))
    rope = lathe([(0.018, 0.5, 0), (0.018, 1.68, 0)], 8)
    place("Courtyard/Well/Chain", make_mesh("Well_Chain", rope, "Iron"), (0.0, -0.09, 0))


def build():
    """Places everything under Courtyard/, and the hall's outside under Hall/."""
    for make in (_roofs, _ranges, _buttresses, _cornice, _gate_wall, _ground, _well):
        make()
