"""Tiling textures drawn with numpy: colours in sRGB, and heights for the normal maps.

Every tile covers TILE_M x TILE_M metres and repeats without a seam. Deterministic.
"""
import numpy as np

SIZE = 512
TILE_M = 2.0
_Y, _X = np.mgrid[0:SIZE, 0:SIZE].astype(np.float64) / SIZE


def _smooth(t):
    t = np.clip(t, 0.0, 1.0)
    return t * t * (3.0 - 2.0 * t)


def noise(seed, cells_x, cells_y=None, octaves=4):
    """Periodic value noise in [0, 1]."""
    cells_y = cells_y or cells_x
    rng, total, weight = np.random.default_rng(seed), 0.0, 0.0
    for octave in range(octaves):
        nx, ny = cells_x << octave, cells_y << octave
        grid = rng.random((ny, nx))
        fx, fy = _X * nx, _Y * ny
        ix, iy = fx.astype(int), fy.astype(int)
        tx, ty = _smooth(fx - ix), _smooth(fy - iy)
        a, b = grid[iy % ny, ix % nx], grid[iy % ny, (ix + 1) % nx]
        c, d = grid[(iy + 1) % ny, ix % nx], grid[(iy + 1) % ny, (ix + 1) % nx]
        amplitude = 0.5 ** octave
        total = total + amplitude * ((a * (1 - tx) + b * tx) * (1 - ty) + (c * (1 - tx) + d * tx) * ty)
        weight += amplitude
    return total / weight


def masonry_layout(row_edges, columns, seed):
    """Courses of blocks as (low, high, cuts): fractions of the tile, downwards and across."""
    rng, courses = np.random.default_rng(seed), []
    for row, (low, high) in enumerate(zip(row_edges, row_edges[1:])):
        count = columns[row % len(columns)]
        cuts = (np.arange(count) + rng.uniform(-0.14, 0.14, count) + 0.5 * (row % 2)) / count
        courses.append((low, high, np.sort(cuts % 1.0)))
    return courses


STONE_COURSES = masonry_layout([0.0, 0.16, 0.33, 0.48, 0.67, 0.84, 1.0], [4, 3, 4, 3, 5, 4], 11)
FLAGSTONES = masonry_layout([0.0, 0.21, 0.45, 0.70, 1.0], [3, 4, 3, 3], 31)
ROOF_ROWS = ROOF_COLUMNS = 12
BOARDS = 8


def tile_arc(across):
    """How far down its row (0..1) a roof tile's round end reaches, at -0.5 .. 0.5 across the tile."""
    return 0.72 + 0.26 * np.sqrt(np.clip(1.0 - (2.05 * across) ** 2, 0.0, 1.0))


def masonry(courses, seed, joint, wobble=0.004):
    """Draws courses: returns (block brightness 0..1, depth 0 in the joint .. 1 on the face)."""
    rng = np.random.default_rng(seed)
    x = (_X + wobble * (noise(seed + 1, 12, octaves=2) - 0.5)) % 1.0
    y = (_Y + wobble * (noise(seed + 2, 12, octaves=2) - 0.5)) % 1.0
    tone, depth = np.zeros_like(x), np.zeros_like(x)
    for low, high, cuts in courses:
        tones = rng.random(len(cuts))
        inside = (y >= low) & (y < high)
        block = np.searchsorted(cuts, x[inside], side="right") % len(cuts)
        along = (x[inside] - cuts[block - 1]) % 1.0
        width = (cuts[block] - cuts[block - 1]) % 1.0
        gap = np.minimum(np.minimum(along, width - along), np.minimum(y[inside] - low, high - y[inside]))
        tone[inside], depth[inside] = tones[block], _smooth(gap / joint)
    return tone, depth


def _mix(low, high, t):
    t = np.clip(t, 0, 1)[..., None]
    return np.array(low) * (1 - t) + np.array(high) * t


def stone():
    tone, depth = masonry(STONE_COURSES, 11, 0.009)
    grain, stain = noise(12, 32), noise(13, 4)
    colour = _mix((0.56, 0.50, 0.42), (0.78, 0.72, 0.62), 0.45 * tone + 0.35 * grain + 0.25 * stain)
    colour *= (0.72 + 0.28 * depth)[..., None]
    return colour, 0.010 * depth + 0.004 * grain


def plaster():
    grain, patches = noise(21, 24, octaves=5), noise(22, 3)
    colour = _mix((0.80, 0.76, 0.68), (0.93, 0.90, 0.84), 0.5 * grain + 0.5 * patches)
    return colour, 0.004 * grain + 0.003 * noise(23, 6, octaves=2)


def flagstone():
    tone, depth = masonry(FLAGSTONES, 31, 0.008, wobble=0.007)
    grain = noise(32, 16, octaves=5)
    colour = _mix((0.40, 0.37, 0.33), (0.64, 0.58, 0.50), 0.55 * tone + 0.45 * grain)
    colour *= (0.62 + 0.38 * depth)[..., None]
    return colour, 0.008 * depth + 0.003 * grain


def plank():
    boards = BOARDS
    row = np.floor(_Y * boards).astype(int)
    within = _Y * boards - row
    rng = np.random.default_rng(41)
    tone = rng.random(boards)[row]
    shift = rng.random(boards)[row]
    fibres = noise(42, 3, 96, octaves=3)
    rings = 0.5 + 0.5 * np.sin(2 * np.pi * (5 * within + 2.0 * noise(43, 2, 16, octaves=3) + 3 * shift))
    gap = _smooth(np.minimum(within, 1 - within) / 0.05)
    colour = _mix((0.27, 0.17, 0.09), (0.52, 0.36, 0.21), 0.35 * tone + 0.4 * fibres + 0.25 * rings)
    colour *= (0.45 + 0.55 * gap)[..., None]
    return colour, 0.006 * gap + 0.0025 * fibres


def roof_tile():
    rows, columns = ROOF_ROWS, ROOF_COLUMNS
    row = np.floor(_Y * rows).astype(int)
    down = _Y * rows - row
    shifted = _X * columns + 0.5 * (row % 2)
    column = np.floor(shifted).astype(int) % columns
    across = shifted - np.floor(shifted) - 0.5
    # The lower end of a plain tile is round: beyond that arc one sees the tile underneath.
    arc = tile_arc(across)
    gap = _smooth((0.5 - np.abs(across)) / 0.05) * _smooth(np.abs(arc - down) / 0.06)
    lower = (down > arc).astype(float)
    tone = np.random.default_rng(51).random((rows, columns))[row, column]
    grain = noise(52, 24)
    colour = _mix((0.42, 0.17, 0.10), (0.68, 0.34, 0.21), 0.65 * tone + 0.35 * grain)
    colour *= ((0.55 + 0.45 * gap) * (1.0 - 0.35 * lower))[..., None]
    return colour, 0.012 * (down * (1 - lower)) * gap + 0.003 * grain


def ground():
    pebbles, blades = noise(61, 40, octaves=3), noise(62, 64, 48, octaves=3)
    grass = _smooth((noise(63, 3, octaves=3) - 0.42) / 0.16)
    gravel = _mix((0.42, 0.38, 0.31), (0.66, 0.61, 0.52), pebbles)
    green = _mix((0.18, 0.25, 0.10), (0.38, 0.45, 0.19), blades)
    return gravel * (1 - grass[..., None]) + green * grass[..., None], 0.012 * pebbles + 0.008 * grass * blades


def marble():
    veins = np.abs(np.sin(2 * np.pi * (_X + _Y + 0.9 * noise(71, 3, octaves=5))))
    colour = _mix((0.68, 0.67, 0.65), (0.90, 0.89, 0.86), 0.45 + 0.55 * veins ** 0.35)
    return colour * (0.96 + 0.04 * noise(72, 32))[..., None], None


def iron():
    return _mix((0.10, 0.10, 0.11), (0.24, 0.23, 0.22), noise(81, 24, octaves=4)), 0.003 * noise(82, 32)


def bronze():
    patina = _smooth((noise(91, 5, octaves=4) - 0.52) / 0.2)
    metal = _mix((0.33, 0.21, 0.10), (0.58, 0.40, 0.20), noise(92, 20))
    return metal * (1 - 0.6 * patina[..., None]) + np.array((0.30, 0.44, 0.37)) * 0.6 * patina[..., None], None


def normal_map(height_m):
    """Tangent-space normals (glTF: green up) of a tile whose heights are in metres; rows run downwards."""
    texel = TILE_M / SIZE
    dx = (np.roll(height_m, -1, 1) - np.roll(height_m, 1, 1)) / (2 * texel)
    dy = (np.roll(height_m, 1, 0) - np.roll(height_m, -1, 0)) / (2 * texel)
    n = np.dstack([-dx, -dy, np.ones_like(dx)])
    return 0.5 + 0.5 * n / np.linalg.norm(n, axis=2, keepdims=True)


TEXTURES = {"Stone": stone, "Plaster": plaster, "Flagstone": flagstone, "Plank": plank, "Roof_Tile": roof_tile,
            "Ground": ground, "Marble": marble, "Iron": iron, "Bronze": bronze}
SURFACE = {"Stone": (0.9, 0.0), "Plaster": (0.95, 0.0), "Flagstone": (0.75, 0.0), "Plank": (0.7, 0.0),
           "Roof_Tile": (0.85, 0.0), "Ground": (1.0, 0.0), "Marble": (0.45, 0.0), "Iron": (0.6, 0.85),
           "Bronze": (0.5, 0.9)}
"""Roughness and metalness per material."""
