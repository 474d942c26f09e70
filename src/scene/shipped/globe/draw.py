#!/usr/bin/env python3
"""Draws the globe: its body and a rough map of the Earth. Needs nothing but Python.

Usage: draw.py [FOLDER]     (default: where this file is)

The map is plate carree: u is the longitude, v the latitude. Faces lie between meridians and
parallels. Corners share vertices, and what two faces share has the same texture coordinates in
both. u runs once around, 0 .. 1; the texture wraps, so 1 is 0.

No map of a disk has a rim that runs once around the texture, so no texture coordinates go on
through the poles. There the faces end in an edge of no length: two corners at the pole, each with
the u of its own meridian. So neighbours agree along all of their meridian.

Between two parallels the faces are trapezoids, and the map is not linear on their planes: the rows
of the picture rule it between a face's edges, where it is always the same. So inside a face it moves
a little as the globe turns, and src/scene/README.md derives how far.
"""
import math
import struct
import sys
import zlib
from pathlib import Path

WIDTH, HEIGHT = 512, 256    # texels
SAMPLES = 4                 # rows of samples a texel; along a row, coverage is exact
MERIDIANS, PARALLELS = 24, 13
POLE_V = 1 / 512            # so far from the map's border that no filter mixes in the other pole

# Rough outlines, (longitude, latitude) in degrees, by eye.
LAND = [
    # North America
    [(-168, 66), (-162, 70), (-156, 71), (-140, 70), (-128, 70), (-115, 68), (-108, 68), (-95, 68), (-94, 72),
     (-86, 69), (-82, 68), (-87, 64), (-94, 61), (-92, 57), (-83, 55), (-80, 51), (-78, 55), (-77, 62),
     (-70, 61), (-65, 59), (-61, 56), (-56, 52), (-66, 50), (-60, 46), (-66, 44), (-70, 43), (-70, 41.5),
     (-74, 40), (-76, 35), (-81, 31), (-80, 25.5), (-82, 28), (-84, 30), (-90, 29), (-97, 27), (-97, 22),
     (-95, 18.5), (-91, 18.5), (-90, 21), (-87, 21), (-88, 16), (-83.5, 15), (-83, 10), (-79.5, 9), (-77.5, 8),
     (-80, 7), (-85, 10), (-88, 13), (-94, 16), (-102, 17.5), (-106, 21), (-112, 28), (-114.5, 31), (-110, 23.5),
     (-115, 29), (-117, 33), (-122, 37), (-124, 41), (-124, 48), (-130, 54), (-136, 58.5), (-146, 61),
     (-152, 59), (-163, 55), (-157, 59), (-165, 62)],
    # Greenland
    [(-73, 78), (-60, 82), (-35, 83.5), (-20, 81), (-20, 73), (-26, 69), (-40, 65), (-44, 60), (-50, 62),
     (-54, 68), (-56, 74)],
    # Baffin Island, Victoria Island, Ellesmere
    [(-80, 73.5), (-72, 71), (-62, 66), (-66, 62), (-73, 65), (-78, 70), (-89, 72)],
    [(-118, 73), (-105, 73), (-102, 69), (-115, 69)],
    [(-90, 77), (-88, 82), (-65, 83), (-78, 77)],
    # South America
    [(-77.5, 8), (-72, 12), (-62, 10.5), (-51, 4.5), (-50, 0), (-44, -2.5), (-35, -6), (-39, -14), (-41, -22),
     (-48, -26), (-53, -33), (-58, -34.5), (-57, -38), (-62, -39), (-65, -43), (-67, -48), (-68, -53),
     (-71, -54.5), (-75, -50), (-73, -40), (-71, -30), (-70, -18), (-76, -14), (-81, -6), (-80, -1), (-77.5, 4)],
    # Africa
    [(-6, 35.5), (10, 37), (11, 33.5), (19, 30.5), (22, 33), (31, 31), (34, 29.5), (35.5, 24), (39, 16), (43, 12),
     (51, 12), (48, 5), (40, -3), (39, -8), (41, -15), (35, -20), (35, -24), (32, -28), (27, -34), (19, -34.5),
     (15, -27), (12, -17), (13.5, -8), (9, -1), (9.5, 4), (4, 6.5), (-8, 4.5), (-13, 8), (-17, 14.5), (-16, 22),
     (-10, 30)],
    # Madagascar
    [(49, -12), (50, -16), (47, -25), (44, -23), (44, -17)],
    # Europe and Asia
    [(-9, 43.5), (-1.5, 43.5), (-1, 46), (-4.5, 48.5), (2, 51), (8, 54), (8, 57), (10.5, 57.5), (11, 54),
     (19, 54.5), (24, 59.5), (30, 60), (22, 60.5), (25, 65), (22, 65.5), (17, 61), (16, 56.5), (12.5, 56),
     (10.5, 59), (6, 58.5), (5, 62), (14, 68), (25, 71), (40, 67.5), (33, 66.5), (38, 64), (44, 66), (44, 68.5),
     (60, 69), (68, 69), (70, 73), (80, 73), (104, 77.5), (113, 74), (130, 71), (141, 73), (160, 70), (180, 69),
     (180, 65), (177, 62.5), (170, 60), (163, 59.5), (163, 56), (156.5, 51), (156, 57), (163, 62), (155, 59.5),
     (143, 59.5), (135, 55), (141, 53), (140, 48), (132, 43), (128, 39.5), (129.5, 35.5), (126.5, 34.5), (125, 39),
     (121, 39), (122, 37), (119, 35), (122, 30.5), (119, 25), (114, 22.5), (108, 21.5), (106, 18.5), (109, 13),
     (105, 9), (102.5, 12), (100, 13.5), (99.5, 9.5), (104, 1.5), (100.5, 5.5), (98, 12), (97, 17), (94, 17),
     (91, 22.5), (87, 21.5), (80, 15), (80, 11), (77.5, 8), (73, 17), (72.5, 21), (67, 25), (57, 25.5), (51, 28),
     (48, 30), (50, 26), (56, 26), (59.5, 22.5), (55, 17.5), (45, 13), (43, 14), (39, 21), (35, 28), (34.5, 31.5),
     (36, 36.5), (28, 36.5), (27, 40), (41, 41), (37, 45), (31, 46.5), (28, 42), (23.5, 40), (22.5, 37),
     (19.5, 41), (13.5, 45.5), (18, 40.5), (16, 38), (11, 42.5), (8, 44), (3, 42.5), (0, 39.5), (-2, 36.5),
     (-9, 37)],
    # The part of Asia beyond the date line
    [(-180, 69), (-170, 66), (-173, 64), (-180, 65)],
    # Great Britain, Ireland, Iceland, Novaya Zemlya, Svalbard
    [(-5, 50), (1.5, 51.5), (0, 53.5), (-2, 57), (-5, 58.5), (-5, 54.5), (-3, 53.5), (-5, 52)],
    [(-10, 52), (-6, 52.5), (-6, 55), (-9.5, 54)],
    [(-24, 65.5), (-15, 66), (-14, 64.5), (-19, 63.5)],
    [(52, 71), (57, 71), (68, 76.5), (58, 75.5)],
    [(11, 79), (27, 80), (18, 77)],
    # Japan, Sakhalin
    [(130, 31.5), (132, 34), (136, 35.5), (140, 40), (142, 45), (145, 43.5), (141, 41.5), (141, 36), (136, 34)],
    [(142, 46), (143.5, 49.5), (143, 54)],
    # Taiwan and the Philippines, Borneo, Sumatra and Java, Celebes, New Guinea, Ceylon
    [(120, 23), (121.5, 25), (121, 22)],
    [(120.5, 18), (122, 18), (126, 7), (122, 7), (122, 12)],
    [(109, 1.5), (117, 7), (118, 1), (115.5, -4), (110, -3)],
    [(95, 5.5), (104, -2), (106, -6), (114, -7.5), (114, -8.5), (105, -7), (101, -3)],
    [(119, 0), (125, 1.5), (121, -1.5), (123, -5), (120, -5)],
    [(131, -1), (138, -1.5), (147, -6), (150, -10.5), (142, -9), (138, -8)],
    [(80, 9.5), (82, 7), (80, 6)],
    # Australia, Tasmania, New Zealand
    [(114, -22), (122, -18), (129, -15), (137, -12), (136, -15), (140.5, -17.5), (142.5, -11), (146, -19),
     (153, -25), (153, -31), (150, -37.5), (146, -39), (140, -38), (138, -33.5), (131, -31.5), (124, -33.5),
     (115, -34.5), (113, -26)],
    [(145, -41), (148, -41), (147, -43.5)],
    [(173, -34.5), (178, -38), (175, -41.5), (174, -39)],
    [(173, -40.5), (171, -45), (167, -46.5), (170, -43)],
    # Cuba, Hispaniola, Newfoundland
    [(-85, 22), (-77, 21), (-75, 20), (-80, 23)],
    [(-74, 19.5), (-69, 19), (-72, 18)],
    [(-59, 48), (-56, 51.5), (-53, 47)],
    # Antarctica
    [(-180, -78), (-150, -77), (-130, -74), (-100, -73), (-75, -73), (-66, -67), (-57, -63.5), (-62, -70),
     (-62, -75), (-40, -78), (-25, -76), (-10, -71), (20, -70), (45, -67.5), (60, -67), (75, -70), (90, -66.5),
     (115, -66.5), (140, -67), (160, -70), (170, -72), (165, -78), (180, -78), (180, -91), (-180, -91)],
]
WATER = [  # within land
    [(28, 42), (31, 46.5), (34, 45), (39, 47), (38, 44.5), (41, 41.5), (35, 42)],  # Black Sea
    [(48, 46), (53, 46.5), (51, 42), (54, 40), (53.5, 37), (49.5, 38)],            # Caspian Sea
    [(-92, 47), (-85, 48.5), (-80, 45), (-83, 42), (-87, 42), (-87, 45.5)],        # Great Lakes
]


def png(path, rows):
    """Rows of (red, green, blue), 0 .. 1."""
    raw = b"".join(b"\0" + bytes(round(255 * min(max(c, 0), 1)) for p in row for c in p) for row in rows)
    chunk = lambda kind, data: (struct.pack(">I", len(data)) + kind + data
                                + struct.pack(">I", zlib.crc32(kind + data)))
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 2, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
                     + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


def covered(outlines, latitude):
    """How much of each texel of a row lies within one of the outlines, 0 .. 1."""
    row = [0.0] * WIDTH
    for outline in outlines:
        crossings = []
        for (x0, y0), (x1, y1) in zip(outline, outline[1:] + outline[:1]):
            if (y0 <= latitude) != (y1 <= latitude):
                crossings.append((x0 + (latitude - y0) / (y1 - y0) * (x1 - x0) + 180) / 360 * WIDTH)
        crossings.sort()
        for left, right in zip(crossings[::2], crossings[1::2]):
            for s in range(max(0, int(left)), min(WIDTH, math.ceil(right))):
                row[s] += max(0.0, min(right, s + 1) - max(left, s))
    return [min(1.0, part) for part in row]


def mix(a, b, t):
    return [p + (q - p) * t for p, q in zip(a, b)]


def ramp(stops, at):
    """The colour between the stops (place, colour)."""
    for (from_at, a), (to_at, b) in zip(stops, stops[1:]):
        if at < to_at:
            return mix(a, b, max(0.0, (at - from_at) / (to_at - from_at)))
    return stops[-1][1]


DEEP, COLD, ICE = (0.05, 0.17, 0.42), (0.1, 0.26, 0.45), (0.93, 0.95, 0.97)
JUNGLE, DESERT, WOODS, TUNDRA = (0.16, 0.42, 0.14), (0.78, 0.68, 0.42), (0.24, 0.44, 0.2), (0.5, 0.5, 0.4)
SEA_BY_LATITUDE = [(0, DEEP), (55, COLD), (76, COLD), (84, ICE), (91, ICE)]
LAND_BY_LATITUDE = [(0, JUNGLE), (10, JUNGLE), (22, DESERT), (30, DESERT), (42, WOODS), (58, WOODS), (66, TUNDRA),
                    (73, ICE), (91, ICE)]


def earth():
    rows = []
    for t in range(HEIGHT):
        latitudes = [90 - 180 * (t + (i + 0.5) / SAMPLES) / HEIGHT for i in range(SAMPLES)]
        mean = lambda outlines: [sum(parts) / SAMPLES for parts in zip(*(covered(outlines, y) for y in latitudes))]
        away = abs(90 - 180 * (t + 0.5) / HEIGHT)
        sea, land = ramp(SEA_BY_LATITUDE, away), ramp(LAND_BY_LATITUDE, away)
        rows.append([mix(sea, land, part * (1 - wet)) for part, wet in zip(mean(LAND), mean(WATER))])
    return rows


def write_globe(path):
    at = lambda p, m: 1 if p == 0 else 2 + (PARALLELS - 1) * MERIDIANS if p == PARALLELS else (
        2 + (p - 1) * MERIDIANS + m % MERIDIANS)
    lines = ["# Drawn by draw.py.", "mtllib globe.mtl", "v 0 1 0"]
    for p in range(1, PARALLELS):
        for m in range(MERIDIANS):
            down, around = math.pi * p / PARALLELS, 2 * math.pi * (m / MERIDIANS - 0.5)
            lines.append("v %.9f %.9f %.9f" % (math.sin(down) * math.sin(around), math.cos(down),
                                               math.sin(down) * math.cos(around)))
    lines.append("v 0 -1 0")
    for p in range(PARALLELS + 1):
        up = min(max(1 - p / PARALLELS, POLE_V), 1 - POLE_V)
        lines += ["vt %.9f %.9f" % (m / MERIDIANS, up) for m in range(MERIDIANS + 1)]
    lines.append("usemtl earth")
    for p in range(PARALLELS):
        for m in range(MERIDIANS):
            corners = [(p, m), (p + 1, m), (p + 1, m + 1), (p, m + 1)]
            lines.append("f " + " ".join("%d/%d" % (at(q, n), q * (MERIDIANS + 1) + n + 1) for q, n in corners))
    path.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    png(folder / "earth.png", earth())
    write_globe(folder / "globe.obj")
    (folder / "globe.mtl").write_text(
        "# Drawn by draw.py. illum 0: as it is.\nnewmtl earth\nKd 1 1 1\nillum 0\nmap_Kd earth.png\n")
