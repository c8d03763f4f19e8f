"""Compares two builds of level_kernels by calling them alternately.

The speed of a machine may change by a third within minutes, but hardly between neighbouring calls: the median of their
ratios resolves differences of a few per cent, which alternating passes do not.
"""

import math
import statistics
import subprocess

from measure import BenchError

# Kernels and numbers of threads.
calls = [("value", 1), ("gradient", 1), ("gradient", 2), ("band_gradient", 1), ("band_gradient", 2), ("newton_model", 1),
         ("newton_model", 2), ("newton_product", 1), ("newton_product", 2)]

least_calls = 6  # with fewer, no interval between two of the values covers the median with 95 %


class Server:
    """A process of level_kernels that waits for calls. is_ready is False for versions that cannot do so."""

    def __init__(self, program, pair, level):
        self.program = program
        self.process = subprocess.Popen([str(program), f"--pair={pair}", f"--level={level}", "--serve"], text=True,
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        self.is_ready = self.process.stdout.readline().strip() == "ready"

    def call(self, kernel, threads):
        """Calls a kernel: nanoseconds per point or node, as CPU time of all threads and as wall time."""
        try:
            self.process.stdin.write(f"{kernel} {threads}\n")
            self.process.stdin.flush()
            cpu, wall = self.process.stdout.readline().split()
            return float(cpu), float(wall)
        except (OSError, ValueError):
            raise BenchError(f"{self.program} ended when '{kernel}' was called on {threads} threads")

    def end(self):
        self.process.kill()
        self.process.communicate()


def measure(programs, pair, level, n_calls):
    """{(kernel, threads): ([cpu, wall] of each call of the first build, the same of the second)}; None if a build cannot be called."""
    servers = []
    try:
        for one in programs:
            servers.append(Server(one.level_kernels, pair, level))
            if not servers[-1].is_ready:
                return None
        result = {}
        for kernel, threads in calls:
            for server in servers:
                server.call(kernel, threads)  # warms up the caches
            found = [[server.call(kernel, threads) for server in servers] for _ in range(n_calls)]
            result[kernel, threads] = tuple(zip(*found))
        return result
    finally:
        for server in servers:
            server.end()


def median_interval(values):
    """The sample median, and the bounds of a distribution-free 95 % confidence interval of the median, from the
    quantiles of the binomial distribution B(n, 1/2)."""
    values, n = sorted(values), len(values)
    below, k = 0.5**n, 0
    while below + math.comb(n, k + 1) * 0.5**n <= 0.025:
        k += 1
        below += math.comb(n, k) * 0.5**n
    return statistics.median(values), values[k], values[-1 - k]


def rows(result):
    """The rows of a table: kernel, unit, both medians, ratio, its interval, verdict."""
    table = []
    for (kernel, threads), (before, after) in result.items():
        unit = "ns/node" if kernel == "newton_product" else "ns/point"
        for what, at in (("CPU", 0), ("wall", 1)):
            if what == "wall" and threads == 1:
                continue
            a, b = [x[at] for x in before], [x[at] for x in after]
            middle, low, high = median_interval([y / x for x, y in zip(a, b)])
            differs = len(a) >= least_calls and (low > 1 or high < 1)
            word = "within the noise" if not differs else "**better**" if middle < 1 else "**worse**"
            words = f"{kernel}, {threads} thread{'s' if threads > 1 else ''}, {what}"
            table.append([words, unit, f"{min(a):.1f} / {statistics.median(a):.1f}", f"{min(b):.1f} / {statistics.median(b):.1f}",
                          f"{middle:.3f}", f"{low:.3f} to {high:.3f}", word])
    return table
