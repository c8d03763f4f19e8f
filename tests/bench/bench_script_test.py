#!/usr/bin/env python3
"""Tests of scripts/bench: what it computes, what it refuses, and small runs with real programs.

usage: bench_script_test.py --build BUILD_TREE [Script | Kernels]
"""

import json
import math
import os
import pathlib
import shutil
import socket
import subprocess
import sys
import time
import types
import unittest
import xml.etree.ElementTree

root = pathlib.Path(__file__).resolve().parent.parent.parent
sys.dont_write_bytecode = True
sys.path[:0] = [str(root / "tests/bench"), str(root / "tests/support")]

import comparison  # noqa: E402
import machine  # noqa: E402
import measure  # noqa: E402
import paired  # noqa: E402
import plotting  # noqa: E402
import roofline  # noqa: E402
import scaling  # noqa: E402
from script_test import ScriptTest, path_option  # noqa: E402

build = None  # the build tree under test
tiny = ["--pairs", "leaf", "--levels", "3:4", "--only", "cascades"]


def bench(*words, script=root / "scripts/bench"):
    return subprocess.run([str(script), *map(str, words)], capture_output=True, text=True, timeout=200)


def command_of(pid):
    """The program that a process runs, "" where it has gone."""
    try:
        return pathlib.Path(f"/proc/{pid}/cmdline").read_text().partition("\0")[0]
    except OSError:
        return ""


class Folder(ScriptTest):
    def refused(self, result, code, *words):
        self.assert_refused(result, "bench", code, words)


class Script(Folder):
    def test_exponents_of_powers_are_found(self):
        sizes = [1000, 8000, 70000, 500000]
        for power in (0.5, 1.0, 1.7):
            slope, error = scaling.exponent(sizes, [3e-6 * n**power for n in sizes])
            self.assertAlmostEqual(slope, power, places=9)
            self.assertLess(error, 1e-9)
        # n log n is no power, but between 1 and 1.2 here, and the fit says that it is none.
        slope, error = scaling.exponent(sizes, [n * math.log(n) for n in sizes])
        self.assertTrue(1.05 < slope < 1.2 and error > 1e-4, (slope, error))

    def test_noise_is_told_from_a_difference(self):
        def differs(before, after):
            return comparison.verdict(before, after)[3]

        self.assertFalse(differs([1.0, 1.0, 1.0], [1.0, 1.0, 1.0]))
        self.assertFalse(differs([1.0, 1.1, 0.9], [1.05, 0.95, 1.0]))  # now one is faster, now the other
        self.assertFalse(differs([1.0, 1.4, 1.0], [1.02, 1.43, 1.02]))  # always slower, but by less than rounds differ
        self.assertFalse(differs([1.0, 1.0, 1.0], [0.99, 1.1, 1.1]))  # mostly slower, but once faster
        self.assertFalse(differs([1.0], [2.0]))  # one round says nothing of noise
        self.assertTrue(differs([1.0, 1.01, 0.99], [1.2, 1.21, 1.19]))
        self.assertTrue(differs([1.0, 1.01, 0.99], [0.8, 0.81, 0.79]))
        self.assertIn("worse", comparison.words_of(1.2, True, False))
        self.assertIn("better", comparison.words_of(1.2, True, True))

    def test_the_median_lies_between_two_of_the_values(self):
        # Of 40 throws of a coin 13 or fewer show heads with 1.9 %, 14 or fewer with 4.0 %.
        self.assertEqual(paired.median_interval([float(i) for i in range(40)]), (19.5, 13.0, 26.0))
        self.assertEqual(paired.median_interval([3.0, 1.0, 2.0]), (2.0, 1.0, 3.0))

    def served(self, name, nanoseconds, ready="ready"):
        """What answers as level_kernels does; calls get slower, as on a machine that others use more and more."""
        program = self.folder / name
        program.write_text(f"""#!/usr/bin/env python3
import sys
print("{ready}", flush=True)
for i, line in enumerate(sys.stdin):
    kernel, threads = line.split()
    if kernel == "newton_product": sys.exit(2)
    print({nanoseconds} * (1 + 0.05 * i), {nanoseconds} / int(threads), flush=True)
""")
        program.chmod(0o755)
        return types.SimpleNamespace(level_kernels=program)

    def test_builds_are_called_in_turn(self):
        slow, fast, old = self.served("slow", 100), self.served("fast", 97), self.served("old", 100, "usage")
        self.assertIsNone(paired.measure((old, fast), "a,b", 4, 8))
        with self.assertRaisesRegex(measure.BenchError, "slow ended when 'newton_product' was called on 1 threads"):
            paired.measure((slow, fast), "a,b", 4, 8)
        before = paired.calls
        paired.calls = [("gradient", 2)]
        try:
            for n_calls, word in ((8, "**better**"), (5, "within the noise")):
                (cpu, wall) = paired.rows(paired.measure((slow, fast), "a,b", 4, n_calls))
                self.assertEqual((cpu[0], wall[0]), ("gradient, 2 threads, CPU", "gradient, 2 threads, wall"))
                self.assertEqual((cpu[4], cpu[5], cpu[6]), ("0.970", "0.970 to 0.970", word))
            self.assertEqual(wall[2:4], ["50.0 / 50.0", "48.5 / 48.5"])
            (cpu, _) = paired.rows(paired.measure((fast, slow), "a,b", 4, 8))
            self.assertEqual(cpu[6], "**worse**")
        finally:
            paired.calls = before

    def test_the_median_of_the_rounds_is_recorded(self):
        rounds = [{"kernels": {"value": {"cpu_ns_per_point": t}}, "cascades": {}} for t in (10.0, 50.0, 12.0)]
        value = comparison.condense(rounds)["kernels"]["value"]
        self.assertEqual(value["cpu_ns_per_point"], 12.0)
        self.assertAlmostEqual(value["spread"], 20 / 12, places=2)

    def test_the_machine_is_described_without_its_name(self):
        found = machine.describe()
        self.assertGreaterEqual(found["cores"], 1)
        self.assertIn("vector_extension", found)
        self.assertEqual(machine.vector_extension({"sse4_2", "avx", "avx2"}), "AVX2")
        self.assertEqual(machine.vector_extension({"avx2", "avx512f"}), "AVX-512")
        if len(socket.gethostname()) > 4:
            self.assertNotIn(socket.gethostname(), json.dumps(found))

    def test_a_busy_machine_is_told(self):
        self.assertEqual(machine.busy_warning(0.1), "")
        self.assertIn("2.5", machine.busy_warning(2.5))

    def test_the_plot_has_every_series(self):
        rows = [{"level": level, "nodes": 10**level, "free_nodes": 6 * 10 ** (level - 1), "steps": 9,
                 **{key: 1e-4 * 10.0 ** (level - 3) for _, key in scaling.series}, "bytes": 7e3 * 10**level}
                for level in (3, 4, 5)]
        plot = scaling.plot(rows)
        named = [series for series in plot["series"] if "name" in series]
        self.assertEqual([series["name"].split(":")[0].split(", GB")[0] for series in named], [name for name, _ in scaling.series])
        for series in named:
            self.assertEqual(series["x"], [1000, 10000, 100000])
            self.assertEqual(len(series["y"]), len(rows))
            self.assertIn("1.00", series["name"])
        self.assertEqual(named[-1]["y"][0], 7e3 * 1000 * 1e-9)
        dotted = [series for series in plot["series"] if "name" not in series]
        self.assertGreater(len(dotted), 2)
        for series in dotted:
            self.assertAlmostEqual(scaling.exponent(series["x"], series["y"])[0], 1)
        picture = self.folder / "plot.svg"
        plotting.draw(plot, picture, build / "tests/studies/plot/plot_series")
        drawn = xml.etree.ElementTree.parse(picture).getroot()
        self.assertEqual(drawn.get("viewBox").split()[2:], ["960", "520"])
        self.assertGreater(len(list(drawn.iter("{http://www.w3.org/2000/svg}path"))), len(plot["series"]))
        self.assertIn("**1.00**", scaling.table(rows))

    def test_what_cannot_be_drawn_is_told(self):
        program = build / "tests/studies/plot/plot_series"
        for plot, words in (({"titel": "a"}, "there is no 'titel'"), ({"series": [{"colour": 1}]}, "there is no 'colour'"),
                            ({"series": [{"name": "a", "x": [1], "y": []}]}, "series 'a' has 1 x and 0 y")):
            with self.assertRaisesRegex(RuntimeError, words):
                plotting.draw(plot, self.folder / "plot.png", program)
        with self.assertRaisesRegex(RuntimeError, "scripts/build release plot_series"):
            plotting.draw({}, self.folder / "plot.png", self.folder / "no_program")

    def test_kernels_are_held_against_the_lower_ceiling(self):
        counts = {name: {"flops": flops} for name, flops in
                  (("band_value_by_point", 100), ("band_gradient_by_point", 400), ("volume_value_by_element", 10),
                   ("volume_gradient_by_element", 40), ("barrier_by_element", 50), ("newton_band_by_point", 900),
                   ("newton_volume_by_element", 200))}
        sizes = {"active_points": 1000, "cells": 500, "free_nodes": 300, "blocks": 4200,
                 **{f"{name}_bytes": 10000 for name in roofline.kernel_names}, "newton_product_bytes": 583200}
        kernels = {name: {"cpu_ns_per_point": 5.0, "cpu_ns_per_free_node": 243.0} for name in roofline.kernel_names}
        kernels.update(ceiling_fma={"gflops": 60.0}, ceiling_fma_and_add={"gflops": 90.0}, ceiling_clock={"gigahertz": 3.75},
                       ceiling_read={"gbytes": 20.0}, ceiling_triad={"gbytes": 22.0})
        rows, ceilings = roofline.rows_of(kernels, sizes, counts)
        rows = {row["kernel"]: row for row in rows}
        self.assertEqual(rows["value"]["flops"], 100 + 0.5 * (10 + 50))
        self.assertEqual(rows["band_gradient"]["reached"], 80.0)
        self.assertFalse(rows["gradient"]["memory_bound"])
        self.assertEqual(rows["gradient"]["ceiling"], 90.0)
        product = rows["newton_product"]  # 18 flops for 72 bytes, (2 * 4200 - 300) times
        self.assertTrue(product["memory_bound"])
        self.assertAlmostEqual(product["ceiling"], 5.0)
        self.assertAlmostEqual(product["reached"], 2.0)
        self.assertIn("| 40 % |", roofline.table(rows.values(), ceilings))

    def test_bad_arguments_are_refused(self):
        self.assertEqual(bench("--help").returncode, 0)
        for words in (["unknown"], ["run", "--rounds", "0"], ["scaling", "--levels", "7:5"], ["scaling", "--pair", "hand"]):
            result = bench(*words)
            self.assertEqual(result.returncode, 2, words)
            self.assertIn(words[-1], result.stderr)
        self.refused(bench("run", "--pairs", "elephant"), 2, "elephant", "ellipsoid")
        self.refused(bench("run", "--no-build", "--build", self.folder), 2, "shellmatch", "--no-build")

    def test_unknown_commits_are_refused(self):
        self.refused(bench("compare", "no-such-commit"), 2, "no-such-commit", "git log")

    def test_commits_without_the_benchmark_are_refused(self):
        self.make_repository(with_kernels=False)
        self.refused(bench("compare", "HEAD", script=self.folder / "scripts/bench"), 2, "HEAD", "level_kernels.cpp",
                     "--only cascades")

    def test_a_damaged_history_is_refused_with_its_line(self):
        history = self.folder / "history.jsonl"
        history.write_text("{}\n{cut\n")
        self.refused(bench("history", "--history", history), 2, "line 2", str(history))
        self.refused(bench("history", "--history", self.folder / "none"), 2, "none")

    def test_a_run_appends_a_record(self):
        history = self.folder / "sub/history.jsonl"
        for i in (1, 2):
            before = history.read_text() if history.exists() else ""
            result = bench("run", *tiny, "--rounds", 2, "--no-build", "--build", build, "--history", history)
            self.assertEqual(result.returncode, 0, result.stderr)
            lines = history.read_text()
            self.assertTrue(lines.startswith(before))
            self.assertEqual(len(lines.splitlines()), i)
        record = json.loads(lines.splitlines()[-1])
        head = subprocess.run(["git", "-C", root, "rev-parse", "HEAD"], capture_output=True, text=True)
        self.assertEqual(record["commit"], head.stdout.strip())
        self.assertIn("cores", record["machine"])
        leaf = record["cascades"]["leaf"]
        self.assertEqual(leaf["levels"], "3:4")
        self.assertGreater(leaf["cpu_seconds"], 0)
        self.assertGreater(leaf["peak_memory_bytes"], 1e6)
        self.assertAlmostEqual(sum(leaf["phase_shares"].values()), 1, places=2)
        self.assertIn("mean", leaf["distance"]["deformed_to_template"])
        self.assertEqual(leaf["folded_cells"], 0)
        self.assertEqual(list(history.parent.iterdir()), [history])
        self.assertEqual(bench("history", "--history", history).stdout.count("leaf 3:4"), 2)

    def test_what_is_stopped_leaves_nothing_running(self):
        history = self.folder / "history.jsonl"
        words = ["run", "--only", "cascades", "--pairs", "hand", "--levels", "3:8", "--no-build", "--build", build,
                 "--history", history]
        script = subprocess.Popen([root / "scripts/bench", *words], stderr=subprocess.PIPE)
        self.addCleanup(script.stderr.close)
        self.addCleanup(script.kill)
        children = pathlib.Path(f"/proc/{script.pid}/task/{script.pid}/children")
        # git comes first; the program stays.
        for _ in range(1000):
            child = next((pid for pid in children.read_text().split() if "shellmatch" in command_of(pid)), None)
            if child:
                break
            time.sleep(0.02)
        self.assertIsNotNone(child)
        script.terminate()
        self.assertEqual(script.wait(60), 143)
        self.assertNotIn("shellmatch", command_of(child))
        self.assertFalse(history.exists())

    def make_repository(self, with_kernels=True, cmake="message(FATAL_ERROR broken-on-purpose)"):
        """A repository with scripts/bench whose programs are what `cmake` makes of them."""
        shutil.copytree(root / "tests/bench", self.folder / "tests/bench", ignore=shutil.ignore_patterns("*.cpp", "__pycache__"))
        (self.folder / "scripts").mkdir()
        shutil.copy(root / "scripts/bench", self.folder / "scripts/bench")
        if with_kernels:
            (self.folder / "tests/bench/level_kernels.cpp").write_text("\n")
        (self.folder / "CMakeLists.txt").write_text(f"cmake_minimum_required(VERSION 3.25)\nproject(p NONE)\n{cmake}\n")
        git = ["git", "-C", self.folder, "-c", "user.name=n", "-c", "user.email=e"]
        for words in (["init", "-q"], ["add", "."], ["commit", "-q", "-m", "first"]):
            subprocess.run([*git, *words], check=True)

    def worktrees(self):
        told = subprocess.run(["git", "-C", self.folder, "worktree", "list"], capture_output=True, text=True).stdout
        return len(told.splitlines())

    def test_commits_that_do_not_build_are_refused(self):
        self.make_repository()
        result = bench("compare", "HEAD", *tiny, "--no-build", "--build", build, script=self.folder / "scripts/bench")
        self.refused(result, 3, "cannot be configured", "broken-on-purpose", "commit ")
        self.assertEqual(self.worktrees(), 1)

    def test_a_commit_is_compared_with(self):
        copy = "add_custom_target(shellmatch COMMAND ${CMAKE_COMMAND} -E copy %s ${CMAKE_BINARY_DIR}/apps/shellmatch)"
        self.make_repository(cmake=copy % (build / "apps/shellmatch"))
        table = self.folder / "table.md"
        result = bench("compare", "HEAD", *tiny, "--rounds", 2, "--no-build", "--build", build, "--output", table,
                       script=self.folder / "scripts/bench")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("| leaf | the same to the bit |", table.read_text())
        self.assertIn("| leaf 3:4 | CPU s |", table.read_text())
        self.assertIn("2 rounds in turn", table.read_text())
        self.assertEqual(self.worktrees(), 1)


class Kernels(Folder):
    def setUp(self):
        super().setUp()
        if not os.access(build / "tests/bench/level_kernels", os.X_OK):
            self.skipTest("tests/bench/level_kernels is not built: SHELLMATCH_BENCH is OFF, or Google Benchmark is not there")

    def test_kernels_are_recorded(self):
        history = self.folder / "history.jsonl"
        result = bench("run", "--only", "kernels", "--rounds", 1, "--seconds", 0.01, "--kernel-level", 4, "--no-build",
                       "--build", build, "--history", history)
        self.assertEqual(result.returncode, 0, result.stderr)
        kernels = json.loads(history.read_text())["kernels"]
        for name in ("value", "gradient", "newton_model"):
            self.assertGreater(kernels[name]["cpu_ns_per_point"], 0)
        self.assertGreater(kernels["newton_product"]["cpu_ns_per_free_node"], 0)
        self.assertGreater(kernels["ceiling_fma"]["gflops"], 0)

    def test_kernels_wait_for_calls(self):
        program = types.SimpleNamespace(level_kernels=build / "tests/bench/level_kernels")
        found = paired.measure((program, program), "ellipsoid/round,ellipsoid/long", 4, 3)
        self.assertEqual(list(found), paired.calls)
        for calls in found.values():
            self.assertEqual([len(side) for side in calls], [3, 3])
            self.assertTrue(all(cpu > 0 and wall > 0 for side in calls for cpu, wall in side))
        words = subprocess.run([build / "tests/bench/level_kernels", "--level=4", "--serve"], input="no_kernel 1\n", text=True,
                               capture_output=True)
        self.assertEqual(words.returncode, 2)
        self.assertIn("no_kernel", words.stderr)

    def test_flops_are_counted(self):
        if not os.access(build / "tests/bench/count_flops", os.X_OK):
            self.skipTest("tests/bench/count_flops is not built")
        counts = roofline.count_flops(build / "tests/bench/count_flops")
        for value, gradient in (("band_value_by_point", "band_gradient_by_point"),
                                ("volume_value_by_element", "volume_gradient_by_element")):
            # Reverse mode costs at most four times the value, and some look-up.
            self.assertTrue(1.5 < counts[gradient]["flops"] / counts[value]["flops"] < 4.0, counts)
        # Membrane and bending each have an exponential and normalise n2 once; the symmetric Dirichlet density has a root
        # and a division at each of eight points, and one for the element's side. Of the barrier, which vanishes there, a
        # bound is worked out that takes less than the determinants at 27 points, of nine products each.
        self.assertEqual(counts["band_value_by_point"]["exponentials"], 2)
        self.assertEqual(counts["band_value_by_point"]["roots"], 2)
        self.assertEqual(counts["volume_value_by_element"]["roots"], 8)
        self.assertEqual(counts["volume_value_by_element"]["divisions"], 8 + 1)
        self.assertEqual(counts["barrier_by_element"]["divisions"], 1)
        self.assertTrue(100 < counts["barrier_by_element"]["flops"] < 27 * 9, counts["barrier_by_element"])
        output = self.folder / "roofline.md"
        result = bench("roofline", "--level", 4, "--seconds", 0.01, "--no-build", "--build", build, "--output", output)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("| newton_product | free node |", output.read_text())

    def test_exponents_are_fitted_to_levels(self):
        output = self.folder / "scaling.md"
        words = ["scaling", "--no-build", "--build", build, "--seconds", 0.01, "--output", output, "--keep"]
        result = bench(*words, "--levels", "3:4")
        self.assertEqual(result.returncode, 0, result.stderr)
        first = json.loads(output.with_suffix(".json").read_text())["rows"]
        self.assertEqual([row["level"] for row in first], [3, 4])
        self.assertEqual(first[0]["nodes"], 729)
        self.assertGreater(first[0]["grid_seconds"], 0)
        # One level more: those that are there are not measured again.
        self.assertEqual(bench(*words, "--levels", "3:5").returncode, 0)
        rows = json.loads(output.with_suffix(".json").read_text())["rows"]
        self.assertEqual(rows[:2], first)
        for row in rows:
            self.assertEqual(row["run_free_nodes"], row["free_nodes"])
        self.assertIn("exponent by free nodes", output.read_text())
        self.assertTrue(output.with_suffix(".png").exists())


if __name__ == "__main__":
    build, rest = path_option("--build")
    unittest.main(argv=[sys.argv[0], *rest])
