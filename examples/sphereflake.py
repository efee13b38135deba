#!/usr/bin/env python3
"""Writes a gnomon scene of the sphereflake, "balls" of Eric Haines' Standard Procedural Databases (SPD).

A sphere of radius 1/2 at the origin carries nine spheres a third its size, tangent to it, each of which carries nine
in turn: six around the equator, three above it, where a child's "up" is the direction from its parent. Depth 4, the
size SPD is usually quoted at, has 1 + 9 + 81 + 729 + 6561 = 7381 spheres.

Spheres, view and light positions are SPD's. Not SPD's: its floor is left out, for gnomon has only spheres; matte
albedos, one per level, stand for its mirrors; the lights, which SPD does not dim with distance, have a power.
"""
import argparse
from math import sqrt

import npy_writer

# One colour per level, root first: SPD's (1, 0.9, 0.7) dimmed to 0.9 of it, then down through earth to blue.
ALBEDO = ((0.9, 0.81, 0.63), (0.85, 0.5, 0.3), (0.85, 0.72, 0.35), (0.35, 0.62, 0.55), (0.3, 0.48, 0.75))

# W in each channel. The root's brightest visible radiance, rho/pi * sum of power * cos(theta) / (4 pi d^2), is then
# 0.54 in red.
POWER = 400.0

# Directions of the nine children of a sphere whose "up" is +z, in SPD's order: at azimuth 45 degrees one sqrt(2/3) up,
# at 15 and 75 degrees two on the equator; then these three turned by 120 and 240 degrees. Neighbours are 60 degrees
# apart. Square roots alone, no sines: the scene is the same to the last bit wherever it is made.
TRIO = ((1 / sqrt(6), 1 / sqrt(6), 2 / sqrt(6)),
        ((sqrt(6) + sqrt(2)) / 4, (sqrt(6) - sqrt(2)) / 4, 0.0),
        ((sqrt(6) - sqrt(2)) / 4, (sqrt(6) + sqrt(2)) / 4, 0.0))
TURNS = ((1.0, 0.0), (-0.5, sqrt(3) / 2), (-0.5, -sqrt(3) / 2))  # cosine, sine
CHILDREN = tuple((c * x - s * y, s * x + c * y, z) for c, s in TURNS for x, y, z in TRIO)


def turn(v, up):
    """v, turned by the rotation about z cross up that takes +z to the unit vector up."""
    if 1 + up[2] < 0.01:  # nearly down the quotient below would enlarge what rounding has left
        # Straight down no axis is distinguished, and SPD takes y's. Down to depth 9, rounding leaves such an "up" an
        # x^2 + y^2 of at most 2e-26, and all others have 4e-14 and more.
        square = up[0] * up[0] + up[1] * up[1]
        if square < 1e-20:
            return (-v[0], v[1], -v[2])
        sine = sqrt(square)  # Rodrigues' formula, about (x, y, 0)
        x, y = -up[1] / sine, up[0] / sine
        along = (x * v[0] + y * v[1]) * (1 - up[2])
        return (v[0] * up[2] + y * v[2] * sine + x * along, v[1] * up[2] - x * v[2] * sine + y * along,
                v[2] * up[2] + (x * v[1] - y * v[0]) * sine)
    along = v[0] * up[0] + v[1] * up[1]
    lift = v[2] - along / (1 + up[2])
    return (v[0] + lift * up[0], v[1] + lift * up[1], v[2] * up[2] - along)


def sphereflake(depth, center=(0.0, 0.0, 0.0), radius=0.5, up=(0.0, 0.0, 1.0), level=0):
    """Yields the spheres, a parent before its children, as x, y, z, radius, red, green, blue."""
    yield (*center, radius, *ALBEDO[level % len(ALBEDO)])
    if level < depth:
        child = radius / 3
        for v in CHILDREN:
            direction = turn(v, up)
            tangent = tuple(c + (radius + child) * d for c, d in zip(center, direction))
            yield from sphereflake(depth, tangent, child, direction, level + 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("depth", type=int, nargs="?", default=4, choices=range(10), metavar="depth",
                        help="levels below the root, 0 to 9; each has nine times the spheres (default 4: 7381 spheres; "
                        "8: 48 million, 1.4 GB)")
    npy_writer.add_output_options(parser)
    options = npy_writer.parse_options(parser, lambda options: 9 ** (options.depth + 1) // 8)
    lights = ((4, 3, 2), (1, -4, 4), (-3, 1, 5))
    scene = {
        "image": {"width": 1024, "height": 768},
        "camera": {"eye": (2.1, 1.3, 1.7), "at": (0, 0, 0), "up": (0, 0, 1), "fov": 45},
        "spheres": [],
        "lights": [{"type": "point", "position": p, "power": (POWER,) * 3} for p in lights],
    }
    npy_writer.write_scene(scene, sphereflake(options.depth), options)


if __name__ == "__main__":
    main()
