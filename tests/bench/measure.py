"""Builds the programs and measures kernels and whole cascades with them."""

import json
import os
import pathlib
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import time

# Whole cascades: name, reference, template, levels.
cascades = [
    ("ellipsoid", "ellipsoid/round", "ellipsoid/long", "3:6"),
    ("hand", "hand/rest", "hand/bent", "3:6"),
    ("cube", "box/cube", "box/compressed", "3:5"),
    ("leaf", "leaf/deep", "leaf/shallow", "4:8"),
]
kernel_filter = "^(value|gradient|band_gradient|newton_model|newton_product)/threads:1/|^ceiling"
# The counters of tests/bench/level_kernels to compare: time per point or node, and the ceilings of the machine.
kernel_counters = ("cpu_ns_per_point", "cpu_ns_per_free_node", "gflops", "gbytes", "gigahertz")


class BenchError(Exception):
    """A message for the user, and the exit code: 2 for bad input, 3 for failures of the environment."""

    def __init__(self, message, code=3):
        super().__init__(message)
        self.code = code


class Programs:
    """shellmatch and level_kernels of one source tree, in one build tree."""

    def __init__(self, source, folder):
        self.source, self.folder = pathlib.Path(source), pathlib.Path(folder)
        self.shellmatch = self.folder / "apps/shellmatch"
        # Commits of before the folder was moved are compared, too.
        bench = "tests/bench" if (self.source / "tests/bench").is_dir() and not (self.source / "bench").is_dir() else "bench"
        self.level_kernels = self.folder / bench / "level_kernels"
        self.count_flops = self.folder / bench / "count_flops"
        self.plot_series = self.folder / "tests/studies/plot/plot_series"

    def build(self, name, jobs, kernels=True, more=()):
        cached = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
        # With a common base directory, ccache finds files compiled in another working tree of the same sources.
        environment = {**os.environ, "CCACHE_BASEDIR": str(self.source), "CCACHE_NOHASHDIR": "1"}
        for tool in ("cmake", "ninja"):
            if not shutil.which(tool):
                raise BenchError(f"'{tool}' is not there; scripts/install-dependencies installs it")
        print(f"Building {name} in {self.folder} ...", file=sys.stderr, flush=True)
        options = ["-DCMAKE_BUILD_TYPE=Release", f"-DSHELLMATCH_BENCH={'ON' if kernels else 'OFF'}", "-DSHELLMATCH_TESTS=OFF"]
        targets = ["shellmatch"] + (["level_kernels"] if kernels else []) + list(more)
        for step, command in (
                ("configured (Google Benchmark is installed by scripts/install-dependencies --developer)",
                 ["cmake", "-G", "Ninja", "-S", str(self.source), "-B", str(self.folder), *options, *cached]),
                ("built", ["cmake", "--build", str(self.folder), "-j", str(jobs), "--target", *targets])):
            result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=environment)
            if result.returncode != 0:
                last = "\n".join(result.stdout.splitlines()[-15:])
                raise BenchError(f"{name} cannot be {step}; the last lines were:\n{last}")

    def check(self, kernels=True):
        for program in [self.shellmatch] + ([self.level_kernels] if kernels else []):
            if not os.access(program, os.X_OK):
                raise BenchError(f"{program} is not there; leave out --no-build, or name another build tree with --build", 2)

    def compiler(self):
        """First line of the compiler's --version."""
        for line in (self.folder / "CMakeCache.txt").read_text().splitlines():
            if line.startswith("CMAKE_CXX_COMPILER:"):
                told = subprocess.run([line.partition("=")[2], "--version"], capture_output=True, text=True).stdout
                return told.partition("\n")[0]
        return "unknown"


def run_and_measure(command, log):
    """Runs a command and returns its wall seconds, CPU seconds and peak memory. Raises BenchError if it fails."""
    begin = time.monotonic()
    # Held back until the program is known, which must not outlive this process.
    mask = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGTERM})
    with open(log, "w") as out:
        try:
            process = subprocess.Popen([str(word) for word in command], stdout=out, stderr=subprocess.STDOUT,
                                       preexec_fn=lambda: signal.pthread_sigmask(signal.SIG_SETMASK, mask))
            try:
                signal.pthread_sigmask(signal.SIG_SETMASK, mask)
                _, status, usage = os.wait4(process.pid, 0)
            except BaseException:
                process.kill()
                process.wait()
                raise
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, mask)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        last = "\n".join(pathlib.Path(log).read_text().splitlines()[-5:])
        raise BenchError(f"'{' '.join(map(str, command))}' ended with code {process.returncode}:\n{last}")
    return {"wall_seconds": round(time.monotonic() - begin, 3), "cpu_seconds": round(usage.ru_utime + usage.ru_stime, 3),
            "peak_memory_bytes": usage.ru_maxrss * 1024}


def measure_kernels(programs, pair, level, seconds, names=kernel_filter):
    """Runs level_kernels once: {kernel: {counter: number}}, and the sizes of its grid."""
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder) / "kernels.json"
        used = run_and_measure([programs.level_kernels, f"--pair={pair}", f"--level={level}", f"--benchmark_filter={names}",
                                f"--benchmark_min_time={seconds}", f"--benchmark_out={report}",
                                "--benchmark_out_format=json"], report.with_suffix(".log"))
        told = json.loads(report.read_text())
    kernels = {}
    for entry in told["benchmarks"]:
        kernels[entry["name"].partition("/")[0]] = {key: entry[key] for key in kernel_counters if key in entry}
    # Of the context only the program's own entries are taken: integers as text.
    sizes = {key: int(text) for key, text in told["context"].items() if isinstance(text, str) and text.isdigit()}
    return kernels, {**sizes, "peak_memory_bytes": used["peak_memory_bytes"]}


def measure_cascade(programs, reference, template, levels, changes=()):
    """Runs the whole program once on one thread: cost and quality by its summary."""
    with tempfile.TemporaryDirectory() as folder:
        output = pathlib.Path(folder) / "out"
        command = [programs.shellmatch, "match", f"generate:{reference}", f"generate:{template}", "-o", output, "-q",
                   "--levels", levels, "--threads", "1", "--set", "pictures=none"]
        for change in changes:
            command += ["--set", change]
        used = run_and_measure(command, pathlib.Path(folder) / "log")
        summary = json.loads((output / "summary.json").read_text())
    last, run = summary["levels"][-1], summary["run"]
    total = sum(run["phase_seconds"].values())
    return {
        "levels": levels, **used,
        "phase_seconds": {phase: round(s, 4) for phase, s in run["phase_seconds"].items()},
        "phase_shares": {phase: round(s / total, 4) for phase, s in run["phase_seconds"].items()},
        "finest_level_seconds": round(run["level_seconds"][-1], 4),
        "nodes": last["nodes"], "free_nodes": last["free_nodes"], "band_cells": last["band_cells"],
        "iterations": sum(level["iterations"] for level in summary["levels"]),
        "finest_level_iterations": last["iterations"],
        "energy": last["energy"]["total"],
        "distance": {way: summary["distance"][way] for way in ("deformed_to_template", "template_to_deformed")},
        "folded_cells": last["folds"]["folded_cells"],
        "uncertified_cells": last["folds"]["uncertified_cells"],
    }


def median_and_spread(values):
    """The median, and half of the range as a share of it."""
    middle = statistics.median(values)
    return middle, (max(values) - min(values)) / (2 * abs(middle)) if middle else 0.0
