#!/usr/bin/env python3
"""Turns a text table of spheres into NumPy's .npy, as gnomon scenes name it: {"file": "NAME.npy", "albedo": [1, 1, 1]}.

A line of the table is one sphere: x y z radius, or x y z radius red green blue, with blanks or commas between the
numbers; blank lines and what follows a # are passed over. The .npy holds little-endian 32-bit floats of shape (N, 4) or
(N, 7). The generators beside this file write theirs and their scenes with it too, block by block in bounded memory.
"""
import argparse
import json
import os
import sys
from array import array
from contextlib import contextmanager, suppress
from itertools import chain, islice
from math import isfinite

BLOCK = 1 << 16  # numbers on their way to the file
# More spheres than this go to an .npy unless the scene goes to standard output: as JSON they take five times its size
# and far more than five times its reading.
INLINE_MAX = 10000


@contextmanager
def whole_file(path, mode="w", encoding=None):
    """A file to write, which takes its name once it is whole: what fails or is interrupted leaves all as it was."""
    target = os.path.realpath(path)  # where path is a link, it stays one
    if os.path.exists(target) and not os.path.isfile(target):  # a pipe or a device has nothing that could be lost
        with open(target, mode, encoding=encoding) as file:
            yield file
        return
    temporary = f"{target}.{os.getpid()}.tmp"
    try:
        with open(temporary, mode, encoding=encoding) as file:
            yield file
        os.replace(temporary, target)
    except BaseException:  # Ctrl-C and sys.exit() too
        with suppress(OSError):
            os.remove(temporary)
        raise


@contextmanager
def npy_file(path, columns):
    """A .npy file to write, as an NpyWriter."""
    with whole_file(path, "wb") as file:
        npy = NpyWriter(file, columns)
        yield npy
        npy.finish()


class NpyWriter:
    """The rows of a .npy file, 32-bit floats, from first to last; their number need not be known before.

    The header comes last, into room kept for it.
    """

    HEADER_SIZE = 128  # a multiple of 64, as the format wants; its text has 77 characters at most, with a count of 2^63

    def __init__(self, file, columns):
        self.file, self.columns, self.numbers = file, columns, 0
        self.file.seek(self.HEADER_SIZE)

    def write(self, rows):
        """Appends rows, any iterable of sequences with a number for each column."""
        numbers = chain.from_iterable(rows)
        while block := array("f", islice(numbers, BLOCK)):
            self.numbers += len(block)
            if sys.byteorder == "big":
                block.byteswap()
            block.tofile(self.file)

    def finish(self):
        count, rest = divmod(self.numbers, self.columns)
        if rest:
            raise ValueError(f"{self.numbers} numbers are no rows of {self.columns}")
        # Version 1.0 (numpy.lib.format): magic, version, the text's length in 16 bits; the text ends with a newline.
        text = f"{{'descr': '<f4', 'fortran_order': False, 'shape': ({count}, {self.columns}), }}"
        length = self.HEADER_SIZE - 10
        self.file.truncate(self.HEADER_SIZE + 4 * self.numbers)  # with no row there is nothing yet, not even the room
        self.file.seek(0)
        self.file.write(b"\x93NUMPY\x01\x00" + length.to_bytes(2, "little") + text.ljust(length - 1).encode() + b"\n")


def add_output_options(parser):
    parser.add_argument("-o", "--output", metavar="SCENE.json", default="-",
                        help="the scene (default: standard output)")
    parser.add_argument("--npy", metavar="FILE.npy",
                        help="the spheres, which the scene then names by a path relative to its own (default: they are "
                        f"in the scene, but more than {INLINE_MAX} go to SCENE.npy if -o names the scene)")


def parse_options(parser, count):
    """The command line; its npy is None if the spheres, count(options) of them, are to be in the scene."""
    options = parser.parse_args()
    if options.npy is None and options.output != "-" and count(options) > INLINE_MAX:
        options.npy = os.path.splitext(options.output)[0] + ".npy"
    if options.npy and os.path.realpath(options.npy) == os.path.realpath(options.output):
        parser.error(f"scene and spheres would both be {options.output}")
    if options.npy:
        expect_npy(options.npy, parser)
    return options


def expect_npy(path, parser):
    """Ends the program unless gnomon would take the name: it knows files by their extension, and refuses controls."""
    if os.path.splitext(path)[1].lower() != ".npy":
        parser.error(f"{path}: expected a name that ends in .npy")
    if any(c < " " or c == "\x7f" or "\ud800" <= c <= "\udfff" for c in path):  # the last: bytes that are no UTF-8
        parser.error(f"{path!a}: expected a name without control characters, in UTF-8")


def name_in_scene(npy, output):
    """The .npy's path from the scene's folder, of which links may be part."""
    folder, name = os.path.split(npy)
    scene_folder = "." if output == "-" else os.path.dirname(output)
    return os.path.relpath(os.path.join(os.path.realpath(folder), name),
                           os.path.realpath(scene_folder)).replace(os.sep, "/")


def write_scene(scene, rows, options, albedo=None):
    """Writes rows of 4 numbers, which all have this albedo, or of 7, after the spheres that the scene has already.

    Whatever goes wrong with the files ends the program, and leaves those that were there.
    """
    to_stdout = options.output == "-"
    try:
        with sys.stdout if to_stdout else whole_file(options.output, encoding="utf-8") as output:
            if options.npy:
                entry = {"file": name_in_scene(options.npy, options.output), **({"albedo": albedo} if albedo else {})}
                with npy_file(options.npy, 4 if albedo else 7) as npy:
                    npy.write(rows)
                    write_json({**scene, "spheres": scene["spheres"] + [entry]}, output)
                    output.flush()  # so that of both files none or all is written before the first takes its name
            else:
                single = ({"center": r[:3], "radius": r[3], "albedo": albedo or r[4:]} for r in rows)
                write_json({**scene, "spheres": chain(scene["spheres"], single)}, output)
    except OSError as error:
        sys.exit(f"{os.path.basename(sys.argv[0])}: {error}")


def write_json(scene, output):
    """One line for each sphere, each light and each other entry; spheres and lights may be any iterable."""
    begin = "{\n"
    for key, value in scene.items():
        output.write(f'{begin}  "{key}": ')
        begin = ",\n"
        if isinstance(value, dict):
            output.write(json.dumps(value))
            continue
        separator = "[\n    "
        for v in value:
            output.write(separator + json.dumps(v))
            separator = ",\n    "
        output.write("\n  ]" if separator[0] == "," else "[]")
    output.write("\n}\n")


def parse_table(lines, fail):
    """Yields the rows of a text table; fail(what) must not return."""
    columns = None
    for number, line in enumerate(lines, 1):
        fields = line.partition("#")[0].replace(",", " ").split()
        if not fields:
            continue
        columns = columns or len(fields)
        if len(fields) != columns or columns not in (4, 7):
            fail(f"line {number}: {len(fields)} numbers, expected {columns if columns in (4, 7) else '4 or 7'}")
        try:
            row = [float(f) for f in fields]
        except ValueError as error:
            fail(f"line {number}: {error}")
        if not all(map(isfinite, array("f", row))) or not array("f", row)[3] > 0:
            fail(f"line {number}: {line.strip()}: not finite in 32 bits, or no positive radius")
        if min(row[4:], default=0) < 0:
            fail(f"line {number}: {line.strip()}: a negative colour")
        yield row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("table", help="the text, - for standard input")
    parser.add_argument("npy", help="the file to write")
    options = parser.parse_args()
    expect_npy(options.npy, parser)
    if os.path.realpath(options.table) == os.path.realpath(options.npy):
        parser.error(f"table and spheres would both be {options.npy}")
    try:
        with sys.stdin if options.table == "-" else open(options.table, encoding="utf-8") as lines:
            rows = parse_table(lines, lambda what: parser.error(f"{options.table}: {what}"))
            first = next(rows, None) or parser.error(f"{options.table}: no spheres")
            with npy_file(options.npy, len(first)) as npy:
                npy.write(chain([first], rows))
    except (OSError, UnicodeDecodeError) as error:
        parser.exit(1, f"{parser.prog}: error: {error}\n")


if __name__ == "__main__":
    main()
