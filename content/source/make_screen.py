#!/usr/bin/env python3
"""Writes maps/screen/dots.png: priorities of a screen of dots. Every gray is as frequent as any other, so that the share of
ink is the tone that a style asks for."""
import math
import pathlib
import struct
import zlib

SIDE = 64


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def gray_png(rows):
    raw = b"".join(b"\0" + bytes(row) for row in rows)
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b"")


def height(place):
    x, y = (2.0 * math.pi * (i + 0.5) / SIDE for i in (place % SIDE, place // SIDE))
    # Places of one height are told apart, so that the ranks are spread evenly.
    return math.cos(x) + math.cos(y) + 1e-6 * math.cos(3.0 * x + 5.0 * y)


def main():
    gray = [0] * SIDE * SIDE
    for rank, place in enumerate(sorted(range(SIDE * SIDE), key=height)):
        gray[place] = 256 * rank // (SIDE * SIDE)
    path = pathlib.Path(__file__).resolve().parent.parent / "maps" / "screen" / "dots.png"
    path.parent.mkdir(exist_ok=True)
    path.write_bytes(gray_png([gray[i : i + SIDE] for i in range(0, SIDE * SIDE, SIDE)]))


if __name__ == "__main__":
    main()
