#!/usr/bin/env python3
"""Writes a gnomon scene of a packed bed: grains dropped into a box one by one, which roll down to where they rest.

Visscher and Bolsterli, "Random packing of equal and unequal spheres", Nature 239 (1972). A grain falls onto the bed,
rolls down over the first one it meets, then along two, and rests when the floor or three carry it; walls count as
grains. What lies already never moves. About 58 % of the space is full. The floor is z = 0, the unit the median radius.
"""
import argparse
import os
import random
import sys
from array import array
from itertools import product
from math import dist, exp, inf, pi, sinh, sqrt

import npy_writer

DENSITY = 0.58  # the share of the space that grains fill, about
FLOOR = -1
WALLS = {-2: (1.0, 0.0, 0.0), -3: (-1.0, 0.0, 0.0), -4: (0.0, 1.0, 0.0), -5: (0.0, -1.0, 0.0)}  # normals, inward
COLORS = ((0.13, 0.30, 0.40), (0.36, 0.53, 0.52), (0.88, 0.79, 0.58), (0.84, 0.50, 0.25), (0.50, 0.17, 0.11))


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def along(a, t, b):
    return (a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2])


def turned(cosine, sine):
    """An angle in (0, 2 pi), to compare: grows with it from 0 to 4. No angle is computed; square roots do."""
    return (1 - cosine if sine >= 0 else 3 + cosine, cosine, sine)


def crossing(a, b, c):
    """Where a cos + b sin, on its way round from 0, falls to c; None if it never does."""
    square = a * a + b * b
    if square <= c * c:
        return None
    root = sqrt(square - c * c)
    return turned((a * c - b * root) / square, (b * c + a * root) / square)


def again(a, b):
    """Where a cos + b sin, which rises now, falls to what it is now: at twice the angle of (a, b)."""
    if b <= 0:  # by rounding
        return None if a <= 0 else turned(1, 0)
    return turned((a * a - b * b) / (a * a + b * b), 2 * a * b / (a * a + b * b))


def tolerance(half_width, height):
    """How far grains may overlap or be apart and count as touching: twice as far as rounding moves the later one.

    The earlier is where it is exactly. A coordinate moves by at most 2^-24 of itself when it becomes a 32-bit float;
    double precision before that loses less by far.
    """
    return 2 * sqrt(3) * 2**-24 * max(half_width, height)


class Bed:
    """Grains are (x, y, z, radius). An obstacle is a grain's index, a wall or the floor."""

    def __init__(self, half_width, largest):
        self.half_width, self.largest, self.cell = half_width, largest, 2 * largest
        self.grains, self.layers = [], 0
        self.near = []  # for each grain, those that a grain of the largest size can touch when it touches this one
        self.cells = {}  # of the edge self.cell: the indices of the grains whose centre lies there
        self.stride = int(2 * half_width / self.cell) + 6  # with room for two cells beside each wall

    def around(self, p, layers, reach):
        """The grains in these layers, up to so many cells away from p in x and y."""
        ix, iy = (int((v + self.half_width) / self.cell) + 2 for v in p[:2])
        for iz in layers:
            for row in range(iy - reach, iy + reach + 1):
                first = (iz * self.stride + row) * self.stride + ix - reach
                for cell in range(first, first + 2 * reach + 1):
                    yield from self.cells.get(cell, ())

    def add(self, grain):
        """True if it fits where it came to rest."""
        x, y, z, radius = grain
        layer, near = int(z / self.cell), []
        allowed = tolerance(self.half_width, z)
        if max(abs(x), abs(y)) + radius > self.half_width + allowed:
            return False
        for k in self.around(grain, range(max(layer - 2, 0), layer + 3), 2):
            qx, qy, qz, other = self.grains[k]
            square, both = (x - qx) ** 2 + (y - qy) ** 2 + (z - qz) ** 2, radius + other
            if square < (both - allowed) ** 2:
                return False
            if square < (both + self.cell) ** 2:
                near.append(k)
        for k in near:
            self.near[k].append(len(self.grains))
        ix, iy = (int((v + self.half_width) / self.cell) + 2 for v in (x, y))
        self.cells.setdefault((layer * self.stride + iy) * self.stride + ix, []).append(len(self.grains))
        self.layers = max(self.layers, layer + 1)
        self.grains.append(grain)
        self.near.append(near)
        return True

    def fall(self, p, radius, passed):
        """What a grain falling from p hits, and the height where it does."""
        best, hit = radius, FLOOR
        for layer in range(self.layers if p[2] == inf else int(p[2] / self.cell), -1, -1):
            for k in self.around(p, (layer,), 1):
                qx, qy, qz, other = self.grains[k]
                square = (radius + other) ** 2 - (p[0] - qx) ** 2 - (p[1] - qy) ** 2
                if square > 0 and k not in passed and best < qz + sqrt(square) <= p[2]:
                    best, hit = qz + sqrt(square), k
            if best > layer * self.cell + radius + self.largest:  # higher than any touches whose centre is below
                break
        return hit, best

    def normal(self, k, p):
        n = WALLS.get(k) or along(p, -1, self.grains[k])
        size = sqrt(dot(n, n))
        return (n[0] / size, n[1] / size, n[2] / size)

    def carriers(self, p, contacts):
        """Which of the contacts a grain at p presses on as it moves, and where it moves; (None, None) if it rests.

        The steepest way that enters no contact: gravity, projected onto those that resist it. None resists: it falls.
        """
        normals = [(k, self.normal(k, p)) for k in contacts]
        if all(n[2] <= 0 for _, n in normals):
            return (), None
        for i, n in normals:
            v = (n[2] * n[0], n[2] * n[1], n[2] * n[2] - 1)
            if n[2] > 0 and all(dot(m, v) >= 0 for k, m in normals if k != i):
                return (i,), v
        for i, n in normals:
            for j, m in normals:
                v = (n[1] * m[2] - n[2] * m[1], n[2] * m[0] - n[0] * m[2], n[0] * m[1] - n[1] * m[0])
                cosine = dot(n, m)
                if v[2] < 0 and n[2] > cosine * m[2] and m[2] > cosine * n[2]:  # down, and both are pressed on
                    if all(dot(o, v) >= 0 for k, o in normals if k not in (i, j)):
                        return (i, j), v
        return None, None

    def roll(self, p, radius, active, v, touched):
        """Rolls from p towards v, round the circle that touches the active obstacles, to whatever ends that first.

        Returns the place, the contacts to go on with, and an obstacle that is touched there too but lets go, or None.
        """
        ball = max(active)  # of two obstacles one at least is a grain
        center = q = self.grains[ball]
        if len(active) == 2:
            axis = WALLS.get(min(active)) or along(self.grains[min(active)], -1, q)
            center = along(q, dot(along(p, -1, q), axis) / dot(axis, axis), axis)
        u = along(p, -1, center)  # the circle: center + u cos + w sin
        square = dot(u, u)
        w = along((0, 0, 0), sqrt(square / dot(v, v)), v)
        (cx, cy, cz), (ux, uy, uz), (wx, wy, wz) = center[:3], u, w
        ends = [(crossing(uz, wz, radius - cz), (FLOOR,), None)]
        for k in self.near[ball]:
            x, y, z, reach = self.grains[k]
            x, y, z, reach = cx - x, cy - y, cz - z, radius + reach
            # The distance's square is 2 (a cos + b sin - c) more than when they touch.
            a, b = x * ux + y * uy + z * uz, x * wx + y * wy + z * wz
            c = (reach * reach - square - x * x - y * y - z * z) / 2
            if a * a + b * b > c * c and k not in active:
                ends.append((again(a, b) if k in touched else crossing(a, b, c), (*active, k), None))
        for k, m in WALLS.items():
            if k not in active:
                a, b, c = dot(m, u), dot(m, w), radius - self.half_width - dot(m, center)
                ends.append((again(a, b) if k in touched else crossing(a, b, c), (*active, k), None))
        # i lets go when no longer n_i.z > (n_i n_j) n_j.z; alone, n_i.z > 0. A grain's n.z is (z - its z) / distance.
        forms = []
        for k in active:
            distance = inf if k in WALLS else radius + self.grains[k][3]
            forms.append((k, 1 / distance, 0 if k in WALLS else self.grains[k][2] / distance))
        cosine = dot(self.normal(active[0], p), self.normal(active[1], p)) if len(active) == 2 else 0
        for (k, slope, offset), (j, slope_j, offset_j) in zip(forms, forms[::-1]):
            slope, offset = slope - cosine * slope_j, offset - cosine * offset_j
            ends.append((crossing(slope * uz, slope * wz, offset - slope * cz), tuple(i for i in active if i != k), k))
        (_, cosine, sine), contacts, lost = min(e for e in ends if e[0])
        return along(along(center, cosine, u), sine, w), contacts, lost

    def drop(self, x, y, radius):
        """Where a grain comes to rest that falls from high above (x, y)."""
        p, contacts, lost = (x, y, inf), (), None
        for _ in range(200):
            active, v = self.carriers(p, contacts)
            if active is None:
                return p
            if active:
                p, contacts, lost = self.roll(p, radius, active, v, (*contacts, lost))
            else:
                hit, z = self.fall(p, radius, (*contacts, lost))
                p, contacts, lost = (*p[:2], z), (*(k for k in contacts if k in WALLS), hit), None
            if FLOOR in contacts:
                return p
        return None


def check(grains, half_width):
    """What is wrong, or None: a grain overlaps another, leaves the box, or lies neither on the floor nor on three."""
    edge = 2 * max(g[3] for g in grains)
    allowed = tolerance(half_width, max(g[2] for g in grains))
    cells, contacts = {}, [0] * len(grains)
    for k, (x, y, z, radius) in enumerate(grains):
        walls = [half_width - abs(x) - radius, half_width - abs(y) - radius, z - radius]
        if min(walls) < -allowed:
            return f"grain {k} is {-min(walls):g} outside the box"
        contacts[k] += sum(gap <= allowed for gap in walls) + (2 if walls[2] <= allowed else 0)
        here = (x // edge, y // edge, z // edge)
        for cell in product(*((i - 1, i, i + 1) for i in here)):
            for other in cells.get(cell, ()):
                gap = dist(grains[k][:3], grains[other][:3]) - radius - grains[other][3]
                if gap < -allowed:
                    return f"grains {other} and {k} overlap by {-gap:g}, {allowed:g} is allowed"
                contacts[k] += gap <= allowed
        cells.setdefault(here, []).append(k)
    loose = [k for k, count in enumerate(contacts) if count < 3]
    return f"grain {loose[0]} touches {contacts[loose[0]]} others, three would carry it" if loose else None


def color(t):
    """From the first colour to the last, with t from 0 to 1."""
    t = min(max(t, 0), 1) * (len(COLORS) - 1)
    i = min(int(t), len(COLORS) - 2)
    return tuple(a + (t - i) * (b - a) for a, b in zip(COLORS[i], COLORS[i + 1]))


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("count", type=int, nargs="?", default=5000, help="how many grains (default 5000)")
    parser.add_argument("--spread", type=float, default=0.12, help="standard deviation of the radius's logarithm, "
                        "0 to 0.5 (default 0.12); none deviates more than thrice that")
    parser.add_argument("--depth", type=float, default=0.3, help="of the bed to its width (default 0.3, about)")
    parser.add_argument("--color", choices=("size", "height"), default="size", help="what colours tell (default: size)")
    parser.add_argument("--seed", type=int, default=1, help="of the random numbers (default 1)")
    parser.add_argument("--check", action="store_true", help="verify that no two overlap and that each is carried")
    npy_writer.add_output_options(parser)
    options = npy_writer.parse_options(parser, lambda options: options.count)
    for name, low, high in (("count", 1, 1e9), ("spread", 0, 0.5), ("depth", 0.01, 100)):
        if not low <= getattr(options, name) <= high:
            parser.error(f"{name} is {getattr(options, name)}, expected {low:g} to {high:g}")
    return options


def fail(what):
    sys.exit(f"{os.path.basename(sys.argv[0])}: {what}")


def empty_bed(options):
    """As wide as all grains will need."""
    # The logarithm is spread (a + b + c), all three uniform in [-1, 1): the mean of exp(s a) is sinh(s) / s.
    s, largest = 3 * options.spread, exp(3 * options.spread) * (1 + 2**-23)
    volume = options.count * 4 / 3 * pi * (sinh(s) / s if s else 1) ** 3 / DENSITY
    return Bed(max((volume / options.depth) ** (1 / 3) / 2, 2 * largest), largest)


def place_grain(bed, radius, uniform):
    for _ in range(100):  # a grain that rounding has led astray, about one in 5000, is dropped anew
        place = bed.drop(*((bed.half_width - radius) * (2 * uniform() - 1) for _ in range(2)), radius)
        if place and bed.add((*array("f", place), radius)):
            return
    fail(f"no place found for grain {len(bed.grains)}")


def fill(bed, options):
    """Drops all grains; returns by how many spreads each one's radius deviates, from -3 to 3."""
    uniform, deviations = random.Random(options.seed).random, []
    while len(bed.grains) < options.count:
        deviations.append(sum(2 * uniform() - 1 for _ in range(3)))
        place_grain(bed, array("f", [exp(options.spread * deviations[-1])])[0], uniform)
    return deviations


def report_check(bed, height):
    wrong = check(bed.grains, bed.half_width)
    if wrong:
        fail(wrong)
    volume = sum(4 / 3 * pi * g[3] ** 3 for g in bed.grains if g[2] < height / 2)
    print(f"{len(bed.grains)} grains, none overlap, all are carried; the bed is {2 * bed.half_width:.4g} wide and "
          f"{height:.4g} high, {volume / (2 * bed.half_width**2 * height):.0%} of its lower half is full",
          file=sys.stderr)


def scene_around(w, height):
    """All but the grains, for a bed from -w to w."""
    ground = 2000 * w
    return {
        "image": {"width": 1024, "height": 768},
        "camera": {"eye": (-1.8 * w, -3.3 * w, 2.1 * w), "at": (0, 0, 0.2 * height), "up": (0, 0, 1), "fov": 35},
        "spheres": [{"center": (0, 0, -ground), "radius": ground, "albedo": (0.55, 0.53, 0.5)}],
        "lights": [{"type": "directional", "direction_to_light": (1.6, -1, 1.5), "irradiance": (2.3, 2.1, 1.8)},
                   {"type": "point", "position": (-2.5 * w, -4 * w, 2.5 * w),
                    "power": [w * w * p for p in (240, 280, 340)]}],
    }


def main():
    options = parse_options()
    bed = empty_bed(options)
    deviations = fill(bed, options)
    height = max(z + r for _, _, z, r in bed.grains)
    if options.check:
        report_check(bed, height)
    tints = (d / 4 + 0.5 for d in deviations) if options.color == "size" else (g[2] / height for g in bed.grains)
    rows = ((*g, *color(t)) for g, t in zip(bed.grains, tints))
    npy_writer.write_scene(scene_around(bed.half_width, height), rows, options)


if __name__ == "__main__":
    main()
