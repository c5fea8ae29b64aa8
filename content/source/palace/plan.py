"""The measures of the palace in metres (Blender axes: x east, y north, z up; the hall lies along y)."""

HALL_X, HALL_Y = 6.0, 12.0          # half width and half length of the hall, inside
WALL = 1.0                          # thickness of the hall's walls
WALL_TOP, FOUNDATION = 9.9, -0.5
BAY = 4.8
BAY_CENTRES = [-9.6, -4.8, 0.0, 4.8, 9.6]
COLUMN_Y = [-7.2, -2.4, 2.4, 7.2]
COLUMN_X = 3.0                      # the two rows stand at x = -3 and x = +3
SPRING = 4.7                        # top of the capitals, where the vault springs
SILL, WINDOW_SPRING, WINDOW_RISE, WINDOW_HALF = 3.9, 5.75, 1.45, 0.7
GALLERY_Z, GALLERY_FRONT = 3.24, -8.0
RISER, TREAD, STAIR_STEPS = 0.18, 0.29, 18
STAIR_X = (-6.0, -4.6)
STAIR_FOOT = GALLERY_FRONT + (STAIR_STEPS - 1) * TREAD
ROOM_X, ROOM_Y, ROOM_Z = (-12.0, -7.0), (1.0, 8.6), 3.5    # side room, inside
DOOR_HALF, DOOR_SPRING, DOOR_RISE = 0.75, 1.95, 0.95
SIDE_DOOR_Y, COURT_DOOR_Y = 4.8, 0.0
COURT_X, COURT_Y, COURT_Z = (7.0, 23.0), (-12.0, 12.0), -0.15
