"""Plots of the page."""

import math

from plotting import draw


def write_penalty_plots(rows, mismatch, energies, program):
    """Mismatch and energies over nu, into two files."""
    nu = [row[0] for row in rows]
    size = {"log_x": True, "x_label": "nu", "width": 620, "height": 380}
    draw({**size, "log_y": True, "y_label": "mismatch", "series": [{"x": nu, "y": [row[1] for row in rows], "points": True}]},
         mismatch, program)
    draw({**size, "y_label": "energy", "series": [{"name": name, "x": nu, "y": [row[k] for row in rows], "points": True}
                                                  for name, k in (("total", 3), ("without match", 2))]}, energies, program)


def oscillating_curve(k, amplitude, start, n):
    """Points of [eq:varphik] and the angle that they run through: r' = R sin(k xi), r theta' = (1 - R^2 sin^2(k xi))^(1/2)."""
    points, theta = [], 0
    for i in range(n):
        xi = 2 * math.pi * (i + 0.5) / n
        r = start + amplitude / k * (1 - math.cos(k * xi))
        points.append((r * math.cos(theta), r * math.sin(theta)))
        theta += math.sqrt(1 - (amplitude * math.sin(k * xi)) ** 2) / r * 2 * math.pi / n
    return points, theta


def write_oscillations(path, program):
    amplitude, n, apart = 0.95, 4000, 2.2
    radius = sum(math.sqrt(1 - (amplitude * math.sin(2 * math.pi * (i + 0.5) / n)) ** 2) for i in range(n)) / n
    angles = [2 * math.pi * i / 200 for i in range(201)]
    series = []
    for panel, k in enumerate((6, 20, 50)):
        low, high = 0.05, 1
        for _ in range(40):  # the angle falls with the start
            middle = 0.5 * (low + high)
            low, high = (middle, high) if oscillating_curve(k, amplitude, middle, n)[1] > 2 * math.pi else (low, middle)
        points = oscillating_curve(k, amplitude, low, n)[0][::2]
        points.append(points[0])
        series.append({"x": [apart * panel + x for x, _ in points], "y": [y for _, y in points], "color": 0})
        series.append({"x": [apart * panel + radius * math.cos(a) for a in angles], "y": [radius * math.sin(a) for a in angles],
                       "color": 1, "dashes": 1})
    # The axes get 2 % and 5 % more than the values at each end (matching/render/canvas/plot.cpp), and have the same scale.
    extent_x, extent_y = (1.04 * (max(max(s["x"]) for s in series) - min(min(s["x"]) for s in series)),
                          1.10 * (max(max(s["y"]) for s in series) - min(min(s["y"]) for s in series)))
    inner_width = 840
    draw({"title": "k = 6, 20, 50", "series": series, "width": inner_width + 84 + 24,
          "height": round(inner_width * extent_y / extent_x) + 50 + 62}, path, program)
