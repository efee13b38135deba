#!/usr/bin/env python3
"""Writes a gnomon scene of spheres strewn at random in a cube: any number, always the same share of it.

The cube is [-50, 50)^3. Radii are uniform from 0.5 to 1.5 r0, with the r0 that makes the spheres' volumes add up to the
share on average: overlaps are not avoided, and count twice. Each sphere takes seven draws: x, y, z, radius, red, green,
blue. The benchmark's scenes S1e4 and S1e6 are the same, but for the rounding to 32-bit floats here.
"""
import argparse
import sys
from array import array
from itertools import islice
from math import inf, pi

import npy_writer

BLOCK = 1024  # spheres at a time
MAX_COUNT = 2**31 - 1  # gnomon's
GAMMA = 0x9E3779B97F4A7C15


def splitmix64(seed, size):
    """Yields the upper 24 bits of splitmix64's draws in blocks of size numbers, for ever.

    Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014. The state is only counted up, so that
    many draws can be made at once: each has 128 bits of one large integer, where a product of 64 by 64 bits stays
    within its own and the integer's operations, which are compiled, do them all.
    """
    ones = int.from_bytes((b"\1" + bytes(15)) * size, "little")
    low = ones * (2**64 - 1)
    low34, low37, low24 = (ones * (2**bits - 1) for bits in (34, 37, 24))
    steps = int.from_bytes(b"".join((i * GAMMA % 2**64).to_bytes(16, "little") for i in range(1, size + 1)), "little")
    while True:
        z = (steps + ones * (seed % 2**64)) & low
        z = ((z ^ (z >> 30 & low34)) * 0xBF58476D1CE4E5B9) & low
        z = ((z ^ (z >> 27 & low37)) * 0x94D049BB133111EB) & low
        z ^= z >> 31  # what comes down from the neighbour's bits stays above these 64
        # Only now are the draws taken apart, into pairs of 64 bits: the number and 0.
        pairs = array("Q")
        pairs.frombytes((z >> 40 & low24).to_bytes(16 * size, "little"))
        if sys.byteorder == "big":
            pairs.byteswap()
        yield pairs[::2]
        seed += size * GAMMA


def radii(count, share):
    """The smallest and the largest."""
    # The mean of r^3, uniform from 0.5 to 1.5 r0, is 1.25 r0^3.
    r0 = (share * 1e6 / (count * 1.25 * 4 / 3 * pi)) ** (1 / 3)
    return (0.5 * r0, 1.5 * r0)


def spheres(count, seed, share, columns):
    """Yields rows of the first 4 or of all 7 numbers, rounded to 32-bit floats."""
    ranges = ((-50, 50), (-50, 50), (-50, 50), radii(count, share), (0.2, 0.9), (0.2, 0.9), (0.2, 0.9))
    blocks = splitmix64(seed, BLOCK * len(ranges))
    for done in range(0, count, BLOCK):
        draws = next(blocks)
        # A draw n stands for n / 2^24 in [0, 1); to divide by a power of two rounds nothing.
        scaled = ((a, (b - a) / 2**24, draws[k::7]) for k, (a, b) in enumerate(ranges[:columns]))
        yield from islice(zip(*(array("f", [a + step * n for n in draw]) for a, step, draw in scaled)), count - done)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("count", type=int, nargs="?", default=10000, help="how many spheres (default 10000)")
    parser.add_argument("--share", type=float, default=0.05, help="the spheres' volume to the cube's (default 0.05)")
    parser.add_argument("--seed", type=int, help="of the random numbers (default: the count)")
    parser.add_argument("--no-albedo", action="store_true",
                        help="the same places and radii, all in one colour: rows of 4 numbers, not 7")
    npy_writer.add_output_options(parser)
    options = npy_writer.parse_options(parser, lambda options: options.count)
    if not 1 <= options.count <= MAX_COUNT:
        parser.error(f"count is {options.count}, expected 1 to {MAX_COUNT}")
    if not options.share > 0 or not all(0 < r < inf for r in array("f", radii(options.count, options.share))):
        parser.error(f"--share is {options.share}, expected a positive number, and radii in the range of 32-bit floats")
    scene = {
        "image": {"width": 1920, "height": 1080},
        "camera": {"eye": (50, 45, -115), "at": (0, 0, 0), "up": (0, 1, 0), "fov": 40},
        "spheres": [],
        "lights": [{"type": "directional", "direction_to_light": (1, 2, -1.5), "irradiance": (1.5,) * 3},
                   {"type": "point", "position": (0, 100, -120), "power": (400000,) * 3}],
    }
    seed = options.count if options.seed is None else options.seed
    columns, albedo = (4, (0.7, 0.7, 0.7)) if options.no_albedo else (7, None)
    npy_writer.write_scene(scene, spheres(options.count, seed, options.share, columns), options, albedo)


if __name__ == "__main__":
    main()
