"""The generators in examples/, run as a user runs them. usage: test_examples.py, with the gnomon program, if there is
one, in GNOMON_PROGRAM."""
import json
import os
import resource
import signal
import struct
import subprocess
import sys
import tempfile
import unittest
from itertools import combinations
from math import dist, sqrt
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parent.parent / "examples"
sys.path.insert(0, str(EXAMPLES))
sys.dont_write_bytecode = True
import npy_writer  # noqa: E402
import packed_bed  # noqa: E402
import sphereflake  # noqa: E402


def read_npy(path):
    """The rows, by the format's description alone (NEP 1)."""
    data = path.read_bytes()
    assert data[:8] == b"\x93NUMPY\x01\x00", data[:8]
    start = 10 + struct.unpack("<H", data[8:10])[0]
    assert start % 64 == 0 and data[start - 1:start] == b"\n", start
    header = eval(data[10:start], {})
    assert header.keys() == {"descr", "fortran_order", "shape"}, header
    assert header["descr"] == "<f4" and header["fortran_order"] is False, header
    rows, columns = header["shape"]
    assert len(data) == start + 4 * rows * columns, len(data)
    return list(struct.iter_unpack(f"<{columns}f", data[start:]))


def float32(x):
    return struct.unpack("<f", struct.pack("<f", x))[0]


class Generators(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def run_script(self, script, *arguments, code=0, text=None):
        ran = subprocess.run([sys.executable, "-B", EXAMPLES / f"{script}.py", *map(str, arguments)], cwd=self.folder,
                             input=text, capture_output=True, text=True)
        self.assertEqual(ran.returncode, code, ran.stderr)
        self.assertNotIn("Traceback", ran.stderr)
        return ran.stdout if code == 0 else ran.stderr

    def spheres(self, script, *arguments):
        """Of a scene that has them in it, as rows of 7."""
        scene = json.loads(self.run_script(script, *arguments))
        return [(*s["center"], s["radius"], *s["albedo"]) for s in scene["spheres"]]

    def test_all_write_the_same_spheres_inline_and_as_npy(self):
        (self.folder / "data").mkdir()
        for script, count, total, first in (("sphereflake", 2, 91, 0), ("random_box", 1500, 1500, 0),
                                            ("packed_bed", 100, 100, 1)):
            with self.subTest(script):
                scene = json.loads(self.run_script(script, count, "--npy", "data/balls.npy"))
                self.assertEqual(scene["spheres"][first:], [{"file": "data/balls.npy"}])
                rows = read_npy(self.folder / "data/balls.npy")
                self.assertEqual(len(rows), total)
                inline = self.spheres(script, count)[first:]
                self.assertEqual(rows, [tuple(map(float32, row)) for row in inline])

    def test_the_same_arguments_give_the_same_bytes_and_another_seed_others(self):
        for script in ("random_box", "packed_bed"):
            made = [self.run_script(script, 60, "--seed", seed) for seed in (7, 7, 8)]
            self.assertEqual(made[0], made[1])
            self.assertNotEqual(made[0], made[2])

    def test_a_large_scene_goes_beside_its_json(self):
        (self.folder / "out").mkdir()
        self.run_script("random_box", 10001, "-o", "out/box.json")
        scene = json.loads((self.folder / "out/box.json").read_text())
        self.assertEqual(scene["spheres"], [{"file": "box.npy"}])
        self.assertEqual(len(read_npy(self.folder / "out/box.npy")), 10001)
        self.run_script("random_box", 10000, "-o", "small.json")
        self.assertFalse((self.folder / "small.npy").exists())

    def test_bad_usage_is_told_with_exit_code_2_and_a_failed_file_with_1(self):
        for script, *arguments in (("sphereflake", -1), ("sphereflake", 10), ("random_box", 0), ("random_box", "many"),
                                   ("random_box", 9, "--share", "nan"), ("random_box", 9, "-o", "x", "--npy", "./x"),
                                   ("random_box", 9, "--share", "inf"), ("random_box", 9, "--share", 1e-200),
                                   ("random_box", 9, "--share", 1e200), ("random_box", 10**400),
                                   ("sphereflake", 1, "--npy", "a.txt"), ("sphereflake", 1, "--npy", "a\n.npy"),
                                   ("packed_bed", 0), ("packed_bed", 9, "--spread", 1), ("npy_writer",)):
            with self.subTest(script=script, arguments=arguments):
                self.assertIn("error: ", self.run_script(script, *arguments, code=2))
        self.assertIn("no/such.json", self.run_script("sphereflake", 1, "-o", "no/such.json", code=1))
        self.assertIn("no/such.npy", self.run_script("sphereflake", 1, "--npy", "no/such.npy", code=1))

    def test_a_text_table_becomes_npy(self):
        self.run_script("npy_writer", "-", "a.npy", text="# x y z r\n1 2 3 4\n\n5, 6.5, -7,1e-3 # the last\n")
        self.assertEqual(read_npy(self.folder / "a.npy"), [(1, 2, 3, 4), (5, 6.5, -7, float32(1e-3))])
        for text, place in (("1 2 3 4\n1 2 3\n", "line 2"), ("1 2 3 4 5\n", "line 1"), ("1 2 3 x\n", "line 1"),
                            ("1 2 3 0\n", "line 1"), ("1 2 1e39 1\n", "line 1"), ("#\n", "no spheres"),
                            ("1 2 3 4 1 0 1\n1 2 3 4 0 -1 0\n", "line 2")):
            with self.subTest(text):
                self.assertIn(place, self.run_script("npy_writer", "-", "b.npy", text=text, code=2))
                self.assertEqual(os.listdir(self.folder), ["a.npy"])
        self.run_script("npy_writer", "-", "a.npy", text="1 2 3 4\n1 2 3\n", code=2)
        self.assertEqual(len(read_npy(self.folder / "a.npy")), 2)
        (self.folder / "t.txt").write_text("1 2 3 4\n")
        (self.folder / "link.npy").symlink_to("t.txt")
        for target in ("t.txt", "link.npy"):
            self.run_script("npy_writer", "t.txt", target, code=2)
            self.assertEqual((self.folder / "t.txt").read_text(), "1 2 3 4\n")

    def test_what_fails_or_is_interrupted_leaves_the_files_that_were_there(self):
        def limit_size():  # as a full disk does: writing beyond fails
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (10000, 10000))

        old = {name: name.encode() for name in ("a.json", "a.npy")}
        for name, data in old.items():
            (self.folder / name).write_bytes(data)
        for arguments in ((500, "-o", "a.json", "--npy", "a.npy"), (500, "-o", "a.json")):
            ran = subprocess.run([sys.executable, "-B", EXAMPLES / "random_box.py", *map(str, arguments)],
                                 cwd=self.folder, capture_output=True, text=True, preexec_fn=limit_size)
            self.assertEqual((ran.returncode, "Traceback" in ran.stderr), (1, False), ran.stderr)
            self.assertEqual({p.name: p.read_bytes() for p in self.folder.iterdir()}, old)
        with self.assertRaises(KeyboardInterrupt), npy_writer.npy_file(self.folder / "a.npy", 4) as npy:
            npy.write([(1, 2, 3, 4)])
            raise KeyboardInterrupt
        self.assertEqual({p.name: p.read_bytes() for p in self.folder.iterdir()}, old)

    def test_a_scene_in_a_linked_folder_names_its_spheres_from_where_that_is(self):
        (self.folder / "real/deep").mkdir(parents=True)
        (self.folder / "link").symlink_to("real/deep")
        self.run_script("random_box", 9, "-o", "link/s.json", "--npy", "x.npy")
        self.assertEqual(json.loads((self.folder / "link/s.json").read_text())["spheres"], [{"file": "../../x.npy"}])
        self.run_script("random_box", 9, "-o", "link/s.json", "--npy", "real/x.npy")
        self.assertEqual(json.loads((self.folder / "link/s.json").read_text())["spheres"], [{"file": "../x.npy"}])
        self.assertEqual(self.run_script("random_box", 9, "-o", "/dev/null"), "")
        self.assertFalse(Path("/dev/null").is_file())

    def test_the_sphereflake_in_the_repository_is_the_script_s(self):
        self.assertEqual(self.run_script("sphereflake"), (EXAMPLES / "sphereflake.json").read_text())

    def test_each_sphere_of_the_sphereflake_is_tangent_to_its_parent(self):
        ancestors = []
        for row in self.spheres("sphereflake", 4):
            while ancestors and ancestors[-1][3] < 2 * row[3]:
                ancestors.pop()
            if ancestors:
                self.assertAlmostEqual(dist(ancestors[-1][:3], row[:3]), ancestors[-1][3] + row[3], delta=1e-14)
            ancestors.append(row)

    def test_nearly_straight_down_directions_turn_without_loss(self):
        # A rotation keeps angles: with z, which it takes to up, and among the children. Another formula does it where
        # the sine is less than 0.141.
        for sine in (0.2, 0.142, 0.141, 1e-3, 1e-7):
            up = (0.6 * sine, -0.8 * sine, -sqrt(1 - sine * sine))
            turned = [sphereflake.turn(v, up) for v in sphereflake.CHILDREN]
            for v, t in zip(sphereflake.CHILDREN, turned):
                self.assertAlmostEqual(sum(a * b for a, b in zip(t, up)), v[2], delta=1e-12)
            for (v, t), (w, s) in combinations(zip(sphereflake.CHILDREN, turned), 2):
                self.assertAlmostEqual(dist(t, s), dist(v, w), delta=1e-12)

    def test_the_random_box_follows_splitmix64_draw_by_draw(self):
        state, count = 3000, 3000

        def draw(low, high):
            nonlocal state
            state = (state + 0x9E3779B97F4A7C15) % 2**64
            z = ((state ^ state >> 30) * 0xBF58476D1CE4E5B9) % 2**64
            z = ((z ^ z >> 27) * 0x94D049BB133111EB) % 2**64
            return float32(low + (high - low) * (((z ^ z >> 31) >> 40) / 2**24))

        r0 = (0.05 * 1e6 / (count * 1.25 * 4 / 3 * 3.141592653589793)) ** (1 / 3)
        ranges = [(-50, 50)] * 3 + [(0.5 * r0, 1.5 * r0)] + [(0.2, 0.9)] * 3
        expected = [tuple(draw(*r) for r in ranges) for _ in range(count)]
        self.run_script("random_box", count, "--npy", "a.npy")
        self.assertEqual(read_npy(self.folder / "a.npy"), expected)
        self.run_script("random_box", count, "--npy", "a.npy", "--no-albedo")
        self.assertEqual(read_npy(self.folder / "a.npy"), [row[:4] for row in expected])

    def test_the_packed_bed_is_packed_and_each_grain_is_carried(self):
        self.run_script("packed_bed", 500, "--check", "--npy", "bed.npy")
        grains = read_npy(self.folder / "bed.npy")
        # Walls are where the grains reach to. All coordinates are below 32, where rounding moves them by 2^-20 at most.
        side = max(max(abs(x), abs(y)) + r for x, y, _, r, *_ in grains)
        self.assertLess(side, 32)
        allowed = 2 * sqrt(3) * 2**-20
        gaps = {k: [z - r] * 3 + [side - r - abs(v) for v in (x, y)] for k, (x, y, z, r, *_) in enumerate(grains)}
        for (i, a), (j, b) in combinations(enumerate(grains), 2):
            gap = dist(a[:3], b[:3]) - a[3] - b[3]
            gaps[i].append(gap)
            gaps[j].append(gap)
        self.assertGreater(min(map(min, gaps.values())), -allowed)
        for k in gaps:
            self.assertGreaterEqual(sum(gap < allowed for gap in gaps[k]), 3, f"grain {k} hangs in the air")

    def test_the_bed_s_own_check_finds_what_is_wrong(self):
        floor = [(2.0 * x, 2.0 * y, 1.0, 1.0) for x in range(-2, 3) for y in range(-2, 3)]
        self.assertIsNone(packed_bed.check(floor, 5.0))
        self.assertIn("overlap", packed_bed.check(floor + [(1.0, 1.0, 2.0, 1.0)], 5.0))
        self.assertIn("outside", packed_bed.check(floor, 4.9))
        self.assertIn("touches 0", packed_bed.check(floor + [(1.0, 1.0, 3.0, 1.0)], 5.0))

    @unittest.skipUnless("GNOMON_PROGRAM" in os.environ, "no GNOMON_PROGRAM")
    def test_gnomon_renders_what_they_write(self):
        for script, count in (("sphereflake", 1), ("random_box", 20), ("packed_bed", 20)):
            with self.subTest(script):
                self.run_script(script, count, "-o", "scene.json")
                subprocess.run([os.environ["GNOMON_PROGRAM"], "render", "scene.json", "--size", "16x12", "-o", "x.png"],
                               cwd=self.folder, check=True, capture_output=True)


if __name__ == "__main__":
    unittest.main()
