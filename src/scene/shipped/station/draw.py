#!/usr/bin/env python3
"""Draws the station: its panels' pictures and its bodies. Needs nothing but Python.

Usage: draw.py [FOLDER]     (default: where this file is)
"""
import math
import struct
import sys
import zlib
from pathlib import Path

SIZE = 192      # texels a side
SAMPLES = 4     # a side, per texel
MERIDIANS, PARALLELS = 12, 7


def png(path, rows):
    """Rows of (red, green, blue), 0 .. 1."""
    raw = b"".join(b"\0" + bytes(round(255 * min(max(c, 0), 1)) for p in row for c in p) for row in rows)
    chunk = lambda kind, data: (struct.pack(">I", len(data)) + kind + data
                                + struct.pack(">I", zlib.crc32(kind + data)))
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 2, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
                     + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


def drawn(colour_at):
    """A picture from a function of x right and y up, both -1 .. 1, each texel a mean of samples."""
    def texel(s, t):
        points = [(2 * (s + (i + 0.5) / SAMPLES) / SIZE - 1, 1 - 2 * (t + (j + 0.5) / SAMPLES) / SIZE)
                  for i in range(SAMPLES) for j in range(SAMPLES)]
        colours = [colour_at(x, y) for x, y in points]
        return [sum(c[k] for c in colours) / len(colours) for k in range(3)]
    return [[texel(s, t) for s in range(SIZE)] for t in range(SIZE)]


def ellipse(x, y, cx, cy, rx, ry):
    return ((x - cx) / rx) ** 2 + ((y - cy) / ry) ** 2 < 1


def mix(a, b, t):
    return [p + (q - p) * t for p, q in zip(a, b)]


STEEL, DARK_STEEL = (0.72, 0.75, 0.8), (0.45, 0.48, 0.54)
FUR, DARK_FUR, MUZZLE, BLACK, WHITE = (0.62, 0.4, 0.2), (0.45, 0.27, 0.13), (0.86, 0.7, 0.5), (0.08, 0.06, 0.06), (1, 1, 1)


def rivets(x, y):
    return any(ellipse(x, y, cx, cy, 0.04, 0.04) for cx in (-0.88, 0.88) for cy in (-0.88, 0.88))


def bear(x, y):
    """A bear, as far as it is there."""
    if ellipse(x, y, -0.2, 0.14, 0.055, 0.075) or ellipse(x, y, 0.2, 0.14, 0.055, 0.075):
        return WHITE if ellipse(x, y, -0.18, 0.17, 0.02, 0.02) or ellipse(x, y, 0.22, 0.17, 0.02, 0.02) else BLACK
    if ellipse(x, y, 0, -0.06, 0.09, 0.065):
        return BLACK
    smile = abs(math.hypot(x, y + 0.1) - 0.14) < 0.014 and y < -0.14
    if smile or (abs(x) < 0.012 and -0.22 < y < -0.1):
        return BLACK
    if ellipse(x, y, 0, -0.13, 0.23, 0.17):
        return MUZZLE
    if ellipse(x, y, 0, 0.06, 0.44, 0.4):
        return FUR
    for side in (-1, 1):
        if ellipse(x, y, side * 0.34, 0.4, 0.1, 0.1):
            return MUZZLE
        if ellipse(x, y, side * 0.34, 0.4, 0.17, 0.17):
            return DARK_FUR
    for k, toe in enumerate((-0.11, 0, 0.11)):
        if ellipse(x, y, 0.52 + toe, -0.2 + (0.04 if k == 1 else 0), 0.04, 0.05):
            return DARK_FUR
    if ellipse(x, y, 0.52, -0.34, 0.16, 0.18):
        return FUR
    if ellipse(x, y, 0, -0.72, 0.52, 0.46):
        return DARK_FUR
    return None


def window(x, y):
    r = math.hypot(x, y)
    if r > 0.82:
        bolt = any(math.hypot(x - 0.89 * math.cos(a), y - 0.89 * math.sin(a)) < 0.035
                   for a in (math.pi / 6 * k for k in range(12)))
        return DARK_STEEL if bolt or r > 0.97 else STEEL
    if r > 0.76:
        return DARK_STEEL
    inside = bear(x, y) or mix((1.0, 0.86, 0.5), (0.75, 0.45, 0.2), min(1, r))
    glint = abs(x + y - 0.75) < 0.05 or abs(x + y - 0.9) < 0.02
    return mix(inside, WHITE, 0.3) if glint else inside


def solar(x, y):
    if max(abs(x), abs(y)) > 0.93:
        return STEEL
    cell_x, cell_y = (x + 0.93) / 1.86 * 6 % 1, (y + 0.93) / 1.86 * 6 % 1
    if min(cell_x, cell_y) < 0.07:
        return (0.75, 0.8, 0.85)
    if min(abs(cell_x - 0.37), abs(cell_x - 0.7)) < 0.02:
        return (0.35, 0.45, 0.7)
    return mix((0.06, 0.1, 0.35), (0.15, 0.25, 0.6), (cell_x + cell_y) / 2)


def hatch(x, y):
    r = math.hypot(x, y)
    if rivets(x, y):
        return DARK_STEEL
    if max(abs(x), abs(y)) > 0.8 and r > 0.8:
        return (0.95, 0.75, 0.1) if (x - y) * 4 % 2 < 1 else BLACK
    if r > 0.74:
        return STEEL
    if r > 0.68:
        return DARK_STEEL
    wheel = abs(r - 0.36) < 0.05 or (r < 0.36 and any(
        abs(x * math.sin(a) - y * math.cos(a)) < 0.035 for a in (0, math.pi / 3, 2 * math.pi / 3)))
    if wheel or r < 0.09:
        return (0.75, 0.15, 0.12)
    return mix(STEEL, DARK_STEEL, 0.3 + 0.3 * y)


def ball_vertices():
    vertices = [(0, 1, 0)]
    for p in range(1, PARALLELS):
        for m in range(MERIDIANS):
            down, around = math.pi * p / PARALLELS, 2 * math.pi * (m - 0.5) / MERIDIANS
            vertices.append((math.sin(down) * math.sin(around), math.cos(down),
                             math.sin(down) * math.cos(around)))
    return vertices + [(0, -1, 0)]


def ball_faces():
    """(corners, material), corners anticlockwise from outside."""
    last = 1 + (PARALLELS - 1) * MERIDIANS
    at = lambda p, m: 0 if p == 0 else last if p == PARALLELS else 1 + (p - 1) * MERIDIANS + m % MERIDIANS
    middle = PARALLELS // 2
    textured = {(middle, 0): "window", (middle, 2): "solar", (middle, 4): "hatch",
                (middle, 6): "window", (middle, 8): "solar", (middle, 10): "hatch"}
    for p in range(PARALLELS):
        for m in range(MERIDIANS):
            corners = [at(p, m), at(p + 1, m), at(p + 1, m + 1), at(p, m + 1)]
            corners = list(dict.fromkeys(corners))
            plain = "cap" if p in (0, PARALLELS - 1) else "blue" if (p + m) % 2 else "grey"
            if p in (middle - 2, middle + 2) and m % 4 == 3:
                plain = "lamp"
            yield corners, textured.get((p, m), plain)


def on_plane(points):
    """Texture coordinates 0 .. 1: the face's own plane, its middle lower side along u."""
    sub = lambda a, b: [x - y for x, y in zip(a, b)]
    dot = lambda a, b: sum(x * y for x, y in zip(a, b))
    along = sub(points[2], points[1])
    along = [c / math.sqrt(dot(along, along)) for c in along]
    up = sub(points[0], points[1])
    up = sub(up, [c * dot(up, along) for c in along])
    up = [c / math.sqrt(dot(up, up)) for c in up]
    flat = [(dot(sub(p, points[0]), along), dot(sub(p, points[0]), up)) for p in points]
    least = [min(f[k] for f in flat) for k in (0, 1)]
    most = [max(f[k] for f in flat) for k in (0, 1)]
    return [[(f[k] - least[k]) / (most[k] - least[k]) for k in (0, 1)] for f in flat]


def write_ball(path):
    vertices = ball_vertices()
    lines = ["# Drawn by draw.py.", "mtllib station.mtl"]
    lines += ["v %.9f %.9f %.9f" % v for v in vertices]
    count, used = 0, ""
    for corners, material in ball_faces():
        if material != used:
            lines.append("usemtl " + material)
            used = material
        if material in ("window", "solar", "hatch"):
            lines += ["vt %.9f %.9f" % tuple(uv) for uv in on_plane([vertices[c] for c in corners])]
            lines.append("f " + " ".join("%d/%d" % (c + 1, count + i + 1) for i, c in enumerate(corners)))
            count += len(corners)
        else:
            lines.append("f " + " ".join(str(c + 1) for c in corners))
    path.write_text("\n".join(lines) + "\n")


def write_ring(path, inner=0.9, outer=1.42, parts=36):
    """A flat ring that the ball cuts through."""
    lines = ["# Drawn by draw.py.", "mtllib station.mtl"]
    for k in range(parts):
        a = 2 * math.pi * k / parts
        lines += ["v %.9f 0 %.9f" % (r * math.sin(a), r * math.cos(a)) for r in (inner, outer)]
    for k in range(parts):
        a, b = 2 * k + 1, 2 * ((k + 1) % parts) + 1
        lines.append("usemtl " + ("ring" if k % 3 else "ring_dark"))
        lines.append("f %d %d %d %d" % (a, a + 1, b + 1, b))
    path.write_text("\n".join(lines) + "\n")


MATERIALS = {"cap": (0.85, 0.86, 0.88), "blue": (0.42, 0.5, 0.66), "grey": (0.74, 0.76, 0.8),
             "ring": (0.8, 0.68, 0.36), "ring_dark": (0.62, 0.3, 0.22)}


def write_materials(path):
    lines = ["# Drawn by draw.py. illum 0: as it is; 1: in the light."]
    for name, colour in MATERIALS.items():
        lines += ["newmtl " + name, "Kd %.2f %.2f %.2f" % colour, "illum 1"]
    lines += ["newmtl lamp", "Kd 1 0.35 0.2", "illum 0"]
    for name in ("window", "solar", "hatch"):
        lines += ["newmtl " + name, "Kd 1 1 1", "illum 1", "map_Kd -clamp on %s.png" % name]
    path.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    for picture in (window, solar, hatch):
        png(folder / (picture.__name__ + ".png"), drawn(picture))
    write_ball(folder / "ball.obj")
    write_ring(folder / "ring.obj")
    write_materials(folder / "station.mtl")
