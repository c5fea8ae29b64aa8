"""The great hall: walls, floor, columns, corbels, doors, windows, gallery and stair."""
import math

import plan
import vault
import windows
from mesh_kit import (Solid, arch_outline, box, carve_mesh, lathe, loft, make_mesh, place, pointed_arch, prism, sweep)

WEST, EAST, NORTH, SOUTH = 90.0, -90.0, 0.0, 180.0     # turns that bring local +y outwards


# ---- Walls ----------------------------------------------------------------------------------------------------------

def door_void(half=plan.DOOR_HALF, spring=plan.DOOR_SPRING, rise=plan.DOOR_RISE, base=0.0, wall=plan.WALL):
    """The void of a doorway through a wall lying in y = 0 .. wall."""
    return prism(arch_outline(half, base, spring, rise, 4), "y", -0.3, wall + 0.3)


def _moved(solid, at, turn_deg):
    return Solid().merge(solid, at, turn_deg)


def _side_wall(name, sign, turn, window_bays, door_y):
    """A long wall with its openings; openings are modelled at y = 0 facing +y and turned into place."""
    x_in, x_out = sign * plan.HALL_X, sign * (plan.HALL_X + plan.WALL)
    body = box(min(x_in, x_out), max(x_in, x_out), -plan.HALL_Y, plan.HALL_Y, plan.FOUNDATION, plan.WALL_TOP)
    voids = [_moved(windows.opening("Window"), (x_in, y, 0), turn) for y in window_bays]
    voids.append(_moved(door_void(), (x_in, door_y, 0), turn))
    return carve_mesh(name, body, voids, "Stone")


def _end_wall(name, sign, turn, kinds, door):
    y_in, y_out = sign * plan.HALL_Y, sign * (plan.HALL_Y + plan.WALL)
    reach = plan.HALL_X + plan.WALL
    body = box(-reach, reach, min(y_in, y_out), max(y_in, y_out), plan.FOUNDATION, plan.WALL_TOP)
    voids = [_moved(windows.opening(kind), (x, y_in, 0), turn) for kind, x in kinds]
    if door:
        voids.append(_moved(door_void(1.1, 1.75, 1.0), (0, y_in, 0), turn))
    return carve_mesh(name, body, voids, "Stone")


EAST_WINDOWS = plan.BAY_CENTRES
WEST_WINDOWS = plan.BAY_CENTRES[:3]
NORTH_WINDOWS = [("Great_Window", 0.0), ("Lancet", -4.5), ("Lancet", 4.5)]
SOUTH_WINDOWS = [("Window", 0.0)]


def _walls():
    place("Hall/Wall_East", _side_wall("Wall_East", 1, EAST, EAST_WINDOWS, plan.COURT_DOOR_Y))
    place("Hall/Wall_West", _side_wall("Wall_West", -1, WEST, WEST_WINDOWS, plan.SIDE_DOOR_Y))
    place("Hall/Wall_North", _end_wall("Wall_North", 1, NORTH, NORTH_WINDOWS, False))
    place("Hall/Wall_South", _end_wall("Wall_South", -1, SOUTH, SOUTH_WINDOWS, True))


def _window_tracery():
    meshes = windows.tracery_meshes()
    for i, y in enumerate(EAST_WINDOWS):
        windows.place_tracery(f"Hall/Window_East_{i + 1:02d}", meshes["Window"], (plan.HALL_X, y), EAST)
    for i, y in enumerate(WEST_WINDOWS):
        windows.place_tracery(f"Hall/Window_West_{i + 1:02d}", meshes["Window"], (-plan.HALL_X, y), WEST)
    for i, (kind, x) in enumerate(NORTH_WINDOWS):
        windows.place_tracery(f"Hall/Window_North_{i + 1:02d}", meshes[kind], (x, plan.HALL_Y), NORTH)
    windows.place_tracery("Hall/Window_South_01", meshes["Window"], (0.0, -plan.HALL_Y), SOUTH)


def _string_courses():
    """A moulded course below the windows, along the long walls and the north wall."""
    moulding = [(-0.17, -0.08), (-0.14, 0.03), (-0.05, 0.09), (-0.02, 0.14), (0.05, 0.14), (0.08, -0.08)]
    z = plan.SILL - 0.62
    ends = {"East": ((plan.HALL_X, plan.HALL_Y), (plan.HALL_X, -plan.HALL_Y)),
            "West": ((-plan.HALL_X, plan.STAIR_FOOT - 3.2), (-plan.HALL_X, plan.HALL_Y)),
            "North": ((-plan.HALL_X, plan.HALL_Y), (plan.HALL_X, plan.HALL_Y))}
    ends["East"] = ((plan.HALL_X, plan.HALL_Y), (plan.HALL_X, plan.GALLERY_FRONT + 0.05))
    for side, (a, b) in ends.items():
        path = [(*a, z), (*b, z)]
        solid = sweep(path, moulding, (0, 0, 1))
        place(f"Hall/String_Course_{side}", make_mesh(f"String_Course_{side}", solid, "Stone"))


def _plinths():
    """A chamfered footing along the inside of the long walls, between doors."""
    profile = [(0.0, -0.05), (0.0, 0.10), (0.30, 0.10), (0.36, 0.04), (0.36, -0.05)]
    gap = plan.DOOR_HALF + 0.36
    runs = [("East_1", (plan.HALL_X, plan.HALL_Y), (plan.HALL_X, plan.COURT_DOOR_Y + gap)),
            ("East_2", (plan.HALL_X, plan.COURT_DOOR_Y - gap), (plan.HALL_X, -plan.HALL_Y)),
            ("West_1", (-plan.HALL_X, plan.STAIR_FOOT), (-plan.HALL_X, plan.SIDE_DOOR_Y - gap)),
            ("West_2", (-plan.HALL_X, plan.SIDE_DOOR_Y + gap), (-plan.HALL_X, plan.HALL_Y))]
    for name, a, b in runs:
        solid = sweep([(*a, -0.02), (*b, -0.02)], profile, (0, 0, 1))
        place(f"Hall/Footing_{name}", make_mesh(f"Footing_{name}", solid, "Stone"))


def _floor():
    """One slab per bay; the two northern ones carry the dais."""
    edges = [-plan.HALL_Y] + plan.COLUMN_Y + [plan.HALL_Y]
    for i, (y0, y1) in enumerate(zip(edges, edges[1:])):
        slab = box(-plan.HALL_X, plan.HALL_X, y0, y1, -0.3, 0.0)
        place(f"Hall/Floor_{i + 1:02d}", make_mesh(f"Floor_{i + 1:02d}", slab, "Flagstone"))
    steps = box(-2.45, 2.45, 7.9, 11.6, -0.05, 0.15, 0.02)
    steps.merge(box(-2.1, 2.1, 8.25, 11.25, 0.10, 0.30, 0.02))
    place("Hall/Dais", make_mesh("Dais", steps, "Flagstone"))


# ---- Columns --------------------------------------------------------------------------------------------------------

def column_profile():
    """(radius, z, squareness): plinth, attic base, entasis, necking, cushion capital, abacus."""
    return [(0.50, -0.02, 1), (0.50, 0.20, 1), (0.46, 0.25, 1), (0.48, 0.25, 0), (0.495, 0.31, 0), (0.41, 0.40, 0),
            (0.43, 0.46, 0), (0.36, 0.52, 0),
            (0.355, 2.2, 0), (0.325, 3.78, 0), (0.37, 3.83, 0), (0.33, 3.89, 0)]


def capital_profile():
    """A cushion capital that grows from the round necking to the square abacus."""
    return [(0.33, 3.88, 0), (0.36, 4.05, 0.1), (0.43, 4.26, 0.55), (0.46, 4.44, 1),
            (0.45, 4.48, 1), (0.54, 4.57, 1), (0.54, 4.71, 1)]


def _leaves(angle, row):
    """Four broad leaves under the corners of the abacus, deepest half way up."""
    depth = {1: 0.07, 2: 0.09}.get(row, 0.0)
    return 1.0 + depth * math.cos(8 * angle)


def _columns():
    shaft = make_mesh("Column", lathe(column_profile(), 16), "Stone", smooth_deg=42)
    capital = make_mesh("Capital", lathe(capital_profile(), 16, _leaves), "Stone", smooth_deg=42)
    places = [(sign * plan.COLUMN_X, y) for y in plan.COLUMN_Y for sign in (-1, 1)]
    for i, (x, y) in enumerate(places):
        place(f"Hall/Column_{i + 1:02d}", shaft, (x, y, 0))
        place(f"Hall/Capital_{i + 1:02d}", capital, (x, y, 0))


def _corbels():
    """Where ribs end on a wall: a turned corbel under a square abacus, half inside the wall."""
    profile = [(0.05, 4.04, 0), (0.10, 4.12, 0), (0.26, 4.46, 0.3), (0.34, 4.59, 1), (0.34, 4.71, 1)]
    mesh = make_mesh("Corbel", lathe(profile, 8), "Stone", smooth_deg=50)
    walls = [(sign * plan.HALL_X, y) for y in plan.COLUMN_Y for sign in (-1, 1)]
    ends = [(sign * plan.COLUMN_X, y) for y in (-plan.HALL_Y, plan.HALL_Y) for sign in (-1, 1)]
    corners = [(sx * plan.HALL_X, sy * plan.HALL_Y) for sx in (-1, 1) for sy in (-1, 1)]
    for i, (x, y) in enumerate(walls + ends + corners):
        place(f"Hall/Corbel_{i + 1:02d}", mesh, (x, y, 0))


# ---- Doors ----------------------------------------------------------------------------------------------------------

SURROUND = [(-0.06, 0.0), (-0.06, 0.30), (0.06, 0.30), (0.10, 0.24), (0.10, 0.17), (0.05, 0.13), (0.05, 0.06), (0.02, 0.0)]


def door_surround(half, spring, rise, base):
    """A moulded frame round a doorway in the plane y = 0, standing proud towards -y."""
    arch = pointed_arch(half + 0.03, spring, rise + 0.03, 4)
    path = [(half + 0.03, 0.0, base)] + [(x, 0.0, z) for x, z in arch] + [(-half - 0.03, 0.0, base)]
    return sweep(path, SURROUND, (0, -1, 0))


def _door_surrounds():
    size = (plan.DOOR_HALF, plan.DOOR_SPRING, plan.DOOR_RISE)
    mesh = make_mesh("Door_Surround", door_surround(*size, -0.02), "Stone", smooth_deg=35)
    outer = make_mesh("Door_Surround_Outer", door_surround(*size, plan.COURT_Z - 0.02), "Stone", smooth_deg=35)
    place("Hall/Door_Surround_East", mesh, (plan.HALL_X, plan.COURT_DOOR_Y, 0), EAST)
    place("Hall/Door_Surround_West", mesh, (-plan.HALL_X, plan.SIDE_DOOR_Y, 0), WEST)
    place("SideRoom/Door_Surround", mesh, (-plan.HALL_X - plan.WALL, plan.SIDE_DOOR_Y, 0), EAST)
    place("Courtyard/Door_Surround", outer, (plan.HALL_X + plan.WALL, plan.COURT_DOOR_Y, 0), WEST)


def _main_door():
    """Two closed leaves of planks in the south portal, with iron straps."""
    leaves = Solid()
    for side in (-1, 1):
        outline = [(side * abs(x), z) for x, z in arch_outline(1.16, 0.01, 1.75, 1.06, 6) if x >= -1e-6]
        outline = [(max(0.006, abs(x)) * side, z) for x, z in outline] + [(0.006 * side, 0.01)]
        leaves.merge(prism(outline, "y", -plan.HALL_Y - 0.52, -plan.HALL_Y - 0.42))
    place("Hall/Door_Main", make_mesh("Door_Main", leaves, "Plank", grain=2))
    straps = Solid()
    for side in (-1, 1):
        for z in (0.5, 1.5):
            x0, x1 = sorted((side * 0.12, side * 1.12))
            straps.merge(box(x0, x1, -plan.HALL_Y - 0.45, -plan.HALL_Y - 0.405, z, z + 0.08))
        ring = lathe([(0.09, 0.0, 0), (0.09, 0.03, 0)], 8)
        straps.merge(Solid().add([(x + side * 0.14, -plan.HALL_Y - 0.42 + z, y + 1.15) for x, y, z in ring.points], ring.faces))
    place("Hall/Door_Main_Straps", make_mesh("Door_Main_Straps", straps, "Iron"))


# ---- Gallery --------------------------------------------------------------------------------------------------------

def _gallery_floor():
    z, front = plan.GALLERY_Z, plan.GALLERY_FRONT
    deck = box(-plan.HALL_X, plan.HALL_X, -plan.HALL_Y, front, z - 0.14, z)
    place("Gallery/Deck", make_mesh("Deck", deck, "Plank", grain=1))
    beam = box(-plan.HALL_X - 0.1, plan.HALL_X + 0.1, front - 0.36, front - 0.06, z - 0.48, z - 0.13, 0.03)
    place("Gallery/Beam", make_mesh("Beam", beam, "Plank", grain=0))
    joist = make_mesh("Joist", box(-0.08, 0.08, -plan.HALL_Y - 0.1, front - 0.2, z - 0.34, z - 0.12), "Plank", grain=1)
    for i in range(9):
        place(f"Gallery/Joist_{i + 1:02d}", joist, (-4.8 + 1.2 * i, 0, 0))


def _gallery_posts():
    top = plan.GALLERY_Z - 0.46
    post = box(-0.14, 0.14, -0.14, 0.14, 0.16, top, 0.025).merge(box(-0.2, 0.2, -0.2, 0.2, -0.02, 0.18))
    for side in (-1, 1):
        arc = [(side * (0.10 + 0.85 * (1 - math.cos(a))), 0.0, top - 0.85 + 0.85 * math.sin(a)) for a in (0.0, 0.75, 1.5)]
        post.merge(sweep(arc, [(-0.07, -0.08), (0.07, -0.08), (0.07, 0.08), (-0.07, 0.08)], (0, 1, 0)))
    mesh = make_mesh("Post", post, "Plank", grain=2)
    for i, x in enumerate((-4.2, -1.75, 1.75, 4.2)):
        place(f"Gallery/Post_{i + 1:02d}", mesh, (x, plan.GALLERY_FRONT - 0.21, 0))


def _baluster():
    """A sawn baluster of square section."""
    shape = [(0.045, -0.02), (0.045, 0.12), (0.055, 0.34), (0.024, 0.60), (0.045, 0.66), (0.045, 0.80)]
    rings = [[(-r, -r, z), (r, -r, z), (r, r, z), (-r, r, z)] for r, z in shape]
    return make_mesh("Baluster", loft(rings, metric_uv=False), "Plank", smooth_deg=30, grain=2)


def _balustrade(baluster):
    z, y = plan.GALLERY_Z, plan.GALLERY_FRONT - 0.12
    x0, x1 = plan.STAIR_X[1], plan.HALL_X
    rails = box(x0 - 0.05, x1 + 0.02, y - 0.07, y + 0.07, z + 0.84, z + 0.95, 0.03)
    rails.merge(box(x0 - 0.02, x1 + 0.02, y - 0.06, y + 0.06, z - 0.02, z + 0.08, 0.015))
    place("Gallery/Balustrade", make_mesh("Balustrade_Rails", rails, "Plank", grain=0))
    count = 22
    for i in range(count):
        x = x0 + (x1 - x0) * (i + 0.5) / count
        place(f"Gallery/Baluster_{i + 1:02d}", baluster, (x, y, z + 0.07))


def _stair(baluster):
    x0, x1 = plan.STAIR_X
    outline, y, z = [(plan.STAIR_FOOT, -0.02)], plan.STAIR_FOOT, 0.0
    for step in range(plan.STAIR_STEPS - 1):
        z += plan.RISER
        outline += [(y, z - 0.05), (y + 0.03, z - 0.035), (y + 0.03, z)]
        y -= plan.TREAD
        outline += [(y, z)]
    outline += [(y, -0.02)]
    stair = prism(outline, "x", x0 - 0.05, x1 + 0.02)
    place("Gallery/Stair", make_mesh("Stair", stair, "Stone"))
    _stair_rail(baluster, x1 - 0.10)


def _stair_rail(baluster, x):
    rise = plan.RISER / plan.TREAD
    foot, top = plan.STAIR_FOOT - 0.16, plan.GALLERY_FRONT + 0.10

    def height(y):
        return plan.RISER + (foot - y) * rise
    path = [(x, foot + 0.05, height(foot) + 0.86), (x, top - 0.22, height(top - 0.22) + 0.86)]
    rail = sweep(path, [(-0.07, 0.0), (-0.07, 0.06), (-0.04, 0.10), (0.04, 0.10), (0.07, 0.06), (0.07, 0.0)], (-1, 0, 0))
    newel = box(x - 0.09, x + 0.09, foot - 0.02, foot + 0.18, -0.04, 1.25, 0.02)
    newel.merge(lathe([(0.05, 1.24, 0), (0.10, 1.32, 0), (0.10, 1.38, 0), (0.04, 1.46, 0)], 8), (x, foot + 0.07, 0))
    newel.merge(box(x - 0.09, x + 0.09, plan.GALLERY_FRONT - 0.21, plan.GALLERY_FRONT - 0.03, plan.GALLERY_Z - 0.3,
        plan.GALLERY_Z + 1.12, 0.02))
    place("Gallery/Stair_Rail", make_mesh("Stair_Rail", rail.merge(newel), "Plank", grain=1))
    for i in range(1, plan.STAIR_STEPS - 1):
        place(f"Gallery/Stair_Baluster_{i:02d}", baluster, (x, plan.STAIR_FOOT - plan.TREAD * (i + 0.5), plan.RISER * (i + 1)))


def build():
    """Places everything under Hall/ and Gallery/."""
    for make in (_walls, _window_tracery, _string_courses, _plinths, _floor, _columns, _corbels, _door_surrounds, _main_door):
        make()
    vault.build()
    _gallery_floor()
    _gallery_posts()
    baluster = _baluster()
    _balustrade(baluster)
    _stair(baluster)
