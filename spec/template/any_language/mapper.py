#!/usr/bin/env python3
"""The exact profile, nearest filter, from the specification's sections 2 to 5: exact and slow.

Reads a call a line from standard input, as bridge.c says, and answers each by a line.
"""
import json
import sys
from fractions import Fraction
from math import ceil, floor

OK = 0
WRAP = 1
BYTES = {0: 1, 1: 2, 2: 4}  # a pixel of INDEX8, RGB565, RGBA8888


def crossings(vertices, y):
    """Where the outline crosses the height y, from left to right: x, u q, v q and q."""
    found = []
    for a, b in zip(vertices, vertices[1:] + vertices[:1]):
        top, bottom = (a, b) if a[1] < b[1] else (b, a)
        if not top[1] <= y < bottom[1]:
            continue
        t = Fraction(y - top[1], bottom[1] - top[1])
        ends = [(x, u * q, v * q, q) for x, _, u, v, q in (top, bottom)]
        found.append([p + t * (q - p) for p, q in zip(*ends)])
    return sorted(found)


def addressed(texel, size, address):
    return texel % size if address == WRAP else min(max(texel, 0), size - 1)


def draw(target, clip, vertices, texture, options):
    """Draws into target["pixels"], a bytearray."""
    width, height = target["width"], target["height"]
    left, top, right, bottom = clip or (0, 0, width, height)
    size = BYTES[target["format"]]
    for j in range(max(top, 0), min(bottom, height)):
        ends = crossings(vertices, 256 * j + 128)
        if not ends:
            continue
        l, r = ends
        first, end = ceil((l[0] - 128) / 256), ceil((r[0] - 128) / 256)
        for i in range(max(first, left, 0), min(end, right, width)):
            t = (256 * i + 128 - l[0]) / (r[0] - l[0])
            u, v, q = (p + t * (e - p) for p, e in zip(l[1:], r[1:]))
            s = addressed(floor(u / q / 65536), texture["width"], options["address"])
            t = addressed(floor(v / q / 65536), texture["height"], options["address"])
            at, to = (t * texture["width"] + s) * size, (j * width + i) * size
            target["pixels"][to : to + size] = texture["pixels"][at : at + size]


def main():
    for line in sys.stdin:
        call = json.loads(line)
        for picture in (call["target"], call["texture"]):
            picture["pixels"] = bytearray.fromhex(picture["pixels"])
        draw(call["target"], call["clip"], call["vertices"], call["texture"], call["options"])
        print(OK, call["target"]["pixels"].hex(), flush=True)


if __name__ == "__main__":
    main()
