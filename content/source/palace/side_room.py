"""The room behind the west wall: plastered walls, a beamed ceiling, a lean-to roof."""
import plan
import windows
from hall import WEST
from mesh_kit import Solid, box, carve_mesh, make_mesh, place, prism

THICK = 0.8
WALL_Z, FOUNDATION = 4.3, -0.56


def _walls():
    (x0, x1), (y0, y1) = plan.ROOM_X, plan.ROOM_Y
    outer = prism([(y0 - THICK, FOUNDATION), (y1 + THICK, FOUNDATION), (y1 + THICK, WALL_Z), (y0 - THICK, WALL_Z)],
                  "x", x0 - THICK, x1 + 0.08)
    inner = box(x0, x1 + 0.5, y0, y1, FOUNDATION - 0.5, WALL_Z + 1.0)
    void = windows.splayed_opening(0.5, 1.25, 2.2, 0.6, wall=THICK, segments=3)
    window = Solid().merge(void, (x0, (y0 + y1) / 2, 0), WEST)
    place("SideRoom/Walls", carve_mesh("Room_Walls", outer, [inner, window], "Plaster"))


def _floor_and_ceiling():
    (x0, x1), (y0, y1) = plan.ROOM_X, plan.ROOM_Y
    place("SideRoom/Floor", make_mesh("Room_Floor", box(x0 - 0.05, x1, y0 - 0.05, y1 + 0.05, -0.3, 0.0), "Plank", grain=0))
    z = plan.ROOM_Z
    place("SideRoom/Ceiling", make_mesh("Room_Ceiling", box(x0 - 0.05, x1, y0 - 0.05, y1 + 0.05, z, z + 0.12), "Plank", grain=1))
    beam = make_mesh("Room_Beam", box(x0 - 0.1, x1 + 0.1, -0.11, 0.11, z - 0.26, z + 0.05), "Plank", grain=0)
    for i in range(5):
        place(f"SideRoom/Beam_{i + 1:02d}", beam, (0, y0 + 0.76 + i * 1.52, 0))


def _lean_to_roof():
    (x0, _), (y0, y1) = plan.ROOM_X, plan.ROOM_Y
    wall_x, eave_x = -plan.HALL_X - plan.WALL + 0.05, x0 - THICK - 0.4
    top, eave = 8.2, WALL_Z - 0.15
    outline = [(eave_x, eave), (eave_x, eave + 0.18), (wall_x, top + 0.18), (wall_x, top)]
    roof = prism(outline, "y", y0 - THICK - 0.3, y1 + THICK + 0.3)
    place("SideRoom/Roof_Tiles", make_mesh("Room_Roof", roof, "Roof_Tile"))
    gable = [(x0 - THICK + 0.02, WALL_Z - 0.02), (wall_x, WALL_Z - 0.02), (wall_x, top + 0.05), (x0 - THICK + 0.02, WALL_Z + 0.15)]
    for name, y in (("South", y0 - THICK), ("North", y1 + 0.2)):
        place(f"SideRoom/Gable_{name}", make_mesh(f"Room_Gable_{name}", prism(gable, "y", y + 0.02, y + THICK - 0.22), "Plaster"))


def build():
    """Places everything under SideRoom/."""
    _walls()
    _floor_and_ceiling()
    _lean_to_roof()
