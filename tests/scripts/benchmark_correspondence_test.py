#!/usr/bin/env python3
"""Tests of scripts/study benchmark-correspondence: what it measures, keeps and refuses, with real programs and small shapes.

usage: benchmark_correspondence_test.py --build BUILD_TREE [TEST]
"""

import csv
import json
import math
import os
import pathlib
import signal
import subprocess
import sys
import time
import unittest

root = pathlib.Path(__file__).resolve().parent.parent.parent
sys.dont_write_bytecode = True
sys.path[:0] = [str(root / "scripts"), str(root / "tests/studies"), str(root / "tests/bench"), str(root / "tests/support")]

from correspondence import tables  # noqa: E402
from correspondence.pairs import draw, read_pairs  # noqa: E402
from script_test import ScriptTest, path_option  # noqa: E402

build = None  # the build tree under test

# A square of 4 x 4 units, its diagonals from lower left to upper right: paths along edges are known, the area is 16.
side = 5
square = [(i, j, 0) for j in range(side) for i in range(side)]
triangles = [t for j in range(side - 1) for i in range(side - 1)
             for a in [side * j + i] for t in ((a, a + 1, a + side + 1), (a, a + side + 1, a + side))]

# Writes what the first argument says: the reference moved by a step along x, or the index of each vertex' neighbour.
tool = """#!/usr/bin/env python3
import sys, time, pathlib
kind, reference, template, out = sys.argv[1:]
lines = pathlib.Path(reference).read_text().split("\\n")
n = int(lines[1].split()[0])
points = [line.split() for line in lines[2:2 + n]]
if kind == "fail":
    print("first line\\nno map was found")
    sys.exit(4)
if kind == "sleep":
    pathlib.Path(out).write_text("half of ")
    time.sleep(100)
if kind == "shift":
    body = [f"{float(x) + 1} {y} {z}" for x, y, z in points]
    pathlib.Path(out + ".off").write_text("\\n".join([lines[0], lines[1], *body, *lines[2 + n:]]))
if kind in ("0", "1"):
    pathlib.Path(out + ".txt").write_text("".join(f"{max(v - 1, 0) + int(kind)}\\n" for v in range(n)))
if kind == "few":
    pathlib.Path(out).write_text("1 2 3")
"""


def off(vertices, facets):
    return "\n".join(["OFF", f"{len(vertices)} {len(facets)} 0", *(" ".join(map(str, v)) for v in vertices),
                      *(f"3 {a} {b} {c}" for a, b, c in facets)]) + "\n"


class Benchmark(ScriptTest):
    def setUp(self):
        super().setUp()
        self.tool = self.folder / "tool"
        self.tool.write_text(tool)
        self.tool.chmod(0o755)

    def command(self, *words):
        return [str(root / "tests/studies/benchmark-correspondence"), *map(str, words[:1]), "-o", str(self.folder / "out"),
                "--program", str(build / "apps/shellmatch"), "--measure", str(build / "tests/studies/correspondence/correspondence_error"),
                "--plots", str(build / "tests/studies/plot/plot_series"), *map(str, words[1:])]

    def run_script(self, *words, data=""):
        return subprocess.run(self.command(*words), capture_output=True, text=True, timeout=300, env={**os.environ, "SHELLMATCH_DATA": data})

    def call(self, *words, code=0):
        result = self.run_script(*words)
        self.assertEqual(result.returncode, code, result.stderr)
        return result.stdout

    def refused(self, words, *parts, code=2):
        self.assert_refused(self.run_script(*words), "benchmark-correspondence", code, parts)

    def rows(self):
        with open(self.folder / "out/table.csv", newline="") as file:
            return {(row["method"], row["pair"]): {key: value for key, value in row.items()} for row in csv.DictReader(file)}

    def squares(self, vts=True):
        """a0 and a1 are the square; its vertices correspond one by one, those of the .vts in the reversed order of their lines."""
        shapes = self.folder / "shapes"
        shapes.mkdir()
        for name in ("a0", "a1"):
            (shapes / f"{name}.off").write_text(off(square, triangles))
            if vts:
                (shapes / f"{name}.vts").write_text("".join(f"{v}\n" for v in range(len(square), 0, -1)))
        return shapes

    def other(self, kind, name="tool"):
        return ["--no-match", "--command", f"{name}: {self.tool} {kind} {{reference}} {{template}} {{out}}"]

    def test_errors_are_those_of_paths_along_edges_over_the_root_of_the_area(self):
        shapes = self.squares()
        self.call(shapes, *self.other("shift"))
        rows = self.rows()
        self.assertEqual(set(rows), {("tool", "a0-a1"), ("tool", "a1-a0")})
        for row in rows.values():
            # A step of 1 over 4, but for the last column, which ends nearest to itself.
            self.assertAlmostEqual(float(row["mean"]), 25 * 20 / 25)
            self.assertEqual((float(row["p95"]), float(row["max"]), float(row["beyond"])), (25, 25, 0.8))
            self.assertEqual((row["before"], row["metric"], row["unreachable"], row["dt_mean"]), ("0", "geodesic", "0", ""))

    def test_without_vts_errors_are_in_diagonals(self):
        self.call(self.squares(vts=False), *self.other("shift"))
        row = self.rows()["tool", "a0-a1"]
        self.assertEqual(row["metric"], "euclidean")
        for figure in ("mean", "p95", "max"):
            self.assertAlmostEqual(float(row[figure]), 1 / math.sqrt(32))
        self.assertEqual(row["beyond"], "1")

    def test_maps_of_vertices_count_from_one_or_zero(self):
        shapes = self.squares()
        # 20 steps by one vertex to the left, four from the first of a row to the last of the one below, 5 away; one stays.
        expected = 25 * (20 * 1 + 4 * 5) / 25
        for first, name in ((0, "zero"), (1, "one")):
            self.call(shapes, *self.other(first, name), "--first-index", first)
            self.assertAlmostEqual(float(self.rows()[name, "a0-a1"]["mean"]), expected)
        self.assertIn(("zero", "a0-a1"), self.rows())  # what an earlier call has found stays in the table
        self.assertIn("expected a number from 1 to 25", self.run_script(shapes, *self.other(0, "wrong")).stdout)

    def test_a_match_is_measured_kept_and_repeated_where_options_change(self):
        for name, variant, edge in (("sphere", "round", "0.041"), ("ellipsoid", "long", "0.05")):  # 492 vertices each
            words = ["generate", f"ellipsoid/{variant}", "-o", self.folder / f"{name}.off", "--edge-length", edge]
            subprocess.run([build / "apps/shellmatch", *words], check=True, capture_output=True)
        pairs = self.folder / "round.txt"
        pairs.write_text("# two shapes\nsphere.off ellipsoid.off  # of one connectivity\n")
        words = [pairs, "--jobs", 2, "--", "--levels", "3:3"]
        first = self.call(*words)
        run = self.folder / "out/shellmatch/sphere-ellipsoid"
        summary = json.loads((run / "out/summary.json").read_text())
        row = self.rows()["shellmatch", "sphere-ellipsoid"]
        self.assertEqual(float(row["dt_mean"]), summary["distance"]["deformed_to_template"]["mean"])
        self.assertEqual(float(row["td_max"]), summary["distance"]["template_to_deformed"]["max"])
        self.assertEqual(row["folded_cells"], "0")
        self.assertLess(float(row["mean"]), 0.5 * float(row["before"]))
        self.assertTrue((run / "out/deformed.ply").exists())
        self.assertFalse((run / "out/deformation.vtu").exists())
        self.assertIn(" 0 ", (self.folder / "out/table.md").read_text())
        shares = list(csv.reader((self.folder / "out/curves-euclidean.csv").read_text().splitlines()))
        values = [float(line[1]) for line in shares[1:]]
        self.assertEqual(shares[0], ["error", "shellmatch"])
        self.assertEqual(values, sorted(values))
        self.assertGreaterEqual(values[-1], 0.98)
        self.assertIn("<svg", (self.folder / "out/curves-euclidean.svg").read_text())
        self.assertNotIn("(kept)", first)

        record = (run / "record.json").read_text()
        self.assertIn("(kept)", self.call(*words))
        self.assertEqual((run / "record.json").read_text(), record)
        self.assertNotIn("(kept)", self.call(*words, "--set", "energy.delta=0.5"))
        self.assertNotEqual(json.loads((run / "record.json").read_text())["run"], json.loads(record)["run"])

    def test_another_shape_under_an_old_name_is_matched_again(self):
        shapes = self.squares()
        self.call(shapes, *self.other("shift"), "--only", "a0-a1")
        (shapes / "a1.off").write_text(off([(2 * x, 2 * y, z) for x, y, z in square], triangles))
        output = self.call(shapes, *self.other("shift"), "--only", "a0-a1")
        self.assertNotIn("(kept)", output)
        self.assertGreater(float(self.rows()["tool", "a0-a1"]["before"]), 0)

    def test_another_correspondence_is_measured_without_a_new_run(self):
        shapes = self.squares()
        self.call(shapes, *self.other("shift"), "--only", "a0-a1")
        old = json.loads((self.folder / "out/tool/a0-a1/record.json").read_text())
        (shapes / "a1.vts").write_text("".join(f"{v}\n" for v in range(1, len(square) + 1)))
        self.call(shapes, *self.other("shift"), "--only", "a0-a1")
        new = json.loads((self.folder / "out/tool/a0-a1/record.json").read_text())
        self.assertEqual(new["seconds"], old["seconds"])
        self.assertGreater(new["error"]["mean"], old["error"]["mean"])

    def stopped(self, number):
        shapes = self.squares()
        words = self.command(shapes, *self.other("sleep"), "--only", "a0-a1")
        script = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        for _ in range(400):
            if list(self.folder.glob("out/tool/.a0-a1.partial-*/out")):
                break
            time.sleep(0.05)
        else:
            self.fail("the tool did not start")
        child = next(int(p.parent.name) for p in pathlib.Path("/proc").glob("[0-9]*/cmdline")
                     if str(self.tool).encode() in reading(p) and b"sleep" in reading(p) and b"benchmark" not in reading(p))
        script.send_signal(number)
        _, message = script.communicate(timeout=60)
        self.addCleanup(ended, child)
        return shapes, script.returncode, message, child

    def test_stopped_in_the_middle_it_leaves_nothing_and_goes_on(self):
        shapes, code, message, child = self.stopped(signal.SIGTERM)
        self.assertEqual((code, message.count("\n")), (130, 1), message)
        self.assertFalse(os.path.exists(f"/proc/{child}"))
        self.assertEqual(list(self.folder.glob("out/tool/*")) + list(self.folder.glob("out/tool/.*")), [])
        self.assertNotIn("(kept)", self.call(shapes, *self.other("shift"), "--only", "a0-a1"))

    def test_killed_in_the_middle_it_leaves_nothing_that_counts(self):
        shapes, code, _, _ = self.stopped(signal.SIGKILL)
        self.assertEqual(code, -signal.SIGKILL)
        self.assertFalse((self.folder / "out/tool/a0-a1").exists())
        self.assertNotIn("(kept)", self.call(shapes, *self.other("shift"), "--only", "a0-a1"))
        self.assertEqual(list(self.folder.glob("out/tool/.*")), [])

    def test_a_run_that_fails_is_named_and_the_others_go_on(self):
        shapes = self.squares()
        good = f"good: {self.tool} shift {{reference}} {{template}} {{out}}"
        result = self.run_script(shapes, *self.other("fail", "bad"), "--command", good)
        self.assertEqual(result.returncode, 1)
        self.assertIn("2 of 4 runs failed", result.stderr)
        self.assertIn("no map was found", result.stdout)
        self.assertIn("Failed: bad, a0-a1: no map was found", (self.folder / "out/table.md").read_text())
        self.assertEqual({method for method, _ in self.rows()}, {"good"})
        self.assertIn("first line", (self.folder / "out/bad/a0-a1.failed.txt").read_text())
        for kind, message in (("few", "is for 3 vertices; the reference has 25"), ("nothing", "it wrote nothing to {out}")):
            self.assertIn(message, self.run_script(shapes, *self.other(kind), "--only", "a0-a1").stdout)
        self.assertIn("stopped after 1 s", self.run_script(shapes, *self.other("sleep"), "--only", "a0-a1", "--limit", 1).stdout)

    def test_pairs_drawn_by_seed_are_reported_apart(self):
        shapes = self.squares()
        for name in ("a2", "a3"):
            (shapes / f"{name}.off").write_text(off(square, triangles))
            (shapes / f"{name}.vts").write_text("".join(f"{v}\n" for v in range(len(square), 0, -1)))
        words = [shapes, *self.other("shift"), "--draw", 4, "--seed", 7]
        self.call(*words, "--part", "others")
        others = set(self.rows())
        self.assertEqual((len(others), {row["part"] for row in self.rows().values()}), (8, {"others"}))
        self.assertIn("**mean of 8 others**", (self.folder / "out/table.md").read_text())
        self.call(*words, "--part", "drawn")
        self.assertEqual({key for key, row in self.rows().items() if row["part"] == "others"}, others)
        table = (self.folder / "out/table.md").read_text()
        self.assertTrue("**mean of 8 others**" in table and "**mean of 4 drawn**" in table, table)
        pairs = read_pairs(shapes)
        self.assertEqual(draw(pairs, 4, 7), draw(pairs[::-1], 4, 7))
        self.assertNotEqual(draw(pairs, 4, 7), draw(pairs, 4, 8))
        self.refused([shapes, "--draw", 13], "--draw 13: there are 12 pairs")
        self.refused([shapes, "--part", "drawn"], "--part and --seed: are for --draw N")

    def test_words_behind_four_files_are_remarks(self):
        shapes = self.squares()
        (self.folder / "list.txt").write_text("shapes/a0.off shapes/a1.off shapes/a0.vts shapes/a1.vts pose easy\n")
        self.call(self.folder / "list.txt", *self.other("shift"))
        self.assertEqual(set(self.rows()), {("tool", "a0-a1")})

    def test_results_go_between_the_marks_of_a_page(self):
        shapes = self.squares()
        page = self.folder / "page.md"
        marks = "<!-- results of shapes: made by scripts/study benchmark-correspondence -->", "<!-- end of shapes -->"
        page.write_text(f"before\n\n{marks[0]}\nold\n{marks[1]}\n\nafter\n")
        for _ in range(2):
            self.call(shapes, *self.other("shift"), "--page", page)
            text = page.read_text()
            self.assertTrue(text.startswith("before\n") and text.endswith("\nafter\n"))
            self.assertNotIn("old", text)
            self.assertEqual(text.count("| a0-a1 | tool | 0.00 | 20.00 | 25.00 | 25.00 | 80.0 % |"), 1, text)
            self.assertEqual(text.count("**mean of 2**"), 1)
            command = next(line for line in text.splitlines() if line.startswith("    scripts/study benchmark-correspondence "))
            self.assertTrue(command.endswith(" -o out/shapes"), command)
            for own in (str(self.folder / "out"), "--program", "--measure", "--plots", "--page"):
                self.assertNotIn(own, command)
        self.assertTrue((self.folder / "pictures/correspondence-shapes-geodesic.svg").exists())
        page.write_text("no marks")
        self.refused([shapes, *self.other("shift"), "--page", page], "page.md needs the lines")

    def test_what_cannot_be_used_is_refused_in_one_message(self):
        shapes = self.squares()
        bad = self.folder / "bad.txt"
        for text, part in (("a.off b.off\n", "line 1: a.off is neither in"), ("\nx\n", "line 2: 1 words"), ("# none\n", "has no pairs"),
                           ("tool tool\ntool tool\n", "two pairs are called tool-tool"), ("'a b\n", "line 1: No closing quotation")):
            bad.write_text(text)
            self.refused([bad], part)
        self.refused([self.folder / "gone"], "gone is not there")
        self.refused([shapes, "--only", "a0-a7"], "has no pair a0-a7; it has a0-a1, a1-a0")
        self.refused([shapes, "--no-match"], "nothing to run")
        self.refused([shapes, "--command", f"{self.tool} {{reference}} {{out}}"], "expected {reference}, {template}, {out}")
        self.refused([shapes, "--command", f"{self.tool} {{reference}} {{template}} {{out}} {{x}}"], "no placeholder {x}")
        self.refused([shapes, "--command", "no-such-tool {reference} {template} {out}"], "no-such-tool cannot be run")
        self.refused([shapes, "--program", "no-such-program"], "no-such-program cannot be run; build it")
        self.refused([shapes, "--measure", "no-such-program"], "build it with scripts/build release correspondence_error")
        self.refused([shapes, "--tables-only"], "has no finished run of these pairs")
        (shapes / "a1.vts").unlink()
        self.refused([shapes], "a1.vts is not there, but")
        (self.folder / "out/other").write_text("")
        (self.folder / "out/.benchmark-correspondence").unlink()
        self.refused([shapes, "--all-pairs", *self.other("shift")], "a1.vts is not there")
        (shapes / "a0.vts").unlink()
        self.refused([shapes, *self.other("shift")], "holds something else than results")

    def test_two_at_a_time_in_one_folder_are_refused(self):
        shapes = self.squares()
        words = self.command(shapes, *self.other("sleep"), "--only", "a0-a1")
        first = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            for _ in range(400):
                if list(self.folder.glob("out/tool/.a0-a1.partial-*/out")):
                    break
                time.sleep(0.05)
            self.refused([shapes, *self.other("shift")], "another benchmark is writing to")
        finally:
            first.terminate()
            first.wait(60)

    def test_curves_weigh_pairs_alike(self):
        limits, shares = tables.curves({"m": [[0, 0, 4, 4], [2, math.inf]]}, "geodesic")
        at = dict(zip(limits, shares["m"]))
        self.assertEqual((limits[0], limits[-1]), (0, 4))
        self.assertEqual((at[0], at[2], at[4]), (0.25, 0.5, 0.75))

    def test_the_program_that_measures_refuses_in_one_line(self):
        shapes = self.squares()
        a, b, ids = shapes / "a0.off", shapes / "a1.off", shapes / "a0.vts"
        short, few = self.folder / "short.off", self.folder / "few.vts"
        short.write_text(off(square[:10], triangles[:4]))
        few.write_text("1\n2\n")
        wrong = self.folder / "wrong.vts"
        for words, part in (((a, b), "expected three files"), ((a, short, "identity"), "25 vertices"), ((a, b, short), "is for 10 vertices"),
                            ((a, b, "identity", "--vts", ids, few), "has 25 lines and"),
                            ((a, b, "identity", "--vts", ids), "a value is missing"),
                            ((a, b, "identity", "--vts", ids, wrong), "entry 2: '26' is no vertex"),
                            ((a, b, "identity", "--speed"), "no option --speed"),
                            ((a, b, "identity", "--first-index", "2"), "expected 0 or 1")):
            wrong.write_text("1 26")
            program = build / "tests/studies/correspondence/correspondence_error"
            result = subprocess.run([program, *map(str, words)], capture_output=True, text=True)
            self.assertEqual((result.returncode, result.stdout, result.stderr.count("\n")), (2, "", 1), result.stderr)
            self.assertIn(part, result.stderr)


def reading(path):
    try:
        return path.read_bytes()
    except OSError:
        return b""


def ended(pid):
    try:
        os.kill(pid, signal.SIGKILL)
    except ProcessLookupError:
        pass


if __name__ == "__main__":
    build, rest = path_option("--build")
    unittest.main(argv=[sys.argv[0], *(f"Benchmark.{name}" for name in rest)])
