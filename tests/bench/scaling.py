"""The growth of time and memory with the grid, measured by level and fitted by a power of the number of nodes."""

import math

import measure
from comparison import markdown

kernels = ("gradient", "newton_model", "newton_product")
# Name in the table, key of a row.
series = [
    ("grid, distances, coefficients", "grid_seconds"),
    ("one gradient", "gradient_seconds"),
    ("one Newton model", "newton_model_seconds"),
    ("one product with it", "newton_product_seconds"),
    ("whole run", "run_seconds"),
    ("peak memory", "bytes"),
]


def measure_level(programs, pair, level, changes, seconds, whole_runs=True):
    """Measures a whole run that ends on this level, and single steps of the minimiser on its finest grid."""
    steps, sizes = measure.measure_kernels(programs, ",".join(pair), level, seconds, "^(" + "|".join(kernels) + ")/threads:1/")

    def cpu_seconds(name):
        ns, count = ("cpu_ns_per_free_node", "free_nodes") if name == "newton_product" else ("cpu_ns_per_point", "active_points")
        return 1e-9 * steps[name][ns] * sizes[count]

    row = {"level": level, "nodes": sizes["nodes"], "free_nodes": sizes["free_nodes"],
           "grid_seconds": 1e-6 * sizes["grid_microseconds"], **{f"{name}_seconds": cpu_seconds(name) for name in kernels}}
    if whole_runs:
        # With placement as-is, as in level_kernels, both programs use the same grid.
        run = measure.measure_cascade(programs, *pair, f"{min(3, level)}:{level}", ["input.placement=as-is", *changes])
        row.update({"run_seconds": run["cpu_seconds"], "bytes": run["peak_memory_bytes"], "run_free_nodes": run["free_nodes"],
                    "steps": run["finest_level_iterations"], "phase_shares": run["phase_shares"]})
    return row


def exponent(sizes, values):
    """Slope of the least-squares line of log(value) over log(size), and its standard error (0 for two points)."""
    x, y = [math.log(s) for s in sizes], [math.log(v) for v in values]
    n = len(x)
    mean_x, mean_y = sum(x) / n, sum(y) / n
    square = sum((a - mean_x) ** 2 for a in x)
    slope = sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / square
    rest = sum((b - mean_y - slope * (a - mean_x)) ** 2 for a, b in zip(x, y))
    return slope, math.sqrt(rest / (n - 2) / square) if n > 2 else 0.0


def measured(rows):
    """The series that every row has."""
    return [entry for entry in series if all(entry[1] in row for row in rows)]


def table(rows):
    def cell(row, key):
        value = row[key]
        return f"{value / 1e6:.0f} MB" if key == "bytes" else f"{value:.3g} s"

    shown = measured(rows)
    with_steps = all("steps" in row for row in rows)
    lines = [[row["level"], f"{row['nodes']:,}", f"{row['free_nodes']:,}", *(cell(row, key) for _, key in shown),
              *([row["steps"]] if with_steps else [])] for row in rows]
    if len(rows) > 1:
        for what, key_of_size in (("nodes", "nodes"), ("free nodes", "free_nodes")):
            fits = [exponent([row[key_of_size] for row in rows], [row[key] for row in rows]) for _, key in shown]
            lines.append([f"exponent by {what}", "", "", *(f"**{slope:.2f}** ± {error:.2f}" for slope, error in fits),
                          *([""] if with_steps else [])])
    return markdown(["level", "nodes", "free nodes", *(name for name, _ in shown),
                     *(["steps on the finest level"] if with_steps else [])], lines)


def plot(rows):
    """Seconds, and gigabytes, over nodes, for plotting.draw()."""
    nodes = [row["nodes"] for row in rows]
    shown, drawn = [], []
    for colour, (name, key) in enumerate(measured(rows)):
        values = [row[key] * (1e-9 if key == "bytes" else 1.0) for row in rows]
        slope = f": {exponent(nodes, values)[0]:.2f}" if len(rows) > 1 else ""
        shown += values
        drawn.append({"name": (name + ", GB" if key == "bytes" else name) + slope, "x": nodes, "y": values, "points": True,
                      "color": colour, "dashes": 1 if key == "bytes" else 0})
    # Dotted lines of slope 1, one decade apart, within the plotted range.
    low, high = min(shown), max(shown)
    for decade in range(math.floor(math.log10(low * nodes[0] / nodes[-1])), math.ceil(math.log10(high))):
        ends = [(n, 10.0**decade * n / nodes[0]) for n in nodes_between(nodes[0], nodes[-1])]
        inside = [(n, v) for n, v in ends if low <= v <= high]
        if len(inside) > 1:
            drawn.append({"x": [n for n, _ in inside], "y": [v for _, v in inside], "color": 7, "dashes": 2})
    return {"title": "One thread; the numbers are exponents, dotted lines have 1", "x_label": "nodes of the finest grid",
            "y_label": "CPU seconds; gigabytes", "log_x": True, "log_y": True, "series": drawn, "width": 960, "height": 520}


def nodes_between(first, last, n=41):
    """n numbers from first to last in geometric progression."""
    return [first * (last / first) ** (i / (n - 1)) for i in range(n)]
