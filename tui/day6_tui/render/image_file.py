"""Pictures as files: PNG by hand (three chunks and zlib), SVG as runs of equal pixels."""

from __future__ import annotations

import struct
import zlib
from itertools import pairwise

import numpy as np

from day6_tui.render.picture import Array


def png(rgb: Array) -> bytes:
    """A PNG of numbers 0xRRGGBB (rows x columns)."""
    rows, columns = rgb.shape
    pixels = np.zeros((rows, 1 + 3 * columns), np.uint8)  # every row begins with its filter, 0
    for offset, shift in enumerate((16, 8, 0)):
        pixels[:, 1 + offset :: 3] = rgb >> shift & 255
    header = struct.pack(">IIBBBBB", columns, rows, 8, 2, 0, 0, 0)
    body = zlib.compress(pixels.tobytes(), 6)
    return b"\x89PNG\r\n\x1a\n" + _chunk(b"IHDR", header) + _chunk(b"IDAT", body) + _chunk(b"IEND", b"")


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def svg(rgb: Array, size: int = 4) -> str:
    """An SVG of the same: one rectangle for every run of equal pixels, the commonest colour as the ground."""
    rows, columns = rgb.shape
    colours, counts = np.unique(rgb, return_counts=True)
    ground = int(colours[counts.argmax()])
    place = f'width="{columns * size}" height="{rows * size}" viewBox="0 0 {columns} {rows}"'
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" {place} shape-rendering="crispEdges">',
        f'<rect width="{columns}" height="{rows}" fill="#{ground:06x}"/>',
    ]
    for y in range(rows):
        row = rgb[y]
        edges = [0, *(np.flatnonzero(row[1:] != row[:-1]) + 1).tolist(), columns]
        for a, b in pairwise(edges):
            if int(row[a]) != ground:
                lines.append(f'<rect x="{a}" y="{y}" width="{b - a}" height="1" fill="#{int(row[a]):06x}"/>')
    return "\n".join([*lines, "</svg>", ""])
