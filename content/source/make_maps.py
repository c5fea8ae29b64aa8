"""Draws every hatch map and ink map: python3 content/source/make_maps.py [FOLDER]. Deterministic.

Ink maps: every level is drawn anew from vector strokes of constant width in texels. Strokes leave in order of priority,
so that the tone stays; each level keeps a subset of the strokes of the level above.
Hatch maps (N x 1): equal lines at every level; line centres lie on multiples of the spacing, measured from the image's
edge, so a line at x in one level is a line at 2x in the level above.
"""
import json
import os
import sys

import numpy as np

sys.dont_write_bytecode = True

import strokes  # noqa: E402
import textures  # noqa: E402
from png_file import write_gray  # noqa: E402

INK_SIZE = 1024
GRAY_BELOW = 16                      # texels; smaller ink levels hold the tone alone


def _write_map(folder, levels, **facts):
    os.makedirs(folder, exist_ok=True)
    for number, values in enumerate(levels):
        write_gray(os.path.join(folder, f"level_{number}.png"), values)
    with open(os.path.join(folder, "map.json"), "w", encoding="ascii") as file:
        json.dump({"format": "hatchway-map/1", "levels": len(levels), **facts}, file, indent=2)
        file.write("\n")


# ---- Hatch maps -----------------------------------------------------------------------------------------------------

def hatch_level(width, spacing, line):
    """One row of lines `line` texels wide, centred on multiples of `spacing`; edges soft by exact coverage."""
    if width < spacing:
        return np.full((1, width), 1.0 - line / spacing)
    edges = np.arange(width + 1, dtype=float)
    phase = (edges + spacing / 2) % spacing - spacing / 2
    ink_up_to = np.clip(phase, -line / 2, line / 2) + line / 2 + line * np.floor((edges + spacing / 2) / spacing)
    return 1.0 - np.diff(ink_up_to)[None, :]


def _hatch_maps(folder):
    for name, spacing, line, size_m in (("diagonal", 8, 1.5, 4.0), ("fine", 8, 1.0, 2.0), ("coarse", 16, 2.0, 4.0)):
        levels = [hatch_level(2048 >> k, spacing, line) for k in range(12)]
        _write_map(os.path.join(folder, name), levels, kind="hatch", size_m=size_m, spacing_texels=spacing)


# ---- Ink maps -------------------------------------------------------------------------------------------------------

class Hand:
    """Draws like a hand: lines waver, stop early, run over. One seed, one drawing."""

    def __init__(self, seed):
        self.random = np.random.default_rng(seed)

    def line(self, a, b, waver=0.0016, step=0.012):
        """A wavering line between two points, its ends left alone."""
        a, b = np.asarray(a, float), np.asarray(b, float)
        length = max(float(np.hypot(*(b - a))), 1e-9)
        count = max(2, int(length / step) + 1)
        t = np.linspace(0.0, 1.0, count + 1)
        phase = self.random.uniform(0, 2 * np.pi, 2)
        sway = waver * np.sin(np.pi * t) * (np.sin(2 * np.pi * t * max(1,
            round(length * 7)) + phase[0]) + 0.5 * np.sin(2 * np.pi * t * max(2, round(length * 17)) + phase[1]))
        normal = np.array([a[1] - b[1], b[0] - a[0]]) / length
        return a + t[:, None] * (b - a) + sway[:, None] * normal

    def broken(self, a, b, gaps):
        """The same, interrupted where the pen was lifted."""
        whole = self.line(a, b)
        cuts = np.sort(self.random.uniform(0.05, 0.95, gaps))
        parts, start = [], 0
        for cut in cuts:
            end = int(cut * len(whole))
            if end - start > 3:
                parts.append(whole[start:end])
                start = end + 1
        return parts + [whole[start:]] if len(whole) - start > 1 else parts


def _spread_order(count):
    """Indices so that any prefix is spread evenly over the cycle."""
    return sorted(range(count), key=lambda i: int(format(i, "08b")[::-1], 2))


def _shuffled(hand, items):
    return [items[i] for i in hand.random.permutation(len(items))]


def _masonry_strokes(hand, courses, mark):
    """Bed joints first, then upright joints, then the marks on the blocks."""
    beds, uprights, marks = [], [], []
    for i in _spread_order(len(courses)):
        if i < len(courses):
            beds += hand.broken((0.0, courses[i][0]), (1.0, courses[i][0]), 1)
    for low, high, cuts in courses:
        for left, right in zip(cuts, np.roll(cuts, -1)):
            right = right if right > left else right + 1.0
            uprights.append(hand.line((left + hand.random.uniform(-1, 1) * 0.003, low), (left, high)))
            marks += mark(hand, left, right, low, high)
    return beds + _shuffled(hand, uprights) + _shuffled(hand, marks)


def _chisel_marks(hand, left, right, low, high):
    """Short parallel strokes in the lower right corner of some blocks, and a few chips."""
    found = []
    if hand.random.random() < 0.9:
        reach = hand.random.uniform(0.25, 0.5) * (right - left)
        for k in range(int(hand.random.integers(6, 10))):
            length = (high - low) * hand.random.uniform(0.22, 0.45) * (1 - k / 10)
            x = right - 0.012 - 0.35 * length - reach * k / 8
            found.append(hand.line((x, high - 0.012), (x + 0.35 * length, high - 0.012 - length), 0.0006))
    for _ in range(int(hand.random.integers(4, 8))):
        x, y = hand.random.uniform(left + 0.02, right - 0.02), hand.random.uniform(low + 0.02, high - 0.02)
        found.append(hand.line((x, y), (x + hand.random.uniform(0.006, 0.018), y + hand.random.uniform(-0.004, 0.004)), 0.0))
    return found


def _worn_marks(hand, left, right, low, high):
    """Cracks and pits of a trodden floor, and the shade at two sides of a slab."""
    found = []
    if hand.random.random() < 0.55:
        x, y = hand.random.uniform(left, right), hand.random.uniform(low, high)
        end = (x + hand.random.uniform(-0.08, 0.08), y + hand.random.uniform(-0.08, 0.08))
        found.append(hand.line((x, y), end, 0.004))
    for k in range(int(hand.random.integers(7, 14))):
        y = high - 0.010 - 0.012 * k
        found.append(hand.line((right - 0.010 - 0.02 * hand.random.random(), y),
            (right - 0.03 - 0.06 * hand.random.random(), y), 0.0006))
    for _ in range(int(hand.random.integers(5, 9))):
        x, y = hand.random.uniform(left, right), hand.random.uniform(low, high)
        found.append(hand.line((x, y), (x + hand.random.uniform(0.004, 0.010), y + 0.002), 0.0))
    return found


def stone_strokes():
    return _masonry_strokes(Hand(101), textures.STONE_COURSES, _chisel_marks)


def flagstone_strokes():
    return _masonry_strokes(Hand(103), textures.FLAGSTONES, _worn_marks)


def _roof_tile_strokes_of(hand, row, column):
    """The round lower end of a tile, its right side, a shading tick."""
    rows, columns = textures.ROOF_ROWS, textures.ROOF_COLUMNS
    shift = -0.5 * (row % 2)
    across = np.linspace(-0.49, 0.49, 13)
    lean = hand.random.uniform(-0.03, 0.03)
    end = np.column_stack([(column + shift + 0.5 + across) / columns, (row + textures.tile_arc(across) + lean * across) / rows])
    x = (column + shift + 1.0 + hand.random.uniform(-0.02, 0.02)) / columns
    side = hand.line((x, (row + 0.02) / rows), (x, (row + 0.70) / rows), 0.0008)
    tick_x = x - hand.random.uniform(0.10, 0.25) / columns
    tick = hand.line((tick_x, (row + 0.45) / rows), (tick_x, (row + hand.random.uniform(0.75, 0.88)) / rows), 0.0004)
    return end, side, tick


def roof_strokes():
    """Round ends first, every second row before the others; then sides; then ticks."""
    hand, ends, sides, ticks = Hand(105), [], [], []
    for row in [r for r in _spread_order(16) if r < textures.ROOF_ROWS]:
        tiles = [_roof_tile_strokes_of(hand, row, column) for column in range(textures.ROOF_COLUMNS)]
        ends += _shuffled(hand, [t[0] for t in tiles])
        sides += [t[1] for t in tiles]
        ticks += [t[2] for t in tiles if hand.random.random() < 0.9]
    return ends + _shuffled(hand, sides) + _shuffled(hand, ticks)


def plank_strokes():
    """Joints between boards, butt ends, then the grain."""
    hand, joints, butts, grain = Hand(107), [], [], []
    for board in _spread_order(textures.BOARDS):
        low, high = board / textures.BOARDS, (board + 1) / textures.BOARDS
        joints += hand.broken((0.0, low), (1.0, low), 1)
        x = hand.random.random()
        butts.append(hand.line((x, low), (x + 0.002, high)))
        for _ in range(9):
            start, y = hand.random.random(), hand.random.uniform(low + 0.014, high - 0.014)
            grain.append(hand.line((start, y), (start + hand.random.uniform(0.10, 0.42), y + hand.random.uniform(-0.006,
                0.006)), 0.0022))
        grain += _knot(hand, hand.random.random(), (low + high) / 2) if board % 3 == 0 else []
    return joints + butts + _shuffled(hand, grain)


def _knot(hand, x, y):
    turns = []
    for radius in (0.008, 0.018):
        a = np.linspace(0.3, 2 * np.pi + 0.1, 15)
        turns.append(np.column_stack([x + 1.9 * radius * np.cos(a), y + radius * np.sin(a) + hand.random.uniform(-0.001, 0.001)]))
    return turns


def ink_levels(drawing):
    """All levels of an ink map, white = 1. The two finest hold the whole drawing, the first for eyes that come close; the
    tone of all others is that of the second."""
    levels = [1.0 - strokes.draw_level(drawing, size) for size in (INK_SIZE, INK_SIZE // 2)]
    tone, size = 1.0 - levels[1].mean(), INK_SIZE // 4
    while size >= 1:
        ink = strokes.draw_level(drawing, size, tone) if size >= GRAY_BELOW else np.full((size, size), tone)
        levels.append(1.0 - ink)
        size //= 2
    return levels


def _ink_maps(folder):
    for name, draw in (("stone_courses", stone_strokes), ("roof_tiles", roof_strokes), ("planks", plank_strokes),
        ("flagstones", flagstone_strokes)):
        levels = ink_levels(draw())
        _write_map(os.path.join(folder, name), levels, kind="ink", size_m=textures.TILE_M)
        print(name, "tone per level:", " ".join(f"{1.0 - level.mean():.3f}" for level in levels))


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.join(here, "..", "maps")
    _hatch_maps(os.path.join(folder, "hatch"))
    _ink_maps(os.path.join(folder, "ink"))


if __name__ == "__main__":
    main()
