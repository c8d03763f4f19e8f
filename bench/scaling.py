"""How seconds and bytes grow with the grid: measured level by level, fitted as a power of the number of nodes."""

import math

import measure
from comparison import markdown

kernels = ("gradient", "newton_model", "newton_product")
# Name in the table, key of a row, colour in the plot.
series = [
    ("grid, distances, coefficients", "grid_seconds", "#7a5195"),
    ("one gradient", "gradient_seconds", "#2f7f4f"),
    ("one Newton model", "newton_model_seconds", "#c8553d"),
    ("one product with it", "newton_product_seconds", "#d89a20"),
    ("whole run", "run_seconds", "#1f4e79"),
    ("peak memory", "bytes", "#444444"),
]


def measure_level(programs, pair, level, changes, seconds, whole_runs=True):
    """A whole run that ends on this level, and its finest grid and single steps of the minimiser there."""
    steps, sizes = measure.measure_kernels(programs, ",".join(pair), level, seconds, "^(" + "|".join(kernels) + ")/threads:1/")

    def cpu_seconds(name):
        ns, count = ("cpu_ns_per_free_node", "free_nodes") if name == "newton_product" else ("cpu_ns_per_point", "active_points")
        return 1e-9 * steps[name][ns] * sizes[count]

    row = {"level": level, "nodes": sizes["nodes"], "free_nodes": sizes["free_nodes"],
           "grid_seconds": 1e-6 * sizes["grid_microseconds"], **{f"{name}_seconds": cpu_seconds(name) for name in kernels}}
    if whole_runs:
        # level_kernels takes the shapes as they are, too: both have the same grid.
        run = measure.measure_cascade(programs, *pair, f"{min(3, level)}:{level}", ["input.placement=as-is", *changes])
        row.update({"run_seconds": run["cpu_seconds"], "bytes": run["peak_memory_bytes"], "run_free_nodes": run["free_nodes"],
                    "steps": run["finest_level_iterations"], "phase_shares": run["phase_shares"]})
    return row


def exponent(sizes, values):
    """Slope of the least squares line through log(value) over log(size), and its standard error (0 for two points)."""
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
    lines = [[row["level"], f"{row['nodes']:,}", f"{row['free_nodes']:,}", *(cell(row, key) for _, key, _ in shown),
              *([row["steps"]] if with_steps else [])] for row in rows]
    if len(rows) > 1:
        for what, key_of_size in (("nodes", "nodes"), ("free nodes", "free_nodes")):
            fits = [exponent([row[key_of_size] for row in rows], [row[key] for row in rows]) for _, key, _ in shown]
            lines.append([f"exponent by {what}", "", "", *(f"**{slope:.2f}** ± {error:.2f}" for slope, error in fits),
                          *([""] if with_steps else [])])
    return markdown(["level", "nodes", "free nodes", *(name for name, _, _ in shown),
                     *(["steps on the finest level"] if with_steps else [])], lines)


def plot(rows):
    """Seconds (left) and bytes (right) over nodes, both logarithmic, as SVG; grey: exponent 1."""
    width, height, left, right, top, bottom = 820, 460, 62, 290, 30, 50
    nodes = [row["nodes"] for row in rows]
    # Bytes share the axis: a gigabyte stands where a second stands.
    shift = 9
    shown = measured(rows)
    times = [row[key] / (10.0**shift if key == "bytes" else 1.0) for row in rows for _, key, _ in shown]
    x_low, x_high = math.floor(math.log10(min(nodes))), math.ceil(math.log10(max(nodes)))
    y_low, y_high = math.floor(math.log10(min(times))), math.ceil(math.log10(max(times)))

    def x_of(value):
        return left + (math.log10(value) - x_low) / max(1, x_high - x_low) * (width - left - right)

    def y_of(value):
        return height - bottom - (math.log10(value) - y_low) / (y_high - y_low) * (height - top - bottom)

    def text(x, y, words, anchor="start", more=""):
        return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" {more}>{words}</text>'

    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" '
             'font-family="DejaVu Sans, sans-serif" font-size="12" fill="#222222">',
             f'<rect width="{width}" height="{height}" fill="#ffffff"/>']
    edge = width - right
    for decade in range(x_low, x_high + 1):
        x = x_of(10.0**decade)
        parts.append(f'<line x1="{x:.1f}" y1="{top}" x2="{x:.1f}" y2="{height - bottom}" stroke="#e4e4e4"/>')
        parts.append(text(x, height - bottom + 18, power(decade), "middle"))
    for decade in range(y_low, y_high + 1):
        y = y_of(10.0**decade)
        parts.append(f'<line x1="{left}" y1="{y:.1f}" x2="{edge}" y2="{y:.1f}" stroke="#e4e4e4"/>')
        parts.append(text(left - 6, y + 4, power(decade) + " s", "end"))
        parts.append(text(edge + 6, y + 4, bytes_text(10.0 ** (decade + shift)), "start", 'fill="#777777"'))
    # Lines of exponent 1, one decade of seconds apart.
    for decade in range(y_low - (x_high - x_low), y_high):
        ends = [(x, decade + (x - x_low)) for x in (x_low, x_high)]
        clipped = clip(ends, y_low, y_high)
        if clipped:
            (xa, ya), (xb, yb) = clipped
            parts.append(f'<line x1="{x_of(10**xa):.1f}" y1="{y_of(10**ya):.1f}" x2="{x_of(10**xb):.1f}" '
                         f'y2="{y_of(10**yb):.1f}" stroke="#cccccc" stroke-dasharray="3 4"/>')
    labels = []
    for name, key, colour in shown:
        values = [row[key] / (10.0**shift if key == "bytes" else 1.0) for row in rows]
        points = [(x_of(n), y_of(v)) for n, v in zip(nodes, values)]
        dash = ' stroke-dasharray="7 4"' if key == "bytes" else ""
        parts.append('<polyline fill="none" stroke-width="1.8" stroke="{}"{} points="{}"/>'.format(
            colour, dash, " ".join(f"{x:.1f},{y:.1f}" for x, y in points)))
        parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{colour}"/>' for x, y in points]
        slope = exponent(nodes, values)[0] if len(rows) > 1 else float("nan")
        labels.append([points[-1][1], f"{name}: {slope:.2f}" if len(rows) > 1 else name, colour])
    labels.sort()
    for above, here in zip(labels, labels[1:]):
        here[0] = max(here[0], above[0] + 15)
    parts += [text(edge + 66, y + 4, words, "start", f'fill="{colour}"') for y, words, colour in labels]
    parts.append(text((left + edge) / 2, height - 12, "nodes of the finest grid", "middle"))
    parts.append(text(left, 18, "CPU seconds on one thread (memory, dashed: right); numbers: exponents; grey: exponent 1"))
    return "\n".join(parts) + "\n</svg>\n"


def clip(ends, low, high):
    """The part of a line of slope 1 whose y is within [low, high]; None where nothing is."""
    (xa, ya), (xb, yb) = ends
    begin, end = max(ya, low), min(yb, high)
    return ((xa + begin - ya, begin), (xa + end - ya, end)) if begin < end else None


def power(decade):
    return {0: "1", 1: "10", 2: "100"}.get(decade) or f'10<tspan dy="-5" font-size="9">{decade}</tspan><tspan dy="5">&#8203;</tspan>'


def bytes_text(value):
    for unit, size in (("TB", 1e12), ("GB", 1e9), ("MB", 1e6), ("KB", 1e3)):
        if value >= size:
            return f"{value / size:.0f} {unit}"
    return f"{value:.0f} B"
