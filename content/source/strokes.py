"""Vector strokes on a torus, drawn with a constant width in texels.

The coverage of a straight stroke is exact: the integral of the stroke's strip over the texel's square.
"""
import numpy as np

WIDTH_TEXELS = 1.5


def _square_cdf(distance, cos_a, sin_a):
    """Share of a unit square on the near side of a line at `distance` from its centre, normal (cos, sin)."""
    long_side, short_side = np.maximum(cos_a, sin_a), np.minimum(cos_a, sin_a)
    flat, reach = 0.5 * (long_side - short_side), 0.5 * (long_side + short_side)
    d = np.clip(distance, -reach, reach)
    height = 1.0 / np.maximum(long_side, 1e-9)
    ramp = np.maximum(2.0 * long_side * short_side, 1e-9)
    low = (d + reach) ** 2 / ramp
    high = 1.0 - (reach - d) ** 2 / ramp
    middle = 0.5 + d * height
    return np.where(d < -flat, low, np.where(d > flat, high, middle))


def _segment_coverage(a, b, x, y):
    """Coverage of the texels with centres (x, y) by the segment a-b, which has round ends."""
    direction = b - a
    length = max(float(np.hypot(*direction)), 1e-9)
    t = np.clip(((x - a[0]) * direction[0] + (y - a[1]) * direction[1]) / length ** 2, 0.0, 1.0)
    dx, dy = x - (a[0] + t * direction[0]), y - (a[1] + t * direction[1])
    distance = np.hypot(dx, dy)
    on_line = distance < 1e-6
    cos_a = np.where(on_line, abs(direction[1]) / length, np.abs(dx) / np.maximum(distance, 1e-9))
    sin_a = np.where(on_line, abs(direction[0]) / length, np.abs(dy) / np.maximum(distance, 1e-9))
    half = WIDTH_TEXELS / 2
    return _square_cdf(distance + half, cos_a, sin_a) - _square_cdf(distance - half, cos_a, sin_a)


def draw(ink, points):
    """Adds one stroke (points in tile fractions, may leave the tile and wraps) to a square coverage image."""
    size = ink.shape[0]
    texels = np.asarray(points, float) * size
    for a, b in zip(texels, texels[1:]):
        low, high = np.floor(np.minimum(a, b)).astype(int) - 2, np.ceil(np.maximum(a, b)).astype(int) + 2
        x, y = np.meshgrid(np.arange(low[0], high[0]), np.arange(low[1], high[1]))
        np.maximum.at(ink, (y % size, x % size), _segment_coverage(a, b, x + 0.5, y + 0.5))


def _shortened(points, share):
    keep = max(2, int(round(len(points) * share)))
    return points[:keep]


def draw_level(strokes, size, tone=None):
    """Draws strokes in order of priority until the mean coverage reaches `tone`; returns coverage in [0, 1]."""
    ink = np.zeros((size, size))
    for stroke in strokes:
        before = ink.mean()
        trial = ink.copy()
        draw(trial, stroke)
        if tone is not None and trial.mean() > tone:
            share = (tone - before) / max(trial.mean() - before, 1e-12)
            if share > 0.1:
                draw(ink, _shortened(stroke, share))
            return ink
        ink = trial
    return ink
